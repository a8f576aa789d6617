//! Numbers of materials that have no finite derivative where they are.

use capwalk_math::Rgb;
use capwalk_scene::bsdf::{PrincipledIndex, PrincipledTextures};
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
            let principled = match &scene.material(id).bsdf {
                Bsdf::Principled(principled) => principled,
                // Finite wherever they are valid; what they contain is in the list itself.
                Bsdf::Diffuse { .. }
                | Bsdf::Conductor(_)
                | Bsdf::RoughConductor(..)
                | Bsdf::Dielectric(_)
                | Bsdf::RoughDielectric(..)
                | Bsdf::ThinDielectric(_)
                | Bsdf::Plastic(_)
                | Bsdf::RoughPlastic { .. }
                | Bsdf::Null
                | Bsdf::TwoSided { .. }
                | Bsdf::Mask { .. }
                | Bsdf::Blend { .. }
                | Bsdf::NormalMap { .. }
                | Bsdf::BumpMap { .. } => continue,
            };
            let numbers = Numbers { scene, shape };
            if let Some((slot, why)) = numbers.without_derivative(principled, &is_asked_for) {
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

    /// What has no finite derivative somewhere, and why.
    fn without_derivative(
        &self,
        it: &PrincipledTextures,
        is_asked_for: impl Fn(TextureId) -> bool,
    ) -> Option<(&'static str, &'static str)> {
        let asked = |id| is_asked_for(self.scene.numbers_of(id, self.shape));
        let is_zero = |id| self.of(id).data.contains(&0.0);
        let has = |id| self.of(id).data.iter().any(|&x| x > 0.0);
        if asked(it.base_color) {
            if is_zero(it.base_color) && has(it.spec_trans) {
                return Some(("base_color", "glass takes its square root for a tint"));
            }
            let colours = self.of(it.base_color);
            let is_black = (0..colours.texels()).any(|i| colours.texel(i) == Rgb::zero());
            if is_black && (has(it.spec_tint) || has(it.sheen) && has(it.sheen_tint)) {
                return Some(("base_color", "tints have its hue, and black has none"));
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
