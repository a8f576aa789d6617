//! A bar with the remaining time, the time limit, Ctrl-C and SIGTERM.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

use anyhow::Context;
use capwalk::Watch;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
#[cfg(unix)]
use signal_hook::{consts::SIGTERM, iterator::Signals};

use crate::{console, diagnostics};

/// Work shorter than this shows no bar.
const QUIET_FOR: Duration = Duration::from_secs(1);

/// Exit status of a process that Ctrl-C killed, as shells have it.
const KILLED: i32 = 130;

/// True once Ctrl-C was pressed or SIGTERM came.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// True if there is something to write, since a sample was taken: until then, what stops a command
/// ends the process, whatever it is at. Locked while that is decided.
static HAS_RESULTS: Mutex<bool> = Mutex::new(false);

/// When the command started: time limits count from here.
static STARTED: OnceLock<Instant> = OnceLock::new();

/// Makes the first Ctrl-C or SIGTERM stop the work cleanly, and the second end the process at
/// once; and a time limit that ends before the first sample end the process there. To be called
/// once, when a command starts.
pub fn watch_for_stops(limit: Option<Duration>) -> anyhow::Result<()> {
    STARTED.get_or_init(Instant::now);
    ctrlc::set_handler(interrupt).context("cannot listen to Ctrl-C")?;
    #[cfg(unix)]
    {
        let signals = Signals::new([SIGTERM]).context("cannot listen to SIGTERM")?;
        spawn("signals", move || {
            let mut signals = signals;
            signals.forever().for_each(|_| interrupt());
        })?;
    }
    limit.map_or(Ok(()), end_after)
}

/// Ends the process so long after the command started, if there is nothing to write then.
pub fn end_after(limit: Duration) -> anyhow::Result<()> {
    let started = *STARTED.get_or_init(Instant::now);
    spawn("time limit", move || {
        std::thread::sleep(limit.saturating_sub(started.elapsed()));
        let words = format!("error: {}\n", out_of_time(SAMPLE));
        end_without_results(&words, diagnostics::BAD_INPUT);
    })
}

/// What has not happened yet while a command prepares its work.
const SAMPLE: &str = "a sample was taken";

/// What is said if the time limit ended before something.
pub fn out_of_time(before: &str) -> String {
    format!("the time limit ended before {before}; nothing was written. Give more time")
}

/// What is said if the work was stopped before something.
pub fn stopped(before: &str) -> String {
    format!("stopped before {before}; nothing was written")
}

fn spawn(name: &str, work: impl FnOnce() + Send + 'static) -> anyhow::Result<()> {
    let thread = std::thread::Builder::new().name(name.into());
    thread.spawn(work).context("no thread to wait on")?;
    Ok(())
}

/// Says that there is something to write: from now on, whoever works stops by itself.
pub fn has_results() {
    *HAS_RESULTS.lock().unwrap_or_else(PoisonError::into_inner) = true;
}

/// Ends the process with these words and this status if there is nothing to write.
fn end_without_results(words: &str, status: u8) {
    // Results that come now wait here for ever.
    let has_results = HAS_RESULTS.lock().unwrap_or_else(PoisonError::into_inner);
    if !*has_results {
        console::remark(words);
        std::process::exit(status.into());
    }
}

/// What Ctrl-C and SIGTERM do.
fn interrupt() {
    if INTERRUPTED.swap(true, Ordering::SeqCst) {
        std::process::exit(KILLED);
    }
    end_without_results(
        &format!("\n{}\n", stopped(SAMPLE)),
        diagnostics::INTERRUPTED,
    );
    console::remark("\nstopping; what is done will be written (Ctrl-C again ends at once)\n");
}

/// True once Ctrl-C was pressed or SIGTERM came.
pub fn interrupted() -> bool {
    INTERRUPTED.load(Ordering::SeqCst)
}

/// What is left of a time limit, which counts from the start of the command.
pub fn left_of(limit: Option<Duration>) -> Option<Duration> {
    let started = STARTED.get_or_init(Instant::now);
    limit.map(|limit| limit.saturating_sub(started.elapsed()))
}

/// Shows one piece of work, and stops it when it is time.
pub struct Progress {
    bar: ProgressBar,
    started: Instant,
    deadline: Option<Instant>,
    /// Set when the bar is first drawn.
    shown: OnceLock<()>,
    /// Set when the first sample was taken.
    has_samples: OnceLock<()>,
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
            has_samples: OnceLock::new(),
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
        if done > 0 {
            self.has_samples.get_or_init(has_results);
        }
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
