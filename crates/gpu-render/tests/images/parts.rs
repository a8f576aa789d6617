//! What is on the device at a time changes no bit.

use capwalk_gpu::Precision;
use capwalk_gpu_render::DeviceScene;
use capwalk_render::{PreparedScene, RenderOptions, Unwatched, render};

use crate::{device, scenes};

#[test]
fn parts_of_any_size_give_the_same_bits() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut scene = scenes::scene("parity/colour_bleeding.xml");
    scene.film.resize([12, 9]);
    let prepared = PreparedScene::new(scene);
    let options = RenderOptions::new(96, 3);
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let image = |most| {
        on_device
            .render_in_parts(&options, most, &Unwatched)
            .expect("rendered")
    };
    let whole = image(1 << 18);
    assert!(whole.statistics.complete);
    assert_eq!(whole.statistics.samples, 12 * 9 * 96);
    assert_eq!(whole.statistics.samples_per_pixel, vec![96; 108]);
    for most in [97, 250] {
        let parts = image(most);
        assert_eq!(parts.value, whole.value, "{most}");
        assert_eq!(parts.statistics, whole.statistics);
    }
    // And the errors are those of the CPU, whose samples are nearly the same.
    let theirs = render(&prepared, &options, &Unwatched);
    let pixels = |image: &capwalk_render::Rendering| image.value.standard_error.pixels.clone();
    let pairs = pixels(&whole).into_iter().zip(pixels(&theirs));
    let near =
        pairs.filter(|(a, b)| (*a - *b).map(f64::abs).max_component() < 2e-2 * b.max_component());
    assert!(near.count() >= 100);
}
