//! What the host writes and the kernels read: sizes, marks, and which number of a query is what. Declared once,
//! here; the kernels include it as `arrays.slang`, which `cargo xtask kernels` writes.

use capwalk_geometry::buffers;

/// Constants in groups, which are modules, and a function that writes them as Slang in a format, where names stand
/// without the group's.
#[doc(hidden)]
#[macro_export]
macro_rules! slang_constants {
    (fn $lines:ident: $type:ty, $format:literal;
        $($(#[doc = $doc:literal])* $group:ident { $($name:ident = $value:expr,)* })*) => {
        $($(#[doc = $doc])* pub mod $group {
            #[allow(unused_imports)]
            use super::*;
            $(pub const $name: $type = $value;)*
        })*

        /// The lines of all groups.
        fn $lines() -> String {
            let groups = [$((
                concat!($("//", $doc, "\n",)*),
                &[$((stringify!($name), $group::$name)),*][..],
            )),*];
            let lines = groups.iter().map(|(doc, names)| {
                let names = names.iter().map(|(name, value)| format!($format, name, value));
                format!("{doc}{}", names.collect::<String>())
            });
            lines.collect()
        }
    };
}

slang_constants! {
    fn whole_numbers: usize, "static const uint {} = {}u;\n";

    /// Threads in a group.
    threads {
        GROUP = crate::compiled_kernel::GROUP,
    }

    /// Ways from the root to a leaf pass no more nodes; words of a node of a tree of triangles, and of one of edges; numbers of a
    /// triangle, and of an edge.
    tree {
        LEVELS = buffers::LEVELS, RAY_NODE = buffers::RAY_NODE, CONE_NODE = buffers::CONE_NODE,
        TRIANGLE = buffers::TRIANGLE, EDGE = buffers::EDGE,
    }

    /// No number, leaves among nodes, edges whose faces have changed sides, and the first answer to a query whose loops were cut
    /// short.
    mark {
        NONE = buffers::NONE as usize, LEAF = buffers::LEAF as usize, FLIPPED = buffers::FLIPPED as usize,
        CUT_SHORT = u32::MAX as usize - 1,
    }

    /// Rows of four words of a query, for bounds.
    view {
        VIEW = 3,
    }

    /// Numbers of a ray, for exact tests, and of a hit: its distance and the weights of two corners.
    ray {
        RAY_ORIGIN = 0, RAY_SHEAR = 3, RAY_INVERSE_Z = 5, RAY_RANGE = 6, RAY_LOCAL_PER_T = 8, RAY_ENTER = 9,
        RAY_EDGE_ON = 10, RAY_LARGEST = 11, RAY = 12,
        HIT_NUMBERS = 3,
    }

    /// Numbers of a cone, for exact tests, and of the nearest point in it: its place on the edge and its position.
    cone {
        CONE_APEX = 0, CONE_AXIS = 3, CONE_PLANE_POINT = 6, CONE_PLANE_NORMAL = 9,
        CONE_ON_PLANE = 12, CONE_SIZE = 13, CONE_LIMIT = 14, CONE_LARGEST = 15, CONE = 16,
        NEAREST_NUMBERS = 4,
    }

    /// Numbers of a frame: its centre, local units per world unit, the largest number, and the least length that has an inverse.
    frame {
        FRAME_CENTRE = 0, FRAME_SCALE = 3, FRAME_LARGEST = 4, FRAME_LEAST = 5, FRAME = 6,
    }

    /// Numbers of a position in double precision, and in single precision, where it is a sum of two.
    position {
        EXACT_POSITION = 3, SUMMED_POSITION = 6,
    }
}

slang_constants! {
    fn numbers: f64, "static const float {} = {:e};\n";

    /// Error of positions in a tree's coordinates, and of what kernels compute from them for the bounds of edges, per unit of distance
    /// from the viewpoint: sums of some thirty terms of at most that size, each rounded by at most 2⁻²⁴, among them those of the bounds
    /// as they are stored. Components of a ray's direction that are slower than this, relative to the fastest, are rounded to it, which
    /// keeps their inverses finite and moves no point within the tree by more than twice as much.
    margin {
        POSITION_MARGIN = 1.0 / (1 << 18) as f64, SLOWEST = capwalk_geometry::ray::SLOWEST,
    }
}

/// `arrays.slang`.
pub fn slang() -> String {
    format!(
        "// `layout.rs` of `capwalk-gpu` as Slang.\n{}{}",
        whole_numbers(),
        numbers()
    )
}
