//! The vertex of a path at a surface: its material, evaluated at a point.

use capwalk_boundary::Accel;
use capwalk_math::{Frame, Real, Rgb, Vec3};
use capwalk_scene::resolve::TexturesAt;
use capwalk_scene::{Pattern, SurfacePoint, TextureId};

use crate::scene_eval::SceneEval;
use crate::surface::Surface;
use crate::vertex::Vertex;

/// The vertex of a path that hits a surface along `direction`; `None` if the side that it
/// hits reflects and transmits nothing.
pub fn vertex_at<R: Real, W: SceneEval<R>>(
    eval: &W,
    accel: &Accel,
    surface: &Surface<R>,
    direction: Vec3<R>,
) -> Option<Vertex<R>> {
    let mut vertex = black_vertex_at(surface, direction);
    add_lobes(eval, accel, surface, &mut vertex).then_some(vertex)
}

/// The vertex at a surface, without its lobes.
#[inline]
pub fn black_vertex_at<R: Real>(surface: &Surface<R>, direction: Vec3<R>) -> Vertex<R> {
    let frame = match surface.tangents {
        // As in Mitsuba: the first axis follows the first texture coordinate.
        Some([along_u, _]) => Frame::from_normal_and_tangent(surface.outward, along_u),
        None => Frame::from_normal(surface.outward),
    };
    Vertex::black(
        surface.position,
        surface.face,
        surface.face_normal,
        frame,
        -direction,
    )
}

/// Adds them, in its place: they are large, and copying them takes as long as finding them.
/// False if there are none.
pub fn add_lobes<R: Real, W: SceneEval<R>>(
    eval: &W,
    accel: &Accel,
    surface: &Surface<R>,
    vertex: &mut Vertex<R>,
) -> bool {
    let textures = &mut Textures {
        eval,
        is_asked_for: &|id| eval.is_asked_for(id),
        point: &surface.point,
        tangents: surface.tangents,
        frame: vertex.frame,
    };
    let (resolver, scene) = (&accel.resolver, &accel.scene);
    let bsdf = &mut vertex.bsdf;
    let flipped = resolver.resolve_into(scene, surface.material, surface.side, textures, bsdf);
    if bsdf.lobes().next().is_none() {
        return false;
    }
    if W::MOVES {
        bsdf.explore();
    }
    vertex.transmits = bsdf.transmits();
    if flipped {
        vertex.turn_over();
    }
    true
}

/// The textures at a point of a surface.
pub struct Textures<'a, R, W> {
    /// The numbers of the scene.
    pub eval: &'a W,
    /// True for a texture with respect to whose texels derivatives are asked for.
    pub is_asked_for: &'a dyn Fn(TextureId) -> bool,
    /// The point on the shape.
    pub point: &'a SurfacePoint<R>,
    /// Derivatives of the position with respect to the texture coordinates, if they span the face.
    pub tangents: Option<[Vec3<R>; 2]>,
    /// The shading frame on the outside.
    pub frame: Frame<R>,
}

impl<R: Real, W: SceneEval<R>> TexturesAt<R> for Textures<'_, R, W> {
    #[inline]
    fn value(&mut self, id: TextureId) -> Rgb<R> {
        self.eval.lookup(id, self.point)
    }
    /// With the position `p(u, v)` and the axes `s` and `t`, where `s` is along
    /// `∂p/∂u`: `h_u = (∂p/∂u·s) h_s` and `h_v = (∂p/∂v·s) h_s + (∂p/∂v·t) h_t`.
    fn gradient(&mut self, id: TextureId) -> [Rgb<R>; 2] {
        let frame = &self.frame;
        let Pattern::Bitmap(bitmap) = &self.eval.scene().texture(id).pattern else {
            unreachable!("scenes are checked for heights with slopes");
        };
        let Some([along_u, along_v]) = self.tangents else {
            return [Rgb::zero(); 2]; // texture coordinates that do not span the face
        };
        let [by_u, by_v] = bitmap.gradient(self.point.uv, |index| self.eval.texel(id, index));
        let by_s = by_u / along_u.dot(frame.s);
        let by_t = (by_v - by_s * along_v.dot(frame.s)) / along_v.dot(frame.t);
        [by_s, by_t]
    }
    fn may_change(&self, id: TextureId) -> bool {
        let scene = self.eval.scene();
        let shape = scene.shape(self.point.shape);
        let numbers = scene.numbers_of(id, shape);
        (self.is_asked_for)(numbers)
    }
}

#[cfg(test)]
mod tests {
    use capwalk_geometry::Mesh;
    use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
    use capwalk_scene::{ShadingNormals, Shape, ShapeId, Texture, builtin};

    use super::*;
    use crate::scene_eval::Primal;
    use crate::surface::surface_at;

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
        scene.shapes = vec![shape.into()];
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
        let mut accel = Accel::new(scene.clone());
        accel.needs_tangent = vec![true];
        let (origin, down) = (Vec3::new(0.1, 0.2, 4.0), Vec3::new(0.0, 0.0, -1.0));
        let hit = accel.first_hit(origin, down).expect("above the triangle");
        assert_eq!(accel.shape_of(&hit), ShapeId(0));
        let eval = Primal(&accel);
        let surface = surface_at(&eval, &accel, &hit, origin, down);
        let [along_u, _] = surface.tangents.expect("texture coordinates");
        let frame = Frame::from_normal_and_tangent(surface.outward, along_u);
        let mut textures = Textures {
            eval: &eval,
            is_asked_for: &|_| false,
            point: &surface.point,
            tangents: surface.tangents,
            frame,
        };
        let [by_s, by_t] = textures.gradient(heights).map(|slope| slope.r);
        let rise = |i: usize| 2.0 * (uvs[i][0] - uvs[0][0]) - 3.0 * (uvs[i][1] - uvs[0][1]);
        for i in [1, 2] {
            let way = corners[i] - corners[0];
            let found = by_s * way.dot(frame.s) + by_t * way.dot(frame.t);
            assert!((found - rise(i)).abs() < 1e-12, "{found} {}", rise(i));
        }
    }
}
