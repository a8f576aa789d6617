//! `domain = triangle` (METHOD 1): the field of Algorithm 7 on the triangle that
//! a direction meets.
//!
//! Its boundaries are the silhouettes before the triangle's plane and the
//! triangle's own border, where the material's coordinates end and the field is
//! zero. Nothing else is needed: where shading jumps between two triangles, both
//! borders are at rest in the material. The walk starts with the cone that the
//! triangle is seen under, and stays on the part of it that is seen.
//!
//! Directions that meet nothing have no triangle. There the field is that of the
//! sphere, bounded by all silhouettes, around the same point.

use std::cell::Cell;

use capwalk_geometry::{EdgeSelection, SilhouettePoint};
use capwalk_math::{Real, Vec3};
use capwalk_walk::{Outline, Sphere, Triangle, WalkSettings, sample_field};

use super::boundary::{Eye, Field, Numbers, SEEN, Visibility};
use super::flow::Flow;
use super::receiver::{PlaneVelocity, Receiver};
use super::unfold::{Mirrors, Seen};

/// The triangle's border limits every cone; nothing else does.
fn unlimited(walk: &WalkSettings) -> WalkSettings {
    WalkSettings {
        max_radius: std::f64::consts::PI,
        ..*walk
    }
}

/// Silhouettes lie before a triangle's plane if they are not farther behind than
/// this fraction of the triangle's distance: where surfaces pass through it they
/// lie in it.
pub(super) const IN_PLANE: f64 = 1e-6;

impl Field<'_> {
    /// The triangle that a direction meets.
    pub(super) fn receiver<R: Real>(&self, eye: &Eye<R>, q: Vec3) -> Option<Receiver> {
        let position = eye.position.value();
        let ray = match eye.visibility {
            Visibility::Camera => self.accel.camera_ray(position, q),
            Visibility::Surface | Visibility::All => self.accel.surface_ray(position, q),
        };
        let hit = self.accel.first_hit_within(&ray)?;
        Some(Receiver::new(&self.accel.mesh, &hit, position, q))
    }

    /// The velocity of a silhouette's projection on the receiver.
    pub(super) fn projected<R: Real>(
        &self,
        eye: &Eye<R>,
        receiver: &Receiver,
        point: &SilhouettePoint,
    ) -> PlaneVelocity {
        let seen = Seen {
            point: *point,
            mirrors: Mirrors::default(),
            is_direct: true,
        };
        receiver.boundary(&self.site(eye, &seen), point.direction)
    }

    /// The directions in which the receiver is seen, and what bounds them.
    fn triangle<R: Real>(
        &self,
        eye: &Eye<R>,
        receiver: &Receiver,
    ) -> Triangle<'_, impl Fn(&SilhouettePoint) -> bool> {
        let position = receiver.eye;
        let is_camera = eye.visibility == Visibility::Camera;
        // Nothing hides what bounds the visible part of a triangle, but the camera
        // sees nothing before its near plane.
        let is_seen = move |site: &SilhouettePoint| {
            let ray = self.accel.camera_ray(position, site.direction);
            ray.t_min < site.distance && site.distance < ray.t_max
        };
        Triangle {
            sphere: Sphere {
                tree: &self.boundaries.tree,
                eye: position,
                edges: EdgeSelection::Silhouettes,
                groups: SEEN,
                in_front_of: Some(receiver.plane(IN_PLANE * receiver.distance)),
                counts: is_camera.then_some(is_seen),
                queries: Cell::new(0),
            },
            corners: receiver.offsets(),
        }
    }

    /// A sample of the direction's motion and its divergence with the field on the
    /// triangle that it meets, Algorithm 7; `None` if it meets nothing.
    pub(super) fn triangle_flow<R: Real>(
        &self,
        eye: &Eye<R>,
        q: Vec3,
        walk: &WalkSettings,
        random: Numbers,
    ) -> Option<Flow> {
        let receiver = self.receiver(eye, q)?;
        let triangle = self.triangle(eye, &receiver);
        let sample = sample_field(&triangle, q, &unlimited(walk), |i| random.number(i));
        random.draw.count_queries(triangle.sphere.queries.get());
        let mut flow = receiver.material();
        for term in sample.terms() {
            if let Outline::Silhouette(point) = &term.site {
                let velocity = self.projected(eye, &receiver, point);
                let divergence = receiver.divergence(term.slope);
                receiver.add(&mut flow, &velocity, term.weight, divergence);
            }
        }
        Some(flow)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::Accel;
    use crate::diff::boundary::{Counts, Draw};
    use crate::diff::flow::Source;
    use crate::options::Method;
    use crate::sampler::Sampler;
    use capwalk_math::Moments;
    use capwalk_scene::builtin;
    use capwalk_walk::Estimator;

    /// Velocities that look random.
    fn velocity(source: Source) -> Vec3 {
        let i = match source {
            Source::Point(i) => f64::from(i) + 1.0,
            Source::Eye => 0.5,
        };
        Vec3::new((12.9 * i).sin(), (78.2 * i).sin(), (37.7 * i).sin())
    }

    /// At a fixed direction both estimators have the same mean, for the motion of
    /// the direction and for its divergence.
    #[test]
    fn literal_and_anchored_agree_at_fixed_directions() {
        let scene = builtin::scene("ball").expect("built in");
        let accel = Accel::new(&scene);
        let field = Field::new(&accel, Method::TriangleWalk);
        let eye: Eye<f64> = Eye::camera(&accel.view, 0);
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
                let flow = field.flow(&eye, q, &walk, random).expect("a surface");
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
            if field.receiver(&eye, q).is_none() {
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
