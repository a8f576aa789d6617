//! The scene in motion: values with one derivative, for forward mode.

use capwalk_math::{Dual, Rgb, Vec3};
use capwalk_scene::sensor::SensorState;
use capwalk_scene::{Motion, Scene, TextureId};
use capwalk_walk::WalkSettings;

use crate::accel::Accel;
use crate::world::{Carried, World, vertex_normal};

use super::boundary::{Eye, Field, Numbers, Site};
use super::flow::Source;

/// A number and its derivative by the parameter.
pub type D = Dual<1>;

/// The scene moving along a [`Motion`].
pub struct InMotion<'a> {
    accel: &'a Accel<'a>,
    field: &'a Field<'a>,
    motion: &'a Motion,
    /// Velocity of every point of the boundaries: the vertices of the joined
    /// mesh, then the ends of crossings.
    points: Vec<Vec3>,
    /// Velocities of each shape's shading normals, where it has any.
    normals: Vec<Option<Vec<Vec3>>>,
    boundaries_move: bool,
}

impl<'a> InMotion<'a> {
    /// The velocities of everything; shapes at rest get zeros.
    pub fn new(accel: &'a Accel<'a>, field: &'a Field<'a>, motion: &'a Motion) -> Self {
        let mut points = vec![Vec3::zero(); accel.mesh.positions.len()];
        for (shape, &first) in motion.shapes.iter().zip(&accel.first_vertex) {
            if let Some(shape) = shape {
                let first = first as usize;
                points[first..first + shape.vertices.len()].copy_from_slice(&shape.vertices);
            }
        }
        let crossings = field.boundaries.crossings.iter();
        let ends: Vec<Vec3> = crossings
            .flat_map(|crossing| crossing.ends.map(|end| end.velocity(&points)))
            .collect();
        points.extend(ends);
        let normals = (0..accel.scene.shapes.len())
            .map(|shape| accel.scene.normal_velocities(motion, shape))
            .collect();
        Self {
            accel,
            field,
            motion,
            boundaries_move: points.iter().any(|&v| v != Vec3::zero()),
            points,
            normals,
        }
    }

    /// Angular velocity of a boundary point seen from the eye.
    fn angular(&self, eye: &Eye<D>, site: &Site) -> Vec3 {
        let [a, b] = site.points.map(|i| self.points[i as usize]);
        let mut velocity = a + (b - a) * site.t;
        if !site.mirrors.is_empty() {
            let corner = |i: u32| self.points[i as usize];
            let (mesh, point) = (&self.accel.mesh, self.field.position(site));
            velocity = site.mirrors.velocity(mesh, point, velocity, corner);
        }
        for (vector, share) in eye.vectors().iter().zip(site.shares()) {
            velocity += vector.tangent(0) * -share;
        }
        self.field.seen_velocity(site, velocity)
    }
}

impl World<D> for InMotion<'_> {
    const MOVES: bool = true;
    #[inline]
    fn vertex(&self, index: u32) -> Vec3<D> {
        let index = index as usize;
        self.accel.mesh.positions[index].with_tangent(self.points[index])
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
    fn is_asked_for(&self, id: TextureId) -> bool {
        self.motion.textures[id.0 as usize].is_some()
    }
    #[inline]
    fn sensor(&self) -> SensorState<D> {
        self.accel.scene.sensor.moving_state(&self.motion.sensor)
    }
    #[inline]
    fn boundary_point(&self, index: u32) -> Vec3<D> {
        let position = self.field.boundaries.position(index);
        position.with_tangent(self.points[index as usize])
    }
    #[inline]
    fn is_still(&self, eye: &Eye<D>) -> bool {
        let moves = |v: &Vec3<D>| v.tangent(0) != Vec3::zero();
        !self.boundaries_move && !eye.vectors().iter().any(moves)
    }
    #[inline]
    fn moves(&self) -> bool {
        self.boundaries_move || self.motion.sensor.moves_rays()
    }
    fn carry(&self, eye: &Eye<D>, q: Vec3, walk: &WalkSettings, numbers: Numbers) -> Carried<D> {
        if self.is_still(eye) {
            return Carried::at_rest(q);
        }
        if let Some(flow) = self.field.flow(eye, q, walk, numbers) {
            let (mean, divergence) = flow.evaluate(|source| match source {
                Source::Point(i) => self.points[i as usize],
                Source::Eye => eye.position.tangent(0),
            });
            return Carried {
                direction: q.with_tangent(mean.reject_from(q)),
                stretch: Dual::new(1.0, [divergence]),
                near_boundary: true,
            };
        }
        let sites = self.field.sample(eye, q, walk, numbers);
        let (mean, divergence) = sites.evaluate(|site| self.angular(eye, site));
        Carried {
            direction: q.with_tangent(mean.reject_from(q)),
            stretch: Dual::new(1.0, [divergence]),
            near_boundary: !sites.is_zero(),
        }
    }
    fn carry_value(&self, eye: &Eye<D>, q: Vec3, walk: &WalkSettings, numbers: Numbers) -> Vec3<D> {
        if self.is_still(eye) {
            return Vec3::constant(q);
        }
        if self.field.has_flow() {
            return self.carry(eye, q, walk, numbers).direction;
        }
        let velocity = match self.field.sample_value(eye, q, walk, numbers) {
            None => Vec3::zero(),
            Some(site) => self.angular(eye, &site).reject_from(q),
        };
        q.with_tangent(velocity)
    }
}
