//! The kernels as `cargo xtask kernels` compiled them from the sources in `kernels`.

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

/// How many there are.
pub const KERNELS: usize = 10;

/// How many threads there are in a group.
pub const GROUP: usize = 64;

/// How many groups a launch may have, which are counted in one dimension.
const MOST_GROUPS: usize = 1 << 15;

impl Kernel {
    /// Its entry point.
    pub fn name(self) -> &'static str {
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
    pub fn group(self) -> usize {
        match self {
            Self::FirstHit | Self::Occluded | Self::Eights => GROUP,
            Self::MovedTriangles | Self::MovedEdges | Self::SampleEdges => GROUP,
            Self::Closest | Self::Gather => GROUP / 8,
            Self::BoundTriangles | Self::BoundEdges => 1,
        }
    }

    /// No launch has more queries.
    pub fn most(self) -> usize {
        MOST_GROUPS * self.group()
    }

    /// In WGSL.
    pub fn wgsl(self, precision: Precision) -> &'static str {
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
    #[cfg_attr(not(any(target_os = "linux", target_os = "windows")), allow(dead_code))]
    pub fn ptx(self, precision: Precision) -> &'static str {
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
    use capwalk_geometry::buffers;

    /// FNV-1a with 64 bits. The first lines of a compiled kernel end with those of its source
    /// and of what follows.
    fn checksum(text: &str) -> String {
        let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
        format!("{hash:016x}")
    }

    /// Whoever changes the source must compile it again, and nobody edits the result.
    #[test]
    fn compiled_kernels_are_current() {
        let sources = [
            include_str!("kernels/queries.slang"),
            include_str!("kernels/moved.slang"),
            include_str!("kernels/bounds.slang"),
        ];
        let [queries, moved, bounds] = sources.map(checksum);
        let sampled = include_str!("kernels/sampled.slang");
        let sampled = checksum(&sampled.replace("#include \"queries.slang\"\n", sources[0]));
        for (kernel, source) in [
            (Kernel::FirstHit, &queries),
            (Kernel::Occluded, &queries),
            (Kernel::Closest, &queries),
            (Kernel::Gather, &queries),
            (Kernel::Eights, &queries),
            (Kernel::MovedTriangles, &moved),
            (Kernel::MovedEdges, &moved),
            (Kernel::BoundTriangles, &bounds),
            (Kernel::BoundEdges, &bounds),
            (Kernel::SampleEdges, &sampled),
        ] {
            for (compiled, precision) in [Precision::Single, Precision::Double]
                .into_iter()
                .flat_map(|p| [(kernel.wgsl(p), p), (kernel.ptx(p), p)])
            {
                let (head, body) = compiled.split_once("\n\n").expect("a head");
                let of = |what: &str| {
                    let line = head.lines().find_map(|line| line.strip_prefix(what));
                    line.unwrap_or_default().to_owned()
                };
                let name = kernel.name();
                assert_eq!(
                    &of("// source: "),
                    source,
                    "{name} {precision:?} is old: run `cargo xtask kernels`"
                );
                assert_eq!(
                    of("// result: "),
                    checksum(body),
                    "{name} {precision:?} was edited: run `cargo xtask kernels`"
                );
                assert!(!of("// compiler: ").is_empty());
            }
        }
    }

    /// Kernels have room for every way down a tree.
    #[test]
    fn trees_are_not_too_deep() {
        let room = format!("static const uint LEVELS = {};", buffers::LEVELS);
        assert!(include_str!("kernels/queries.slang").contains(&room));
    }
}
