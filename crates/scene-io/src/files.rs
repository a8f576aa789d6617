//! Finding and reading the files that a scene names.

use std::path::{Path, PathBuf};

use crate::texts::Text;

/// The largest scene file that is read, bytes; the largest known ones have 30 MB.
const LARGEST_FILE: u64 = 1 << 29;

/// The text in a file, or what is wrong with the file.
pub(crate) fn read_text(path: &Path) -> Result<Text, String> {
    let name = path.display().to_string();
    let cannot = |reason: String| format!("cannot read \"{name}\": {reason}");
    let metadata = std::fs::metadata(path).map_err(|error| cannot(error.to_string()))?;
    if metadata.is_dir() {
        return Err(cannot("it is a folder; expected a scene file".into()));
    }
    if metadata.len() > LARGEST_FILE {
        let (size, most) = (metadata.len() >> 20, LARGEST_FILE >> 20);
        return Err(cannot(format!(
            "it has {size} MiB; expected at most {most}"
        )));
    }
    let bytes = std::fs::read(path).map_err(|error| cannot(error.to_string()))?;
    let content = String::from_utf8(bytes).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        cannot(format!(
            "byte {valid} is not UTF-8 text; expected an XML scene file"
        ))
    })?;
    Ok(Text::of_file(path, content))
}

/// The path of a file in the first of the directories that has it, or a message
/// that lists what was tried.
pub(crate) fn find_file(name: &str, directories: &[PathBuf]) -> Result<PathBuf, String> {
    if name.is_empty() {
        return Err("the file name is empty".into());
    }
    let tried: Vec<PathBuf> = directories.iter().map(|d| d.join(name)).collect();
    if let Some(found) = tried.iter().find(|path| path.exists()) {
        return Ok(found.clone());
    }
    let mut places: Vec<String> = tried
        .iter()
        .map(|p| format!("\"{}\"", p.display()))
        .collect();
    places.dedup();
    Err(format!("there is no file {}", places.join(" or ")))
}
