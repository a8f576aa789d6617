//! Maps of normals on mirrored texture coordinates, where glTF turns the second tangent over
//! and Mitsuba does not.

use capwalk_scene::{Bsdf, BsdfId, Scene, Shape};

/// What to warn of, if there are such maps: the first shape that has one.
pub(crate) fn mirrored_maps(scene: &Scene) -> Option<String> {
    let mut shapes = scene.shapes.iter();
    let shape = shapes.find(|shape| has_map(scene, shape.bsdf) && is_mirrored(shape))?;
    Some(format!(
        "texture coordinates of \"{}\" are mirrored: its map of normals is upside down there",
        shape.id
    ))
}

fn has_map(scene: &Scene, bsdf: BsdfId) -> bool {
    match scene.material(bsdf).bsdf {
        Bsdf::NormalMap { .. } => true,
        Bsdf::TwoSided { front, .. } => has_map(scene, front),
        Bsdf::Mask { nested, .. } => has_map(scene, nested),
        _ => false,
    }
}

/// True if a face shows images as a mirror does: v points down in them.
fn is_mirrored(shape: &Shape) -> bool {
    let mut faces = shape.uvs.iter().flatten();
    faces.any(|[a, b, c]| {
        let (u, v) = ([b[0] - a[0], c[0] - a[0]], [b[1] - a[1], c[1] - a[1]]);
        u[0] * v[1] - u[1] * v[0] > 0.0
    })
}
