//! A kernel as `cargo xtask kernels` compiled it, and the pack in which those of a crate are.

use std::collections::{BTreeSet, HashMap};
use std::io::Read;
use std::path::Path;

use lzma_rust2::LzmaReader;

use crate::precision::Precision;

/// How many threads there are in a group.
pub const GROUP: usize = 64;

/// How many groups a launch may have, which are counted in one dimension.
const MOST_GROUPS: usize = 1 << 15;

/// A kernel of a pack.
#[derive(Clone, Copy, Debug)]
pub struct CompiledKernel {
    /// Its entry point.
    pub name: &'static str,
    /// How many queries, paths or the like a group of 64 threads works on.
    pub group: usize,
    /// The pack of its crate.
    pub pack: fn() -> &'static KernelPack,
}

impl CompiledKernel {
    /// What drivers know a compiled one by: kernels of two crates may have the same name.
    pub(crate) fn key(&self) -> (&'static str, usize) {
        (self.name, std::ptr::from_ref((self.pack)()) as usize)
    }

    /// No launch has more queries.
    pub(crate) fn most(&self) -> usize {
        MOST_GROUPS * self.group
    }

    /// In WGSL.
    pub(crate) fn wgsl_in(&self, precision: Precision) -> &'static str {
        self.code("wgsl", precision)
    }

    /// In PTX, NVIDIA's language between compilers and drivers.
    #[cfg_attr(not(any(target_os = "linux", target_os = "windows")), allow(dead_code))]
    pub(crate) fn ptx_in(&self, precision: Precision) -> &'static str {
        self.code("ptx", precision)
    }

    fn code(&self, language: &str, precision: Precision) -> &'static str {
        let file = self.file(language, precision);
        match (self.pack)().kernels.get(&*file) {
            Some(kernel) => kernel.code,
            None => panic!("no {file} in the pack of kernels: run `cargo xtask kernels`"),
        }
    }

    /// The name of its file in the pack.
    fn file(&self, language: &str, precision: Precision) -> String {
        let precision = match precision {
            Precision::Single => "single",
            Precision::Double => "double",
        };
        format!("{}_{precision}.{language}", self.name)
    }
}

/// The kernels of a crate as constants: the function that has their pack, then of each its entry point, and how many
/// queries, paths or the like a group of 64 threads works on. For tests, `KERNELS` are all of them.
#[doc(hidden)]
#[macro_export]
macro_rules! compiled_kernels {
    ($pack:ident: $($(#[$doc:meta])* $kernel:ident = $name:literal of $group:expr,)*) => {
        $($(#[$doc])* pub const $kernel: $crate::CompiledKernel = $crate::CompiledKernel {
            name: $name,
            group: $group,
            pack: $pack,
        };)*

        #[cfg(test)]
        const KERNELS: [$crate::CompiledKernel; [$($name),*].len()] = [$($kernel),*];
    };
}

/// The compiled kernels of a crate: one LZMA stream of text, that of each kernel behind a line that begins
/// with `////` and says its file name, the source it was compiled from, that source's checksum and its own.
#[derive(Debug)]
pub struct KernelPack {
    kernels: HashMap<&'static str, PackedKernel>,
}

#[derive(Debug)]
struct PackedKernel {
    source: &'static str,
    /// Checksum of the source, with included files in the place of the lines that include them.
    checksum: &'static str,
    own_checksum: &'static str,
    code: &'static str,
}

impl KernelPack {
    const MARK: &str = "\n//// ";

    /// The pack in a file that `cargo xtask kernels` wrote; it stays in memory until the process ends.
    ///
    /// # Panics
    ///
    /// If the file is anything else, as that of a crate whose kernels were not compiled yet.
    pub fn unpack(packed: &[u8]) -> Self {
        let mut text = String::new();
        LzmaReader::new_mem_limit(packed, u32::MAX, None)
            .and_then(|mut reader| reader.read_to_string(&mut text))
            .expect("a pack of kernels, which `cargo xtask kernels` writes anew");
        let text: &'static str = text.leak();
        // Each kernel ends with the line before the next one's head.
        let heads = text.match_indices(Self::MARK);
        let starts: Vec<usize> = heads.map(|(at, _)| at + 1).chain([text.len()]).collect();
        let kernels = starts.windows(2).map(|ends| {
            let part = &text[ends[0] + Self::MARK.len() - 1..ends[1]];
            let (head, code) = part.split_once('\n').expect("a head of a line");
            let words: Vec<&str> = head.split(' ').collect();
            let [file, source, checksum, own_checksum] = words[..] else {
                panic!("{head}: not the head of a kernel");
            };
            let kernel = PackedKernel {
                source,
                checksum,
                own_checksum,
                code,
            };
            (file, kernel)
        });
        Self {
            kernels: kernels.collect(),
        }
    }

    /// An error, in words, if its kernels are not these, in each language and precision; if one was compiled from
    /// another source than the one of that name that was made, or is in the first of these folders that has it; or if
    /// it is damaged. For tests.
    pub fn check(
        &self,
        folders: &[&Path],
        made: &[(&str, String)],
        kernels: &[CompiledKernel],
    ) -> Result<(), String> {
        let versions = [Precision::Single, Precision::Double]
            .map(|precision| ["wgsl", "ptx"].map(|language| (language, precision)));
        let files = kernels.iter().flat_map(|kernel| {
            let files = versions.as_flattened().iter();
            files.map(|&(language, precision)| kernel.file(language, precision))
        });
        let named: BTreeSet<String> = files.collect();
        let packed = self.kernels.keys().map(|&file| file.to_owned()).collect();
        if let Some(file) = named.difference(&packed).next() {
            return Err(format!("no {file}: run `cargo xtask kernels`"));
        }
        if let Some(file) = packed.difference(&named).next() {
            return Err(format!("{file} is the code of no kernel of the crate"));
        }
        for (file, kernel) in &self.kernels {
            let source = with_includes(folders, made, kernel.source)?;
            if checksum(&source) != kernel.checksum {
                return Err(format!("{file} is old: run `cargo xtask kernels`"));
            }
            if checksum(kernel.code) != kernel.own_checksum {
                return Err(format!("{file} is damaged: run `cargo xtask kernels`"));
            }
        }
        Ok(())
    }

    /// The file names and texts of the kernels in a language, `wgsl` or `ptx`. For tests.
    pub fn codes(&self, language: &str) -> impl Iterator<Item = (&'static str, &'static str)> {
        let is_this = move |file: &str| file.rsplit('.').next() == Some(language);
        let kernels = self.kernels.iter();
        kernels.filter_map(move |(file, kernel)| is_this(file).then_some((*file, kernel.code)))
    }
}

/// A source with what it includes in the place of the lines that say so.
fn with_includes(folders: &[&Path], made: &[(&str, String)], name: &str) -> Result<String, String> {
    let source = match made.iter().find(|(its, _)| *its == name) {
        Some((_, source)) => source.clone(),
        None => {
            let mut paths = folders.iter().map(|folder| folder.join(name));
            let path = paths.find(|path| path.exists());
            let path = path.ok_or_else(|| format!("{name}: no such source"))?;
            std::fs::read_to_string(path).map_err(|error| format!("{name}: {error}"))?
        }
    };
    let lines = source.split_inclusive('\n').map(|line| {
        let included = line.strip_prefix("#include \"");
        match included.and_then(|rest| rest.strip_suffix("\"\n")) {
            Some(included) => with_includes(folders, made, included),
            None => Ok(line.to_owned()),
        }
    });
    lines.collect()
}

/// FNV-1a with 64 bits, as `xtask/kernels.py` computes it.
fn checksum(text: &str) -> String {
    let hash = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    format!("{hash:016x}")
}
