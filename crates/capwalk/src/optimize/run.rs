//! A run: iterates, and writes down what happens.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

use capwalk_diff::{Chosen, Refusal, Watch};
use capwalk_inverse::record::Row;
use capwalk_inverse::{Iteration, PreparedViews, Problem, State, Stop};
use capwalk_scene_io::{LoadError, Warning};

use super::fingerprint::fingerprint;
use super::folder::{self, Folder};
use super::job::Job;
use super::posed::LoadedProblem;
use crate::error::Error;

/// An optimisation that keeps every iteration in a folder: killed at any moment and begun
/// again with `resume`, it ends in the same bits.
///
/// ```
/// use std::ops::ControlFlow;
///
/// use capwalk::Unwatched;
/// use capwalk::optimize::{Job, Run, Stop};
///
/// let job = Job::parse("example", r#"
///     scene = "leaf"
///     size = [8, 6]
///     iterations = 2
///     spp = 4
///     target = { set = { "leaf.translate.x" = 0.2 }, spp = 16 }
///     parameter = [{ name = "leaf.translate.x" }]
///     optimizer = { lr = 0.1 }
/// "#)?;
/// # let folder = std::env::temp_dir().join(format!("capwalk-run-{}", std::process::id()));
/// # let folder = folder.as_path();
/// let mut run = Run::begin(&job, folder, false, &Unwatched)?;
/// let stop = run.go(&Unwatched, |iteration| {
///     println!("{}: {}", iteration.row.iteration, iteration.row.loss);
///     ControlFlow::Continue(())
/// })?;
/// assert_eq!(stop, Stop::Done);
/// for file in run.finish(&stop)? {
///     assert!(file.exists());
/// }
/// # std::fs::remove_dir_all(folder)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Run<'j> {
    job: &'j Job,
    problem: Problem,
    chosen: Option<Chosen>,
    warnings: Vec<Warning>,
    state: State,
    views: PreparedViews,
    folder: Folder,
    last: Option<Row>,
    missing: Option<String>,
}

impl<'j> Run<'j> {
    /// Begins a job's run in a folder, or goes on with the one in it if `resume` says so
    /// and there is one. Loads what the job names; `watch` follows the rendering of its
    /// targets.
    pub fn begin(
        job: &'j Job,
        folder: impl AsRef<Path>,
        resume: bool,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        let posed = job.posed()?;
        let claimed = folder::claim(folder.as_ref(), resume, &posed.files)?;
        let LoadedProblem {
            problem,
            chosen,
            warnings,
        } = posed.rendered(watch)?;
        let fingerprint = fingerprint(&problem, &job.specs(), job.method());
        let (folder, state) = claimed.begin(&problem, fingerprint)?;
        Ok(Self {
            job,
            problem,
            chosen,
            warnings,
            state,
            views: PreparedViews::new(),
            folder,
            last: None,
            missing: None,
        })
    }

    /// What is looked for.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// How the method of its gradients was chosen; `None` if the job names one, if they are
    /// refused, or if the run was stopped before.
    pub fn chosen(&self) -> Option<&Chosen> {
        self.chosen.as_ref()
    }

    /// Warnings about the scene files of the job.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// Where the run is.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// The last iteration that was written down by this run; `None` before the first.
    pub fn last(&self) -> Option<&Row> {
        self.last.as_ref()
    }

    /// What is missing in gradients of this run, as the first one that lacks something says it; `None` if nothing is
    /// known to be.
    pub fn missing(&self) -> Option<&str> {
        self.missing.as_deref()
    }

    /// Iterates until something stops it, and returns what. Every iteration is kept in the
    /// folder, then shown to `seen`, which may stop the run there: [`Stop::Interrupted`].
    /// A derivative that is refused is [`Error::Refused`]; [`Run::located`] says where the
    /// job asks for it.
    pub fn go(
        &mut self,
        watch: &dyn Watch,
        mut seen: impl FnMut(&Iteration) -> ControlFlow<()>,
    ) -> Result<Stop, Error> {
        loop {
            // Take a step.
            let started = Instant::now();
            let iteration = match self.problem.iterate(&self.state, &mut self.views, watch) {
                Ok(iteration) => iteration,
                Err(Stop::Refused(refusal)) => return Err(refusal.into()),
                Err(stop) => return Ok(stop),
            };
            // Write it down: the row, images every so often and at the end, the state.
            let seconds = started.elapsed().as_secs_f64();
            self.folder.write(&self.problem, &iteration, seconds)?;
            let (number, every) = (self.state.iteration, self.job.keys.images);
            let is_last = iteration.next.is_err();
            if every > 0 && (number.is_multiple_of(every) || is_last) {
                let name = format!("{number:06}");
                self.folder.draw(&self.problem, &name, &iteration.images)?;
            }
            if let Ok(next) = &iteration.next {
                self.folder.keep(next)?;
            }
            // Go on from the next state, unless the caller stops the run.
            let flow = seen(&iteration);
            if let (None, Some(step)) = (&self.missing, &iteration.row.step) {
                self.missing = step.dips.remark();
            }
            self.last = Some(iteration.row);
            match iteration.next {
                Ok(next) => self.state = next,
                Err(stop) => return Ok(stop),
            }
            if flow.is_break() {
                return Ok(Stop::Interrupted);
            }
        }
    }

    /// A refusal that [`Run::go`] returned, with the place in the job of the parameter that
    /// it is about.
    pub fn located(&self, refusal: &Refusal) -> LoadError {
        let reason = refusal.to_string();
        self.job.refused(&self.problem, &self.state, &reason)
    }

    /// Writes the result of a run that stopped for this reason, and returns the files: the
    /// parameters, the scene with them, and the record.
    pub fn finish(&self, stop: &Stop) -> Result<Vec<PathBuf>, Error> {
        let files = self
            .folder
            .finish(&self.problem, &self.state, &stop.to_string());
        Ok(files?)
    }
}
