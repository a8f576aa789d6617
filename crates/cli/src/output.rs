//! Where pictures go: formats by ending, and places that are known to be
//! writable before the work starts.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};
use capwalk_render::Statistics;
use capwalk_scene::Image;

/// Output files of a command, checked.
pub struct Files {
    paths: Vec<PathBuf>,
}

impl Files {
    /// The files that were asked for, or `stem` with the default endings.
    /// Folders are created; a file that cannot be written is an error now.
    pub fn new(asked: &[PathBuf], stem: &str, endings: &[&str]) -> Result<Self> {
        let paths = if asked.is_empty() {
            let defaults = endings.iter();
            defaults
                .map(|ending| PathBuf::from(format!("{stem}.{ending}")))
                .collect()
        } else {
            asked.to_vec()
        };
        for path in &paths {
            format(path)?;
            check_writable(path).with_context(|| format!("cannot write {}", path.display()))?;
        }
        Ok(Self { paths })
    }
}

/// File formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Exr,
    Npz,
    Png,
}

fn format(path: &Path) -> Result<Format> {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    Ok(match ending.to_ascii_lowercase().as_str() {
        "exr" => Format::Exr,
        "npz" => Format::Npz,
        "png" => Format::Png,
        _ => bail!(
            "cannot tell the format of {} by its ending; expected .exr, .npz or .png",
            path.display()
        ),
    })
}

/// Creates the folder of a file if it is missing, and a file beside it for a
/// moment: results are written under another name first and then moved.
fn check_writable(path: &Path) -> Result<()> {
    ensure!(!path.is_dir(), "it is a folder");
    let folder = path.parent().unwrap_or(Path::new(""));
    if !folder.as_os_str().is_empty() {
        fs::create_dir_all(folder)
            .with_context(|| format!("cannot create the folder {}", folder.display()))?;
    }
    let probe = folder.join(format!(".capwalk-{}.probe", std::process::id()));
    File::create(&probe)?;
    fs::remove_file(&probe)?;
    Ok(())
}
