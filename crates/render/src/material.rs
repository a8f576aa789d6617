//! What a surface does to light at a point: its material with its numbers.

use capwalk_math::{Frame, Real, Rgb, Vec3};
use capwalk_scene::lobe::Event;
use capwalk_scene::resolve::TexturesAt;
use capwalk_scene::{
    Bsdf as Plugin, BsdfId, Integrator, Pattern, Scene, Shape, Texture, TextureId,
};

use crate::accel::Accel;
use crate::vertex::Vertex;
use crate::world::{Surface, World};

/// The vertex of a path at a surface that is seen along `direction`; `None` if
/// the side that is seen is black.
pub fn vertex_at<R: Real, W: World<R>>(
    world: &W,
    accel: &Accel,
    surface: &Surface<R>,
    direction: Vec3<R>,
) -> Option<Vertex<R>> {
    let mut frame = match surface.tangents {
        // As in Mitsuba: the first axis follows the first texture coordinate.
        Some([along_u, _]) => Frame::from_normal_and_tangent(surface.outward, along_u),
        None => Frame::from_normal(surface.outward),
    };
    let textures = &mut Textures {
        world,
        surface,
        frame,
    };
    let resolver = &accel.resolver;
    let resolved = resolver.resolve(accel.scene, surface.material, surface.side, textures);
    resolved.bsdf.lobes().next()?;
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

/// The textures where a surface is met.
struct Textures<'a, R, W> {
    world: &'a W,
    surface: &'a Surface<R>,
    /// The shading frame on the outside.
    frame: Frame<R>,
}

impl<R: Real, W: World<R>> TexturesAt<R> for Textures<'_, R, W> {
    #[inline]
    fn value(&mut self, id: TextureId) -> Rgb<R> {
        self.world.lookup(id, &self.surface.point)
    }
    /// With the position `p(u, v)` and the axes `s` and `t`, where `s` is along
    /// `∂p/∂u`: `h_u = (∂p/∂u·s) h_s` and `h_v = (∂p/∂v·s) h_s + (∂p/∂v·t) h_t`.
    fn gradient(&mut self, id: TextureId) -> [Rgb<R>; 2] {
        let (surface, frame) = (self.surface, &self.frame);
        let Pattern::Bitmap(bitmap) = &self.world.scene().texture(id).pattern else {
            unreachable!("scenes are checked for heights with slopes");
        };
        let Some([along_u, along_v]) = surface.tangents else {
            return [Rgb::zero(); 2]; // texture coordinates that do not span the face
        };
        let [by_u, by_v] = bitmap.gradient(surface.point.uv, |index| self.world.texel(id, index));
        let by_s = by_u / along_u.dot(frame.s);
        let by_t = (by_v - by_s * along_v.dot(frame.s)) / along_v.dot(frame.t);
        [by_s, by_t]
    }
    fn may_change(&self, id: TextureId) -> bool {
        let scene = self.world.scene();
        let shape = scene.shape(self.surface.point.shape);
        let numbers = scene.numbers_of(id, shape);
        self.world.is_asked_for(numbers)
    }
}

/// True if it matters, for the value or a derivative, how a material is turned
/// about the normal.
pub fn needs_tangent(scene: &Scene, id: BsdfId) -> bool {
    any_part(scene, id, |bsdf| {
        matches!(bsdf, Plugin::Principled(_)) || is_anisotropic(scene, bsdf)
    }) || scene.map_in(id).is_some()
}

/// True if it matters where on a face of a shape a ray meets it, besides the
/// position: for interpolated normals, for textures, for layers of these.
pub fn needs_place(scene: &Scene, shape: &Shape) -> bool {
    let mut textures = textures_of(scene, shape).into_iter();
    shape.normals.per_vertex().is_some()
        || textures.any(|texture| !texture.is_constant())
        || matches!(scene.settings.integrator, Integrator::Aov(_))
}

/// True if the value depends on how a material is turned about the normal.
pub fn looks_turned(scene: &Scene, id: BsdfId) -> bool {
    any_part(scene, id, |bsdf| is_anisotropic(scene, bsdf))
}

fn is_anisotropic(scene: &Scene, bsdf: &Plugin) -> bool {
    match bsdf {
        Plugin::RoughConductor(_, facets) | Plugin::RoughDielectric(_, facets) => {
            facets.alpha[0] != facets.alpha[1]
        }
        Plugin::Principled(principled) => {
            let anisotropic = scene.texture(principled.anisotropic);
            let is_attribute = matches!(anisotropic.pattern, Pattern::MeshAttribute { .. });
            is_attribute || anisotropic.data.iter().any(|&x| x != 0.0)
        }
        _ => false,
    }
}

/// True if a plugin reflects in one direction alone; what refracts so does, too.
fn is_mirror(bsdf: &Plugin) -> bool {
    matches!(
        bsdf,
        Plugin::Conductor(_)
            | Plugin::Dielectric(_)
            | Plugin::ThinDielectric(_)
            | Plugin::Plastic(_)
    )
}

/// True if a plugin lets light pass straight on.
fn is_pane(bsdf: &Plugin) -> bool {
    matches!(
        bsdf,
        Plugin::ThinDielectric(_) | Plugin::Mask { .. } | Plugin::Null
    )
}

/// True if a material can reflect, refract or pass light in one direction alone.
pub fn may_be_specular(scene: &Scene, id: BsdfId) -> bool {
    any_part(scene, id, |bsdf| is_mirror(bsdf) || is_pane(bsdf))
}

/// Which perfectly specular events at a shape keep images in shape.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FlatEvents {
    /// Reflection by a plane.
    reflects: bool,
    /// Passing straight on.
    passes: bool,
}

impl FlatEvents {
    /// The events.
    pub fn iter(self) -> impl Iterator<Item = Event> {
        let reflects = self.reflects.then_some(Event::Reflect);
        let passes = self.passes.then_some(Event::Pass);
        reflects.into_iter().chain(passes)
    }

    /// True if the event is one of them.
    pub fn contains(self, event: Event) -> bool {
        self.iter().any(|own| own == event)
    }

    /// True if there are none.
    pub fn is_empty(self) -> bool {
        self.iter().next().is_none()
    }
}

/// Which perfectly specular events at a shape keep images in shape: mirrors must
/// be flat, panes may be bent.
pub fn flat_events(scene: &Scene, shape: &Shape) -> FlatEvents {
    let turns = scene.map_in(shape.bsdf).is_some();
    let is_flat = shape.normals.per_vertex().is_none() && !turns;
    FlatEvents {
        reflects: is_flat && any_part(scene, shape.bsdf, is_mirror),
        passes: any_part(scene, shape.bsdf, is_pane),
    }
}

/// True if something holds for a material, or one that it is made of.
fn any_part(scene: &Scene, id: BsdfId, holds: impl Fn(&Plugin) -> bool) -> bool {
    let mut parts = scene.materials_below(id).into_iter();
    parts.any(|part| holds(&scene.material(part).bsdf))
}

/// How the position on a face of a shape changes with each texture coordinate,
/// for edges from its first corner to the others; `None` without usable texture
/// coordinates.
pub fn tangents_of_face<R: Real>(
    shape: &Shape,
    face: usize,
    edges: [Vec3<R>; 2],
) -> Option<[Vec3<R>; 2]> {
    let [[u0, v0], [u1, v1], [u2, v2]] = shape.uvs.as_ref()?[face];
    let (du1, dv1, du2, dv2) = (u1 - u0, v1 - v0, u2 - u0, v2 - v0);
    let scale = 1.0 / (du1 * dv2 - du2 * dv1);
    let along = |a: f64, b: f64| {
        let [a, b] = [a, b].map(|x| R::constant(x * scale));
        edges[0] * a + edges[1] * b
    };
    let tangents = [along(dv2, -dv1), along(-du2, du1)];
    let are_finite = tangents.iter().all(|tangent| tangent.value().is_finite());
    are_finite.then_some(tangents)
}

/// The textures that decide how a shape looks: those of its materials and of
/// what it emits, attributes in the place of what looks them up.
pub fn textures_of<'s>(scene: &'s Scene, shape: &Shape) -> Vec<&'s Texture> {
    let mut ids: Vec<TextureId> = shape
        .emitter
        .map(|id| scene.emitter(id).radiance())
        .into_iter()
        .collect();
    ids.extend(
        scene
            .slots_below(shape.bsdf)
            .iter()
            .map(|slot| slot.texture),
    );
    let shown = |id| scene.texture(scene.numbers_of(id, shape));
    ids.into_iter().map(shown).collect()
}

#[cfg(test)]
mod tests {
    use capwalk_geometry::Mesh;
    use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
    use capwalk_scene::{ShadingNormals, ShapeId, builtin};

    use super::*;
    use crate::world::{AtRest, surface_at};

    /// On a triangle with skewed texture coordinates, whose heights are a ramp of
    /// them, the gradient along the axes gives the heights of all corners.
    #[test]
    fn gradients_follow_skewed_coordinates() {
        let mut scene = builtin::scene("leaf").expect("built in");
        let corners = [(-3.0, 0.2, 1.0), (2.0, -2.5, 0.3), (1.5, 3.0, -0.4)];
        let corners = corners.map(|(x, y, z)| Vec3::new(x, y, z));
        let mesh = Mesh {
            positions: corners.to_vec(),
            faces: vec![[0, 1, 2]],
        };
        let uvs = [[0.3, 0.3], [0.7, 0.4], [0.4, 0.7]];
        let bsdf = scene.shapes[0].bsdf;
        let mut shape = Shape::new("skewed", mesh, ShadingNormals::Face, bsdf);
        shape.uvs = Some(vec![uvs]);
        scene.shapes = vec![shape];
        scene.emitters.clear();
        // 2 u - 3 v at the centres of 8 x 8 texels.
        let centre = |i: usize| (i as f64 + 0.5) / 8.0;
        let ramp = |i: usize| 2.0 * centre(i % 8) - 3.0 * centre(i / 8);
        let heights = scene.add_texture(Texture {
            id: "ramp".into(),
            channels: 1,
            data: (0..64).map(ramp).collect(),
            pattern: Pattern::Bitmap(Bitmap {
                width: 8,
                height: 8,
                filter: TexelFilter::Bilinear,
                wrap: Wrap::Clamp,
                to_uv: UvTransform::IDENTITY,
            }),
        });
        let mut accel = Accel::new(&scene);
        accel.needs_tangent = vec![true];
        let (origin, down) = (Vec3::new(0.1, 0.2, 4.0), Vec3::new(0.0, 0.0, -1.0));
        let hit = accel.first_hit(origin, down).expect("above the triangle");
        assert_eq!(accel.shape_of(&hit), ShapeId(0));
        let world = AtRest(&accel);
        let surface = surface_at(&world, &accel, &hit, origin, down);
        let [along_u, _] = surface.tangents.expect("texture coordinates");
        let frame = Frame::from_normal_and_tangent(surface.outward, along_u);
        let mut textures = Textures {
            world: &world,
            surface: &surface,
            frame,
        };
        let [by_s, by_t] = textures.gradient(heights).map(|slope| slope.x);
        let rise = |i: usize| 2.0 * (uvs[i][0] - uvs[0][0]) - 3.0 * (uvs[i][1] - uvs[0][1]);
        for i in [1, 2] {
            let way = corners[i] - corners[0];
            let found = by_s * way.dot(frame.s) + by_t * way.dot(frame.t);
            assert!((found - rise(i)).abs() < 1e-12, "{found} {}", rise(i));
        }
    }
}
