//! How far an image is from a target.

use capwalk_diff::{RenderOptions, Rendering, Statistics};
use capwalk_scene::{Image, Scene};

pub use capwalk_inverse::loss::{Distance, Loss, Measured};

use crate::error::Error;
use crate::method::Choice;

/// Those without numbers of their own.
impl Choice for Distance {
    const NAMES: &'static [(&'static str, Self)] = &[("l1", Self::L1), ("l2", Self::L2)];

    fn help(self) -> &'static str {
        match self {
            Self::L1 => "Absolute difference; noise in the image biases its gradient towards zero",
            Self::L2 => "Squared difference; its gradient is unbiased",
            Self::Relative { .. } => "Squared difference over the squared target",
            Self::Log { .. } => "Squared difference of logarithms",
        }
    }
}

/// The loss of an image that was rendered for it.
#[derive(Clone, Debug)]
pub struct ImageLoss {
    /// The loss, its standard error, and its derivative with respect to each pixel.
    pub measured: Measured,
    /// Seed of the image.
    pub seed: u64,
    /// What was done for the image.
    pub statistics: Statistics,
}

/// The loss of an image that is rendered so as to be independent of a gradient with these options.
pub(crate) fn measure(
    scene: &Scene,
    loss: &Loss,
    target: &Image,
    mask: Option<&Image>,
    options: &RenderOptions,
    render: impl FnOnce(&RenderOptions) -> Result<Rendering, Error>,
) -> Result<ImageLoss, Error> {
    let expected = scene.film.crop_size.map(|n| n as usize);
    for (what, image) in [("target", Some(target)), ("mask", mask)] {
        let found = image.map_or(expected, |image| [image.width, image.height]);
        if found != expected {
            return Err(Error::Size {
                what,
                found,
                expected,
            });
        }
    }
    let options = options.with_independent_seed();
    let rendering = render(&options)?;
    if rendering.statistics.samples_per_pixel.contains(&0) {
        return Err(Error::Stopped {
            before: "every pixel of the image had a sample",
        });
    }
    Ok(ImageLoss {
        measured: loss.measure(&rendering.value, target, mask),
        seed: options.seed,
        statistics: rendering.statistics,
    })
}
