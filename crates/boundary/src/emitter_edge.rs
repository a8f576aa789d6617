//! The emitter edges with a term of their own (METHOD 3), and where they coincide: at
//! emitters that touch.

use capwalk_math::Vec3;

/// An edge of an emitter with few edges.
#[derive(Clone, Debug)]
pub struct EmitterEdge {
    /// Its ends, vertices of the joined mesh.
    pub ends: [u32; 2],
    /// Total length of the edges up to and including it.
    pub cumulative: f64,
    /// Where other emitters' edges lie on it. In lengths from its first end over its
    /// own.
    shared: Vec<[f64; 2]>,
}

impl EmitterEdge {
    /// How many edges coincide at a place on it, itself included: each of them adds its
    /// share of the discontinuity there.
    pub fn multiplicity(&self, t: f64) -> f64 {
        let covers = |[from, to]: &&[f64; 2]| *from <= t && t <= *to;
        1.0 + self.shared.iter().filter(covers).count() as f64
    }
}

/// Edges between these vertices, in this order.
pub fn emitter_edges(ends: &[[u32; 2]], positions: &[Vec3]) -> Vec<EmitterEdge> {
    let segments: Vec<[Vec3; 2]> = ends
        .iter()
        .map(|ends| ends.map(|i| positions[i as usize]))
        .collect();
    let mut length = 0.0;
    let edges = segments.iter().zip(ends).zip(shared(&segments));
    let edges = edges.map(|(([a, b], &ends), shared)| {
        length += (*b - *a).length();
        EmitterEdge {
            ends,
            cumulative: length,
            shared,
        }
    });
    edges.collect()
}

/// Fraction of its length by which an edge may lie beside another one and still
/// lie on it.
const ON_EDGE: f64 = 1e-10;

/// Where the second of two edges lies on the first one, if it does.
fn overlap([a, b]: [Vec3; 2], other: [Vec3; 2]) -> Option<[f64; 2]> {
    let along = b - a;
    let squared = along.length_squared();
    if squared == 0.0 {
        return None;
    }
    let is_beside = |p: &Vec3| {
        let distance = (*p - a).cross(along).length_squared();
        distance > (ON_EDGE * squared) * (ON_EDGE * squared)
    };
    if other.iter().any(is_beside) {
        return None;
    }
    let [s, t] = other.map(|p| (p - a).dot(along) / squared);
    let (from, to) = (s.min(t).max(0.0), s.max(t).min(1.0));
    (to - from > ON_EDGE).then_some([from, to])
}

/// A direction that scenes are not aligned with: along it, emitters in a grid have
/// different coordinates.
pub const SWEEP: Vec3 = Vec3::new(0.536_187_1, 0.618_033_9, 0.575_219_3);

/// Where other edges lie on each edge, in the order of the others. Only edges whose
/// shadows on a line overlap are compared.
fn shared(segments: &[[Vec3; 2]]) -> Vec<Vec<[f64; 2]>> {
    // The interval of each edge along that direction, with a margin for edges beside it and
    // for rounding.
    let mut intervals: Vec<(f64, f64, usize)> = (0..segments.len())
        .map(|i| {
            let [a, b] = segments[i];
            let [s, t] = [a, b].map(|p| p.dot(SWEEP));
            let margin = 2.0 * ON_EDGE * (b - a).length() + 1e-12 * s.abs().max(t.abs());
            (s.min(t) - margin, s.max(t) + margin, i)
        })
        .collect();
    intervals.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut found: Vec<Vec<(usize, [f64; 2])>> = vec![Vec::new(); segments.len()];
    for (rank, &(_, end, i)) in intervals.iter().enumerate() {
        let behind = intervals[rank + 1..].iter();
        for &(_, _, k) in behind.take_while(|(start, ..)| *start <= end) {
            for (on, other) in [(i, k), (k, i)] {
                if let Some(place) = overlap(segments[on], segments[other]) {
                    found[on].push((other, place));
                }
            }
        }
    }
    let in_order = |mut places: Vec<(usize, [f64; 2])>| {
        places.sort_by_key(|(other, _)| *other);
        places.into_iter().map(|(_, place)| place).collect()
    };
    found.into_iter().map(in_order).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Squares in a grid that touch, some of them moved, turned or shrunk: emitters
    /// by the dozen.
    fn squares(count: usize, mut random: u64) -> Vec<[Vec3; 2]> {
        let mut number = || {
            random = random
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (random >> 40) as f64 / (1u64 << 24) as f64
        };
        let mut segments = Vec::new();
        for i in 0..count {
            let corner = Vec3::new((i % 8) as f64, (i / 8) as f64, 0.5);
            let (size, lift) = match i % 5 {
                1 => (0.5, 0.0),
                2 => (1.0, 0.3 * number()),
                3 => (number(), 0.0),
                _ => (1.0, 0.0),
            };
            let at = |x: f64, y: f64| corner + Vec3::new(size * x, size * y, lift);
            let ring = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
            segments.extend((0..4).map(|k| [ring[k], ring[(k + 1) % 4]]));
        }
        // A long edge beside many, and one without length.
        segments.push([Vec3::new(-1.0, 1.0, 0.5), Vec3::new(9.0, 1.0, 0.5)]);
        segments.push([Vec3::new(1.0, 1.0, 0.5); 2]);
        segments
    }

    #[test]
    fn the_sweep_finds_what_all_pairs_find() {
        for seed in 0..20 {
            let segments = squares(3 + 4 * seed as usize, seed);
            let swept = shared(&segments);
            let mut total = 0;
            for (i, &segment) in segments.iter().enumerate() {
                let others = segments.iter().enumerate().filter(|&(k, _)| k != i);
                let all = others.filter_map(|(_, &other)| overlap(segment, other));
                let all: Vec<[f64; 2]> = all.collect();
                total += all.len();
                assert_eq!(swept[i], all, "seed {seed}, edge {i}");
            }
            assert!(total > seed as usize, "{total}");
        }
    }

    #[test]
    fn two_squares_share_an_edge() {
        let p = Vec3::new;
        let positions = [p(0.0, 0.0, 0.0), p(0.0, 2.0, 0.0), p(0.0, 1.0, 0.0)];
        let edges = emitter_edges(&[[0, 1], [2, 0], [1, 1]], &positions);
        assert_eq!(edges[0].shared, [[0.0, 0.5]]);
        assert_eq!([0.2, 0.7].map(|t| edges[0].multiplicity(t)), [2.0, 1.0]);
        assert_eq!(edges[1].shared, [[0.0, 1.0]]);
        assert_eq!(edges[2].cumulative, 3.0);
    }
}
