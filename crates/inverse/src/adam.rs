//! Adam (Kingma and Ba 2015), with PyTorch's conventions, and its uniform variant
//! (Nicolet et al. 2021, section 4), in which all numbers of a group take steps by
//! the same rate: the direction of the gradient is kept, which smoothing relies
//! on.

/// What there is to choose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adam {
    /// How much of the means of the gradient and of its square is kept.
    pub betas: [f64; 2],
    /// Added to the root of the mean square.
    pub eps: f64,
}

impl Default for Adam {
    fn default() -> Self {
        Self {
            betas: [0.9, 0.999],
            eps: 1e-8,
        }
    }
}

/// Running means of a group of unknowns.
#[derive(Debug)]
pub struct MomentEstimates<'a> {
    /// Means of the gradient.
    pub first: &'a mut [f64],
    /// Means of its square.
    pub second: &'a mut [f64],
}

impl Adam {
    /// Updates the moments of a group of unknowns and subtracts the step from
    /// them. `step` counts from 1; `lr` is the learning rate.
    pub fn step(
        &self,
        step: u32,
        lr: f64,
        uniform: bool,
        gradient: &[f64],
        moments: MomentEstimates,
        unknowns: &mut [f64],
    ) {
        let [beta1, beta2] = self.betas;
        let bias = |beta: f64| 1.0 - beta.powf(f64::from(step));
        let (bias1, bias2) = (bias(beta1), bias(beta2));
        for (m, &g) in moments.first.iter_mut().zip(gradient) {
            *m = beta1 * *m + (1.0 - beta1) * g;
        }
        for (v, &g) in moments.second.iter_mut().zip(gradient) {
            *v = beta2 * *v + (1.0 - beta2) * g * g;
        }
        let largest = moments.second.iter().copied().fold(0.0, f64::max);
        let moments = moments.first.iter().zip(&*moments.second);
        for (x, (m, &v)) in unknowns.iter_mut().zip(moments) {
            let v = if uniform { largest } else { v };
            *x -= lr * (m / bias1) / ((v / bias2).sqrt() + self.eps);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(uniform: bool, gradients: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let (mut first, mut second, mut x) = ([0.0; 2], [0.0; 2], [1.0, -1.0]);
        let steps = gradients.iter().zip(1..).map(|(gradient, step)| {
            let moments = MomentEstimates {
                first: &mut first,
                second: &mut second,
            };
            let adam = Adam {
                betas: [0.5, 0.75],
                eps: 0.0,
            };
            adam.step(step, 0.1, uniform, gradient, moments, &mut x);
            x
        });
        steps.collect()
    }

    #[track_caller]
    fn assert_near(found: [f64; 2], expected: [f64; 2]) {
        for (a, b) in found.into_iter().zip(expected) {
            assert!((a - b).abs() < 1e-15, "{found:?} {expected:?}");
        }
    }

    /// By hand: the first step is the rate, whatever the gradient; in the second
    /// the means are m = (½ g₁ + g₂)/2, over 3/4, and v = ¾ ¼ g₁² + ¼ g₂², over
    /// 7/16.
    #[test]
    fn steps_are_those_by_hand() {
        let x = run(false, &[[4.0, -0.01], [2.0, 0.02]]);
        assert_near(x[0], [1.0 - 0.1, -1.0 + 0.1]);
        let second = |before: f64, g1: f64, g2: f64| {
            let m = (0.25 * g1 + 0.5 * g2) / 0.75;
            let v = (0.1875 * g1 * g1 + 0.25 * g2 * g2) / 0.4375;
            before - 0.1 * m / v.sqrt()
        };
        assert_near(x[1], [second(0.9, 4.0, 2.0), second(-0.9, -0.01, 0.02)]);
    }

    /// All steps of a group have the same rate: the first one is along the
    /// gradient, and as long as the rate in its largest number.
    #[test]
    fn uniform_steps_keep_the_direction() {
        let x = run(true, &[[4.0, -1.0], [0.0, 2.0]]);
        assert_near(x[0], [1.0 - 0.1, -1.0 + 0.1 / 4.0]);
        // The largest v is that of the first number: ¾ ¼ 16 = 3.
        let rate = 0.1 / (3.0_f64 / 0.4375).sqrt();
        let m = [0.25 * 4.0 / 0.75, (-0.25 + 0.5 * 2.0) / 0.75];
        assert_near(x[1], [0.9 - rate * m[0], -0.975 - rate * m[1]]);
    }

    /// Where the gradient is zero, nothing moves, and nothing is NaN.
    #[test]
    fn no_gradient_no_step() {
        let adam = Adam::default();
        let (mut first, mut second, mut x) = ([0.0], [0.0], [3.0]);
        let moments = MomentEstimates {
            first: &mut first,
            second: &mut second,
        };
        adam.step(1, 0.1, true, &[0.0], moments, &mut x);
        assert_eq!(x, [3.0]);
    }
}
