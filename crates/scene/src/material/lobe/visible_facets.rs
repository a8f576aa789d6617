//! Means over the facets that are seen from a direction, without noise.

use std::f64::consts::{FRAC_PI_2, PI};

use capwalk_math::Vec3;
use capwalk_math::elementary::{exp, sin_cos};
use capwalk_math::quadrature::gauss_legendre;

use super::microfacets::MIN_ALPHA;
use super::microfacets::{Distribution, Microfacets};

/// Beckmann's slopes are not steeper than this, in units of the roughness: the
/// rest is one in 1e16.
const STEEPEST: f64 = 6.0;

/// Nodes per interval; enough for means to 1e-5.
const NODES: usize = 32;

/// Facets of a rough surface without direction.
///
/// Integrals are over slopes `alpha s` along the view and `alpha t` across it,
/// `m = (-alpha s, -alpha t, 1) / |.|`, in coordinates `a` and `b` with finite
/// ranges. Where total reflection begins the integrand bends like a square
/// root, and where reflection goes along the surface it has a corner. Intervals
/// end there, and their nodes crowd quadratically at the ends, so that a mean
/// is a smooth function of roughness and index.
pub struct VisibleFacets {
    pub microfacets: Microfacets,
    /// Nodes and weights on `[0, 1]`, crowded at both ends.
    rule: Vec<(f64, f64)>,
}

impl VisibleFacets {
    pub fn new(distribution: Distribution, alpha: f64) -> Self {
        let crowded = |(x, w): (f64, f64)| (x * x * (3.0 - 2.0 * x), w * 6.0 * x * (1.0 - x));
        Self {
            microfacets: Microfacets::isotropic(distribution, alpha.max(MIN_ALPHA)),
            rule: gauss_legendre(NODES).into_iter().map(crowded).collect(),
        }
    }

    /// The mean of `f(wi, m)` over the facet normals `m` visible from a
    /// direction `wi` with the given cosine. The far side is denser by `eta`.
    pub fn mean(&self, cos: f64, eta: f64, f: impl Fn(Vec3, Vec3) -> f64) -> f64 {
        let alpha = self.microfacets.alpha_u;
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let wi = Vec3::new(sin, 0.0, cos);
        // Facets steeper than this along the view turn away.
        let hidden = if sin > 0.0 {
            cos / (alpha * sin)
        } else {
            f64::INFINITY
        };
        let mut along_ends = vec![self.along(f64::NEG_INFINITY), self.along(hidden)];
        let [least, most] = [along_ends[0], along_ends[1]];
        // Where, at t = 0, facets reflect along the surface, and where total
        // reflection begins: the integrand bends there.
        let mut bends = roots(alpha * alpha * cos, 2.0 * alpha * sin, -cos);
        let critical2 = 1.0 - eta * eta; // squared cosine
        if critical2 > 0.0 {
            bends.extend(roots(
                (sin * sin - critical2) * alpha * alpha,
                -2.0 * alpha * sin * cos,
                cos * cos - critical2,
            ));
        }
        let bends = bends.into_iter().map(|s| self.along(s));
        along_ends.extend(bends.filter(|a| least < *a && *a < most));
        along_ends.sort_by(f64::total_cmp);
        let mut sum = 0.0;
        for (a, along_weight) in self.nodes(&along_ends) {
            let along = self.place(a);
            let s = along.slope();
            let facing = cos - alpha * s * sin; // wi · m / m.z
            // The same across: 1 + alpha² (s² + t²) where the integrand bends.
            let mut bends = vec![2.0 * facing / cos];
            if critical2 > 0.0 {
                bends.push(facing * facing / critical2);
            }
            let t2 = bends
                .into_iter()
                .map(|bend| (bend - 1.0) / (alpha * alpha) - s * s);
            let last = self.across(s, f64::INFINITY);
            let mut across_ends = vec![0.0, last];
            let bends = t2
                .filter(|t2| *t2 > 0.0)
                .map(|t2| self.across(s, t2.sqrt()));
            across_ends.extend(bends.filter(|b| *b < last));
            across_ends.sort_by(f64::total_cmp);
            for (b, across_weight) in self.nodes(&across_ends) {
                let (m, density) = self.facet(along, self.place(b));
                sum += f(wi, m) * facing * density * along_weight * across_weight;
            }
        }
        // Both signs of t.
        2.0 * sum * self.microfacets.visible_over_cos(wi)
    }

    /// Nodes and weights on the intervals between consecutive ends.
    fn nodes<'a>(&'a self, ends: &'a [f64]) -> impl Iterator<Item = (f64, f64)> + 'a {
        ends.windows(2).flat_map(|ends| {
            let (from, length) = (ends[0], ends[1] - ends[0]);
            let node = move |&(x, w): &(f64, f64)| (from + length * x, w * length);
            self.rule.iter().map(node)
        })
    }

    /// The coordinate `a` of a slope along the view.
    fn along(&self, s: f64) -> f64 {
        match self.microfacets.distribution {
            Distribution::Beckmann => s.clamp(-STEEPEST, STEEPEST),
            Distribution::Ggx => s.atan(),
        }
    }

    /// What is at a coordinate.
    fn place(&self, coordinate: f64) -> Place {
        let [sin, cos] = match self.microfacets.distribution {
            Distribution::Beckmann => [coordinate, 1.0],
            Distribution::Ggx => sin_cos(coordinate).into(),
        };
        Place { sin, cos }
    }

    /// The coordinate `b` of a slope across, where the one along is `s`.
    fn across(&self, s: f64, t: f64) -> f64 {
        match self.microfacets.distribution {
            Distribution::Beckmann => t.min(STEEPEST),
            Distribution::Ggx if t.is_infinite() => FRAC_PI_2,
            Distribution::Ggx => (t / 1.0_f64.hypot(s)).atan(),
        }
    }

    /// The normal of a facet, and the density of slopes per `da db`.
    #[inline(always)]
    fn facet(&self, along: Place, across: Place) -> (Vec3, f64) {
        let alpha = self.microfacets.alpha_u;
        let normal = Vec3::new(
            -alpha * along.sin * across.cos,
            -alpha * across.sin,
            along.cos * across.cos,
        );
        let density = match self.microfacets.distribution {
            Distribution::Beckmann => exp(-along.sin * along.sin - across.sin * across.sin),
            Distribution::Ggx => along.cos * across.cos * across.cos,
        };
        (normal.normalized(), density / PI)
    }
}

/// A coordinate: for GGX its sine and cosine, for Beckmann itself, and 1.
#[derive(Clone, Copy)]
struct Place {
    sin: f64,
    cos: f64,
}

impl Place {
    /// The slope along the view.
    fn slope(self) -> f64 {
        self.sin / self.cos
    }
}

/// The real zeros of `a x² + b x + c`.
fn roots(a: f64, b: f64, c: f64) -> Vec<f64> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return Vec::new();
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    [q / a, c / q]
        .into_iter()
        .filter(|x| x.is_finite())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::lobe::{fresnel_dielectric, local};

    const CASES: [(Distribution, f64); 4] = [
        (Distribution::Beckmann, 0.02),
        (Distribution::Beckmann, 0.4),
        (Distribution::Ggx, 0.05),
        (Distribution::Ggx, 0.5),
    ];

    /// The shadowing is what makes the density of visible normals one.
    #[test]
    fn visible_facets_are_all_facets() {
        for (distribution, alpha) in CASES {
            let facets = VisibleFacets::new(distribution, alpha);
            for cos in [1e-6, 0.02, 0.3, 0.8, 1.0] {
                for eta in [1.5, 0.6] {
                    let all = facets.mean(cos, eta, |_, _| 1.0);
                    assert!(
                        (all - 1.0).abs() < 2e-5,
                        "{distribution:?} {alpha} {cos}: {all}"
                    );
                }
            }
        }
    }

    /// The mean is that of the samples, by a rule of many nodes in their square.
    #[test]
    fn means_are_those_of_samples() {
        let rule = gauss_legendre(128);
        for (distribution, alpha) in CASES {
            let facets = VisibleFacets::new(distribution, alpha);
            for cos in [0.05, 0.4, 0.9] {
                let eta = 0.6;
                let reflected = |wi: Vec3, m: Vec3| {
                    let wo = local::reflected_about(wi, m);
                    let visible = if wo.z > 0.0 {
                        facets.microfacets.visible(wo)
                    } else {
                        0.0
                    };
                    visible * fresnel_dielectric(wi.dot(m), eta) * (1.0 + m.x)
                };
                let mean = facets.mean(cos, eta, reflected);
                let wi = Vec3::new((1.0 - cos * cos).sqrt(), 0.0, cos);
                let mut sum = 0.0;
                for (u, w) in &rule {
                    for (v, other) in &rule {
                        let m = facets.microfacets.sample(wi, [*u, *v]);
                        sum += w * other * reflected(wi, m);
                    }
                }
                // As good as the rule is over the bends.
                let error = (mean - sum).abs();
                assert!(error < 1e-3, "{distribution:?} {alpha} {cos}: {mean} {sum}");
            }
        }
    }
}
