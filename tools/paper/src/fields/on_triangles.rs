//! `domain = triangle` (METHOD 1): the field of Algorithm 7 on the triangle that
//! a direction meets.
//!
//! Its boundaries are the silhouettes before the triangle's plane and the
//! triangle's own border, where the material's coordinates end and the field is
//! zero. Nothing else is needed: where shading is discontinuous between two triangles, both
//! borders do not move in the material. The walk starts with the cone that the
//! triangle is seen under, and stays on the part of it that is seen.
//!
//! Directions that meet nothing have no triangle. There the field is that of the
//! sphere, bounded by all silhouettes, around the same point.

use std::cell::Cell;

use capwalk_boundary::{
    Accel, Boundaries, CustomField, Field, Flow, Method, Numbers, SEEN, Viewpoint, Visibility,
};
use capwalk_geometry::{EdgeSelection, SilhouettePoint};
use capwalk_math::Vec3;
use capwalk_walk::{Sphere, WalkSettings, sample_field};

use super::receiver::{IN_PLANE, PlaneVelocity, Receiver};
use crate::walk::triangle::{Triangle, TriangleBoundary};

/// The walk of the renderer on the triangle that each direction hits, where the field is relative to
/// the material: the paper to the letter. Borders of triangles limit its walks, in the place of
/// `max_radius`, which is left for directions that hit nothing. Unbiased; reflected boundaries are
/// not covered.
pub const ON_TRIANGLES: Method = Method::Custom(&OnTriangles);

#[derive(Debug)]
struct OnTriangles;

impl CustomField for OnTriangles {
    fn name(&self) -> &'static str {
        "walk on triangles"
    }

    fn is_unbiased(&self) -> bool {
        true
    }

    fn walks(&self) -> bool {
        true
    }

    /// Algorithm 7; `None` if the direction meets nothing.
    fn flow(
        &self,
        accel: &Accel,
        boundaries: &Boundaries,
        viewpoint: &Viewpoint<f64>,
        q: Vec3,
        walk: &WalkSettings,
        random: Numbers,
    ) -> Option<Flow> {
        let receiver = Receiver::met(accel, viewpoint, q)?;
        let field = Field::new(accel, boundaries, ON_TRIANGLES);
        let triangle = triangle(&field, viewpoint, &receiver);
        let sample = sample_field(&triangle, q, &unlimited(walk), |i| random.number(i));
        random.draw.count_queries(triangle.sphere.queries.get());
        let mut flow = receiver.material();
        for term in sample.terms() {
            if let TriangleBoundary::Silhouette(point) = &term.site {
                let velocity = projected(&field, viewpoint, &receiver, point);
                let divergence = receiver.divergence(term.gradient);
                receiver.add(&mut flow, &velocity, term.weight, divergence);
            }
        }
        Some(flow)
    }
}

/// The triangle's border limits every cone; nothing else does.
fn unlimited(walk: &WalkSettings) -> WalkSettings {
    WalkSettings {
        max_radius: std::f64::consts::PI,
        ..*walk
    }
}

/// The velocity of a silhouette's projection on the receiver.
pub(super) fn projected(
    field: &Field,
    viewpoint: &Viewpoint<f64>,
    receiver: &Receiver,
    point: &SilhouettePoint,
) -> PlaneVelocity {
    let sample = field.direct_boundary_sample(viewpoint, point);
    let angular = |velocity| sample.angular(velocity);
    receiver.boundary(sample.points, sample.t, angular, point.direction)
}

/// The directions in which the receiver is seen, and what bounds them.
fn triangle<'a>(
    field: &Field<'a>,
    viewpoint: &Viewpoint<f64>,
    receiver: &Receiver,
) -> Triangle<'a, impl Fn(&SilhouettePoint) -> bool> {
    let (accel, boundaries, position) = (field.accel, field.boundaries, receiver.viewpoint);
    let is_camera = viewpoint.visibility == Visibility::Camera;
    // Nothing hides what bounds the visible part of a triangle, but the camera
    // sees no edge before its near plane. One that passes it counts as a whole:
    // if its closest point decided, the field would be discontinuous there.
    let view = accel.view.from(position);
    let [near, far] = view.clip();
    let is_seen = move |site: &SilhouettePoint| {
        let [a, b] = boundaries.ends(site.edge).map(|p| view.depth(p));
        a.max(b) > near && a.min(b) < far
    };
    Triangle {
        sphere: Sphere {
            tree: boundaries.tree(),
            origin: position,
            edges: EdgeSelection::Silhouettes,
            groups: SEEN,
            in_front_of: Some(receiver.plane(IN_PLANE * receiver.distance)),
            counts: is_camera.then_some(is_seen),
            queries: Cell::new(0),
        },
        corners: receiver.offsets(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_boundary::{Counts, Draw, FlowSource, Sampler};
    use capwalk_math::{Moments, sphere};
    use capwalk_scene::builtin;
    use capwalk_walk::{Domain, Estimator};

    /// Velocities that look random.
    fn velocity(source: FlowSource) -> Vec3 {
        let i = match source {
            FlowSource::Point(i) => f64::from(i) + 1.0,
            FlowSource::Viewpoint => 0.5,
        };
        Vec3::new((12.9 * i).sin(), (78.2 * i).sin(), (37.7 * i).sin())
    }

    /// A field is continuous only if the distance to its boundaries is: it changes by
    /// no more than the direction does, also where edges pass the near plane.
    #[test]
    fn edges_that_pass_the_near_plane_count_as_a_whole() {
        let mut scene = builtin::scene("leaf").expect("built in");
        // A leaf before the camera, of which a corner is before the near plane.
        let [width, height] = scene.film.size.map(f64::from);
        let view = Accel::new(scene.clone()).view;
        let corner = |[x, y, distance]: [f64; 3]| {
            view.origin + view.direction([width * x, height * y]) * distance
        };
        let leaf = scene.shapes_mut().find(|shape| shape.id == "leaf");
        let corners = [[0.1, 0.3, 0.3], [0.9, 0.5, 1.0], [0.4, 0.7, 0.9]];
        leaf.expect("it is there").mesh.positions = corners.map(corner).to_vec();
        scene.sensor.near_clip = 0.6;
        let accel = Accel::new(scene.clone());
        let boundaries = Boundaries::new(&accel);
        let field = Field::new(&accel, &boundaries, ON_TRIANGLES);
        let viewpoint: Viewpoint<f64> = Viewpoint::camera(&accel.view, 0);
        let mut meets = 0;
        for row in 0..16 {
            let steps = 2000;
            let at = |step: u32| {
                let [x, y] = [f64::from(step) / f64::from(steps), f64::from(row) / 16.0];
                accel.view.direction([width * x, height * y])
            };
            let Some(receiver) = Receiver::met(&accel, &viewpoint, at(steps / 2)) else {
                continue;
            };
            let triangle = triangle(&field, &viewpoint, &receiver);
            let nearest = |step: u32| triangle.closest(at(step), std::f64::consts::PI);
            for step in 0..steps {
                let (Some(a), Some(b)) = (nearest(step), nearest(step + 1)) else {
                    continue;
                };
                meets += u32::from(a.site != TriangleBoundary::Border);
                let change = (a.distance - b.distance).abs();
                let angle = sphere::angle_between(at(step), at(step + 1));
                assert!(change < angle + 1e-12, "{row}, {step}: {change} > {angle}");
            }
        }
        assert!(meets > 1000, "only {meets} directions have silhouettes");
    }

    /// At a fixed direction both estimators have the same mean, for the motion of
    /// the direction and for its divergence.
    #[test]
    fn literal_and_anchored_agree_at_fixed_directions() {
        let scene = builtin::scene("ball").expect("built in");
        let accel = Accel::new(scene.clone());
        let boundaries = Boundaries::new(&accel);
        let viewpoint: Viewpoint<f64> = Viewpoint::camera(&accel.view, 0);
        let sampler = Sampler::new(&scene.settings, 3, 1);
        let [width, height] = scene.film.size.map(f64::from);
        let estimate = |q: Vec3, steps: u32, estimator: Estimator| {
            let walk = WalkSettings {
                steps,
                estimator,
                ..WalkSettings::default()
            };
            let mut moments = [Moments::default(); 2];
            for number in 0..3000 {
                let stream = sampler.stream(7, number);
                let counts = Counts::default();
                let draw = Draw {
                    stream: &stream,
                    counts: &counts,
                };
                let random = Numbers { draw, dimension: 0 };
                let flow = OnTriangles
                    .flow(&accel, &boundaries, &viewpoint, q, &walk, random)
                    .expect("a surface");
                let (u, divergence) = flow.evaluate(velocity);
                moments[0].add(u.dot(Vec3::new(0.3, -0.5, 0.8)));
                moments[1].add(divergence);
            }
            moments
        };
        let mut noisy = 0;
        for i in 0..24 {
            // A lattice that fills the film evenly.
            let at = [0.754_877_666, 0.569_840_291].map(|a| (f64::from(i) * a).fract());
            let q = accel.view.direction([width * at[0], height * at[1]]);
            if Receiver::met(&accel, &viewpoint, q).is_none() {
                continue;
            }
            let steps = 1 + i as u32 % 2;
            let anchored = estimate(q, steps, Estimator::Anchored);
            let literal = estimate(q, steps, Estimator::Literal);
            for (a, b) in anchored.iter().zip(&literal) {
                let error = a.standard_error().hypot(b.standard_error());
                let difference = (a.mean - b.mean).abs();
                // Some 40 comparisons: 4.5 σ fails one run in 3000.
                assert!(
                    difference <= 4.5 * error + 1e-12,
                    "{i}, M = {steps}: {} against {} ± {error}",
                    a.mean,
                    b.mean
                );
                noisy += usize::from(error > 0.0);
            }
        }
        assert!(noisy > 20, "only {noisy} comparisons have noise");
    }
}
