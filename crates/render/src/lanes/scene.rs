//! What of a scene lanes need, and which scenes allow them.

use capwalk_boundary::{Accel, tangents_of_face};
use capwalk_math::{Rgb, Vec3};
use capwalk_scene::lobe::{Diffuse, Lobe, Side};
use capwalk_scene::resolve::Constants;
use capwalk_scene::{Bsdf, BsdfId, Emitter, Scene, Shape, ShapeId, SurfacePoint, TextureId};

use crate::emitter_sampler::DirectionSampler;
use crate::lanes::lobes::{Lobes, Turned};
use crate::lanes::step::Vertices;
use crate::prepared::PreparedScene;
use crate::rectangle_sampler::RectangleSampler;
use crate::triangle_sampler::Node;

/// No face.
pub const NOTHING: u32 = u32::MAX;

/// A scene of one rectangle that emits, and surfaces whose lobes are the same all over them, or
/// that are diffuse.
pub struct LaneScene<'a> {
    accel: &'a Accel,
    faces: Vec<Face>,
    shapes: Vec<ShapeOfLanes>,
    /// The rectangle, its shape, and its radiance.
    pub rectangle: &'a RectangleSampler,
    emitter: ShapeId,
    /// All its triangles.
    pub triangles: &'a Node,
    pub radiance: Rgb,
}

/// A face.
struct Face {
    corner: Vec3,
    /// Unit normal by its winding.
    normal: Vec3,
    /// Along the first texture coordinate, if the material turns with it.
    tangent: Option<Vec3>,
    /// The gradients of the weights of the second and third corner: their inner products with the
    /// offset from the first are the weights.
    weights: [Vec3; 2],
    shape: ShapeId,
}

impl Face {
    fn of(accel: &Accel, face: usize) -> Self {
        let shape = accel.shape_of_face[face];
        let place = shape.0 as usize;
        let [a, b, c] = accel.mesh.corners(face);
        let tangents = || {
            let own = face - accel.first_face[place] as usize;
            tangents_of_face(accel.scene.shape(shape), own, [b - a, c - a])
        };
        let turns = accel.needs_tangent[place];
        let cross = accel.mesh.face_cross(face);
        let weights = [(c - a).cross(cross), cross.cross(b - a)];
        Self {
            corner: a,
            normal: cross.normalized(),
            weights: weights.map(|weight| weight / cross.length_squared()),
            tangent: turns.then(tangents).flatten().map(|[along_u, _]| along_u),
            shape,
        }
    }

    /// Weights of the corners at a point of its plane.
    fn barycentric(&self, position: Vec3) -> [f64; 3] {
        let offset = position - self.corner;
        let [wb, wc] = self.weights.map(|weight| weight.dot(offset));
        [1.0 - wb - wc, wb, wc]
    }
}

/// What a shape's sides scatter: the one that its normal points to, and the other.
struct ShapeOfLanes {
    sides: [Option<Scattering>; 2],
    has_normals: bool,
}

/// What a side of a surface does to light.
enum Scattering {
    /// It reflects a fraction diffusely.
    Diffuse(Rgb),
    /// The fraction is that of a texture.
    Textured(TextureId),
    /// It has other lobes.
    Lobes(Box<Lobes>),
}

impl<'a> LaneScene<'a> {
    /// `None` if the scene does not allow it.
    pub fn of(prepared: &'a PreparedScene) -> Option<Self> {
        let accel = prepared.accel();
        let scene: &Scene = &accel.scene;
        let ([emitter], [sampler]) = (&scene.emitters[..], prepared.emitters()) else {
            return None;
        };
        let (Emitter::Area { shape, radiance }, DirectionSampler::Area(triangles)) =
            (emitter, &sampler.directions)
        else {
            return None;
        };
        let texture = scene.texture(*radiance);
        let rectangle = triangles.rectangle().filter(|_| texture.is_constant())?;
        let shapes: Option<Vec<_>> = scene
            .shapes
            .iter()
            .enumerate()
            .map(|(i, shape)| {
                Some(ShapeOfLanes {
                    sides: sides(accel, shape, accel.needs_tangent[i])?,
                    has_normals: shape.normals.per_vertex().is_some(),
                })
            })
            .collect();
        let faces = (0..accel.mesh.faces.len()).map(|face| Face::of(accel, face));
        let mut ids = (0..).map(ShapeId).zip(&scene.shapes);
        let is_only_one = ids.all(|(id, other)| other.emitter.is_some() == (id == *shape));
        let shapes = shapes.filter(|_| is_only_one)?;
        Some(Self {
            accel,
            shapes,
            faces: faces.collect(),
            rectangle,
            emitter: *shape,
            triangles: triangles.root(),
            radiance: texture.texel(0),
        })
    }

    /// How far the box around the nearest face is from a point, at least.
    pub fn distance(&self, point: Vec3) -> f64 {
        let faces = 0..self.faces.len();
        let distances = faces.map(|face| {
            let [a, b, c] = self.accel.mesh.corners(face);
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            (point - point.max(low).min(high)).length()
        });
        distances.fold(f64::INFINITY, f64::min)
    }

    /// True if a ray that hits a face sees it emit.
    #[inline]
    pub fn emits(&self, face: u32, direction: Vec3) -> bool {
        face != NOTHING && {
            let face = &self.faces[face as usize];
            face.shape == self.emitter && face.normal.dot(direction) < 0.0
        }
    }

    /// Looks up where the plane of the face is that a path hits.
    #[inline]
    pub fn set_plane(&self, face: u32, lane: usize, vertices: &mut Vertices) {
        let Face { corner, normal, .. } = self.faces[face as usize];
        vertices.corner.set(lane, corner);
        vertices.face_normal.set(lane, normal);
    }

    /// Looks up what the face scatters that a path hits, where its position is known; `None` if
    /// nothing, else what does if it is not diffuse.
    #[inline]
    pub fn look_up(
        &self,
        face: u32,
        lane: usize,
        vertices: &mut Vertices,
    ) -> Option<Option<Turned<'_>>> {
        let found = &self.faces[face as usize];
        let shape = &self.shapes[found.shape.0 as usize];
        let barycentric = || found.barycentric(vertices.position.get(lane));
        let (outward, out) = match shape.has_normals {
            false => (found.normal, 1.0),
            true => self.normal(face, found, barycentric()),
        };
        let (place, side) = if vertices.seen[lane] * out > 0.0 {
            (0, 1.0)
        } else {
            (1, -1.0)
        };
        let (side, albedo, lobes) = match shape.sides[place].as_ref()? {
            Scattering::Diffuse(albedo) => (side, *albedo, None),
            Scattering::Textured(id) => (side, self.texture(*id, face, found, barycentric()), None),
            Scattering::Lobes(lobes) => {
                let tangent = found.tangent;
                (lobes.front, Rgb::zero(), Some(Turned { lobes, tangent }))
            }
        };
        vertices.outward.set(lane, outward);
        vertices.side[lane] = side;
        vertices.scattered.set_colour(lane, albedo);
        Some(lobes)
    }

    /// The interpolated normal, and 1 or -1 for whether the face's own points out.
    fn normal(&self, face: u32, found: &Face, [wa, wb, wc]: [f64; 3]) -> (Vec3, f64) {
        let shape = self.accel.scene.shape(found.shape);
        let normals = shape.normals.per_vertex().expect("it has normals");
        let first = self.accel.first_vertex[found.shape.0 as usize];
        let corners = self.accel.mesh.faces[face as usize];
        let [a, b, c] = corners.map(|i| normals[(i - first) as usize]);
        let out = (a + b + c).dot(found.normal).signum();
        ((a * wa + b * wb + c * wc).normalized(), out)
    }

    fn texture(&self, id: TextureId, face: u32, found: &Face, barycentric: [f64; 3]) -> Rgb {
        let scene = &self.accel.scene;
        let shape = scene.shape(found.shape);
        let face = (face - self.accel.first_face[found.shape.0 as usize]) as usize;
        let point = SurfacePoint {
            shape: found.shape,
            face,
            barycentric,
            uv: shape.uv(face, barycentric),
        };
        let texel = |id, index| scene.texture(id).texel(index);
        scene.lookup(id, &point, texel)
    }
}

/// What the sides of a shape do to light; `None` if that changes along them, but for the texture
/// of what is diffuse. `turns` if the material turns with texture coordinates.
fn sides(accel: &Accel, shape: &Shape, turns: bool) -> Option<[Option<Scattering>; 2]> {
    let scene: &Scene = &accel.scene;
    let slots = scene.slots_below(shape.bsdf);
    let mut textures = slots.iter().map(|slot| scene.texture(slot.texture));
    if !textures.all(|texture| texture.is_constant()) {
        return textured(scene, shape.bsdf);
    }
    Some([Side::Front, Side::Back].map(|side| {
        let resolver = &accel.resolver;
        let resolved = resolver.resolve(scene, shape.bsdf, side, &mut Constants(scene));
        let lobes: Vec<_> = resolved.bsdf.lobes().collect();
        match lobes[..] {
            [] => None,
            [(1.0, Lobe::Diffuse(lobe))] if !turns => Some(Scattering::Diffuse(lobe.reflectance)),
            _ => Some(Scattering::Lobes(Box::new(Lobes::new(resolved)))),
        }
    }))
}

/// What both sides of a material reflect, if it is diffuse.
fn textured(scene: &Scene, id: BsdfId) -> Option<[Option<Scattering>; 2]> {
    let side = |id: BsdfId| match &scene.material(id).bsdf {
        Bsdf::Plain(Lobe::Diffuse(Diffuse { reflectance })) => {
            let texture = scene.texture(*reflectance);
            Some(match texture.is_constant() {
                true => Scattering::Diffuse(texture.texel(0)),
                false => Scattering::Textured(*reflectance),
            })
        }
        _ => None,
    };
    match &scene.material(id).bsdf {
        Bsdf::TwoSided { front, back } => Some([Some(side(*front)?), Some(side(*back)?)]),
        _ => Some([Some(side(id)?), None]),
    }
}
