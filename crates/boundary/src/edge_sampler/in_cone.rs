//! An edge sampled in a cone, and the tree as flat arrays for devices that do the same. The
//! formulas are described in `capwalk_geometry::sampler_buffers`.

use std::f64::consts::PI;

use capwalk_geometry::edge::closest_direction;
use capwalk_geometry::sampler_buffers::{BOUNDS, DrawnEdge, EdgeCone, NONE, SamplerBuffers};
use capwalk_geometry::{EdgeSelection, LocalFrame};
use capwalk_math::Vec3;

use super::{EdgeBounds, EdgeSampler};

impl EdgeSampler {
    /// An edge that counts and meets the cone. `None` if the numbers lead to none: they choose
    /// a few edges first, among which there need not be one. All that there are have a
    /// probability above 0, but those without length.
    pub fn sample_in_cone(&self, cone: &EdgeCone) -> Option<DrawnEdge> {
        let [u, mut v] = cone.numbers;
        let subtree = self.descend(cone.apex, u, |_, bounds| importance(cone, bounds))?;
        let mut sum = 0.0;
        let mut chosen = None;
        for counted in self.counted(&subtree, cone.apex) {
            let [a, b] = counted.ends.map(|p| p - cone.apex);
            let meets = closest_direction(a, b, cone.axis)
                .is_some_and(|closest| closest.angle < cone.max_angle || cone.max_angle >= PI);
            let weight = counted.factor * (b - a).length() / (a.dot(a) + b.dot(b));
            let is_one = meets && weight > 0.0; // false for NaN
            if !is_one {
                continue;
            }
            sum += weight;
            let share = weight / sum;
            if v < share || chosen.is_none() {
                chosen = Some((counted.edge, weight));
                v /= share;
            } else {
                v = (v - share) / (1.0 - share);
            }
        }
        let (edge, weight) = chosen?;
        Some(DrawnEdge {
            edge,
            probability: subtree.probability * (weight / sum),
        })
    }

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
            frame: LocalFrame::around(edges.clone().flat_map(|edge| edge.ends)),
            all_edges: self.selection == EdgeSelection::All,
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

/// The importance of edges for a cone; zero if they certainly do not meet it.
fn importance(cone: &EdgeCone, bounds: &EdgeBounds) -> f64 {
    let offset = bounds.centre - cone.apex;
    let square = offset.dot(offset);
    if is_beside(cone, bounds, offset, square.sqrt()) {
        return 0.0;
    }
    let scale = square.max(bounds.radius * bounds.radius);
    let length = bounds.visible_length(cone.apex);
    if scale > 0.0 { length / scale } else { 0.0 }
}

/// True if the ball around edges certainly does not meet the cone.
fn is_beside(cone: &EdgeCone, bounds: &EdgeBounds, offset: Vec3, distance: f64) -> bool {
    let [sin, cos] = cone.sin_cos();
    let z = cone.axis.dot(offset);
    let radial = offset - cone.axis * z;
    let rho = radial.dot(radial).sqrt();
    // In the plane of the axis and the centre, how far that is from the side of the cone, and
    // how far along it; behind the apex, that is nearest.
    let (beside, along) = (rho * cos - z * sin, rho * sin + z * cos);
    if beside < 0.0 {
        return false;
    }
    let least = if along < 0.0 { distance } else { beside };
    least > bounds.radius + bounds.clear(cone.apex)
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
