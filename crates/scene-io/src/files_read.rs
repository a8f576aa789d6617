//! Files that were read, so that none of them is overwritten.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Component, Path, PathBuf};

/// Which files were read for some work: scenes with all that they name, targets, velocities.
/// What was read is never written.
///
/// ```
/// use capwalk_scene_io::FilesRead;
///
/// let file = std::env::temp_dir().join(format!("read-{}.png", std::process::id()));
/// std::fs::write(&file, "texels")?;
/// let mut files = FilesRead::default();
/// files.add(&file);
/// assert!(files.refuse(&file).is_err());
/// assert!(files.refuse(&file.with_extension("exr")).is_ok());
/// # std::fs::remove_file(&file)?;
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FilesRead {
    /// Without links in them.
    paths: BTreeSet<PathBuf>,
}

/// What is to be written would take the place of a file that was read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{} would overwrite {}, which is read; what is read is never written: choose another name",
    output.display(), input.display()
)]
pub struct InputInTheWay {
    /// The file that was read.
    pub input: PathBuf,
    /// What was to be written.
    pub output: PathBuf,
}

impl FilesRead {
    /// Remembers a file that is read.
    pub fn add(&mut self, path: &Path) {
        // What is not there was not read.
        self.paths.extend(path.canonicalize());
    }

    /// Remembers the files of another record, too.
    pub fn extend(&mut self, others: &Self) {
        self.paths.extend(others.paths.iter().cloned());
    }

    /// The files, without links in their paths.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.paths.iter().map(PathBuf::as_path)
    }

    /// An error if a file was read that this output is by any of its names, or that is in the
    /// folder which this output is.
    pub fn refuse(&self, output: &Path) -> Result<(), InputInTheWay> {
        let place = place_of(output);
        let is_lost = |input: &&PathBuf| input.starts_with(&place) || is_same_file(input, &place);
        match self.paths.iter().find(is_lost) {
            None => Ok(()),
            Some(input) => Err(InputInTheWay {
                input: input.clone(),
                output: output.to_owned(),
            }),
        }
    }
}

impl<P: AsRef<Path>> FromIterator<P> for FilesRead {
    fn from_iter<I: IntoIterator<Item = P>>(paths: I) -> Self {
        let mut files = Self::default();
        paths.into_iter().for_each(|path| files.add(path.as_ref()));
        files
    }
}

/// Where a file will be, without links and steps upwards, once the folders in its path that are not
/// there are made.
fn place_of(output: &Path) -> PathBuf {
    let mut place = std::env::current_dir().unwrap_or_default();
    for part in output.components() {
        match part {
            Component::ParentDir => {
                place.pop();
            }
            part => place.push(part),
        }
        // What is not there is no link.
        place = place.canonicalize().unwrap_or(place);
    }
    place
}

/// True if both are names of one file, as hard links are.
#[cfg(unix)]
fn is_same_file(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;

    let identity = |path: &Path| fs::metadata(path).map(|of| (of.dev(), of.ino()));
    matches!((identity(a), identity(b)), (Ok(a), Ok(b)) if a == b)
}

/// Paths tell, where hard links are rare.
#[cfg(not(unix))]
fn is_same_file(a: &Path, b: &Path) -> bool {
    a == b
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::fs::symlink;

    /// A file by all of its names, and the folders that it is in.
    #[test]
    fn what_was_read_is_never_written() {
        let folder = std::env::temp_dir().join(format!("capwalk-read-{}", std::process::id()));
        fs::create_dir_all(folder.join("inside")).expect("a temporary directory");
        let path = |name: &str| folder.join(name);
        for name in ["inside/read.png", "other.png"] {
            fs::write(path(name), "texels").expect("writable");
        }
        symlink(path("inside/read.png"), path("link.png")).expect("linkable");
        symlink(path("inside"), path("folder")).expect("linkable");
        fs::hard_link(path("inside/read.png"), path("hard.png")).expect("linkable");
        let read: FilesRead = [path("link.png"), path("missing.png")]
            .into_iter()
            .collect();
        assert_eq!(read.paths().count(), 1);
        for output in [
            "inside/read.png",
            "link.png",
            "folder/read.png",
            "inside/../folder/read.png",
            "hard.png",
            "not there/../other/../inside/read.png",
            "not there/..",
            "inside",
            "folder",
        ] {
            let error = read.refuse(&path(output)).expect_err(output);
            assert_eq!(error.output, path(output));
        }
        for output in [
            "other.png",
            "new.png",
            "inside/new.png",
            "missing.png",
            "inside/read.png/../no",
        ] {
            assert_eq!(read.refuse(&path(output)), Ok(()), "{output}");
        }
        fs::remove_dir_all(&folder).expect("removable");
    }
}
