//! How the learning rate changes from iteration to iteration.

use std::f64::consts::PI;

/// A factor of the learning rate for every iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule {
    /// The first iterations, in which the rate grows in equal steps up to what
    /// it is.
    pub warmup: u32,
    /// What it does then.
    pub decay: Decay,
}

/// How the learning rate falls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Decay {
    /// It does not.
    Constant,
    /// Times `gamma` after every iteration.
    Exponential {
        /// From 0 to 1.
        gamma: f64,
    },
    /// Times `gamma` after every `step_size` iterations.
    Step {
        /// From 0 to 1.
        gamma: f64,
        /// At least 1.
        step_size: u32,
    },
    /// In equal steps to `end` times what it was, at the last iteration.
    Linear {
        /// From 0 to 1.
        end: f64,
    },
    /// Along half a cosine to `end` times what it was (Loshchilov and Hutter
    /// 2017, without restarts).
    Cosine {
        /// From 0 to 1.
        end: f64,
    },
}

impl Schedule {
    /// The factor in an iteration, counted from 0, of so many.
    pub fn factor(&self, iteration: u32, iterations: u32) -> f64 {
        let warm = match self.warmup {
            0 => 1.0,
            warmup => (f64::from(iteration + 1) / f64::from(warmup)).min(1.0),
        };
        // From 0 in the first to 1 in the last iteration.
        let done = f64::from(iteration) / f64::from(iterations.saturating_sub(1).max(1));
        let decay = match self.decay {
            Decay::Constant => 1.0,
            Decay::Exponential { gamma } => gamma.powf(f64::from(iteration)),
            Decay::Step { gamma, step_size } => gamma.powf(f64::from(iteration / step_size)),
            Decay::Linear { end } => 1.0 + (end - 1.0) * done,
            Decay::Cosine { end } => end + (1.0 - end) * 0.5 * (1.0 + (PI * done).cos()),
        };
        warm * decay
    }

    /// True if the factor of an iteration depends on how many there will be.
    pub fn needs_the_end(&self) -> bool {
        matches!(self.decay, Decay::Linear { .. } | Decay::Cosine { .. })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factors(warmup: u32, decay: Decay) -> Vec<f64> {
        let schedule = Schedule { warmup, decay };
        (0..5).map(|k| schedule.factor(k, 5)).collect()
    }

    #[test]
    fn factors_are_what_their_names_say() {
        assert_eq!(factors(0, Decay::Constant), [1.0; 5]);
        assert_eq!(factors(2, Decay::Constant), [0.5, 1.0, 1.0, 1.0, 1.0]);
        let halved = Decay::Exponential { gamma: 0.5 };
        assert_eq!(factors(0, halved), [1.0, 0.5, 0.25, 0.125, 0.0625]);
        let stairs = Decay::Step {
            gamma: 0.1,
            step_size: 2,
        };
        assert_eq!(factors(0, stairs), [1.0, 1.0, 0.1, 0.1, 0.1_f64.powi(2)]);
        let line = factors(0, Decay::Linear { end: 0.2 });
        let cosine = factors(0, Decay::Cosine { end: 0.2 });
        for (k, expected) in [1.0, 0.8, 0.6, 0.4, 0.2].into_iter().enumerate() {
            assert!((line[k] - expected).abs() < 1e-15);
        }
        for (k, expected) in [(0, 1.0), (2, 0.6), (4, 0.2)] {
            assert!((cosine[k] - expected).abs() < 1e-15);
        }
        assert!((cosine[1] - (0.6 + 0.4 * 0.5_f64.sqrt())).abs() < 1e-15);
    }

    /// One iteration is the first and the last.
    #[test]
    fn a_single_iteration_has_the_whole_rate() {
        let schedule = Schedule {
            warmup: 0,
            decay: Decay::Cosine { end: 0.0 },
        };
        assert_eq!(schedule.factor(0, 1), 1.0);
    }
}
