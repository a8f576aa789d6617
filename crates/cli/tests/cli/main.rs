//! The built command from outside: what it prints, writes, and returns.

mod backward;
mod bad_input;
mod compare;
mod demo;
#[cfg(feature = "gpu")]
mod device;
mod help;
mod hostile;
mod images;
mod long_input;
#[cfg(target_os = "linux")]
mod memory;
mod methods;
mod one_sided;
mod optimize;
mod overwriting;
mod scenes;
mod settings;
mod stopping;
mod streams;
mod verdicts;
#[cfg(not(feature = "gpu"))]
mod without_gpu;

#[cfg(unix)]
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
#[cfg(unix)]
use std::process::Stdio;
use std::process::{Command, Output};

use serde_json::Value;

/// The command, to be run in a folder of its own.
struct Capwalk {
    folder: PathBuf,
}

/// What a finished command left.
struct Finished {
    status: i32,
    stdout: String,
    stderr: String,
}

impl Capwalk {
    /// In an empty folder named after the test.
    fn new(test: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
        if folder.exists() {
            std::fs::remove_dir_all(&folder).expect("it is ours");
        }
        std::fs::create_dir_all(&folder).expect("the build folder is writable");
        Self { folder }
    }

    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_capwalk"));
        command
            .args(arguments.split_whitespace())
            .current_dir(&self.folder);
        command
    }

    /// Runs with arguments that are separated by spaces.
    fn run(&self, arguments: &str) -> Finished {
        let output = self.command(arguments).output().expect("it starts");
        Finished::from(output)
    }

    /// Runs until a line with this text is on the standard error, then does something, then
    /// sends a signal: `-INT` is Ctrl-C.
    #[cfg(unix)]
    fn interrupt(
        &self,
        signal: &str,
        arguments: &str,
        line: &str,
        meanwhile: impl FnOnce(),
    ) -> Finished {
        let mut command = self.command(arguments);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("it starts");
        let mut errors = BufReader::new(child.stderr.take().expect("it is piped"));
        let mut said = String::new();
        while !said.lines().any(|said| said.contains(line)) {
            let count = errors.read_line(&mut said).expect("text");
            assert!(count > 0, "no \"{line}\" in:\n{said}");
        }
        meanwhile();
        let interrupt = Command::new("kill")
            .args([signal, &child.id().to_string()])
            .status();
        assert!(interrupt.expect("kill exists").success());
        errors.read_to_string(&mut said).expect("text");
        let mut finished = Finished::from(child.wait_with_output().expect("it ends"));
        finished.stderr = said;
        finished
    }

    /// The JSON that a successful run prints.
    fn json(&self, arguments: &str) -> Value {
        let finished = self.run(arguments);
        assert_eq!(finished.status, 0, "{}", finished.stderr);
        serde_json::from_str(&finished.stdout).expect("one JSON object")
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).expect("the folder is writable");
    }

    /// The error that bad input gives: status 3, nothing on standard output.
    fn error(&self, arguments: &str) -> String {
        let finished = self.run(arguments);
        assert_eq!(finished.status, 3, "{arguments}: {}", finished.stderr);
        assert_eq!(finished.stdout, "", "{arguments}");
        assert!(
            finished.stderr.starts_with("error: "),
            "{}",
            finished.stderr
        );
        finished.stderr
    }
}

impl From<Output> for Finished {
    fn from(output: Output) -> Self {
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
        Self {
            status: output.status.code().unwrap_or(-1),
            stdout: text(output.stdout),
            stderr: text(output.stderr),
        }
    }
}

/// Asserts that a text has all these parts.
#[track_caller]
fn assert_has(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "no \"{part}\" in:\n{text}");
    }
}
