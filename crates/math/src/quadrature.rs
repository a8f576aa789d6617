//! Integrals as weighted sums.

use std::f64::consts::PI;

/// Nodes and weights of the rule of Gauss and Legendre with `n` nodes on
/// `[0, 1]`, exact for polynomials of degree `2 n - 1`; to 1e-14.
pub fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    (0..n).map(|i| node(i, n)).collect()
}

/// The `i`-th zero of Legendre's polynomial of degree `n`, largest first, by
/// Newton's method, moved to `[0, 1]`.
fn node(i: usize, n: usize) -> (f64, f64) {
    // From the asymptotic zeros it converges in three steps or four.
    const STEPS: usize = 6;
    let mut x = (PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
    let mut dp = 1.0;
    for _ in 0..STEPS {
        let (mut p, mut before) = (1.0, 0.0);
        for k in 0..n {
            let k = k as f64;
            (p, before) = (((2.0 * k + 1.0) * x * p - k * before) / (k + 1.0), p);
        }
        dp = n as f64 * (x * p - before) / (x * x - 1.0);
        x -= p / dp;
    }
    (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * dp * dp))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_integrated_exactly() {
        for n in [1, 2, 8, 33, 64] {
            let rule = gauss_legendre(n);
            for degree in [0, 1, 2 * n - 1] {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(degree as i32)).sum();
                let integral = 1.0 / (degree + 1) as f64;
                assert!(
                    (sum / integral - 1.0).abs() < 1e-12,
                    "{n} nodes, degree {degree}"
                );
            }
        }
    }
}
