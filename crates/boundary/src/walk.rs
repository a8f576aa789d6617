//! The velocity field around a viewpoint, estimated by fixed-step walks on spherical caps
//! (METHOD 2). Its boundaries are the edges seen directly, in flat mirrors and through
//! panes.

use std::cell::Cell;

use capwalk_geometry::{ConeQuery, EdgeSelection, Shadow, Sight, SilhouettePoint};
use capwalk_math::{Real, Vec3};
use capwalk_walk::{FieldSample, Sphere, WalkSettings, sample_field, sample_value};

use crate::boundary_sample::BoundarySample;
use crate::draw::Numbers;
use crate::field::Field;
use crate::passing::Leaving;
use crate::reflected::ReflectedSphere;
use crate::viewpoint::{CREASED, ROUND, SMOOTH, Viewpoint, Visibility};

/// A sample of the field `u(q)` and its divergence `div u(q)`: boundary points with the
/// weights of their velocities in both.
pub fn walk<R: Real>(
    field: &Field,
    viewpoint: &Viewpoint<R>,
    q: Vec3,
    settings: &WalkSettings,
    random: Numbers,
) -> FieldSample<BoundarySample, Vec3> {
    // Walk among the boundaries, without velocities.
    let sphere = sphere(field, viewpoint);
    let sample = sample_field(&sphere, q, settings, |i| random.number(i));
    random.draw.count_queries(sphere.direct.queries.get());
    // Turn each boundary point into a linear map from velocities to its angular velocity.
    sample.map(|seen| field.boundary_sample(viewpoint, seen))
}

/// A sample of the field `u(q)` alone: the boundary point where the walk ends, whose
/// angular velocity it is; `None` if no boundary is near and the field is zero.
pub fn walk_value<R: Real>(
    field: &Field,
    viewpoint: &Viewpoint<R>,
    q: Vec3,
    settings: &WalkSettings,
    random: Numbers,
) -> Option<BoundarySample> {
    let sphere = sphere(field, viewpoint);
    let seen = sample_value(&sphere, q, settings, |i| random.number(i));
    random.draw.count_queries(sphere.direct.queries.get());
    Some(field.boundary_sample(viewpoint, &seen?))
}

/// The sphere of directions around a viewpoint, bounded by edges and their mirror images.
pub(crate) fn sphere<'e, R: Real>(
    field: &'e Field,
    viewpoint: &'e Viewpoint<R>,
) -> ReflectedSphere<'e, R, impl Sight> {
    ReflectedSphere {
        direct: direct_sphere(field, viewpoint),
        field,
        viewpoint,
    }
}

/// The same without the mirror images.
pub fn direct_sphere<'e, R: Real>(
    field: &'e Field,
    viewpoint: &'e Viewpoint<R>,
) -> Sphere<'e, impl Sight> {
    let (accel, boundaries) = (field.accel, field.boundaries);
    let position = viewpoint.position.value();
    // A camera with parallel rays sees directions from the origin of image space.
    let (tree, apex) = match viewpoint.axes {
        None => (boundaries.tree(), position),
        Some(_) => (boundaries.image_tree(), Vec3::zero()),
    };
    let is_camera = viewpoint.visibility == Visibility::Camera;
    let seen = SeenFrom {
        field,
        viewpoint,
        apex,
    };
    Sphere {
        tree,
        origin: apex,
        edges: viewpoint.selection,
        groups: viewpoint.group,
        in_front_of: is_camera.then(|| accel.behind_near_plane()).flatten(),
        counts: (viewpoint.visibility != Visibility::All).then_some(seen),
        queries: Cell::new(0),
    }
}

/// What a viewpoint sees without a specular event.
struct SeenFrom<'e, R> {
    field: &'e Field<'e>,
    viewpoint: &'e Viewpoint<R>,
    /// In the space of the tree.
    apex: Vec3,
}

impl<R: Real> Sight for SeenFrom<'_, R> {
    /// Leaves out what is hidden, from the camera also what its clip planes cut off. The horizon
    /// counts without a ray: along the plane of a face, rounding decides what a ray hits.
    fn sees(&self, point: &SilhouettePoint) -> bool {
        let (field, viewpoint) = (self.field, self.viewpoint);
        let position = viewpoint.position.value();
        let (_, distance) = field.located(viewpoint, self.apex, point);
        match viewpoint.visibility {
            Visibility::Camera => (field.accel).camera_sees(position, point.direction, distance),
            Visibility::Surface | Visibility::All => {
                field.horizon(viewpoint, point).is_some()
                    || (field.accel).surface_sees(position, point.direction, distance)
            }
        }
    }

    fn shadow(&self, point: &SilhouettePoint) -> Option<Shadow> {
        if self.viewpoint.visibility != Visibility::Surface {
            return None;
        }
        let normal = self.viewpoint.face_normal?;
        let side = normal * normal.dot(point.direction).signum();
        let position = self.viewpoint.position.value();
        (self.field.accel).shadow_before(position, point.direction, side)
    }
}

/// What is seen from a point of a specular face after an event. The face's own edges do not count.
struct SeenBehind<'e> {
    field: &'e Field<'e>,
    viewpoint: &'e Viewpoint<f64>,
    leaving: &'e Leaving,
}

impl Sight for SeenBehind<'_> {
    fn sees(&self, point: &SilhouettePoint) -> bool {
        let from = self.viewpoint.position;
        self.field.horizon(self.viewpoint, point).is_none()
            && (self.field.accel).sees_leaving(self.leaving, from, point.direction, point.distance)
    }

    /// Only in front of the face, for rays that dip begin elsewhere.
    fn shadow(&self, point: &SilhouettePoint) -> Option<Shadow> {
        let (normal, from) = (self.leaving.normal(), self.viewpoint.position);
        self.field
            .accel
            .shadow_before(from, point.direction, normal)
    }
}

/// Which edges bound light of a chain of specular events that are seen from one of its vertices; the `last` is where
/// no further event follows, and light comes that is scattered or emitted.
pub const fn seen_by_chains(last: bool) -> [(u8, EdgeSelection); 2] {
    let (all, silhouettes) = match last {
        true => (CREASED | SMOOTH, ROUND),
        false => (CREASED, SMOOTH | ROUND),
    };
    [
        (all, EdgeSelection::All),
        (silhouettes, EdgeSelection::Silhouettes),
    ]
}

impl Field<'_> {
    /// The boundary point closest to a direction, nearer than `limit` radians, that is seen from a point of a
    /// specular face after an event, the `last` of its chain or not. The face's own edges do not count: they
    /// are seen only where the direction is in the plane of the face.
    pub fn closest_behind(
        &self,
        position: Vec3,
        leaving: &Leaving,
        direction: Vec3,
        last: bool,
        mut limit: f64,
    ) -> Option<SilhouettePoint> {
        let viewpoint = Viewpoint::towards_surfaces(position, leaving.normal(), 0);
        let mut found = None;
        for (groups, edges) in seen_by_chains(last) {
            let query = ConeQuery {
                apex: position,
                axis: direction,
                max_angle: limit,
                edges,
                groups,
                in_front_of: None,
            };
            let seen = SeenBehind {
                field: self,
                viewpoint: &viewpoint,
                leaving,
            };
            if let Some(point) = self.boundaries.tree().closest_where(&query, &seen) {
                limit = point.angle;
                found = Some(point);
            }
        }
        found
    }
}

#[cfg(test)]
mod tests;
