//! The kernels of queries and refits, from the sources in `kernels`.

use std::sync::LazyLock;

use crate::compiled_kernel::{CompiledKernel, GROUP, KernelPack};

/// As `cargo xtask kernels` compiled them.
pub fn pack() -> &'static KernelPack {
    static PACK: LazyLock<KernelPack> =
        LazyLock::new(|| KernelPack::unpack(include_bytes!("kernels/compiled.lzma")));
    &PACK
}

/// A kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    FirstHit,
    Occluded,
    Closest,
    Gather,
    /// Whether cones can be asked at all.
    Eights,
    /// Triangles and edges at new positions.
    MovedTriangles,
    MovedEdges,
    /// Bounds of the children of nodes around these.
    BoundTriangles,
    BoundEdges,
    /// Edges sampled in cones.
    SampleEdges,
}

impl Kernel {
    /// All that a driver needs of it: its entry point, and how many queries a group works on. Cones have eight threads
    /// each, children of nodes a group.
    pub fn compiled(self) -> CompiledKernel {
        let (name, group) = match self {
            Self::FirstHit => ("first_hit", GROUP),
            Self::Occluded => ("occluded", GROUP),
            Self::Closest => ("closest", GROUP / 8),
            Self::Gather => ("gather", GROUP / 8),
            Self::Eights => ("eights", GROUP),
            Self::MovedTriangles => ("moved_triangles", GROUP),
            Self::MovedEdges => ("moved_edges", GROUP),
            Self::BoundTriangles => ("bound_triangles", 1),
            Self::BoundEdges => ("bound_edges", 1),
            Self::SampleEdges => ("sample_edges", GROUP),
        };
        CompiledKernel { name, group, pack }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use capwalk_geometry::buffers;

    /// Whoever changes a source must compile it again.
    #[test]
    fn compiled_kernels_are_current() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/kernels");
        assert_eq!(pack().check(&[&folder]), Ok(()));
        for kernel in [
            Kernel::FirstHit,
            Kernel::Occluded,
            Kernel::Closest,
            Kernel::Gather,
            Kernel::Eights,
            Kernel::MovedTriangles,
            Kernel::MovedEdges,
            Kernel::BoundTriangles,
            Kernel::BoundEdges,
            Kernel::SampleEdges,
        ] {
            assert_eq!(kernel.compiled().check(), Ok(()));
        }
    }

    /// Kernels have room for every way down a tree.
    #[test]
    fn trees_are_not_too_deep() {
        let room = format!("static const uint LEVELS = {};", buffers::LEVELS);
        assert!(include_str!("kernels/rays.slang").contains(&room));
    }
}
