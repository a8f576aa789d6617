//! A run that is killed at any moment of writing, or paused anywhere, ends in the same
//! bits. Kills are simulated: from a chosen step of writing on nothing more is written,
//! and what was half done stays as it is.

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use capwalk::optimize::{FolderError, Job, Run, Stop};
use capwalk::{Error, Unwatched};
use capwalk_scene_io::faults;

/// Milliseconds of work; images in the first, the third and the last iteration.
const JOB: &str = r#"
scene = "leaf"
size = [8, 6]
iterations = 3
spp = 4
seed = 5
images = 2
target = { spp = 16, set = { "leaf.translate.x" = 0.2 } }
parameter = [
    { name = "leaf.translate.x", bounds = [-1, 1] },
    { name = "floor.bsdf.reflectance.value", reparam = "sigmoid" },
]
optimizer = { lr = 0.02 }
"#;

/// An empty folder named after the test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("it is ours");
    }
    folder
}

fn job() -> Job {
    Job::parse("job", JOB).expect("a job")
}

/// Begins or goes on until the end or a kill after so many steps of writing; how many
/// were left.
fn attempt(folder: &Path, steps: u32) -> (Result<Stop, Error>, u32) {
    faults::kill_after(steps);
    let job = job();
    let result = Run::begin(&job, folder, true, &Unwatched).and_then(|mut run| {
        let stop = run.go(&Unwatched, |_| ControlFlow::Continue(()))?;
        run.finish(&stop)?;
        Ok(stop)
    });
    (result, faults::revive())
}

/// All files below a folder that two equal runs share, with their bytes.
fn files(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if !path.ends_with("timing.csv") {
                let name = path.strip_prefix(folder).expect("it is below").to_owned();
                found.push((name, fs::read(path).expect("readable")));
            }
        }
    }
    found.sort();
    found
}

#[track_caller]
fn assert_same_files(a: &Path, b: &Path, case: u32) {
    let (a, b) = (files(a), files(b));
    let names = |files: &[(PathBuf, Vec<u8>)]| -> Vec<PathBuf> {
        files.iter().map(|(name, _)| name.clone()).collect()
    };
    assert_eq!(names(&a), names(&b), "{case}");
    for ((name, a), (_, b)) in a.iter().zip(&b) {
        assert!(a == b, "{case}: {} differs", name.display());
    }
}

/// One kill before every step of writing: before, in the middle of and after every file
/// and every row.
#[test]
fn a_run_killed_at_any_write_ends_in_the_same_bits() {
    let (whole, killed) = (folder("kills_whole"), folder("kills_killed"));
    let (result, left) = attempt(&whole, u32::MAX);
    assert_eq!(result.expect("nobody killed it"), Stop::Done);
    let steps = u32::MAX - left;
    // 4 rows, 4 checkpoints, 3 images, 3 meshes, a scene and the parameters.
    assert!(steps > 50, "{steps}");
    for step in 0..steps {
        if killed.exists() {
            fs::remove_dir_all(&killed).expect("it is ours");
        }
        assert!(attempt(&killed, step).0.is_err(), "{step} of {steps}");
        let (result, _) = attempt(&killed, u32::MAX);
        assert_eq!(result.expect("nobody killed it"), Stop::Done, "{step}");
        assert_same_files(&whole, &killed, step);
    }
    // Once more, when all is done.
    attempt(&killed, u32::MAX).0.expect("nobody killed it");
    assert_same_files(&whole, &killed, steps);
}

/// The same run killed again and again, each time a little later.
#[test]
fn a_run_killed_again_and_again_ends_in_the_same_bits() {
    let (whole, killed) = (folder("again_whole"), folder("again_killed"));
    attempt(&whole, u32::MAX).0.expect("nobody killed it");
    let mut kills = 0;
    while attempt(&killed, 3 + kills).0.is_err() {
        kills += 1;
        assert!(kills < 1000, "it never ends");
    }
    assert!(kills > 10, "{kills}");
    assert_same_files(&whole, &killed, kills);
}

/// Pauses after every iteration; and nobody else writes there meanwhile.
#[test]
fn a_run_in_pieces_ends_in_the_same_bits() {
    let (whole, pieces) = (folder("pieces_whole"), folder("pieces_pieces"));
    attempt(&whole, u32::MAX).0.expect("nobody killed it");
    let job = job();
    for piece in 0..4 {
        let mut run = Run::begin(&job, &pieces, true, &Unwatched).expect("it can go on");
        assert_eq!(run.state().iteration, piece);
        let second = Run::begin(&job, &pieces, true, &Unwatched);
        let is_busy = matches!(second, Err(Error::Folder(FolderError::Busy { .. })));
        assert!(is_busy, "{second:?}");
        let stop = run.go(&Unwatched, |_| ControlFlow::Break(()));
        let stop = stop.expect("it can be written");
        match piece {
            3 => assert_eq!(stop, Stop::Done),
            _ => assert_eq!(stop, Stop::Interrupted),
        }
        run.finish(&stop).expect("it can be written");
    }
    assert_same_files(&whole, &pieces, 0);
}
