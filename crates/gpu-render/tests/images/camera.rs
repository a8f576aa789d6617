//! The camera's rays, which the device draws, beside the CPU's.

use capwalk_diff::GradientOptions;
use capwalk_gpu::Precision;
use capwalk_gpu_render::DeviceScene;
use capwalk_math::{Affine, Vec3};
use capwalk_render::{PreparedScene, RenderOptions, Unwatched, render};
use capwalk_scene::{Film, Filter, Scene, SensorModel, Tangent};

use crate::beside::{compare, different};
use crate::derivatives::all_texels;
use crate::motion::on_cpu;
use crate::{device, scenes};

/// Samples differ if they or their derivatives do by more than this, relatively.
const DIFFERENT: f64 = 5e-4;

const FILTERS: [Filter; 6] = [
    Filter::Box,
    Filter::Tent { radius: 1.3 },
    Filter::Gaussian { stddev: 0.5 },
    Filter::Mitchell { b: 0.2, c: 0.4 },
    Filter::CATMULL_ROM,
    Filter::Lanczos { lobes: 3 },
];

/// A camera of each kind with each filter, whose axes have other lengths than one, before textures
/// and a map, on a part of a film, with filters that are cut off at its border and with others.
fn cameras() -> impl Iterator<Item = (String, Scene)> {
    let scene = |name| scenes::scene(&format!("parity/{name}.xml"));
    let models = [
        SensorModel::Perspective {
            fov_x: 0.8,
            principal_point_offset: [0.1, -0.05],
        },
        SensorModel::ThinLens {
            fov_x: 0.7,
            aperture_radius: 0.2,
            focus_distance: 4.5,
        },
        SensorModel::Orthographic,
    ];
    models.into_iter().flat_map(move |model| {
        let of_filter = move |(i, filter)| {
            let mut scene = scene(["bitmap_ball", "environment_map"][i % 2]);
            scene.film = Film {
                crop_offset: [5, 2],
                crop_size: [21, 17],
                sample_border: i % 3 == 1,
                ..Film::new(30, 22, filter)
            };
            scene.sensor.model = model;
            let size = match model {
                SensorModel::Orthographic => Vec3::new(2.0, 1.7, 1.3),
                _ => Vec3::new(1.2, 0.9, 1.4),
            };
            let camera = &mut scene.sensor.world_from_camera;
            *camera = *camera * Affine::scale(size);
            (format!("{model:?}, {filter:?}"), scene)
        };
        FILTERS.into_iter().enumerate().map(of_filter)
    })
}

/// Sample by sample, in both precisions.
#[test]
fn every_camera_and_filter_draws_the_samples_of_the_cpu() {
    for precision in [Precision::Double, Precision::Single] {
        for (name, scene) in cameras() {
            let prepared = PreparedScene::new(scene);
            let Some(compared) = compare(&prepared, precision) else {
                return;
            };
            compared.unwrap_or_else(|problem| panic!("{precision:?}, {name}: {problem}"));
        }
    }
}

/// Several samples of each pixel with a seed of 64 bits, in parts that end within the image.
#[test]
fn every_sample_has_its_random_numbers() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut scene = scenes::scene("parity/bitmap_ball.xml");
    scene.film.filter = Filter::Gaussian { stddev: 0.5 };
    let prepared = PreparedScene::new(scene);
    let options = RenderOptions::new(3, 0xfedc_ba98_7654_3210);
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let ours = on_device.render_in_parts(&options, 1000, &Unwatched);
    let ours = ours.expect("rendered").value.mean;
    let theirs = render(&prepared, &options, &Unwatched).value.mean;
    let (count, all) = different(&ours, &theirs, DIFFERENT);
    assert!(100 * count <= all, "{count} of {all} pixels differ");
}

/// A part of one sample, which takes less memory than its description.
#[test]
fn single_samples_have_room() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut scene = scenes::scene("parity/bitmap_ball.xml");
    scene.film.resize([4, 3]);
    let prepared = PreparedScene::new(scene);
    let tangent = all_texels(prepared.scene());
    let options = GradientOptions::new(RenderOptions::new(2, 7));
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let [whole, single] = [24, 1].map(|most| {
        let image = on_device.gradient_in_parts(&tangent, &options, most, &Unwatched);
        image.expect("supported").gradient
    });
    assert!(whole.mean.pixels.iter().any(|x| x.max_component() > 0.0));
    assert_eq!(whole, single);
}

/// A telescope far from what it sees has pixels of 3 · 10⁻⁸ rad: single precision does not tell
/// their directions apart.
#[test]
fn far_cameras_see_as_sharply() {
    let mut scene = scenes::scene("parity/bitmap_ball.xml");
    let camera = &mut scene.sensor.world_from_camera;
    let away = camera.vector(Vec3::new(0.0, 0.0, -1.0));
    camera.translation += away * 3e6;
    scene.sensor.far_clip = 1e8;
    scene.sensor.model = SensorModel::Perspective {
        fov_x: 1e-6,
        principal_point_offset: [0.0; 2],
    };
    let prepared = PreparedScene::new(scene);
    for precision in [Precision::Double, Precision::Single] {
        if let Some(compared) = compare(&prepared, precision) {
            assert_eq!(compared, Ok(()), "{precision:?}");
        }
    }
}

/// All numbers of the sensor change: the interior term beside the CPU's, sample by sample. (With
/// parallel rays the CPU's film points move instead.)
#[test]
fn every_moving_camera_has_the_derivatives_of_the_cpu() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    for (name, scene) in cameras() {
        if scene.sensor.model == SensorModel::Orthographic {
            continue;
        }
        let prepared = PreparedScene::new(scene);
        let mut tangent = Tangent::zero(prepared.scene());
        let sensor = &mut tangent.sensor;
        sensor.translation = Vec3::new(0.03, -0.02, 0.04);
        sensor.rotation = Vec3::new(-0.02, 0.04, 0.03);
        sensor.axes[0] = Vec3::new(0.02, 0.01, -0.03);
        sensor.optics = Vec3::new(0.05, 0.04, 0.3);
        let options = GradientOptions::new(RenderOptions::new(1, 7));
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let ours = on_device.interior_term(&tangent, &options, &Unwatched);
        let ours = ours.expect("supported").gradient.mean;
        let theirs = on_cpu(&prepared, &tangent, &options);
        let (count, all) = different(&ours, &theirs, DIFFERENT);
        assert!(
            100 * count <= all,
            "{name}: {count} of {all} samples differ"
        );
    }
}
