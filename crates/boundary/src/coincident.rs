//! Edges that lie on each other in space.

use capwalk_geometry::Edge;
use capwalk_math::Vec3;
use capwalk_math::near_key::near_key;

use crate::emitter_edge::SWEEP;

/// Difference of lines, as a fraction of the scene's size, up to which they may be the
/// same: more than rounding.
const SAME_LINE: f64 = 1e-7;

/// An edge on its line.
struct OnLine {
    edge: usize,
    /// Equal for edges on the same line, and for hardly any others.
    key: f64,
    /// Where it starts and ends along the line, world units.
    range: [f64; 2],
}

/// For each edge, whether it may lie on a part of another one. Never false if it does; in
/// rare cases true if it does not.
pub fn may_coincide(edges: &[Edge], positions: &[Vec3]) -> Vec<bool> {
    let mut found = vec![false; edges.len()];
    visit_overlaps(edges, positions, |pair| pair.map(|edge| found[edge] = true));
    found
}

/// Calls `visit` with all pairs of edges of which one may lie on a part of the other.
pub fn visit_overlaps<T>(
    edges: &[Edge],
    positions: &[Vec3],
    mut visit: impl FnMut([usize; 2]) -> T,
) {
    let ends = |edge: &Edge| edge.vertices.map(|i| positions[i as usize]);
    let size = |p: Vec3| p.x.abs().max(p.y.abs()).max(p.z.abs());
    let sizes = edges.iter().flat_map(ends).map(size);
    let scale = sizes.fold(f64::MIN_POSITIVE, f64::max);
    // Sort by lines: edges of one line are neighbours then.
    let on_lines = edges.iter().enumerate();
    let mut on_lines: Vec<OnLine> = on_lines
        .filter_map(|(edge, what)| on_line(edge, ends(what), scale))
        .collect();
    on_lines.sort_unstable_by(|a, b| a.key.total_cmp(&b.key));
    for line in on_lines.chunk_by_mut(|a, b| b.key - a.key <= SAME_LINE) {
        // Along each line, compare each edge with those that have not ended before it starts.
        line.sort_unstable_by(|a, b| a.range[0].total_cmp(&b.range[0]));
        let mut open: Vec<&OnLine> = Vec::new();
        for next in &*line {
            open.retain(|before| before.range[1] > next.range[0] + SAME_LINE * scale);
            for before in &open {
                visit([before.edge, next.edge]);
            }
            open.push(next);
        }
    }
}

/// `None` for an edge without length.
fn on_line(edge: usize, [a, b]: [Vec3; 2], scale: f64) -> Option<OnLine> {
    let along = b - a;
    let length = along.length();
    if length == 0.0 {
        return None;
    }
    // Both orders of the ends give the same line: its direction goes along the sweep. No
    // component would do, since where it is half of the length, rounding would decide.
    let sign = along.dot(SWEEP).signum();
    let d = along * (sign / length);
    // The point of the line closest to the origin.
    let foot = (a - d * a.dot(d)) / scale;
    let numbers = [
        d.x * d.x,
        d.y * d.y,
        d.x * d.y,
        d.y * d.z,
        d.z * d.x,
        d.z * d.z,
        foot.x,
        foot.y,
        foot.z,
    ];
    let key = near_key(&numbers);
    let [s, t] = [a, b].map(|p| p.dot(d));
    Some(OnLine {
        edge,
        key,
        range: [s.min(t), s.max(t)],
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use capwalk_geometry::Sides;

    fn found(segments: &[[[f64; 3]; 2]]) -> Vec<bool> {
        let positions: Vec<Vec3> = segments.iter().flatten().map(|&p| p.into()).collect();
        let edges: Vec<Edge> = (0..segments.len() as u32)
            .map(|i| Edge {
                vertices: [2 * i, 2 * i + 1],
                sides: Sides::Open,
                groups: 1,
            })
            .collect();
        may_coincide(&edges, &positions)
    }

    /// Edges that overlap along a line, in either order of their ends; not those that
    /// follow each other on it, run beside it, or cross it.
    #[test]
    fn overlaps_are_found() {
        let at = |t: f64| [0.3 - 0.7 * t, 1.1 * t, 0.2 + 0.4 * t];
        let beside = |t: f64| [0.3 - 0.7 * t, 1.1 * t + 1e-4, 0.2 + 0.4 * t];
        let segments = [
            [at(0.0), at(1.0)],
            [at(0.5), at(2.0)],
            [at(2.0), at(3.0)],
            [at(4.0), at(3.5)],
            [at(3.4), at(4.5)],
            [beside(0.0), beside(5.0)],
            [at(0.2), beside(0.9)],
            [at(7.0), at(7.0)],
        ];
        let expected = [true, true, false, true, true, false, false, false];
        assert_eq!(found(&segments), expected);
    }

    /// Lines at 60° to an axis, as in things that are turned by 60°: half of the length is
    /// along it, give or take rounding.
    #[test]
    fn overlaps_are_found_at_sixty_degrees() {
        let (sin, cos) = (PI / 3.0).sin_cos();
        for d in [[cos, -sin, 0.0], [cos, 0.0, -sin], [0.0, cos, -sin]] {
            for i in 0..200 {
                let number = |k: i32| f64::from(7 * i + k).sin();
                let origin = [1, 2, 3].map(number);
                let at = |t: f64| [0, 1, 2].map(|k| origin[k] + t * d[k]);
                let t = [4, 5].map(|k| 3.0 + number(k));
                let segments = [[at(0.0), at(t[0])], [at(t[1] - 1.0), at(t[0] + t[1])]];
                assert_eq!(found(&segments), [true, true], "{segments:?}");
            }
        }
    }

    /// Every overlap among many edges on few lines, by brute force.
    #[test]
    fn overlaps_are_those_of_brute_force() {
        let number = |i: usize| ((i as f64 * 12.9898).sin() * 43758.5453).fract().abs();
        let mut segments = Vec::new();
        let mut places = Vec::new();
        for i in 0..600 {
            let line = i % 40;
            let d = [0, 1, 2].map(|k| number(7 * line + k) - 0.5);
            let o = [3, 4, 5].map(|k| number(7 * line + k));
            let from = 20.0 * number(1000 + i);
            let to = from + 0.5 * number(5000 + i) + 0.01;
            let at = |t: f64| [0, 1, 2].map(|k| o[k] + t * d[k]);
            let ends = if i % 3 == 0 {
                [at(from), at(to)]
            } else {
                [at(to), at(from)]
            };
            segments.push(ends);
            places.push((line, from, to));
        }
        let expected: Vec<bool> = (0..600)
            .map(|i| {
                let (line, from, to) = places[i];
                (0..600).any(|k| {
                    let (other, a, b) = places[k];
                    k != i && other == line && a < to && from < b
                })
            })
            .collect();
        assert!(expected.contains(&true) && expected.contains(&false));
        assert_eq!(found(&segments), expected);
    }
}
