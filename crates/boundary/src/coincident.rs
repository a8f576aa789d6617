//! Edges that lie on each other in space.

use capwalk_geometry::{Edge, Halt};
use capwalk_math::Vec3;
use capwalk_math::near_key::near_key;

use crate::emitter_edge::SWEEP;

/// Difference of lines, as a fraction of how far from the origin they are, up to which they may be
/// the same: more than rounding.
const SAME_LINE: f64 = 1e-7;

/// Edges that are nearer to the origin than the farthest ones by this factor are compared among
/// themselves with a tolerance of their own; log₂. With that of far ones, a small thing in a wide
/// scene would have all of its edges on one line, and none of them longer than the tolerance.
const NEARER: f64 = 12.0;

/// An edge on its line.
struct OnLine {
    edge: usize,
    /// True if it is one of the farthest: pairs of others are visited later.
    is_far: bool,
    /// Equal for edges on the same line, and for hardly any others.
    key: f64,
    /// Where it starts and ends along the line, world units.
    range: [f64; 2],
}

/// The row of an edge that certainly lies on no part of another one.
pub const ALONE: u32 = u32::MAX;

/// For each edge the number of its row: edges of which one may lie on a part of the other are in
/// the same one. In rare cases others are, too.
pub fn rows(edges: &[Edge], positions: &[Vec3], halt: &Halt) -> Vec<u32> {
    // Each edge leads to an earlier one of its row, and the first one to itself.
    let mut rows: Vec<u32> = (0..edges.len() as u32).collect();
    visit_overlaps(edges, positions, halt, |pair| {
        let [a, b] = pair.map(|edge| first_of_row(&mut rows, edge as u32));
        rows[a.max(b) as usize] = a.min(b);
    });
    let mut is_alone = vec![true; edges.len()];
    for edge in 0..edges.len() as u32 {
        let first = first_of_row(&mut rows, edge);
        rows[edge as usize] = first;
        if first != edge {
            is_alone[first as usize] = false;
        }
    }
    for (edge, row) in rows.iter_mut().enumerate() {
        if *row == edge as u32 && is_alone[edge] {
            *row = ALONE;
        }
    }
    rows
}

/// The first edge of a row that another one is in. Shortens the way there.
fn first_of_row(rows: &mut [u32], mut edge: u32) -> u32 {
    while rows[edge as usize] != edge {
        rows[edge as usize] = rows[rows[edge as usize] as usize];
        edge = rows[edge as usize];
    }
    edge
}

/// Calls `visit` with all pairs of edges of which one may lie on a part of the other; with some of
/// them if the work is given up.
pub fn visit_overlaps<T>(
    edges: &[Edge],
    positions: &[Vec3],
    halt: &Halt,
    mut visit: impl FnMut([usize; 2]) -> T,
) {
    let ends = |edge: usize| edges[edge].vertices.map(|i| positions[i as usize]);
    let size = |p: Vec3| p.x.abs().max(p.y.abs()).max(p.z.abs());
    let distance = |edge: usize| ends(edge).map(size).into_iter().fold(0.0, f64::max);
    let mut distances: Vec<(usize, f64)> = (0..edges.len())
        .map(|edge| (edge, distance(edge)))
        .collect();
    // The farthest with all others, then the farthest of these with the rest, and so on.
    while !distances.is_empty() {
        let scale = distances
            .iter()
            .fold(f64::MIN_POSITIVE, |most, &(_, distance)| most.max(distance));
        let is_far = |distance: f64| distance >= scale * (-NEARER).exp2();
        let on_lines = distances
            .iter()
            .filter_map(|&(edge, distance)| on_line(edge, ends(edge), scale, is_far(distance)));
        visit_overlaps_of(on_lines.collect(), scale, halt, &mut visit);
        distances.retain(|&(_, distance)| !is_far(distance));
    }
}

/// Calls `visit` with the pairs of which one is far.
fn visit_overlaps_of<T>(
    mut on_lines: Vec<OnLine>,
    scale: f64,
    halt: &Halt,
    visit: &mut impl FnMut([usize; 2]) -> T,
) {
    // Sort by lines: edges of one line are neighbours then.
    on_lines.sort_unstable_by(|a, b| a.key.total_cmp(&b.key));
    for line in on_lines.chunk_by_mut(|a, b| b.key - a.key <= SAME_LINE) {
        // Along each line, compare each edge with those that have not ended before it starts.
        line.sort_unstable_by(|a, b| a.range[0].total_cmp(&b.range[0]));
        let (mut far, mut near): (Vec<&OnLine>, Vec<&OnLine>) = (Vec::new(), Vec::new());
        for next in &*line {
            if halt.now() {
                return;
            }
            let is_open = |before: &&OnLine| before.range[1] > next.range[0] + SAME_LINE * scale;
            far.retain(is_open);
            for before in &far {
                visit([before.edge, next.edge]);
            }
            if next.is_far {
                near.retain(is_open);
                for before in &near {
                    visit([before.edge, next.edge]);
                }
                far.push(next);
            } else {
                near.push(next);
            }
        }
    }
}

/// `None` for an edge without length.
fn on_line(edge: usize, [a, b]: [Vec3; 2], scale: f64, is_far: bool) -> Option<OnLine> {
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
        is_far,
        key,
        range: [s.min(t), s.max(t)],
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use capwalk_geometry::Sides;

    /// The row of each edge.
    fn found(segments: &[[[f64; 3]; 2]]) -> Vec<u32> {
        let positions: Vec<Vec3> = segments.iter().flatten().map(|&p| p.into()).collect();
        let edges: Vec<Edge> = (0..segments.len() as u32)
            .map(|i| Edge {
                vertices: [2 * i, 2 * i + 1],
                sides: Sides::Open,
                groups: 1,
            })
            .collect();
        rows(&edges, &positions, &Halt::never())
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
        let expected = [0, 0, ALONE, 3, 3, ALONE, ALONE, ALONE];
        assert_eq!(found(&segments), expected);
    }

    /// A small thing in a wide scene: its edges overlap each other as they do without, and an edge
    /// of what is wide where they lie on it.
    #[test]
    fn overlaps_are_found_in_wide_scenes() {
        let segments = [
            [[0.0, 0.3, 0.1], [1.0, 0.3, 0.1]],
            [[0.6, 0.3, 0.1], [2.0, 0.3, 0.1]],
            [[0.0, 0.3, 0.7], [1.0, 0.3, 0.7]],
            [[-4e9, 2e6, 0.0], [4e9, 2e6, 0.0]],
            [[-3e9, 2e6, 0.0], [-1e9, 2e6, 0.0]],
            [[-2e6, 2e6, 0.0], [1e6, 2e6, 0.0]],
        ];
        let expected = [0, 0, ALONE, 3, 3, 3];
        assert_eq!(found(&segments), expected);
    }

    /// Many parallel edges of small things beside a wide one take no longer than without: a
    /// few seconds in all are far more than that. With one tolerance for all, every pair overlaps.
    #[test]
    fn small_parallel_edges_in_wide_scenes_are_told_apart() {
        let place = |i: usize| [0.0, (i % 300) as f64, (i / 300) as f64];
        let small = (0..30_000).map(|i| {
            let [x, y, z] = place(i);
            [[x, y, z], [x + 1e3, y, z]]
        });
        let wide = [[1e9, 0.0, 0.0], [1e9, 1e9, 0.0]];
        let segments: Vec<[[f64; 3]; 2]> = small.chain([wide]).collect();
        let started = std::time::Instant::now();
        assert!(found(&segments).iter().all(|&row| row == ALONE));
        let taken = started.elapsed().as_secs_f64();
        assert!(taken < 5.0, "{taken} s");
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
                assert_eq!(found(&segments), [0, 0], "{segments:?}");
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
        // An edge is in the row of the first edge that is reached from it over overlaps.
        let overlap = |i: usize, k: usize| {
            let ((line, from, to), (other, a, b)) = (places[i], places[k]);
            k != i && other == line && a < to && from < b
        };
        let row = |edge: usize| {
            let mut reached = vec![edge];
            let mut next = 0;
            while let Some(&i) = reached.get(next) {
                let more: Vec<usize> = (0..600)
                    .filter(|k| overlap(i, *k) && !reached.contains(k))
                    .collect();
                reached.extend(more);
                next += 1;
            }
            match reached.iter().min() {
                Some(&first) if reached.len() > 1 => first as u32,
                _ => ALONE,
            }
        };
        let expected: Vec<u32> = (0..600).map(row).collect();
        let alone = expected.iter().filter(|&&row| row == ALONE).count();
        assert!((1..500).contains(&alone), "{alone}");
        assert_eq!(found(&segments), expected);
    }
}
