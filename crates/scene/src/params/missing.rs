//! What a user of other renderers looks for among the parameters and does not
//! find: the reason, and what to do instead.

use crate::emitter::Emitter;
use crate::scene::Scene;

/// Parts of an emitter's name that place it.
const PLACEMENT: [&str; 7] = [
    "to_world",
    "translate",
    "rotate",
    "scale",
    "position",
    "direction",
    "target",
];

/// Why a name is no parameter's, if there is more to say than that.
pub(super) fn reason(scene: &Scene, name: &str) -> Option<String> {
    scene
        .emitters
        .iter()
        .find_map(|emitter| placement(scene, emitter, name))
        .or_else(|| texture_coordinates(scene, name))
}

/// An emitter without geometry stays where it is.
fn placement(scene: &Scene, emitter: &Emitter, name: &str) -> Option<String> {
    let id = emitter.name(scene);
    let what = part_behind(&id, name)?;
    if !PLACEMENT.contains(&what) {
        return None;
    }
    let other_scene = "to check such a derivative, compare images of two scenes that differ in \
                       where the emitter stands";
    match emitter {
        Emitter::Area { .. } | Emitter::Constant { .. } => None,
        Emitter::EnvironmentMap { .. } => Some(format!(
            "derivatives with respect to the rotation of an environment map are not implemented. `{id}.data`, \
             its texels, is a parameter; {other_scene}"
        )),
        Emitter::Projector { .. } => Some(format!(
            "derivatives with respect to where a projector stands, and where its image falls, are not \
             implemented. `{id}.scale` and the numbers of its image are parameters; {other_scene}"
        )),
        Emitter::Point { .. } => Some(format!(
            "a point light has a place alone: `{id}.translate.x` (y, z) move it, and \
             `{id}.position` is an array"
        )),
        Emitter::Spot { .. } => Some(format!(
            "`{id}.translate.x` and `{id}.rotate.x` (y, z) move and turn a spot light"
        )),
        Emitter::Directional { .. } => Some(format!(
            "`{id}.rotate.x` (y, z) turn parallel light, which has no place"
        )),
    }
}

fn texture_coordinates(scene: &Scene, name: &str) -> Option<String> {
    let mut shapes = scene.shapes.iter();
    let asked = |id: &str| {
        let part = part_behind(id, name);
        part.is_some_and(|part| matches!(part, "texcoords" | "vertex_texcoords" | "uv" | "uvs"))
    };
    shapes.any(|shape| asked(&shape.id)).then(|| {
        "derivatives with respect to texture coordinates are not implemented; the texels of a bitmap \
         (`.data`) are parameters"
            .into()
    })
}

/// The first part of `name` behind the name of an object, without indices.
fn part_behind<'a>(object: &str, name: &'a str) -> Option<&'a str> {
    let behind = name.strip_prefix(object)?.strip_prefix('.')?;
    behind.split(['.', '[']).next()
}
