//! The kernels that follow paths and take boundary terms, from the sources in `kernels`.

use std::sync::LazyLock;

use capwalk_gpu::{CompiledKernel, GROUP, KernelPack, compiled_kernels};

use crate::layout::hit::HIT_WORDS;
use crate::layout::path::{FORWARD_PATH, SIDE_WEIGHT};
use crate::layout::reverse_path::{KEPT, KEPT_WORDS};

/// As `cargo xtask kernels` compiled them.
pub fn pack() -> &'static KernelPack {
    static PACK: LazyLock<KernelPack> =
        LazyLock::new(|| KernelPack::unpack(include_bytes!("kernels/compiled.lzma")));
    &PACK
}

compiled_kernels! {
    pack:
    BEGIN_PATHS = "begin_paths" of GROUP,
    GO_ON = "go_on" of GROUP,
    GO_ON_DIFFUSE = "go_on_diffuse" of GROUP,
    BEGIN_AT_HITS = "begin_at_hits" of GROUP,
    BEGIN_FORWARD = "begin_forward" of GROUP,
    GO_ON_FORWARD = "go_on_forward" of GROUP,
    BEGIN_REVERSE = "begin_reverse" of GROUP,
    GO_ON_REVERSE = "go_on_reverse" of GROUP,
    /// Takes what arrives behind the vertices of a list back by one.
    GO_BACK = "go_back" of GROUP,
    CROSS_EDGES = "cross_edges" of GROUP,
    BEGIN_SIDES = "begin_sides" of GROUP,
    ADD_SIDES = "add_sides" of GROUP,
    CROSS_EDGES_BACK = "cross_edges_back" of GROUP,
    BEGIN_SIDES_BACK = "begin_sides_back" of GROUP,
    ADD_SIDES_BACK = "add_sides_back" of GROUP,
    /// Walks at the vertices that paths are at, before they go further, in forward mode.
    WALK = "walk" of GROUP,
    /// Takes back what directions that have walked change, behind the vertices of a list, in reverse mode.
    WALK_BACK = "walk_back" of GROUP,
}

/// The kernels that follow paths for a purpose.
#[derive(Debug)]
pub struct PathKernels {
    /// Draws the camera's rays and follows them to what they hit.
    pub begin: CompiledKernel,
    /// Takes the paths of a list further by a segment.
    pub go_on: CompiledKernel,
    /// Words of a path in what a launch is given: its place in a list, or the hit it begins at.
    pub input: usize,
    /// Words of a path: the first one lists the paths that go on.
    pub path: usize,
    /// Words that are kept of each of its vertices.
    pub vertex: usize,
}

impl PathKernels {
    /// True if vertices are kept.
    pub fn keeps(&self) -> bool {
        self.vertex > 0
    }

    /// Words of a path and of so many vertices.
    pub fn words(&self, levels: usize) -> usize {
        self.path + self.vertex * levels
    }
}

/// Images: behind the list is the light of a path.
pub const IMAGE: PathKernels = PathKernels {
    begin: BEGIN_PATHS,
    go_on: GO_ON,
    input: 1,
    path: SIDE_WEIGHT,
    vertex: 0,
};

/// Images of scenes where all surfaces are diffuse and light comes from no map.
pub const DIFFUSE_IMAGE: PathKernels = PathKernels {
    go_on: GO_ON_DIFFUSE,
    ..IMAGE
};

/// Images of paths that begin at what a camera's ray hits.
pub const IMAGE_FROM_HITS: PathKernels = PathKernels {
    begin: BEGIN_AT_HITS,
    input: HIT_WORDS,
    ..IMAGE
};

/// [`IMAGE_FROM_HITS`] for scenes of [`DIFFUSE_IMAGE`].
pub const DIFFUSE_IMAGE_FROM_HITS: PathKernels = PathKernels {
    go_on: DIFFUSE_IMAGE.go_on,
    ..IMAGE_FROM_HITS
};

/// Images with their derivative: behind the list is the light of a path, then its derivative.
pub const FORWARD: PathKernels = PathKernels {
    begin: BEGIN_FORWARD,
    go_on: GO_ON_FORWARD,
    input: 1,
    path: FORWARD_PATH,
    vertex: 0,
};

/// Derivatives of a loss. Behind a path is what is kept of its vertices.
pub const REVERSE: PathKernels = PathKernels {
    begin: BEGIN_REVERSE,
    go_on: GO_ON_REVERSE,
    input: 1,
    path: KEPT,
    vertex: KEPT_WORDS,
};

/// The kernels that take boundary terms at the vertices of paths.
#[derive(Debug)]
pub struct BoundaryKernels {
    /// Adds the boundary terms of light from emitters.
    pub cross_edges: CompiledKernel,
    /// Begins paths to both sides of edges.
    pub begin_sides: CompiledKernel,
    /// Takes the difference of what they bring.
    pub add_sides: CompiledKernel,
}

/// In forward mode, at the vertices that paths are at.
pub const BOUNDARY: BoundaryKernels = BoundaryKernels {
    cross_edges: CROSS_EDGES,
    begin_sides: BEGIN_SIDES,
    add_sides: ADD_SIDES,
};

/// In reverse mode, at vertices that are kept.
pub const BOUNDARY_BACK: BoundaryKernels = BoundaryKernels {
    cross_edges: CROSS_EDGES_BACK,
    begin_sides: BEGIN_SIDES_BACK,
    add_sides: ADD_SIDES_BACK,
};

#[cfg(test)]
mod tests {
    use std::path::Path;

    use capwalk_gpu::arrays_slang;

    use super::*;
    use crate::layout::slang;

    /// Whoever changes a source must compile it again.
    #[test]
    fn compiled_kernels_are_current() {
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let folders = ["gpu-render", "gpu"].map(|name| crates.join(name).join("src/kernels"));
        let folders = folders.each_ref().map(|path| &**path);
        let made = [("layout.slang", slang()), ("arrays.slang", arrays_slang())];
        assert_eq!(pack().check(&folders, &made, &KERNELS), Ok(()));
        // NVIDIA's driver is given eight arrays and, behind them, the launch.
        for (name, code) in pack().codes("ptx") {
            let takes = ["SLANG_globalParams[136]", "SLANG_globalParams+128]"];
            assert!(takes.iter().all(|what| code.contains(what)), "{name}");
        }
    }
}
