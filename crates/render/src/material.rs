//! What a surface does to light at a point: its material with its numbers.

use capwalk_math::{Frame, Real, Vec3};
use capwalk_scene::lobe::Bsdf;
use capwalk_scene::{Bsdf as Plugin, BsdfId, Pattern, Scene, Shape, Texture, TextureId};

use crate::accel::Accel;
use crate::path::Vertex;
use crate::world::{Surface, World};

/// The vertex of a path at a surface that is seen along `direction`; `None` if
/// the side that is seen is black.
pub fn vertex_at<R: Real, W: World<R>>(
    world: &W,
    accel: &Accel,
    surface: &Surface<R>,
    direction: Vec3<R>,
) -> Option<Vertex<R>> {
    let lookup = &mut |id: TextureId| world.lookup(id, &surface.point);
    let resolver = &accel.resolver;
    let resolved = resolver.resolve(accel.scene, surface.material, surface.side, lookup);
    resolved.bsdf.lobes().next()?;
    let mut frame = match surface.tangent {
        // As in Mitsuba: the first axis follows the first texture coordinate.
        Some(tangent) => Frame::from_normal_and_tangent(surface.outward, tangent),
        None => Frame::from_normal(surface.outward),
    };
    if resolved.flipped {
        frame.n = -frame.n;
    }
    let bsdf = match W::MOVES {
        true => resolved.bsdf.explored(),
        false => resolved.bsdf,
    };
    Some(Vertex::new(
        surface.position,
        surface.face_normal,
        frame,
        -direction,
        bsdf,
    ))
}

/// True if it matters how a material is turned about the normal.
pub fn needs_tangent(scene: &Scene, id: BsdfId) -> bool {
    let bsdf = &scene.material(id).bsdf;
    let is_zero = |id: TextureId| scene.texture(id).data.iter().all(|&x| x == 0.0);
    let own = match bsdf {
        Plugin::RoughConductor(_, facets) | Plugin::RoughDielectric(_, facets) => {
            facets.alpha[0] != facets.alpha[1]
        }
        Plugin::Principled(principled) => !is_zero(principled.anisotropic),
        _ => false,
    };
    own || bsdf
        .parts()
        .into_iter()
        .any(|part| needs_tangent(scene, part))
}

impl<R: Real> Vertex<R> {
    /// A vertex with the given shading frame, seen from the unit direction `wi`.
    pub fn new(
        position: Vec3<R>,
        face_normal: Vec3,
        frame: Frame<R>,
        wi: Vec3<R>,
        bsdf: Bsdf<R>,
    ) -> Self {
        let transmits = bsdf.lobes().any(|(_, lobe)| lobe.is_two_sided());
        Self {
            position,
            face_normal,
            wi: frame.to_local(wi),
            frame,
            transmits,
            bsdf,
        }
    }
}

/// The textures that decide how a shape looks: those of its materials and of
/// what it emits, attributes in the place of what looks them up.
pub fn textures_of<'s>(scene: &'s Scene, shape: &Shape) -> Vec<&'s Texture> {
    let mut materials = vec![shape.bsdf];
    let mut ids: Vec<TextureId> = shape
        .emitter
        .map(|id| scene.emitter(id).radiance())
        .into_iter()
        .collect();
    while let Some(id) = materials.pop() {
        let bsdf = &scene.material(id).bsdf;
        materials.extend(bsdf.parts());
        ids.extend(bsdf.slots().iter().map(|slot| slot.texture));
    }
    let resolved = |id: TextureId| match &scene.texture(id).pattern {
        Pattern::MeshAttribute { name, .. } => {
            let attribute = shape.attribute(name);
            scene.texture(attribute.expect("scenes are checked for attributes"))
        }
        _ => scene.texture(id),
    };
    ids.into_iter().map(resolved).collect()
}
