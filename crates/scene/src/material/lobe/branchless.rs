//! Microfacets and what reflects by them without a branch, but for [`stretched_normal`]: in a loop over
//! several, the compiler computes as many at a time as registers hold. For one alone,
//! [`Microfacets`]' own functions are faster.

use std::f64::consts::FRAC_1_PI;

use capwalk_math::Vec3;
use capwalk_math::elementary::{erf_and_gaussian, exp};

pub use super::coat::base_probability;
pub use super::microfacets::Stretched;
use super::microfacets::{
    Distribution, Microfacets, Mirrored, SHADOWLESS, beckmann_normal, ggx_normal,
};

/// [`Microfacets::visible_over_cos`].
#[inline(always)]
pub fn visible_over_cos(facets: &Microfacets, w: Vec3) -> f64 {
    let (alpha_u, alpha_v) = facets.alphas();
    let z = w.z.abs();
    let [x, y] = [alpha_u * w.x, alpha_v * w.y];
    let (z2, spread2) = (z * z, x * x + y * y);
    let length = choose(facets, spread2, z2 + spread2).sqrt();
    let is_shadowless = z2 >= SHADOWLESS * SHADOWLESS * spread2;
    let slope = z / if is_shadowless { 1.0 } else { length };
    let [erf, derivative] = erf_and_gaussian(slope);
    let beckmann = z * (1.0 + erf) + 0.5 * length * derivative;
    let beckmann = if is_shadowless { 2.0 * z } else { beckmann };
    2.0 / choose(facets, beckmann, z + length)
}

/// What facets do, as perfect mirrors, to light between `wi` and `wo`, both in front; `visible` is
/// [`visible_over_cos`] of `wi`.
#[inline(always)]
pub fn mirrored(facets: &Microfacets, wi: Vec3, visible: f64, wo: Vec3) -> Mirrored {
    // The normal halfway is this over its length.
    let sum = wi + wo;
    let squared = sum.length_squared();
    let length = squared.sqrt();
    let (alpha_u, alpha_v) = facets.alphas();
    let area = alpha_u * alpha_v;
    let [x, y, z] = [sum.x * alpha_v, sum.y * alpha_u, sum.z * area];
    let (spread, cos2) = (x * x + y * y, z * z);
    // Both quotients from one division.
    let below = choose(facets, cos2, spread + cos2);
    let product = 1.0 / (below * length);
    let inverse = product * length;
    let falls = area * squared * inverse;
    // Far out, the exponential function is zero.
    let tail = choose(facets, exp(-spread * inverse), 1.0);
    let pdf = 0.25 * FRAC_1_PI * area * tail * (falls * falls) * visible;
    Mirrored {
        cos: wi.dot(sum) * (product * below),
        pdf,
        scattered: pdf * (visible_over_cos(facets, wo) * wo.z),
    }
}

/// A direction in front, stretched until the roughness is one: the first of three steps that do what
/// [`Microfacets::sample`] and a mirror do.
#[inline(always)]
pub fn stretched(facets: &Microfacets, wi: Vec3) -> Stretched {
    facets.stretched(wi)
}

/// A normal of stretched facets, drawn as it is seen, with `x` along the view and not of unit length:
/// the second step. `visible` is [`visible_over_cos`] of the direction.
#[inline(always)]
pub fn stretched_normal(
    distribution: Distribution,
    view: &Stretched,
    visible: f64,
    u: [f64; 2],
) -> Vec3 {
    match distribution {
        Distribution::Beckmann => beckmann_normal(view, visible, u, erf_and_gaussian),
        Distribution::Ggx => ggx_normal(view, u),
    }
}

/// Where a facet sends the direction, whose normal was stretched: the third step.
#[inline(always)]
pub fn mirrored_at(facets: &Microfacets, view: &Stretched, normal: Vec3, wi: Vec3) -> Vec3 {
    let normal = facets.unstretched(view, normal);
    normal * (2.0 * wi.dot(normal) / normal.length_squared()) - wi
}

/// [`fresnel_dielectric`](super::fresnel_dielectric) by the square of the refractive index.
#[inline(always)]
pub fn fresnel_dielectric(cos: f64, eta2: f64) -> f64 {
    let squared = eta2 - (1.0 - cos * cos);
    let refracted = squared.abs().sqrt();
    let (s_sum, p_sum) = (cos + refracted, eta2 * cos + refracted);
    let inverse = 1.0 / (s_sum * p_sum);
    let senkrecht = (cos - refracted) * p_sum * inverse;
    let parallel = (eta2 * cos - refracted) * s_sum * inverse;
    let reflected = 0.5 * (senkrecht * senkrecht + parallel * parallel);
    // Total reflection.
    if squared <= 0.0 { 1.0 } else { reflected }
}

/// [`fresnel_conductor`](super::fresnel_conductor) of several channels.
#[inline(always)]
pub fn fresnel_conductor<const N: usize>(cos: f64, eta: &[f64; N], k: &[f64; N]) -> [f64; N] {
    let cos2 = cos * cos;
    let sin2 = 1.0 - cos2;
    let mut reflected = [0.0; N];
    for channel in 0..N {
        let (eta, k) = (eta[channel], k[channel]);
        let (real, product) = (eta * eta - k * k - sin2, eta * k);
        let modulus = (real * real + 4.0 * (product * product)).sqrt();
        let root = (0.5 * (modulus + real.abs())).sqrt();
        let is_metal = real < 0.0;
        let a = if is_metal { product } else { root };
        let scale = if is_metal { root } else { 1.0 };
        let s = 2.0 * a * cos;
        let s_sum = (modulus + cos2) * scale;
        let p_sum = (modulus * cos2 + sin2 * sin2) * scale;
        let quotient = (s_sum - s) * p_sum / ((s_sum + s) * (p_sum + s * sin2));
        // At the critical angle, and for an index of zero, all is reflected.
        reflected[channel] = if modulus == 0.0 { 1.0 } else { quotient };
    }
    reflected
}

/// That of the distribution of the two.
#[inline(always)]
fn choose(facets: &Microfacets, beckmann: f64, ggx: f64) -> f64 {
    match facets.distribution {
        Distribution::Beckmann => beckmann,
        Distribution::Ggx => ggx,
    }
}

#[cfg(test)]
mod tests {
    use capwalk_math::Rgb;

    use super::*;

    /// Both are the functions with branches, over all directions in front and roughnesses, down to
    /// the smallest.
    #[test]
    fn they_are_those_with_branches() {
        let direction = |i: u64, k: f64| {
            let [u, v] = [k, 2.3 * k].map(|k| (i as f64 * k).fract());
            let cos: f64 = if i.is_multiple_of(5) { 1e-3 * u } else { u };
            let sin = (1.0 - cos * cos).sqrt();
            Vec3::new(sin * (7.0 * v).cos(), sin * (7.0 * v).sin(), cos)
        };
        for distribution in [Distribution::Beckmann, Distribution::Ggx] {
            for (alpha_u, alpha_v) in [(0.3, 0.3), (0.05, 0.8), (1e-5, 0.01), (1.5, 1.5)] {
                let facets = Microfacets {
                    distribution,
                    alpha_u,
                    alpha_v,
                };
                for i in 1..20_000 {
                    let (wi, wo) = (direction(i, 0.618_034), direction(i, 0.414_214));
                    let visible = visible_over_cos(&facets, wi);
                    let expected = facets.visible_over_cos(wi);
                    assert!((visible / expected - 1.0).abs() < 1e-13, "{wi:?}");
                    let found = mirrored(&facets, wi, visible, wo);
                    let expected = facets.mirrored(wi, wo);
                    for (found, expected) in [
                        (found.cos, expected.cos),
                        (found.pdf, expected.pdf),
                        (found.scattered, expected.scattered),
                    ] {
                        let error = (found - expected).abs();
                        // The exponent has an error of its own size.
                        let most = 1e-12 * expected.abs() + 1e-250;
                        assert!(error <= most, "{wi:?} {wo:?}: {found:e} {expected:e}");
                    }
                }
            }
        }
    }

    #[test]
    fn fresnels_equations_are_those_with_branches() {
        for i in 0..=1000 {
            let cos = f64::from(i) * 1e-3;
            for eta in [0.4, 0.7, 1.0, 1.0001, 1.5, 3.0] {
                let found = fresnel_dielectric(cos, eta * eta);
                let expected = super::super::fresnel_dielectric(cos, eta);
                assert!((found - expected).abs() < 1e-15, "{eta} {cos}: {found:e}");
            }
            for (eta, k) in [(0.2, 3.9), (1.5, 0.0), (0.6, 0.0), (0.0, 1.0), (0.0, 0.0)] {
                let (etas, ks) = ([eta, 2.0 * eta], [k, 0.5 * k]);
                let found = fresnel_conductor(cos, &etas, &ks);
                for ((found, eta), k) in found.into_iter().zip(etas).zip(ks) {
                    let [eta, k] = [eta, k].map(Rgb::splat);
                    let expected = super::super::fresnel_conductor(cos, eta, k).r;
                    assert!(
                        (found - expected).abs() < 1e-15,
                        "{eta:?} {k:?} {cos}: {found:e}"
                    );
                }
            }
        }
    }
}
