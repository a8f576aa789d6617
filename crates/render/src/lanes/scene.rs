//! What of a scene eight paths need, and which scenes allow them.

use capwalk_boundary::Accel;
use capwalk_math::{Rgb, Vec3};
use capwalk_scene::{Bsdf, BsdfId, Emitter, Scene, ShapeId, SurfacePoint, TextureId};

use crate::emitter_sampler::DirectionSampler;
use crate::lanes::step::Vertices;
use crate::light::NARROW;
use crate::prepared::PreparedScene;
use crate::rectangle_sampler::RectangleSampler;
use crate::triangle_sampler::TriangleSampler;

/// No face.
pub const NOTHING: u32 = u32::MAX;

/// A scene of diffuse surfaces, and one rectangle that emits.
pub struct LaneScene<'a> {
    accel: &'a Accel,
    faces: Vec<Face>,
    shapes: Vec<ShapeOfLanes>,
    /// The rectangle, its shape, and its radiance.
    pub rectangle: &'a RectangleSampler,
    triangles: &'a TriangleSampler,
    emitter: ShapeId,
    pub radiance: Rgb,
}

/// A face.
struct Face {
    corner: Vec3,
    /// Unit normal by its winding.
    normal: Vec3,
    shape: ShapeId,
}

/// What a shape's sides reflect.
struct ShapeOfLanes {
    front: Option<Albedo>,
    back: Option<Albedo>,
    has_normals: bool,
}

/// A fraction of light.
#[derive(Clone, Copy)]
enum Albedo {
    Constant(Rgb),
    Texture(TextureId),
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
            .map(|shape| {
                let [front, back] = albedos(scene, shape.bsdf)?;
                Some(ShapeOfLanes {
                    front,
                    back,
                    has_normals: shape.normals.per_vertex().is_some(),
                })
            })
            .collect();
        let faces = accel.mesh.faces.len();
        let faces = (0..faces).map(|face| Face {
            corner: accel.mesh.corners(face)[0],
            normal: accel.mesh.face_cross(face).normalized(),
            shape: accel.shape_of_face[face],
        });
        let mut ids = (0..).map(ShapeId).zip(&scene.shapes);
        let is_only_one = ids.all(|(id, other)| other.emitter.is_some() == (id == *shape));
        let shapes = shapes.filter(|_| is_only_one)?;
        Some(Self {
            accel,
            shapes,
            faces: faces.collect(),
            rectangle,
            triangles,
            emitter: *shape,
            radiance: texture.texel(0),
        })
    }

    /// True if the emitter is so narrow, seen from a point, that points on it are enough.
    pub fn is_narrow(&self, position: Vec3) -> bool {
        self.triangles.solid_angle(position) < NARROW
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

    /// Looks up the face that a path hits; false if it reflects nothing.
    #[inline]
    pub fn look_up(&self, face: u32, lane: usize, vertices: &mut Vertices) -> bool {
        let found = &self.faces[face as usize];
        let shape = &self.shapes[found.shape.0 as usize];
        let direction = vertices.direction.get(lane);
        let seen = if found.normal.dot(direction) > 0.0 {
            -1.0
        } else {
            1.0
        };
        let needs_place = shape.has_normals
            || matches!(shape.front, Some(Albedo::Texture(_)))
            || matches!(shape.back, Some(Albedo::Texture(_)));
        let barycentric = match needs_place {
            true => self.barycentric(face, found, vertices.origin.get(lane), direction),
            false => [1.0, 0.0, 0.0],
        };
        let (outward, out) = match shape.has_normals {
            false => (found.normal, 1.0),
            true => self.normal(face, found, barycentric),
        };
        let (side, albedo) = match seen * out > 0.0 {
            true => (1.0, shape.front),
            false => (-1.0, shape.back),
        };
        let Some(albedo) = albedo else {
            return false;
        };
        let albedo = match albedo {
            Albedo::Constant(albedo) => albedo,
            Albedo::Texture(id) => self.texture(id, face, found, barycentric),
        };
        vertices.corner.set(lane, found.corner);
        vertices.face_normal.set(lane, found.normal);
        vertices.outward.set(lane, outward);
        vertices.side[lane] = side;
        vertices.albedo.set_colour(lane, albedo);
        true
    }

    /// Weights of the corners where a ray meets the plane of a face.
    fn barycentric(&self, face: u32, found: &Face, origin: Vec3, direction: Vec3) -> [f64; 3] {
        let [a, b, c] = self.accel.mesh.corners(face as usize);
        let t = (a - origin).dot(found.normal) / direction.dot(found.normal);
        let offset = origin + direction * t - a;
        let (second, third) = (b - a, c - a);
        let cross = second.cross(third);
        let scale = 1.0 / cross.length_squared();
        let wb = offset.cross(third).dot(cross) * scale;
        let wc = second.cross(offset).dot(cross) * scale;
        [1.0 - wb - wc, wb, wc]
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

/// What both sides of a material reflect, if it is diffuse.
fn albedos(scene: &Scene, id: BsdfId) -> Option<[Option<Albedo>; 2]> {
    let front_of = |id: BsdfId| match &scene.material(id).bsdf {
        Bsdf::Diffuse { reflectance } => {
            let texture = scene.texture(*reflectance);
            Some(match texture.is_constant() {
                true => Albedo::Constant(texture.texel(0)),
                false => Albedo::Texture(*reflectance),
            })
        }
        _ => None,
    };
    match &scene.material(id).bsdf {
        Bsdf::TwoSided { front, back } => Some([Some(front_of(*front)?), Some(front_of(*back)?)]),
        _ => Some([Some(front_of(id)?), None]),
    }
}
