//! The flux through edges before lamps, METHOD 8: directions towards lamps stay,
//! and what moves across them is sampled on the edges themselves.

use capwalk_boundary::{Draw, Field, SilhouettePieces, Viewpoint, Window, clip, place};
use capwalk_math::{Real, Rgb, Vec3};

use crate::emitter_edge_term::emitted_and_reflected;
use crate::scene_eval::SceneEval;
use crate::vertex::Vertex;

/// Points drawn on the edges around each lamp that is looked at.
const POINTS: u32 = 2;
/// Random numbers that [`gathered_term`] takes.
pub const NUMBERS: u32 = 2;

/// Distance by which the planes of a window are moved outward, in distances of the
/// edge: more than rounding.
const IN_PLANE: f64 = 1e-9;

/// Longest piece of an edge that a weight is given to, radians: lobes are narrow.
const PIECE: f64 = 0.05;
const MOST_PIECES: f64 = 32.0;

/// Weight of an edge before what reflects no light from its middle, in those of
/// the mean of all edges: there may be light beside the middle.
const LEAST_WEIGHT: f64 = 0.1;
/// And where there is none at all.
const TINY: f64 = 1e-30;

/// Zero, with the derivative of the light of lamps reflected at a surface by the
/// motion of all edges against directions at rest,
///
/// ```text
/// Σ ∮ [f(inside) - f(outside)] u_edge·n dl
/// ```
///
/// along all edges before a lamp and its own, on the sphere of directions, from
/// points drawn on them. `f` is the light of one lamp, drawn uniformly with the
/// first of the [`NUMBERS`] from `dimension` on. `vertex` is the surface at
/// rest, `eye` the same point in motion.
pub fn gathered_term<R: Real, W: SceneEval<R>>(
    field: &Field,
    eval: &W,
    viewpoint: &Viewpoint<R>,
    vertex: &Vertex<f64>,
    draw: Draw,
    dimension: u32,
) -> Rgb<R> {
    let lamps = &field.boundaries.area_emitters;
    if lamps.is_empty() || eval.is_still(viewpoint) {
        return Rgb::zero();
    }
    let [choice, place] = draw.stream.pair(dimension);
    let lamp = &lamps[((choice * lamps.len() as f64) as usize).min(lamps.len() - 1)];
    let Some(window) = lamp.window(vertex.position) else {
        return Rgb::zero();
    };
    draw.count_queries(1);
    let outline = outline(field, vertex, &window);
    let mut light = Rgb::zero();
    for i in 0..POINTS {
        let u = (f64::from(i) + place) / f64::from(POINTS);
        let Some(point) = outline.draw(field.boundaries, vertex.position, u) else {
            continue;
        };
        let warped = Vec3::constant(point.direction);
        let ends = point.ends().map(|i| eval.boundary_point(i));
        let flow = point.flow(ends, viewpoint.position, warped);
        // Not a number where the surface touches the edge: it goes on, to be counted.
        if !flow.is_constant() {
            let is_lamp = |emitter| emitter == lamp.emitter;
            let [behind, before] = point
                .sides()
                .map(|side| emitted_and_reflected(field.accel, vertex, side, is_lamp));
            // Hidden edges look the same on both sides.
            let share = lamps.len() as f64 / f64::from(POINTS);
            light += Rgb::constant((behind - before) * share) * flow;
        }
    }
    light
}

/// The edges before a lamp, by their angles and what the surface reflects of light
/// from their middles.
fn outline(field: &Field, vertex: &Vertex<f64>, window: &Window) -> SilhouettePieces {
    let mut found: Vec<(u32, [f64; 2], f64, f64)> = Vec::new();
    let mut sum = 0.0;
    for (edge, ends) in field.boundaries.gather(&window.cone) {
        let [a, b] = ends.map(|p| p - vertex.position);
        // What lies in a plane of the window, as the lamp's own edges do, is inside.
        let margin = IN_PLANE * a.length().max(b.length());
        let Some(range) = clip(&window.planes, margin, [a, b]) else {
            continue;
        };
        let ends = range.map(|t| a + (b - a) * t);
        let [near, far] = ends.map(Vec3::length);
        let [from, to] = [ends[0] / near, ends[1] / far];
        // Equal steps on the chord between the directions.
        let chord = to - from;
        let count = (chord.length() / PIECE).ceil().clamp(1.0, MOST_PIECES);
        let place = |part| place(range, [near, far], part);
        for i in 0..count as u32 {
            let part = |k: f64| (f64::from(i) + k) / count;
            let middle = from + chord * part(0.5);
            let reflected = vertex.eval(middle.normalized()).max_component();
            // What is seen end-on has no middle.
            if reflected.is_finite() {
                sum += reflected;
                let range = [place(part(0.0)), place(part(1.0))];
                found.push((edge, range, chord.length() / count, reflected));
            }
        }
    }
    let least = LEAST_WEIGHT * sum / found.len() as f64 + TINY;
    let mut outline = SilhouettePieces::default();
    for (edge, range, chord, reflected) in found {
        outline.push(edge, range, chord * (reflected + least));
    }
    outline
}
