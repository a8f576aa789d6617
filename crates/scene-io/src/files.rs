//! Finding and reading files by name: the one place that opens them.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::texts::Text;

/// The largest scene file that is read, bytes; the largest known ones have 30 MB.
pub(crate) const LARGEST_TEXT: u64 = 1 << 29;

/// The largest file of any kind that is read, bytes: more than the meshes and images of
/// any known scene, and a bound on the time and memory that a wrong name costs.
const LARGEST_FILE: u64 = 1 << 33;

/// The bytes of a file. What is no file, and what has no end, is refused before it is
/// opened: a pipe would wait for whoever writes into it, a device never ends.
pub fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    read_at_most(path, LARGEST_FILE)
}

/// The text in a file, see [`read_file`].
pub fn read_text_file(path: &Path) -> io::Result<String> {
    String::from_utf8(read_file(path)?).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        io::Error::other(format!("byte {valid} is not UTF-8 text"))
    })
}

/// A file to be read in parts; what [`read_file`] refuses is refused.
pub(crate) fn open_file(path: &Path) -> io::Result<File> {
    Ok(open_at_most(path, LARGEST_FILE)?.0)
}

/// A file and its size in bytes.
fn open_at_most(path: &Path, most: u64) -> io::Result<(File, u64)> {
    regular_size(&fs::metadata(path)?, most)?;
    let file = File::open(path)?;
    // The name may mean something else by now.
    let size = regular_size(&file.metadata()?, most)?;
    Ok((file, size))
}

fn read_at_most(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let (file, size) = open_at_most(path, most)?;
    let mut bytes = Vec::new();
    bytes
        .try_reserve_exact(size as usize)
        .map_err(|_| io::Error::other(format!("there is no memory for its {size} bytes")))?;
    file.take(size).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// How many bytes a file has, or why it is not read.
fn regular_size(metadata: &fs::Metadata, most: u64) -> io::Result<u64> {
    let refuse = |reason: String| Err(io::Error::other(reason));
    if metadata.is_dir() {
        return refuse("it is a folder; expected a file".into());
    }
    if !metadata.is_file() {
        let reason = "it is a pipe or a device, which may have no end; \
                      write its contents into a file and give that";
        return refuse(reason.into());
    }
    match metadata.len() {
        // Files of the system say so, too, and may never end.
        0 => refuse(
            "it is empty, or one of the system's, as in /proc; expected a file with contents"
                .into(),
        ),
        size if size > most => {
            let (size, most) = (size >> 20, most >> 20);
            refuse(format!("it has {size} MiB; expected at most {most}"))
        }
        size => Ok(size),
    }
}

/// The text in a scene file, or what is wrong with the file.
pub(crate) fn read_text(path: &Path) -> Result<Text, String> {
    let name = path.display().to_string();
    let cannot = |reason: String| format!("cannot read \"{name}\": {reason}");
    let bytes = read_at_most(path, LARGEST_TEXT).map_err(|error| cannot(error.to_string()))?;
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

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::fs::symlink;
    use std::process::Command;

    /// What never ends, what waits, and what has no bytes is refused at once; a link to a
    /// file is that file.
    #[test]
    fn only_files_are_read() {
        let folder = std::env::temp_dir().join(format!("capwalk-files-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a temporary directory");
        let pipe = folder.join("pipe");
        let made = Command::new("mkfifo").arg(&pipe).status();
        assert!(made.expect("there is mkfifo").success());
        let endless = ["/dev/zero", "/dev/random", "/dev/stdin"].map(PathBuf::from);
        for path in endless.iter().chain([&pipe]).filter(|path| path.exists()) {
            // Under a test, standard input may be a file.
            if path.is_file() {
                continue;
            }
            let error = read_file(path).expect_err("no end").to_string();
            assert!(error.contains("write its contents into a file"), "{error}");
        }
        let error = read_file(&folder).expect_err("a folder").to_string();
        assert_eq!(error, "it is a folder; expected a file");

        let (file, link) = (folder.join("file"), folder.join("link"));
        fs::write(&file, "four").expect("writable");
        symlink(&file, &link).expect("linkable");
        assert_eq!(read_file(&link).expect("a file"), b"four");
        let error = read_at_most(&link, 3).expect_err("too long").to_string();
        assert!(error.contains("expected at most"), "{error}");
        // Says that it is empty.
        let system = Path::new("/proc/self/status");
        if system.exists() {
            let error = read_file(system).expect_err("of the system").to_string();
            assert!(error.starts_with("it is empty"), "{error}");
        }
        let hole = folder.join("hole");
        let large = File::create(&hole).expect("writable");
        large.set_len(LARGEST_FILE + 1).expect("a file with a hole");
        assert!(read_file(&hole).is_err());
        fs::remove_dir_all(&folder).expect("removable");
    }
}
