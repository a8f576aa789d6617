//! Estimates against exact numbers.

use capwalk_diff::{Estimate, GradientOptions, Method, RenderOptions};

/// Standard errors beyond which a difference is no accident: 7 tests in a
/// million are beyond, and there are some hundred of them.
const SIGNIFICANT: f64 = 4.5;

/// Demands that an estimate with an error equals the exact number, and that the
/// error is small enough to say something.
pub fn equals(name: &str, mean: f64, error: f64, exact: f64, largest_error: f64) {
    println!("{name}: {mean:.5} ± {error:.5}, exactly {exact:.5}");
    assert!((mean - exact).abs() <= SIGNIFICANT * error + 1e-9, "{name}");
    assert!(error <= largest_error, "{name}: the error says nothing");
}

/// So many samples per pixel.
pub fn settings(spp: u32) -> GradientOptions {
    GradientOptions {
        method: Method::Walk,
        ..GradientOptions::new(RenderOptions::new(spp, 5))
    }
}

/// The mean of an image, and of each of its quarters, with errors.
pub fn means(image: &Estimate) -> [(f64, f64); 5] {
    let (width, height) = (image.mean.width, image.mean.height);
    let mean = |is_in: &dyn Fn(usize, usize) -> bool| {
        let (mut sum, mut variance, mut count) = (0.0, 0.0, 0.0);
        for (i, pixel) in image.mean.pixels.iter().enumerate() {
            if is_in(i % width, i / width) {
                sum += pixel.r;
                variance += image.standard_error.pixels[i].r.powi(2);
                count += 1.0;
            }
        }
        (sum / count, f64::sqrt(variance) / count)
    };
    let [half_x, half_y] = [width / 2, height / 2];
    [
        mean(&|_, _| true),
        mean(&|x, y| x < half_x && y < half_y),
        mean(&|x, y| x >= half_x && y < half_y),
        mean(&|x, y| x < half_x && y >= half_y),
        mean(&|x, y| x >= half_x && y >= half_y),
    ]
}
