//! The field around a viewpoint by fixed-step walks on spherical caps (METHOD 2), with
//! silhouettes seen directly, in flat mirrors and through panes as boundaries.

use std::cell::Cell;

use capwalk_geometry::SilhouettePoint;
use capwalk_math::{Real, Vec3};
use capwalk_walk::{FieldSample, Sphere, WalkSettings, sample_field, sample_value};

use crate::boundary_sample::BoundarySample;
use crate::draw::Numbers;
use crate::field::Field;
use crate::reflected::ReflectedSphere;
use crate::viewpoint::{Viewpoint, Visibility};

/// A sample of the field and its divergence in the direction `q`.
pub fn walk<R: Real>(
    field: &Field,
    viewpoint: &Viewpoint<R>,
    q: Vec3,
    settings: &WalkSettings,
    random: Numbers,
) -> FieldSample<BoundarySample, Vec3> {
    let sphere = sphere(field, viewpoint);
    let sample = sample_field(&sphere, q, settings, |i| random.number(i));
    random.draw.count_queries(sphere.direct.queries.get());
    sample.map(|seen| field.boundary_sample(viewpoint, seen))
}

/// A sample of the field alone: the boundary point whose velocity it is; `None` for
/// velocity zero.
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

/// The directions around a viewpoint, bounded by edges and their images.
pub(crate) fn sphere<'e, R: Real>(
    field: &'e Field,
    viewpoint: &'e Viewpoint<R>,
) -> ReflectedSphere<'e, R, impl Fn(&SilhouettePoint) -> bool> {
    let (accel, boundaries) = (field.accel, field.boundaries);
    let position = viewpoint.position.value();
    // Parallel rays all start from the origin of image space.
    let (tree, apex) = match viewpoint.axes {
        None => (boundaries.tree(), position),
        Some(_) => (boundaries.image_tree(), Vec3::zero()),
    };
    let is_camera = viewpoint.visibility == Visibility::Camera;
    let is_seen = move |point: &SilhouettePoint| {
        let (_, distance) = field.located(viewpoint, apex, point);
        match is_camera {
            true => accel.camera_sees(position, point.direction, distance),
            false => accel.surface_sees(position, point.direction, distance),
        }
    };
    ReflectedSphere {
        direct: Sphere {
            tree,
            origin: apex,
            edges: viewpoint.selection,
            groups: viewpoint.group,
            in_front_of: None,
            counts: (viewpoint.visibility != Visibility::All).then_some(is_seen),
            queries: Cell::new(0),
        },
        field,
        viewpoint,
    }
}

#[cfg(test)]
mod tests;
