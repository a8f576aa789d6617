//! Rough metal and rough plastic as plain numbers, for computing many at a time.

use std::sync::Arc;

use capwalk_math::Rgb;

use super::branchless::fresnel_conductor;
use super::microfacets::Microfacets;
use super::rough_transmittance::RoughTransmittance;

/// A [rough metal](super::RoughConductor) or a [rough plastic](super::RoughPlastic), whose facets decide everything but a diffuse base,
/// with its weight. A metal has a base that is black.
#[derive(Clone, Debug, PartialEq)]
pub struct RoughSurface {
    /// The facets.
    pub facets: Microfacets,
    /// Factor on what a coat's facets mirror by Fresnel's equations. For a metal see
    /// [`RoughSurface::metal`].
    pub specular: Rgb,
    /// The coat's refractive index, squared; 1 for a metal.
    pub eta2: f64,
    /// `f` of the base, if all light passed the coat.
    pub base: Rgb,
    /// Base and coat are chosen in proportion to these, times what passes and what does not.
    pub choice_weights: [f64; 2],
    kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    /// The refractive index, real and imaginary part, of three channels and one that fills the
    /// processor's vectors.
    Metal([[f64; 4]; 2]),
    Plastic(Arc<RoughTransmittance>),
}

impl RoughSurface {
    /// A metal.
    pub(super) fn metal_of(facets: Microfacets, specular: Rgb, eta: Rgb, k: Rgb) -> Self {
        Self {
            facets,
            specular,
            eta2: 1.0,
            base: Rgb::zero(),
            choice_weights: [0.0, 1.0],
            kind: Kind::Metal([eta, k].map(|Rgb { r, g, b }| [r, g, b, b])),
        }
    }

    /// A coat, through which the fractions in a table pass.
    pub(super) fn coat_of(
        facets: Microfacets,
        specular: Rgb,
        eta2: f64,
        base: Rgb,
        choice_weights: [f64; 2],
        passes: Arc<RoughTransmittance>,
    ) -> Self {
        Self {
            facets,
            specular,
            eta2,
            base,
            choice_weights,
            kind: Kind::Plastic(passes),
        }
    }

    /// The fraction of light from a direction with the cosine `cos` (0 to 1) that passes the coat;
    /// nothing passes a metal.
    #[inline(always)]
    pub fn passes(&self, cos: f64) -> f64 {
        match &self.kind {
            Kind::Metal(_) => 0.0,
            Kind::Plastic(table) => table.passes(cos),
        }
    }

    /// What a metal's facets reflect of light that is seen under the cosine `cos`; `None` for a coat.
    #[inline(always)]
    pub fn metal(&self, cos: f64) -> Option<Rgb> {
        match &self.kind {
            Kind::Metal([eta, k]) => {
                let [r, g, b, _] = fresnel_conductor(cos, eta, k);
                Some(Rgb::new(r, g, b) * self.specular)
            }
            Kind::Plastic(_) => None,
        }
    }
}
