//! The tree with two children per node that building starts with.

/// A node of the binary tree. The `n` primitives from `start` on own the
/// slots from `2 start` to `2 (start + n) - 2`; their node is the first.
#[derive(Clone, Copy)]
pub struct BinaryNode {
    /// Half the surface of the box around its primitives.
    pub half_area: f32,
    /// Its first primitive.
    pub start: u32,
    /// Primitives in the left half; 0 for a leaf.
    pub left: u32,
}

impl BinaryNode {
    /// A slot that no node has taken yet.
    pub const UNUSED: Self = Self {
        half_area: 0.0,
        start: 0,
        left: 0,
    };

    /// The slots of the two halves of the node at `slot`; `None` for a leaf.
    pub fn halves(&self, slot: usize) -> Option<[usize; 2]> {
        (self.left > 0).then(|| [slot + 1, slot + 2 * self.left as usize])
    }
}
