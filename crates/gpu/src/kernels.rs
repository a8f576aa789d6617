//! The kernels as `cargo xtask kernels` compiled them from `kernels/queries.slang`.

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
        }
    }

    /// How many queries a group works on: cones have eight threads each.
    fn group(self) -> usize {
        match self {
            Self::FirstHit | Self::Occluded | Self::Eights => GROUP,
            Self::Closest | Self::Gather => GROUP / 8,
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
        let source = [include_str!("kernels/queries.slang"), RAYS_SOURCE].concat();
        for kernel in [
            Kernel::FirstHit,
            Kernel::Occluded,
            Kernel::Closest,
            Kernel::Gather,
            Kernel::Eights,
        ] {
            assert_eq!(kernel.compiled().check(&source), Ok(()));
        }
    }

    /// Kernels have room for every way down a tree.
    #[test]
    fn trees_are_not_too_deep() {
        let room = format!("static const uint LEVELS = {};", buffers::LEVELS);
        assert!(RAYS_SOURCE.contains(&room));
    }
}
