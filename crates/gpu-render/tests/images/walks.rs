//! Directions towards surfaces that walk, also where edges are seen in flat mirrors: derivatives beside the
//! CPU's, sample by sample, and both modes beside each other.

use capwalk_boundary::Boundaries;
use capwalk_diff::{Gathers, GradientOptions, Method, Wanted};
use capwalk_gpu::Precision;
use capwalk_gpu_render::DeviceScene;
use capwalk_math::{Rgb, Vec3};
use capwalk_render::{Grid, PreparedScene, RenderOptions, Unwatched};

use crate::beside::different;
use crate::derivatives::adjoint;
use crate::device;
use crate::edges::{BLOCK, Case, GREY, SKY, ball, block, case, cases, emitter, wall};
use crate::motion::{assert_same, everything, samples_among, with_sensor};

/// Samples differ if their derivatives do by more than this, relatively.
const DIFFERENT: f64 = 5e-4;

/// The share of those with a derivative that may, and how many more: which of two edges is nearer, and whether
/// one in the plane of a face is seen, is decided by rounding. On a ball that turns, of 952 samples 15 differ on
/// software Vulkan, and 21 on an H100, for which more may.
const MOST_DIFFERENT: f64 = 0.017;
const MOST_ON_HARDWARE: f64 = 0.025;
const FEW: f64 = 2.0;

/// Pixels of the images, of which there are so many, of one sample; and how many pixels must have a
/// derivative, in all scenes.
const SIZE: [u32; 2] = [24, 18];
const SEEDS: u64 = 3;
const FEWEST_MOVE: usize = 1500;

/// Edges are gathered before the camera, emitters and the environment alone, and film points drawn as on devices.
const WALKS: Method = Method::Edges(Gathers {
    indirect: false,
    beside_silhouettes: false,
    ..Gathers::ALL
});

/// Surfaces whose edges are seen in mirrors, or which are mirrors, all of grey things under an emitter.
fn mirrors() -> Vec<Case> {
    let things = |wall: String| {
        [
            block("block", "grey", 0.35, BLOCK),
            wall,
            emitter("lamp", 1.0, [0.2, 3.5, -1.5], "2, 3, 2.5"),
        ]
    };
    let turned = |id: &str, x: f64, angle: f64| {
        format!(
            r#"<shape type="rectangle" id="{id}">
    <transform name="to_world">
      <scale value="1.2"/><rotate y="1" angle="{angle}"/><translate x="{x}" y="1" z="-0.8"/>
    </transform>
    <ref id="mirror"/>
  </shape>"#
        )
    };
    vec![
        Case {
            depth: 4,
            ..case("before a mirror", things(wall("mirror")))
        },
        Case {
            depth: 4,
            moving: vec!["wall"],
            rotation: Vec3::new(0.3, 0.2, 0.0),
            ..case("a mirror turns", things(wall("mirror")))
        },
        Case {
            depth: 4,
            floor: r#"<ref id="glazed"/>"#,
            ..case("on glazed ground", things(wall("grey")))
        },
        Case {
            depth: 5,
            moving: vec!["block", "left"],
            ..case(
                "between mirrors",
                [
                    block("block", "grey", 0.3, [0.0, 0.5, -0.6]),
                    turned("left", -1.2, 70.0),
                    turned("right", 1.2, -70.0),
                    emitter("lamp", 1.0, [0.2, 3.5, -0.5], "2, 3, 2.5"),
                ],
            )
        },
        Case {
            depth: 3,
            ..case(
                "a ball in a mirror",
                [
                    ball("block", GREY, 0.4, [0.0, 1.0, -0.5]),
                    wall("mirror"),
                    emitter("lamp", 1.0, [0.2, 3.5, -1.5], "2, 3, 2.5"),
                ],
            )
        },
    ]
}

/// A ball that turns: each face's own edges are on its horizon, and move across it.
fn turning_ball() -> Case {
    let things = [
        ball("ball", GREY, 1.0, [0.0, -0.6, 0.4]),
        wall("grey"),
        emitter("lamp", 1.0, [0.2, 3.5, -0.5], "2, 3, 2.5"),
    ];
    Case {
        depth: 3,
        moving: vec!["ball"],
        rotation: Vec3::new(0.3, 0.4, -0.2),
        ..case("a ball turns", things)
    }
}

/// All scenes with light that surfaces reflect, and how directions move there.
fn scenes() -> impl Iterator<Item = (Case, GradientOptions)> {
    let deep = cases().into_iter().filter(|case| case.depth > 2);
    let deep = deep.chain([turning_ball()]).map(|case| (case, WALKS));
    let mirrors = mirrors().into_iter().map(|case| (case, WALKS));
    deep.chain(mirrors).map(|(case, method)| {
        let options = GradientOptions {
            method,
            grid: Grid::default(),
            ..GradientOptions::new(RenderOptions::new(1, 3))
        };
        (case, options)
    })
}

fn prepared(case: &Case) -> PreparedScene {
    let mut scene = case.scene();
    scene.film.resize(SIZE);
    PreparedScene::new(scene)
}

/// Where there are no edges before emitters and the environment: all other terms have the CPU's random
/// numbers.
#[test]
fn walks_are_those_of_the_cpu() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let most = match gpu.is_software() {
        true => MOST_DIFFERENT,
        false => MOST_ON_HARDWARE,
    };
    let mut all = 0;
    for (case, options) in scenes() {
        if case.things.iter().any(|thing| thing == SKY) {
            continue;
        }
        let prepared = prepared(&case);
        let mut boundaries = Boundaries::new(prepared.accel());
        boundaries.area_emitters.clear();
        let tangent = case.tangent(prepared.scene());
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let [mut wrong, mut moving] = [0; 2];
        for seed in 0..SEEDS {
            let options = GradientOptions { seed, ..options };
            let ours = on_device.gradient_among(&boundaries, &tangent, &options, &Unwatched);
            let ours = ours.expect("supported").gradient.mean;
            let theirs = samples_among(&boundaries, &prepared, &tangent, &options);
            let (count, _) = different(&ours, &theirs, DIFFERENT);
            wrong += count;
            let moves = |pixel: &&Rgb| **pixel != Rgb::zero();
            moving += theirs.pixels.iter().filter(moves).count();
        }
        assert!(
            wrong as f64 <= most * moving as f64 + FEW,
            "{}: {wrong} of {moving} samples differ",
            case.name
        );
        all += moving;
    }
    assert!(all >= FEWEST_MOVE, "only {all} pixels move");
}

/// From the same samples, but for rounding, where everything moves.
#[test]
fn walks_are_the_same_in_both_modes() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    for (case, options) in scenes() {
        let prepared = PreparedScene::new(case.scene());
        let scene = prepared.scene();
        let (tangent, adjoint) = (with_sensor(everything(scene)), adjoint(scene));
        let options = GradientOptions {
            blind: true,
            ..options
        };
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let forward = on_device.gradient(&tangent, &options, &Unwatched);
        let forward = forward.expect("supported").gradient.mean;
        let reverse = on_device.backward(&adjoint, &Wanted::by(&tangent), &options, &Unwatched);
        let reverse = reverse.expect("supported");
        assert_same(case.name, &adjoint, &forward, &reverse, &tangent);
    }
}
