//! Files that appear whole or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Writes a file under a temporary name beside its place and moves it there
/// when it is complete. If anything fails, the place is left as it was.
pub(crate) fn write_atomically(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> io::Result<()> {
    write(path, fill, File::sync_all)
}

/// [`write_atomically`] for one of many files, without waiting for the disk at each: if the machine
/// fails soon after, its contents may be lost.
pub(crate) fn write_one_of_many(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> io::Result<()> {
    write(path, fill, |_| Ok(()))
}

fn write(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
    sync: impl FnOnce(&File) -> io::Result<()>,
) -> io::Result<()> {
    let temporary = temporary_name(path)?;
    let written = (|| {
        faults::step()?;
        let mut writer = BufWriter::new(File::create(&temporary)?);
        faults::step()?;
        fill(&mut writer)?;
        writer.flush()?;
        sync(&writer.into_inner()?)?;
        faults::step()?;
        fs::rename(&temporary, path)
    })();
    // A killed process does not clean up.
    if written.is_err() && !faults::is_killed() {
        // The error that is reported is the first one.
        let _ = fs::remove_file(&temporary);
    }
    written
}

/// Adds bytes to the end of a file. They are on the disk when this returns.
pub fn append(file: &mut File, bytes: &[u8]) -> io::Result<()> {
    faults::step()?;
    let (first, rest) = bytes.split_at(bytes.len() / 2);
    file.write_all(first)?;
    faults::step()?;
    file.write_all(rest)?;
    file.sync_data()
}

/// Checks that [`write_atomically`] could write there, by making its temporary
/// file and removing it again.
pub(crate) fn check_writable(path: &Path) -> io::Result<()> {
    if path.is_dir() {
        return Err(io::Error::from(io::ErrorKind::IsADirectory));
    }
    let temporary = temporary_name(path)?;
    File::create(&temporary)?;
    fs::remove_file(&temporary)
}

/// The end of temporary names. Nobody else gives files such an end.
const TEMPORARY: &str = ".capwalk-tmp";

/// `.name.<process>.capwalk-tmp` in the same directory, so that the move cannot cross
/// file systems and two processes do not meet.
fn temporary_name(path: &Path) -> io::Result<PathBuf> {
    let name = path.file_name().ok_or_else(|| {
        io::Error::new(io::ErrorKind::InvalidInput, "the path does not name a file")
    })?;
    let name = name.to_string_lossy();
    let name = format!(".{name}.{}{TEMPORARY}", std::process::id());
    Ok(path.with_file_name(name))
}

/// True for the names of files that are being written, or that a killed process was writing.
pub fn is_temporary(name: &str) -> bool {
    let process = name
        .strip_prefix('.')
        .and_then(|rest| rest.strip_suffix(TEMPORARY))
        .and_then(|rest| rest.rsplit_once('.'));
    process.is_some_and(|(_, process)| process.parse::<u32>().is_ok())
}

/// Writing goes on.
#[cfg(not(feature = "faults"))]
mod faults {
    pub fn step() -> std::io::Result<()> {
        Ok(())
    }

    pub fn is_killed() -> bool {
        false
    }
}

/// Kills of the process at a chosen moment of writing, for tests: from then on all
/// writing of this thread fails, and what is half done stays.
#[cfg(feature = "faults")]
pub mod faults {
    use std::cell::Cell;
    use std::io;

    thread_local! {
        /// Steps until the kill.
        static LEFT: Cell<u32> = const { Cell::new(u32::MAX) };
    }

    /// Kills the process, as it were, before its next step but `steps`.
    pub fn kill_after(steps: u32) {
        LEFT.set(steps);
    }

    /// True if it was killed.
    pub fn is_killed() -> bool {
        LEFT.get() == 0
    }

    /// What a new process has: nothing to fear. Returns how many steps were left.
    pub fn revive() -> u32 {
        LEFT.replace(u32::MAX)
    }

    /// A moment between two things that are written.
    pub(super) fn step() -> io::Result<()> {
        match LEFT.get() {
            0 => Err(io::Error::other("killed by a test")),
            left => {
                LEFT.set(left - 1);
                Ok(())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn failing_writers_leave_nothing_and_spoil_nothing() {
        let directory = std::env::temp_dir().join(format!("capwalk-atomic-{}", std::process::id()));
        fs::create_dir_all(&directory).expect("a temporary directory");
        let path = directory.join("file.txt");
        write_atomically(&path, |w| w.write_all(b"first")).expect("writable");
        let interrupted = write_atomically(&path, |w| {
            w.write_all(b"second")?;
            Err(io::Error::other("interrupted"))
        });
        assert_eq!(interrupted.expect_err("failed").to_string(), "interrupted");
        assert_eq!(fs::read(&path).expect("readable"), b"first");
        assert_eq!(fs::read_dir(&directory).expect("readable").count(), 1);
        write_atomically(&path, |w| w.write_all(b"third")).expect("writable");
        assert_eq!(fs::read(&path).expect("readable"), b"third");
        fs::remove_dir_all(&directory).expect("removable");
    }
    #[test]
    fn temporary_names_are_unmistakable() {
        let name = temporary_name(Path::new("folder/a.b.npz")).expect("it names a file");
        let name = name.file_name().expect("it does").to_string_lossy();
        assert!(is_temporary(&name), "{name}");
        for other in [
            ".notes.tmp",
            ".notes.12.tmp",
            ".notes.mine.capwalk-tmp",
            "a.12.capwalk-tmp",
        ] {
            assert!(!is_temporary(other), "{other}");
        }
    }
}
