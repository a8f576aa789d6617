//! What a scene may hold and this crate cannot render yet. Nothing is rendered
//! as something else: who renders asks here first.

use capwalk_scene::{Bsdf, Scene};

/// What of the scene cannot be rendered yet, one phrase each; empty if all of it
/// can.
pub fn unsupported(scene: &Scene) -> Vec<String> {
    let is_rendered = |bsdf: &Bsdf| !matches!(bsdf, Bsdf::NormalMap { .. } | Bsdf::BumpMap { .. });
    let materials = scene.materials.iter();
    materials
        .filter(|material| !is_rendered(&material.bsdf))
        .map(|material| {
            let plugin = material.bsdf.plugin();
            format!("the material \"{}\" is a {plugin}", material.id)
        })
        .collect()
}

/// [`unsupported`] as one text, or `None` if all of the scene can be rendered.
pub fn unsupported_text(scene: &Scene) -> Option<String> {
    let found = unsupported(scene);
    match found.is_empty() {
        true => None,
        false => Some(format!(
            "the scene has what cannot be rendered yet: {}. Use the material that it stands around \
             by itself",
            found.join("; ")
        )),
    }
}
