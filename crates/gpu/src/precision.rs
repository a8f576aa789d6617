//! In what triangles and edges are tested.

/// The precision of the tests of triangles and edges, and their coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    // In this order in a `CompiledKernel`.
    /// Single precision, in the tree's coordinates.
    Single,
    /// Double precision; of queries in the world's coordinates.
    Double,
}
