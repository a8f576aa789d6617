//! What a surface does to light at a point: its material with its numbers.

use capwalk_math::{Frame, Real, Vec3};
use capwalk_scene::Bsdf as Plugin;
use capwalk_scene::lobe::{Bsdf, Diffuse, Lobe, Side};

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
            reflectance: world.texel(reflectance, 0),
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
