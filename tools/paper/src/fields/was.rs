//! Warped-area sampling (Bangaru et al. 2020), a baseline: a direction moves
//! with the weighted mean of what auxiliary rays around it hit,
//!
//! ```text
//! v(q) = ∫ w(z; q) V(z) dz / ∫ w(z; q) dz        Eq. (7)
//! w(z; q) = 1 / (D(z; q) + B(z))^γ               Eq. (8)
//! D(z; q) = e^{κ (1 - q·z)} - 1
//! ```
//!
//! with `V(z)` the angular velocity of the surface point seen along `z` and `B`
//! zero at silhouettes, so that `w` has all its weight there when `q` comes
//! near. Both integrals are estimated with the same few rays: the ratio is
//! biased, and consistent as their number grows. Constants and sampling are
//! those of the authors' implementation in Falcor (WARDiffPathTracer) but for
//! what misses, where `B` is one as in Mitsuba 3.4: with zero, silhouettes before
//! the sky would not move. Their clamps for single precision are left out:
//! they are biased for any number of rays.

use std::f64::consts::PI;

use capwalk_boundary::{Accel, Flow, FlowSource, Stream, Viewpoint, Visibility};
use capwalk_geometry::Hit;
use capwalk_math::{Frame, Vec3};

use super::was_settings::{WasBoundary, WasSettings};
use super::weighted_mean::{self, Share, edge_test, ray_numbers, relative_density};

/// An auxiliary ray.
struct Auxiliary {
    /// Its unit direction `z`.
    direction: Vec3,
    /// One over the density that it was drawn with, up to a constant.
    inverse_density: f64,
    /// `B`, the boundary test.
    boundary: f64,
    /// What it hits.
    hit: Option<Hit>,
}

/// The velocity of the direction `q` and the divergence there, as a map from the
/// velocities of the vertices around what auxiliary rays hit, Eq. (7).
pub(super) fn flow(
    accel: &Accel,
    viewpoint: &Viewpoint<f64>,
    q: Vec3,
    settings: &WasSettings,
    numbers: &Stream,
) -> Flow {
    let draw =
        |index, rays: &mut Vec<_>| batch(accel, viewpoint, q, settings, numbers, index, rays);
    let weight = |ray: &Auxiliary| weight(ray, q, settings.kappa);
    let (rays, shares) = weighted_mean::shares(settings, numbers, draw, weight, curvature(q));
    flow_of(accel, &rays, &shares)
}

/// The covector on the mean in the divergence of its tangent part.
fn curvature(q: Vec3) -> Vec3 {
    q * -2.0
}

/// Draws as many auxiliary rays as the settings say, the `index`-th batch.
fn batch(
    accel: &Accel,
    viewpoint: &Viewpoint<f64>,
    q: Vec3,
    settings: &WasSettings,
    numbers: &Stream,
    index: u32,
    rays: &mut Vec<Auxiliary>,
) {
    let frame = Frame::from_normal(q);
    for (u, mirrored) in ray_numbers(settings, numbers, index) {
        let (local, inverse_density) = sample_direction(settings.kappa, u);
        let local = match mirrored {
            true => Vec3::new(-local.x, -local.y, local.z),
            false => local,
        };
        let direction = frame.to_world(local).normalized();
        let hit = cast(accel, viewpoint, direction);
        rays.push(Auxiliary {
            direction,
            inverse_density,
            boundary: match &hit {
                None => 1.0,
                Some(hit) => boundary_test(accel, settings.boundary, hit, direction),
            },
            hit,
        });
    }
}

/// A direction around `+z` with a density proportional to `e^{κ (cos θ - 1)}`
/// (von Mises and Fisher) where that is not tiny; and the inverse of this
/// number.
fn sample_direction(kappa: f64, u: [f64; 2]) -> (Vec3, f64) {
    let s = relative_density(u[1]);
    let density = s + (1.0 - s) * (-2.0 * kappa).exp();
    let height = -density.ln() / kappa; // 1 - cos θ
    let sin_theta = (height * (2.0 - height)).max(0.0).sqrt();
    let (sin_phi, cos_phi) = (2.0 * PI * u[0]).sin_cos();
    let direction = Vec3::new(sin_theta * cos_phi, sin_theta * sin_phi, 1.0 - height);
    (direction, 1.0 / density)
}

/// What the viewpoint sees in a direction.
pub(super) fn cast(accel: &Accel, viewpoint: &Viewpoint<f64>, direction: Vec3) -> Option<Hit> {
    let position = viewpoint.position;
    match viewpoint.visibility {
        Visibility::Camera => accel.first_hit_within(&accel.camera_ray(position, direction)),
        Visibility::All | Visibility::Surface => accel.first_hit(position, direction),
    }
}

/// `B`: zero at silhouettes, at most about one.
pub(super) fn boundary_test(accel: &Accel, test: WasBoundary, hit: &Hit, direction: Vec3) -> f64 {
    let weights = corner_weights(hit);
    match test {
        WasBoundary::Edges => edge_test(weights),
        // Normals turn away from the viewpoint at silhouettes of smooth surfaces. The
        // mean is not normalised (Falcor).
        WasBoundary::Normals => {
            let shape_id = accel.shape_of(hit);
            let shape = accel.scene.shape(shape_id);
            let normal = match shape.normals.per_vertex() {
                None => accel.mesh.face_cross(hit.face as usize).normalized(),
                Some(normals) => {
                    let first = accel.first_vertex[shape_id.0 as usize];
                    let corners = accel.mesh.faces[hit.face as usize];
                    let [a, b, c] = corners.map(|i| normals[(i - first) as usize]);
                    a * weights[0] + b * weights[1] + c * weights[2]
                }
            };
            normal.dot(direction).powi(2)
        }
    }
}

pub(super) fn corner_weights(hit: &Hit) -> [f64; 3] {
    let [b, c] = hit.barycentric;
    [1.0 - b - c, b, c]
}

/// `D`, zero where `z` is `q`.
fn distance(q: Vec3, z: Vec3, kappa: f64) -> f64 {
    (0.5 * kappa * (q - z).length_squared()).exp_m1()
}

/// `w(z; q)` over the density of `z`, Eq. (8), and its gradient by `q` on the
/// tangent plane.
fn weight(ray: &Auxiliary, q: Vec3, kappa: f64) -> (f64, Vec3) {
    let distance = distance(q, ray.direction, kappa);
    let gradient = ray.direction.reject_from(q) * (-kappa * (distance + 1.0));
    weighted_mean::weight(ray.inverse_density, (distance, gradient), ray.boundary)
}

/// The same as a map from the velocities of vertices: a hit keeps its place on the
/// triangle, so it is seen to move with `V = P_z (Σ b_k ẋ_k - ȯ) / r`.
fn flow_of(accel: &Accel, rays: &[Auxiliary], shares: &[Share]) -> Flow {
    let mut flow = Flow::default();
    let (mut viewpoint_columns, mut viewpoint_divergence) = ([Vec3::zero(); 3], Vec3::zero());
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for (ray, share) in rays.iter().zip(shares) {
        let Some(hit) = &ray.hit else {
            continue;
        };
        let angular = |v: Vec3| v.reject_from(ray.direction) / hit.t;
        let columns = axes.map(|[x, y, z]| angular(Vec3::new(x, y, z)) * share.weight);
        let divergence = angular(share.divergence);
        for (&corner, b) in accel.mesh.faces[hit.face as usize]
            .iter()
            .zip(corner_weights(hit))
        {
            flow.add(
                FlowSource::Point(corner),
                columns.map(|column| column * b),
                divergence * b,
            );
        }
        for (sum, column) in viewpoint_columns.iter_mut().zip(columns) {
            *sum += -column;
        }
        viewpoint_divergence += -divergence;
    }
    flow.add(
        FlowSource::Viewpoint,
        viewpoint_columns,
        viewpoint_divergence,
    );
    flow
}

#[cfg(test)]
mod tests;
