//! Distributions of microfacet normals, after Walter et al., "Microfacet Models
//! for Refraction through Rough Surfaces" (2007), anisotropic.
//!
//! Sampling is of visible normals: Heitz and d'Eon, "Importance Sampling
//! Microfacet-Based BSDFs using the Distribution of Visible Normals" (2014),
//! and Heitz, "Sampling the GGX Distribution of Visible Normals" (2018).

use std::f64::consts::PI;

use capwalk_math::elementary::sin_cos;
use capwalk_math::special::{erf_and_derivative, erf_inverse};
use capwalk_math::{Real, Vec3};
use serde::{Deserialize, Serialize};

/// Smallest roughness, as in Mitsuba; below, the lobe is too narrow for the
/// digits of a direction.
pub const MIN_ALPHA: f64 = 1e-4;

/// Where `erf(a)` is one to the last digit and `exp(-a²)` is below it.
pub const SHADOWLESS: f64 = 6.0;

/// The shape of the distribution of slopes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Distribution {
    /// Gaussian slopes.
    Beckmann,
    /// Trowbridge and Reitz: long tails.
    Ggx,
}

impl Distribution {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Beckmann, Self::Ggx];

    /// What scene files call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Beckmann => "beckmann",
            Self::Ggx => "ggx",
        }
    }
}

/// A rough surface: how the normals of its facets are distributed. The two
/// roughnesses are root mean square slopes times √2, along x and y of the
/// shading frame; values below 1e-4 count as 1e-4.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Microfacets<R = f64> {
    /// The shape.
    pub distribution: Distribution,
    /// Roughness along the tangent.
    pub alpha_u: R,
    /// Roughness along the bitangent.
    pub alpha_v: R,
}

/// What facets that are perfect mirrors do to light between two directions in front of them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mirrored {
    /// The cosine between one of them and the normal halfway.
    pub cos: f64,
    /// The density of the other one per solid angle, if visible normals reflect the first.
    pub pdf: f64,
    /// `f |cos|` of the other one.
    pub scattered: f64,
}

/// A direction in front of facets that were stretched until their roughness is one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stretched {
    /// Sine of its angle to the axis.
    pub sin: f64,
    /// Cosine of its angle to the axis.
    pub cos: f64,
    /// Sine of its angle around the axis.
    pub sin_phi: f64,
    /// Cosine of its angle around the axis.
    pub cos_phi: f64,
    /// What became of the length of a unit vector.
    pub length: f64,
}

impl<R: Copy> Microfacets<R> {
    /// The same roughness in all directions.
    pub fn isotropic(distribution: Distribution, alpha: R) -> Self {
        Self {
            distribution,
            alpha_u: alpha,
            alpha_v: alpha,
        }
    }
}

impl<R: Real> Microfacets<R> {
    /// The roughnesses, where they are not too small.
    #[inline(always)]
    pub(super) fn alphas(&self) -> (R, R) {
        let at_least = |alpha: R| {
            if alpha.value() < MIN_ALPHA {
                R::constant(MIN_ALPHA)
            } else {
                alpha
            }
        };
        (at_least(self.alpha_u), at_least(self.alpha_v))
    }

    /// The product of the roughnesses.
    #[inline]
    pub(super) fn alpha2(&self) -> R {
        let (alpha_u, alpha_v) = self.alphas();
        alpha_u * alpha_v
    }

    /// Density of normals `m` per solid angle and area of the surface:
    /// `∫ density(m) m.z dm = 1`. Zero for normals that point down.
    #[inline]
    pub fn density(&self, m: Vec3<R>) -> R {
        if m.z.value() <= 0.0 {
            return R::constant(0.0);
        }
        let (alpha_u, alpha_v) = self.alphas();
        let scale = R::constant(PI) * alpha_u * alpha_v;
        let spread = (m.x / alpha_u).squared() + (m.y / alpha_v).squared();
        let cos2 = m.z.squared();
        match self.distribution {
            Distribution::Beckmann => {
                let exponent = spread / cos2;
                // Beyond, `exp` is zero and its slopes are zero times infinity.
                const LARGEST_EXPONENT: f64 = 600.0;
                if exponent.value() > LARGEST_EXPONENT {
                    return R::constant(0.0);
                }
                (-exponent).exp() / (scale * cos2.squared())
            }
            Distribution::Ggx => R::constant(1.0) / (scale * (spread + cos2).squared()),
        }
    }

    /// Fraction of the facets turned to `w` that are not hidden from it, over
    /// `|w.z|`, after Smith. Finite at grazing angles, where the fraction
    /// itself vanishes.
    ///
    /// For Beckmann this is Smith's integral itself; Mitsuba evaluates a fit to
    /// it that is off by up to 0.35 % and is discontinuous.
    #[inline]
    pub fn visible_over_cos(&self, w: Vec3<R>) -> R {
        let (alpha_u, alpha_v) = self.alphas();
        let z = w.z.abs();
        let spread2 = (alpha_u * w.x).squared() + (alpha_v * w.y).squared();
        let one = R::constant(1.0);
        let two = R::constant(2.0);
        match self.distribution {
            Distribution::Beckmann => {
                if z.value().squared() >= SHADOWLESS * SHADOWLESS * spread2.value() {
                    return one / z;
                }
                let spread = spread2.sqrt();
                let [erf, derivative] = (z / spread).erf_and_derivative();
                let hidden = R::constant(0.5) * spread * derivative;
                two / (z * (one + erf) + hidden)
            }
            Distribution::Ggx => two / (z + (z.squared() + spread2).sqrt()),
        }
    }

    /// Fraction of the facets turned to `w` that are not hidden from it.
    #[inline]
    pub fn visible(&self, w: Vec3<R>) -> R {
        self.visible_over_cos(w) * w.z.abs()
    }

    /// Scattering of perfect mirrors as facets: `f |cos wo|` for `wi` and `wo`
    /// in front and the unit vector `h` halfway between them.
    #[inline]
    pub(super) fn reflection(&self, wi: Vec3<R>, wo: Vec3<R>, h: Vec3<R>) -> R {
        self.density(h) * self.visible_over_cos(wi) * self.visible(wo) * R::constant(0.25)
    }
}

impl Microfacets {
    /// Draws a normal as seen from `wi`, which is in front (`wi.z >= 0`).
    pub fn sample(&self, wi: Vec3, u: [f64; 2]) -> Vec3 {
        let view = self.stretched(wi);
        let normal = match self.distribution {
            Distribution::Beckmann => {
                let visible = self.visible_over_cos(wi);
                beckmann_normal(&view, visible, u, erf_and_derivative)
            }
            Distribution::Ggx => ggx_normal(&view, u),
        };
        self.unstretched(&view, normal).normalized()
    }

    /// A direction, stretched until the roughness is one.
    #[inline(always)]
    pub(super) fn stretched(&self, wi: Vec3) -> Stretched {
        let (alpha_u, alpha_v) = self.alphas();
        let longer = Vec3::new(alpha_u * wi.x, alpha_v * wi.y, wi.z);
        let length = longer.length();
        let stretched = longer * (1.0 / length);
        let sin = (stretched.x * stretched.x + stretched.y * stretched.y).sqrt();
        let is_upright = sin <= 0.0;
        let inverse = 1.0 / if is_upright { 1.0 } else { sin };
        Stretched {
            sin,
            cos: stretched.z,
            sin_phi: stretched.y * inverse,
            cos_phi: if is_upright {
                1.0
            } else {
                stretched.x * inverse
            },
            length,
        }
    }

    /// A normal of facets of roughness one, which has `x` along the view, not of unit length.
    #[inline(always)]
    pub(super) fn unstretched(&self, view: &Stretched, normal: Vec3) -> Vec3 {
        let (alpha_u, alpha_v) = self.alphas();
        let Stretched {
            sin_phi, cos_phi, ..
        } = *view;
        Vec3::new(
            (cos_phi * normal.x - sin_phi * normal.y) * alpha_u,
            (sin_phi * normal.x + cos_phi * normal.y) * alpha_v,
            normal.z,
        )
    }

    /// Density of [`Microfacets::sample`] per solid angle of normals.
    #[inline]
    pub fn pdf(&self, wi: Vec3, m: Vec3) -> f64 {
        self.density(m) * self.visible_over_cos(wi) * wi.dot(m).max(0.0)
    }

    /// What they do, as perfect mirrors, to light between `wi` and `wo`, both in front.
    #[inline]
    pub(super) fn mirrored(&self, wi: Vec3, wo: Vec3) -> Mirrored {
        let h = (wi + wo).normalized();
        let pdf = self.reflection_pdf(wi, h);
        Mirrored {
            cos: wi.dot(h),
            pdf,
            scattered: pdf * self.visible(wo),
        }
    }

    /// Density per solid angle of directions if visible normals reflect `wi`;
    /// `h` is the unit vector halfway.
    #[inline]
    pub(super) fn reflection_pdf(&self, wi: Vec3, h: Vec3) -> f64 {
        0.25 * self.density(h) * self.visible_over_cos(wi)
    }
}

/// A normal (not of unit length, with `x` along the view) of a Beckmann surface of roughness one,
/// drawn as it is seen; `visible` is [`Microfacets::visible_over_cos`] of what was stretched, `erf` the
/// error function and its derivative.
#[inline(always)]
pub(super) fn beckmann_normal(
    view: &Stretched,
    visible: f64,
    u: [f64; 2],
    erf: impl Fn(f64) -> [f64; 2],
) -> Vec3 {
    let Stretched { sin, cos, .. } = *view;
    let visible = visible * view.length;
    // Up to a factor, the probability of a slope of less (the normal of a slope
    // is `(-slope, ., 1)`); it grows up to the slope that hides its facet.
    let steepest = if sin * SHADOWLESS > cos {
        cos / sin
    } else {
        SHADOWLESS
    };
    let target = u[0] * (2.0 / visible);
    // The first guess: seen from above, slopes are Gaussian; seen from aside, their mean is half
    // the tangent of the angle lower. At the steepest slope the density vanishes: keep away.
    let least = -1.0 + f64::EPSILON;
    let gaussian = erf_inverse((-1.0 + target / cos.max(sin)).clamp(least, -least));
    let mean = -0.5 * sin / cos.max(sin);
    // Halley's steps, kept between bounds.
    let (mut low, mut high) = (-SHADOWLESS, steepest);
    let mut slope = (gaussian + mean).clamp(low, 0.5 * high);
    // Halving alone needs fewer steps than this for all digits.
    const MOST_STEPS: usize = 64;
    // Each of these steps is about the cube of the one before: behind one that changes the slope
    // by less than this, what is left of the probability is below 1e-8.
    const LAST_STEP: f64 = 3e-4;
    for _ in 0..MOST_STEPS {
        // This probability, its derivative, the density, and the density's.
        let [below, gaussian] = erf(slope);
        let value = cos * (1.0 + below) + 0.5 * sin * gaussian;
        let density = gaussian * (cos - slope * sin);
        let bend = -2.0 * slope * density - gaussian * sin;
        let error = value - target;
        if error > 0.0 {
            high = slope;
        } else {
            low = slope;
        }
        let mut next = slope - error * density / (density * density - 0.5 * error * bend);
        if !(low..=high).contains(&next) {
            next = 0.5 * (low + high);
        }
        let step = (next - slope).abs();
        slope = next;
        if step < LAST_STEP {
            break;
        }
    }
    // The slope across the view is Gaussian. `u` of exactly zero has no slope.
    let across = erf_inverse((2.0 * u[1] - 1.0).max(-1.0 + f64::EPSILON));
    Vec3::new(-slope, across, 1.0)
}

/// As [`beckmann_normal`] for GGX, whose facets of roughness one are those of a
/// hemisphere: a point of the hemisphere's projection towards the view.
#[inline(always)]
pub(super) fn ggx_normal(view: &Stretched, u: [f64; 2]) -> Vec3 {
    let Stretched { sin, cos, .. } = *view;
    let radius = u[0].sqrt();
    let (sin_phi, cos_phi) = sin_cos(2.0 * PI * u[1]);
    let across = radius * cos_phi;
    // The projection is half a disk and half an ellipse: one disk, pushed up.
    let visible = 0.5 * (1.0 + cos);
    let edge = (1.0 - across * across).max(0.0).sqrt();
    let up = (1.0 - visible) * edge + visible * radius * sin_phi;
    let towards = (1.0 - across * across - up * up).max(0.0).sqrt();
    Vec3::new(
        towards * sin - up * cos,
        across,
        (towards * cos + up * sin).max(0.0),
    )
}
