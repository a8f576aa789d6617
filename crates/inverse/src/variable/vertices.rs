//! Displacements of vertices: free, in a plane, or along one direction each.

use std::collections::BTreeSet;
use std::ops::Range;

use capwalk_geometry::Mesh;
use capwalk_geometry::topology::weld;
use capwalk_math::Vec3;
use capwalk_scene::{Gradient, Scene, ShapeVectors, Tangent, vertex_normals};

use super::error::VerticesError;

/// Which vertices of a shape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Selection {
    /// All of them.
    All,
    /// Those at open edges: the rim of a disk.
    Border,
    /// Those with these numbers, counted from 0.
    Numbers(Vec<Range<usize>>),
}

/// Where vertices may go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Directions {
    /// Anywhere: three numbers each.
    Free,
    /// In a plane through where they are, spanned by these vectors: two numbers.
    Plane([Vec3; 2]),
    /// Along this vector: one number.
    Along(Vec3),
    /// Along their normals before the first step: one number.
    Normals,
    /// Away from the shape's centre before the first step: one number. With a
    /// normal of a plane, in that plane.
    Radial(Option<Vec3>),
}

/// A linear map from numbers to displacements.
#[derive(Clone, Debug)]
pub(crate) struct Vertices {
    /// Index of the shape.
    pub shape: usize,
    /// For each vertex of the mesh the selected one that it moves with, if any:
    /// vertices at the same place (seams) move together.
    moves_with: Vec<Option<u32>>,
    /// Numbers for each selected vertex.
    pub dims: usize,
    /// `dims` directions for each selected vertex.
    basis: Vec<Vec3>,
}

impl Vertices {
    /// The vertices of a shape; an error says what is wrong with the choice.
    pub fn new(
        scene: &Scene,
        shape: usize,
        selection: &Selection,
        directions: Directions,
    ) -> Result<Self, VerticesError> {
        let base = &scene.shapes[shape];
        let welded = weld(&base.mesh.positions);
        let selected = selected(&base.mesh, &welded, selection)?;
        let mut number = vec![None; welded.len()];
        for (i, &vertex) in (0..).zip(&selected) {
            number[vertex] = Some(i);
        }
        let normals = || {
            let faces = base.mesh.faces.iter();
            let faces: Vec<_> = faces.map(|f| f.map(|i| welded[i as usize])).collect();
            vertex_normals(&base.mesh.positions, &faces)
        };
        let normals = match directions {
            Directions::Normals => normals(),
            _ => Vec::new(),
        };
        let (mut basis, mut dims) = (Vec::new(), 0);
        for &vertex in &selected {
            let radial = base.mesh.positions[vertex] - base.centre();
            let of_vertex = match directions {
                Directions::Free => {
                    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                    axes.map(Vec3::from).to_vec()
                }
                Directions::Plane(axes) => axes.to_vec(),
                Directions::Along(direction) => vec![direction],
                Directions::Normals => vec![normals[vertex]],
                Directions::Radial(None) => vec![radial.normalized()],
                Directions::Radial(Some(n)) => {
                    vec![radial.reject_from(n.normalized()).normalized()]
                }
            };
            if !of_vertex.iter().all(|d| d.is_finite()) || of_vertex.contains(&Vec3::zero()) {
                return Err(VerticesError::NoDirection { vertex });
            }
            dims = of_vertex.len();
            basis.extend(of_vertex);
        }
        Ok(Self {
            shape,
            moves_with: welded.iter().map(|&first| number[first as usize]).collect(),
            dims,
            basis,
        })
    }

    /// How many numbers there are.
    pub fn count(&self) -> usize {
        self.basis.len()
    }

    /// How many vertices are selected.
    pub fn nodes(&self) -> usize {
        self.basis.len() / self.dims
    }

    /// The edges of the mesh both of whose ends are selected.
    pub fn edges(&self, mesh: &Mesh) -> Vec<[usize; 2]> {
        let sides = |[a, b, c]: &[u32; 3]| [[*a, *b], [*b, *c], [*c, *a]];
        let sides = mesh.faces.iter().flat_map(sides);
        let selected = |i: u32| self.moves_with[i as usize].map(|node| node as usize);
        sides
            .filter_map(|[a, b]| Some([selected(a)?, selected(b)?]))
            .collect()
    }

    /// Displacements, as a motion for one unit.
    pub fn push(&self, scene: &Scene, numbers: &[f64]) -> Tangent {
        let displacement = |node: u32| {
            let first = node as usize * self.dims;
            let own = first..first + self.dims;
            let terms = self.basis[own.clone()].iter().zip(&numbers[own]);
            terms.fold(Vec3::zero(), |sum, (&d, &x)| sum + d * x)
        };
        let moves_with = self.moves_with.iter();
        let vertices = moves_with.map(|node| node.map_or(Vec3::zero(), displacement));
        let mut tangent = Tangent::zero(scene);
        tangent.shapes[self.shape] = Some(ShapeVectors {
            vertices: vertices.collect(),
            normals: None,
        });
        tangent
    }

    /// The transpose of [`Vertices::push`].
    pub fn pull(&self, gradient: &Gradient) -> Vec<f64> {
        let mut sums = vec![Vec3::zero(); self.nodes()];
        if let Some(of_shape) = &gradient.shapes[self.shape] {
            for (node, &covector) in self.moves_with.iter().zip(&of_shape.vertices) {
                if let Some(node) = node {
                    sums[*node as usize] += covector;
                }
            }
        }
        let basis = self.basis.iter().enumerate();
        basis.map(|(k, d)| d.dot(sums[k / self.dims])).collect()
    }
}

/// The first of each group of selected vertices at the same place, in order.
fn selected(
    mesh: &Mesh,
    welded: &[u32],
    selection: &Selection,
) -> Result<Vec<usize>, VerticesError> {
    let group = |i: usize| welded[i] as usize;
    let groups: BTreeSet<usize> = match selection {
        // Vertices of no face show nothing.
        Selection::All => mesh
            .faces
            .iter()
            .flatten()
            .map(|&i| group(i as usize))
            .collect(),
        Selection::Border => {
            let mut uses = std::collections::BTreeMap::new();
            for &[a, b, c] in &mesh.faces {
                for [i, k] in [[a, b], [b, c], [c, a]] {
                    let [i, k] = [i, k].map(|i| group(i as usize));
                    *uses.entry([i.min(k), i.max(k)]).or_insert(0) += 1;
                }
            }
            let open = uses.into_iter().filter(|&(_, count)| count == 1);
            open.flat_map(|(ends, _)| ends).collect()
        }
        Selection::Numbers(ranges) => {
            let count = welded.len();
            if let Some(beyond) = ranges.iter().find(|range| range.end > count) {
                let index = beyond.start.max(count);
                return Err(VerticesError::Index { index, count });
            }
            ranges.iter().cloned().flatten().map(group).collect()
        }
    };
    match groups.is_empty() {
        true => Err(VerticesError::Empty),
        false => Ok(groups.into_iter().collect()),
    }
}
