//! What the device does not have is refused by name.

use capwalk_gpu::Precision;
use capwalk_gpu_render::{DeviceError, DeviceScene, unsupported};
use capwalk_render::{PreparedScene, RenderOptions, Unwatched};
use capwalk_scene::{Integrator, SamplerKind, Scene};

use crate::{device, scenes};

fn refusal(scene: Scene) -> Option<String> {
    Some(unsupported(&PreparedScene::new(scene))?.to_string())
}

#[test]
fn what_is_missing_is_named() {
    for (name, expected) in [
        (
            "parity/dielectric.xml",
            "the material of shape \"block\" is of the type dielectric: not on the GPU yet",
        ),
        (
            "parity/maps_around_sides.xml",
            "the material of shape \"front_pitted\" is of the type normalmap",
        ),
        ("parity/glass_rough.xml", "is of the type roughdielectric"),
        ("parity/principled.xml", "is of the type principled"),
        ("parity/mask.xml", "is of the type mask"),
        ("parity/point_light.xml", "is of the type point"),
        (
            "scenes/emitters_that_touch/scene.xml",
            "an emitter is in the plane of another surface",
        ),
        (
            "scenes/depth_of_a_turning_cube/scene.xml",
            "the integrator renders depth, not light",
        ),
    ] {
        let found = refusal(scenes::scene(name)).unwrap_or_default();
        assert!(
            found.contains(expected) && found.contains("--device cpu"),
            "{name}: {found}"
        );
    }
    let mut scene = scenes::scene("parity/bitmap.xml");
    assert_eq!(refusal(scene.clone()), None);
    scene.settings.sampler = SamplerKind::Sobol;
    assert!(
        refusal(scene).is_some_and(|found| found.starts_with("the sampler takes Sobol points"))
    );
}

/// Before anything is done, also where only options ask for it.
#[test]
fn adaptive_sampling_is_refused() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut scene = scenes::scene("parity/bitmap.xml");
    let prepared = PreparedScene::new(scene.clone());
    let options = RenderOptions {
        adaptive: true,
        ..RenderOptions::new(4, 1)
    };
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let error = on_device.render(&options, &Unwatched).err();
    assert!(matches!(error, Some(DeviceError::Unsupported(_))));
    scene.settings.integrator = Integrator::Aov(capwalk_scene::Aov::Mask);
    let prepared = PreparedScene::new(scene);
    let error = DeviceScene::new(gpu, &prepared).err();
    assert!(matches!(error, Some(DeviceError::Unsupported(_))));
}
