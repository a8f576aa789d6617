//! What the principled materials share, after Burley, "Physically Based Shading at
//! Disney" (2012) and "Extending the Disney BRDF to a BSDF with Integrated Subsurface
//! Scattering" (2015), in Mitsuba's form.

use std::f64::consts::FRAC_1_PI;

use capwalk_math::{Real, Rgb, Vec3};

use super::local::lerp;
use super::microfacets::{Distribution, Microfacets};
use crate::ids::TextureId;
use crate::material::plain::AskedNumbers;

/// Smallest roughness.
const MIN_ALPHA: f64 = 1e-3;

/// Smallest share of a part that is explored.
const LEAST_SHARE: f64 = 0.1;

/// Why sampling rates have no effect.
pub(super) const SAMPLING_RATES: &str =
    "directions are chosen by our own rule; the mean is the same";

/// The share of a part by which it is sampled; some, if how much there is of it may have
/// a derivative (`is_explored`).
#[inline]
pub(super) fn share(amount: f64, is_explored: bool) -> f64 {
    amount.max(if is_explored { LEAST_SHARE } else { 0.0 })
}

/// Facets whose `alpha` is the square of `roughness`, longer along the tangent.
#[inline]
pub(super) fn facets<R: Real>(roughness: R, anisotropic: R) -> Microfacets<R> {
    let aspect = (R::constant(1.0) - R::constant(0.9) * anisotropic).sqrt();
    let at_least = |alpha: R| {
        if alpha.value() < MIN_ALPHA {
            R::constant(MIN_ALPHA)
        } else {
            alpha
        }
    };
    let alpha = roughness.squared();
    Microfacets {
        distribution: Distribution::Ggx,
        alpha_u: at_least(alpha / aspect),
        alpha_v: at_least(alpha * aspect),
    }
}

/// The base colour at luminance one; white for black.
#[inline]
pub(super) fn hue<R: Real>(base_color: Rgb<R>) -> Rgb<R> {
    let luminance = base_color.luminance();
    if luminance.value() > 0.0 {
        base_color / luminance
    } else {
        Rgb::splat(R::constant(1.0))
    }
}

/// The colour, if derivatives are asked for by it, it is black somewhere, and a tint takes its hue.
pub(super) fn hue_of_black(
    numbers: &AskedNumbers,
    base_color: TextureId,
    spec_tint: TextureId,
    [sheen, sheen_tint]: [TextureId; 2],
) -> Option<(&'static str, &'static str)> {
    let colours = (numbers.texture)(base_color);
    let is_black = (0..colours.texels()).any(|i| colours.texel(i) == Rgb::zero());
    let is_tinted = numbers.has(spec_tint) || numbers.has(sheen) && numbers.has(sheen_tint);
    let why = "tints have its hue, and black has none";
    ((numbers.is_asked_for)(base_color) && is_black && is_tinted).then_some(("base_color", why))
}

/// What a tinted interface reflects, by Schlick's approximation.
#[inline]
pub(super) fn tinted_reflectance<R: Real>(base_color: Rgb<R>, cos_h: R, eta: R) -> Rgb<R> {
    let one = R::constant(1.0);
    let normal_incidence = ((eta - one) / (eta + one)).squared();
    schlick(
        hue(base_color) * normal_incidence,
        schlick_weight(cos_h, eta),
    )
}

/// From the reflectance at normal incidence to white at grazing.
#[inline]
pub(super) fn schlick<R: Real>(normal: Rgb<R>, weight: R) -> Rgb<R> {
    normal.map(|normal| lerp(normal, R::constant(1.0), weight))
}

/// How far Schlick's approximation is from normal to grazing incidence, by the
/// cosine on the thinner side.
#[inline]
pub(super) fn schlick_weight<R: Real>(cos: R, eta: R) -> R {
    let one = R::constant(1.0);
    if eta.value() > 1.0 {
        return fifth_power(one - cos);
    }
    let refracted = super::fresnel::cos_refracted(cos, eta);
    fifth_power(one - refracted.unwrap_or(R::constant(0.0)))
}

#[inline]
pub(super) fn fifth_power<R: Real>(x: R) -> R {
    x.squared().squared() * x
}

/// The diffuse base with its retro-reflection and flatness, `f |cos wo|` of a white one.
#[inline]
pub(super) fn base<R: Real>(wi: Vec3<R>, wo: Vec3<R>, cos_h: R, roughness: R, flatness: R) -> R {
    let constant = R::constant;
    let (one, half) = (constant(1.0), constant(0.5));
    let at_i = fifth_power(one - wi.z);
    let at_o = fifth_power(one - wo.z);
    let lambert = (one - half * at_i) * (one - half * at_o);
    let twice_rough = constant(2.0) * roughness * cos_h.squared();
    let retro = twice_rough * (at_o + at_i + at_o * at_i * (twice_rough - one));
    // Below the surface, after Hanrahan and Krueger.
    let grazing = half * twice_rough;
    let below = lerp(one, grazing, at_o) * lerp(one, grazing, at_i);
    let flat = constant(1.25) * (below * (one / (wo.z + wi.z) - half) + half);
    constant(FRAC_1_PI) * lerp(lambert + retro, flat, flatness) * wo.z
}

/// A rim of light as on cloth, `f |cos wo|`, with some of the hue of the base.
#[inline]
pub(super) fn sheen<R: Real>(base_color: Rgb<R>, tint: R, wo: Vec3<R>, cos_h: R) -> Rgb<R> {
    let white = Rgb::splat(R::constant(1.0));
    let hue = white + (hue(base_color) - white) * tint;
    hue * (fifth_power(R::constant(1.0) - cos_h) * wo.z)
}
