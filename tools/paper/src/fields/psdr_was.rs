//! Warped-area sampling in path space (Xu et al. 2023), a baseline: the weighted
//! mean of earlier work on the triangle that a direction meets, of velocities
//! relative to its material.
//!
//! Auxiliary points `z` are drawn on the triangle's plane around the hit point `p`,
//! and rays from the viewpoint are sent there. What such a ray meets before the plane
//! prescribes the velocity of its projection, with its place on its own triangle
//! fixed; where nothing is before it the material does not move.
//!
//! Of Xu et al. are the integral over the surface (Eq. 7), the material form with
//! stationary borders of triangles, and the form of the weights (Eq. 8). Chosen here,
//! as in warped-area sampling among directions, are
//!
//! ```text
//! D(z; p) = e^{κ |z - p|² / 2r²} - 1 ,   r = |p - o|
//! ```
//!
//! with the same `κ`, `γ` and boundary tests, that points are drawn with the density
//! `1 / (D + 1)`, and that directions that meet nothing have the field among
//! directions. The triangle's own border counts by the test of edges always: it is
//! there whatever normals say.

use std::f64::consts::PI;

use capwalk_boundary::{Accel, Flow, Stream, Viewpoint};
use capwalk_geometry::Hit;
use capwalk_math::{Frame, Vec3};

use super::receiver::Receiver;
use super::was;
use super::was_settings::WasSettings;
use super::weighted_mean::{self, edge_test, ray_numbers, relative_density};

/// What lies before a plane does so by more than this fraction of the distance.
const IN_PLANE: f64 = 1e-9;

/// An auxiliary point.
struct Auxiliary {
    /// `z - p`.
    offset: Vec3,
    /// One over the density that it was drawn with, up to a constant.
    inverse_density: f64,
    /// `B`, the boundary test.
    boundary: f64,
    /// What is seen before it, and its unit direction.
    before: Option<(Hit, Vec3)>,
}

/// The motion of the direction `q` and the divergence there.
pub(super) fn flow(
    accel: &Accel,
    viewpoint: &Viewpoint<f64>,
    q: Vec3,
    settings: &WasSettings,
    numbers: &Stream,
) -> Flow {
    let Some(receiver) = Receiver::met(accel, viewpoint, q) else {
        return was::flow(accel, viewpoint, q, settings, numbers);
    };
    let draw = |index, rays: &mut Vec<_>| {
        for (u, mirrored) in ray_numbers(settings, numbers, index) {
            let (offset, inverse_density) = sample_offset(&receiver, settings.kappa, u);
            let offset = if mirrored { -offset } else { offset };
            rays.push(auxiliary(
                accel,
                viewpoint,
                &receiver,
                settings,
                offset,
                inverse_density,
            ));
        }
    };
    let weight = |ray: &Auxiliary| {
        let distance = distance(&receiver, ray.offset, settings.kappa);
        weighted_mean::weight(ray.inverse_density, distance, ray.boundary)
    };
    let (rays, shares) = weighted_mean::shares(settings, numbers, draw, weight, Vec3::zero());
    let mut flow = receiver.material();
    for (ray, share) in rays.iter().zip(&shares) {
        let Some((hit, seen)) = &ray.before else {
            continue; // the material, which does not move
        };
        let corners = accel.mesh.faces[hit.face as usize];
        let weights = was::corner_weights(hit);
        let parts = [0, 1, 2].map(|i| (corners[i], weights[i]));
        let angular = |velocity: Vec3| velocity.reject_from(*seen) / hit.t;
        let velocity = receiver.projected(&parts, angular, *seen);
        receiver.add(&mut flow, &velocity, share.weight, share.divergence);
    }
    flow
}

fn auxiliary(
    accel: &Accel,
    viewpoint: &Viewpoint<f64>,
    receiver: &Receiver,
    settings: &WasSettings,
    offset: Vec3,
    inverse_density: f64,
) -> Auxiliary {
    let point = receiver.point() + offset;
    let to_point = point - receiver.viewpoint;
    let distance = to_point.length();
    let direction = to_point / distance;
    let hit = was::cast(accel, viewpoint, direction);
    let before = hit.filter(|hit| hit.t < distance * (1.0 - IN_PLANE) && hit.face != receiver.face);
    Auxiliary {
        offset,
        inverse_density,
        boundary: match &before {
            Some(hit) => was::boundary_test(accel, settings.boundary, hit, direction),
            None => edge_test(receiver.weights(point)),
        },
        before: before.map(|hit| (hit, direction)),
    }
}

/// A vector in the receiver's plane, normally distributed with the standard
/// deviation `r / √κ`, and one over its density, up to a constant.
fn sample_offset(receiver: &Receiver, kappa: f64, u: [f64; 2]) -> (Vec3, f64) {
    let density = relative_density(u[1]);
    let length = receiver.distance * (-2.0 * density.ln() / kappa).sqrt();
    let (sin_phi, cos_phi) = (2.0 * PI * u[0]).sin_cos();
    let Frame { s, t, .. } = Frame::from_normal(receiver.normal());
    (
        s * (length * cos_phi) + t * (length * sin_phi),
        1.0 / density,
    )
}

/// `D`, zero where `z` is `p`, and its gradient by `p` in the plane.
fn distance(receiver: &Receiver, offset: Vec3, kappa: f64) -> (f64, Vec3) {
    let r = receiver.distance;
    let scaled = kappa * offset.length_squared() / (2.0 * r * r);
    let distance = scaled.exp_m1();
    let r_gradient = receiver.direction.reject_from(receiver.normal());
    let gradient = offset * (-kappa / (r * r)) - r_gradient * (2.0 * scaled / r);
    (distance, gradient * (distance + 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_geometry::Mesh;

    /// The gradient of `D` is that of moving the hit point in the plane, with the
    /// auxiliary point fixed.
    #[test]
    fn distance_has_its_gradient() {
        let v = |x: f64, y: f64, z: f64| Vec3::new(x, y, z);
        let mesh = Mesh {
            positions: vec![v(-1.0, -0.8, 2.0), v(1.2, -0.7, 2.6), v(0.1, 1.3, 1.7)],
            faces: vec![[0, 1, 2]],
        };
        let viewpoint = v(0.1, 0.05, -0.3);
        let point = (mesh.positions[0] + mesh.positions[1] + mesh.positions[2]) / 3.0;
        let at = |point: Vec3| {
            let offset = point - viewpoint;
            let hit = Hit {
                face: 0,
                t: offset.length(),
                barycentric: [0.0; 2],
            };
            Receiver::new(&mesh, &hit, viewpoint, offset.normalized())
        };
        let receiver = at(point);
        let frame = Frame::from_normal(receiver.normal());
        let auxiliary = point + frame.s * 0.3 - frame.t * 0.2;
        let (_, gradient) = distance(&receiver, auxiliary - point, 20.0);
        for d in [frame.s, frame.t] {
            let h = 1e-6;
            let moved = |h: f64| {
                let point = point + d * h;
                distance(&at(point), auxiliary - point, 20.0).0
            };
            let numeric = (moved(h) - moved(-h)) / (2.0 * h);
            assert!(
                (gradient.dot(d) - numeric).abs() < 1e-7,
                "{gradient:?} {numeric}"
            );
            assert!(numeric.abs() > 0.1, "nothing to compare");
        }
        assert!(gradient.dot(receiver.normal()).abs() < 1e-12);
    }
}
