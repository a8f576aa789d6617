//! The boundary term of gathered silhouettes towards emitters (METHOD 8): sampled
//! directions do not move, and points are sampled on the projected edges instead.

use capwalk_boundary::{Draw, Field, SilhouettePieces, Viewpoint, Window, clip, place};
use capwalk_math::{Real, Rgb, Vec3};

use crate::emitter_edge_term::emitted_and_reflected;
use crate::scene_eval::SceneEval;
use crate::vertex::Vertex;

/// Points sampled on the edges in front of the chosen emitter.
const POINTS: u32 = 2;
/// How many random numbers [`gathered_term`] uses.
pub const NUMBERS: u32 = 2;

/// How far the planes of a window are moved outward, as a fraction of the edge's
/// distance: more than rounding.
const IN_PLANE: f64 = 1e-9;

/// Length of the longest piece that has one sampling weight, radians: lobes are narrow.
const PIECE: f64 = 0.05;
/// The most pieces of one edge.
const MOST_PIECES: f64 = 32.0;

/// Sampling weight of a piece from whose middle no light is reflected, relative to the
/// mean over all pieces: there may be light beside the middle.
const LEAST_WEIGHT: f64 = 0.1;
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
    // Gather the edges in its window, with sampling weights that know no velocity.
    draw.count_queries(1);
    let pieces = pieces(field, vertex, &window);
    let mut light = Rgb::zero();
    for i in 0..POINTS {
        // Sample a point on one of the edges, stratified.
        let u = (f64::from(i) + place) / f64::from(POINTS);
        let Some(point) = pieces.draw(field.boundaries, vertex.position, u) else {
            continue;
        };
        // Evaluate u_edge·n over the density. The sampled direction stays: the field is zero.
        let warped = Vec3::constant(point.direction);
        let ends = point.ends().map(|i| eval.boundary_point(i));
        let flow = point.flow(ends, viewpoint.position, warped);
        // Trace both sides only where something moves. A shading point on the edge itself
        // gives a NaN, which is not constant and is counted with the sample.
        if !flow.is_constant() {
            let is_chosen = |emitter| emitter == chosen.emitter;
            let [behind, before] = point
                .sides()
                .map(|side| emitted_and_reflected(field.accel, vertex, side, is_chosen));
            // Divide by the probability of the emitter and by the number of points.
            let share = emitters.len() as f64 / f64::from(POINTS);
            light += Rgb::constant((behind - before) * share) * flow;
        }
    }
    light
}

/// The edges in the window of an emitter, cut into pieces whose sampling weight is their
/// angle times the largest channel of BSDF and cosine in the direction of their middle.
fn pieces(field: &Field, vertex: &Vertex<f64>, window: &Window) -> SilhouettePieces {
    let mut found: Vec<(u32, [f64; 2], f64, f64)> = Vec::new();
    let mut sum = 0.0;
    for (edge, ends) in field.boundaries.gather(&window.cone) {
        let [a, b] = ends.map(|p| p - vertex.position);
        // Clip the edge to the window; the emitter's own edges, in its planes, count as inside.
        let margin = IN_PLANE * a.length().max(b.length());
        let Some(range) = clip(&window.planes, margin, [a, b]) else {
            continue;
        };
        let ends = range.map(|t| a + (b - a) * t);
        let [near, far] = ends.map(Vec3::length);
        let [from, to] = [ends[0] / near, ends[1] / far];
        // Cut it at equal steps on the chord between the directions of its ends.
        let chord = to - from;
        let count = (chord.length() / PIECE).ceil().clamp(1.0, MOST_PIECES);
        let place = |part| place(range, [near, far], part);
        for i in 0..count as u32 {
            let part = |k: f64| (f64::from(i) + k) / count;
            let middle = from + chord * part(0.5);
            let reflected = vertex.eval(middle.normalized()).max_component();
            // An edge seen end-on has no middle direction, and no angle.
            if reflected.is_finite() {
                sum += reflected;
                let range = [place(part(0.0)), place(part(1.0))];
                found.push((edge, range, chord.length() / count, reflected));
            }
        }
    }
    let least = LEAST_WEIGHT * sum / found.len() as f64 + TINY;
    let mut pieces = SilhouettePieces::default();
    for (edge, range, chord, reflected) in found {
        pieces.push(edge, range, chord * (reflected + least));
    }
    pieces
}
