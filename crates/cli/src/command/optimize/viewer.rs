//! `--view`: a run in the viewer of Rerun, which the Python package shows while the run goes on.

use std::ffi::OsString;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use anyhow::{Context, Result, bail, ensure};

/// The variable that names the interpreter of Python, unless it is `python3`.
const INTERPRETER: &str = "CAPWALK_PYTHON";

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
        follower.arg(folder).arg("--follow");
        // Ctrl-C is for the run alone.
        follower.stdin(Stdio::null()).stdout(Stdio::null());
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut follower, 0);
        let process = follower.spawn().with_context(missing)?;
        Ok(Self { process })
    }

    /// Waits until all of the run is shown, after the folder's lock is gone.
    ///
    /// # Errors
    ///
    /// It was not shown, for a reason that the process has printed.
    pub fn finish(mut self) -> Result<()> {
        let status = self.process.wait()?;
        ensure!(status.success(), "the run was not shown: {status}");
        Ok(())
    }
}

fn follower() -> Command {
    let mut command = Command::new(interpreter());
    command.args(["-m", "capwalk.rerun"]);
    command
}

fn interpreter() -> OsString {
    std::env::var_os(INTERPRETER).unwrap_or_else(|| "python3".into())
}

fn missing() -> String {
    format!(
        "--view needs the Python package capwalk with its extra `rerun` (pip install \
         'capwalk[rerun]') in {:?}; {INTERPRETER} names another interpreter",
        interpreter()
    )
}
