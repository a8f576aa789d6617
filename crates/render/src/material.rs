//! What a surface does to light at a point: its material with its numbers.

use capwalk_math::{Frame, Real, Vec3};
use capwalk_scene::lobe::{Bsdf, Diffuse, Lobe, Side};
use capwalk_scene::{Bsdf as Plugin, Pattern, Scene, Shape, Texture, TextureId};

use crate::path::Vertex;
use crate::world::{Surface, World};

/// The vertex of a path at a surface that is seen along `direction`; `None` if
/// the side that is seen is black.
pub fn vertex_at<R: Real, W: World<R>>(
    world: &W,
    surface: &Surface<R>,
    direction: Vec3<R>,
) -> Option<Vertex<R>> {
    let scene = world.scene();
    let side = if surface.side == Side::Front {
        1.0
    } else {
        -1.0
    };
    let facing = scene.facing_bsdf(surface.material, side)?;
    let (normal, side) = match facing.flipped {
        true => (-surface.outward, Side::Front),
        false => (surface.outward, surface.side),
    };
    let lobe = match scene.material(facing.id).bsdf {
        Plugin::Diffuse { reflectance } => Lobe::Diffuse(Diffuse {
            reflectance: world.lookup(reflectance, &surface.point),
        }),
        _ => unreachable!("resolved to one side; other plugins are refused before"),
    };
    let bsdf = Bsdf::from(lobe).seen_from(side);
    Some(Vertex::new(
        surface.position,
        surface.face_normal,
        normal,
        -direction,
        bsdf,
    ))
}

impl<R: Real> Vertex<R> {
    /// A vertex with the given unit shading normal, seen from the unit direction
    /// `wi`.
    pub fn new(
        position: Vec3<R>,
        face_normal: Vec3,
        normal: Vec3<R>,
        wi: Vec3<R>,
        bsdf: Bsdf<R>,
    ) -> Self {
        let frame = Frame::from_normal(normal);
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
