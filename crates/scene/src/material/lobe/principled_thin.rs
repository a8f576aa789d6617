//! The principled material of a sheet: of paper, leaves, cloth.

use std::f64::consts::FRAC_1_PI;

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::burley::{self, share};
use super::event::Drawn;
use super::fresnel::fresnel_dielectric;
use super::local;
use super::local::{lerp, mirrored, raised};
use super::microfacets::Microfacets;
use crate::ids::TextureId;
use crate::material::fields::{WithoutEffect, fields};
use crate::material::number::{Circumstances, Derived, Number};
use crate::material::plain::{Anisotropy, AskedNumbers, InScene, Plain, Samples, Scatters};

/// Diffuse reflection and transmission, sheen, and clear facets, blended; the same seen from
/// both sides. All numbers but `eta` and `diff_trans` are from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PrincipledThin<N: Number = f64> {
    /// The colour of the base, and of what passes the facets.
    pub base_color: N::Colour,
    /// How rough reflection and transmission are.
    pub roughness: N,
    /// How much longer highlights are along the tangent.
    pub anisotropic: N,
    /// How much of it is facets.
    pub spec_trans: N,
    /// Refractive index relative to the outside.
    pub eta: N,
    /// How much reflection takes the hue of the base.
    pub spec_tint: N,
    /// A rim of light as on cloth.
    pub sheen: N,
    /// How much the sheen takes the hue of the base.
    pub sheen_tint: N,
    /// How much the base looks as if light went through below the surface.
    pub flatness: N,
    /// Twice the part of the diffuse light that is transmitted.
    pub diff_trans: N,
    /// What is sampled even where there is none of it.
    pub explored: N::Derived<ExploredThin>,
}

fields! {
    PrincipledThin {
        base_color: colour(Reflectance, 0.5),
        roughness: number(Fraction, 0.5),
        anisotropic: number(Fraction, 0.0),
        spec_trans: number(Fraction, 0.0),
        eta: number(RefractiveIndex { bends: false }, 1.5),
        spec_tint: number(Fraction, 0.0),
        sheen: number(Fraction, 0.0),
        sheen_tint: number(Fraction, 0.0),
        flatness: number(Fraction, 0.0),
        diff_trans: number(TwiceFraction, 0.0),
        ; explored: ExploredThin
    }
}

impl<N: Number> Plain for PrincipledThin<N> {
    const PLUGIN: &'static str = "principledthin";
    const WITHOUT_EFFECT: WithoutEffect = WithoutEffect {
        names: &[
            "specular_reflectance_sampling_rate",
            "specular_transmittance_sampling_rate",
            "diffuse_transmittance_sampling_rate",
            "diffuse_reflectance_sampling_rate",
        ],
        reason: burley::SAMPLING_RATES,
    };
    const IS_TWO_SIDED: bool = true;
}

impl InScene for PrincipledThin<TextureId> {
    fn anisotropy(&self) -> Anisotropy {
        Anisotropy::By(self.anisotropic)
    }

    fn infinite_derivative(&self, numbers: &AskedNumbers) -> Option<(&'static str, &'static str)> {
        let sheen = [self.sheen, self.sheen_tint];
        burley::hue_of_black(numbers, self.base_color, self.spec_tint, sheen)
    }
}

impl Derived for ExploredThin {
    type Of<N: Number> = PrincipledThin<N>;

    #[inline]
    fn find(thin: &PrincipledThin<TextureId>, at: &impl Circumstances) -> Self {
        Self {
            facets: at.may_change(thin.spec_trans),
            transmission: at.may_change(thin.diff_trans),
        }
    }
}

/// Parts of a [`PrincipledThin`] that are sampled even where there are none of them: how
/// much there is may have a derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExploredThin {
    /// Facets beside the diffuse base, and the base beside the facets.
    pub facets: bool,
    /// Diffuse transmission beside reflection, and the other way round.
    pub transmission: bool,
}

/// Directions with `wi` in front: a sheet is the same from both sides.
#[inline]
fn turned<R: Real>(wi: Vec3<R>, wo: Vec3<R>) -> (Vec3<R>, Vec3<R>) {
    match wi.z.value() < 0.0 {
        true => (mirrored(wi), mirrored(wo)),
        false => (wi, wo),
    }
}

impl<R: Real> PrincipledThin<R> {
    #[inline]
    fn reflecting_facets(&self) -> Microfacets<R> {
        burley::facets(self.roughness, self.anisotropic)
    }

    /// Facets that look as rough as two interfaces, by Figure 15 of Burley (2015).
    #[inline]
    fn transmitting_facets(&self) -> Microfacets<R> {
        let scale = R::constant(0.65) * self.eta - R::constant(0.35);
        burley::facets(scale * self.roughness, self.anisotropic)
    }
}

impl<R: Real> Scatters<R> for PrincipledThin<R> {
    #[inline]
    fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        let (wi, wo) = turned(wi, wo);
        let one = R::constant(1.0);
        let half = R::constant(0.5);
        let up = raised(wo);
        if up.z.value() == 0.0 {
            return Rgb::zero();
        }
        let h = (wi + up).normalized();
        let cos_h = wi.dot(h);
        let dielectric = fresnel_dielectric(cos_h, self.eta);
        let base = one - self.spec_trans;
        if wo.z.value() <= 0.0 {
            let facets = self.transmitting_facets().reflection(wi, up, h) * self.spec_trans;
            let passes = facets * (one - dielectric) * fade(-wo.dot(h));
            let diffuse = base * half * self.diff_trans * up.z * R::constant(FRAC_1_PI);
            return self.base_color * (passes + diffuse);
        }
        let plain = Rgb::splat(dielectric);
        let tinted = burley::tinted_reflectance(self.base_color, cos_h, self.eta);
        let reflectance = plain + (tinted - plain) * self.spec_tint;
        let facets = self.reflecting_facets().reflection(wi, wo, h) * self.spec_trans;
        let white = burley::base(wi, wo, cos_h, self.roughness, self.flatness);
        let sheen = burley::sheen(self.base_color, self.sheen_tint, wo, cos_h) * self.sheen;
        let diffuse = self.base_color * white + sheen;
        reflectance * facets + diffuse * (base * (one - half * self.diff_trans))
    }
}

/// From zero, where the transmitted direction is in the plane of the facet, to one.
///
/// Mitsuba has nothing for directions in front of the facet: transmission would be discontinuous
/// along a curve that is on no edge, which no derivative of the integrand sees. Faded over half
/// a degree it is continuous.
#[inline]
fn fade<R: Real>(cos: R) -> R {
    const WIDTH: f64 = 0.01;
    if cos.value() <= 0.0 {
        return R::constant(0.0);
    }
    if cos.value() >= WIDTH {
        return R::constant(1.0);
    }
    let x = cos * R::constant(1.0 / WIDTH);
    x.squared() * lerp(R::constant(3.0), R::constant(1.0), x)
}

/// Probabilities of sampling each part.
struct Chances {
    facets_reflect: f64,
    facets_transmit: f64,
    base_reflects: f64,
    base_transmits: f64,
}

impl PrincipledThin {
    #[inline]
    fn chances(&self) -> Chances {
        let facets = share(self.spec_trans, self.explored.facets);
        let base = share(1.0 - self.spec_trans, self.explored.facets);
        let transmitted = 0.5 * self.diff_trans;
        let passes = share(transmitted, self.explored.transmission);
        let stays = share(1.0 - transmitted, self.explored.transmission);
        let sum = facets + base * (passes + stays);
        Chances {
            facets_reflect: 0.5 * facets / sum,
            facets_transmit: 0.5 * facets / sum,
            base_reflects: base * stays / sum,
            base_transmits: base * passes / sum,
        }
    }
}

impl Samples for PrincipledThin {
    #[inline]
    fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        let inside = wi.z < 0.0;
        let wi = raised(wi);
        let chances = self.chances();
        let reflected = |facets: Microfacets| {
            let wo = local::reflected_about(wi, facets.sample(wi, u));
            Some(wo).filter(|wo| wo.z > 0.0)
        };
        let mut rest = choice;
        let mut chosen = |chance: f64| {
            rest -= chance;
            rest < 0.0
        };
        let wo = if chosen(chances.facets_reflect) {
            reflected(self.reflecting_facets())?
        } else if chosen(chances.facets_transmit) {
            mirrored(reflected(self.transmitting_facets())?)
        } else if chosen(chances.base_reflects) {
            local::sample_cosine(u)
        } else {
            mirrored(local::sample_cosine(u))
        };
        Some(Drawn::Smooth(if inside { mirrored(wo) } else { wo }))
    }

    #[inline]
    fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        let (wi, wo) = turned(wi, wo);
        let chances = self.chances();
        let up = raised(wo);
        if up.z == 0.0 {
            return 0.0;
        }
        let h = (wi + up).normalized();
        let (facets, facets_chance, base_chance) = match wo.z > 0.0 {
            true => (
                self.reflecting_facets(),
                chances.facets_reflect,
                chances.base_reflects,
            ),
            false => (
                self.transmitting_facets(),
                chances.facets_transmit,
                chances.base_transmits,
            ),
        };
        facets_chance * facets.reflection_pdf(wi, h) + base_chance * local::cosine_pdf(up)
    }
}
