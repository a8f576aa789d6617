//! A method that a pilot tried, and how trials are compared.

use capwalk_boundary::Method;
use capwalk_render::tiles::EFFORT_OF_DERIVATIVE;

/// Samples of each pixel in a trial: variances are those within pixels.
pub const PER_PIXEL: u32 = 4;

/// A trial that costs so many times as much as another one in the first part of its samples takes
/// no more, and none with another cutoff follows: a fitting one has cost a seventh at best.
const HOPELESS: f64 = 10.0;

/// One pixel of so many is taken for an accident, that of the largest variance.
const WORST: usize = 100;

/// A trial with so many times the variance with its worst pixels as without has more than half of it
/// from a few samples: there may be larger ones that so few samples do not show.
const CARRIED: f64 = 2.0;

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
    /// That mean with all pixels as they are.
    pub whole_variance: f64,
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
            effort: EFFORT_OF_DERIVATIVE as f64 + spent as f64 / (count * f64::from(PER_PIXEL)),
        }
    }

    /// True if most of the variance is that of the few worst pixels: a sign of rare and large
    /// samples, whose variance so few of them do not tell.
    pub fn is_carried_by_few(&self) -> bool {
        self.whole_variance > CARRIED * self.variance
    }

    /// Variance × time: what is to be small.
    pub fn cost(&self) -> f64 {
        self.variance * self.effort
    }

    /// Variance × time, with the worst pixels if most of the variance is theirs.
    pub fn upper_cost(&self) -> f64 {
        match self.is_carried_by_few() {
            true => self.whole_variance * self.effort,
            false => self.cost(),
        }
    }

    /// The effort of all of its samples.
    pub fn spent(&self) -> f64 {
        self.samples as f64 * self.effort
    }

    /// So much worse than one of these that more samples would not change it.
    pub fn is_hopeless(&self, trials: &[Self]) -> bool {
        let costs = trials.iter().map(Self::upper_cost);
        self.cost() > HOPELESS * costs.fold(f64::INFINITY, f64::min)
    }

    /// Better than another one by so much that so few samples can tell. Where a few of them carry one
    /// or the other, it must be better with them, too; where they carry the other alone, that is
    /// enough. Trials share their random numbers, so that what happens to one of them alone is a matter
    /// of its method.
    pub fn beats(&self, other: &Self, clearly: f64) -> bool {
        let [few, few_of_other] = [self, other].map(Self::is_carried_by_few);
        let with_all = self.beats_with_all(other, clearly);
        let without = self.cost() < clearly * other.cost();
        // A trial without variance met nothing.
        self.variance > 0.0
            && match (few, few_of_other) {
                (false, false) => without,
                (false, true) => with_all,
                (true, _) => without && with_all,
            }
    }

    /// Better with the worst pixels, whatever it is without: where one is the other with more
    /// samples, they are no accidents.
    pub fn beats_with_all(&self, other: &Self, clearly: f64) -> bool {
        let whole = |trial: &Self| trial.whole_variance * trial.effort;
        self.variance > 0.0 && whole(self) < clearly * whole(other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A trial of pixels that all have this variance, but for a few.
    fn trial(variance: f64, few: &[f64]) -> Trial {
        let pixels = (0..400).map(|i| few.get(i).copied().unwrap_or(variance));
        let found: Vec<(f64, u64)> = pixels.map(|variance| (variance, 400)).collect();
        Trial::new(Method::Walk, 0.2, &found)
    }

    /// Three pixels of four hundred.
    const ACCIDENTS: [f64; 3] = [4e4, 2e3, 1e3];

    #[test]
    fn the_worst_pixels_count_like_the_next_one() {
        let (even, carried) = (trial(1.0, &[]), trial(1.0, &ACCIDENTS));
        assert_eq!((even.variance, even.whole_variance), (1.0, 1.0));
        assert_eq!(carried.variance, 1.0);
        assert!((carried.whole_variance - 43_397.0 / 400.0).abs() < 1e-9);
        assert_eq!((even.effort, even.samples), (200.0, 1600));
        // They all count where hardly any others have a variance.
        let rare = trial(0.0, &ACCIDENTS);
        assert_eq!(rare.variance, rare.whole_variance);
    }

    /// What a few samples carry must be better with them, too; what none carry is preferred to it
    /// even if it looks worse without them.
    #[test]
    fn what_a_few_samples_carry_is_not_trusted() {
        let (even, carried) = (trial(1.0, &[]), trial(0.01, &ACCIDENTS));
        assert!(!even.is_carried_by_few() && carried.is_carried_by_few());
        assert!(carried.cost() < 0.1 * even.cost());
        assert!(!carried.beats(&even, 0.9) && even.beats(&carried, 0.9));
        // So much worse that even the accidents are less.
        let noisy = trial(300.0, &[]);
        assert!(carried.beats(&noisy, 0.9) && !noisy.beats(&carried, 0.9));
        assert!(!even.is_hopeless(&[carried]) && noisy.is_hopeless(&[carried, even]));
    }

    /// A few more samples of the same kind are no reason to distrust one of two.
    #[test]
    fn both_are_compared_with_their_worst_pixels() {
        let (few, not_quite) = (trial(1.0, &[150.0; 3]), trial(1.5, &[190.0; 3]));
        assert!(few.is_carried_by_few() && !not_quite.is_carried_by_few());
        assert!(!not_quite.beats(&few, 0.9));
    }

    /// Where both have accidents, neither the accidents nor the rest decide alone.
    #[test]
    fn accidents_of_both_do_not_decide() {
        let (lucky, unlucky) = (trial(1.0, &[1e3; 3]), trial(0.5, &ACCIDENTS));
        assert!(lucky.is_carried_by_few() && unlucky.is_carried_by_few());
        assert!(!lucky.beats(&unlucky, 0.9) && !unlucky.beats(&lucky, 0.9));
        let better = trial(0.4, &[5e2; 3]);
        assert!(better.beats(&unlucky, 0.9) && better.beats(&lucky, 0.9));
    }

    #[test]
    fn what_met_nothing_is_no_better() {
        assert!(!trial(0.0, &[]).beats(&trial(1.0, &[]), 0.9));
    }
}
