//! The folder of a run: what a killed run leaves is enough to go on, and a resumed
//! run ends in the same files, but for `timing.csv`.
//!
//! Every iteration first appends its row to `record.csv`, then replaces
//! `checkpoint.npz`. So the record has at least the rows of the checkpoint; the
//! others are cut off when the run is resumed, and written again.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use capwalk_inverse::{Iteration, Problem, State, record};
use capwalk_scene::Image;
use capwalk_scene_io::arrays::{self, Array, ArrayFile, Arrays};
use capwalk_scene_io::export;
use capwalk_scene_io::image::{Panel, Scale, Style, write_panels};
use capwalk_scene_io::{FilesRead, append, is_temporary, read_file, read_text_file};

use crate::folder_error::FolderError;

/// What a run needs to go on.
const CHECKPOINT: &str = "checkpoint.npz";
/// A row for every iteration.
const RECORD: &str = "record.csv";
/// How long each took: the one file that differs from run to run.
const TIMING: &str = "timing.csv";
const TIMING_HEADER: &str = "iteration,seconds\n";
/// The result: the numbers that were looked for, by their names.
const PARAMETERS: &str = "parameters.npz";
/// The scene with them.
const SCENE: &str = "scene.xml";
/// The folders that [`export::write_scene`] puts beside it.
const MESHES: &str = "scene_meshes";
const TEXTURES: &str = "scene_textures";
/// The folder of images.
const IMAGES: &str = "images";
/// Held by the process that writes there.
const LOCK: &str = ".lock";
/// The folders that files are written into, from the folder of the run.
const FOLDERS: [&str; 4] = ["", IMAGES, MESHES, TEXTURES];

/// The folder of a run that goes on in it.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    fingerprint: Vec<(String, String)>,
    record: File,
    timing: File,
    /// Held until the end, also that of a killed process.
    _lock: File,
}

/// The folder of a run that has not begun: nobody else writes there.
#[derive(Debug)]
pub struct Claimed {
    path: PathBuf,
    lock: File,
}

/// Makes sure that a run can go into this folder: it can be written to, no other
/// run is in it, and without `resume` there is none to go on with. Nothing is lost:
/// neither files that the run reads nor results of something else.
pub fn claim(path: &Path, resume: bool, read: &FilesRead) -> Result<Claimed, FolderError> {
    refuse_losses(path, read)?;
    let cannot = |error: io::Error| FolderError::Unwritable {
        folder: path.into(),
        error,
    };
    fs::create_dir_all(path.join(IMAGES)).map_err(cannot)?;
    if !resume && path.join(CHECKPOINT).exists() {
        return Err(FolderError::Taken {
            folder: path.into(),
        });
    }
    let mut options = OpenOptions::new();
    let options = options.create(true).write(true).truncate(false);
    let lock = options.open(path.join(LOCK)).map_err(cannot)?;
    // Who follows a run asks whether it is locked, and holds the lock for a moment.
    let locked = lock.try_lock().or_else(|_| {
        std::thread::sleep(Duration::from_millis(20));
        lock.try_lock()
    });
    match locked {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => {
            return Err(FolderError::Busy {
                folder: path.into(),
            });
        }
        Err(TryLockError::Error(error)) => return Err(cannot(error)),
    }
    for folder in FOLDERS {
        remove_leftovers(&path.join(folder), read).map_err(cannot)?;
    }
    Ok(Claimed {
        path: path.to_owned(),
        lock,
    })
}

/// An error if a run in this folder would overwrite what it did not write.
fn refuse_losses(path: &Path, read: &FilesRead) -> Result<(), FolderError> {
    let written = [
        CHECKPOINT, RECORD, TIMING, PARAMETERS, SCENE, MESHES, TEXTURES, IMAGES, LOCK,
    ];
    for name in written {
        read.refuse(&path.join(name))?;
    }
    // These are written where they are; the others are replaced, links and all.
    for name in [RECORD, TIMING, LOCK] {
        let file = path.join(name);
        if file.is_symlink() {
            return Err(FolderError::LinkInTheWay { file });
        }
    }
    if path.join(CHECKPOINT).exists() {
        return Ok(());
    }
    let is_result = |name: &str| match name {
        RECORD | TIMING => !is_begun_table(&path.join(name)),
        LOCK => fs::metadata(path.join(name)).is_ok_and(|lock| lock.len() > 0),
        IMAGES => has_files(&path.join(name)),
        CHECKPOINT | PARAMETERS | SCENE | MESHES | TEXTURES => {
            path.join(name).symlink_metadata().is_ok()
        }
        _ => unreachable!("these are all that is written"),
    };
    match written.into_iter().find(|name| is_result(name)) {
        None => Ok(()),
        Some(name) => Err(FolderError::ResultInTheWay {
            file: path.join(name),
        }),
    }
}

/// True for a table that is not there or that a run left which was killed before its first
/// checkpoint: some of the first line of a table.
fn is_begun_table(path: &Path) -> bool {
    let Ok(table) = read_file(path) else {
        // One of no bytes is nobody's, and cannot be read.
        return fs::metadata(path).map_or(true, |file| file.len() == 0);
    };
    let first = "iteration,".as_bytes();
    let line = table.strip_suffix(b"\n").unwrap_or(&table);
    (line.starts_with(first) || first.starts_with(line)) && !line.contains(&b'\n')
}

/// True if something is in a folder that a killed process did not leave.
fn has_files(folder: &Path) -> bool {
    let mut entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.any(|entry| !is_temporary(&entry.file_name().to_string_lossy()))
}

/// Removes what a killed process was just writing, but nothing that is read.
fn remove_leftovers(folder: &Path, read: &FilesRead) -> io::Result<()> {
    if !folder.is_dir() {
        return Ok(());
    }
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let is_leftover =
            is_temporary(&entry.file_name().to_string_lossy()) && entry.file_type()?.is_file();
        if is_leftover && read.refuse(&entry.path()).is_ok() {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}

impl Claimed {
    /// The folder with the state to go on from: that of the checkpoint if there is
    /// one, the first otherwise.
    pub fn begin(
        self,
        problem: &Problem,
        fingerprint: Vec<(String, String)>,
    ) -> Result<(Folder, State), FolderError> {
        let Self { path, lock } = self;
        let checkpoint = path.join(CHECKPOINT);
        let state = match checkpoint.exists() {
            true => Some(read_state(&checkpoint, problem, &fingerprint)?),
            false => None,
        };
        let header = record::header(problem);
        let kept = match &state {
            None => header.clone(),
            Some(state) => {
                let file = path.join(RECORD);
                let table = read_text_file(&file).map_err(|error| FolderError::Unreadable {
                    file: file.clone(),
                    error,
                })?;
                let kept = record::kept(&table, &header, state.iteration);
                let kept = kept.ok_or(FolderError::MissingRows {
                    file,
                    iterations: state.iteration,
                })?;
                kept.to_owned()
            }
        };
        let iterations = state.as_ref().map_or(0, |state| state.iteration);
        let timing = read_text_file(&path.join(TIMING)).unwrap_or_default();
        // What is lost of it is only of interest.
        let timing = record::kept(&timing, TIMING_HEADER, iterations).unwrap_or(TIMING_HEADER);
        let folder = Folder {
            record: cut(&path.join(RECORD), &kept)?,
            timing: cut(&path.join(TIMING), timing)?,
            path,
            fingerprint,
            _lock: lock,
        };
        let state = match state {
            Some(state) => state,
            None => {
                let state = State::new(problem);
                folder.keep(&state)?;
                state
            }
        };
        Ok((folder, state))
    }
}

/// The state in a checkpoint, if it is one of this problem.
fn read_state(
    file: &Path,
    problem: &Problem,
    fingerprint: &[(String, String)],
) -> Result<State, FolderError> {
    let damaged = FolderError::DamagedCheckpoint;
    let mut checkpoint = ArrayFile::open(file).map_err(damaged)?;
    let metadata = checkpoint.metadata().map_err(damaged)?;
    let was = |name: &str| {
        let found = metadata.iter().find(|(key, _)| key == name);
        found.map_or("nothing", |(_, what)| what)
    };
    let changed: Vec<String> = fingerprint
        .iter()
        .filter(|(name, what)| was(name) != what)
        .map(|(name, what)| format!("{name} was {}, is {what}", was(name)))
        .collect();
    if !changed.is_empty() {
        return Err(FolderError::OtherJob {
            folder: file.parent().unwrap_or(file).into(),
            changed,
        });
    }
    let no_checkpoint = |reason: String| FolderError::NoCheckpoint {
        file: file.into(),
        reason,
    };
    let unknowns = problem.variables.count();
    let mut arrays = Vec::new();
    for (name, count) in State::counts(unknowns) {
        // Before its numbers take time and memory.
        let found = checkpoint.count(name).map_err(damaged)?;
        if let Some(found) = found.filter(|&found| found != count as u64) {
            let reason = format!("\"{name}\" has {found} numbers; expected {count}");
            return Err(no_checkpoint(reason));
        }
        let numbers = checkpoint.numbers(name).map_err(damaged)?;
        arrays.extend(numbers.map(|numbers| (name, numbers)));
    }
    let find = |name: &str| {
        let found = arrays.iter().find(|(known, _)| *known == name);
        found.map(|(_, numbers)| &numbers[..])
    };
    State::from_numbers(unknowns, find).map_err(no_checkpoint)
}

/// A file with this text, to be appended to. What it has already is not touched.
fn cut(path: &Path, text: &str) -> Result<File, FolderError> {
    let cut = || {
        let old = read_text_file(path).unwrap_or_default();
        let mut file = OpenOptions::new().create(true).append(true).open(path)?;
        if old.starts_with(text) {
            file.set_len(text.len() as u64)?;
            file.sync_data()?;
        } else {
            file.set_len(0)?;
            append(&mut file, text.as_bytes())?;
        }
        Ok(file)
    };
    cut().map_err(|error| unwritten(path, error))
}

fn unwritten(file: &Path, error: io::Error) -> FolderError {
    FolderError::Unwritten {
        file: file.into(),
        error,
    }
}

impl Folder {
    /// Writes an iteration down, which took so many seconds: its row, then the state that
    /// it leads to.
    pub fn write(
        &mut self,
        problem: &Problem,
        iteration: &Iteration,
        seconds: f64,
    ) -> Result<(), FolderError> {
        let row = iteration.row.csv(problem);
        // It must be there before the checkpoint that relies on it.
        let written = append(&mut self.record, row.as_bytes());
        written.map_err(|error| unwritten(&self.path.join(RECORD), error))?;
        let timing = format!("{},{seconds:.6}\n", iteration.row.iteration);
        let written = append(&mut self.timing, timing.as_bytes());
        written.map_err(|error| unwritten(&self.path.join(TIMING), error))
    }

    /// Keeps a state, to be resumed from.
    pub fn keep(&self, state: &State) -> Result<(), FolderError> {
        let arrays = state.to_numbers().into_iter().map(|(name, numbers)| Array {
            name: name.into(),
            shape: vec![numbers.len()],
            numbers,
        });
        let checkpoint = Arrays {
            arrays: arrays.collect(),
            metadata: self.fingerprint.clone(),
        };
        Ok(arrays::write(&self.path.join(CHECKPOINT), &checkpoint)?)
    }

    /// Writes the images of an iteration beside their targets, one file for each view.
    pub fn draw(&self, problem: &Problem, name: &str, images: &[Image]) -> Result<(), FolderError> {
        for (i, (image, view)) in images.iter().zip(&problem.views).enumerate() {
            let file = match images.len() {
                1 => format!("{name}.png"),
                _ => format!("{name}-view{}.png", i + 1),
            };
            let pairs = image.pixels.iter().zip(&view.target.pixels);
            let difference = Image {
                pixels: pairs.map(|(&a, &b)| a - b).collect(),
                ..*image
            };
            let photographic = Style::Photographic { exposure: 0.0 };
            let panel = |title, image, style| Panel {
                title,
                image,
                style,
            };
            let panels = [
                panel("image", image, photographic),
                panel("target", &view.target, photographic),
                panel(
                    "difference",
                    &difference,
                    Style::Diverging(Scale::of([&difference])),
                ),
            ];
            write_panels(&self.path.join(IMAGES).join(file), &panels, &[])?;
        }
        Ok(())
    }

    /// Writes the result of a run that stopped for this reason: the parameters, and the
    /// scene with them. Returns the names of the files.
    pub fn finish(
        &self,
        problem: &Problem,
        state: &State,
        stopped: &str,
    ) -> Result<Vec<PathBuf>, FolderError> {
        let (values, scene) = (problem.values(state), problem.scene(state)?);
        let count = problem.variables.iter().count();
        let results = (0..count).map(|i| problem.variables.result(i, &scene, &values));
        let arrays = results.map(|result| Array {
            name: result.name,
            shape: result.shape,
            numbers: result.numbers,
        });
        let note = |key: &str, value: String| (key.to_owned(), value);
        let result = Arrays {
            arrays: arrays.collect(),
            metadata: vec![
                note("command", "optimize".into()),
                note("iterations", state.iteration.to_string()),
                note("stopped", stopped.into()),
                note("version", env!("CARGO_PKG_VERSION").into()),
            ],
        };
        let parameters = self.path.join(PARAMETERS);
        arrays::write(&parameters, &result)?;
        let scene = export::write_scene(&scene, &self.path.join(SCENE))?;
        Ok(vec![parameters, scene, self.path.join(RECORD)])
    }
}
