//! The principled material: many appearances from few numbers.

use std::f64::consts::PI;

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::burley::{self, schlick, schlick_weight, share};
use super::event::Drawn;
use super::fresnel::fresnel_dielectric;
use super::local;
use super::local::{lerp, mirrored, turned_outside};
use super::microfacets::{Distribution, Microfacets};
use super::refraction::{refracted_about, refracting_normal, transmission, transmission_pdf};
use crate::ids::TextureId;
use crate::material::fields::{WithoutEffect, fields};
use crate::material::number::{Circumstances, Derived, Number, PrincipledIndex};
use crate::material::plain::{
    Anisotropy, AskedNumbers, InScene, Plain, Samples, Scatters, TextureOf,
};

/// Diffuse base, metal, glass, sheen and a clear coat, blended. All numbers but
/// `eta` are from 0 to 1.
///
/// It shows something to the back only if it transmits (`spec_trans` above 0
/// and `metallic` below 1, or `explored.glass`); from there it is glass.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Principled<N: Number = f64> {
    /// The colour of base and metal.
    pub base_color: N::Colour,
    /// Refractive index of the inside relative to the outside.
    pub eta: N::Index,
    /// How rough reflection and transmission are; `alpha` is its square.
    pub roughness: N,
    /// How much longer highlights are along the tangent.
    pub anisotropic: N,
    /// How much of it is metal.
    pub metallic: N,
    /// How much of what is no metal is glass.
    pub spec_trans: N,
    /// How much reflection takes the hue of the base.
    pub spec_tint: N,
    /// A rim of light as on cloth.
    pub sheen: N,
    /// How much the sheen takes the hue of the base.
    pub sheen_tint: N,
    /// How much the base looks as if light went through below the surface.
    pub flatness: N,
    /// A second, clear coat.
    pub clearcoat: N,
    /// How smooth that coat is.
    pub clearcoat_gloss: N,
    /// What is sampled even where there is none of it.
    pub explored: N::Derived<Explored>,
}

fields! {
    Principled {
        base_color: colour(Reflectance, 0.5),
        eta: index(0.5),
        roughness: number(Fraction, 0.5),
        anisotropic: number(Fraction, 0.0),
        metallic: number(Fraction, 0.0),
        spec_trans: number(Fraction, 0.0),
        spec_tint: number(Fraction, 0.0),
        sheen: number(Fraction, 0.0),
        sheen_tint: number(Fraction, 0.0),
        flatness: number(Fraction, 0.0),
        clearcoat: number(Fraction, 0.0),
        clearcoat_gloss: number(Fraction, 0.0),
        ; explored: Explored
    }
}

impl<N: Number> Plain for Principled<N> {
    const PLUGIN: &'static str = "principled";
    const HAS_FACETS: bool = true;
    const WITHOUT_EFFECT: WithoutEffect = WithoutEffect {
        names: &[
            "main_specular_sampling_rate",
            "clearcoat_sampling_rate",
            "diffuse_reflectance_sampling_rate",
        ],
        reason: burley::SAMPLING_RATES,
    };
}

impl InScene for Principled<TextureId> {
    fn anisotropy(&self) -> Anisotropy {
        Anisotropy::By(self.anisotropic)
    }

    fn has_inside(&self, texture: TextureOf) -> bool {
        let glass = texture(self.spec_trans);
        !glass.is_constant() || glass.data.iter().any(|&x| x > 0.0)
    }

    fn infinite_derivative(&self, numbers: &AskedNumbers) -> Option<(&'static str, &'static str)> {
        if numbers.is_asked_for_at_zero(self.base_color) && numbers.has(self.spec_trans) {
            return Some(("base_color", "glass takes its square root for a tint"));
        }
        let sheen = [self.sheen, self.sheen_tint];
        burley::hue_of_black(numbers, self.base_color, self.spec_tint, sheen).or(match self.eta {
            PrincipledIndex::Specular(specular) if numbers.is_asked_for_at_zero(specular) => {
                Some(("specular", "the refractive index follows its square root"))
            }
            PrincipledIndex::Specular(_) | PrincipledIndex::Eta(_) => None,
        })
    }
}

impl Derived for Explored {
    type Of<N: Number> = Principled<N>;

    #[inline]
    fn find(principled: &Principled<TextureId>, at: &impl Circumstances) -> Self {
        let base = at.may_change(principled.metallic) || at.may_change(principled.spec_trans);
        Self {
            base,
            glass: base && !at.is_opaque(),
            coat: at.may_change(principled.clearcoat),
        }
    }
}

/// Parts of a [`Principled`] that are sampled even where there are none of them:
/// how much there is may have a derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Explored {
    /// The diffuse base.
    pub base: bool,
    /// Transmission.
    pub glass: bool,
    /// The clear coat.
    pub coat: bool,
}

impl<R: Real> Scatters<R> for Principled<R> {
    #[inline]
    fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        let (wi, wo, eta, front) = self.turned(wi, wo);
        let facets = self.facets();
        if wo.z.value() <= 0.0 {
            let Some(h) = refracting_normal(wi, wo, eta).filter(|_| self.is_two_sided()) else {
                return Rgb::zero();
            };
            let passes = self.glass() * transmission(&facets, wi, wo, h, eta);
            return self.base_color.map(root) * passes;
        }
        let h = (wi + wo).normalized();
        let cos_h = wi.dot(h);
        let reflectance = self.reflectance(cos_h, eta, front);
        let specular = reflectance * facets.reflection(wi, wo, h);
        if !front {
            return specular;
        }
        specular + self.diffuse(wi, wo, cos_h) + Rgb::splat(self.coat(wi, wo, h))
    }

    #[inline]
    fn mirrored(&self, wi: Vec3<R>, wo: Vec3<R>, visit: &mut impl FnMut(Rgb<R>, R)) {
        let (wi, wo, eta, front) = self.turned(wi, wo);
        if wo.z.value() > 0.0 {
            let (h, facets) = ((wi + wo).normalized(), self.facets());
            let reflectance = self.reflectance(wi.dot(h), eta, front);
            visit(reflectance * facets.reflection(wi, wo, h), facets.alpha2());
            if front {
                let coat = Rgb::splat(self.coat(wi, wo, h));
                visit(coat, self.coat_alpha().squared());
            }
        }
    }

    #[inline]
    fn is_two_sided(&self) -> bool {
        self.explored.glass || self.glass().value() > 0.0
    }
}

impl<R: Real> Principled<R> {
    /// The refractive index for the number `specular` (0 to 1), which says how
    /// much is reflected at normal incidence: 8 % of it.
    pub fn eta_of_specular(specular: R) -> R {
        let one = R::constant(1.0);
        let root = (R::constant(0.08) * specular).sqrt();
        R::constant(2.0) / (one - root) - one
    }

    /// The facets of metal and glass.
    #[inline]
    fn facets(&self) -> Microfacets<R> {
        burley::facets(self.roughness, self.anisotropic)
    }

    /// How much of it is a diffuse base.
    #[inline]
    fn base(&self) -> R {
        let one = R::constant(1.0);
        (one - self.metallic) * (one - self.spec_trans)
    }

    /// How much of it is glass.
    #[inline]
    fn glass(&self) -> R {
        (R::constant(1.0) - self.metallic) * self.spec_trans
    }

    /// Directions and refractive index with `wi` in front; true if that is the
    /// front of the surface.
    #[inline]
    fn turned(&self, wi: Vec3<R>, wo: Vec3<R>) -> (Vec3<R>, Vec3<R>, R, bool) {
        if !self.is_two_sided() {
            return (local::raised(wi), wo, self.eta, true);
        }
        let front = wi.z.value() >= 0.0;
        let (wi, wo, eta) = turned_outside(wi, wo, self.eta);
        (wi, wo, eta, front)
    }

    /// What the facets reflect: Fresnel's equations for the dielectric, blended
    /// with Schlick's approximation for its tinted part and for the metal.
    #[inline]
    fn reflectance(&self, cos_h: R, eta: R, front: bool) -> Rgb<R> {
        let one = R::constant(1.0);
        let dielectric = fresnel_dielectric(cos_h, eta);
        if dielectric.value() <= 0.0 {
            return Rgb::zero(); // no interface, no metal either: as in Mitsuba
        }
        if !front {
            return Rgb::splat(self.glass() * dielectric);
        }
        let metal = schlick(self.base_color, schlick_weight(cos_h, eta));
        let tinted = burley::tinted_reflectance(self.base_color, cos_h, eta);
        let no_metal = one - self.metallic;
        metal * self.metallic
            + tinted * (no_metal * self.spec_tint)
            + Rgb::splat(dielectric * no_metal * (one - self.spec_tint))
    }

    /// The diffuse base and its sheen.
    #[inline]
    fn diffuse(&self, wi: Vec3<R>, wo: Vec3<R>, cos_h: R) -> Rgb<R> {
        let base = self.base() * burley::base(wi, wo, cos_h, self.roughness, self.flatness);
        // Of glass alone, too, for continuity: Mitsuba's scalar variants have none there.
        let sheen = self.sheen * (R::constant(1.0) - self.metallic);
        self.base_color * base + burley::sheen(self.base_color, self.sheen_tint, wo, cos_h) * sheen
    }

    /// The clear coat: `f |cos wo|`, with tails longer than those of GGX.
    #[inline]
    fn coat(&self, wi: Vec3<R>, wo: Vec3<R>, h: Vec3<R>) -> R {
        // Shadowing of a fixed roughness, whatever the gloss.
        const SHADOWING_ALPHA: f64 = 0.25;
        let shadowing = Microfacets::isotropic(Distribution::Ggx, R::constant(SHADOWING_ALPHA));
        let weight = schlick_weight(wi.dot(h), self.eta);
        let reflectance = lerp(R::constant(0.04), R::constant(1.0), weight);
        let visible = shadowing.visible(wi) * shadowing.visible(wo);
        let coat = R::constant(0.25) * self.clearcoat * reflectance;
        coat * coat_density(self.coat_alpha(), h.z) * visible * wo.z
    }

    #[inline]
    fn coat_alpha(&self) -> R {
        lerp(R::constant(0.1), R::constant(0.001), self.clearcoat_gloss)
    }
}

/// The square root; zero with derivative zero where the derivative is infinite.
#[inline]
fn root<R: Real>(x: R) -> R {
    if x.value() > 0.0 {
        x.sqrt()
    } else {
        R::constant(0.0)
    }
}

/// Density of the coat's normals, the distribution "GTR1" of Burley (2012).
#[inline]
fn coat_density<R: Real>(alpha: R, cos: R) -> R {
    let alpha2 = alpha.squared();
    let below_one = alpha2 - R::constant(1.0);
    let spread = R::constant(1.0) + below_one * cos.squared();
    below_one / (R::constant(PI) * alpha2.ln() * spread)
}

/// A normal drawn with the density `coat_density(alpha, cos) cos`.
fn sample_coat(alpha: f64, u: [f64; 2]) -> Vec3 {
    let alpha2 = alpha * alpha;
    let cos2 = ((1.0 - alpha2.powf(1.0 - u[0])) / (1.0 - alpha2)).clamp(0.0, 1.0);
    let sin = (1.0 - cos2).sqrt();
    let (sin_phi, cos_phi) = (2.0 * PI * u[1]).sin_cos();
    Vec3::new(sin * cos_phi, sin * sin_phi, cos2.sqrt())
}

/// Probabilities of sampling the base, the coat, and the facets.
struct Chances {
    base: f64,
    coat: f64,
    facets: f64,
}

impl Principled {
    /// By weight; the coat counts a quarter. Glass seen from behind has facets alone.
    #[inline]
    fn chances(&self, front: bool) -> Chances {
        if !front {
            return Chances {
                base: 0.0,
                coat: 0.0,
                facets: 1.0,
            };
        }
        let base = share(self.base(), self.explored.base);
        let coat = 0.25 * share(self.clearcoat, self.explored.coat);
        let sum = base + coat + 1.0;
        Chances {
            base: base / sum,
            coat: coat / sum,
            facets: 1.0 / sum,
        }
    }

    /// Probability that facets refract, and do not reflect.
    #[inline]
    fn refraction(&self, cos_h: f64, eta: f64, front: bool) -> f64 {
        let passes = 1.0 - fresnel_dielectric(cos_h, eta);
        if front {
            share(self.glass(), self.explored.glass) * passes
        } else {
            passes
        }
    }
}

impl Samples for Principled {
    #[inline]
    fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        let inside = self.is_two_sided() && wi.z < 0.0;
        let (wi, _, eta, front) = self.turned(wi, wi);
        let chances = self.chances(front);
        let wo = if choice < chances.base {
            Some(local::sample_cosine(u))
        } else if choice < chances.base + chances.coat {
            let wo = local::reflected_about(wi, sample_coat(self.coat_alpha(), u));
            Some(wo).filter(|wo| wo.z > 0.0)
        } else {
            let m = self.facets().sample(wi, u);
            let rest = (choice - chances.base - chances.coat) / chances.facets;
            if rest < self.refraction(wi.dot(m), eta, front) {
                refracted_about(wi, m, eta).filter(|wo| wo.z < 0.0)
            } else {
                Some(local::reflected_about(wi, m)).filter(|wo| wo.z > 0.0)
            }
        }?;
        Some(Drawn::Smooth(if inside { mirrored(wo) } else { wo }))
    }

    #[inline]
    fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        let (wi, wo, eta, front) = self.turned(wi, wo);
        let chances = self.chances(front);
        let facets = self.facets();
        if wo.z <= 0.0 {
            let Some(h) = refracting_normal(wi, wo, eta).filter(|_| self.is_two_sided()) else {
                return 0.0;
            };
            let refracts = chances.facets * self.refraction(wi.dot(h), eta, front);
            return refracts * transmission_pdf(&facets, wi, wo, h, eta);
        }
        let h = (wi + wo).normalized();
        let cos_h = wi.dot(h);
        let reflects = chances.facets * (1.0 - self.refraction(cos_h, eta, front));
        // The coat's normals are not those that are visible: at facets seen
        // from the side the density has no bound.
        let coat = if chances.coat > 0.0 && cos_h > 0.0 {
            coat_density(self.coat_alpha(), h.z) * h.z / (4.0 * cos_h)
        } else {
            0.0
        };
        reflects * facets.reflection_pdf(wi, h)
            + chances.coat * coat
            + chances.base * local::cosine_pdf(wo)
    }
}
