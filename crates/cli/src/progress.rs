//! A bar with the remaining time, the time limit, and Ctrl-C.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use anyhow::Context;
use capwalk::Watch;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::console;

/// Work shorter than this shows no bar.
const QUIET_FOR: Duration = Duration::from_secs(1);

/// Exit status of a process that Ctrl-C killed, as shells have it.
const KILLED: i32 = 130;

/// True once Ctrl-C was pressed.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Makes the first Ctrl-C stop the work cleanly, and the second end the
/// process at once.
pub fn catch_interrupts() -> anyhow::Result<()> {
    ctrlc::set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::SeqCst) {
            std::process::exit(KILLED);
        }
        console::remark("\nstopping; what is done will be written (Ctrl-C again ends at once)\n");
    })
    .context("cannot listen to Ctrl-C")
}

/// True once Ctrl-C was pressed.
pub fn interrupted() -> bool {
    INTERRUPTED.load(Ordering::SeqCst)
}

/// Shows one piece of work, and stops it when it is time.
pub struct Progress {
    bar: ProgressBar,
    started: Instant,
    deadline: Option<Instant>,
    /// Set when the bar is first drawn.
    shown: OnceLock<()>,
}

impl Progress {
    /// Progress of `what`, to be stopped after `limit`.
    pub fn new(what: &'static str, limit: Option<Duration>) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let style = ProgressStyle::with_template(
            "{msg:9} {wide_bar:.cyan/dim} {percent:>3} %  {elapsed} elapsed, {eta} left",
        )
        .expect("the template is constant and valid");
        bar.set_style(style);
        bar.set_message(what);
        let started = Instant::now();
        Self {
            bar,
            started,
            deadline: limit.and_then(|limit| started.checked_add(limit)),
            shown: OnceLock::new(),
        }
    }

    /// Clears the bar; how long it took.
    pub fn finish(self) -> Duration {
        self.bar.finish_and_clear();
        self.started.elapsed()
    }
}

impl Watch for Progress {
    fn progress(&self, done: u64, total: u64) {
        self.bar.set_length(total);
        // Workers finish in any order: the bar never goes back.
        if done > self.bar.position() {
            self.bar.set_position(done);
        }
        if self.started.elapsed() > QUIET_FOR {
            self.shown.get_or_init(|| {
                // Draws nothing if the standard error is not a terminal.
                self.bar.set_draw_target(ProgressDrawTarget::stderr());
            });
        }
    }

    fn should_stop(&self) -> bool {
        interrupted() || self.deadline.is_some_and(|at| Instant::now() >= at)
    }
}
