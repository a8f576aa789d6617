//! What clear coats over a diffuse base share.

use capwalk_math::{Real, Rgb};

use super::local;

/// What the base sends up through a coat, per light that gets to it:
/// `diffuse / (1 - what goes round once)`.
#[inline]
pub(super) fn base<R: Real>(diffuse: Rgb<R>, internal_reflectance: R, nonlinear: bool) -> Rgb<R> {
    let one = R::constant(1.0);
    match nonlinear {
        true => diffuse.map(|diffuse| diffuse / (one - diffuse * internal_reflectance)),
        false => diffuse * (one / (one - internal_reflectance)),
    }
}

/// The least of these weights: what is black may have a derivative, so it is sampled a little.
pub const LEAST_WEIGHT: f64 = 0.05;

/// Base and coat are chosen in proportion to these, times what passes the coat and what does not.
#[inline]
pub(super) fn choice_weights(diffuse: Rgb, specular: Rgb) -> [f64; 2] {
    [diffuse, specular].map(|colour| local::mean(colour).max(LEAST_WEIGHT))
}

/// Probability of choosing the base and not the coat, which lets the fraction `transmittance` pass.
#[inline(always)]
pub fn base_probability(transmittance: f64, weights: [f64; 2]) -> f64 {
    let base = transmittance * weights[0];
    let coat = (1.0 - transmittance) * weights[1];
    base / (base + coat)
}
