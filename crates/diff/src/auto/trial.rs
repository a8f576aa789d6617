//! A method that a pilot tried, and how trials are compared.

use capwalk_boundary::Method;
use capwalk_render::tiles::EFFORT_OF_SAMPLE;

/// Samples of each pixel in a trial: variances are those within pixels.
pub const PER_PIXEL: u32 = 4;

/// A trial that costs so many times as much as another one in the first part of its samples takes
/// no more, and none with another cutoff follows: a fitting one has cost a seventh at best.
const HOPELESS: f64 = 10.0;

/// One pixel of so many is taken for an accident, that of the largest variance.
const WORST: usize = 100;

/// A method that was tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    /// The method.
    pub method: Method,
    /// The angular cutoff of its walks around surfaces, radians.
    pub max_radius: f64,
    /// How many samples were taken.
    pub samples: u64,
    /// The mean over the pixels of a sample's variance, summed over the channels; the
    /// hundredth of them where it is largest counts like the next one.
    pub variance: f64,
    /// The same with all that was met.
    pub whole_variance: f64,
    /// The share of the variance that the pixel with the largest one has, from 0 to 1.
    pub largest_share: f64,
    /// The mean effort of a sample, in about twenty nanoseconds.
    pub effort: f64,
}

impl Trial {
    /// What was found of some pixels by a method: the variance of the samples of each, and their
    /// effort in all.
    pub fn new(method: Method, max_radius: f64, found: &[(f64, u64)]) -> Self {
        let count = found.len() as f64;
        // The worst pixels count like the next one: an event that few pilots see would decide
        // alone. They all count where hardly any others have a variance at all.
        let mut variances: Vec<f64> = found.iter().map(|&(variance, _)| variance).collect();
        variances.sort_by(|a, b| b.total_cmp(a));
        let whole_variance: f64 = variances.iter().sum();
        let largest_share = variances.first().map_or(0.0, |largest| match largest {
            0.0 => 0.0,
            largest => largest / whole_variance,
        });
        let worst = variances.len().div_ceil(WORST);
        if let Some(&next) = variances.get(worst).filter(|&&next| next > 0.0) {
            variances[..worst].fill(next);
        }
        let variance: f64 = variances.iter().sum();
        let spent: u64 = found.iter().map(|(_, spent)| spent).sum();
        Self {
            method,
            max_radius,
            samples: found.len() as u64 * u64::from(PER_PIXEL),
            variance: variance / count,
            whole_variance: whole_variance / count,
            largest_share,
            effort: EFFORT_OF_SAMPLE as f64 + spent as f64 / (count * f64::from(PER_PIXEL)),
        }
    }

    /// Variance × time: what is to be small.
    pub fn cost(&self) -> f64 {
        self.variance * self.effort
    }

    /// The effort of all of its samples.
    pub fn spent(&self) -> f64 {
        self.samples as f64 * self.effort
    }

    /// So much worse than one of these that more samples would not change it.
    pub fn is_hopeless(&self, trials: &[Self]) -> bool {
        let least = trials.iter().map(Self::cost).fold(f64::INFINITY, f64::min);
        self.cost() > HOPELESS * least
    }

    /// Better than another one by so much that so few samples can tell.
    pub fn beats(&self, other: &Self, clearly: f64) -> bool {
        // A trial without variance met nothing.
        self.variance > 0.0 && self.cost() < clearly * other.cost()
    }

    /// The same even with the worst pixels.
    pub fn beats_with_all(&self, other: &Self, clearly: f64) -> bool {
        let whole = |trial: &Trial| trial.whole_variance * trial.effort;
        self.beats(other, clearly) && whole(self) < clearly * whole(other)
    }
}
