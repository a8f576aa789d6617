//! The boundary term of emitter edges (METHOD 3): the velocity field ignores these
//! edges, and a line integral along them accounts for the difference.
//!
//! Emitter edges are few and known. If the field followed them too, it would be
//! singular wherever the silhouette of an occluder crosses an emitter edge, and the
//! variance would be infinite.

use capwalk_boundary::{Accel, Boundaries, Viewpoint, beside};
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::EmitterId;

use crate::light::emitter_towards;
use crate::scene_eval::{Primal, SceneEval};
use crate::surface::emitted_at;
use crate::vertex::Vertex;

/// Fraction of the distance to an edge by which what hides it must be nearer: more than the
/// rounding of what meets at the edge.
pub const SHORT_OF_EDGE: f64 = 1e-9;

/// An estimate of the emitter-edge term: a number of value zero whose derivative is
///
/// ```text
/// ∮ [f(inside) - f(outside)] (u_edge - u)·n dl
/// ```
///
/// along the edges on the sphere of directions around the shading point. `f` is the
/// radiance of the emitters that `counts` accepts, times BSDF and cosine; `u_edge` is
/// the angular velocity of the edge, `u` the field's, and `n` the normal of the edge's
/// projection. Both sides are traced, so it does not matter what is behind an emitter
/// or in front of it.
///
/// `vertex` is the primal shading point and `viewpoint` the same point with its
/// derivatives; `u` in `[0, 1)` chooses a point on the edges, uniformly by length, and `warped`
/// gives the direction to it as the field moves it.
#[allow(clippy::too_many_arguments, reason = "a formula with many symbols")]
pub fn emitter_edge_term<R: Real, W: SceneEval<R>>(
    accel: &Accel,
    boundaries: &Boundaries,
    eval: &W,
    viewpoint: &Viewpoint<R>,
    vertex: &Vertex<f64>,
    u: f64,
    warped: impl FnOnce(Vec3) -> Vec3<R>,
    counts: impl Fn(EmitterId) -> bool,
) -> Rgb<R> {
    let edges = &boundaries.emitter_edges;
    let Some(total) = edges.last().map(|edge| edge.cumulative) else {
        return Rgb::zero();
    };
    // Choose an edge in proportion to its length, and reuse the random number for the
    // place on it.
    let target = u * total;
    let i = edges
        .partition_point(|edge| edge.cumulative <= target)
        .min(edges.len() - 1);
    let chosen = &edges[i];
    let [a, b] = chosen.ends.map(|v| eval.vertex(v));
    let along = (b - a).value();
    let length = along.length();
    let t = ((chosen.cumulative - target) / length).clamp(0.0, 1.0);

    // Evaluate the direction to that point, which moves with u_edge, and the same
    // direction warped by the field, which moves with u.
    let offset = a + (b - a) * R::constant(t) - viewpoint.position;
    let edge = offset.normalized();
    let q = edge.value();
    let warped = warped(q);
    // n dl: per unit of length along the edge ê, its projection advances by P_q ê / r
    // on the sphere, and q × ê / r is the normal times that length.
    let across = q.cross(along) / (length * offset.value().length());
    // Divide by the density 1 / total. Where edges of several emitters coincide, each of
    // them finds the same step in f and takes its share of it.
    let share = total / chosen.multiplicity(t);
    let flow = (edge - warped).dot(Vec3::constant(across * share));
    // Skip the two rays where nothing moves. A shading point on the edge itself gives a
    // NaN, which is not constant and is counted with the sample.
    if flow.is_constant() {
        return Rgb::zero();
    }
    // Trace both sides of the edge; the normal points from the first to the second.
    let normal = across.normalized();
    let [behind, before] =
        beside(q, normal).map(|direction| emitted_and_reflected(accel, vertex, direction, &counts));
    Rgb::constant(behind - before) * flow
}

/// Emitted radiance that arrives from `direction` at the shading point, times BSDF and
/// cosine; zero if what is seen is no emitter that `counts` accepts.
pub fn emitted_and_reflected(
    accel: &Accel,
    vertex: &Vertex<f64>,
    direction: Vec3,
    counts: impl Fn(EmitterId) -> bool,
) -> Rgb {
    emitted_past(accel, vertex, direction, 0.0, counts)
}

/// [`emitted_and_reflected`] for emitters farther than `distance`; zero if anything is nearer.
pub fn emitted_past(
    accel: &Accel,
    vertex: &Vertex<f64>,
    direction: Vec3,
    distance: f64,
    counts: impl Fn(EmitterId) -> bool,
) -> Rgb {
    let origin = vertex.position;
    let hit = accel.first_hit(origin, direction);
    if hit
        .as_ref()
        .is_some_and(|hit| hit.t < distance * (1.0 - SHORT_OF_EDGE))
    {
        return Rgb::zero();
    }
    let emitter = emitter_towards(accel, hit.as_ref(), direction);
    let Some(emitter) = emitter.filter(|&emitter| counts(emitter)) else {
        return Rgb::zero();
    };
    let eval = Primal(accel);
    let radiance = emitted_at(&eval, accel, emitter, hit.as_ref(), origin, direction);
    vertex.eval(direction) * radiance
}

/// Radiance of the environment from `direction` at the shading point, times BSDF and
/// cosine; zero if anything is in that direction.
pub fn reflected_environment(
    accel: &Accel,
    vertex: &Vertex<f64>,
    direction: Vec3,
    environment: EmitterId,
) -> Rgb {
    let (eval, origin) = (Primal(accel), vertex.position);
    let radiance = emitted_at(&eval, accel, environment, None, origin, direction);
    let light = vertex.eval(direction) * radiance;
    // False for NaN.
    if light == Rgb::zero() || !accel.surface_sees(origin, direction, f64::INFINITY) {
        return Rgb::zero();
    }
    light
}
