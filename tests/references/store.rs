//! References of derivatives: images of finite differences with standard errors, made once by
//! long runs and kept in the repository, so that a test takes the samples of its gradient only.
//! `cargo xtask references [TEST ...]` makes them again, as has to be done where a scene, a
//! parameter or a step changes.

use std::path::{Path, PathBuf};

use capwalk_diff::Estimate;
use capwalk_scene_io::image::{self, LayeredImage, Preview};

/// The variable in which `cargo xtask references` asks for references instead of tests.
const VARIABLE: &str = "CAPWALK_REFERENCES";

/// So many times the samples that a reference would have beside a gradient.
pub const FACTOR: u32 = 4;

const MEAN: &str = "reference";
const ERROR: &str = "reference_stderr";

/// Which reference is meant.
pub struct Reference<'a> {
    /// Letters, digits and lines: the name of its file.
    pub name: String,
    /// How far the parameter moves on each side, in its own units.
    pub step: f64,
    /// Samples per pixel on each side, before they are made [`FACTOR`] times as many.
    pub spp: u32,
    /// What is differentiated.
    pub of: &'a str,
}

/// Whether references are asked for, and not tests.
pub fn are_made() -> bool {
    std::env::var_os(VARIABLE).is_some()
}

impl Reference<'_> {
    /// The reference that is kept, or one that `compute` makes with so many samples per pixel, if
    /// references are asked for.
    ///
    /// # Panics
    ///
    /// If there is none, or it was made for another step or fewer samples.
    pub fn get(&self, compute: impl FnOnce(u32) -> Estimate) -> Estimate {
        if are_made() {
            self.keep(&compute(self.spp * FACTOR));
        }
        let file = self.file();
        let again = "make it again: cargo xtask references TEST";
        let kept = image::read(&file).unwrap_or_else(|error| panic!("{error}\n{again}"));
        for (key, expected) in self.notes() {
            let found = kept.metadata.iter().find(|(name, _)| *name == key);
            let found = found.map(|(_, value)| value.as_str());
            let shown = file.display();
            assert_eq!(found, Some(expected.as_str()), "{key} of {shown}\n{again}");
        }
        let layer = |name: &str| kept.layer(name).expect("written").clone();
        Estimate {
            mean: layer(MEAN),
            standard_error: layer(ERROR),
        }
    }

    fn keep(&self, made: &Estimate) {
        let file = self.file();
        let mut layered = LayeredImage {
            metadata: self.notes(),
            ..LayeredImage::default()
        };
        layered.push(MEAN, made.mean.clone());
        layered.push(ERROR, made.standard_error.clone());
        image::write(&file, &layered, &Preview::default()).expect("writable");
    }

    fn file(&self) -> PathBuf {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/references");
        folder.join(&self.name).with_extension("exr")
    }

    /// How it was made, which must be how it is asked for.
    fn notes(&self) -> Vec<(String, String)> {
        [
            ("of", self.of.to_owned()),
            ("step", self.step.to_string()),
            ("spp", (self.spp * FACTOR).to_string()),
        ]
        .map(|(key, value)| (key.to_owned(), value))
        .into()
    }
}

/// A name as letters, digits and lines.
pub fn plain(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    name.chars().map(plain).collect()
}
