//! Numbers of materials that have no finite derivative where they are.

use capwalk_scene::plain::AskedNumbers;
use capwalk_scene::{Bsdf, Scene, TextureId};

use crate::refusal::Refusal;

/// A refusal if derivatives are asked for by a texture with texels at which
/// what a material does has no finite derivative.
pub fn refuse_infinite_derivatives(
    scene: &Scene,
    is_asked_for: impl Fn(TextureId) -> bool,
) -> Result<(), Refusal> {
    for shape in &scene.shapes {
        let numbers = AskedNumbers {
            texture: &|id| scene.texture(scene.numbers_of(id, shape)),
            is_asked_for: &|id| is_asked_for(scene.numbers_of(id, shape)),
        };
        for id in scene.materials_below(shape.bsdf) {
            let material = scene.material(id);
            // What one contains that is made of others is in the list itself.
            if let Bsdf::Plain(lobe) = &material.bsdf
                && let Some((slot, why)) = lobe.infinite_derivative(&numbers)
            {
                return Err(Refusal::InfiniteDerivative {
                    material: material.id.clone(),
                    slot,
                    why,
                });
            }
        }
    }
    Ok(())
}
