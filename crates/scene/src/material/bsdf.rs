//! Materials: what a file says of a surface. What it does to light at a point is
//! in [`crate::lobe`]. To add one: add a variant here, and follow the compiler.

use serde::{Deserialize, Serialize};

use super::lobe::Distribution;
use crate::ids::{BsdfId, TextureId};
use crate::quantity::Quantity;
use crate::slot::Slot;

/// A material and its name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Its name; parameters are `<id>.reflectance.value` and so on.
    pub id: String,
    /// What it does to light.
    pub bsdf: Bsdf,
}

/// What a surface does to light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Bsdf {
    /// Reflects equally to all directions, from its front side only.
    Diffuse {
        /// Fraction of light reflected.
        reflectance: TextureId,
    },
    /// A metal mirror, from its front side only.
    Conductor(Metal),
    /// A metal of microfacets, from its front side only.
    RoughConductor(Metal, Facets),
    /// The surface of a clear body.
    Dielectric(Glass),
    /// The surface of a clear body, of microfacets.
    RoughDielectric(Glass, Facets),
    /// A clear pane without thickness.
    ThinDielectric(Glass),
    /// A clear coat over a diffuse base, from its front side only.
    Plastic(Coat),
    /// A rough clear coat over a diffuse base, from its front side only.
    RoughPlastic {
        /// Coat and base.
        coat: Coat,
        /// Distribution of the facets.
        distribution: Distribution,
        /// Roughness of the coat; a constant.
        alpha: TextureId,
    },
    /// Clear facets added to a diffuse base, from its front side only.
    PolarizedPlastic(Coat, Facets),
    /// Many looks from few numbers.
    Principled(PrincipledTextures),
    /// The same of a sheet, alike from both sides.
    PrincipledThin(ThinTextures),
    /// Nothing: light passes.
    Null,
    /// Has a front and a back.
    TwoSided {
        /// Material of the side that the normal points to.
        front: BsdfId,
        /// Material of the other side.
        back: BsdfId,
    },
    /// Partly there.
    Mask {
        /// Fraction of light that interacts with the material; the rest passes.
        opacity: TextureId,
        /// The material.
        nested: BsdfId,
    },
    /// Two materials mixed.
    Blend {
        /// Fraction of the second.
        weight: TextureId,
        /// The materials.
        nested: [BsdfId; 2],
    },
    /// Normals from a texture, relative to the shading frame.
    NormalMap {
        /// `(n + 1) / 2`.
        normals: TextureId,
        /// The material.
        nested: BsdfId,
        /// What is done about normals that go too far.
        limits: NormalLimits,
    },
    /// Normals from the derivatives of a texture.
    BumpMap {
        /// Heights, in world units.
        heights: TextureId,
        /// Factor on the heights; a constant.
        scale: TextureId,
        /// The material.
        nested: BsdfId,
        /// What is done about normals that go too far.
        limits: NormalLimits,
    },
}

/// The numbers of a metal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Metal {
    /// Refractive index.
    pub eta: TextureId,
    /// Extinction.
    pub k: TextureId,
    /// Factor on what is reflected.
    pub specular_reflectance: TextureId,
}

/// How rough a surface is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Facets {
    /// Distribution of their normals.
    pub distribution: Distribution,
    /// Roughness along tangent and bitangent; one texture if it is the same.
    pub alpha: [TextureId; 2],
}

/// The numbers of a clear body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Glass {
    /// Refractive index on the side that the normal points away from.
    pub int_ior: TextureId,
    /// Refractive index on the side that the normal points to.
    pub ext_ior: TextureId,
    /// Factor on what is reflected.
    pub specular_reflectance: TextureId,
    /// Factor on what is transmitted.
    pub specular_transmittance: TextureId,
}

/// The numbers of a clear coat and its base.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Coat {
    /// Refractive index of the coat.
    pub int_ior: TextureId,
    /// Refractive index outside.
    pub ext_ior: TextureId,
    /// Fraction of light reflected by the base.
    pub diffuse_reflectance: TextureId,
    /// Factor on what the coat reflects.
    pub specular_reflectance: TextureId,
    /// True if light takes the colour of the base each time it gets there.
    pub nonlinear: bool,
}

/// The numbers of [`Bsdf::Principled`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the names are those of the literature")]
pub struct PrincipledTextures {
    pub base_color: TextureId,
    pub roughness: TextureId,
    pub anisotropic: TextureId,
    pub metallic: TextureId,
    pub spec_trans: TextureId,
    pub index: PrincipledIndex,
    pub spec_tint: TextureId,
    pub sheen: TextureId,
    pub sheen_tint: TextureId,
    pub flatness: TextureId,
    pub clearcoat: TextureId,
    pub clearcoat_gloss: TextureId,
}

/// The numbers of [`Bsdf::PrincipledThin`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the names are those of the literature")]
pub struct ThinTextures {
    pub base_color: TextureId,
    pub roughness: TextureId,
    pub anisotropic: TextureId,
    pub spec_trans: TextureId,
    pub eta: TextureId,
    pub spec_tint: TextureId,
    pub sheen: TextureId,
    pub sheen_tint: TextureId,
    pub flatness: TextureId,
    pub diff_trans: TextureId,
}

/// How much a principled material refracts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum PrincipledIndex {
    /// Refractive index relative to the outside.
    Eta(TextureId),
    /// 0 to 1: 8 % of it is reflected at normal incidence.
    Specular(TextureId),
}

/// What is done about perturbed normals that go too far.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct NormalLimits {
    /// True if normals that turn away from the viewer are turned back.
    pub flip_invalid: bool,
    /// True if light fades where the surface would hide itself.
    pub shadowing: bool,
}

impl Bsdf {
    /// The plugin's name.
    pub fn plugin(&self) -> &'static str {
        match self {
            Self::Diffuse { .. } => "diffuse",
            Self::Conductor(_) => "conductor",
            Self::RoughConductor(..) => "roughconductor",
            Self::Dielectric(_) => "dielectric",
            Self::RoughDielectric(..) => "roughdielectric",
            Self::ThinDielectric(_) => "thindielectric",
            Self::Plastic(_) => "plastic",
            Self::RoughPlastic { .. } => "roughplastic",
            Self::PolarizedPlastic(..) => "pplastic",
            Self::Principled(_) => "principled",
            Self::PrincipledThin(_) => "principledthin",
            Self::Null => "null",
            Self::TwoSided { .. } => "twosided",
            Self::Mask { .. } => "mask",
            Self::Blend { .. } => "blendbsdf",
            Self::NormalMap { .. } => "normalmap",
            Self::BumpMap { .. } => "bumpmap",
        }
    }

    /// The textures that stand in it.
    pub fn slots(&self) -> Vec<Slot> {
        use Quantity::*;
        let mut slots = Vec::new();
        let mut add = |name, texture, quantity| {
            slots.push(Slot {
                name,
                texture,
                quantity,
            });
        };
        match self {
            Self::Diffuse { reflectance } => add("reflectance", *reflectance, Reflectance),
            Self::Conductor(metal) => metal.slots(add),
            Self::RoughConductor(metal, facets) => {
                facets.slots(&mut add);
                metal.slots(add);
            }
            Self::Dielectric(glass) => glass.slots(RefractiveIndex { bends: true }, add),
            Self::ThinDielectric(glass) => glass.slots(RefractiveIndex { bends: false }, add),
            Self::RoughDielectric(glass, facets) => {
                facets.slots(&mut add);
                glass.slots(RefractiveIndex { bends: false }, add);
            }
            Self::Plastic(coat) => coat.slots(add),
            Self::RoughPlastic { coat, alpha, .. } => {
                add("alpha", *alpha, Roughness);
                coat.slots(add);
            }
            Self::PolarizedPlastic(coat, facets) => {
                facets.slots(&mut add);
                coat.slots(add);
            }
            Self::Principled(principled) => principled.slots(add),
            Self::PrincipledThin(thin) => thin.slots(add),
            Self::Null | Self::TwoSided { .. } => {}
            Self::Mask { opacity, .. } => add("opacity", *opacity, Fraction),
            Self::Blend { weight, .. } => add("weight", *weight, Fraction),
            Self::NormalMap { normals, .. } => add("normalmap", *normals, Normal),
            Self::BumpMap { heights, scale, .. } => {
                add("nested_texture", *heights, Height);
                add("scale", *scale, SignedFactor);
            }
        }
        slots
    }
}

impl Metal {
    fn slots(&self, mut add: impl FnMut(&'static str, TextureId, Quantity)) {
        add("eta", self.eta, Quantity::MetalIndex);
        add("k", self.k, Quantity::Extinction);
        let factor = Quantity::Reflectance;
        add("specular_reflectance", self.specular_reflectance, factor);
    }
}

impl Facets {
    fn slots(&self, add: &mut impl FnMut(&'static str, TextureId, Quantity)) {
        let [u, v] = self.alpha;
        if u == v {
            add("alpha", u, Quantity::Roughness);
        } else {
            add("alpha_u", u, Quantity::Roughness);
            add("alpha_v", v, Quantity::Roughness);
        }
    }
}

impl Glass {
    fn slots(&self, index: Quantity, mut add: impl FnMut(&'static str, TextureId, Quantity)) {
        add("int_ior", self.int_ior, index);
        add("ext_ior", self.ext_ior, index);
        let factor = Quantity::Reflectance;
        add("specular_reflectance", self.specular_reflectance, factor);
        let factor = Quantity::Transmittance;
        add(
            "specular_transmittance",
            self.specular_transmittance,
            factor,
        );
    }
}

impl Coat {
    fn slots(&self, mut add: impl FnMut(&'static str, TextureId, Quantity)) {
        let index = Quantity::RefractiveIndex { bends: false };
        add("int_ior", self.int_ior, index);
        add("ext_ior", self.ext_ior, index);
        let reflectance = Quantity::Reflectance;
        add("diffuse_reflectance", self.diffuse_reflectance, reflectance);
        add(
            "specular_reflectance",
            self.specular_reflectance,
            reflectance,
        );
    }
}

impl PrincipledTextures {
    fn slots(&self, mut add: impl FnMut(&'static str, TextureId, Quantity)) {
        add("base_color", self.base_color, Quantity::Reflectance);
        match self.index {
            PrincipledIndex::Eta(eta) => {
                add("eta", eta, Quantity::RefractiveIndex { bends: false });
            }
            PrincipledIndex::Specular(specular) => add("specular", specular, Quantity::Fraction),
        }
        for (name, texture) in self.fractions() {
            add(name, texture, Quantity::Fraction);
        }
    }

    /// All that is a number from 0 to 1, but for `specular`.
    fn fractions(&self) -> [(&'static str, TextureId); 10] {
        [
            ("roughness", self.roughness),
            ("anisotropic", self.anisotropic),
            ("metallic", self.metallic),
            ("spec_trans", self.spec_trans),
            ("spec_tint", self.spec_tint),
            ("sheen", self.sheen),
            ("sheen_tint", self.sheen_tint),
            ("flatness", self.flatness),
            ("clearcoat", self.clearcoat),
            ("clearcoat_gloss", self.clearcoat_gloss),
        ]
    }
}

impl ThinTextures {
    fn slots(&self, mut add: impl FnMut(&'static str, TextureId, Quantity)) {
        add("base_color", self.base_color, Quantity::Reflectance);
        add("eta", self.eta, Quantity::RefractiveIndex { bends: false });
        for (name, texture) in [
            ("roughness", self.roughness),
            ("anisotropic", self.anisotropic),
            ("spec_trans", self.spec_trans),
            ("spec_tint", self.spec_tint),
            ("sheen", self.sheen),
            ("sheen_tint", self.sheen_tint),
            ("flatness", self.flatness),
        ] {
            add(name, texture, Quantity::Fraction);
        }
        add("diff_trans", self.diff_trans, Quantity::TwiceFraction);
    }
}
