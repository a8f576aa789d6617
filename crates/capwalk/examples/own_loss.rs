//! A loss of one's own: how bright a window of the image is, squared.
//! Whatever a loss is, its derivative with respect to each pixel is an adjoint image, and
//! one pass in reverse mode turns that into the gradient with respect to any number of
//! parameters: here all vertices of a leaf, and its position.

use capwalk::{GradientOptions, Image, Loader, Prepared, RenderOptions, Rgb, Unwatched};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Loader::new("leaf").size([40, 30]).load()?.scene;
    let prepared = Prepared::new(scene)?;
    let options = GradientOptions {
        spp: 64,
        ..GradientOptions::default()
    };

    // The image that the loss is of. Its noise must be independent of the gradient's: the
    // mean of a product is the product of the means only then.
    let sampling: RenderOptions = options.sampling().with_independent_seed();
    let image = prepared.render(&sampling, &Unwatched)?.value.mean;

    // The loss is the square of the mean brightness of a window, `L = m²`.
    let (columns, rows) = (16..24, 12..18);
    let count = (columns.len() * rows.len()) as f64;
    let pixels = || {
        rows.clone()
            .flat_map(|y| columns.clone().map(move |x| (x, y)))
    };
    let mean = pixels()
        .map(|(x, y)| brightness(image.at(x, y)))
        .sum::<f64>()
        / count;

    // Its derivative with respect to each channel of a pixel: 2 m ∂m/∂pixel.
    let mut adjoint = Image::new(image.width, image.height);
    for (x, y) in pixels() {
        adjoint.pixels[y * image.width + x] = Rgb::splat(2.0 * mean / (3.0 * count));
    }

    let names = ["leaf.positions", "leaf.translate.x", "leaf.translate.z"];
    let gradients = prepared.backward(&adjoint, &names, &options, &Unwatched)?;
    println!("loss {:.5}", mean * mean);
    for gradient in &gradients {
        println!(
            "{:17} {:?} {:.5} ± {:.5}",
            gradient.name, gradient.shape, gradient.size, gradient.size_error
        );
    }
    Ok(())
}

/// The mean of the channels.
fn brightness(pixel: Rgb) -> f64 {
    pixel.to_array().iter().sum::<f64>() / 3.0
}
