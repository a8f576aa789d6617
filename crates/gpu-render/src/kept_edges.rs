//! A tree of some of a sampler's edges: where only some of them move, a tree of these is smaller.

use std::ops::Range;

use capwalk_geometry::sampler_buffers::{NODE, NONE, SamplerBuffers};

/// The most edges in a leaf, as in the sampler: more where few of them count.
const LEAF: [usize; 2] = [32, 12];

/// A tree of some edges.
pub struct KeptEdges {
    /// Their places in the sampler, in its order.
    pub edges: Vec<usize>,
    /// The root comes first.
    pub nodes: Vec<KeptNode>,
    /// The most edges in a leaf.
    pub leaf: usize,
}

/// A node of it.
pub struct KeptNode {
    /// The node of the sampler whose bounds are around it.
    pub source: usize,
    /// Both halves; none in a leaf.
    pub halves: Option<[usize; 2]>,
    /// Its edges.
    pub edges: Range<usize>,
}

impl KeptEdges {
    /// Those of the edges that are kept; `None` if none is.
    pub fn new(buffers: &SamplerBuffers, kept: &[bool]) -> Option<Self> {
        let edges: Vec<usize> = (0..kept.len()).filter(|&i| kept[i]).collect();
        let mut tree = Self {
            edges,
            nodes: Vec::new(),
            leaf: LEAF[usize::from(buffers.all_edges)],
        };
        if tree.edges.is_empty() {
            return None;
        }
        tree.add(buffers.nodes.as_chunks::<NODE>().0, 0);
        Some(tree)
    }

    /// Adds what is kept of a node, which is something, and returns its number.
    fn add(&mut self, nodes: &[[u32; NODE]], source: usize) -> usize {
        let [first, second, start, end] = nodes[source];
        let kept = |nodes: &[u32; NODE]| {
            let [start, end] = [nodes[2], nodes[3]].map(|i| i as usize);
            self.edges.partition_point(|&i| i < start)..self.edges.partition_point(|&i| i < end)
        };
        let edges = kept(&[first, second, start, end]);
        let halves = (first != NONE && edges.len() > self.leaf).then(|| [first, second]);
        if let Some(halves) = halves {
            let halves = halves.map(|half| half as usize);
            // Where all that is kept is in one half, that stands for the node.
            let full = halves.map(|half| !kept(&nodes[half]).is_empty());
            match full {
                [true, false] => return self.add(nodes, halves[0]),
                [false, true] => return self.add(nodes, halves[1]),
                _ => {}
            }
            let number = self.nodes.len();
            self.nodes.push(KeptNode {
                source,
                halves: None,
                edges,
            });
            let halves = halves.map(|half| self.add(nodes, half));
            self.nodes[number].halves = Some(halves);
            return number;
        }
        self.nodes.push(KeptNode {
            source,
            halves: None,
            edges,
        });
        self.nodes.len() - 1
    }
}
