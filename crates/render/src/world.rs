//! The numbers of a scene, with or without their derivatives: the same code
//! evaluates a path and its derivative by asking one [`World`] or the other.

use capwalk_geometry::Hit;
use capwalk_math::{Affine, Dual, Real, Rgb, Vec3};
use capwalk_scene::{Bsdf, BsdfId, EmitterId, Motion, Scene, TextureId};

use crate::accel::Accel;

/// What a path reads of a scene.
pub trait World<R: Real> {
    /// Position of a vertex of the joined mesh.
    fn vertex(&self, index: u32) -> Vec3<R>;
    /// Unit shading normal of a vertex of a shape with vertex normals.
    fn normal(&self, shape: usize, vertex: u32) -> Vec3<R>;
    /// The scene whose numbers they are.
    fn scene(&self) -> &Scene;
    /// A texel of a texture.
    fn texel(&self, id: TextureId, index: usize) -> Rgb<R>;
    /// The camera-space direction of a world-space one.
    fn camera_direction(&self, direction: Vec3<R>) -> Vec3<R>;
    /// Where the sensor stands.
    fn sensor_origin(&self) -> Vec3<R>;

    /// Reflectance of a diffuse material.
    #[inline]
    fn reflectance(&self, id: BsdfId) -> Rgb<R> {
        match self.scene().material(id).bsdf {
            Bsdf::Diffuse { reflectance } => self.texel(reflectance, 0),
            Bsdf::TwoSided { .. } => unreachable!("a hit's material has been resolved to one side"),
        }
    }

    /// Radiance of an emitter.
    #[inline]
    fn radiance(&self, id: EmitterId) -> Rgb<R> {
        self.texel(self.scene().emitter(id).radiance(), 0)
    }
}

/// The scene as it is.
pub struct AtRest<'a>(pub &'a Accel<'a>);

/// The scene moving along a [`Motion`]: values with one derivative.
pub struct InMotion<'a> {
    accel: &'a Accel<'a>,
    motion: &'a Motion,
    /// Velocity of every vertex of the joined mesh.
    pub vertices: Vec<Vec3>,
    /// Velocities of each shape's shading normals, where it has any.
    normals: Vec<Option<Vec<Vec3>>>,
}

/// A number and its derivative by the parameter.
pub type D = Dual<1>;

impl<'a> InMotion<'a> {
    /// The velocities of everything; shapes at rest get zeros.
    pub fn new(accel: &'a Accel<'a>, motion: &'a Motion) -> Self {
        let scene = accel.scene;
        let mut vertices = vec![Vec3::zero(); accel.mesh.positions.len()];
        for (shape, &first) in motion.shapes.iter().zip(&accel.first_vertex) {
            if let Some(shape) = shape {
                let first = first as usize;
                vertices[first..first + shape.vertices.len()].copy_from_slice(&shape.vertices);
            }
        }
        let normals = (0..scene.shapes.len())
            .map(|shape| scene.normal_velocities(motion, shape))
            .collect();
        Self {
            accel,
            motion,
            vertices,
            normals,
        }
    }
}

impl World<f64> for AtRest<'_> {
    #[inline]
    fn vertex(&self, index: u32) -> Vec3 {
        self.0.mesh.positions[index as usize]
    }
    #[inline]
    fn normal(&self, shape: usize, vertex: u32) -> Vec3 {
        vertex_normal(self.0.scene, shape, vertex)
    }
    #[inline]
    fn scene(&self) -> &Scene {
        self.0.scene
    }
    #[inline]
    fn texel(&self, id: TextureId, index: usize) -> Rgb {
        self.0.scene.texture(id).texel(index)
    }
    #[inline]
    fn camera_direction(&self, direction: Vec3) -> Vec3 {
        camera_from_world(&self.0.scene.sensor.world_from_camera, direction)
    }
    #[inline]
    fn sensor_origin(&self) -> Vec3 {
        self.0.scene.sensor.origin()
    }
}

impl World<D> for InMotion<'_> {
    #[inline]
    fn vertex(&self, index: u32) -> Vec3<D> {
        let index = index as usize;
        self.accel.mesh.positions[index].with_tangent(self.vertices[index])
    }
    #[inline]
    fn normal(&self, shape: usize, vertex: u32) -> Vec3<D> {
        let velocity = match &self.normals[shape] {
            Some(velocities) => velocities[vertex as usize],
            None => Vec3::zero(),
        };
        vertex_normal(self.accel.scene, shape, vertex).with_tangent(velocity)
    }
    #[inline]
    fn scene(&self) -> &Scene {
        self.accel.scene
    }
    #[inline]
    fn texel(&self, id: TextureId, index: usize) -> Rgb<D> {
        let scene = self.accel.scene;
        let velocity = self.motion.texel(scene, id, index);
        scene.texture(id).texel(index).with_tangent(velocity)
    }
    #[inline]
    fn camera_direction(&self, direction: Vec3<D>) -> Vec3<D> {
        // d/dθ (Rᵀ q) = Rᵀ (q̇ - ω × q): turning the camera to the left shows
        // what lies to the left.
        let (q, velocity) = (direction.value(), direction.tangent(0));
        let seen = velocity - self.motion.sensor.rotation.cross(q);
        let sensor = &self.accel.scene.sensor.world_from_camera;
        camera_from_world(sensor, q).with_tangent(camera_from_world(sensor, seen))
    }
    #[inline]
    fn sensor_origin(&self) -> Vec3<D> {
        let origin = self.accel.scene.sensor.origin();
        origin.with_tangent(self.motion.sensor.translation)
    }
}

fn vertex_normal(scene: &Scene, shape: usize, vertex: u32) -> Vec3 {
    let normals = scene.shapes[shape].normals.per_vertex();
    normals.expect("asked only of shapes with vertex normals")[vertex as usize]
}

/// The transpose of a rotation is its inverse.
fn camera_from_world(world_from_camera: &Affine, v: Vec3) -> Vec3 {
    let [a, b, c] = world_from_camera.rows;
    a * v.x + b * v.y + c * v.z
}

/// Where a (moving) ray meets the (moving) surface that it hits.
#[derive(Clone, Copy, Debug)]
pub struct Surface<R> {
    /// The hit point.
    pub position: Vec3<R>,
    /// Unit shading normal on the viewer's side.
    pub normal: Vec3<R>,
    /// Unit geometric normal on the viewer's side.
    pub face_normal: Vec3,
    /// The diffuse material of that side, or `None` if it is black.
    pub bsdf: Option<BsdfId>,
}

impl<R: Real> Surface<R> {
    /// The surface without its derivative.
    pub fn value(&self) -> Surface<f64> {
        Surface {
            position: self.position.value(),
            normal: self.normal.value(),
            face_normal: self.face_normal,
            bsdf: self.bsdf,
        }
    }
}

/// The surface at a hit of the ray from `origin` along `direction`. Which
/// side is seen is decided by the face, not by the interpolated normal: the
/// latter would end the material along a curve inside faces, where no edge
/// is.
pub fn surface_at<R: Real, W: World<R>>(
    world: &W,
    accel: &Accel,
    hit: &Hit,
    origin: Vec3<R>,
    direction: Vec3<R>,
) -> Surface<R> {
    let scene = accel.scene;
    let shape_id = accel.shape_of(hit);
    let shape = scene.shape(shape_id);
    let corners = accel.mesh.faces[hit.face as usize];
    let [a, b, c] = corners.map(|i| world.vertex(i));
    let (edge1, edge2) = (b - a, c - a);
    let cross = edge1.cross(edge2);

    // The ray meets the plane of the triangle, both moving.
    let t = (a - origin).dot(cross) / direction.dot(cross);
    let position = origin + direction * t;

    let face_normal = cross.value().normalized();
    let seen = if face_normal.dot(direction.value()) > 0.0 {
        -1.0
    } else {
        1.0
    };
    // Normals given with a mesh say which side of a face is out, even against
    // its winding; all three together, so that it is the same all over it.
    let (outward, out) = match shape.normals.per_vertex() {
        None => (cross.normalized(), 1.0),
        Some(_) => {
            // Barycentric weights by the areas opposite to the corners.
            let offset = position - a;
            let scale = R::constant(1.0) / cross.length_squared();
            let wb = offset.cross(edge2).dot(cross) * scale;
            let wc = edge1.cross(offset).dot(cross) * scale;
            let first = accel.first_vertex[shape_id.0 as usize];
            let [na, nb, nc] = corners.map(|i| world.normal(shape_id.0 as usize, i - first));
            let out = (na + nb + nc).value().dot(face_normal).signum();
            let normal = (na + (nb - na) * wb + (nc - na) * wc).normalized();
            (normal, out)
        }
    };
    let facing = seen * out;
    let bsdf = scene.facing_bsdf(shape.bsdf, facing);
    Surface {
        position,
        normal: outward * R::constant(facing),
        face_normal: face_normal * seen,
        bsdf: bsdf.map(|facing| facing.id),
    }
}
