//! `--view`: a run in the viewer of Rerun, which the Python package shows while the run goes on.

use std::ffi::OsString;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail, ensure};

use crate::progress;

/// The variable that names the interpreter of Python, unless it is [`PYTHON`].
const INTERPRETER: &str = "CAPWALK_PYTHON";
/// Virtual environments of Windows have no `python3`.
const PYTHON: &str = if cfg!(windows) { "python" } else { "python3" };
/// How long the command waits for the last pictures of a run that is over. The viewer's process goes on
/// without it.
const PATIENCE: Duration = Duration::from_secs(10);
/// How often it looks.
const OFTEN: Duration = Duration::from_millis(20);

/// The process that follows a run.
pub struct Viewer {
    process: Child,
}

impl Viewer {
    /// Tries whether Python has what it takes to show a run, before time is spent on the run.
    ///
    /// # Errors
    ///
    /// There is no interpreter, or it has no `capwalk` or no `rerun`.
    pub fn check() -> Result<()> {
        let tried = follower()
            .arg("--help")
            .stdin(Stdio::null())
            .output()
            .with_context(missing)?;
        if !tried.status.success() {
            let said = String::from_utf8_lossy(&tried.stderr);
            let reason = said.trim().lines().last().unwrap_or("it says nothing");
            bail!("{}: {reason}", missing());
        }
        Ok(())
    }

    /// Begins to show the run in a folder, which is locked until the run is over.
    ///
    /// # Errors
    ///
    /// No process can be started.
    pub fn open(folder: &Path) -> Result<Self> {
        let mut follower = follower();
        follower.arg(folder).args(["--follow", "--begun"]);
        // Ctrl-C is for the run alone.
        follower.stdin(Stdio::null()).stdout(Stdio::null());
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut follower, 0);
        #[cfg(windows)]
        std::os::windows::process::CommandExt::creation_flags(
            &mut follower,
            0x200, // CREATE_NEW_PROCESS_GROUP
        );
        let process = follower.spawn().with_context(missing)?;
        Ok(Self { process })
    }

    /// Waits for some seconds until all of the run is shown, after the folder's lock is gone.
    ///
    /// # Errors
    ///
    /// It was not shown, for a reason that the process has printed, or not all of it yet.
    pub fn finish(mut self) -> Result<()> {
        let began = Instant::now();
        while began.elapsed() < PATIENCE && !progress::interrupted() {
            if let Some(status) = self.process.try_wait()? {
                ensure!(status.success(), "the run was not shown: {status}");
                return Ok(());
            }
            std::thread::sleep(OFTEN);
        }
        bail!("the viewer is slow: the last pictures of the run follow by themselves")
    }
}

fn follower() -> Command {
    let mut command = Command::new(interpreter());
    command.args(["-m", "capwalk.rerun"]);
    command
}

fn interpreter() -> OsString {
    std::env::var_os(INTERPRETER).unwrap_or_else(|| PYTHON.into())
}

fn missing() -> String {
    format!(
        "--view needs the Python package capwalk with its extra `rerun` (pip install \
         'capwalk[rerun]', in a clone '.[rerun]') in {:?}; {INTERPRETER} names another interpreter",
        interpreter()
    )
}
