//! Refraction by clear facets.

use capwalk_math::{Real, Vec3};

use super::fresnel::{cos_refracted, fresnel_dielectric};
use super::microfacets::Microfacets;

/// The unit normal of the facet that refracts `wi` (in front) to `wo` (behind),
/// on the side of `+z`; `None` if only the back of a facet could do it.
#[inline]
pub(super) fn refracting_normal<R: Real>(wi: Vec3<R>, wo: Vec3<R>, eta: R) -> Option<Vec3<R>> {
    let along = wi + wo * eta;
    let length2 = along.length_squared();
    if wo.z.value() >= 0.0 || length2.value() == 0.0 {
        return None;
    }
    let sign = if along.z.value() < 0.0 { -1.0 } else { 1.0 };
    let h = along * (R::constant(sign) / length2.sqrt());
    (wi.dot(h).value() > 0.0 && wo.dot(h).value() < 0.0).then_some(h)
}

/// `f |cos wo|` of refraction by clear facets, for radiance: the `1 / eta²` of
/// its scaling and the `eta²` of Walter's equation (21) cancel.
#[inline]
pub(super) fn transmission<R: Real>(
    microfacets: &Microfacets<R>,
    wi: Vec3<R>,
    wo: Vec3<R>,
    h: Vec3<R>,
    eta: R,
) -> R {
    let (cos_i, cos_o) = (wi.dot(h), wo.dot(h));
    let transmittance = R::constant(1.0) - fresnel_dielectric(cos_i, eta);
    let facets =
        microfacets.density(h) * microfacets.visible_over_cos(wi) * microfacets.visible(wo);
    let refracted = transmittance * facets * cos_i * cos_o / (cos_i + eta * cos_o).squared();
    -refracted * upright_fade(h.z)
}

/// From zero for facets that stand upright to one for all but the last half degree.
///
/// GGX has such facets, and the model ends with them: refraction would be
/// discontinuous along a circle that moves with `wi`, which no derivative of the integrand
/// sees (it would miss 5 % at a roughness of 0.6). Faded, it is continuous; the
/// light that is lost is 0.05 % for a roughness of 0.3, at most 0.3 % for 0.9.
#[inline]
fn upright_fade<R: Real>(cos_m: R) -> R {
    const WIDTH: f64 = 0.01;
    if cos_m.value() >= WIDTH {
        return R::constant(1.0);
    }
    let x = cos_m * R::constant(1.0 / WIDTH);
    x.squared() * (R::constant(3.0) - R::constant(2.0) * x)
}

/// Density of directions `wo` per solid angle if visible normals refract.
#[inline]
pub(super) fn transmission_pdf(
    microfacets: &Microfacets,
    wi: Vec3,
    wo: Vec3,
    h: Vec3,
    eta: f64,
) -> f64 {
    let (cos_i, cos_o) = (wi.dot(h), wo.dot(h));
    microfacets.pdf(wi, h) * eta.squared() * cos_o.abs() / (cos_i + eta * cos_o).squared()
}

/// Where a facet with the normal `m` refracts `wi`; `None` if it reflects all.
#[inline]
pub(super) fn refracted_about(wi: Vec3, m: Vec3, eta: f64) -> Option<Vec3> {
    let cos_i = wi.dot(m);
    let cos_t = cos_refracted(cos_i, eta)?;
    Some(m * (cos_i / eta - cos_t) - wi / eta)
}
