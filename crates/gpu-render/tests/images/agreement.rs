//! Beside the CPU: sample by sample, where samples are the same, and by z-test elsewhere.

use capwalk_gpu::Precision;
use capwalk_gpu_render::unsupported;
use capwalk_render::{PreparedScene, RenderOptions, Unwatched, render};
use capwalk_scene::builtin;

use crate::beside::{compare, on_device};
use crate::scenes;

/// Scenes with emitters whose triangles are so small that the device samples them by area, where
/// the CPU samples them by solid angle.
pub const SMALL_EMITTERS: [&str; 5] = [
    "parity/cylinder.xml",
    "parity/disk_emitter.xml",
    "parity/sphere_emitter.xml",
    "scenes/emitter_of_many_edges_moves/scene.xml",
    "scenes/sphere_emitter_grows/scene.xml",
];

/// Scenes of which nothing is unsupported.
const FEWEST_SCENES: usize = 105;

/// Every scene file that the device can render, and those that are built in.
#[test]
fn samples_are_those_of_the_cpu() {
    let built_in = ["leaf", "ball", "box-room"].map(|name| {
        let scene = builtin::scene(name).expect("built in");
        (name.to_owned(), scene)
    });
    let (mut rendered, mut problems) = (0, Vec::new());
    for (name, scene) in scenes::all().into_iter().chain(built_in) {
        let prepared = PreparedScene::new(scene);
        if SMALL_EMITTERS.contains(&&*name) || unsupported(&prepared).is_some() {
            continue;
        }
        let Some(compared) = compare(&prepared, Precision::Double) else {
            return;
        };
        problems.extend(compared.err().map(|problem| format!("{name}: {problem}")));
        rendered += 1;
    }
    assert_eq!(problems, [""; 0]);
    assert!(rendered >= FEWEST_SCENES, "{rendered} scenes");
}

/// Smooth and flat shading, textures, light from everywhere, light that is reflected often, metals
/// and plastics.
#[test]
fn single_precision_is_enough() {
    for name in [
        "parity/colour_bleeding.xml",
        "parity/bitmap_ball.xml",
        "parity/painted_mesh.xml",
        "parity/cube_sky.xml",
        "parity/environment_map.xml",
        "parity/anisotropic.xml",
        "parity/metal_smooth.xml",
        "parity/plastic_nonlinear.xml",
        "parity/roughplastic.xml",
    ] {
        let prepared = PreparedScene::new(scenes::scene(name));
        let Some(compared) = compare(&prepared, Precision::Single) else {
            return;
        };
        compared.unwrap_or_else(|problem| panic!("{name}: {problem}"));
    }
}

/// A scene without shapes, whose tree has no nodes, shows its environment.
#[test]
fn nothing_is_seen_where_nothing_is() {
    let mut scene = scenes::scene("parity/cube_sky.xml");
    scene.shapes.clear();
    scene.emitters.retain(|emitter| emitter.shape().is_none());
    let prepared = PreparedScene::new(scene);
    if let Some(compared) = compare(&prepared, Precision::Double) {
        assert_eq!(compared, Ok(()));
    }
}

/// Means over nine parts of an image are the CPU's, which has other random numbers. Five
/// scenes and one that is built in, three channels: 162 numbers, of which one is beyond 4.5
/// standard errors by accident in one run of 900, and the seeds are fixed.
#[test]
fn small_emitters_are_as_bright() {
    let mut built_in = builtin::scene("lattice-shadow").expect("built in");
    built_in.film.resize([36, 36]);
    let scenes = SMALL_EMITTERS.iter().map(|name| scenes::scene(name));
    let scenes = scenes.chain([built_in]);
    let spp = 8;
    for scene in scenes {
        let prepared = PreparedScene::new(scene);
        let Some(ours) = on_device(&prepared, &RenderOptions::new(spp, 1), Precision::Double)
        else {
            return;
        };
        let theirs = render(&prepared, &RenderOptions::new(spp, 2), &Unwatched);
        let size = &ours.value.mean;
        let mut differences = [[[0.0; 2]; 3]; 9];
        for (i, (a, b)) in size
            .pixels
            .iter()
            .zip(&theirs.value.mean.pixels)
            .enumerate()
        {
            let [x, y] = [
                i % size.width * 3 / size.width,
                i / size.width * 3 / size.height,
            ];
            let errors = [&ours, &theirs].map(|image| image.value.standard_error.pixels[i]);
            for (channel, [sum, squares]) in differences[3 * y + x].iter_mut().enumerate() {
                *sum += a[channel] - b[channel];
                *squares += errors.iter().map(|e| e[channel] * e[channel]).sum::<f64>();
            }
        }
        for (part, [sum, squares]) in differences.as_flattened().iter().enumerate() {
            let z = sum / squares.sqrt().max(1e-9);
            let id = &prepared.scene().shapes[0].id;
            assert!(z.abs() < 4.5, "{id} and others, part {part}: z = {z}");
        }
    }
}
