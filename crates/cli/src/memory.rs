//! Whether there is memory for an image, before work begins that cannot end.

use anyhow::{Result, ensure};
use capwalk::Scene;
use capwalk::scene::memory::{available, mib};

/// What commands take for each pixel, bytes: the sums of up to 16 batches, of which five wait
/// for each other, and the results in memory and as a file. Measured with 16 samples or more
/// per pixel: 473, 863 and 918.
#[derive(Clone, Copy)]
pub enum Need {
    /// An image.
    Image = 500,
    /// A derivative image and the image that comes with it.
    Gradient = 900,
    /// The same twice, of which one is sums; and a first reference while a second one is made,
    /// four images and what was compared.
    Check = 1000 + 4 * 24 + 8,
    /// The image that a loss is of, its target and its adjoint, and the sums of a gradient.
    Loss = 900 + 3 * 24,
    /// Images to be compared, with everything that their statistics need.
    Comparison = 600,
}

/// An error if the machine has not the memory for an image of this scene.
pub fn check(scene: &Scene, need: Need) -> Result<()> {
    check_size(scene.film.crop_size, need)
}

/// An error if the machine has not the memory for an image of so many pixels.
pub fn check_size(size: [u32; 2], need: Need) -> Result<()> {
    match available() {
        Some(free) => fits(size, need, free),
        None => Ok(()),
    }
}

fn fits([width, height]: [u32; 2], need: Need, free: u64) -> Result<()> {
    let bytes = u64::from(width) * u64::from(height) * need as u64;
    let instead = match need {
        Need::Comparison => "compare images of crop windows one after the other",
        Need::Loss => "choose fewer pixels (--size, or the size of the film), or crop windows",
        _ => "choose fewer pixels with --size, or render crop windows one after the other",
    };
    ensure!(
        bytes <= free,
        "{width} x {height} pixels need up to {} MiB of memory, and {} MiB are free; {instead}",
        mib(bytes),
        mib(free)
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_that_do_not_fit_are_refused() {
        let size = [8000, 8000];
        assert!(fits(size, Need::Image, 40 << 30).is_ok());
        let error = fits(size, Need::Gradient, 40 << 30).expect_err("too large");
        let text = error.to_string();
        assert!(
            text.starts_with("8000 x 8000 pixels need up to 54932 MiB"),
            "{text}"
        );
        assert!(text.contains("40960 MiB are free"), "{text}");
        assert!(fits(size, Need::Comparison, 40 << 30).is_ok());
        assert!(fits(size, Need::Comparison, 30 << 30).is_err());
    }
}
