//! Lobes and environment maps whose numbers no scene file has: textures in all places, indices near
//! and below one, facets nearly smooth, black maps, many samples of each technique.

use std::path::Path;

use capwalk_gpu::Precision;
use capwalk_render::PreparedScene;
use capwalk_scene::{Emitter, Scene, ShadingNormals, ShapeId};

use crate::beside::compare;

/// A ball, a floor and a wall of a material, under a sky and a rectangle that emits.
fn scene(material: &str, sky: &str, integrator: &str) -> Scene {
    let text = format!(
        r#"<scene version="3.0.0">
  {integrator}
  <sensor type="perspective">
    <float name="fov" value="36"/>
    <transform name="to_world">
      <lookat origin="1.5, 2, 5" target="0, 0.5, 0" up="0, 1, 0"/>
    </transform>
    <film type="hdrfilm">
      <integer name="width" value="36"/>
      <integer name="height" value="28"/>
      <rfilter type="box"/>
    </film>
  </sensor>
  {material}
  <shape type="sphere" id="ball">
    <point name="center" x="-0.3" y="0.6" z="0.2"/>
    <float name="radius" value="0.6"/>
    <ref id="material"/>
  </shape>
  <shape type="rectangle" id="floor">
    <transform name="to_world">
      <rotate x="1" angle="-90"/>
      <scale value="2.5"/>
    </transform>
    <ref id="material"/>
  </shape>
  <shape type="rectangle" id="wall">
    <transform name="to_world">
      <rotate y="1" angle="200"/>
      <translate x="0.9" y="1" z="-1"/>
    </transform>
    <ref id="material"/>
  </shape>
  <shape type="rectangle" id="lamp">
    <transform name="to_world">
      <rotate x="1" angle="90"/>
      <translate x="-0.5" y="3"/>
    </transform>
    <emitter type="area">
      <rgb name="radiance" value="4, 3.8, 3.5"/>
    </emitter>
  </shape>
  {sky}
</scene>"#
    );
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/parity");
    let loaded = capwalk_scene_io::load_scene_str(&text, &folder, "material", &[]);
    let mut scene = loaded.unwrap_or_else(|error| panic!("{error}")).scene;
    // Normals of the wall turn away from the camera, which sees the face.
    let wall = scene.shapes.iter().position(|shape| shape.id == "wall");
    let wall = scene.shape_mut(ShapeId(wall.expect("there is a wall") as u32));
    let [a, b, c] = wall.mesh.corners(0);
    let along = (b - a).normalized();
    let across = (b - a).cross(c - a).normalized();
    let count = wall.mesh.positions.len();
    wall.normals = ShadingNormals::Given(vec![(along + across * 0.2).normalized(); count]);
    scene
}

const PATHS: &str = r#"<integrator type="path">
    <integer name="max_depth" value="5"/>
    <integer name="rr_depth" value="2"/>
  </integrator>"#;

const DIRECT: &str = r#"<integrator type="direct">
    <integer name="emitter_samples" value="3"/>
    <integer name="bsdf_samples" value="2"/>
  </integrator>"#;

const GREY: &str =
    r#"<emitter type="constant"><rgb name="radiance" value="0.3, 0.4, 0.5"/></emitter>"#;

/// A material on both sides, from its type and what is in it.
fn two_sided(kind: &str, content: &str) -> String {
    format!(r#"<bsdf type="twosided" id="material"><bsdf type="{kind}">{content}</bsdf></bsdf>"#)
}

fn texture(name: &str, file: &str) -> String {
    format!(
        r#"<texture name="{name}" type="bitmap"><string name="filename" value="{file}"/></texture>"#
    )
}

fn number(name: &str, number: f64) -> String {
    format!(r#"<float name="{name}" value="{number}"/>"#)
}

fn string(name: &str, value: &str) -> String {
    format!(r#"<string name="{name}" value="{value}"/>"#)
}

/// A sky and an integrator.
type Surroundings = [&'static str; 2];
const OUTDOORS: Surroundings = [GREY, PATHS];
/// Where a surface is diffuse, points on the emitter alone are sampled.
const ONE_EMITTER: Surroundings = ["", DIRECT];

/// Each in surroundings of its own.
const DISTRIBUTIONS: [(&str, Surroundings); 2] = [("beckmann", OUTDOORS), ("ggx", ONE_EMITTER)];

/// Fails if a scene's samples are not the CPU's.
fn check(scene: Scene, what: &str) {
    let prepared = PreparedScene::new(scene);
    if let Some(compared) = compare(&prepared, Precision::Double) {
        assert_eq!(compared, Ok(()), "{what}");
    }
}

fn check_material(kind: &str, content: &str, [sky, integrator]: Surroundings) {
    let material = two_sided(kind, content);
    check(scene(&material, sky, integrator), &material);
}

#[test]
fn metals_have_any_index_and_roughness() {
    let gold = string("material", "Au");
    let textured = [
        texture("eta", "colours.png"),
        texture("k", "leaf.png"),
        texture("specular_reflectance", "colours.png"),
    ]
    .concat();
    let glassy = [number("eta", 1.02), number("k", 0.0)].concat();
    for metal in [gold, textured, glassy] {
        check_material("conductor", &metal, OUTDOORS);
        for (distribution, surroundings) in DISTRIBUTIONS {
            let turned = [number("alpha_u", 0.08), number("alpha_v", 0.6)].concat();
            let alpha = |alpha| number("alpha", alpha);
            for alpha in [
                alpha(0.01),
                alpha(1.0),
                turned,
                texture("alpha", "rough.png"),
            ] {
                let distribution = string("distribution", distribution);
                let rough = [&*metal, &distribution, &alpha].concat();
                check_material("roughconductor", &rough, surroundings);
            }
        }
    }
}

#[test]
fn plastics_have_any_index_and_roughness() {
    let textured = [
        texture("diffuse_reflectance", "colours.png"),
        texture("specular_reflectance", "leaf.png"),
    ]
    .concat();
    let black = number("diffuse_reflectance", 0.0);
    let nonlinear = [&textured, r#"<boolean name="nonlinear" value="true"/>"#].concat();
    for base in [textured, black, nonlinear] {
        for [inside, outside] in [[1.5, 1.0], [1.0, 1.3], [1.01, 1.0]] {
            let coat = [
                &*base,
                &number("int_ior", inside),
                &number("ext_ior", outside),
            ]
            .concat();
            check_material("plastic", &coat, OUTDOORS);
            for ((distribution, surroundings), alpha) in DISTRIBUTIONS.into_iter().zip([0.05, 0.5])
            {
                let facets = [string("distribution", distribution), number("alpha", alpha)];
                let rough = [&*coat, &facets.concat()].concat();
                check_material("roughplastic", &rough, surroundings);
            }
        }
    }
}

/// A turned map; the same with a sun, beside which other texels are dark; and a black one, which is
/// drawn uniformly.
#[test]
fn maps_are_drawn_beside_other_emitters() {
    const MAP: &str = r#"<emitter type="envmap">
      <string name="filename" value="sky.exr"/>
      <transform name="to_world"><rotate x="0.6" y="0.8" angle="170"/></transform>
      <float name="scale" value="0.7"/>
    </emitter>"#;
    const HIDDEN: &str =
        r#"<integrator type="path"><boolean name="hide_emitters" value="true"/></integrator>"#;
    let plain: fn(&mut [f64]) = |_| ();
    let sunny: fn(&mut [f64]) = |texels| {
        let middle = texels.len() / 6 * 3;
        texels[middle..][..3].fill(1e5);
    };
    let black: fn(&mut [f64]) = |texels| texels.fill(0.0);
    for (paint, integrator) in [(plain, PATHS), (sunny, DIRECT), (black, HIDDEN)] {
        for (kind, content) in [
            ("diffuse", String::new()),
            ("plastic", String::new()),
            ("roughconductor", number("alpha", 0.2)),
            ("conductor", String::new()),
        ] {
            let mut scene = scene(&two_sided(kind, &content), MAP, integrator);
            let mut maps = scene.emitters.iter();
            let texels = maps.find_map(|emitter| match emitter {
                Emitter::EnvironmentMap { data, .. } => Some(*data),
                _ => None,
            });
            let texels = texels.expect("there is a map");
            paint(&mut scene.texture_mut(texels).data);
            check(scene, &format!("{kind}, {integrator}"));
        }
    }
}
