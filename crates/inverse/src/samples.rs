//! How many samples a step takes: always the same number, or as many as its noise requires
//! (docs/optimize.md, "Samples that follow the noise").
//!
//! With `d` the last step as it would be at the full learning rate, the descent `a = -g·d` is by how much the loss falls
//! per step if steps go on as they do. The gradient is new and `d` is not, so their noise is independent, and noise does
//! not change the mean of `a`, as far as the loss is one that noise does not bias.
//!
//! Adam's steps follow the mean of many gradients, so a single gradient may be far noisier than the descent is large, and
//! many steps with few samples lead further than few steps with many. More samples pay once noise hides the descent in a
//! whole block of steps: then these wander about where they are. This is the inner-product test of Bollapragada, Byrd
//! and Nocedal (2018), for a block. With `V_I` and `V_G` the variances of `a` that one sample per pixel of images and of
//! gradients would add, and `c` the cost of a gradient's sample in samples of images, a variance `e²` costs least with
//!
//! ```text
//! n_I = r n_G ,   n_G = (V_I / r + V_G) / e² ,   r = √(c V_I / V_G) .
//! ```
//!
//! By choice `r` is `c` at most, so that images do not cost more than gradients.

/// Sample counts that follow the noise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByNoise {
    /// `θ`: the standard error that the mean descent of a block of steps may have, relative to it.
    pub theta: f64,
    /// The most samples per pixel of a gradient. Images have at most `cost` times as many.
    pub most: u32,
    /// `c`: what a sample of the gradient costs, in samples of the image; a guess, which changes no mean.
    pub cost: f64,
}

/// The fewest samples per pixel of images and gradients that have errors.
pub const LEAST: [u32; 2] = [2, 4];

/// [`ByNoise::cost`] with and without anything that moves; measured in `docs/optimize.md`.
pub const COSTS: [f64; 2] = [50.0, 1.5];
/// So many steps are judged together.
const BLOCK: f64 = 20.0;
/// The variance of a step's descent becomes smaller or larger by this factor, and larger only if that leaves less than is
/// allowed.
const CHANGE: f64 = 2.0;
/// By how much the counts of images and of gradients grow in a block at most; they fall by [`CHANGE`] at most. What
/// noise of images is left over from that of gradients is known badly, and may seem to be none.
const GROWTH: [f64; 2] = [4.0, 2.0];
/// More samples help only if noise is at least this part of the mean square of descents: what else they vary by is
/// steps that are too long.
const NOISY: f64 = 0.5;

/// What is remembered of the noise of steps.
#[derive(Clone, Debug, PartialEq)]
pub struct StepNoise {
    /// The samples per pixel of the next image and the next gradient, before they are rounded.
    pub counts: [f64; 2],
    /// The last step over the factor of the schedule; zero before the first.
    pub direction: Vec<f64>,
    /// Since counts may last have changed: how many steps; sums of their descents, of the squares, and of the
    /// variances [`Descent::by`] for one sample per pixel. Long steps count more.
    pub block: [f64; 5],
    /// Set by the last of two blocks that had the most samples, too much noise, and no descent that is clear.
    pub no_descent: Option<NoDescent>,
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
            block: [0.0; 5],
            no_descent: None,
        }
    }

    /// The samples per pixel of the next image and the next gradient.
    pub fn spp(&self) -> [u32; 2] {
        self.counts.map(|count| count.round() as u32)
    }

    /// Learns from a step. Counts do not become smaller than `least`.
    pub fn learn(&mut self, rule: &ByNoise, least: [u32; 2], descent: &Descent) {
        self.no_descent = None;
        if self.direction.iter().all(|&d| d == 0.0) {
            return;
        }
        // All steps of a block have the same counts. A single step is noisy.
        let spp = self.spp().map(f64::from);
        let Descent { value, by } = *descent;
        let new = [1.0, value, value * value, by[0] * spp[0], by[1] * spp[1]];
        for (sum, new) in self.block.iter_mut().zip(new) {
            *sum += new;
        }
        let [steps, sums @ ..] = self.block;
        if steps % BLOCK != 0.0 {
            return;
        }
        let [mean, squared, variances @ ..] = sums.map(|sum| sum / steps);
        let [by_image, by_gradient] = variances.map(|variance| variance.max(0.0));
        // The variance of a step's descent, and what it may be so that the mean of the block is known.
        let noise = by_image / spp[0] + by_gradient / spp[1];
        let allowed = (rule.theta * mean.max(0.0)).powi(2) * steps;
        let is_short = noise > allowed && noise > NOISY * squared;
        let wanted = match is_short {
            true => noise / CHANGE,
            false if noise * CHANGE < allowed => noise * CHANGE,
            false => noise,
        };
        if !(wanted > 0.0 && wanted.is_finite()) {
            self.block = [0.0; 5];
            return;
        }
        let counts = self.cheapest(rule, least, [by_image, by_gradient], wanted, wanted > noise);
        // Where samples cannot grow, a second block must say that there is no descent, too: if it is twice the noise of a
        // block, one misses it with the probability 0.16, and both with 0.03.
        let is_most = counts[0] < (CHANGE - 1e-6) * spp[0] && counts[1] <= spp[1];
        let error = (noise / steps).sqrt();
        if is_short && is_most && mean <= error {
            if steps == BLOCK {
                return;
            }
            let steps = steps as u32;
            self.no_descent = Some(NoDescent { mean, error, steps });
        }
        self.counts = counts;
        self.block = [0.0; 5];
    }

    /// The counts that give a descent the variance `wanted` at the least cost, as far as they may change, from the
    /// variances for one sample. Unless noise may grow, images get the ratio `r` even where gradients have their least
    /// count, which is more than they need: at most that doubles the time of a step.
    fn cheapest(
        &self,
        rule: &ByNoise,
        least: [u32; 2],
        [by_image, by_gradient]: [f64; 2],
        wanted: f64,
        may_grow: bool,
    ) -> [f64; 2] {
        let (cost, most) = (rule.cost, f64::from(rule.most));
        let balanced = (by_image * by_gradient / cost).sqrt();
        let ideal = (balanced.max(by_image / cost) + by_gradient) / wanted;
        let ratio = (cost * by_image / by_gradient).sqrt().min(cost);
        let limited = |i: usize, count: f64, most: f64| {
            let least = f64::from(least[i]);
            let slowly = count.clamp(self.counts[i] / CHANGE, self.counts[i] * GROWTH[i]);
            slowly.clamp(least, most.max(least))
        };
        let beside = match may_grow {
            true => ideal,
            false => ideal.max(least[1].into()),
        };
        let of_images = limited(0, ratio * beside.min(most), u32::MAX.into());
        // The noise that images leave to gradients, if they have more than the ideal.
        let left = wanted - by_image / of_images;
        let of_gradients = match left > 0.0 {
            true => ideal.min(by_gradient / left),
            false => ideal,
        };
        [of_images, limited(1, of_gradients, most)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RULE: ByNoise = ByNoise {
        theta: 0.5,
        most: 256,
        cost: 4.0,
    };

    /// Steps with a given descent for a variance, and errors of either sign in turn; variances fall with the samples.
    /// What is remembered, and how many steps there were.
    fn after(steps: u32, descent: impl Fn(f64) -> f64, variances: [f64; 2]) -> (StepNoise, u32) {
        let mut noise = StepNoise::new([8, 16], 1);
        noise.direction = vec![1.0];
        for step in 0..steps {
            let spp = noise.spp();
            let by = [0, 1].map(|i| variances[i] / f64::from(spp[i]));
            let variance = by[0] + by[1];
            let error = [1.0, -1.0][step as usize % 2] * variance.sqrt();
            let value = descent(variance) + error;
            noise.learn(&RULE, LEAST, &Descent { value, by });
            if noise.no_descent.is_some() {
                return (noise, step + 1);
            }
        }
        (noise, steps)
    }

    /// Counts settle between what is enough and twice that. The mean of 20 descents of 2 may have the variance 1, so each
    /// may have 20: if image and gradient have the variances 1000 and 250 of a sample, n_G = (1000 / 4 + 250) / 20, and
    /// n_I is four times that.
    #[test]
    fn counts_follow_the_noise() {
        for (variances, expected) in [
            ([1000.0, 250.0], [100, 25]),
            ([0.0, 1800.0], [2, 90]),
            ([800.0, -1.0], [40, 10]),
            ([1e7, 1e7], [512, 256]),
            ([1e-6, 1e-6], [2, 4]),
        ] {
            let (noise, _) = after(400, |_| 2.0, variances);
            for (count, expected) in noise.spp().into_iter().zip(expected) {
                assert!(
                    (expected..=2 * expected).contains(&count),
                    "{variances:?}: {count}"
                );
            }
        }
    }

    /// Of all counts with their variance, those of image and gradient cost least.
    #[test]
    fn counts_are_the_cheapest() {
        let variances = [3000.0, 1500.0];
        let (noise, _) = after(400, |_| 2.0, variances);
        let [of_image, of_gradient] = noise.counts;
        let variance = variances[0] / of_image + variances[1] / of_gradient;
        let cost = |of_image: f64| {
            of_image + RULE.cost * variances[1] / (variance - variances[0] / of_image)
        };
        let own = cost(of_image);
        assert!((own - of_image - RULE.cost * of_gradient).abs() < 1e-9 * own);
        for other in [0.97, 1.03] {
            assert!(own < cost(other * of_image), "{other}");
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

    /// Where noise hides the descent, samples grow block by block, to the most, and after two blocks with these it is over;
    /// not where the descent is small but clear.
    #[test]
    fn it_is_over_where_there_is_no_descent() {
        let (noise, steps) = after(400, |_| -0.1, [9e3, 9e3]);
        let found = noise.no_descent.expect("over");
        assert_eq!(found.steps, 40);
        assert!(
            (found.mean + 0.1).abs() < 1e-12 && found.error > 1.0,
            "{found:?}"
        );
        // A block of 8 and 16, and of 32 and 16, 64 and 32, up to 512 and 256, and a second one of these.
        assert_eq!(steps, 140);
        let at_1_5_errors = |variance: f64| 1.5 * (variance / 20.0).sqrt();
        let (noise, _) = after(400, at_1_5_errors, [9e3, 9e3]);
        assert_eq!((noise.spp(), noise.no_descent), ([512, 256], None));
    }

    /// The variance of a step is known from one difference, and that of images is what this has left over from the
    /// gradients': with such errors, too, images do not lose the samples that they need, and where there is no descent it is
    /// soon over.
    #[test]
    fn badly_known_noise_does_no_harm() {
        let rule = ByNoise {
            theta: 0.9,
            most: 64,
            cost: 50.0,
        };
        let mut state = 1_u64;
        let mut uniform = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        // Of the variance 1, about normal.
        let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
        for of_image in [0.1, 1.0, 10.0, 100.0] {
            for run in 0..20 {
                let mut noise = StepNoise::new([4, 4], 1);
                noise.direction = vec![1.0];
                let mut steps = 0;
                while noise.no_descent.is_none() {
                    let [images, gradients] = noise.spp().map(f64::from);
                    let [by_image, by_gradient] = [of_image / images, 1.0 / gradients];
                    let both = by_image + by_gradient;
                    let by = [both * normal().powi(2) - by_gradient, by_gradient];
                    let value = both.sqrt() * normal();
                    noise.learn(&rule, LEAST, &Descent { value, by });
                    steps += 1;
                    assert!(steps <= 400, "{of_image}, {run}: {:?}", noise.counts);
                    // A ninth of what pays beside four samples of the gradient, √(50 V_I) times as many.
                    let least = 3.0 * of_image.sqrt();
                    assert!(steps <= 60 || images > least, "{of_image}, {run}: {images}");
                }
            }
        }
    }

    /// Where descents of either sign are larger than their noise, more samples would not help.
    #[test]
    fn steps_that_are_too_long_need_no_samples() {
        let mut noise = StepNoise::new([8, 16], 1);
        noise.direction = vec![1.0];
        for step in 0..400 {
            let value = [1.0, -1.0][step % 2];
            let by = noise.spp().map(|spp| 1.0 / f64::from(spp));
            noise.learn(&RULE, LEAST, &Descent { value, by });
        }
        assert!(noise.no_descent.is_none());
        assert!(noise.counts[1] <= 16.0, "{:?}", noise.counts);
    }
}
