//! The velocity fields around all viewpoints of a scene, as linear maps from the
//! velocities of its vertices.

use capwalk_geometry::SilhouettePoint;
use capwalk_math::{Real, Vec3};

use crate::accel::Accel;
use crate::boundaries::Boundaries;
use crate::boundary_sample::{BoundarySample, Seen};
use crate::method::Method;
use crate::mirror::Mirrors;
use crate::viewpoint::Viewpoint;

/// The fields around all viewpoints of a scene.
#[derive(Clone, Copy)]
pub struct Field<'a> {
    /// The scene.
    pub accel: &'a Accel,
    /// Its boundaries.
    pub boundaries: &'a Boundaries,
    /// The estimator.
    pub method: Method,
}

impl<'a> Field<'a> {
    /// The sine of the height over the horizon of a face from which on all of a boundary's motion
    /// counts. Any is unbiased.
    pub const LOW: f64 = 0.2;

    /// Edges are seen end-on if they look shorter than this part of their length: the direction in
    /// which they run is rounding.
    pub const END_ON: f64 = 1e-9;

    /// The fields of a scene with the given boundaries.
    pub fn new(accel: &'a Accel, boundaries: &'a Boundaries, method: Method) -> Self {
        Self {
            accel,
            boundaries,
            method,
        }
    }

    /// A boundary point as a linear map from velocities. What counts is its motion
    /// perpendicular to the direction in which it is seen or, on the horizon of the face
    /// that the viewpoint is on, its motion across the horizon; close to the horizon, its
    /// motion across the edge, and a part of that along it.
    pub(crate) fn boundary_sample<R: Real>(
        &self,
        viewpoint: &Viewpoint<R>,
        seen: &Seen,
    ) -> BoundarySample {
        let found = &seen.point;
        let edge = &self.boundaries.edge(found.edge);
        // Only motion across the horizon matters; that along it grows without bound as the
        // viewpoint nears the edge.
        let horizon = match seen.is_direct {
            true => self.horizon(viewpoint, found),
            false => None,
        };
        BoundarySample {
            points: edge.vertices,
            t: found.t,
            direction: horizon.unwrap_or(found.direction),
            is_horizon: horizon.is_some(),
            damped: match viewpoint.face_normal {
                Some(normal) if seen.is_direct => self.damped(edge.vertices, found, normal),
                _ => Vec3::zero(),
            },
            distance: found.distance,
            place: viewpoint.axes.map(|_| {
                let point = self.boundaries.point(edge.vertices, found.t);
                self.accel.view.place(point)
            }),
            mirrors: seen.mirrors,
        }
    }

    /// The same of a point that is seen without a specular event.
    pub fn direct_boundary_sample<R: Real>(
        &self,
        viewpoint: &Viewpoint<R>,
        point: &SilhouettePoint,
    ) -> BoundarySample {
        let seen = Seen {
            point: *point,
            mirrors: Mirrors::default(),
            is_direct: true,
        };
        self.boundary_sample(viewpoint, &seen)
    }

    /// The normal of the viewpoint's face, if a point that is seen without a specular event is
    /// on an edge in the plane of that face, as the face's own edges are: on the horizon.
    pub(crate) fn horizon<R: Real>(
        &self,
        viewpoint: &Viewpoint<R>,
        found: &SilhouettePoint,
    ) -> Option<Vec3> {
        let normal = viewpoint.face_normal?;
        let height = normal.dot(found.direction) * found.distance;
        let ends = self.boundaries.edge(found.edge).vertices;
        let is_on_it = height.abs() <= self.accel.horizon_distance()
            && self.in_horizon(viewpoint.position.value(), ends, normal);
        is_on_it.then_some(normal)
    }

    /// The direction along an edge, as it is seen at a point, times the root of the part of the
    /// motion along it that does not count. Motion along a boundary does not move it; where
    /// neighbours of the viewpoint's face rise above the horizon, close to the viewpoint, it would
    /// grow without bound.
    fn damped(&self, ends: [u32; 2], found: &SilhouettePoint, normal: Vec3) -> Vec3 {
        let part = 1.0 - normal.dot(found.direction).abs() / Self::LOW;
        let [a, b] = ends.map(|i| self.boundaries.position(i));
        let seen = (b - a).reject_from(found.direction);
        let length = seen.length();
        match part > 0.0 && length > Self::END_ON * (b - a).length() {
            true => seen * (part.sqrt() / length),
            false => Vec3::zero(),
        }
    }

    /// World position of a boundary point.
    pub fn position(&self, sample: &BoundarySample) -> Vec3 {
        self.boundaries.point(sample.points, sample.t)
    }

    /// True if an edge, whose ends are points of the boundaries, is in the plane of the
    /// viewpoint's face.
    pub fn in_horizon(&self, viewpoint: Vec3, ends: [u32; 2], normal: Vec3) -> bool {
        ends.into_iter().all(|i| {
            let offset = self.boundaries.position(i) - viewpoint;
            offset.dot(normal).abs() <= self.accel.horizon_distance()
        })
    }

    /// The velocity of a boundary point's direction, radians, for the velocities of
    /// points of the boundaries and of the viewpoint ([`Viewpoint::vectors`]).
    pub(crate) fn velocity(
        &self,
        sample: &BoundarySample,
        point: impl Fn(u32) -> Vec3,
        viewpoint: &[Vec3; 4],
    ) -> Vec3 {
        // The point moves with the ends of its edge, its mirror image also with the mirrors.
        let [a, b] = sample.points.map(&point);
        let mut velocity = a + (b - a) * sample.t;
        if !sample.mirrors.is_empty() {
            let (mesh, position) = (&self.accel.mesh, self.position(sample));
            velocity = sample.mirrors.velocity(mesh, position, velocity, point);
        }
        // Subtract the velocity of what is fixed to the viewpoint.
        for (&vector, share) in viewpoint.iter().zip(sample.shares()) {
            velocity += vector * -share;
        }
        self.seen_velocity(sample, velocity)
    }

    /// The transpose of [`Field::velocity`]: passes a covector on the velocity of a
    /// boundary point's direction on to covectors on points of the boundaries and on
    /// the vectors of the viewpoint.
    pub(crate) fn pull_velocity(
        &self,
        sample: &BoundarySample,
        covector: Vec3,
        mut on_point: impl FnMut(u32, Vec3),
        mut on_viewpoint: impl FnMut(usize, Vec3),
    ) {
        let mut covector = self.pull_seen_velocity(sample, covector);
        for (i, share) in sample.shares().into_iter().enumerate() {
            on_viewpoint(i, covector * -share);
        }
        if !sample.mirrors.is_empty() {
            let (mesh, position) = (&self.accel.mesh, self.position(sample));
            covector = sample.mirrors.pull(mesh, position, covector, &mut on_point);
        }
        let [a, b] = sample.points;
        on_point(a, covector * (1.0 - sample.t));
        on_point(b, covector * sample.t);
    }

    /// The angular velocity of a boundary point, or of its mirror image, for a velocity
    /// `ẋ - ȯ` relative to the viewpoint: `P_x̂ (ẋ - ȯ) / |x - o|`. If the viewpoint's rays
    /// are parallel, it is that of the direction in image space.
    #[inline]
    fn seen_velocity(&self, sample: &BoundarySample, relative: Vec3) -> Vec3 {
        match sample.place {
            None => sample.angular(relative),
            Some(_) => sample.angular(self.accel.view.image_velocity(relative)),
        }
    }

    /// The transpose of [`Field::seen_velocity`].
    #[inline]
    fn pull_seen_velocity(&self, sample: &BoundarySample, covector: Vec3) -> Vec3 {
        let on_velocity = sample.angular(covector);
        match sample.place {
            None => on_velocity,
            Some(_) => self.accel.view.pull_image_velocity(on_velocity),
        }
    }

    /// World position of a point that a query found around `apex`, and its distance along
    /// the viewpoint's ray.
    pub(crate) fn located<R>(
        &self,
        viewpoint: &Viewpoint<R>,
        apex: Vec3,
        found: &SilhouettePoint,
    ) -> (Vec3, f64) {
        match viewpoint.axes {
            None => (apex + found.direction * found.distance, found.distance),
            Some(_) => {
                let edge = self.boundaries.edge(found.edge);
                let point = self.boundaries.point(edge.vertices, found.t);
                (point, self.accel.view.depth(point))
            }
        }
    }
}
