//! A bar with the remaining time, and Ctrl-C.

use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::Context;
use capwalk_diff::Watch;
use indicatif::{ProgressBar, ProgressStyle};

/// Exit status of a process that Ctrl-C killed, as shells have it.
const KILLED: i32 = 130;

/// True once Ctrl-C was pressed.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Makes the first Ctrl-C stop the work cleanly, and the second end the process at
/// once.
pub fn catch_interrupts() -> anyhow::Result<()> {
    ctrlc::set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::SeqCst) {
            std::process::exit(KILLED);
        }
        eprintln!("\nstopping; what is done will be written (Ctrl-C again ends at once)");
    })
    .context("cannot listen to Ctrl-C")
}

/// Shows one stage of a figure on the standard error, if that is a terminal, until it
/// is dropped.
pub struct Stage(ProgressBar);

impl Stage {
    /// The stage with this name.
    pub fn new(name: &'static str) -> Self {
        let style = ProgressStyle::with_template(
            "{msg:9} {wide_bar:.cyan/dim} {percent:>3} %  {elapsed} elapsed, {eta} left",
        );
        let style = style.expect("the template is constant and valid");
        Self(ProgressBar::new(0).with_style(style).with_message(name))
    }
}

impl Drop for Stage {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

impl Watch for Stage {
    fn progress(&self, done: u64, total: u64) {
        self.0.set_length(total);
        // Workers finish in any order: the bar never goes back.
        if done > self.0.position() {
            self.0.set_position(done);
        }
    }

    fn should_stop(&self) -> bool {
        INTERRUPTED.load(Ordering::SeqCst)
    }
}
