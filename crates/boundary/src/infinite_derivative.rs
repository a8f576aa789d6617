//! Numbers of materials that have no finite derivative where they are.

use capwalk_math::Rgb;
use capwalk_scene::bsdf::{PrincipledIndex, PrincipledTextures, ThinTextures};
use capwalk_scene::{Bsdf, Scene, Shape, Texture, TextureId};

use crate::refusal::Refusal;

/// A refusal if derivatives are asked for by a texture with texels at which
/// what a principled material does has no finite derivative.
pub fn refuse_infinite_derivatives(
    scene: &Scene,
    is_asked_for: impl Fn(TextureId) -> bool,
) -> Result<(), Refusal> {
    for shape in &scene.shapes {
        for id in scene.materials_below(shape.bsdf) {
            let numbers = Numbers { scene, shape };
            let found = match &scene.material(id).bsdf {
                Bsdf::Principled(it) => numbers.of_principled(it, &is_asked_for),
                Bsdf::PrincipledThin(it) => numbers.of_thin(it, &is_asked_for),
                // Finite wherever they are valid; what they contain is in the list itself.
                Bsdf::Diffuse { .. }
                | Bsdf::Conductor(_)
                | Bsdf::RoughConductor(..)
                | Bsdf::Dielectric(_)
                | Bsdf::RoughDielectric(..)
                | Bsdf::ThinDielectric(_)
                | Bsdf::Plastic(_)
                | Bsdf::RoughPlastic { .. }
                | Bsdf::PolarizedPlastic(..)
                | Bsdf::Null
                | Bsdf::TwoSided { .. }
                | Bsdf::Mask { .. }
                | Bsdf::Blend { .. }
                | Bsdf::NormalMap { .. }
                | Bsdf::BumpMap { .. } => continue,
            };
            if let Some((slot, why)) = found {
                return Err(Refusal::InfiniteDerivative {
                    material: scene.material(id).id.clone(),
                    slot,
                    why,
                });
            }
        }
    }
    Ok(())
}

/// The numbers of textures on a shape.
struct Numbers<'s> {
    scene: &'s Scene,
    shape: &'s Shape,
}

impl Numbers<'_> {
    fn of(&self, id: TextureId) -> &Texture {
        self.scene.texture(self.scene.numbers_of(id, self.shape))
    }

    fn has(&self, id: TextureId) -> bool {
        self.of(id).data.iter().any(|&x| x > 0.0)
    }

    /// The colour, if it is black somewhere and a tint takes its hue.
    fn hue_of_black(
        &self,
        base_color: TextureId,
        spec_tint: TextureId,
        [sheen, sheen_tint]: [TextureId; 2],
    ) -> Option<(&'static str, &'static str)> {
        let colours = self.of(base_color);
        let is_black = (0..colours.texels()).any(|i| colours.texel(i) == Rgb::zero());
        let is_tinted = self.has(spec_tint) || self.has(sheen) && self.has(sheen_tint);
        let why = "tints have its hue, and black has none";
        (is_black && is_tinted).then_some(("base_color", why))
    }

    fn of_thin(
        &self,
        it: &ThinTextures,
        is_asked_for: impl Fn(TextureId) -> bool,
    ) -> Option<(&'static str, &'static str)> {
        match is_asked_for(self.scene.numbers_of(it.base_color, self.shape)) {
            true => self.hue_of_black(it.base_color, it.spec_tint, [it.sheen, it.sheen_tint]),
            false => None,
        }
    }

    /// What has no finite derivative somewhere, and why.
    fn of_principled(
        &self,
        it: &PrincipledTextures,
        is_asked_for: impl Fn(TextureId) -> bool,
    ) -> Option<(&'static str, &'static str)> {
        let asked = |id| is_asked_for(self.scene.numbers_of(id, self.shape));
        let is_zero = |id| self.of(id).data.contains(&0.0);
        if asked(it.base_color) {
            if is_zero(it.base_color) && self.has(it.spec_trans) {
                return Some(("base_color", "glass takes its square root for a tint"));
            }
            let sheen = [it.sheen, it.sheen_tint];
            if let Some(found) = self.hue_of_black(it.base_color, it.spec_tint, sheen) {
                return Some(found);
            }
        }
        match it.index {
            PrincipledIndex::Specular(specular) if asked(specular) && is_zero(specular) => {
                Some(("specular", "the refractive index follows its square root"))
            }
            PrincipledIndex::Specular(_) | PrincipledIndex::Eta(_) => None,
        }
    }
}
