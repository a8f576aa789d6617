//! The flux through the edges of lamps, METHOD 3: the field runs over them,
//! and what it carries across is taken back.
//!
//! Lamp edges are few and known. Were they boundaries of the field, it would
//! be singular wherever a shadow's edge runs over the lamp's own, and the
//! variance would diverge.

use capwalk_math::Rgb;
use capwalk_scene::Diffuse;

use crate::light::emitter_towards;
use crate::world::{AtRest, Surface, World};

use super::boundary::{Eye, Numbers};
use super::forward::Forward;

/// Radians by which a ray passes a lamp's edge on either side of it. The
/// integrand is taken this far from where it jumps, which changes the flux by
/// a fraction of this size.
const BESIDE_EDGE: f64 = 1e-7;

/// Derivative of the light reflected at a surface by the motion of lamp edges
/// against the field,
///
/// ```text
/// ∮ [f(inside) - f(outside)] (u_edge - u)·n dl
/// ```
///
/// along the lamps' edges on the sphere of directions, from one point drawn on
/// them by length. `f` is all light that arrives, so that it does not matter
/// what lies behind the lamp, nor what hides it.
pub fn lamp_edge_flux(
    forward: &Forward,
    eye: &Eye,
    surface: &Surface<f64>,
    reflectance: Rgb,
    u: f64,
    numbers: Numbers,
) -> Rgb {
    let boundaries = &forward.field.boundaries;
    let edges = &boundaries.lamp_edges;
    let Some(&(_, total)) = edges.last() else {
        return Rgb::zero();
    };
    let target = u * total;
    let i = edges
        .partition_point(|&(_, cumulative)| cumulative <= target)
        .min(edges.len() - 1);
    let (vertices, cumulative) = edges[i];
    let [a, b] = vertices.map(|v| boundaries.positions[v as usize]);
    let [va, vb] = vertices.map(|v| boundaries.velocities[v as usize]);
    let length = (b - a).length();
    let t = ((cumulative - target) / length).clamp(0.0, 1.0);

    let offset = a + (b - a) * t - eye.position.value();
    let distance = offset.length();
    let q = offset / distance;
    // Per unit of length along the edge, the curve on the sphere advances by
    // P_q ê / r; this is its normal times that length.
    let across = q.cross(b - a) / (length * distance);
    let normal = across.normalized();
    let edge_velocity = (va + (vb - va) * t - eye.position.tangent(0)).reject_from(q) / distance;
    let field = forward
        .field
        .sample_value(eye, q, &forward.light_walk, numbers);
    let flow = (edge_velocity - field).dot(across) * total;
    // Not a number where the surface touches the edge: it goes on, to be counted.
    if flow == 0.0 {
        return Rgb::zero();
    }
    let arriving = |side: f64| {
        let direction = (q + normal * (side * BESIDE_EDGE)).normalized();
        let hit = forward.accel.first_hit(surface.position, direction);
        let Some(emitter) = emitter_towards(forward.accel, hit.as_ref(), direction) else {
            return Rgb::zero();
        };
        let f = Diffuse::eval(reflectance, surface.normal.dot(direction));
        f.hadamard(AtRest(forward.accel).radiance(emitter))
    };
    // The normal points from the side of -1 to that of +1.
    (arriving(-1.0) - arriving(1.0)) * flow
}
