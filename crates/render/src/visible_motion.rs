//! The part of a probe that asks from where boundaries are seen to move: along the field around such a
//! viewpoint directions move, also far from what moves (METHOD 6).

use capwalk_boundary::MAX_EVENTS;
use capwalk_geometry::Ray;
use capwalk_math::Vec3;
use capwalk_scene::lobe::Event;

use crate::specular_probe::{Random, SpecularProbe};
use crate::vertex::Vertex;

/// A hit this close to a point, as a part of its distance, is the point.
const NEAR: f64 = 1e-6;
/// Two directions whose cosine is less than 1 by no more than this are the same.
const SAME_DIRECTION: f64 = 1e-9;

impl SpecularProbe<'_> {
    /// True if the camera sees a boundary move, as far as one sample shows.
    pub(crate) fn camera_sees_motion(&self, random: &mut Random) -> bool {
        let accel = self.tracer.accel;
        let view = &accel.view;
        let launch = |point: Vec3| {
            self.film_point_of(view, point)?;
            Some(accel.camera_ray(view.origin, view.towards(point).normalized()))
        };
        self.samples_motion(launch, !view.is_parallel(), random)
    }

    /// True if a point on a surface sees a boundary move, as far as one sample shows.
    pub(crate) fn sees_motion(&self, vertex: &Vertex<f64>, random: &mut Random) -> bool {
        let launch = |point: Vec3| {
            let offset = point - vertex.position;
            let is_before = offset.dot(vertex.face_normal) > 0.0;
            let ray = self
                .tracer
                .accel
                .surface_ray(vertex.position, offset.normalized());
            (is_before || vertex.transmits).then_some(ray)
        };
        self.moves_curves && self.samples_motion(launch, true, random)
    }

    /// Looks at one point of what moves, straight and by a flat mirror if there are any. `launch` is
    /// the ray to a point, if it can be seen there.
    fn samples_motion(
        &self,
        launch: impl Fn(Vec3) -> Option<Ray>,
        by_mirrors: bool,
        random: &mut Random,
    ) -> bool {
        if self.has_shadows {
            return true;
        }
        let Some(point) = self.point_that_moves(random) else {
            return false;
        };
        let straight = launch(point).is_some_and(|ray| self.arrives(ray, point));
        if straight || !by_mirrors || self.flat_mirrors.is_empty() {
            return straight;
        }
        let mirror = &self.flat_mirrors[random.below(self.flat_mirrors.len())];
        let face = mirror.start as usize + random.below(mirror.len());
        self.arrives_by_mirror(launch, face, point)
    }

    /// True if nothing hides a point from where a ray to it starts but what lets light pass straight
    /// on.
    fn arrives(&self, mut ray: Ray, point: Vec3) -> bool {
        let accel = self.tracer.accel;
        for _ in 0..=MAX_EVENTS {
            let distance = (point - ray.origin).length();
            match accel.first_hit_within(&ray) {
                Some(hit) if hit.t < distance * (1.0 - NEAR) => {
                    if !accel.flat_events(&hit).contains(Event::Pass) {
                        return false;
                    }
                    ray = accel.surface_ray(ray.origin + ray.direction * hit.t, ray.direction);
                }
                _ => return true,
            }
        }
        false
    }

    /// The same for the image of the point in the plane of a face.
    fn arrives_by_mirror(
        &self,
        launch: impl Fn(Vec3) -> Option<Ray>,
        face: usize,
        point: Vec3,
    ) -> bool {
        let accel = self.tracer.accel;
        let normal = |face: usize| accel.mesh.face_cross(face).normalized();
        let reflected = |v: Vec3, n: Vec3| v - n * (2.0 * n.dot(v));
        let corner = accel.mesh.corners(face)[0];
        let image = corner + reflected(point - corner, normal(face));
        let Some(ray) = launch(image) else {
            return false;
        };
        let Some(hit) = accel.first_hit_within(&ray) else {
            return false;
        };
        let at = ray.origin + ray.direction * hit.t;
        let onward = reflected(ray.direction, normal(hit.face as usize));
        let leads_to_point = onward.dot((point - at).normalized()) > 1.0 - SAME_DIRECTION;
        let is_mirror = accel.is_flat_mirror(accel.shape_of(&hit));
        is_mirror && leads_to_point && self.arrives(accel.surface_ray(at, onward), point)
    }
}
