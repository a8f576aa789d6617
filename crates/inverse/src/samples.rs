//! How many samples a step takes: always the same number, or as many as its noise requires
//! (docs/optimize.md, "Samples that follow the noise").
//!
//! With `d` the last step as it would be at the full learning rate, the descent `a = -g·d` is by how much the loss falls
//! per step if steps go on as they do. The gradient is new and `d` is not, so their noise is independent, and noise does
//! not change the mean of `a`, as far as the loss is one that noise does not bias.
//! As in the inner-product test of Bollapragada, Byrd and Nocedal (2018), a step has enough samples if the standard error
//! of `a` is at most `θ |a|`, with `a²` the mean over some steps, less what noise adds to it. With the variances `V_I` and `V_G` that one sample per pixel of images and of gradients would
//! add, and what these samples cost, the counts that reach an error `e` at the least cost are
//!
//! ```text
//! n_I = √(V_I / c_I) S / e² ,   n_G = √(V_G / c_G) S / e² ,   S = √(V_I c_I) + √(V_G c_G)
//! ```

/// Sample counts that follow the noise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByNoise {
    /// `θ`: the standard error of the descent, relative to it, that a step may have.
    pub theta: f64,
    /// The most samples per pixel of an image, and of a gradient.
    pub most: u32,
}

/// The fewest samples per pixel of images and gradients that have errors.
pub const LEAST: [u32; 2] = [2, 4];

/// What a sample of an image and one of a gradient cost, relative to each other: a guess, which changes no mean.
const COSTS: [f64; 2] = [1.0, 4.0];
/// How much of the means over steps is kept in each.
const KEPT: f64 = 0.8;
/// Counts change by this factor at most in a step.
const FASTEST: f64 = 2.0;
/// Counts get smaller if this times as many would be enough.
const FAR_BELOW: f64 = 2.0;
/// The steps in a row with the most samples that decide whether there is still a descent.
const BLOCK: f64 = 20.0;
/// There is if its mean over them is so many standard errors. A descent of 0.45 of its noise goes on then in five of
/// six blocks, and none in one of six.
const CLEARLY: f64 = 1.0;

/// What is remembered of the noise of steps.
#[derive(Clone, Debug, PartialEq)]
pub struct StepNoise {
    /// The samples per pixel of the next image and the next gradient, before they are rounded.
    pub counts: [f64; 2],
    /// The last step over the factor of the schedule; zero before the first.
    pub direction: Vec<f64>,
    /// Running sums over steps, with weights that fall: of the weights, the squared descent less what noise adds to it,
    /// and its variances [`Descent::by`] for one sample per pixel.
    pub sums: [f64; 4],
    /// How many steps in a row had the most samples, and too much noise, up to 20; the sums of their descents and
    /// of the squares.
    pub block: [f64; 3],
}

/// The descent along the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Descent {
    /// What it is, loss per step at the full learning rate.
    pub value: f64,
    /// Its variances by the noise of the image and by that of the gradient. Their sum is known from the difference of two
    /// halves, one number, so the first may be below zero; it is NaN where there are no halves.
    pub by: [f64; 2],
}

/// A descent that cannot be told from zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoDescent {
    /// Its mean over some steps.
    pub mean: f64,
    /// The standard error of that.
    pub error: f64,
    /// How many steps.
    pub steps: u32,
}

impl StepNoise {
    /// Before the first step, which has so many samples, for so many unknowns.
    pub fn new(spp: [u32; 2], unknowns: usize) -> Self {
        Self {
            counts: spp.map(f64::from),
            direction: vec![0.0; unknowns],
            sums: [0.0; 4],
            block: [0.0; 3],
        }
    }

    /// The samples per pixel of the next image and the next gradient.
    pub fn spp(&self) -> [u32; 2] {
        self.counts.map(|count| count.round() as u32)
    }

    /// Learns from a step. Counts do not become smaller than `least`.
    pub fn learn(&mut self, rule: &ByNoise, least: [u32; 2], descent: &Descent) {
        if self.direction.iter().all(|&d| d == 0.0) {
            return;
        }
        // Means over some steps: a single one is noisy.
        let spp = self.spp();
        let [of_image, of_gradient] = [0, 1].map(|i| descent.by[i] * f64::from(spp[i]));
        let squared = descent.value * descent.value - descent.by[0] - descent.by[1];
        let new = [1.0, squared, of_image, of_gradient];
        for (sum, new) in self.sums.iter_mut().zip(new) {
            *sum = KEPT * *sum + (1.0 - KEPT) * new;
        }
        let [_, squared, variances @ ..] = self.sums.map(|sum| (sum / self.sums[0]).max(0.0));
        // If there is no descent, the error is to be 0: as many as possible.
        let squared_error = rule.theta * rule.theta * squared;
        let both: f64 = variances
            .iter()
            .zip(COSTS)
            .map(|(v, cost)| (v * cost).sqrt())
            .sum();
        let mut is_short = false;
        for i in [0, 1] {
            let enough = (variances[i] / COSTS[i]).sqrt() * both / squared_error;
            is_short |= spp[i] >= rule.most && enough > f64::from(rule.most);
            let change = match enough / self.counts[i] {
                more if more > 1.0 => more.min(FASTEST),
                less if less * FAR_BELOW < 1.0 => less.max(1.0 / FASTEST),
                _ => 1.0,
            };
            let most = rule.most.max(least[i]);
            self.counts[i] = (self.counts[i] * change).clamp(least[i].into(), most.into());
        }
        // Steps with as many as possible, for which these are not enough.
        if self.block[0] >= BLOCK {
            self.block = [0.0; 3];
        }
        match is_short {
            true => {
                let new = [1.0, descent.value, descent.value * descent.value];
                let sums = self.block.iter_mut().zip(new);
                sums.for_each(|(sum, new)| *sum += new);
            }
            false => self.block = [0.0; 3],
        }
    }

    /// That the last steps had the most samples, too much noise, and no descent that is clearly above zero.
    pub fn no_descent(&self) -> Option<NoDescent> {
        let [count, sum, squares] = self.block;
        let mean = sum / count;
        let error = ((squares / count - mean * mean) / (count - 1.0))
            .max(0.0)
            .sqrt();
        (count >= BLOCK && mean <= CLEARLY * error).then_some(NoDescent {
            mean,
            error,
            steps: count as u32,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RULE: ByNoise = ByNoise {
        theta: 0.5,
        most: 256,
    };

    /// Steps with a given descent, and variances that fall with the samples; what is left of them.
    fn after(steps: u32, descent: impl Fn(u32) -> f64, variances: [f64; 2]) -> (StepNoise, u32) {
        let mut noise = StepNoise::new([8, 16], 1);
        noise.direction = vec![1.0];
        for step in 0..steps {
            let (spp, value) = (noise.spp(), descent(step));
            let by = [0, 1].map(|i| variances[i] / f64::from(spp[i]));
            // As large as with noise on average.
            let size = (value * value + by[0] + by[1]).sqrt();
            let value = size.copysign(value);
            noise.learn(&RULE, LEAST, &Descent { value, by });
            if noise.no_descent().is_some() {
                return (noise, step + 1);
            }
        }
        (noise, steps)
    }

    /// Counts settle between what is enough and twice that. A descent of 2 may have the squared error 1: if the image
    /// and the gradient have the variances 50 and 12.5 of a sample, then n_I = 50 (1 + 1) = 100 and n_G = 12.5 (1 + 1).
    #[test]
    fn counts_follow_the_noise() {
        for (variances, expected) in [
            ([50.0, 12.5], [100, 25]),
            ([0.0, 90.0], [2, 90]),
            ([20.0, -1.0], [20, 4]),
            ([1e6, 1e6], [256, 256]),
            ([1e-6, 1e-6], [2, 4]),
        ] {
            let (noise, _) = after(60, |_| 2.0, variances);
            for (count, expected) in noise.spp().into_iter().zip(expected) {
                assert!(
                    (expected..=2 * expected).contains(&count),
                    "{variances:?}: {count}"
                );
            }
        }
    }

    /// Before the first step there is no direction, and nothing to learn.
    #[test]
    fn the_first_step_changes_nothing() {
        let mut noise = StepNoise::new([8, 16], 2);
        let by = [1.0, 1.0];
        noise.learn(&RULE, LEAST, &Descent { value: 0.0, by });
        assert_eq!(noise, StepNoise::new([8, 16], 2));
    }

    /// Where the descent has either sign, samples grow to the most, and after some steps with these it is over; where it
    /// is small but steady, it is not. Where the sign changes and is known, few samples are enough.
    #[test]
    fn it_is_over_where_there_is_no_descent() {
        let (noise, steps) = after(100, |step| [1.0, -0.9][step as usize % 2], [9e3, 9e3]);
        let found = noise.no_descent().expect("over");
        assert_eq!(found.steps, 20);
        assert!(found.mean.abs() < 2.0 * found.error, "{found:?}");
        assert!((24..30).contains(&steps), "{steps}");
        let steady = |step| 1.0 + [1.0, -1.0][step as usize % 2];
        let (noise, _) = after(100, steady, [9e3, 9e3]);
        assert_eq!((noise.spp(), noise.no_descent()), ([256; 2], None));
        let (noise, _) = after(100, |step| [1.0, -1.0][step as usize % 2], [0.1, 0.1]);
        assert_eq!(noise.spp(), [2, 4]);
    }
}
