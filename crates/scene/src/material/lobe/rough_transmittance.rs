//! How much light passes a rough clear surface, as a table.

use std::sync::OnceLock;

use capwalk_math::Real;
use capwalk_math::Vec3;

use super::fresnel::fresnel_dielectric;
use super::local;
use super::microfacets::Distribution;
use super::refraction::refracted_about;
use super::visible_facets::VisibleFacets;

/// Cosines in the table, from 0 to 1, as many as in Mitsuba.
pub const NODES: usize = 64;

/// What a rough dielectric coat does to light on average: the fraction that
/// passes it from outside by the cosine of the direction, and the fraction of
/// diffuse light from inside that it throws back, to 1e-5 (for `eta` below 1,
/// to 1 % of themselves at grazing angles). Both with derivatives by roughness
/// and refractive index, which are computed when they are first asked for.
///
/// Making one takes about 20 ms, and derivatives by each of the two take
/// 40 ms: make it when the material changes, not at every hit.
#[derive(Clone, Debug)]
pub struct RoughTransmittance {
    distribution: Distribution,
    alpha: f64,
    eta: f64,
    numbers: Numbers,
    by_alpha: OnceLock<Numbers>,
    by_eta: OnceLock<Numbers>,
}

impl PartialEq for RoughTransmittance {
    fn eq(&self, other: &Self) -> bool {
        self.is_for(other.distribution, other.alpha, other.eta)
    }
}

/// The numbers of a table, or their derivatives.
#[derive(Clone, Debug)]
struct Numbers {
    transmittance: [f64; NODES],
    internal_reflectance: f64,
}

impl Numbers {
    fn new(distribution: Distribution, alpha: f64, eta: f64) -> Self {
        let facets = VisibleFacets::new(distribution, alpha);
        Self {
            transmittance: transmittance(&facets, eta),
            internal_reflectance: internal_reflectance(&facets, eta),
        }
    }

    /// Their derivatives at `x`, which stands for roughness or index.
    fn derivatives(at: impl Fn(f64) -> Self, x: f64, step: f64) -> Self {
        let [above, below] = [at(x + step), at(x - step)];
        let slope = |above: f64, below: f64| (above - below) / (2.0 * step);
        Self {
            transmittance: std::array::from_fn(|node| {
                slope(above.transmittance[node], below.transmittance[node])
            }),
            internal_reflectance: slope(above.internal_reflectance, below.internal_reflectance),
        }
    }
}

/// The step of differences for derivatives: a share of the roughness, and of the index's distance
/// from 1. Their error is of the order of its square.
const STEP: f64 = 1e-3;

impl RoughTransmittance {
    /// The table for a coat of the given roughness, whose refractive index
    /// relative to the outside is `eta`, not 1.
    pub fn new(distribution: Distribution, alpha: f64, eta: f64) -> Self {
        Self {
            distribution,
            alpha,
            eta,
            numbers: Numbers::new(distribution, alpha, eta),
            by_alpha: OnceLock::new(),
            by_eta: OnceLock::new(),
        }
    }

    fn by_alpha(&self) -> &Numbers {
        self.by_alpha.get_or_init(|| {
            let at = |alpha| Numbers::new(self.distribution, alpha, self.eta);
            Numbers::derivatives(at, self.alpha, STEP * self.alpha)
        })
    }

    fn by_eta(&self) -> &Numbers {
        self.by_eta.get_or_init(|| {
            let at = |eta| Numbers::new(self.distribution, self.alpha, eta);
            Numbers::derivatives(at, self.eta, STEP * (self.eta - 1.0))
        })
    }

    /// True if it was made for these numbers.
    pub fn is_for(&self, distribution: Distribution, alpha: f64, eta: f64) -> bool {
        (self.distribution, self.alpha, self.eta) == (distribution, alpha, eta)
    }

    /// The fraction that passes from outside, at cosines from 0 to 1 in equal steps.
    pub fn nodes(&self) -> impl Iterator<Item = f64> {
        self.numbers.transmittance.iter().copied()
    }

    /// The roughness that it was made for.
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// The refractive index that it was made for.
    pub fn eta(&self) -> f64 {
        self.eta
    }

    /// Fraction of light from the direction with the cosine `cos` (0 to 1) that
    /// passes, linear between the nodes of the table. `alpha` and `eta` carry
    /// derivatives; their values are those that the table was made for, or close to them.
    #[inline]
    pub fn transmittance<R: Real>(&self, cos: R, alpha: R, eta: R) -> R {
        let place = cos * R::constant((NODES - 1) as f64);
        let index = (place.value() as usize).min(NODES - 2);
        let [below, above] = [index, index + 1]
            .map(|node| self.number(|numbers| numbers.transmittance[node], alpha, eta));
        local::lerp(below, above, place - R::constant(index as f64))
    }

    /// [`RoughTransmittance::transmittance`] without derivatives.
    #[inline(always)]
    pub fn passes(&self, cos: f64) -> f64 {
        let place = cos * (NODES - 1) as f64;
        let index = (place as usize).min(NODES - 2);
        let [below, above] = [index, index + 1].map(|node| self.numbers.transmittance[node]);
        local::lerp(below, above, place - index as f64)
    }

    /// Fraction of diffuse light from inside that does not get out.
    #[inline]
    pub fn internal_reflectance<R: Real>(&self, alpha: R, eta: R) -> R {
        self.number(|numbers| numbers.internal_reflectance, alpha, eta)
    }

    /// One of the numbers, to first order around those that the table was made for.
    #[inline]
    fn number<R: Real>(&self, of: impl Fn(&Numbers) -> f64, alpha: R, eta: R) -> R {
        let change = |by: R, made_for: f64, slopes: fn(&Self) -> &Numbers| match by.is_constant()
            && by.value() == made_for
        {
            true => R::constant(0.0),
            false => (by - R::constant(made_for)) * R::constant(of(slopes(self))),
        };
        R::constant(of(&self.numbers))
            + change(alpha, self.alpha, Self::by_alpha)
            + change(eta, self.eta, Self::by_eta)
    }
}

/// Cosine of a node; Mitsuba keeps off the horizon by as much.
fn cosine(node: usize) -> f64 {
    (node as f64 / (NODES - 1) as f64).max(1e-6)
}

/// Fraction of light that passes from outside, for each node.
fn transmittance(facets: &VisibleFacets, eta: f64) -> [f64; NODES] {
    std::array::from_fn(|node| {
        facets.mean(cosine(node), eta, |wi, m| {
            let passes = 1.0 - fresnel_dielectric(wi.dot(m), eta);
            let wo = refracted_about(wi, m, eta).filter(|wo| wo.z < 0.0);
            wo.map_or(0.0, |wo| passes * facets.microfacets.visible(wo))
        })
    })
}

/// Fraction of diffuse light from inside that is thrown back: the mean over
/// nodes, weighted with twice their cosines, as Mitsuba takes it.
fn internal_reflectance(facets: &VisibleFacets, eta: f64) -> f64 {
    let inwards = 1.0 / eta;
    let reflectance = |wi: Vec3, m: Vec3| {
        let wo = local::reflected_about(wi, m);
        if wo.z <= 0.0 {
            return 0.0;
        }
        fresnel_dielectric(wi.dot(m), inwards) * facets.microfacets.visible(wo)
    };
    let sum: f64 = (0..NODES)
        .map(cosine)
        .map(|cos| cos * facets.mean(cos, inwards, reflectance))
        .sum();
    2.0 * sum / NODES as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::lobe::fresnel_diffuse;
    use capwalk_math::Dual;

    /// What passes smooth glass is known.
    #[test]
    fn smooth_coats_follow_fresnel() {
        for distribution in [Distribution::Beckmann, Distribution::Ggx] {
            let table = RoughTransmittance::new(distribution, 1e-3, 1.5);
            for node in [6, 20, 40, 63] {
                let cos = cosine(node);
                let passes = table.transmittance(cos, 1e-3, 1.5);
                let known = 1.0 - fresnel_dielectric(cos, 1.5);
                assert!((passes - known).abs() < 3e-4, "{cos}: {passes} {known}");
            }
            // Mitsuba's mean over nodes is not quite the integral.
            let back = table.internal_reflectance(1e-3, 1.5);
            let known = fresnel_diffuse(1.0 / 1.5);
            assert!((back - known).abs() < 0.01, "{back} {known}");
        }
    }

    /// The derivatives are those of the table's numbers, by tables of other
    /// roughness and index.
    #[test]
    fn tables_know_their_derivatives() {
        let table = |alpha: f64, eta: f64| RoughTransmittance::new(Distribution::Ggx, alpha, eta);
        let (alpha, eta) = (0.3, 1.6);
        let middle = table(alpha, eta);
        let read = |table: &RoughTransmittance, cos: f64| {
            let (alpha, eta) = (table.alpha(), table.eta());
            [
                table.transmittance(cos, alpha, eta),
                table.internal_reflectance(alpha, eta),
            ]
        };
        const STEP: f64 = 3e-4;
        let by_alpha = [table(alpha + STEP, eta), table(alpha - STEP, eta)];
        let by_eta = [table(alpha, eta + STEP), table(alpha, eta - STEP)];
        for cos in [0.0, 0.013, 0.33, 0.9, 1.0] {
            let [cos_r, alpha_r, eta_r] = [
                Dual::<2>::constant(cos),
                Dual::variable(alpha, 0),
                Dual::variable(eta, 1),
            ];
            let duals = [
                middle.transmittance(cos_r, alpha_r, eta_r),
                middle.internal_reflectance(alpha_r, eta_r),
            ];
            for (i, dual) in duals.into_iter().enumerate() {
                assert_eq!(dual.value, read(&middle, cos)[i]);
                for (tangent, [above, below]) in dual.tangent.into_iter().zip([&by_alpha, &by_eta])
                {
                    let difference = (read(above, cos)[i] - read(below, cos)[i]) / (2.0 * STEP);
                    let error = (tangent - difference).abs();
                    assert!(error < 1e-4, "{cos}, number {i}: {tangent} {difference}");
                }
            }
        }
        // Between nodes it is linear.
        let derivative = middle.transmittance(
            Dual::<1>::variable(0.4, 0),
            Dual::constant(alpha),
            Dual::constant(eta),
        );
        let [above, below] = [0.401, 0.399].map(|cos| read(&middle, cos)[0]);
        assert!((derivative.tangent[0] - (above - below) / 0.002).abs() < 1e-9);
    }
}
