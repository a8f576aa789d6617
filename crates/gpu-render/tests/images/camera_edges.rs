//! The boundary term of the edges that the camera sees: beside the CPU's, sample by sample, in
//! scenes whose derivative has no other term.

use capwalk_diff::{Gathers, GradientImage, GradientOptions, Method, Wanted};
use capwalk_gpu::Precision;
use capwalk_gpu_render::{DeviceError, DeviceScene};
use capwalk_math::{Rgb, Vec3};
use capwalk_render::{PreparedScene, RenderOptions, Unwatched, Watch};
use capwalk_scene::{Scene, ShapeVectors, Tangent};

use crate::beside::different;
use crate::derivatives::adjoint;
use crate::faults::Impatient;
use crate::{device, scenes};

/// Where light is emitted and not scattered, derivatives differ by no more than this, relatively:
/// radiance in single precision.
const EMITTED_DIFFERENT: f64 = 1e-6;

/// By how much samples of paths may, and how many may by more: those whose roulette decides otherwise.
const DIFFERENT: f64 = 5e-4;
const MOST_DIFFERENT: usize = 1;

/// A camera, its filter and everything else.
fn scene(integrator: &str, camera: &str, filter: &str, content: &str) -> Scene {
    let text = format!(
        r#"<scene version="3.0.0">
  {integrator}
  <sensor type="{camera}">
    {numbers}
    <transform name="to_world">
      <lookat origin="1.2, 1.7, 5" target="0, 0.5, 0" up="0.1, 1, 0"/>
    </transform>
    <film type="hdrfilm">
      <integer name="width" value="24"/>
      <integer name="height" value="18"/>
      <rfilter type="{filter}"/>
    </film>
  </sensor>
  {content}
</scene>"#,
        numbers = match camera {
            "orthographic" => "",
            "thinlens" =>
                r#"<float name="fov" value="36"/>
    <float name="aperture_radius" value="0.2"/>
    <float name="focus_distance" value="4"/>"#,
            _ => r#"<float name="fov" value="36"/>"#,
        }
    );
    let loaded = capwalk_scene_io::load_scene_str(&text, &scenes::root(), "edges", &[]);
    loaded.unwrap_or_else(|error| panic!("{error}")).scene
}

const EMISSION: &str =
    r#"<integrator type="path"><integer name="max_depth" value="1"/></integrator>"#;

const PATHS: &str = r#"<integrator type="path">
    <integer name="max_depth" value="4"/>
    <integer name="rr_depth" value="2"/>
  </integrator>"#;

const HIDDEN: &str = r#"<integrator type="path">
    <integer name="max_depth" value="3"/>
    <boolean name="hide_emitters" value="true"/>
  </integrator>"#;

const DIRECT: &str = r#"<integrator type="direct">
    <integer name="emitter_samples" value="2"/>
    <integer name="bsdf_samples" value="2"/>
  </integrator>"#;

/// A ring, which hides a part of itself, before a panel; a cube partly behind the ring; a black block
/// before all of them, cut by the border; under a sky.
const EMITTERS: &str = r#"
  <shape type="obj" id="ring">
    <string name="filename" value="parity/torus.obj"/>
    <transform name="to_world">
      <scale value="0.45"/>
      <rotate x="1" angle="50"/>
      <translate x="0.1" y="0.7" z="0.6"/>
    </transform>
    <emitter type="area"><rgb name="radiance" value="1.7, 1.2, 0.4"/></emitter>
  </shape>
  <shape type="rectangle" id="panel">
    <transform name="to_world">
      <rotate y="1" angle="10"/>
      <translate x="-1.3" y="0.2" z="-0.5"/>
    </transform>
    <emitter type="area"><rgb name="radiance" value="0.3, 0.8, 2.1"/></emitter>
  </shape>
  <shape type="cube" id="cube">
    <transform name="to_world">
      <rotate x="1" y="1" angle="40"/>
      <scale value="0.4"/>
      <translate x="0.6" y="0.3" z="-0.6"/>
    </transform>
    <bsdf type="diffuse"/>
    <emitter type="area"><rgb name="radiance" value="0.9, 0.2, 0.6"/></emitter>
  </shape>
  <shape type="cube" id="block">
    <transform name="to_world">
      <scale x="0.1" y="0.2" z="0.5"/>
      <translate x="1.2" y="1.1" z="2.9"/>
    </transform>
    <bsdf type="diffuse"><rgb name="reflectance" value="0"/></bsdf>
  </shape>
  <emitter type="constant"><rgb name="radiance" value="0.1, 0.2, 0.3"/></emitter>"#;

/// A floor and a wall of a material, lit by an emitter and a sign, and a black block near the camera,
/// before the sign: no light on its way from emitters to floor and wall, or between them, passes the
/// block.
fn lit_room(material: &str) -> String {
    format!(
        r#"{material}
  <shape type="rectangle" id="floor">
    <transform name="to_world"><rotate x="1" angle="-90"/><scale value="1.5"/></transform>
    <ref id="material"/>
  </shape>
  <shape type="rectangle" id="wall">
    <transform name="to_world"><scale value="1.5"/><translate y="1.5" z="-1.5"/></transform>
    <ref id="material"/>
  </shape>
  <shape type="rectangle" id="lamp">
    <transform name="to_world">
      <rotate x="1" angle="90"/>
      <scale value="0.6"/>
      <translate y="2.6" z="-0.4"/>
    </transform>
    <emitter type="area"><rgb name="radiance" value="4, 3.8, 3.5"/></emitter>
  </shape>
  <shape type="rectangle" id="sign">
    <transform name="to_world"><scale value="0.4"/><translate x="0.5" y="0.9" z="-1.4"/></transform>
    <emitter type="area"><rgb name="radiance" value="0.5, 2, 1"/></emitter>
  </shape>
  <shape type="cube" id="block">
    <transform name="to_world">
      <rotate x="1" z="1" angle="30"/>
      <scale value="0.2"/>
      <translate x="0.7" y="1.2" z="2.5"/>
    </transform>
    <bsdf type="diffuse"><rgb name="reflectance" value="0"/></bsdf>
  </shape>"#
    )
}

const DIFFUSE: &str = r#"<bsdf type="diffuse" id="material">
    <rgb name="reflectance" value="0.7, 0.6, 0.5"/>
  </bsdf>"#;

const METAL: &str = r#"<bsdf type="roughconductor" id="material">
    <float name="alpha" value="0.3"/>
  </bsdf>"#;

const MIRROR: &str = r#"<bsdf type="conductor" id="material"/>"#;

const VARNISH: &str = r#"<bsdf type="plastic" id="material"/>"#;

/// A shape moves, turns and grows, each in a way of its own.
fn moving(scene: &Scene, names: &[&str]) -> Tangent {
    let mut tangent = Tangent::zero(scene);
    for (number, shape) in scene.shapes.iter().enumerate() {
        if !names.contains(&&*shape.id) {
            continue;
        }
        let k = number as f64;
        let (along, turn) = (
            Vec3::new(1.0, 0.5 - k, 0.3 * k),
            Vec3::new(0.2, k - 1.0, 0.4),
        );
        let velocity = |&p: &Vec3| along + turn.cross(p) + p * (0.3 * k);
        tangent.shapes[number] = Some(ShapeVectors {
            vertices: shape.mesh.positions.iter().map(velocity).collect(),
            normals: None,
        });
    }
    tangent
}

/// The camera moves and turns.
fn with_moving_camera(mut tangent: Tangent) -> Tangent {
    tangent.sensor.translation = Vec3::new(0.4, -0.3, 0.5);
    tangent.sensor.rotation = Vec3::new(0.1, 0.2, -0.3);
    tangent
}

fn options(spp: u32) -> GradientOptions {
    GradientOptions {
        method: Method::Edges(Gathers {
            beside_silhouettes: false,
            ..Gathers::ALL
        }),
        ..GradientOptions::new(RenderOptions::new(spp, 7))
    }
}

/// The device's derivative and the CPU's; `None` where there is no device.
fn both(
    prepared: &PreparedScene,
    tangent: &Tangent,
    options: &GradientOptions,
) -> Option<[GradientImage; 2]> {
    let gpu = device::open(Precision::Double)?;
    let on_device = DeviceScene::new(gpu, prepared).expect("supported");
    let ours = on_device.gradient(tangent, options, &Unwatched);
    let theirs = capwalk_diff::gradient(prepared, tangent, options, &Unwatched);
    Some([ours.expect("supported"), theirs.expect("not refused")])
}

/// Fails if more than so many samples differ by more than a tolerance, or if fewer than these have a
/// derivative.
fn check(what: &str, both: Option<[GradientImage; 2]>, tolerance: f64, most: usize, fewest: usize) {
    let Some([ours, theirs]) = both else {
        return;
    };
    let with_derivative = |image: &GradientImage| {
        let pixels = image.gradient.mean.pixels.iter();
        pixels.filter(|&&pixel| pixel != Rgb::zero()).count()
    };
    let (found, expected) = (with_derivative(&ours), with_derivative(&theirs));
    assert!(
        expected >= fewest,
        "{what}: {expected} samples, device: {found}"
    );
    for (kind, ours, theirs) in [
        ("image", &ours.value, &theirs.value),
        ("derivative", &ours.gradient, &theirs.gradient),
    ] {
        let (count, all) = different(&ours.mean, &theirs.mean, tolerance);
        assert!(
            count <= most,
            "{what}: {kind}: {count} of {all} samples differ"
        );
    }
    assert_eq!(ours.statistics.non_finite, theirs.statistics.non_finite);
}

/// With filters that are discontinuous and that are not, also from a lens; edges before emitters and
/// before the sky, and hidden ones; where sampling knows velocities, and where it may not.
#[test]
fn emitters_and_the_camera_move() {
    for (camera, filter, blind) in [
        ("perspective", "box", false),
        ("perspective", "gaussian", true),
        ("thinlens", "tent", false),
    ] {
        let prepared = PreparedScene::new(scene(EMISSION, camera, filter, EMITTERS));
        let options = GradientOptions {
            blind,
            ..options(1)
        };
        let scene = prepared.scene();
        let shapes = moving(scene, &["ring", "cube", "block"]);
        for (moves, tangent) in [
            ("shapes", shapes.clone()),
            ("camera", with_moving_camera(Tangent::zero(scene))),
            ("both", with_moving_camera(shapes)),
        ] {
            let what = format!("{camera}, {filter}, {moves}");
            let both = both(&prepared, &tangent, &options);
            check(&what, both, EMITTED_DIFFERENT, 0, 40);
        }
    }
}

/// What is behind an edge is a path of several segments, with the random numbers of the sample.
#[test]
fn paths_go_on_beside_edges() {
    for (integrator, filter, material, fewest) in [
        (PATHS, "box", DIFFUSE, 15),
        (PATHS, "gaussian", METAL, 15),
        (DIRECT, "gaussian", DIFFUSE, 15),
        (DIRECT, "box", METAL, 15),
        (HIDDEN, "box", DIFFUSE, 15),
        (PATHS, "gaussian", MIRROR, 8),
        (DIRECT, "box", VARNISH, 8),
    ] {
        let scene = scene(integrator, "perspective", filter, &lit_room(material));
        let tangent = moving(&scene, &["block"]);
        let what = format!("{filter}, {integrator}, {material}");
        let both = both(&PreparedScene::new(scene), &tangent, &options(1));
        check(&what, both, DIFFERENT, MOST_DIFFERENT, fewest);
    }
}

/// Neither image, nor derivative, nor their errors: parts where all samples have an edge, and where
/// none has one.
#[test]
fn parts_of_any_size_give_the_same_bits() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut scene = scene(PATHS, "perspective", "gaussian", &lit_room(DIFFUSE));
    scene.film.resize([12, 9]);
    let tangent = moving(&scene, &["block"]);
    let prepared = PreparedScene::new(scene);
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let parts = |most| {
        let image = on_device.gradient_in_parts(&tangent, &options(24), most, &Unwatched);
        let image = image.expect("supported");
        (image.value, image.gradient, image.statistics)
    };
    let whole = parts(1 << 18);
    assert!(whole.2.complete);
    assert!(
        whole
            .1
            .mean
            .pixels
            .iter()
            .any(|&pixel| pixel != Rgb::zero())
    );
    for most in [3, 71, 250] {
        assert!(parts(most) == whole, "{most}");
    }
}

/// Work that is stopped at any stage gives whole samples, with their terms.
#[test]
fn samples_are_whole_where_work_is_stopped() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let scene = scene(PATHS, "perspective", "box", &lit_room(DIFFUSE));
    let tangent = moving(&scene, &["block"]);
    let prepared = PreparedScene::new(scene);
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let image = |watch: &dyn Watch| {
        let image = on_device.gradient_in_parts(&tangent, &options(1), 97, watch);
        image.expect("supported")
    };
    let whole = image(&Unwatched).gradient.mean;
    let mut with_derivative = 0;
    for until in 0.. {
        let image = image(&Impatient::new(until));
        let counts = image.statistics.samples_per_pixel.iter();
        let pixels = image.gradient.mean.pixels.iter().zip(&whole.pixels);
        for (&count, (&pixel, &expected)) in counts.zip(pixels) {
            assert!(count == 0 || pixel == expected, "{until}");
            with_derivative += u32::from(count > 0 && pixel != Rgb::zero());
        }
        if image.statistics.complete {
            break;
        }
    }
    assert!(with_derivative > 0);
    let (adjoint, wanted) = (adjoint(prepared.scene()), Wanted::by(&tangent));
    let gradient = |watch: &dyn Watch| {
        let found = on_device.backward_in_parts(&adjoint, &wanted, &options(1), 97, watch);
        found.expect("supported")
    };
    let whole = gradient(&Unwatched);
    for until in (0..16).map(|i| 1 << i) {
        let some = gradient(&Impatient::new(until));
        // Of one sample of the image, all or nothing.
        let expected = match some.statistics.complete {
            true => whole.gradient().clone(),
            false => whole.gradient().scaled(0.0),
        };
        assert!(*some.gradient() == expected, "{until}");
        if some.statistics.complete {
            return;
        }
        assert_eq!(some.statistics.samples, 0, "{until}");
    }
    panic!("it never ends");
}

/// With what it is, before a sample is taken.
#[test]
fn what_has_no_edges_yet_is_refused() {
    let refusal = |scene: Scene, precision, options: &GradientOptions| {
        let tangent = with_moving_camera(Tangent::zero(&scene));
        let gpu = device::open(precision)?;
        let prepared = PreparedScene::new(scene);
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        match on_device.gradient(&tangent, options, &Unwatched) {
            Err(DeviceError::Unsupported(unsupported)) => Some(unsupported.to_string()),
            other => panic!("{:?}", other.err()),
        }
    };
    let room = |material| scene(PATHS, "perspective", "box", &lit_room(material));
    let deep = PATHS.replace(r#""max_depth" value="4""#, r#""max_depth" value="8""#);
    let long = PATHS
        .replace(r#""max_depth" value="4""#, r#""max_depth" value="-1""#)
        .replace(r#""rr_depth" value="2""#, r#""rr_depth" value="70000""#);
    let ball = r#"<shape type="sphere" id="ball">
    <float name="radius" value="0.3"/><ref id="material"/>
  </shape>"#;
    let curved = format!("{}{ball}", lit_room(VARNISH));
    let curved = scene(PATHS, "perspective", "box", &curved);
    let edges = options(1);
    let walks = GradientOptions {
        method: Method::Walk,
        ..edges
    };
    let mut steps = edges;
    steps.walk.steps = 2;
    for (scene, precision, options, expected) in [
        (
            scene(EMISSION, "orthographic", "box", EMITTERS),
            Precision::Double,
            edges,
            "the sensor's rays are parallel",
        ),
        (
            curved,
            Precision::Double,
            edges,
            "shape \"ball\" is a curved mirror",
        ),
        (
            scene(&deep, "perspective", "box", &lit_room(MIRROR)),
            Precision::Double,
            edges,
            "mirrors may show each other more than 6 times",
        ),
        (
            scene(&long, "perspective", "box", &lit_room(DIFFUSE)),
            Precision::Double,
            edges,
            "paths may have more than 65535 segments",
        ),
        (
            room(DIFFUSE),
            Precision::Double,
            walks,
            "the method is `walk`",
        ),
        (
            room(MIRROR),
            Precision::Double,
            steps,
            "walks are not of one anchored step",
        ),
        (
            room(DIFFUSE),
            Precision::Single,
            edges,
            "the device has single precision alone",
        ),
    ] {
        if let Some(found) = refusal(scene, precision, &options) {
            assert!(found.starts_with(expected), "{found}");
            assert!(found.contains("not on the GPU yet"), "{found}");
        }
    }
}
