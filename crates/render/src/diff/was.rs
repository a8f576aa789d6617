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
//! what misses, where `B` is one as in Mitsuba 3.4: with zero, outlines before
//! the sky would stay at rest. Their clamps for single precision are left out:
//! they are biased for any number of rays.

use std::f64::consts::PI;

use capwalk_geometry::Hit;
use capwalk_math::{Frame, Real, Vec3};

use crate::accel::Accel;
use crate::options::{WasBoundary, WasSettings};
use crate::sampler::Stream;

use super::boundary::{Eye, Visibility};
use super::flow::{Flow, Source};

/// `γ`, how fast weights fall off.
const EXPONENT: i32 = 3;
/// Rays are drawn where the density is above this part of its maximum.
const LEAST_DENSITY: f64 = 1e-6;
/// `D + B` below this counts as this: zero only if a ray is drawn in the very
/// direction of an edge, and the cube of its inverse is finite.
const LEAST_DENOMINATOR: f64 = 1e-12;
/// Probability of another doubling in the debiased estimator: between 1/4, where
/// its variance would be infinite for bounded weights, and 1/2, where its cost
/// would be.
const DOUBLING: f64 = 0.4;
/// Most doublings. The bias of so many rays, 2^12 times as many, is left.
const MAX_DOUBLINGS: u32 = 12;

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

/// What the velocity of one ray's hit does to the mean.
#[derive(Clone, Copy)]
struct Share {
    /// Its weight in the velocity.
    weight: f64,
    /// The covector on it in the divergence.
    divergence: Vec3,
}

impl Share {
    fn none() -> Self {
        Self {
            weight: 0.0,
            divergence: Vec3::zero(),
        }
    }
}

/// The velocity of the direction `q` and the divergence there, as a map from the
/// velocities of the vertices around what auxiliary rays hit, Eq. (7).
pub fn flow<R: Real>(
    accel: &Accel,
    eye: &Eye<R>,
    q: Vec3,
    settings: &WasSettings,
    numbers: &Stream,
) -> Flow {
    let count = settings.rays as usize;
    let mut rays = Vec::with_capacity(count);
    let mut drawn = 0;
    let mut draw = |rays: &mut Vec<Auxiliary>| {
        batch(accel, eye, q, settings, numbers, drawn, rays);
        drawn += 1;
    };
    draw(&mut rays);
    let mut shares = vec![Share::none(); count];
    let kappa = settings.kappa;
    add_ratio(&rays, q, kappa, 1.0, &mut shares);
    if settings.debias {
        // A telescoping sum over estimates with twice as many rays each (McLeish
        // 2011), cut by roulette. What is added is compared with the mean of
        // both halves, which makes it small (Blanchet and Glynn 2015).
        let mut probability = 1.0;
        for level in 0..MAX_DOUBLINGS {
            if numbers.number(level) >= DOUBLING {
                break;
            }
            probability *= DOUBLING;
            let half = rays.len();
            while rays.len() < 2 * half {
                draw(&mut rays);
            }
            shares.resize(rays.len(), Share::none());
            let factor = 1.0 / probability;
            add_ratio(&rays, q, kappa, factor, &mut shares);
            for part in [0..half, half..2 * half] {
                let halves = &mut shares[part.clone()];
                add_ratio(&rays[part], q, kappa, -0.5 * factor, halves);
            }
        }
    }
    flow_of(accel, &rays, &shares)
}

/// Draws as many auxiliary rays as the settings say, the `index`-th batch.
fn batch<R: Real>(
    accel: &Accel,
    eye: &Eye<R>,
    q: Vec3,
    settings: &WasSettings,
    numbers: &Stream,
    index: u32,
    rays: &mut Vec<Auxiliary>,
) {
    let frame = Frame::from_normal(q);
    let first = MAX_DOUBLINGS + 2 * index * settings.rays;
    for i in 0..settings.rays {
        let mirrored = settings.antithetic && i % 2 == 1;
        let u = numbers.pair(first + 2 * (i - u32::from(mirrored)));
        let (local, inverse_density) = sample_direction(settings.kappa, u);
        let local = match mirrored {
            true => Vec3::new(-local.x, -local.y, local.z),
            false => local,
        };
        let direction = frame.to_world(local).normalized();
        let hit = cast(accel, eye, direction);
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
/// (von Mises and Fisher) where that is not below [`LEAST_DENSITY`]; and the
/// inverse of this number.
fn sample_direction(kappa: f64, u: [f64; 2]) -> (Vec3, f64) {
    let s = (1.0 - u[1]).max(LEAST_DENSITY);
    let density = s + (1.0 - s) * (-2.0 * kappa).exp();
    let height = -density.ln() / kappa; // 1 - cos θ
    let sin_theta = (height * (2.0 - height)).max(0.0).sqrt();
    let (sin_phi, cos_phi) = (2.0 * PI * u[0]).sin_cos();
    let direction = Vec3::new(sin_theta * cos_phi, sin_theta * sin_phi, 1.0 - height);
    (direction, 1.0 / density)
}

/// What the eye sees in a direction.
fn cast<R: Real>(accel: &Accel, eye: &Eye<R>, direction: Vec3) -> Option<Hit> {
    let position = eye.position.value();
    match eye.visibility {
        Visibility::Camera => accel.first_hit_within(&accel.camera_ray(position, direction)),
        Visibility::All | Visibility::Surface => accel.first_hit(position, direction),
    }
}

/// `B`: zero at silhouettes, at most about one.
fn boundary_test(accel: &Accel, test: WasBoundary, hit: &Hit, direction: Vec3) -> f64 {
    let weights = corner_weights(hit);
    match test {
        // The distance to the next edge of the triangle as if it were
        // equilateral, one in its middle (Mitsuba 3.4).
        WasBoundary::Edges => 3.0 * weights.into_iter().fold(1.0, f64::min),
        // Normals turn away from the eye at outlines of smooth surfaces. The
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

fn corner_weights(hit: &Hit) -> [f64; 3] {
    let [b, c] = hit.barycentric;
    [1.0 - b - c, b, c]
}

/// `D`, zero where `z` is `q`.
fn distance(q: Vec3, z: Vec3, kappa: f64) -> f64 {
    (0.5 * kappa * (q - z).length_squared()).exp_m1()
}

/// `w(z; q)` over the density of `z`, Eq. (8), and its gradient by `q` on the
/// tangent plane. The density is not differentiated, nor is `B(z)`, which does
/// not depend on `q`.
fn weight(ray: &Auxiliary, q: Vec3, kappa: f64) -> (f64, Vec3) {
    let distance = distance(q, ray.direction, kappa);
    let denominator = (distance + ray.boundary).max(LEAST_DENOMINATOR);
    let weight = ray.inverse_density / denominator.powi(EXPONENT);
    let slope = f64::from(EXPONENT) * kappa * (distance + 1.0) * weight / denominator;
    (weight, ray.direction.reject_from(q) * slope)
}

/// Adds `factor` times the ratio estimate of Eq. (7) from these rays. With
/// `W = Σ w_i` the divergence of the tangent part of the mean is
///
/// ```text
/// Σ_i V_i · [ ∇w_i - (w_i / W) Σ_j ∇w_j ] / W  -  2 q·v
/// ```
fn add_ratio(rays: &[Auxiliary], q: Vec3, kappa: f64, factor: f64, shares: &mut [Share]) {
    let weights: Vec<_> = rays.iter().map(|ray| weight(ray, q, kappa)).collect();
    let start = (0.0, Vec3::zero());
    let (sum, slope_sum) = weights.iter().fold(start, |a, b| (a.0 + b.0, a.1 + b.1));
    let mean_slope = slope_sum / sum;
    for ((weight, slope), share) in weights.into_iter().zip(shares) {
        let part = weight / sum * factor;
        share.weight += part;
        share.divergence += slope * (factor / sum) - (mean_slope + q * 2.0) * part;
    }
}

/// The same as a map from the velocities of vertices: a hit keeps its place on the
/// triangle, so it is seen to move with `V = P_z (Σ b_k ẋ_k - ȯ) / r`.
fn flow_of(accel: &Accel, rays: &[Auxiliary], shares: &[Share]) -> Flow {
    let mut flow = Flow::default();
    let (mut eye_columns, mut eye_divergence) = ([Vec3::zero(); 3], Vec3::zero());
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
                Source::Point(corner),
                columns.map(|column| column * b),
                divergence * b,
            );
        }
        for (sum, column) in eye_columns.iter_mut().zip(columns) {
            *sum += -column;
        }
        eye_divergence += -divergence;
    }
    flow.add(Source::Eye, eye_columns, eye_divergence);
    flow
}

#[cfg(test)]
mod tests;
