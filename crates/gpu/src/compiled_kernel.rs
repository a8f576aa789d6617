//! A kernel as `cargo xtask kernels` compiled it.

use crate::precision::Precision;

/// How many threads there are in a group.
pub const GROUP: usize = 64;

/// How many groups a launch may have, which are counted in one dimension.
const MOST_GROUPS: usize = 1 << 15;

/// What all sources of kernels may include: rays in a tree of triangles.
pub const RAYS_SOURCE: &str = include_str!("kernels/rays.slang");

/// A kernel, compiled ahead by `cargo xtask kernels` for every interface and precision.
#[derive(Clone, Copy, Debug)]
pub struct CompiledKernel {
    /// Its entry point.
    pub name: &'static str,
    /// How many queries, paths or the like a group of 64 threads works on.
    pub group: usize,
    /// In WGSL: in single precision, and in double.
    pub wgsl: [&'static str; 2],
    /// In PTX, NVIDIA's language between compilers and drivers, likewise.
    pub ptx: [&'static str; 2],
}

impl CompiledKernel {
    /// An error, in words, if it was compiled from another source than this one (with what it
    /// includes in the place of the lines that say so), or was edited. For tests: the first lines of
    /// a compiled kernel end with checksums of its source and of what follows.
    pub fn check(&self, source: &str) -> Result<(), String> {
        for compiled in self.wgsl.into_iter().chain(self.ptx) {
            let (head, body) = compiled.split_once("\n\n").ok_or("it has no head")?;
            let of = |what: &str| {
                let line = head.lines().find_map(|line| line.strip_prefix(what));
                line.unwrap_or_default()
            };
            let problem = if of("// source: ") != checksum(source) {
                "is old"
            } else if of("// result: ") != checksum(body) {
                "was edited"
            } else if of("// compiler: ").is_empty() {
                "names no compiler"
            } else {
                continue;
            };
            return Err(format!(
                "{} {problem}: run `cargo xtask kernels`",
                self.name
            ));
        }
        Ok(())
    }

    /// What drivers know a compiled one by: kernels of two crates may have the same name.
    pub(crate) fn key(&self) -> (&'static str, usize) {
        (self.name, self.wgsl[0].as_ptr() as usize)
    }

    /// No launch has more queries.
    pub(crate) fn most(&self) -> usize {
        MOST_GROUPS * self.group
    }

    pub(crate) fn wgsl_in(&self, precision: Precision) -> &'static str {
        self.wgsl[precision as usize]
    }

    #[cfg_attr(not(any(target_os = "linux", target_os = "windows")), allow(dead_code))]
    pub(crate) fn ptx_in(&self, precision: Precision) -> &'static str {
        self.ptx[precision as usize]
    }
}

/// FNV-1a with 64 bits.
fn checksum(text: &str) -> String {
    let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    format!("{hash:016x}")
}
