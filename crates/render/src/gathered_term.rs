//! The boundary term of gathered silhouettes towards emitters (METHOD 8): sampled
//! directions do not move, and points are sampled on the projected edges instead, in
//! proportion to what they contribute (METHOD 10).

use std::cell::RefCell;

use capwalk_boundary::{Draw, EdgePoint, Field, SilhouettePieces, Viewpoint, Window, clip, place};
use capwalk_geometry::add_effort;
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::EmitterId;

use crate::emitter_edge_term::{emitted_and_reflected, emitted_past};
use crate::scene_eval::SceneEval;
use crate::vertex::Vertex;

/// How many random numbers [`gathered_term`] uses.
pub const NUMBERS: u32 = 2;

/// Points on the edges in front of the chosen emitter, for so many pieces: gathering them
/// is paid once, and where there are many pieces they differ more.
fn point_count(pieces: usize) -> u32 {
    ((pieces as f64).sqrt() as u32).clamp(LEAST_POINTS, MOST_POINTS)
}
const LEAST_POINTS: u32 = 2;
const MOST_POINTS: u32 = 32;

/// How far the planes of a window are moved outward, as a fraction of the edge's
/// distance: more than rounding.
const IN_PLANE: f64 = 1e-9;

/// The effort of weighing a piece: BSDF and cosine are evaluated.
const EFFORT_OF_PIECE: u64 = 10;

/// Length of the longest piece that has one sampling weight, radians: lobes are narrow.
const PIECE: f64 = 0.05;
/// The most pieces of one edge.
const MOST_PIECES: f64 = 32.0;

/// Share of the mean over all pieces that is added to what a piece contributes at its
/// middle: beside the middle there may be light, or motion.
const LEAST_WEIGHT: f64 = 0.03;
/// The same where that mean is zero.
const TINY: f64 = 1e-30;

/// An estimate of the boundary term of direct light: a number of value zero whose
/// derivative is
///
/// ```text
/// Σ ∮ [f(behind) - f(before)] u_edge·n dl
/// ```
///
/// over all edges in front of an emitter and its own, on the sphere of directions around
/// the shading point. `f` is the radiance of this emitter times BSDF and cosine, `u_edge`
/// the angular velocity of an edge, and `n` the normal of its projection, from behind to
/// before. Hidden edges need no visibility test: `f` is the same on both of their sides.
///
/// `vertex` is the primal shading point and `viewpoint` the same point with its
/// derivatives. The [`NUMBERS`] from `dimension` on choose the emitter and the points.
pub fn gathered_term<R: Real, W: SceneEval<R>>(
    field: &Field,
    eval: &W,
    viewpoint: &Viewpoint<R>,
    vertex: &Vertex<f64>,
    draw: Draw,
    dimension: u32,
) -> Rgb<R> {
    let emitters = &field.boundaries.area_emitters;
    if emitters.is_empty() || eval.is_still(viewpoint) {
        return Rgb::zero();
    }
    // Choose one emitter uniformly.
    let [choice, place] = draw.stream.pair(dimension);
    let chosen = &emitters[((choice * emitters.len() as f64) as usize).min(emitters.len() - 1)];
    let Some(window) = chosen.window(vertex.position) else {
        return Rgb::zero();
    };
    // Gather the edges in its window, with sampling weights.
    draw.count_queries(1);
    MEMORY.with_borrow_mut(|memory| {
        field.boundaries.gather(&window.cone, &mut memory.gathered);
        weigh(field, eval, viewpoint, vertex, &window, memory);
        let pieces = &memory.pieces;
        let points = point_count(pieces.count());
        let mut light = Rgb::zero();
        for i in 0..points {
            // Sample a point on one of the edges, stratified.
            let u = (f64::from(i) + place) / f64::from(points);
            let Some(point) = pieces.draw(field.boundaries, vertex.position, u) else {
                continue;
            };
            // Evaluate u_edge·n over the density. The sampled direction stays: the field is zero.
            let warped = Vec3::constant(point.direction);
            let ends = point.ends().map(|i| eval.boundary_point(i));
            let flow = point.flow(ends, viewpoint.position, warped);
            // Trace rays only where something moves. A shading point on the edge itself
            // gives a NaN, which is not constant and is counted with the sample.
            if !flow.is_constant() {
                let jump = discontinuity(field, vertex, &point, chosen.emitter);
                light += Rgb::constant(jump / f64::from(points)) * flow;
            }
        }
        // Divide by the probability of the emitter.
        light * R::constant(emitters.len() as f64)
    })
}

/// `f(behind) - f(before)` of one emitter at a point of an edge.
fn discontinuity(
    field: &Field,
    vertex: &Vertex<f64>,
    point: &EdgePoint,
    emitter: EmitterId,
) -> Rgb {
    let is_chosen = |other| other == emitter;
    let accel = field.accel;
    let [behind, before] = point.sides();
    match point.covered_side(field.boundaries, accel, vertex.position, emitter) {
        // The surface covers one side, and emits nothing there: one ray past the edge shows
        // whether the edge is seen, and what is behind it.
        Some(covered) => {
            let (direction, sign) = match covered {
                0 => (before, -1.0),
                _ => (behind, 1.0),
            };
            emitted_past(accel, vertex, direction, point.distance, is_chosen) * sign
        }
        None => {
            let [behind, before] =
                [behind, before].map(|side| emitted_and_reflected(accel, vertex, side, is_chosen));
            behind - before
        }
    }
}

/// Memory for one sample after another.
#[derive(Default)]
struct Memory {
    gathered: Vec<(u32, [Vec3; 2])>,
    weighed: Vec<Weighed>,
    pieces: SilhouettePieces,
}

/// A piece of an edge.
struct Weighed {
    edge: u32,
    range: [f64; 2],
    /// Radians.
    angle: f64,
    /// What it contributes if all of it is like its middle.
    contribution: f64,
}

thread_local! {
    static MEMORY: RefCell<Memory> = RefCell::default();
}

/// Cuts the gathered edges into pieces where they are in the window of an emitter. The
/// sampling weight of a piece is what it contributes if all of it is like its middle: its
/// angle times the largest channel of BSDF and cosine times the angular speed across the
/// edge.
fn weigh<R: Real, W: SceneEval<R>>(
    field: &Field,
    eval: &W,
    viewpoint: &Viewpoint<R>,
    vertex: &Vertex<f64>,
    window: &Window,
    memory: &mut Memory,
) {
    let Memory {
        gathered,
        weighed,
        pieces,
    } = memory;
    weighed.clear();
    for &(edge, ends) in &*gathered {
        let [a, b] = ends.map(|p| p - vertex.position);
        // Clip the edge to the window; the emitter's own edges, in its planes, count as inside.
        let margin = IN_PLANE * a.length().max(b.length());
        let Some(range) = clip(&window.planes, margin, [a, b]) else {
            continue;
        };
        let normal = a.cross(b).normalized();
        let points = field.boundaries.edge(edge).vertices;
        let ends = range.map(|t| a + (b - a) * t);
        let [near, far] = ends.map(Vec3::length);
        let [from, to] = [ends[0] / near, ends[1] / far];
        // Cut it at equal steps on the chord between the directions of its ends.
        let chord = to - from;
        let count = (chord.length() / PIECE).ceil().clamp(1.0, MOST_PIECES);
        let place = |part| place(range, [near, far], part);
        for i in 0..count as u32 {
            let part = |k: f64| (f64::from(i) + k) / count;
            let middle = (from + chord * part(0.5)).normalized();
            let reflected = vertex.eval(middle).max_component();
            let t = place(part(0.5));
            let distance = (a + (b - a) * t).length();
            let speed = eval.speed(points, t, viewpoint.position, normal) / distance;
            let angle = chord.length() / count;
            let contribution = angle * reflected * speed;
            // An edge seen end-on has no middle direction, and no angle.
            if contribution.is_finite() {
                weighed.push(Weighed {
                    edge,
                    range: [place(part(0.0)), place(part(1.0))],
                    angle,
                    contribution,
                });
            }
        }
    }
    add_effort(EFFORT_OF_PIECE * weighed.len() as u64);
    // Every piece has a share of its angle, too.
    let sum: f64 = weighed.iter().map(|piece| piece.contribution).sum();
    let angle: f64 = weighed.iter().map(|piece| piece.angle).sum();
    let least = LEAST_WEIGHT * sum / angle + TINY;
    pieces.clear();
    for piece in &*weighed {
        let weight = piece.contribution + least * piece.angle;
        pieces.push(piece.edge, piece.range, weight);
    }
}
