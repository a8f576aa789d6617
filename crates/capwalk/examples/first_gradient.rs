//! The derivative of an image with respect to a motion: of a ball and its shadow when the
//! ball moves sideways. Writes `first_gradient.png`, blue where pixels get darker and red
//! where they get brighter, and prints how sure the result is.

use capwalk::{GradientOptions, Loader, Prepared, Unwatched, write_image};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Any Mitsuba 3 file will do; `ball` is built in.
    let loaded = Loader::new("ball").size([96, 72]).load()?;
    for warning in &loaded.warnings {
        eprintln!("warning: {warning}");
    }
    let prepared = Prepared::new(loaded.scene)?;

    // The derivative per world unit of motion, with the image that comes with it.
    let options = GradientOptions {
        spp: 32,
        ..GradientOptions::default()
    };
    let result = prepared.gradient("ball.translate.x", &options, &Unwatched)?;
    write_image("first_gradient.png", "gradient", &result.gradient.mean)?;

    // Every pixel has a standard error.
    let mean_square = |image: &capwalk::Image| {
        let squares: f64 = image.pixels.iter().map(|pixel| pixel.dot(*pixel)).sum();
        (squares / image.pixels.len() as f64).sqrt()
    };
    println!(
        "{} samples; gradient {:.3}, noise {:.3} (root mean squares over pixels)",
        result.statistics.samples,
        mean_square(&result.gradient.mean),
        mean_square(&result.gradient.standard_error),
    );
    Ok(())
}
