//! Some of a tree's edges, among which alone a gather searches.

use super::silhouette_tree::SilhouetteTree;
use crate::bvh::any_below;

/// Some of the edges of a [`SilhouetteTree`]: of this tree, as it is now.
#[derive(Clone, Debug)]
pub struct EdgeSubset {
    /// For each node, which of its children have one of them below, by bits.
    pub(super) children: Vec<u8>,
    /// For each leaf, which of its edges are among them, by bits.
    pub(super) edges: Vec<u8>,
}

impl SilhouetteTree {
    /// The edges for whose numbers `contains` holds, found in time linear in the tree.
    pub fn subset(&self, contains: impl Fn(u32) -> bool) -> EdgeSubset {
        let starts = &self.hierarchy.leaf_starts;
        let of_leaf = |range: &[u32]| {
            let edges = &self.edges[range[0] as usize..range[1] as usize];
            bits(edges.iter().map(|edge| contains(edge.id)))
        };
        let edges: Vec<u8> = starts.windows(2).map(of_leaf).collect();
        let below = any_below(&self.hierarchy, |leaf| edges[leaf] != 0);
        let children = below.into_iter().map(|children| bits(children.into_iter()));
        EdgeSubset {
            children: children.collect(),
            edges,
        }
    }
}

/// The bits of up to eight flags, the first one lowest.
fn bits(flags: impl Iterator<Item = bool>) -> u8 {
    flags
        .zip(0..)
        .fold(0, |bits, (flag, i)| bits | u8::from(flag) << i)
}
