//! How the tree of an edge sampler divides its edges into two groups.

use capwalk_math::Vec3;

use crate::sampled_edge::SampledEdge;

/// Bins along each axis among whose borders a node is divided.
const BINS: usize = 16;

/// Deeper nodes are halved, however their edges lie.
const DEEP: u32 = 60;

/// Orders edges so that two groups follow each other, and returns where the second one
/// starts: at the border of a bin for which the boxes around the groups, weighed by what is
/// in them, have the least surface.
pub fn divide(edges: &mut [SampledEdge], depth: u32) -> usize {
    let boxes = |edges: &[SampledEdge]| {
        let middles = edges.iter().map(SampledEdge::middle);
        let none = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
        middles.fold(none, |(low, high), p| (low.min(p), high.max(p)))
    };
    let (low, high) = boxes(edges);
    let size = high - low;
    let bins_of = |edge: &SampledEdge| {
        let offset = (edge.middle() - low).to_array();
        // Not a number along axes without extent, which is bin 0.
        [0, 1, 2].map(|axis| {
            let place = offset[axis] / size[axis] * BINS as f64;
            (place as usize).min(BINS - 1)
        })
    };
    let mut bins = [[Bin::EMPTY; BINS]; 3];
    for edge in &*edges {
        let own = Bin::of(edge);
        for (bins, bin) in bins.iter_mut().zip(bins_of(edge)) {
            bins[bin].add(&own);
        }
    }
    let mut best = (f64::INFINITY, 0, 0);
    for axis in (0..3).filter(|&axis| size[axis] > 0.0 && depth < DEEP) {
        let bins = &bins[axis];
        // What is behind each border, from the last to the first.
        let mut behind = *bins;
        for i in (1..BINS - 1).rev() {
            let next = behind[i + 1];
            behind[i].add(&next);
        }
        let mut before = Bin::EMPTY;
        for i in 1..BINS {
            before.add(&bins[i - 1]);
            let cost = before.cost() + behind[i].cost();
            if before.weight > 0.0 && behind[i].weight > 0.0 && cost < best.0 {
                best = (cost, axis, i);
            }
        }
    }
    let (cost, axis, border) = best;
    if cost < f64::INFINITY {
        // In the order in which they were.
        let is_before = |edge: &SampledEdge| bins_of(edge)[axis] < border;
        let (mut first, mut others) = (0, Vec::new());
        for i in 0..edges.len() {
            if is_before(&edges[i]) {
                edges[first] = edges[i];
                first += 1;
            } else {
                others.push(edges[i]);
            }
        }
        edges[first..].copy_from_slice(&others);
        if first > 0 && first < edges.len() {
            return first;
        }
    }
    edges.len() / 2
}

/// Edges in a box.
#[derive(Clone, Copy)]
pub struct Bin {
    pub low: Vec3,
    pub high: Vec3,
    /// The sum of lengths, each times its share.
    pub weight: f64,
}

impl Bin {
    pub const EMPTY: Self = Self {
        low: Vec3::new(f64::INFINITY, f64::INFINITY, f64::INFINITY),
        high: Vec3::new(f64::NEG_INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY),
        weight: 0.0,
    };

    pub fn of(edge: &SampledEdge) -> Self {
        let [a, b] = edge.ends;
        Self {
            low: a.min(b),
            high: a.max(b),
            weight: edge.weight,
        }
    }

    pub fn add(&mut self, other: &Self) {
        self.low = self.low.min(other.low);
        self.high = self.high.max(other.high);
        self.weight += other.weight;
    }

    /// The surface of the box times what is in it.
    fn cost(&self) -> f64 {
        if self.weight == 0.0 {
            return 0.0;
        }
        let Vec3 { x, y, z } = self.high - self.low;
        (x * y + y * z + z * x) * self.weight
    }
}
