//! How large a pilot is: it follows from the number of samples that it chooses a method for.

use capwalk_scene::Scene;

use crate::options::GradientOptions;

/// The size of a pilot. Work of about as many samples has the same, so that it also makes the same
/// choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PilotSize {
    /// Samples of the work, rounded down to a power of two.
    work: u64,
}

/// Share of the work's samples that a trial takes, if these are enough to compare methods.
const SHARE: u64 = 128;
/// Share of a trial in smaller work: all trials, of which there are up to twelve, take less
/// than half of the samples.
const LARGE_SHARE: u64 = 32;
/// Samples of a trial that are enough to compare methods: more only where the work is large.
const ENOUGH: u64 = 1 << 11;
/// Samples of a trial at most: a choice gets no better with more.
const MOST: u64 = 1 << 14;
/// Samples of a trial at least, of 128 pixels. What so few chose in folders of `tests/scenes` cost at
/// most an eighth more than what 2,048 did; with fewer, hardly a silhouette is met.
const LEAST: u64 = 1 << 9;
/// Share of the work's effort that all trials may take together.
const ALL_TRIALS: f64 = 0.5;

impl PilotSize {
    /// The size of the pilot before work with these options, whose choice will be used so often.
    pub fn of(scene: &Scene, options: &GradientOptions, times: u64) -> Self {
        let samples = scene.film.pixel_count() as u64 * u64::from(options.spp);
        Self::of_samples(samples.saturating_mul(times))
    }

    fn of_samples(work: u64) -> Self {
        let work = work.checked_ilog2().map_or(0, |log| 1 << log);
        Self { work }
    }

    /// Samples that each trial takes; 0 if the work is too small for any.
    pub fn samples_of_trial(self) -> u64 {
        let samples = (self.work / SHARE).max((self.work / LARGE_SHARE).min(ENOUGH));
        match samples {
            0..LEAST => 0,
            samples => samples.min(MOST),
        }
    }

    /// The effort that all trials may take together if a sample of the work takes this.
    pub fn allowed_effort(self, effort_of_sample: f64) -> f64 {
        ALL_TRIALS * self.work as f64 * effort_of_sample
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pilots_grow_with_the_work() {
        let samples = |work| PilotSize::of_samples(work).samples_of_trial();
        let works = [0, 1, 16 * 12, 1 << 14, 1 << 16, 1 << 18, 1 << 19, 1 << 40];
        let expected = [0, 0, 0, 512, 2048, 2048, 4096, 1 << 14];
        assert_eq!(works.map(samples), expected);
    }

    /// A few samples more or less make no other choice.
    #[test]
    fn like_works_have_one_size() {
        let of = PilotSize::of_samples;
        assert_eq!(of(96 * 72 * 16), of(96 * 72 * 18));
    }
}
