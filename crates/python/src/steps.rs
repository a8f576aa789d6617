//! Steps of an optimisation: Adam, and large steps.

use capwalk::Vec3;
use capwalk::optimize::{Adam, MomentEstimates, Smoother};
use capwalk::scene::weld;
use numpy::{PyArrayDyn, PyReadonlyArray2, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::watched::detached;
use crate::{arrays, errors};

/// A number array of Python.
type Array<'py> = Bound<'py, PyArrayDyn<f64>>;

/// What Adam is given besides numbers.
#[derive(FromPyObject)]
pub struct Rates {
    #[pyo3(attribute)]
    lr: f64,
    #[pyo3(attribute)]
    betas: [f64; 2],
    #[pyo3(attribute)]
    eps: f64,
    #[pyo3(attribute)]
    uniform: bool,
}

/// Numbers after a step of Adam, and the running means of their gradient and of its square.
/// `step` counts from 1. All arrays have the same shape.
#[pyfunction]
pub fn adam<'py>(
    py: Python<'py>,
    rates: Rates,
    step: u32,
    numbers: PyReadonlyArrayDyn<'py, f64>,
    gradient: PyReadonlyArrayDyn<'py, f64>,
    means: [PyReadonlyArrayDyn<'py, f64>; 2],
) -> PyResult<[Array<'py>; 3]> {
    let shape = numbers.shape().to_vec();
    let mut after = arrays::to_numbers(&numbers);
    let [mut first, mut second] = means.map(|mean| arrays::to_numbers(&mean));
    let adam = Adam {
        betas: rates.betas,
        eps: rates.eps,
    };
    let moments = MomentEstimates {
        first: &mut first,
        second: &mut second,
    };
    let gradient = arrays::to_numbers(&gradient);
    let (rate, uniform) = (rates.lr, rates.uniform);
    detached(py, || {
        adam.step(step, rate, uniform, &gradient, moments, &mut after);
    })?;
    let array = |numbers| arrays::from_numbers(py, &shape, numbers);
    Ok([array(after)?, array(first)?, array(second)?])
}

/// The matrix `I + λL` of a mesh whose vertices at the same place are one, with its factors.
#[pyclass(frozen, module = "capwalk._capwalk")]
pub struct Smooth {
    smoother: Smoother,
    /// For each vertex the node that it is part of.
    nodes: Vec<usize>,
    /// A vertex of each node.
    vertices: Vec<usize>,
}

#[pymethods]
impl Smooth {
    #[new]
    fn new(
        py: Python<'_>,
        positions: PyReadonlyArray2<'_, f64>,
        faces: Vec<[usize; 3]>,
        lambda: f64,
    ) -> PyResult<Self> {
        let positions = positions.as_array();
        let rows = positions.rows().into_iter();
        let positions: Vec<Vec3> = rows.map(|p| Vec3::new(p[0], p[1], p[2])).collect();
        let made = detached(py, || {
            let (mut vertices, mut nodes) = (Vec::new(), Vec::new());
            let mut node_of = vec![0; positions.len()];
            for (vertex, &first) in weld(&positions).iter().enumerate() {
                if first as usize == vertex {
                    node_of[vertex] = vertices.len();
                    vertices.push(vertex);
                }
                nodes.push(node_of[first as usize]);
            }
            let sides = |[a, b, c]: [usize; 3]| [[a, b], [b, c], [c, a]];
            let sides = faces.into_iter().flat_map(sides);
            let edges: Vec<_> = sides.map(|side| side.map(|vertex| nodes[vertex])).collect();
            let smoother = Smoother::new(vertices.len(), &edges, lambda);
            smoother.map(|smoother| Self {
                smoother,
                nodes,
                vertices,
            })
        })?;
        made.ok_or_else(|| errors::internal(py, "no memory for the factors of a matrix"))
    }

    /// Nodes and vertices: the rows of both sides.
    #[getter]
    fn sizes(&self) -> (usize, usize) {
        (self.vertices.len(), self.nodes.len())
    }

    /// `(I + λL) x` of positions (V, 3): (N, 3).
    fn multiply<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Array<'py>> {
        let positions = positions.as_array();
        let rows = self.vertices.iter().map(|&vertex| positions.row(vertex));
        let rows: Vec<f64> = rows.flat_map(|row| row.to_vec()).collect();
        let product = detached(py, || self.smoother.multiply(&rows, 3))?;
        arrays::from_numbers(py, &[self.vertices.len(), 3], product)
    }

    /// `(I + λL)⁻¹ u` of nodes (N, 3), at each vertex: (V, 3).
    fn solve<'py>(
        &self,
        py: Python<'py>,
        nodes: PyReadonlyArrayDyn<'py, f64>,
    ) -> PyResult<Array<'py>> {
        let rows = arrays::to_numbers(&nodes);
        let solved = detached(py, || self.smoother.solve(&rows, 3))?;
        let rows = self.nodes.iter().flat_map(|&node| &solved[3 * node..][..3]);
        arrays::from_numbers(py, &[self.nodes.len(), 3], rows.copied().collect())
    }

    /// The transpose of [`Smooth::solve`]: gradients with respect to vertices (V, 3) to those with
    /// respect to nodes.
    fn pull<'py>(
        &self,
        py: Python<'py>,
        gradient: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Array<'py>> {
        let gradient = gradient.as_array();
        let mut sums = vec![0.0; 3 * self.vertices.len()];
        for (row, &node) in gradient.rows().into_iter().zip(&self.nodes) {
            for (sum, x) in sums[3 * node..].iter_mut().zip(row) {
                *sum += x;
            }
        }
        let solved = detached(py, || self.smoother.solve(&sums, 3))?;
        arrays::from_numbers(py, &[self.vertices.len(), 3], solved)
    }
}
