//! What is differentiated: a loss by its derivative by every pixel, from a file
//! or from the distance to a target.

use std::time::Duration;

use anyhow::{Result, bail};
use capwalk_diff::{Estimate, Options, Prepared, Statistics};
use capwalk_math::Rgb;
use capwalk_scene::{Image, Scene};
use serde_json::{Value, json};

use crate::args::{Backward, LossName};
use crate::progress::Progress;
use crate::{output, report};

/// A derivative by every pixel, and where it comes from.
pub struct Objective {
    pub adjoint: Image,
    pub loss: Option<Loss>,
}

/// A loss that was computed.
pub struct Loss {
    name: LossName,
    /// Mean over pixels and channels.
    pub value: f64,
    /// How much of it the noise of the picture makes on average, if that is
    /// known (for the square: its variance).
    noise: Option<f64>,
    /// Seed of the picture.
    pub seed: u64,
    /// What was done for the picture, and in how many seconds.
    pub statistics: Statistics,
    seconds: f64,
}

/// Reads files, and checks that they fit the scene.
pub fn read(args: &Backward, scene: &Scene) -> Result<Image> {
    let (layer, size) = (args.layer.as_deref(), scene.film.crop_size);
    match (&args.objective.adjoint, &args.target) {
        (Some(file), _) => output::read_layer(file, layer, &["adjoint", "value"], size),
        (None, Some(file)) => output::read_layer(file, layer, &["value"], size),
        (None, None) => bail!("neither --adjoint nor --target was given"),
    }
}

/// The derivative of the loss by each pixel's channels. `read` is what [`read`]
/// returned. `None` if the picture was stopped before every pixel had a sample.
pub fn objective(
    args: &Backward,
    scene: &Scene,
    options: &Options,
    read: Image,
) -> Result<Option<Objective>> {
    let Some(name) = args.objective.loss else {
        return Ok(Some(Objective {
            adjoint: read,
            loss: None,
        }));
    };
    // Another seed than that of the gradient: the adjoint must not know its
    // random numbers. The complement is nobody's neighbour in a row of seeds.
    let options = Options {
        seed: !options.seed,
        ..*options
    };
    let limit = args.sampling.time_limit.map(|limit| limit / PICTURE_SHARE);
    let progress = Progress::new("picture", limit);
    let picture = capwalk_diff::render(&Prepared::new(scene.clone()), &options, &progress);
    let seconds = progress.finish().as_secs_f64();
    let statistics = picture.statistics;
    if statistics.samples_per_pixel.contains(&0) {
        return Ok(None);
    }
    let (value, adjoint) = distance(name, &picture.value.mean, &read);
    Ok(Some(Objective {
        adjoint,
        loss: Some(Loss {
            name,
            value,
            noise: noise(name, &picture.value),
            seed: options.seed,
            statistics,
            seconds,
        }),
    }))
}

/// One of so many parts of a time limit is for the picture: samples of its
/// gradient take several times as long.
const PICTURE_SHARE: u32 = 4;

impl LossName {
    /// Of one difference.
    fn of(self, difference: f64) -> f64 {
        match self {
            Self::L1 => difference.abs(),
            Self::L2 => difference * difference,
        }
    }

    /// Its derivative; 0 where it has none.
    fn slope(self, difference: f64) -> f64 {
        match self {
            Self::L1 if difference == 0.0 => 0.0,
            Self::L1 => difference.signum(),
            Self::L2 => 2.0 * difference,
        }
    }
}

/// The mean distance over pixels and channels, and its derivative by each.
fn distance(name: LossName, picture: &Image, target: &Image) -> (f64, Image) {
    let count = 3.0 * picture.pixels.len() as f64;
    let pairs = picture.pixels.iter().zip(&target.pixels);
    let differences: Vec<Rgb> = pairs.map(|(&a, &b)| a - b).collect();
    let channels = differences.iter().flat_map(|d| d.to_array());
    let value = channels.map(|d| name.of(d)).sum::<f64>() / count;
    let slopes = differences.iter().map(|d| d.map(|d| name.slope(d)) / count);
    let adjoint = Image {
        pixels: slopes.collect(),
        ..*picture
    };
    (value, adjoint)
}

/// What noise adds to the loss on average.
fn noise(name: LossName, picture: &Estimate) -> Option<f64> {
    let errors = &picture.standard_error.pixels;
    let squares = errors.iter().map(|e| e.dot(*e)).sum::<f64>();
    let noise = squares / (3.0 * errors.len() as f64);
    (name == LossName::L2 && noise.is_finite()).then_some(noise)
}

impl Loss {
    /// What there is to say about it, in lines.
    pub fn describe(&self) -> String {
        let mut text = format!("loss ({}): {:.6e}", self.name(), self.value);
        if let Some(noise) = self.noise {
            let noise = report::significant(noise, 2);
            text += &format!(", of which about {noise} is noise of the picture");
        }
        text += &format!("\nthe picture has the seed {}\n", self.seed);
        report::work("picture", &self.statistics, self.seconds) + &text
    }

    /// The same as JSON.
    pub fn to_json(&self) -> Value {
        json!({
            "name": self.name(),
            "value": self.value,
            "noise": self.noise,
            "seed": self.seed,
            "statistics": report::statistics_json(&self.statistics, self.seconds),
        })
    }

    /// Its name as typed.
    pub fn name(&self) -> &'static str {
        match self.name {
            LossName::L1 => "l1",
            LossName::L2 => "l2",
        }
    }

    /// How long the picture took.
    pub fn elapsed(&self) -> Duration {
        Duration::from_secs_f64(self.seconds)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Derivatives of both losses against central differences.
    #[test]
    fn adjoints_are_derivatives() {
        let image = |pixels: &[Rgb]| Image {
            width: 2,
            height: 1,
            pixels: pixels.to_vec(),
        };
        let target = image(&[Rgb::new(0.5, 1.0, 2.0), Rgb::new(0.0, 3.0, 0.25)]);
        let picture = image(&[Rgb::new(0.75, 0.5, 2.0), Rgb::new(0.5, 1.0, 0.0)]);
        for (name, expected) in [(LossName::L1, 3.5), (LossName::L2, 4.625)] {
            let (value, adjoint) = distance(name, &picture, &target);
            assert!((value - expected / 6.0).abs() < 1e-15, "{value}");
            for pixel in 0..2 {
                for channel in 0..3 {
                    let loss = |h: f64| {
                        let mut moved = picture.clone();
                        let mut numbers = moved.pixels[pixel].to_array();
                        numbers[channel] += h;
                        moved.pixels[pixel] = numbers.into();
                        distance(name, &moved, &target).0
                    };
                    let difference = (loss(1e-6) - loss(-1e-6)) / 2e-6;
                    let slope = adjoint.pixels[pixel][channel];
                    assert!((slope - difference).abs() < 1e-9, "{slope} {difference}");
                }
            }
        }
    }
}
