//! The flux through the edges of lamps, METHOD 3: the field runs over them,
//! and what it carries across is taken back.
//!
//! Lamp edges are few and known. Were they boundaries of the field, it would
//! be singular wherever a shadow's edge runs over the lamp's own, and the
//! variance would diverge.

use capwalk_boundary::{Accel, Boundaries, Numbers, Viewpoint, beside};
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::EmitterId;
use capwalk_walk::WalkSettings;

use crate::light::emitter_towards;
use crate::scene_eval::{Primal, SceneEval};
use crate::surface::emitted_at;
use crate::vertex::Vertex;

/// Zero, with the derivative of the light reflected at a surface by the motion
/// of lamp edges against the field,
///
/// ```text
/// ∮ [f(inside) - f(outside)] (u_edge - u)·n dl
/// ```
///
/// along the lamps' edges on the sphere of directions, from one point drawn on
/// them by length with the number `u`. `f` is the light of all emitters that
/// `counts` accepts, so that it does not matter what lies behind the lamp, nor what
/// hides it. `vertex` is the surface at rest, `eye` the same point in motion.
#[allow(clippy::too_many_arguments, reason = "a formula with many symbols")]
pub fn emitter_edge_term<R: Real, W: SceneEval<R>>(
    accel: &Accel,
    boundaries: &Boundaries,
    eval: &W,
    viewpoint: &Viewpoint<R>,
    vertex: &Vertex<f64>,
    u: f64,
    walk: &WalkSettings,
    numbers: Numbers,
    counts: impl Fn(EmitterId) -> bool,
) -> Rgb<R> {
    let edges = &boundaries.emitter_edges;
    let Some(total) = edges.last().map(|edge| edge.cumulative) else {
        return Rgb::zero();
    };
    let target = u * total;
    let i = edges
        .partition_point(|edge| edge.cumulative <= target)
        .min(edges.len() - 1);
    let lamp_edge = &edges[i];
    let [a, b] = lamp_edge.ends.map(|v| eval.vertex(v));
    let along = (b - a).value();
    let length = along.length();
    let t = ((lamp_edge.cumulative - target) / length).clamp(0.0, 1.0);

    // The moving direction of the edge, and that of the field.
    let offset = a + (b - a) * R::constant(t) - viewpoint.position;
    let edge = offset.normalized();
    let q = edge.value();
    let warped = eval.warp_value(viewpoint, q, walk, numbers);
    // Per unit of length along the edge, the curve on the sphere advances by
    // P_q ê / r; this is its normal times that length.
    let across = q.cross(along) / (length * offset.value().length());
    let share = total / lamp_edge.multiplicity(t);
    let flow = (edge - warped).dot(Vec3::constant(across * share));
    // Not a number where the surface touches the edge: it goes on, to be counted.
    if flow.is_constant() {
        return Rgb::zero();
    }
    let normal = across.normalized();
    // The normal points from the first side to the second.
    let [behind, before] =
        beside(q, normal).map(|direction| emitted_and_reflected(accel, vertex, direction, &counts));
    Rgb::constant(behind - before) * flow
}

/// The light of those emitters that `counts` accepts that arrives at a surface from a
/// direction, as reflected there.
pub fn emitted_and_reflected(
    accel: &Accel,
    vertex: &Vertex<f64>,
    direction: Vec3,
    counts: impl Fn(EmitterId) -> bool,
) -> Rgb {
    let origin = vertex.position;
    let hit = accel.first_hit(origin, direction);
    let emitter = emitter_towards(accel, hit.as_ref(), direction);
    let Some(emitter) = emitter.filter(|&emitter| counts(emitter)) else {
        return Rgb::zero();
    };
    let eval = Primal(accel);
    let radiance = emitted_at(&eval, accel, emitter, hit.as_ref(), origin, direction);
    vertex.eval(direction) * radiance
}
