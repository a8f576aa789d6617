//! What a scene may hold and this crate cannot render yet. Nothing is rendered
//! as something else: who renders asks here first.

use capwalk_scene::{Bsdf, Scene, Texture};

/// What of the scene cannot be rendered yet, one sentence each; empty if all of
/// it can.
pub fn unsupported(scene: &Scene) -> Vec<String> {
    let mut found = Vec::new();
    let is_texture = |what: String, texture: &Texture| {
        (!texture.is_constant()).then(|| format!("the {what} is a texture"))
    };
    for material in &scene.materials {
        if !matches!(material.bsdf, Bsdf::Diffuse { .. } | Bsdf::TwoSided { .. }) {
            let plugin = material.bsdf.plugin();
            found.push(format!("the material \"{}\" is a {plugin}", material.id));
            continue;
        }
        for slot in material.bsdf.slots() {
            let what = format!("{} of the material \"{}\"", slot.name, material.id);
            found.extend(is_texture(what, scene.texture(slot.texture)));
        }
    }
    for emitter in &scene.emitters {
        let what = format!("radiance of \"{}\"", emitter.name(scene));
        found.extend(is_texture(what, scene.texture(emitter.radiance())));
    }
    found
}

/// [`unsupported`] as one text, or `None` if all of the scene can be rendered.
pub fn unsupported_text(scene: &Scene) -> Option<String> {
    let found = unsupported(scene);
    match found.is_empty() {
        true => None,
        false => Some(format!(
            "the scene has what cannot be rendered yet: {}. Give one colour, or a material and \
             lamps that docs/scene-files.md lists as rendered",
            found.join("; ")
        )),
    }
}
