//! The velocity field around a viewpoint, estimated by fixed-step walks on spherical caps
//! (METHOD 2). Its boundaries are the edges seen directly, in flat mirrors and through
//! panes.

use std::cell::Cell;
use std::f64::consts::PI;

use capwalk_geometry::{ConeQuery, EdgeSelection, EdgeSubset, Shadow, Sight, SilhouettePoint};
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

/// How much farther than a walk can reach edges are asked for, for rounding.
const FARTHER: f64 = 1.0 + 1e-6;

/// The most images in mirrors that are looked at before edges count as reached.
const MOST_IMAGES: u32 = 16;

/// What moves, as far as it is known.
#[derive(Clone, Copy)]
pub struct MovingBoundaries<'a> {
    /// All edges but those that certainly do not move.
    pub edges: &'a EdgeSubset,
    /// False if no flat mirror moves.
    pub mirrors: bool,
}

impl Field<'_> {
    /// False if no walk from the direction `q` around a viewpoint comes to a boundary that moves, seen directly
    /// or in mirrors. In doubt it is true, as it is for cameras with parallel rays and fields of someone else.
    pub fn reaches<R: Real>(
        &self,
        viewpoint: &Viewpoint<R>,
        q: Vec3,
        settings: &WalkSettings,
        moving: MovingBoundaries,
    ) -> bool {
        let max_angle = settings.reach() * FARTHER;
        let is_known = self.method.traits().is_spherical && viewpoint.axes.is_none();
        if !is_known || max_angle >= 0.5 * PI {
            return true;
        }
        let query = ConeQuery {
            apex: viewpoint.position.value(),
            axis: q,
            max_angle,
            edges: viewpoint.selection,
            groups: viewpoint.group,
            in_front_of: None,
        };
        let mut images = 0;
        self.is_met(&query, moving, viewpoint.events, None, &mut images)
    }

    /// True if a boundary that moves is in a cone, or in its image behind one of so many mirrors in turn. The last one
    /// of them was `behind`; `images` counts all.
    fn is_met(
        &self,
        query: &ConeQuery,
        moving: MovingBoundaries,
        events: u32,
        behind: Option<usize>,
        images: &mut u32,
    ) -> bool {
        if self.boundaries.tree().meets(query, moving.edges) {
            return true;
        }
        if events == 0 {
            return false;
        }
        let Some(mirrors) = self.accel.mirror_planes() else {
            return true;
        };
        let (sin, cos) = query.max_angle.sin_cos();
        mirrors.planes.iter().enumerate().any(|(i, plane)| {
            // A ray does not meet the plane again that it comes from.
            if behind == Some(i) || !plane.may_be_in_cone(query.apex, query.axis, [cos, sin]) {
                return false;
            }
            // As the mirror shows it, everything moves with the mirror.
            *images += 1;
            if moving.mirrors || *images > MOST_IMAGES {
                return true;
            }
            let image = ConeQuery {
                apex: plane.mirror.point(query.apex),
                axis: plane.mirror.direction(query.axis),
                ..*query
            };
            self.is_met(&image, moving, events - 1, Some(i), images)
        })
    }
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
        let viewpoint = self.viewpoint;
        let normal = viewpoint.face_normal?;
        let side = normal * normal.dot(point.direction).signum();
        let is_surface = viewpoint.visibility == Visibility::Surface;
        let position = viewpoint.position.value();
        let shadow = || (self.field.accel).shadow_before(position, point.direction, side);
        is_surface.then(shadow)?
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
