//! Which node has which children, and which leaf which primitives.

/// Children per node.
pub const WIDTH: usize = 8;

/// No leaf lies deeper than this below the root: the builder balances what
/// would become deeper, and traversal stacks are sized by it.
pub const MAX_DEPTH: usize = 40;

/// A child of a node: another node, a leaf, or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(transparent)]
pub struct Child(u32);

const LEAF_BIT: u32 = 1 << 31;

impl Child {
    pub const NONE: Self = Self(u32::MAX);

    pub fn node(index: usize) -> Self {
        debug_assert!(index < LEAF_BIT as usize);
        Self(index as u32)
    }

    pub fn leaf(index: usize) -> Self {
        debug_assert!(index < (LEAF_BIT - 1) as usize);
        Self(index as u32 | LEAF_BIT)
    }

    /// What the slot holds; `None` if it is empty.
    #[inline]
    pub fn kind(self) -> Option<ChildKind> {
        match self {
            Self::NONE => None,
            Self(bits) if bits & LEAF_BIT == 0 => Some(ChildKind::Node(bits as usize)),
            Self(bits) => Some(ChildKind::Leaf((bits & !LEAF_BIT) as usize)),
        }
    }

    /// The child as a number, for traversal stacks.
    #[inline]
    pub fn bits(self) -> u32 {
        self.0
    }

    /// Inverse of [`bits`](Self::bits).
    #[inline]
    pub fn from_bits(bits: u32) -> Self {
        Self(bits)
    }
}

/// What a child slot holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChildKind {
    /// The index of a node.
    Node(usize),
    /// The index of a leaf.
    Leaf(usize),
}

/// Which node has which children, and which leaf has which primitives.
#[derive(Clone, Debug, Default)]
pub struct Hierarchy {
    /// The children of each node. The root is node 0; children come after
    /// their parents. Slots in use come first. Empty without primitives.
    pub nodes: Vec<[Child; WIDTH]>,
    /// The primitives in the order of the leaves.
    pub order: Vec<u32>,
    /// Where in `order` each leaf starts, and at last where they all end. The
    /// leaves below any node are consecutive.
    pub leaf_starts: Vec<u32>,
}

impl Hierarchy {
    /// How many leaves there are.
    pub fn leaf_count(&self) -> usize {
        self.leaf_starts.len().saturating_sub(1)
    }

    /// The primitives of a leaf.
    #[inline]
    pub fn leaf(&self, leaf: usize) -> &[u32] {
        &self.order[self.leaf_starts[leaf] as usize..self.leaf_starts[leaf + 1] as usize]
    }
}
