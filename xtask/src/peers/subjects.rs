//! The scenes that capwalk and Mitsuba are compared in: where their files come from, and what
//! their derivatives are with respect to.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};

use crate::shell::root;

/// A scene that both programs can load.
pub struct Subject {
    pub name: &'static str,
    pub from: Origin,
    pub differentiated: Differentiated,
}

/// Where a scene file comes from.
#[derive(PartialEq)]
pub enum Origin {
    /// Exported by `capwalk scenes`.
    BuiltIn,
    /// A folder of `tests/scenes`.
    Folder,
    /// A file of `xtask/peers`; `peer_scenes.py` makes what it refers to.
    Peers,
    /// In the folder of public scenes, with the size of its image.
    Public(&'static str, [u32; 2]),
}

/// What the derivatives of an image are with respect to.
#[derive(PartialEq)]
pub enum Differentiated {
    /// The place of a shape. Derivative images are of its translation along an axis; whether
    /// Mitsuba's are right is measured.
    Motion { shape: &'static str, axis: char },
    /// An array, which has the same name in both programs.
    Texels(&'static str),
    /// The image is compared alone.
    Nothing,
}

/// Width and height of the images of built-in scenes, as `capwalk demo` has them;
/// those of the folders are small already.
const SIZE: [u32; 2] = [128, 96];

/// The tutorials of Mitsuba 3, a clone of `mitsuba-renderer/mitsuba-tutorials`, and "The Grey &
/// White Room" by Wig42 from <https://benedikt-bitterli.me/resources>, whose folder has the
/// scene for an older Mitsuba.
const CBOX: &str = "mitsuba-tutorials/scenes/cbox.xml";
const SIMPLE: &str = "mitsuba-tutorials/scenes/simple.xml";
const LIVING_ROOM: &str = "living-room/scene.xml";

/// All scenes.
pub const SUBJECTS: [Subject; 23] = [
    Subject::moving("leaf", Origin::BuiltIn, "leaf", 'x'),
    Subject::moving("ball", Origin::BuiltIn, "ball", 'x'),
    Subject::moving("box-room", Origin::BuiltIn, "box", 'x'),
    Subject::moving("lattice-shadow", Origin::BuiltIn, "lattice", 'y'),
    Subject::moving("sphere-shadow", Origin::Peers, "thing", 'z'),
    Subject::moving("cube-shadow", Origin::Peers, "thing", 'z'),
    Subject::moving("shadow_of_a_moving_occluder", Origin::Folder, "thing", 'x'),
    Subject::moving("emitter_moves", Origin::Folder, "lamp", 'y'),
    Subject::moving("interreflection", Origin::Folder, "thing", 'x'),
    Subject::moving("indirect_shadow", Origin::Folder, "sheet", 'x'),
    Subject::moving("cornell-box", Origin::Peers, "block", 'y'),
    Subject::moving("painted-box", Origin::Peers, "block", 'y'),
    Subject::moving("glossy-box", Origin::Peers, "block", 'y'),
    Subject::with_texels("texture-direct", "floor.bsdf.reflectance.data"),
    Subject::with_texels("texture-path", "floor.bsdf.reflectance.data"),
    Subject::with_texels("texture-sky", "floor.bsdf.reflectance.data"),
    Subject::with_texels("roughness-texture", "floor.bsdf.alpha.data"),
    Subject::with_texels("sky-texels", "sky.data"),
    Subject::image("arcade", Origin::Peers),
    Subject::image("many", Origin::Peers),
    Subject::image("cbox", Origin::Public(CBOX, [128, 128])),
    Subject::image("simple", Origin::Public(SIMPLE, [128, 128])),
    Subject::image("living-room", Origin::Public(LIVING_ROOM, [128, 72])),
];

impl Subject {
    const fn moving(name: &'static str, from: Origin, shape: &'static str, axis: char) -> Self {
        Self {
            name,
            from,
            differentiated: Differentiated::Motion { shape, axis },
        }
    }

    const fn with_texels(name: &'static str, array: &'static str) -> Self {
        Self {
            name,
            from: Origin::Peers,
            differentiated: Differentiated::Texels(array),
        }
    }

    const fn image(name: &'static str, from: Origin) -> Self {
        Self {
            name,
            from,
            differentiated: Differentiated::Nothing,
        }
    }

    /// The parameter that derivative images are of, where something moves.
    pub fn parameter(&self) -> Option<String> {
        match self.differentiated {
            Differentiated::Motion { shape, axis } => Some(format!("{shape}.translate.{axis}")),
            Differentiated::Texels(_) | Differentiated::Nothing => None,
        }
    }

    /// Width and height that the image gets; its own if `None`.
    pub fn size(&self) -> Option<[u32; 2]> {
        match self.from {
            Origin::BuiltIn => Some(SIZE),
            Origin::Public(_, size) => Some(size),
            Origin::Folder | Origin::Peers => None,
        }
    }

    /// The scene's file, or its name if it is built in; a public one's path in their folder.
    pub fn scene(&self) -> PathBuf {
        match self.from {
            Origin::BuiltIn => self.name.into(),
            Origin::Folder => self.folder().join("scene.xml"),
            Origin::Peers => root()
                .join("xtask/peers")
                .join(format!("{}.xml", self.name)),
            Origin::Public(file, _) => file.into(),
        }
    }

    /// The folder of a scene that has one.
    fn folder(&self) -> PathBuf {
        root().join("tests/scenes").join(self.name)
    }

    /// Puts the scene file into a folder, with what it refers to, if that is not made or public.
    pub fn copy_to(&self, folder: &Path, capwalk: &Path, public: Option<&Path>) -> Result<PathBuf> {
        // `capwalk` replaces no files of a run that was ended.
        if folder.exists() {
            fs::remove_dir_all(folder)?;
        }
        fs::create_dir_all(folder)?;
        let file = folder.join(format!("{}.xml", self.name));
        match self.from {
            Origin::BuiltIn => {
                let mut export = Command::new(capwalk);
                export.args(["scenes", "--export"]).arg(folder);
                let output = export.arg(self.name).output()?;
                if !output.status.success() {
                    bail!("capwalk: {}", String::from_utf8_lossy(&output.stderr));
                }
                Ok(file)
            }
            Origin::Peers => {
                fs::copy(self.scene(), &file)?;
                Ok(file)
            }
            Origin::Public(..) => {
                let public = public.context("public scenes need --public FOLDER")?;
                let source = public.join(self.scene());
                ensure!(
                    source.exists(),
                    "there is no {}; the folder of --public must have it",
                    source.display()
                );
                fs::copy(source, &file)?;
                Ok(file)
            }
            Origin::Folder => {
                let source = self.folder();
                let entries = fs::read_dir(&source)
                    .with_context(|| format!("cannot list {}", source.display()))?;
                for entry in entries {
                    let file = entry?;
                    fs::copy(file.path(), folder.join(file.file_name()))?;
                }
                Ok(folder.join("scene.xml"))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_exist() {
        for subject in SUBJECTS {
            let is_own = matches!(subject.from, Origin::Folder | Origin::Peers);
            assert_eq!(subject.scene().exists(), is_own, "{}", subject.name);
        }
    }
}
