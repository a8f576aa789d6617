//! The weighted mean that earlier work makes velocity fields of, from a few
//! auxiliary rays: Eqs. (7) and (8), in directions and on surfaces.
//!
//! ```text
//! v(p) = ∫ w(z; p) V(z) dz / ∫ w(z; p) dz
//! w(z; p) = 1 / (D(z; p) + B(z))^γ
//! ```
//!
//! Both integrals are estimated with the same few rays: the ratio is biased, and
//! consistent as their number grows.

use capwalk_boundary::Stream;
use capwalk_math::Vec3;

use super::was_settings::WasSettings;

/// `γ`, how fast weights fall off. As printed, with 1, the integral of `w` is finite
/// around a silhouette, and the field does not become the silhouette's there.
const EXPONENT: i32 = 3;
/// Points are drawn where the density is above this part of its maximum.
const LEAST_DENSITY: f64 = 1e-6;
/// `D + B` below this counts as this: zero only if a ray is drawn in the very
/// direction of an edge, and the cube of its inverse is finite.
const LEAST_DENOMINATOR: f64 = 1e-12;
/// Probability of another doubling in the debiased estimator: between 1/4, where
/// its variance would be infinite for bounded weights, and 1/2, where its cost
/// would be.
const DOUBLING: f64 = 0.4;
/// Most doublings. The bias of so many rays, 2^12 times as many, is left.
const MAX_DOUBLINGS: u32 = 12;

/// What the velocity of one ray's hit does to the mean.
#[derive(Clone, Copy)]
pub struct Share {
    /// Its weight in the velocity.
    pub weight: f64,
    /// The covector on it in the divergence.
    pub divergence: Vec3,
}

impl Share {
    /// No share.
    pub fn none() -> Self {
        Self {
            weight: 0.0,
            divergence: Vec3::zero(),
        }
    }
}

/// Rays in batches, and what each does to the mean: of one batch, or, with
/// roulette, of as many as make its expectation that of very many. `draw` adds the
/// batch of the given number, `weight` is that of a ray and its gradient, and
/// `curvature` is the covector on the mean in the divergence.
pub fn shares<A>(
    settings: &WasSettings,
    numbers: &Stream,
    mut draw: impl FnMut(u32, &mut Vec<A>),
    weight: impl Fn(&A) -> (f64, Vec3),
    curvature: Vec3,
) -> (Vec<A>, Vec<Share>) {
    let ratio = |rays: &[A], factor: f64, shares: &mut [Share]| {
        let weights: Vec<_> = rays.iter().map(&weight).collect();
        add_ratio(&weights, curvature, factor, shares);
    };
    let mut rays = Vec::with_capacity(settings.rays as usize);
    let mut drawn = 0;
    let mut draw_next = |rays: &mut Vec<A>| {
        draw(drawn, rays);
        drawn += 1;
    };
    draw_next(&mut rays);
    let mut shares = vec![Share::none(); rays.len()];
    ratio(&rays, 1.0, &mut shares);
    if settings.debias {
        // A telescoping sum over estimates with twice as many rays each (McLeish
        // 2011), cut by roulette. What is added is compared with the mean of
        // both halves, which makes it small (Blanchet and Glynn 2015).
        let mut probability = 1.0;
        for level in 0..MAX_DOUBLINGS {
            if numbers.number(level) >= DOUBLING {
                break;
            }
            probability *= DOUBLING;
            let half = rays.len();
            while rays.len() < 2 * half {
                draw_next(&mut rays);
            }
            shares.resize(rays.len(), Share::none());
            let factor = 1.0 / probability;
            ratio(&rays, factor, &mut shares);
            for part in [0..half, half..2 * half] {
                ratio(&rays[part.clone()], -0.5 * factor, &mut shares[part]);
            }
        }
    }
    (rays, shares)
}

/// The random numbers of each ray of a batch, and whether it is the opposite of the
/// one before it.
pub fn ray_numbers<'a>(
    settings: &'a WasSettings,
    numbers: &'a Stream,
    batch: u32,
) -> impl Iterator<Item = ([f64; 2], bool)> + 'a {
    let first = MAX_DOUBLINGS + 2 * batch * settings.rays;
    (0..settings.rays).map(move |i| {
        let mirrored = settings.antithetic && i % 2 == 1;
        (
            numbers.pair(first + 2 * (i - u32::from(mirrored))),
            mirrored,
        )
    })
}

/// The density, over its maximum, with which a point is drawn: uniform above
/// [`LEAST_DENSITY`], as that of a normal distribution in the plane is.
pub fn relative_density(u: f64) -> f64 {
    (1.0 - u).max(LEAST_DENSITY)
}

/// `w` over the density of a point, Eq. (8), and its gradient, from those of `D`.
/// Neither the density is differentiated nor `B`, which does not depend on `p`.
pub fn weight(
    inverse_density: f64,
    (distance, distance_gradient): (f64, Vec3),
    boundary: f64,
) -> (f64, Vec3) {
    let denominator = (distance + boundary).max(LEAST_DENOMINATOR);
    let weight = inverse_density / denominator.powi(EXPONENT);
    let derivative = -f64::from(EXPONENT) * weight / denominator;
    (weight, distance_gradient * derivative)
}

/// Adds `factor` times the ratio estimate of Eq. (7). With `W = Σ w_i` the divergence
/// of the mean is, up to the curvature of the space,
///
/// ```text
/// Σ_i V_i · [ ∇w_i - (w_i / W) Σ_j ∇w_j ] / W
/// ```
pub fn add_ratio(weights: &[(f64, Vec3)], curvature: Vec3, factor: f64, shares: &mut [Share]) {
    let start = (0.0, Vec3::zero());
    let (sum, gradient_sum) = weights.iter().fold(start, |a, b| (a.0 + b.0, a.1 + b.1));
    let mean_gradient = gradient_sum / sum;
    for (&(weight, gradient), share) in weights.iter().zip(shares) {
        let part = weight / sum * factor;
        share.weight += part;
        share.divergence += gradient * (factor / sum) + (curvature - mean_gradient) * part;
    }
}

/// `B` by the next edge of a triangle: the distance to it as if the triangle were
/// equilateral, one in its middle (Mitsuba 3.4).
pub fn edge_test(corner_weights: [f64; 3]) -> f64 {
    3.0 * corner_weights.into_iter().fold(1.0, f64::min).abs()
}
