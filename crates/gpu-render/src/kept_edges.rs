//! A tree of some of a sampler's edges: where only some of them move, a tree of these is smaller.

use std::ops::Range;

use capwalk_geometry::sampler_buffers::{NODE, NONE, SamplerBuffers};

/// The most edges in a leaf. Also where creases count, of which the sampler has fewer: what one list has
/// is sampled better than what is in several.
pub const LEAF: usize = 32;

/// A tree of some edges.
pub struct KeptEdges {
    /// Their places in the sampler, in its order.
    pub edges: Vec<usize>,
    /// The root comes first.
    pub nodes: Vec<KeptNode>,
}

/// A node of it.
pub struct KeptNode {
    /// The node of the sampler whose bounds are around it.
    pub source: usize,
    /// The second half; none in a leaf. The first one is the next node.
    pub second: Option<usize>,
    /// The node after all that are below it.
    pub end: usize,
    /// Its edges.
    pub edges: Range<usize>,
}

impl KeptEdges {
    /// The tree of the edges that are kept; `None` if none is.
    pub fn new(buffers: &SamplerBuffers, kept: &[bool]) -> Option<Self> {
        let edges: Vec<usize> = (0..kept.len()).filter(|&i| kept[i]).collect();
        let mut tree = Self {
            edges,
            nodes: Vec::new(),
        };
        if tree.edges.is_empty() {
            return None;
        }
        tree.add(buffers.nodes.as_chunks::<NODE>().0, 0);
        Some(tree)
    }

    /// How many leaves there are.
    pub fn leaves(&self) -> usize {
        let leaves = self.nodes.iter().filter(|node| node.second.is_none());
        leaves.count()
    }

    /// Adds what is kept of a node, which is something, and returns its number.
    fn add(&mut self, nodes: &[[u32; NODE]], source: usize) -> usize {
        let [first, second, ..] = nodes[source];
        let edges = self.kept(&nodes[source]);
        let is_leaf = first == NONE || edges.len() <= LEAF;
        let halves = [first, second].map(|half| half as usize);
        if !is_leaf {
            // Where all that is kept is in one half, that stands for the node.
            for [empty, other] in [halves, [halves[1], halves[0]]] {
                if self.kept(&nodes[empty]).is_empty() {
                    return self.add(nodes, other);
                }
            }
        }
        let number = self.nodes.len();
        self.nodes.push(KeptNode {
            source,
            second: None,
            end: 0,
            edges,
        });
        if !is_leaf {
            let [_, second] = halves.map(|half| self.add(nodes, half));
            self.nodes[number].second = Some(second);
        }
        self.nodes[number].end = self.nodes.len();
        number
    }

    /// Which of the kept edges are in a node.
    fn kept(&self, [_, _, start, end]: &[u32; NODE]) -> Range<usize> {
        let place = |end: u32| self.edges.partition_point(|&i| i < end as usize);
        place(*start)..place(*end)
    }
}

#[cfg(test)]
mod tests {
    use capwalk_boundary::{Accel, Boundaries};
    use capwalk_geometry::EdgeSelection;
    use capwalk_math::{Affine, Vec3};
    use capwalk_scene::primitive::{cube, icosphere};
    use capwalk_scene::{BsdfId, ShadingNormals, Shape, builtin};

    use super::*;

    /// Each edge that is kept is in one leaf, whose node in the sampler has it; leaves are small.
    #[test]
    fn kept_edges_are_in_one_leaf_each() {
        let mut scene = builtin::scene("leaf").expect("built in");
        scene.shapes.clear();
        scene.emitters.clear();
        let away = Affine::translate(Vec3::new(3.0, 0.0, 0.0));
        for mesh in [icosphere(9), cube(away).0] {
            scene.add_shape(Shape::new("", mesh, ShadingNormals::Face, BsdfId(0)));
        }
        let accel = Accel::new(scene);
        let boundaries = Boundaries::new(&accel);
        for selection in [EdgeSelection::Silhouettes, EdgeSelection::All] {
            let buffers = boundaries.edge_sampler(&accel, selection).buffers();
            let count = buffers.edges.len();
            let nodes = buffers.nodes.as_chunks::<NODE>().0;
            assert!(KeptEdges::new(&buffers, &vec![false; count]).is_none());
            for step in [1, 2, 7, 300] {
                let kept: Vec<bool> = (0..count).map(|i| i % step == 0).collect();
                let tree = KeptEdges::new(&buffers, &kept).expect("some are kept");
                let mut listed: Vec<usize> = Vec::new();
                for node in tree.nodes.iter().filter(|node| node.second.is_none()) {
                    let [_, _, start, end] = nodes[node.source];
                    let edges = &tree.edges[node.edges.clone()];
                    assert!(edges.len() <= LEAF && !edges.is_empty());
                    assert!(edges.iter().all(|&i| (start..end).contains(&(i as u32))));
                    listed.extend(edges);
                }
                let expected: Vec<usize> = (0..count).filter(|&i| kept[i]).collect();
                assert_eq!(listed, expected);
                // The first half follows its node, the second one the first.
                assert_eq!(tree.nodes[0].end, tree.nodes.len());
                for (i, node) in tree.nodes.iter().enumerate() {
                    let Some(second) = node.second else {
                        assert_eq!(node.end, i + 1);
                        continue;
                    };
                    let halves = [&tree.nodes[i + 1], &tree.nodes[second]];
                    assert_eq!(halves.map(|half| half.end), [second, node.end]);
                    let edges = halves.map(|half| half.edges.clone());
                    assert_eq!(edges[0].start..edges[1].end, node.edges);
                }
                let is_whole = step == 1 && selection == EdgeSelection::Silhouettes;
                assert!(!is_whole || tree.nodes.len() == nodes.len());
            }
        }
    }
}
