//! Trees on the device that follow moved vertices.
//!
//! Only positions are uploaded: 24 bytes for each vertex, and in single precision 12 for each
//! face. The frame is that of the CPU's own refit, wherever vertices go. The new arrays are
//! written beside the old ones, which answer until all is done, and stay if anything fails.

use capwalk_geometry::buffers::{FLIPPED, NONE};
use capwalk_geometry::{LocalFrame, Mesh};
use capwalk_math::Vec3;
use rayon::prelude::*;

use crate::compiled_kernel::CompiledKernel;
use crate::driver::Memory;
use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::kernels::{BOUND_EDGES, BOUND_TRIANGLES, MOVED_EDGES, MOVED_TRIANGLES};
use crate::launch::Launch;
use crate::layout::frame::*;
use crate::layout::position::*;
use crate::precision::Precision;
use crate::resident::{Resident, reserved, uploaded};

/// What a tree is over, in the order of its leaves.
#[derive(Debug)]
pub enum Primitives {
    /// All triangles of a mesh.
    Triangles,
    /// Some edges: their [`sides`](capwalk_geometry::buffers::SilhouetteBuffers::sides).
    Edges(Vec<u32>),
}

impl Primitives {
    /// The kernels that write primitives, and bounds.
    fn kernels(&self) -> [&'static CompiledKernel; 2] {
        match self {
            Self::Triangles => [&MOVED_TRIANGLES, &BOUND_TRIANGLES],
            Self::Edges(_) => [&MOVED_EDGES, &BOUND_EDGES],
        }
    }

    /// The words of each edge.
    fn sides(&self) -> &[[u32; 4]] {
        match self {
            Self::Triangles => &[],
            Self::Edges(sides) => sides.as_chunks::<4>().0,
        }
    }

    /// The vertices that the frame is around; or what tells that the mesh is another one, for a
    /// tree of so many.
    fn vertices(&self, mesh: &Mesh, count: usize) -> Result<Vec<u32>, String> {
        let mut is_used = vec![false; mesh.positions.len()];
        match self {
            Self::Triangles => {
                if mesh.faces.len() != count {
                    let faces = mesh.faces.len();
                    return Err(format!(
                        "it is over {count} faces, and the mesh has {faces}"
                    ));
                }
                for &vertex in mesh.faces.iter().flatten() {
                    is_used[vertex as usize] = true;
                }
            }
            Self::Edges(_) => {
                for &[a, b, first, second] in self.sides() {
                    let faces = [first, second & !FLIPPED].into_iter();
                    let exists = |face: u32| (face as usize) < mesh.faces.len();
                    if first != NONE && !faces.into_iter().all(exists) {
                        return Err("one of its edges has faces that the mesh has not".to_owned());
                    }
                    for vertex in [a, b] {
                        *is_used
                            .get_mut(vertex as usize)
                            .ok_or("one of its edges has ends that the mesh has not")? = true;
                    }
                }
            }
        }
        let numbers = is_used.iter().zip(0..);
        Ok(numbers.filter(|(used, _)| **used).map(|(_, i)| i).collect())
    }
}

/// What a tree needs on the device to follow vertices.
#[derive(Debug)]
pub struct Refit {
    kernels: [&'static CompiledKernel; 2],
    is_of_triangles: bool,
    /// Eight children for each node.
    children: u32,
    below: Memory,
    sides: Memory,
    faces: Memory,
    positions: Memory,
    /// The frame, or in single precision the normals of the faces.
    others: Memory,
    /// Where the next arrays are written, and the last ones were: nodes, primitives, and what is
    /// read of them before.
    spare: [Memory; 3],
    /// The vertices that the frame is around.
    framed: Vec<u32>,
    /// How many vertices and faces the mesh has.
    size: [usize; 2],
}

impl Refit {
    /// Moves a tree to where the vertices of the mesh are, and returns its new frame; what that takes
    /// is made for the first mesh, and kept once the tree has followed it. `below` is what the tree's
    /// buffers call so. After any error the tree is what it was.
    pub fn move_tree(
        kept: &mut Option<Self>,
        gpu: &Gpu,
        tree: &mut Resident,
        (primitives, below): (&Primitives, &[u32]),
        mesh: &Mesh,
    ) -> Result<LocalFrame, GpuError> {
        if let Some(refit) = kept {
            return refit.follow(gpu, tree, mesh);
        }
        let mut refit = Self::new(gpu, tree, primitives, below, mesh)?;
        let frame = refit.follow(gpu, tree, mesh)?;
        *kept = Some(refit);
        Ok(frame)
    }

    /// Uploads the faces of the mesh, and takes memory for all else.
    fn new(
        gpu: &Gpu,
        tree: &Resident,
        primitives: &Primitives,
        below: &[u32],
        mesh: &Mesh,
    ) -> Result<Self, GpuError> {
        check(mesh)?;
        let framed = primitives.vertices(mesh, tree.primitives());
        let framed = framed.map_err(|reason| GpuError::OtherMesh { reason })?;
        let corners = |&[a, b, c]: &[u32; 3]| [a, b, c, 0];
        let faces: Vec<[u32; 4]> = mesh.faces.iter().map(corners).collect();
        let others = match gpu.precision() {
            Precision::Double => size_of::<[f64; FRAME]>(),
            Precision::Single => size_of::<[f32; 3]>() * mesh.faces.len(),
        };
        let position = match gpu.precision() {
            Precision::Double => size_of::<[f64; EXACT_POSITION]>(),
            Precision::Single => size_of::<[f32; SUMMED_POSITION]>(),
        };
        let positions = position * mesh.positions.len();
        Ok(Self {
            kernels: primitives.kernels(),
            is_of_triangles: matches!(primitives, Primitives::Triangles),
            children: (below.len() / 2) as u32,
            below: uploaded(gpu, bytemuck::cast_slice(below))?,
            sides: uploaded(gpu, bytemuck::cast_slice(primitives.sides()))?,
            faces: uploaded(gpu, bytemuck::cast_slice(&faces))?,
            positions: reserved(gpu, positions as u64)?,
            others: reserved(gpu, others as u64)?,
            spare: tree.spare(gpu)?,
            framed,
            size: [mesh.positions.len(), mesh.faces.len()],
        })
    }

    /// Moves the tree to where the vertices of the mesh are, and returns its new frame. After
    /// any error the tree is what it was.
    fn follow(
        &mut self,
        gpu: &Gpu,
        tree: &mut Resident,
        mesh: &Mesh,
    ) -> Result<LocalFrame, GpuError> {
        check(mesh)?;
        let size = [mesh.positions.len(), mesh.faces.len()];
        if size != self.size {
            let [vertices, faces] = size;
            return Err(GpuError::OtherMesh {
                reason: format!(
                    "the mesh has {vertices} vertices and {faces} faces, and had {} and {}",
                    self.size[0], self.size[1]
                ),
            });
        }
        let framed = self.framed.iter();
        let frame = LocalFrame::around(framed.map(|&vertex| mesh.positions[vertex as usize]));
        self.upload(gpu, mesh, &frame)?;
        let [spare_nodes, spare_primitives, spare_rough] = &self.spare;
        let [nodes, _, _, rough] = tree.arrays();
        let launch = |end: u32| Launch {
            first: 0,
            end,
            capacity: 0,
            primitives: tree.primitives() as u32,
        };
        let arrays = [
            &self.sides,
            &self.below,
            &self.positions,
            &self.faces,
            rough,
            &self.others,
            spare_rough,
            spare_primitives,
        ];
        gpu.run(self.kernels[0], arrays, launch(tree.primitives() as u32))?;
        let arrays = [
            nodes,
            &self.below,
            spare_primitives,
            if self.is_of_triangles {
                rough
            } else {
                spare_rough
            },
            &self.sides,
            &self.others,
            spare_nodes,
            // Nothing is written there.
            &self.positions,
        ];
        gpu.run(self.kernels[1], arrays, launch(self.children))?;
        // The numbers of triangles stay.
        tree.exchange(&mut self.spare, self.is_of_triangles);
        Ok(frame)
    }

    /// Positions and what comes with them.
    fn upload(&self, gpu: &Gpu, mesh: &Mesh, frame: &LocalFrame) -> Result<(), GpuError> {
        match gpu.precision() {
            Precision::Double => {
                let positions = mesh.positions.par_iter().with_min_len(1024);
                let positions: Vec<[f64; EXACT_POSITION]> =
                    positions.map(|p| p.to_array()).collect();
                gpu.upload(&self.positions, bytemuck::cast_slice(&positions))?;
                gpu.upload(&self.others, bytemuck::cast_slice(&numbers(frame)))
            }
            Precision::Single => {
                let positions = mesh.positions.par_iter().with_min_len(1024);
                let positions = positions.map(|&p| two_parts(frame.local_from_world(p)));
                let positions: Vec<[f32; SUMMED_POSITION]> = positions.collect();
                gpu.upload(&self.positions, bytemuck::cast_slice(&positions))?;
                let faces = (0..mesh.faces.len()).into_par_iter().with_min_len(1024);
                let normals: Vec<[f32; 3]> = faces.map(|face| unit_normal(mesh, face)).collect();
                gpu.upload(&self.others, bytemuck::cast_slice(&normals))
            }
        }
    }
}

/// An error if the mesh is none.
fn check(mesh: &Mesh) -> Result<(), GpuError> {
    mesh.check().map_err(|error| GpuError::OtherMesh {
        reason: error.to_string(),
    })
}

/// A frame as the kernels read it, with the largest number and the least length that has an
/// inverse.
fn numbers(frame: &LocalFrame) -> [f64; FRAME] {
    let mut numbers = [0.0; FRAME];
    numbers[FRAME_CENTRE..FRAME_SCALE].copy_from_slice(&frame.centre.to_array());
    numbers[FRAME_SCALE] = frame.inverse_scale;
    numbers[FRAME_LARGEST] = f64::MAX;
    numbers[FRAME_LEAST] = f64::MIN_POSITIVE;
    numbers
}

/// Two numbers for each coordinate, of which it is the sum: the first ones are the rounded
/// coordinates.
fn two_parts(p: Vec3) -> [f32; SUMMED_POSITION] {
    let [x, y, z] = p.to_array();
    let rounded = [x, y, z].map(|v| v as f32);
    let rest = [0, 1, 2].map(|axis| (p[axis] - f64::from(rounded[axis])) as f32);
    let [high, low] = [rounded, rest];
    [high[0], high[1], high[2], low[0], low[1], low[2]]
}

/// Zero for degenerate faces.
fn unit_normal(mesh: &Mesh, face: usize) -> [f32; 3] {
    let normal = mesh.face_cross(face).normalized();
    match normal.is_finite() {
        true => normal.to_array().map(|v| v as f32),
        false => [0.0; 3],
    }
}
