//! Running statistics that can be merged, and tails of distributions.

use serde::{Deserialize, Serialize};

/// Count, mean and spread of a stream of numbers (Welford; merging after
/// Chan et al. 1979).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Moments {
    /// How many numbers were added.
    pub count: u64,
    /// Their mean; 0 if there are none.
    pub mean: f64,
    /// Sum of squared deviations from the mean.
    pub sum_of_squares: f64,
}

impl Moments {
    /// Adds one number.
    #[inline]
    pub fn add(&mut self, x: f64) {
        self.count += 1;
        let before = x - self.mean;
        self.mean += before / self.count as f64;
        self.sum_of_squares += before * (x - self.mean);
    }

    /// Adds everything another stream has seen.
    pub fn merge(&mut self, other: &Self) {
        match (self.count, other.count) {
            (_, 0) => return,
            (0, _) => return *self = *other,
            _ => self.count += other.count,
        }
        let share = other.count as f64 / self.count as f64;
        let shift = other.mean - self.mean;
        self.mean += shift * share;
        // Each of those before is off by the share of the shift, each other one by the rest of it.
        let before = (self.count - other.count) as f64;
        self.sum_of_squares += other.sum_of_squares + shift * shift * (before * share);
    }

    /// The moments of so many numbers, from the sums of their differences from one of them and of those
    /// squared.
    #[inline]
    pub fn from_sums(count: u64, from: f64, sum: f64, squares: f64) -> Self {
        let shift = sum / count as f64;
        Self {
            count,
            mean: from + shift,
            // Negative only by rounding.
            sum_of_squares: (squares - sum * shift).max(0.0),
        }
    }

    /// Unbiased sample variance; NaN for fewer than two numbers.
    pub fn variance(&self) -> f64 {
        if self.count < 2 {
            f64::NAN
        } else {
            self.sum_of_squares / (self.count - 1) as f64
        }
    }

    /// Standard error of the mean; NaN for fewer than two numbers.
    pub fn standard_error(&self) -> f64 {
        (self.variance() / self.count as f64).sqrt()
    }
}

/// Probability that a standard normal variable is above `z`, to 1e-7 absolute
/// (Abramowitz and Stegun 7.1.26, with its asymptotic tail beyond 5).
pub fn normal_upper_tail(z: f64) -> f64 {
    if z < 0.0 {
        return 1.0 - normal_upper_tail(-z);
    }
    if z > 5.0 {
        let inverse_square = 1.0 / (z * z);
        let density = (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt();
        return density / z * (1.0 - inverse_square * (1.0 - 3.0 * inverse_square));
    }
    let x = z / std::f64::consts::SQRT_2;
    let t = 1.0 / (1.0 + 0.3275911 * x);
    let polynomial = t
        * (0.254829592
            + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
    0.5 * polynomial * (-x * x).exp()
}

/// Probability that a chi-squared variable with `n` degrees of freedom is
/// above `x` (Wilson and Hilferty 1931; good to a few per cent of itself for
/// `n` of 10 and more, which is what it is used for).
pub fn chi_squared_upper_tail(x: f64, n: f64) -> f64 {
    let spread = 2.0 / (9.0 * n);
    normal_upper_tail(((x / n).cbrt() - (1.0 - spread)) / spread.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn merging_equals_adding() {
        let numbers: Vec<f64> = (0..100).map(|i| (i as f64 * 1.7).sin() + 1e6).collect();
        let of = |numbers: &[f64]| {
            let mut moments = Moments::default();
            numbers.iter().for_each(|&x| moments.add(x));
            moments
        };
        let all = of(&numbers);
        let [first, last] = [&numbers[..37], &numbers[37..]];
        // By sums, too.
        let from = last[5];
        let differences = last.iter().map(|x| x - from);
        let squares = differences.clone().map(|x| x * x).sum();
        let by_sums = Moments::from_sums(63, from, differences.sum(), squares);
        for last in [of(last), by_sums] {
            let mut merged = of(first);
            merged.merge(&last);
            assert_eq!(merged.count, all.count);
            assert!((merged.mean - all.mean).abs() < 1e-9);
            assert!((merged.variance() / all.variance() - 1.0).abs() < 1e-9);
        }
        let mean = numbers.iter().sum::<f64>() / 100.0;
        let variance = numbers.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / 99.0;
        assert!((all.variance() / variance - 1.0).abs() < 1e-6);
    }

    #[test]
    fn tails_match_tables() {
        for (z, tail) in [
            (0.0, 0.5),
            (1.0, 0.158655254),
            (1.959964, 0.025),
            (-1.0, 0.841344746),
        ] {
            assert!((normal_upper_tail(z) - tail).abs() < 2e-7, "{z}");
        }
        assert!((normal_upper_tail(6.0) / 9.8659e-10 - 1.0).abs() < 1e-3);
        assert!((chi_squared_upper_tail(124.342, 100.0) - 0.05).abs() < 1e-3);
    }
}
