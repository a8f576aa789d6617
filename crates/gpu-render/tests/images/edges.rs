//! Edges that move before emitters, before the environment, and before surfaces that reflect light, where the camera sees
//! only what does not move: the derivative beside the CPU's, by z-test.

use std::path::Path;

use capwalk_diff::{GradientImage, GradientOptions, Method};
use capwalk_gpu::Precision;
use capwalk_gpu_render::DeviceScene;
use capwalk_math::{Rgb, Vec3};
use capwalk_render::{Estimate, Grid, PreparedScene, RenderOptions, Unwatched};
use capwalk_scene::{Scene, ShapeVectors, Tangent};

use crate::device;

/// Pixels of the images.
const SIZE: [u32; 2] = [8, 6];

/// The largest variance, as a multiple of the CPU's: where many edges count, the CPU lists them all.
const MOST_VARIANCE: f64 = 2.5;

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
  <bsdf type="roughconductor" id="polished">
    <float name="alpha" value="0.1"/><rgb name="specular_reflectance" value="0.3, 0.2, 0.4"/>
  </bsdf>
  <bsdf type="conductor" id="mirror"><rgb name="specular_reflectance" value="0.9, 0.8, 0.7"/></bsdf>
  <bsdf type="plastic" id="glazed"/>
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
pub fn block(id: &str, material: &str, size: f64, [x, y, z]: [f64; 3]) -> String {
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
pub fn emitter(id: &str, size: f64, [x, y, z]: [f64; 3], radiance: &str) -> String {
    format!(
        r#"<shape type="rectangle" id="{id}">
    <transform name="to_world">
      <rotate x="1" angle="90"/><scale value="{size}"/><translate x="{x}" y="{y}" z="{z}"/>
    </transform>
    <emitter type="area"><rgb name="radiance" value="{radiance}"/></emitter>
  </shape>"#
    )
}

/// A ball of a material.
pub fn ball(id: &str, material: &str, radius: f64, [x, y, z]: [f64; 3]) -> String {
    format!(
        r#"<shape type="sphere" id="{id}">
    <point name="center" x="{x}" y="{y}" z="{z}"/><float name="radius" value="{radius}"/>
    {material}
  </shape>"#
    )
}

/// A wall behind the floor, in which the floor sees nothing but the camera could.
pub fn wall(material: &str) -> String {
    format!(
        r#"<shape type="rectangle" id="wall">
    <transform name="to_world"><scale value="1.5"/><translate y="1.5" z="-1.8"/></transform>
    <ref id="{material}"/>
  </shape>"#
    )
}

/// Without being turned.
fn upright(block: &str) -> String {
    block.replace(r#"angle="25""#, r#"angle="0""#)
}

pub const GREY: &str = r#"<ref id="grey"/>"#;
const BLACK: &str = r#"<ref id="black"/>"#;
const METAL: &str = r#"<ref id="metal"/>"#;
const POLISHED: &str = r#"<ref id="polished"/>"#;
const PLASTIC: &str = r#"<ref id="plastic"/>"#;
pub const SKY: &str =
    r#"<emitter type="constant"><rgb name="radiance" value="0.5, 0.7, 1"/></emitter>"#;
const MAP: &str = r#"<emitter type="envmap"><string name="filename" value="sky.exr"/></emitter>"#;

/// What a large emitter emits, and something else.
const EMITS: &str = r#"<rgb name="radiance" value="2, 3, 2.5"/>"#;
const CHECKS: &str = r#"<texture type="checkerboard" name="radiance">
      <rgb name="color0" value="1, 2, 3"/>
      <rgb name="color1" value="8, 6, 7"/>
      <transform name="to_uv"><scale x="2" y="1.5"/></transform>
    </texture>"#;

/// Where the block and the emitter are, unless a scene says otherwise.
pub const BLOCK: [f64; 3] = [0.0, 1.2, -0.6];
const EMITTER: [f64; 3] = [0.2, 3.5, -1.5];

/// A scene in which some shapes move, all alike.
pub struct Case {
    pub name: &'static str,
    /// Segments of the longest paths.
    pub depth: u32,
    pub floor: &'static str,
    pub things: Vec<String>,
    pub moving: Vec<&'static str>,
    /// Of the world's origin, with which they turn.
    pub velocity: Vec3,
    pub rotation: Vec3,
    /// Samples per pixel on the device.
    pub spp: u32,
}

/// What is left out is as in most of them.
pub fn case(name: &'static str, things: impl IntoIterator<Item = String>) -> Case {
    Case {
        name,
        depth: 2,
        floor: GREY,
        things: things.into_iter().collect(),
        moving: vec!["block"],
        velocity: Vec3::new(0.6, 0.3, -0.5),
        rotation: Vec3::zero(),
        spp: 32,
    }
}

pub fn cases() -> Vec<Case> {
    let black = || block("block", "black", 0.35, BLOCK);
    let small = || emitter("lamp", 0.15, EMITTER, "60, 50, 40");
    let large = || emitter("lamp", 1.0, EMITTER, "2, 3, 2.5");
    let lights_the_wall = || {
        r#"<shape type="rectangle">
    <transform name="to_world">
      <rotate y="1" angle="180"/><scale value="0.3"/><translate y="0.35" z="3.6"/>
    </transform>
    <emitter type="area"><rgb name="radiance" value="90, 80, 70"/></emitter>
  </shape>"#
            .to_owned()
    };
    let behind_the_camera = || {
        let board = r#"<shape type="rectangle">
    <transform name="to_world">
      <rotate y="1" angle="180"/><scale value="1.2"/><translate y="1.5" z="5"/>
    </transform>
    <ref id="grey"/>
  </shape>
  <shape type="rectangle">
    <transform name="to_world"><scale value="0.5"/><translate y="1.5" z="4.3"/></transform>
    <emitter type="area"><rgb name="radiance" value="90, 80, 70"/></emitter>
  </shape>"#;
        let block = block("block", "black", 0.3, [0.9, 1.2, 3.0]);
        [block, wall("grey"), board.to_owned()]
    };
    let sky = || SKY.to_owned();
    let standing = || upright(&block("block", "black", 0.3, [0.1, 0.3, -1.3]));
    let half = |id, x| upright(&block(id, "black", 0.2, [x, 1.2, -0.8]));
    // In its own plane, so that what a direction sees of it changes only at its edges.
    let level = Vec3::new(0.7, 0.0, 0.4);
    let spin = Vec3::new(0.5, -0.8, 0.4);
    let emits = r#"<emitter type="area"><rgb name="radiance" value="9, 8, 7"/></emitter>"#;
    vec![
        case("a small emitter", [black(), small()]),
        Case {
            rotation: spin,
            ..case("a large emitter", [black(), large()])
        },
        Case {
            floor: METAL,
            ..case("metal", [black(), large()])
        },
        Case {
            floor: PLASTIC,
            ..case("plastic", [black(), large(), sky()])
        },
        Case {
            moving: vec!["lamp"],
            velocity: level,
            ..case("an emitter moves", [black(), large()])
        },
        // What emits has edges inside: lines of its texture, and where a block passes through it.
        Case {
            moving: vec!["lamp"],
            velocity: level,
            ..case(
                "an emitter of checks moves",
                [large()
                    .replace(EMITS, CHECKS)
                    .replace(r#"value="1""#, r#"value="0.7""#)],
            )
        },
        case(
            "an emitter is cut",
            [block("block", "black", 0.4, [0.3, 3.4, -1.3]), large()],
        ),
        Case {
            moving: vec!["block", "other"],
            velocity: level,
            ..case(
                "two emitters",
                [
                    black(),
                    small(),
                    emitter("other", 0.4, [-1.2, 2.8, -0.8], "3, 9, 9"),
                ],
            )
        },
        Case {
            rotation: spin,
            ..case("a sky", [black(), sky()])
        },
        case("a map", [black(), MAP.to_owned()]),
        // More edges than a leaf has.
        case(
            "a ball",
            [ball("block", BLACK, 0.4, [0.0, 1.3, -0.5]), large(), sky()],
        ),
        case(
            "an emitter that is a ball",
            [black(), ball("lamp", emits, 0.4, [0.3, 3.2, -1.2])],
        ),
        // Interpolated normals, and many edges that do not move.
        Case {
            depth: 3,
            ..case(
                "on a ball",
                [black(), ball("bump", METAL, 1.0, [0.0, -0.6, 0.4]), large()],
            )
        },
        // Edges that lie on each other: both move, or one of them.
        Case {
            moving: vec!["block", "twin"],
            ..case(
                "twins",
                [
                    black(),
                    black().replace("\"block\"", "\"twin\""),
                    large(),
                    sky(),
                ],
            )
        },
        case(
            "blocks that touch",
            [half("block", 0.0), half("twin", 0.4), large(), sky()],
        ),
        // Edges in the plane of the floor.
        case("on the floor", [standing(), small(), sky()]),
        Case {
            depth: 3,
            ..case("before a wall", [black(), wall("grey"), large()])
        },
        // Lit by the wall alone, nearly, which sees the emitter; nothing is lit twice.
        Case {
            depth: 3,
            ..case("by a wall", [black(), wall("grey"), lights_the_wall()])
        },
        Case {
            depth: 4,
            ..case(
                "by a wall and the floor",
                [black(), wall("grey"), lights_the_wall()],
            )
        },
        // A polished floor shows the wall, which is lit by a board behind the camera: edges between those two.
        Case {
            depth: 4,
            floor: POLISHED,
            ..case("by way of a wall", behind_the_camera())
        },
        Case {
            depth: 3,
            floor: POLISHED,
            ..case("not by way of a wall", behind_the_camera())
        },
        // Curves in which surfaces cross, and lines of textures, too.
        Case {
            depth: 3,
            ..case(
                "in a wall",
                [
                    block("block", "black", 0.4, [0.0, 1.2, -1.8]),
                    wall("checks"),
                    large(),
                ],
            )
        },
        Case {
            depth: 3,
            moving: vec!["wall"],
            velocity: Vec3::new(0.5, 0.3, 0.0),
            ..case("a wall slides", [wall("checks"), large()])
        },
        Case {
            depth: 4,
            floor: METAL,
            ..case("metal before metal", [black(), wall("metal"), large()])
        },
        Case {
            depth: 5,
            rotation: spin,
            ..case("long paths", [black(), wall("checks"), large(), sky()])
        },
    ]
}

impl Case {
    pub fn scene(&self) -> Scene {
        scene(self.depth, self.floor, &self.things.concat())
    }

    fn prepared(&self) -> PreparedScene {
        PreparedScene::new(self.scene())
    }

    pub fn tangent(&self, scene: &Scene) -> Tangent {
        let mut tangent = Tangent::zero(scene);
        let velocity = |&p: &Vec3| self.velocity + self.rotation.cross(p);
        for (shape, vectors) in scene.shapes.iter().zip(&mut tangent.shapes) {
            *vectors = self.moving.contains(&&*shape.id).then(|| ShapeVectors {
                vertices: shape.mesh.positions.iter().map(velocity).collect(),
                normals: None,
            });
        }
        tangent
    }
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
    let pairs = estimate
        .mean
        .pixels
        .iter()
        .zip(&estimate.standard_error.pixels);
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
    (
        [worst, score(difference, all)],
        squares(&ours) / squares(&theirs),
    )
}

/// Where only what the camera does not see moves, and has no colour of its own: then there are no other
/// terms.
#[test]
fn boundary_terms_are_those_of_the_cpu() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut wrong = Vec::new();
    // By more than its plane.
    let wall_moves = Case {
        depth: 3,
        moving: vec!["wall"],
        velocity: Vec3::new(0.5, 0.3, 0.4),
        ..case(
            "a wall moves",
            [wall("metal"), emitter("lamp", 1.0, EMITTER, "2, 3, 2.5")],
        )
    };
    for case in cases().into_iter().chain([wall_moves]) {
        let prepared = case.prepared();
        let tangent = case.tangent(prepared.scene());
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let ours = on_device.gradient(&tangent, &options(case.spp, 3), &Unwatched);
        let ours = ours.expect("supported");
        let options = options(8 * case.spp, 4);
        let theirs = capwalk_diff::gradient(&prepared, &tangent, &options, &Unwatched);
        let theirs = theirs.expect("not refused");
        let (scores, ratio) = scores(&ours, &theirs);
        let line = format!(
            "{}: {scores:.2?} standard errors off, variance {:.2} of the CPU's",
            case.name,
            ratio / 8.0
        );
        println!("{line}");
        let is_right = scores.iter().zip(MOST).all(|(score, most)| *score < most);
        if !is_right || ratio / 8.0 > MOST_VARIANCE {
            wrong.push(line);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Rays beside edges need double precision.
#[test]
fn single_precision_is_refused() {
    let Some(gpu) = device::open(Precision::Single) else {
        return;
    };
    let case = case("small", [block("block", "black", 0.35, BLOCK)]);
    let prepared = case.prepared();
    let tangent = case.tangent(prepared.scene());
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let error = on_device.gradient(&tangent, &options(1, 3), &Unwatched);
    let text = error.expect_err("it moves").to_string();
    assert!(
        text.starts_with("the device has single precision alone"),
        "{text}"
    );
}

/// Neither the image nor its derivative depends on how many paths are on the device at a time.
#[test]
fn parts_of_any_size_give_the_same_bits() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let cases = cases();
    let case = cases.last().expect("there are some");
    let prepared = case.prepared();
    let tangent = case.tangent(prepared.scene());
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let image = |most| {
        let found = on_device.gradient_in_parts(&tangent, &options(8, 3), most, &Unwatched);
        let found = found.expect("supported");
        (found.value, found.gradient)
    };
    let whole = image(1 << 18);
    for most in [1 << 18, 71, 250] {
        assert!(image(most) == whole, "{most}");
    }
}
