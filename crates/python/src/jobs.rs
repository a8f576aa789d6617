//! Jobs of inverse rendering.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::Instant;

use capwalk::optimize::{Job, Run, Stop};
use capwalk::{Error, Watch};
use pyo3::prelude::*;

use crate::errors;
use crate::watched::{How, watched};

/// Why a run stopped, why its results are unreliable, its folder, and warnings about the scene files.
type Ended = (String, Vec<String>, PathBuf, Vec<String>);

/// Stops when it is time or another watch says so, and tells nothing: progress is by iterations.
struct Until<'w> {
    watch: &'w dyn Watch,
    deadline: Option<Instant>,
}

impl Until<'_> {
    fn is_late(&self) -> bool {
        self.deadline.is_some_and(|at| Instant::now() >= at)
    }
}

impl Watch for Until<'_> {
    fn progress(&self, _done: u64, _total: u64) {}

    fn should_stop(&self) -> bool {
        self.is_late() || self.watch.should_stop()
    }
}

/// Runs the job in a file, as `capwalk optimize` does.
#[pyfunction]
pub fn optimize(
    py: Python<'_>,
    job: PathBuf,
    output: Option<PathBuf>,
    resume: bool,
    threads: Option<usize>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Ended> {
    let ended = watched(py, &How { threads, progress }, |watch| {
        ended(&Job::read(job)?, output, resume, watch)
    })?;
    ended.map_err(|error| errors::exception(py, error))
}

fn ended(
    job: &Job,
    output: Option<PathBuf>,
    resume: bool,
    watch: &dyn Watch,
) -> Result<Ended, Error> {
    let until = Until {
        watch,
        deadline: job
            .time_limit()
            .and_then(|limit| Instant::now().checked_add(limit)),
    };
    let folder = output.unwrap_or_else(|| job.output().to_owned());
    let mut run = Run::begin(job, &folder, resume, &until)?;
    let total = u64::from(run.problem().limits.iterations);
    watch.progress(u64::from(run.state().iteration).min(total), total);
    let stop = run.go(&until, |iteration| {
        watch.progress((u64::from(iteration.row.iteration) + 1).min(total), total);
        ControlFlow::Continue(())
    });
    let stop = stop.map_err(|error| match error {
        Error::Refused(refusal) => run.located(&refusal).into(),
        error => error,
    })?;
    run.finish(&stop)?;
    let why = match &stop {
        Stop::Interrupted if until.is_late() => "the time limit is over".into(),
        stop => stop.to_string(),
    };
    let is_bad = matches!(
        stop,
        Stop::Guard(_) | Stop::Outside(_) | Stop::NotFinite { .. }
    );
    let unreliable = is_bad.then(|| why.clone()).into_iter();
    let unreliable = unreliable.chain(run.missing().map(str::to_owned));
    let warnings = run.warnings().iter().map(ToString::to_string);
    let unreliable = unreliable.collect();
    Ok((why, unreliable, folder, warnings.collect()))
}
