//! Large steps (Nicolet, Jacobson and Jakob 2021): instead of the positions `x` of
//! neighbours, the unknowns are `u = (I + λL) x`, with the graph's Laplacian `L`.
//! A step in `u` moves whole regions, so that noise in the gradient wrinkles
//! nothing. The factors of the matrix are computed once.

use faer::prelude::Solve;
use faer::sparse::linalg::solvers::Llt;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};

/// The matrix `A = I + λL` of a graph and its sparse Cholesky factors. `L` is the
/// combinatorial Laplacian: how many neighbours a node has on the diagonal, and -1
/// for each neighbour.
#[derive(Clone, Debug)]
pub struct Smoother {
    lambda: f64,
    neighbours: Vec<Vec<usize>>,
    factors: Llt<usize, f64>,
}

impl Smoother {
    /// For a graph with so many nodes. `edges` may have an edge several times, in
    /// either direction; `lambda` is finite and at least 0. `None` if memory runs
    /// out.
    pub fn new(nodes: usize, edges: &[[usize; 2]], lambda: f64) -> Option<Self> {
        let mut neighbours = vec![Vec::new(); nodes];
        for &[a, b] in edges.iter().filter(|[a, b]| a != b) {
            neighbours[a].push(b);
            neighbours[b].push(a);
        }
        for around in &mut neighbours {
            around.sort_unstable();
            around.dedup();
        }
        let mut entries = Vec::new();
        for (i, around) in neighbours.iter().enumerate() {
            entries.push(Triplet::new(i, i, 1.0 + lambda * around.len() as f64));
            entries.extend(around.iter().map(|&k| Triplet::new(i, k, -lambda)));
        }
        let matrix = SparseColMat::try_new_from_triplets(nodes, nodes, &entries).ok()?;
        // It is positive definite: its eigenvalues are at least 1.
        let factors = matrix.sp_cholesky(Side::Lower).ok()?;
        Some(Self {
            lambda,
            neighbours,
            factors,
        })
    }

    /// `A⁻¹ u` of every column of rows of `dims` numbers; symmetric, so this also
    /// takes the gradient with respect to `x` to that with respect to `u`.
    pub fn solve(&self, rows: &[f64], dims: usize) -> Vec<f64> {
        let nodes = self.neighbours.len();
        let right = Mat::from_fn(nodes, dims, |i, k| rows[i * dims + k]);
        let solved = self.factors.solve(&right);
        let entries = (0..nodes * dims).map(|i| solved[(i / dims, i % dims)]);
        entries.collect()
    }

    /// `A x`, the inverse of [`Smoother::solve`].
    pub fn multiply(&self, rows: &[f64], dims: usize) -> Vec<f64> {
        let entry = |i: usize| {
            let (node, k) = (i / dims, i % dims);
            let around = self.neighbours[node].iter();
            let differences = around.map(|&other| rows[i] - rows[other * dims + k]);
            rows[i] + self.lambda * differences.sum::<f64>()
        };
        (0..rows.len()).map(entry).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ring with some chords, a path, and a node by itself.
    fn graph() -> (usize, Vec<[usize; 2]>) {
        let mut edges: Vec<[usize; 2]> = (0..20).map(|i| [i, (i + 1) % 20]).collect();
        edges.extend((0..20).step_by(3).map(|i| [i, (i * 7 + 5) % 20]));
        edges.extend([[20, 21], [21, 22], [21, 20], [3, 3]]);
        (24, edges)
    }

    fn vector(count: usize) -> Vec<f64> {
        (0..count).map(|i| (1.7 * i as f64).sin()).collect()
    }

    /// Gaussian elimination with the dense matrix.
    fn dense_solve(nodes: usize, edges: &[[usize; 2]], lambda: f64, right: &[f64]) -> Vec<f64> {
        let mut matrix = vec![vec![0.0; nodes]; nodes];
        let mut seen = std::collections::HashSet::new();
        for &[a, b] in edges {
            if a != b && seen.insert([a.min(b), a.max(b)]) {
                for (i, k) in [(a, b), (b, a)] {
                    matrix[i][i] += lambda;
                    matrix[i][k] -= lambda;
                }
            }
        }
        let mut right = right.to_vec();
        for (i, row) in matrix.iter_mut().enumerate() {
            row[i] += 1.0;
        }
        for i in 0..nodes {
            for k in i + 1..nodes {
                let factor = matrix[k][i] / matrix[i][i];
                let row = matrix[i].clone();
                let pairs = matrix[k].iter_mut().zip(&row);
                pairs.for_each(|(entry, above)| *entry -= factor * above);
                right[k] -= factor * right[i];
            }
        }
        for i in (0..nodes).rev() {
            let known: f64 = (i + 1..nodes).map(|c| matrix[i][c] * right[c]).sum();
            right[i] = (right[i] - known) / matrix[i][i];
        }
        right
    }

    #[test]
    fn solves_are_those_of_the_dense_matrix() {
        let (nodes, edges) = graph();
        for lambda in [0.0, 0.3, 19.0, 1e4] {
            let smoother = Smoother::new(nodes, &edges, lambda).expect("positive definite");
            let right = vector(nodes);
            let expected = dense_solve(nodes, &edges, lambda, &right);
            for (a, b) in smoother.solve(&right, 1).iter().zip(&expected) {
                assert!((a - b).abs() < 1e-11, "{lambda}: {a} {b}");
            }
        }
    }

    /// There and back, for rows of several numbers; and constants stay.
    #[test]
    fn multiplying_undoes_solving() {
        let (nodes, edges) = graph();
        let smoother = Smoother::new(nodes, &edges, 7.0).expect("positive definite");
        let rows = vector(3 * nodes);
        for (a, b) in smoother
            .multiply(&smoother.solve(&rows, 3), 3)
            .iter()
            .zip(&rows)
        {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
        let ones = vec![1.0; 2 * nodes];
        assert_eq!(smoother.multiply(&ones, 2), ones);
        for one in smoother.solve(&ones, 2) {
            assert!((one - 1.0).abs() < 1e-12);
        }
    }
}
