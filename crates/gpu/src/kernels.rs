//! The kernels as `cargo xtask kernels` compiled them from the sources in `kernels`.

use crate::compiled_kernel::{CompiledKernel, GROUP};
use crate::precision::Precision;

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
    /// All that a driver needs of it.
    pub fn compiled(self) -> CompiledKernel {
        let precisions = [Precision::Single, Precision::Double];
        CompiledKernel {
            name: self.name(),
            group: self.group(),
            wgsl: precisions.map(|precision| self.wgsl(precision)),
            ptx: precisions.map(|precision| self.ptx(precision)),
        }
    }

    /// Its entry point.
    fn name(self) -> &'static str {
        match self {
            Self::FirstHit => "first_hit",
            Self::Occluded => "occluded",
            Self::Closest => "closest",
            Self::Gather => "gather",
            Self::Eights => "eights",
            Self::MovedTriangles => "moved_triangles",
            Self::MovedEdges => "moved_edges",
            Self::BoundTriangles => "bound_triangles",
            Self::BoundEdges => "bound_edges",
            Self::SampleEdges => "sample_edges",
        }
    }

    /// How many queries a group works on: cones have eight threads each, children of nodes a
    /// group.
    fn group(self) -> usize {
        match self {
            Self::FirstHit | Self::Occluded | Self::Eights => GROUP,
            Self::MovedTriangles | Self::MovedEdges | Self::SampleEdges => GROUP,
            Self::Closest | Self::Gather => GROUP / 8,
            Self::BoundTriangles | Self::BoundEdges => 1,
        }
    }

    /// In WGSL.
    fn wgsl(self, precision: Precision) -> &'static str {
        match (self, precision) {
            (Self::FirstHit, Precision::Single) => include_str!("kernels/first_hit_single.wgsl"),
            (Self::FirstHit, Precision::Double) => include_str!("kernels/first_hit_double.wgsl"),
            (Self::Occluded, Precision::Single) => include_str!("kernels/occluded_single.wgsl"),
            (Self::Occluded, Precision::Double) => include_str!("kernels/occluded_double.wgsl"),
            (Self::Closest, Precision::Single) => include_str!("kernels/closest_single.wgsl"),
            (Self::Closest, Precision::Double) => include_str!("kernels/closest_double.wgsl"),
            (Self::Gather, Precision::Single) => include_str!("kernels/gather_single.wgsl"),
            (Self::Gather, Precision::Double) => include_str!("kernels/gather_double.wgsl"),
            (Self::Eights, Precision::Single) => include_str!("kernels/eights_single.wgsl"),
            (Self::Eights, Precision::Double) => include_str!("kernels/eights_double.wgsl"),
            (Self::MovedTriangles, Precision::Single) => {
                include_str!("kernels/moved_triangles_single.wgsl")
            }
            (Self::MovedTriangles, Precision::Double) => {
                include_str!("kernels/moved_triangles_double.wgsl")
            }
            (Self::MovedEdges, Precision::Single) => {
                include_str!("kernels/moved_edges_single.wgsl")
            }
            (Self::MovedEdges, Precision::Double) => {
                include_str!("kernels/moved_edges_double.wgsl")
            }
            (Self::BoundTriangles, Precision::Single) => {
                include_str!("kernels/bound_triangles_single.wgsl")
            }
            (Self::BoundTriangles, Precision::Double) => {
                include_str!("kernels/bound_triangles_double.wgsl")
            }
            (Self::BoundEdges, Precision::Single) => {
                include_str!("kernels/bound_edges_single.wgsl")
            }
            (Self::BoundEdges, Precision::Double) => {
                include_str!("kernels/bound_edges_double.wgsl")
            }
            (Self::SampleEdges, Precision::Single) => {
                include_str!("kernels/sample_edges_single.wgsl")
            }
            (Self::SampleEdges, Precision::Double) => {
                include_str!("kernels/sample_edges_double.wgsl")
            }
        }
    }

    /// In PTX, NVIDIA's language between compilers and drivers.
    fn ptx(self, precision: Precision) -> &'static str {
        match (self, precision) {
            (Self::FirstHit, Precision::Single) => include_str!("kernels/first_hit_single.ptx"),
            (Self::FirstHit, Precision::Double) => include_str!("kernels/first_hit_double.ptx"),
            (Self::Occluded, Precision::Single) => include_str!("kernels/occluded_single.ptx"),
            (Self::Occluded, Precision::Double) => include_str!("kernels/occluded_double.ptx"),
            (Self::Closest, Precision::Single) => include_str!("kernels/closest_single.ptx"),
            (Self::Closest, Precision::Double) => include_str!("kernels/closest_double.ptx"),
            (Self::Gather, Precision::Single) => include_str!("kernels/gather_single.ptx"),
            (Self::Gather, Precision::Double) => include_str!("kernels/gather_double.ptx"),
            (Self::Eights, Precision::Single) => include_str!("kernels/eights_single.ptx"),
            (Self::Eights, Precision::Double) => include_str!("kernels/eights_double.ptx"),
            (Self::MovedTriangles, Precision::Single) => {
                include_str!("kernels/moved_triangles_single.ptx")
            }
            (Self::MovedTriangles, Precision::Double) => {
                include_str!("kernels/moved_triangles_double.ptx")
            }
            (Self::MovedEdges, Precision::Single) => include_str!("kernels/moved_edges_single.ptx"),
            (Self::MovedEdges, Precision::Double) => include_str!("kernels/moved_edges_double.ptx"),
            (Self::BoundTriangles, Precision::Single) => {
                include_str!("kernels/bound_triangles_single.ptx")
            }
            (Self::BoundTriangles, Precision::Double) => {
                include_str!("kernels/bound_triangles_double.ptx")
            }
            (Self::BoundEdges, Precision::Single) => include_str!("kernels/bound_edges_single.ptx"),
            (Self::BoundEdges, Precision::Double) => include_str!("kernels/bound_edges_double.ptx"),
            (Self::SampleEdges, Precision::Single) => {
                include_str!("kernels/sample_edges_single.ptx")
            }
            (Self::SampleEdges, Precision::Double) => {
                include_str!("kernels/sample_edges_double.ptx")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiled_kernel::RAYS_SOURCE;
    use capwalk_geometry::buffers;

    /// Whoever changes the source must compile it again, and nobody edits the result.
    #[test]
    fn compiled_kernels_are_current() {
        let included = |source: &str, name: &str, content: &str| {
            source.replace(&format!("#include \"{name}\"\n"), content)
        };
        let queries = include_str!("kernels/queries.slang");
        let queries = &*included(queries, "rays.slang", RAYS_SOURCE);
        let sampled = include_str!("kernels/sampled.slang");
        let sampled = &*included(sampled, "queries.slang", queries);
        let moved = include_str!("kernels/moved.slang");
        let bounds = include_str!("kernels/bounds.slang");
        for (kernel, source) in [
            (Kernel::FirstHit, queries),
            (Kernel::Occluded, queries),
            (Kernel::Closest, queries),
            (Kernel::Gather, queries),
            (Kernel::Eights, queries),
            (Kernel::MovedTriangles, moved),
            (Kernel::MovedEdges, moved),
            (Kernel::BoundTriangles, bounds),
            (Kernel::BoundEdges, bounds),
            (Kernel::SampleEdges, sampled),
        ] {
            assert_eq!(kernel.compiled().check(source), Ok(()));
        }
    }

    /// Kernels have room for every way down a tree.
    #[test]
    fn trees_are_not_too_deep() {
        let room = format!("static const uint LEVELS = {};", buffers::LEVELS);
        assert!(RAYS_SOURCE.contains(&room));
    }
}
