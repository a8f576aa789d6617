//! Edges that move before emitters, before the environment, and before surfaces that reflect light, where the camera sees
//! only what rests: the derivative beside the processor's, by z-test.

use std::path::Path;

use capwalk_diff::{GradientOptions, Method};
use capwalk_gpu::Precision;
use capwalk_gpu_render::DeviceScene;
use capwalk_math::{Rgb, Vec3};
use capwalk_render::{Estimate, GradientImage, Grid, PreparedScene, RenderOptions, Unwatched};
use capwalk_scene::{Scene, ShapeVectors, Tangent};

use crate::device;

/// Pixels of the images.
const SIZE: [u32; 2] = [8, 6];

/// The largest standard score of a number of a pixel, of 144, and of the mean over the image: one in
/// some ten thousand is larger by chance.
const MOST: [f64; 2] = [5.0, 4.0];

/// A floor that the camera sees a part of, and things that it does not see.
fn scene(depth: u32, floor: &str, things: &str) -> Scene {
    let text = format!(
        r#"<scene version="3.0.0">
  <integrator type="path">
    <integer name="max_depth" value="{depth}"/>
  </integrator>
  <sensor type="perspective">
    <float name="fov" value="20"/>
    <transform name="to_world">
      <lookat origin="0, 3, 4" target="0, 0, 0.4" up="0, 1, 0"/>
    </transform>
    <film type="hdrfilm">
      <integer name="width" value="{}"/>
      <integer name="height" value="{}"/>
      <rfilter type="box"/>
    </film>
  </sensor>
  <bsdf type="diffuse" id="black"><rgb name="reflectance" value="0"/></bsdf>
  <bsdf type="diffuse" id="grey"><rgb name="reflectance" value="0.6, 0.5, 0.4"/></bsdf>
  <bsdf type="diffuse" id="checks">
    <texture type="checkerboard" name="reflectance">
      <rgb name="color0" value="0.1, 0.2, 0.3"/>
      <rgb name="color1" value="0.8, 0.6, 0.7"/>
      <transform name="to_uv"><scale x="3" y="2"/></transform>
    </texture>
  </bsdf>
  <bsdf type="roughconductor" id="metal"><float name="alpha" value="0.3"/></bsdf>
  <bsdf type="roughplastic" id="plastic"><float name="alpha" value="0.2"/></bsdf>
  <shape type="rectangle" id="floor">
    <transform name="to_world"><rotate x="1" angle="-90"/><scale value="3"/></transform>
    {floor}
  </shape>
  {things}
</scene>"#,
        SIZE[0], SIZE[1]
    );
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/parity");
    let loaded = capwalk_scene_io::load_scene_str(&text, &folder, "edges", &[]);
    loaded.unwrap_or_else(|error| panic!("{error}")).scene
}

/// A cube of a material, half as large as given, at a place.
fn block(id: &str, material: &str, size: f64, [x, y, z]: [f64; 3]) -> String {
    format!(
        r#"<shape type="cube" id="{id}">
    <transform name="to_world">
      <rotate x="1" y="2" z="0.5" angle="25"/><scale value="{size}"/><translate x="{x}" y="{y}" z="{z}"/>
    </transform>
    <ref id="{material}"/>
  </shape>"#
    )
}

/// A rectangle that looks down and emits, half as large as given.
fn lamp(id: &str, size: f64, [x, y, z]: [f64; 3], radiance: &str) -> String {
    format!(
        r#"<shape type="rectangle" id="{id}">
    <transform name="to_world">
      <rotate x="1" angle="90"/><scale value="{size}"/><translate x="{x}" y="{y}" z="{z}"/>
    </transform>
    <emitter type="area"><rgb name="radiance" value="{radiance}"/></emitter>
  </shape>"#
    )
}

const GREY: &str = r#"<ref id="grey"/>"#;
const BLOCK: [f64; 3] = [0.0, 1.2, -0.6];
const LAMP: [f64; 3] = [0.2, 3.5, -1.5];

/// Names, scenes, and which shapes move how.
fn cases() -> Vec<(&'static str, Scene, Vec<&'static str>, Vec3)> {
    let black = || block("block", "black", 0.35, BLOCK);
    let oblique = Vec3::new(0.6, 0.3, -0.5);
    let level = Vec3::new(0.7, 0.0, 0.4);
    let small = || lamp("lamp", 0.15, LAMP, "60, 50, 40");
    let large = || lamp("lamp", 1.0, LAMP, "2, 3, 2.5");
    let sky = || r#"<emitter type="constant"><rgb name="radiance" value="0.5, 0.7, 1"/></emitter>"#.to_owned();
    let map = || r#"<emitter type="envmap"><string name="filename" value="sky.exr"/></emitter>"#.to_owned();
    let wall = |material: &str| format!(
        r#"<shape type="rectangle" id="wall">
    <transform name="to_world"><scale value="1.5"/><translate y="1.5" z="-1.8"/></transform>
    <ref id="{material}"/>
  </shape>"#
    );
    let smooth = r#"<shape type="sphere" id="block"><point name="center" x="0" y="1.3" z="-0.5"/><float name="radius" value="0.4"/><ref id="black"/></shape>"#.to_owned();
    let ball_lamp = r#"<shape type="sphere" id="ball"><point name="center" x="0.3" y="3.2" z="-1.2"/><float name="radius" value="0.4"/><emitter type="area"><rgb name="radiance" value="9, 8, 7"/></emitter></shape>"#.to_owned();
    let one = vec!["block"];
    let of = |depth, floor: &str, things: &[String]| scene(depth, floor, &things.concat());
    vec![
        ("small lamp", of(2, GREY, &[black(), small()]), one.clone(), oblique),
        ("large lamp", of(2, GREY, &[black(), large()]), one.clone(), oblique),
        ("metal", of(2, r#"<ref id="metal"/>"#, &[black(), large()]), one.clone(), oblique),
        ("plastic", of(2, r#"<ref id="plastic"/>"#, &[black(), large()]), one.clone(), oblique),
        ("lamp moves", of(2, GREY, &[black(), large()]), vec!["lamp"], level),
        (
            "two lamps",
            of(2, GREY, &[black(), small(), lamp("other", 0.4, [-1.2, 2.8, -0.8], "3, 9, 9")]),
            vec!["block", "other"],
            level,
        ),
        ("sky", of(2, GREY, &[black(), sky()]), one.clone(), oblique),
        ("map", of(2, GREY, &[black(), map()]), one.clone(), oblique),
        ("ball", of(2, GREY, &[smooth.clone(), large(), sky()]), one.clone(), oblique),
        ("ball lamp", of(2, GREY, &[black(), ball_lamp.clone()]), one.clone(), oblique),
        ("touching", of(2, GREY, &[black(), black().replace("\"block\"", "\"twin\""), large(), sky()]), vec!["block", "twin"], oblique),
        ("touching one", of(2, GREY, &[block("block", "black", 0.2, [0.0, 1.2, -0.8]).replace("angle=\"25\"", "angle=\"0\""), block("twin", "black", 0.2, [0.4, 1.2, -0.8]).replace("angle=\"25\"", "angle=\"0\""), large(), sky()]), vec!["block"], oblique),
        ("stands on the floor", of(2, GREY, &[block("block", "black", 0.3, [0.1, 0.3, -1.3]).replace("angle=\"25\"", "angle=\"0\""), small(), sky()]), one.clone(), oblique),
        ("in a wall", of(3, GREY, &[block("block", "black", 0.4, [0.0, 1.2, -1.8]), wall("checks"), large()]), one.clone(), oblique),
        ("bump", of(3, GREY, &[black(), r#"<shape type="sphere" id="bump"><point name="center" x="0" y="-0.6" z="0.4"/><float name="radius" value="1.0"/><ref id="metal"/></shape>"#.to_owned(), large()]), one.clone(), oblique),
        ("bump 2", of(2, GREY, &[black(), r#"<shape type="sphere" id="bump"><point name="center" x="0" y="-0.6" z="0.4"/><float name="radius" value="1.0"/><ref id="metal"/></shape>"#.to_owned(), large()]), one.clone(), oblique),
        ("bump grey", of(2, GREY, &[black(), r#"<shape type="sphere" id="bump"><point name="center" x="0" y="-0.6" z="0.4"/><float name="radius" value="1.0"/><ref id="grey"/></shape>"#.to_owned(), large()]), one.clone(), oblique),
        ("checks slide", of(3, GREY, &[wall("checks"), large(), lamp("other", 0.15, [-0.8, 2.5, -0.6], "30, 50, 40")]), vec!["wall"], Vec3::new(0.5, 0.3, 0.0)),
        ("wall behind", of(3, GREY, &[black(), wall("grey"), large()]), one.clone(), oblique),
        ("wall of checks", of(3, GREY, &[black(), wall("checks"), small()]), one.clone(), oblique),
        ("long paths", of(5, GREY, &[black(), wall("checks"), large(), sky()]), one.clone(), oblique),
        ("metal wall", of(4, r#"<ref id="metal"/>"#, &[black(), wall("metal"), large()]), one.clone(), oblique),
        ("sky on metal", of(2, r#"<ref id="metal"/>"#, &[black(), sky()]), one.clone(), oblique),
    ]
}

fn moved(scene: &Scene, ids: &[&str], velocity: Vec3) -> Tangent {
    let mut tangent = Tangent::zero(scene);
    for (shape, vectors) in scene.shapes.iter().zip(&mut tangent.shapes) {
        *vectors = ids.contains(&&*shape.id).then(|| ShapeVectors {
            vertices: vec![velocity; shape.mesh.positions.len()],
            normals: None,
        });
    }
    tangent
}

fn options(spp: u32, seed: u64) -> GradientOptions {
    GradientOptions {
        method: Method::EDGES,
        grid: Grid::default(),
        ..GradientOptions::new(RenderOptions::new(spp, seed))
    }
}

/// Every channel of every pixel, with its standard error.
fn numbers(estimate: &Estimate) -> Vec<[f64; 2]> {
    let pairs = estimate.mean.pixels.iter().zip(&estimate.standard_error.pixels);
    let channels = |(mean, error): (&Rgb, &Rgb)| {
        let (mean, error) = (mean.to_array(), error.to_array());
        [0, 1, 2].map(|k| [mean[k], error[k]])
    };
    pairs.flat_map(channels).collect()
}

/// How far two estimates are apart, in standard errors of their difference: of each number the
/// largest, and of the mean. And the first's variance over the second's.
fn scores(ours: &GradientImage, theirs: &GradientImage) -> ([f64; 2], f64) {
    let (ours, theirs) = (numbers(&ours.gradient), numbers(&theirs.gradient));
    let pairs = || ours.iter().zip(&theirs);
    let score = |difference: f64, squares: f64| match difference == 0.0 {
        true => 0.0,
        false => difference.abs() / squares.sqrt(),
    };
    let each = pairs().map(|(a, b)| score(a[0] - b[0], a[1] * a[1] + b[1] * b[1]));
    let difference: f64 = pairs().map(|(a, b)| a[0] - b[0]).sum();
    // Channels go up and down together.
    let squares = |numbers: &[[f64; 2]]| numbers.iter().map(|x| x[1] * x[1]).sum::<f64>();
    let all = 3.0 * (squares(&ours) + squares(&theirs));
    let worst = each.fold(0.0, |worst, one| match one > worst || one.is_nan() {
        true => one,
        false => worst,
    });
    ([worst, score(difference, all)], squares(&ours) / squares(&theirs))
}

/// Where only what the camera does not see moves, and has no colour of its own.
#[test]
fn boundary_terms_are_the_processors() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let only = std::env::var("ONLY").unwrap_or_default();
    let spp = std::env::var("SPP").map_or(256, |spp| spp.parse().expect("a number"));
    for (name, scene, ids, velocity) in cases() {
        if !name.contains(&only) { continue; }
        let prepared = PreparedScene::new(scene);
        let tangent = moved(prepared.scene(), &ids, velocity);
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let start = std::time::Instant::now();
        let ours = on_device.gradient(&tangent, &options(spp, 3), &Unwatched);
        let ours = ours.expect("supported");
        let middle = std::time::Instant::now();
        let theirs = capwalk_diff::gradient(&prepared, &tangent, &options(spp, 4), &Unwatched);
        let theirs = theirs.expect("not refused");
        let times = [middle - start, middle.elapsed()].map(|time| time.as_secs_f64());
        let (scores, ratio) = scores(&ours, &theirs);
        let means = [&ours, &theirs].map(|image| {
            let all = numbers(&image.gradient);
            let (sum, squares) = all.iter().fold((0.0, 0.0), |(sum, squares), x| (sum + x[0], squares + x[0] * x[0]));
            [sum / all.len() as f64, (squares / all.len() as f64).sqrt()]
        });
        if !only.is_empty() { for (i, (a, b)) in numbers(&ours.gradient).iter().zip(numbers(&theirs.gradient)).enumerate().step_by(3) { println!("{} {}: {a:.4?} {b:.4?}", i / 3 % 8, i / 24); } }
        println!("{name}: z {scores:.2?}, variance {ratio:.2}, means {means:.4?}, seconds {times:.2?}");
    }
}
