//! The kernels of queries and refits, from the sources in `kernels`.

use std::sync::LazyLock;

use crate::compiled_kernel::{GROUP, KernelPack};
use crate::compiled_kernels;

/// As `cargo xtask kernels` compiled them.
pub fn pack() -> &'static KernelPack {
    static PACK: LazyLock<KernelPack> =
        LazyLock::new(|| KernelPack::unpack(include_bytes!("kernels/compiled.lzma")));
    &PACK
}

// Children of nodes have a group of threads each.
compiled_kernels! {
    pack:
    FIRST_HIT = "first_hit" of GROUP,
    OCCLUDED = "occluded" of GROUP,
    CLOSEST = "closest" of GROUP,
    GATHER = "gather" of GROUP,
    /// Triangles and edges at new positions.
    MOVED_TRIANGLES = "moved_triangles" of GROUP,
    MOVED_EDGES = "moved_edges" of GROUP,
    /// Bounds of the children of nodes around these.
    BOUND_TRIANGLES = "bound_triangles" of 1,
    BOUND_EDGES = "bound_edges" of 1,
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::layout;

    /// Whoever changes a source must compile it again.
    #[test]
    fn compiled_kernels_are_current() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/kernels");
        let made = [("arrays.slang", layout::slang())];
        assert_eq!(pack().check(&[&folder], &made, &KERNELS), Ok(()));
    }
}
