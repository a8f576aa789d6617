//! The tree of silhouettes: the closest one, Algorithm 5, and all in a cone.

use std::ops::Range;

use rayon::prelude::*;

use super::cone_node::ConeNode;
use super::edge_block::{self, EdgeBlock, LocalEdge};
use super::tree_edge::TreeEdge;
use crate::aabb::Aabb;
use crate::bvh::{Hierarchy, Leaves, Splits, SurfaceCost, build, child_bounds, child_leaves};
use crate::edge::Edge;
use crate::halt::{Halt, Halted};
use crate::local_frame::LocalFrame;
use crate::mesh::Mesh;
use crate::simd::Instructions;

/// Edges per leaf: as many as are tested at a time.
pub(super) const LEAF_SIZE: usize = edge_block::LANES;

/// A tree over the edges of a mesh, with cones of their faces' normals. It
/// keeps what it needs of the mesh.
///
/// Answers are bitwise those of
/// [`oracle::closest_silhouette`](crate::oracle::closest_silhouette), on every
/// CPU: bounds only decide what need not be tested.
#[derive(Clone, Debug)]
pub struct SilhouetteTree {
    pub(super) hierarchy: Hierarchy,
    pub(super) frame: LocalFrame,
    pub(super) nodes: Vec<ConeNode>,
    pub(super) leaves: Vec<EdgeBlock>,
    /// The edges in the order of the leaves: what queries need, and the rest.
    pub(super) edges: Vec<TreeEdge>,
    pub(super) sources: Vec<Edge>,
    cost: SurfaceCost,
    pub(super) instructions: Instructions,
}

impl SilhouetteTree {
    /// Builds the tree. `edges` may come from several meshes as long as they
    /// index `mesh`.
    pub fn build(mesh: &Mesh, edges: &[Edge]) -> Self {
        Self::try_build(mesh, edges, &Halt::never()).expect("nobody gives it up")
    }

    /// [`Self::build`], unless the work is given up.
    pub fn try_build(mesh: &Mesh, edges: &[Edge], halt: &Halt) -> Result<Self, Halted> {
        let frame = frame_of(mesh, edges);
        let bounds: Vec<Aabb> = edges
            .par_iter()
            .with_min_len(1024)
            .map(|edge| {
                let ends = edge.vertices.map(|i| mesh.positions[i as usize]);
                Aabb::around(ends.map(|p| frame.local_from_world(p)))
            })
            .collect();
        let hierarchy =
            halt.unless_halted(build(&bounds, Leaves::of(LEAF_SIZE), Splits::Coarse, halt))?;
        let mut tree = Self {
            sources: hierarchy
                .order
                .iter()
                .map(|&id| edges[id as usize])
                .collect(),
            hierarchy,
            frame,
            nodes: Vec::new(),
            leaves: Vec::new(),
            edges: Vec::new(),
            cost: SurfaceCost::default(),
            instructions: Instructions::detect(),
        };
        tree.refit(mesh);
        tree.cost.now_is_new();
        halt.now();
        halt.unless_halted(tree)
    }

    /// Follows moved vertices; faces and edges must be those it was built with.
    /// Takes time in proportion to the number of edges and the depth of the
    /// tree, and memory for one copy of the edges.
    ///
    /// For these edges, answers stay exact however far vertices move: the closest
    /// silhouettes are bit for bit those of a new tree, and the same edges are
    /// gathered, in an order that may differ. They only take longer, see
    /// [`degradation`](Self::degradation). Whether these still are the edges of
    /// the mesh is another question, see [`topology`](crate::topology).
    pub fn refit(&mut self, mesh: &Mesh) {
        let hierarchy = &self.hierarchy;
        (&hierarchy.order, &self.sources)
            .into_par_iter()
            .with_min_len(1024)
            .map(|(&id, edge)| TreeEdge::new(mesh, id, edge))
            .collect_into_vec(&mut self.edges);
        self.frame = LocalFrame::around(self.edges.iter().flat_map(|edge| edge.ends));
        let local: Vec<LocalEdge> = (&self.edges, &self.sources)
            .into_par_iter()
            .with_min_len(1024)
            .map(|(edge, source)| edge.local(&self.frame, source.groups))
            .collect();
        let below = |leaves: Range<u32>| {
            let [start, end] = [leaves.start, leaves.end]
                .map(|leaf| hierarchy.leaf_starts[leaf as usize] as usize);
            (start, &local[start..end])
        };
        let mut leaf_bounds = Vec::new();
        (0..hierarchy.leaf_count() as u32)
            .into_par_iter()
            .with_min_len(256)
            .map(|leaf| {
                let (start, edges) = below(leaf..leaf + 1);
                let bounds = Aabb::around(edges.iter().flat_map(|edge| edge.ends));
                (EdgeBlock::new(start, edges), bounds)
            })
            .unzip_into_vecs(&mut self.leaves, &mut leaf_bounds);
        let leaves = child_leaves(hierarchy);
        (&hierarchy.nodes, &leaves)
            .into_par_iter()
            .map(|(children, leaves)| ConeNode::new(children, |slot| below(leaves[slot].clone()).1))
            .collect_into_vec(&mut self.nodes);
        self.cost.update(&child_bounds(hierarchy, &leaf_bounds));
    }

    /// The surface-area cost of the tree over that when it was built: 1 for a new
    /// tree, and larger the less the mesh resembles the one it was built for.
    pub fn degradation(&self) -> f64 {
        self.cost.degradation()
    }

    /// Uses these instructions from now on. The answers stay the same.
    #[cfg(test)]
    pub fn with(self, instructions: Instructions) -> Self {
        Self {
            instructions,
            ..self
        }
    }
}

fn frame_of(mesh: &Mesh, edges: &[Edge]) -> LocalFrame {
    let ends = edges.iter().flat_map(|edge| edge.vertices);
    LocalFrame::around(ends.map(|i| mesh.positions[i as usize]))
}
