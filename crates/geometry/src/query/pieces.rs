//! What trees have in their leaves: single triangles, and spheres.
//!
//! A piece has the number of its first face.

use std::sync::Arc;

use capwalk_math::Vec3;
use rayon::prelude::*;

use super::ray_kernel::LANES;
use super::sphere::MeshSphere;
use crate::aabb::Aabb;
use crate::bvh::{Hierarchy, Leaves, Splits, build};
use crate::halt::Halt;
use crate::local_frame::LocalFrame;
use crate::mesh::Mesh;

/// The pieces of a mesh.
#[derive(Clone, Copy)]
pub struct Pieces<'a> {
    pub mesh: &'a Mesh,
    /// In the order of their faces.
    pub spheres: &'a [Arc<MeshSphere>],
}

impl<'a> Pieces<'a> {
    /// All of them.
    pub fn all(&self) -> Vec<u32> {
        let mut pieces = Vec::new();
        let mut next = 0;
        for sphere in self.spheres {
            let faces = sphere.faces();
            pieces.extend(next..faces.start);
            pieces.push(faces.start);
            next = faces.end;
        }
        pieces.extend(next..self.mesh.faces.len() as u32);
        pieces
    }

    /// The coordinates of a tree over some of them.
    pub fn frame(&self, pieces: &[u32]) -> LocalFrame {
        LocalFrame::around(pieces.iter().flat_map(|&piece| self.ends(piece)))
    }

    /// The box around one.
    fn bounds(&self, frame: &LocalFrame, piece: u32) -> Aabb {
        Aabb::around(self.ends(piece).map(|p| frame.local_from_world(p)))
    }

    /// The box around those of a leaf.
    pub fn leaf_bounds(&self, frame: &LocalFrame, leaf: &[u32]) -> Aabb {
        leaf.iter().fold(Aabb::EMPTY, |bounds, &piece| {
            bounds.union(&self.bounds(frame, piece))
        })
    }

    /// A tree over some of them.
    pub fn hierarchy(&self, mut pieces: Vec<u32>, frame: &LocalFrame, halt: &Halt) -> Hierarchy {
        // Triangles first.
        pieces.sort_by_key(|&piece| self.sphere(piece).is_some());
        let single = pieces.partition_point(|&piece| self.sphere(piece).is_none());
        let leaves = Leaves {
            size: LANES,
            alone_from: single as u32,
        };
        let all = pieces.par_iter().with_min_len(1024);
        let bounds: Vec<Aabb> = all.map(|&piece| self.bounds(frame, piece)).collect();
        let mut hierarchy = build(&bounds, leaves, Splits::Fine, halt);
        for place in &mut hierarchy.order {
            *place = pieces[*place as usize];
        }
        hierarchy
    }

    /// The sphere that a leaf with these pieces has, if it is no block of triangles.
    pub fn sphere_in(&self, leaf: &[u32]) -> Option<&'a Arc<MeshSphere>> {
        match leaf {
            [piece] => self.sphere(*piece),
            _ => None,
        }
    }

    /// Points whose box is that around a piece.
    fn ends(&self, piece: u32) -> [Vec3; 3] {
        match self.sphere(piece) {
            None => self.mesh.corners(piece as usize),
            Some(sphere) => {
                let [low, high] = sphere.corners();
                [low, high, high]
            }
        }
    }

    fn sphere(&self, piece: u32) -> Option<&'a Arc<MeshSphere>> {
        let place = self
            .spheres
            .binary_search_by_key(&piece, |sphere| sphere.faces().start);
        place.ok().map(|place| &self.spheres[place])
    }
}
