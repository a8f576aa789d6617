//! The kernels of queries and refits, from the sources in `kernels`.

use std::sync::LazyLock;

use capwalk_geometry::{buffers, sampler_buffers};

use crate::compiled_kernel::{CompiledKernel, GROUP, KernelPack};

/// As `cargo xtask kernels` compiled them.
pub fn pack() -> &'static KernelPack {
    static PACK: LazyLock<KernelPack> =
        LazyLock::new(|| KernelPack::unpack(include_bytes!("kernels/compiled.lzma")));
    &PACK
}

/// What the kernels include as `trees.slang`: sizes and marks of trees, as `capwalk-geometry` writes them.
pub fn trees_slang() -> String {
    let sizes = [
        ("Threads in a group.", "GROUP", GROUP),
        (
            "Ways from the root to a leaf pass no more nodes.",
            "LEVELS",
            buffers::LEVELS,
        ),
        (
            "Words of a node of a tree of triangles, and of one of edges.",
            "RAY_NODE",
            buffers::RAY_NODE,
        ),
        ("", "CONE_NODE", buffers::CONE_NODE),
        (
            "Numbers of a triangle, and of an edge.",
            "TRIANGLE",
            buffers::TRIANGLE,
        ),
        ("", "EDGE", buffers::EDGE),
        (
            "Numbers of the bounds of a node of an edge sampler, and factors of an edge.",
            "BOUNDS",
            sampler_buffers::BOUNDS,
        ),
        ("", "FACTORS", sampler_buffers::FACTORS),
        (
            "No number, leaves among nodes, and edges whose faces have changed sides.",
            "NONE",
            buffers::NONE as usize,
        ),
        ("", "LEAF", buffers::LEAF as usize),
        ("", "FLIPPED", buffers::FLIPPED as usize),
    ];
    let lines = sizes.map(|(doc, name, size)| {
        let doc = if doc.is_empty() {
            String::new()
        } else {
            format!("// {doc}\n")
        };
        format!("{doc}static const uint {name} = {size}u;\n")
    });
    format!("// `trees_slang` of `kernels.rs`.\n{}", lines.concat())
}

/// A kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    FirstHit,
    Occluded,
    Closest,
    Gather,
    /// True if cones can be asked at all.
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

    /// Whoever changes a source must compile it again.
    #[test]
    fn compiled_kernels_are_current() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/kernels");
        assert_eq!(
            pack().check(&[&folder], &[("trees.slang", trees_slang())]),
            Ok(())
        );
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
}
