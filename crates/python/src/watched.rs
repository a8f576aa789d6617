//! Long work that Python can follow and stop.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use capwalk::{Watch, with_threads};
use pyo3::prelude::*;

use crate::errors;

/// How often signals are looked for: Ctrl-C is answered in a fifth of a second.
const SIGNALS: Duration = Duration::from_millis(50);
/// How often progress is told.
const PROGRESS: Duration = Duration::from_millis(100);

/// How work is done beside what it is.
pub struct How<'py> {
    /// Worker threads; all cores without.
    pub threads: Option<usize>,
    /// Called with what is done and what there is to do.
    pub progress: Option<Bound<'py, PyAny>>,
}

/// What the workers and the thread of Python share.
#[derive(Default)]
struct Shared {
    stop: AtomicBool,
    done: AtomicU64,
    total: AtomicU64,
}

impl Watch for Shared {
    fn progress(&self, done: u64, total: u64) {
        // Another total is another stage of the work.
        match self.total.swap(total, Ordering::Relaxed) == total {
            true => self.done.fetch_max(done, Ordering::Relaxed),
            false => self.done.swap(done, Ordering::Relaxed),
        };
    }

    fn should_stop(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

/// Does work on a thread of its own while this one waits without the interpreter's lock,
/// looks for signals and tells the progress. An exception of either stops the work and is
/// raised. Workers must not look for signals: only Python's own threads may.
pub fn watched<T: Send>(
    py: Python<'_>,
    how: &How<'_>,
    work: impl FnOnce(&dyn Watch) -> T + Send,
) -> PyResult<T> {
    let shared = Shared::default();
    let threads = how.threads;
    thread::scope(|scope| {
        let (sender, receiver) = mpsc::channel();
        let watch = &shared;
        let worker = thread::Builder::new().name("capwalk".into());
        let spawned = worker.spawn_scoped(scope, move || {
            let work = || match threads {
                Some(threads) => with_threads(threads, || work(watch)),
                None => work(watch),
            };
            // The other side waits until it is sent.
            let _ = sender.send(catch_unwind(AssertUnwindSafe(work)));
        });
        spawned.map_err(|error| errors::internal(py, &format!("no thread to work on: {error}")))?;
        let mut receiver = Some(receiver);
        let mut raised = None;
        let mut told = Instant::now();
        loop {
            // Only this closure has it: it may be sent, not shared.
            let waiting = receiver.take().expect("it comes back");
            let (answer, back) = py.detach(move || (waiting.recv_timeout(SIGNALS), waiting));
            receiver = Some(back);
            if let Ok(result) = answer {
                return match (raised, result) {
                    (Some(error), _) => Err(error),
                    (None, Ok(value)) => {
                        tell(how, &shared)?;
                        Ok(value)
                    }
                    (None, Err(panic)) => Err(errors::internal(py, &text(panic.as_ref()))),
                };
            }
            let mut checked = py.check_signals();
            if checked.is_ok() && raised.is_none() && told.elapsed() >= PROGRESS {
                told = Instant::now();
                checked = tell(how, &shared);
            }
            if let Err(error) = checked {
                shared.stop.store(true, Ordering::Relaxed);
                raised.get_or_insert(error);
            }
        }
    })
}

/// Does work that nobody can stop, such as reading a scene, on a thread of its own, while this one
/// looks for signals. An exception of theirs is raised at once; the work goes on to its end, and what
/// it gives is dropped.
pub fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (sender, receiver) = mpsc::channel();
    let worker = thread::Builder::new().name("capwalk".into());
    let spawned = worker.spawn(move || {
        // Nobody may wait any more.
        let _ = sender.send(catch_unwind(AssertUnwindSafe(work)));
    });
    spawned.map_err(|error| errors::internal(py, &format!("no thread to work on: {error}")))?;
    let mut receiver = receiver;
    loop {
        let (answer, back) = py.detach(move || (receiver.recv_timeout(SIGNALS), receiver));
        receiver = back;
        if let Ok(result) = answer {
            return result.map_err(|panic| errors::internal(py, &text(panic.as_ref())));
        }
        py.check_signals()?;
    }
}

/// Something short, without the interpreter's lock, as all that waits for workers: these may
/// be waiting for it, to tell a progress.
pub fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let done = py.detach(|| catch_unwind(AssertUnwindSafe(work)));
    done.map_err(|panic| errors::internal(py, &text(panic.as_ref())))
}

fn tell(how: &How<'_>, shared: &Shared) -> PyResult<()> {
    if let Some(progress) = &how.progress {
        let [done, total] = [&shared.done, &shared.total].map(|n| n.load(Ordering::Relaxed));
        // Nothing is known before the first stage.
        if total > 0 {
            progress.call1((done, total))?;
        }
    }
    Ok(())
}

/// What a panic says.
fn text(panic: &(dyn Any + Send)) -> String {
    let words = panic.downcast_ref::<&str>().map(ToString::to_string);
    let words = words.or_else(|| panic.downcast_ref::<String>().cloned());
    words.unwrap_or_else(|| "a panic without words".into())
}
