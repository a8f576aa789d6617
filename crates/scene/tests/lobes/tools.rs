//! Random numbers, directions, and integrals over the sphere.

use std::f64::consts::PI;

use capwalk_math::Vec3;
use capwalk_math::quadrature::gauss_legendre;

/// Random numbers of a fixed seed (SplitMix64).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Uniform in `[0, 1)`.
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn pair(&mut self) -> [f64; 2] {
        [self.next(), self.next()]
    }
}

/// The direction with the given cosine and azimuth.
pub fn direction(cos: f64, phi: f64) -> Vec3 {
    let sin = (1.0 - cos * cos).max(0.0).sqrt();
    Vec3::new(sin * phi.cos(), sin * phi.sin(), cos)
}

/// Integral over the part of the sphere with cosines and azimuths in the given
/// ranges, in `pieces` by `pieces` tiles of Gauss's rule of eight nodes.
pub fn integral<const C: usize>(
    cosines: [f64; 2],
    azimuths: [f64; 2],
    pieces: usize,
    f: impl Fn(Vec3) -> [f64; C],
) -> [f64; C] {
    let rule = gauss_legendre(8);
    let nodes = |[from, to]: [f64; 2]| {
        let step = (to - from) / pieces as f64;
        let mut nodes = Vec::new();
        for piece in 0..pieces {
            for (x, w) in &rule {
                nodes.push((from + (piece as f64 + x) * step, w * step));
            }
        }
        nodes
    };
    let mut sum = [0.0; C];
    let azimuths = nodes(azimuths);
    for (cos, weight) in nodes(cosines) {
        for &(phi, other) in &azimuths {
            let values = f(direction(cos, phi));
            for (sum, value) in sum.iter_mut().zip(values) {
                *sum += value * weight * other;
            }
        }
    }
    sum
}

/// Integral over all directions; the equator, where lobes end, is a border.
pub fn sphere_integral<const C: usize>(pieces: usize, f: impl Fn(Vec3) -> [f64; C]) -> [f64; C] {
    let below = integral([-1.0, 0.0], [0.0, 2.0 * PI], pieces, &f);
    let above = integral([0.0, 1.0], [0.0, 2.0 * PI], pieces, &f);
    std::array::from_fn(|c| below[c] + above[c])
}
