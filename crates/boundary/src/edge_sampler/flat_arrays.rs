//! The tree as flat arrays, for devices. `capwalk_geometry::sampler_buffers` describes them.

use capwalk_geometry::sampler_buffers::{BOUNDS, NONE, SamplerBuffers};
use capwalk_math::Vec3;

use super::{EdgeBounds, EdgeSampler};

impl EdgeSampler {
    /// The tree as flat arrays.
    pub fn buffers(&self) -> SamplerBuffers {
        let nodes = self.nodes.iter().flat_map(|node| {
            let [first, second] = node
                .halves
                .map_or([NONE; 2], |halves| halves.map(|i| i as u32));
            [
                first,
                second,
                node.places.start as u32,
                node.places.end as u32,
            ]
        });
        let edges = self.edges.iter();
        let numbers = edges.clone().flat_map(|edge| {
            let [first, second] = edge.outward_crosses();
            let [a, b] = edge.ends;
            let vectors = [a, b, first, second].map(Vec3::to_array);
            let lengths = [first.length(), second.length()];
            vectors.into_iter().flatten().chain(lengths)
        });
        SamplerBuffers {
            nodes: nodes.collect(),
            bounds: self
                .nodes
                .iter()
                .flat_map(|node| numbers_of(&node.bounds))
                .collect(),
            ends_and_normals: numbers.collect(),
            factors: edges
                .clone()
                .flat_map(|edge| [edge.exposure, edge.crease])
                .collect(),
            edges: edges.map(|edge| edge.edge).collect(),
        }
    }
}

/// The numbers of bounds, as the flat arrays have them.
fn numbers_of(bounds: &EdgeBounds) -> [f64; BOUNDS] {
    let (centre, normals) = (bounds.centre, bounds.normals);
    let sin = if normals.sin.is_finite() {
        normals.sin
    } else {
        2.0
    };
    let mut numbers = [0.0; BOUNDS];
    numbers[..3].copy_from_slice(&centre.to_array());
    numbers[3] = bounds.radius;
    numbers[4..7].copy_from_slice(&normals.axis.to_array());
    numbers[7] = sin;
    numbers[8] = (1.0 - sin * sin).max(0.0).sqrt();
    numbers[9] = bounds.height;
    numbers[10] = bounds.length;
    numbers[11] = bounds.visibility.reach();
    numbers[12..].copy_from_slice(&bounds.visibility.shares().map(f64::from));
    numbers
}
