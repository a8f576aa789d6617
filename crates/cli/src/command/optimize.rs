//! `capwalk optimize`: which numbers of a scene make its images look like given ones?

mod live;
mod viewer;

use std::ops::ControlFlow;

use anyhow::{Result, ensure};
use capwalk::optimize::{Job, Run, Stop};
use capwalk::{Error, GradientOptions};
use serde_json::json;

use crate::args::Optimize;
use crate::diagnostics::Outcome;
use crate::memory::{self, Need};
use crate::progress::{self, Progress};
use crate::{console, method, report};
use live::{Clock, Live};
use viewer::Viewer;

pub fn run(args: &Optimize) -> Result<Outcome> {
    let job = Job::read(&args.job)?;
    let limit = args.time_limit.or(job.time_limit());
    // That of the command line is watched since the start.
    if let Some(of_job) = job.time_limit().filter(|_| args.time_limit.is_none()) {
        progress::end_after(of_job)?;
    }
    let clock = Clock::new(progress::left_of(limit));
    let output = args.output.as_deref().unwrap_or(job.output());
    check_memory(&job)?;
    if args.view {
        Viewer::check()?;
    }
    let targets = Progress::new("target", clock.remaining());
    let begun = Run::begin(&job, output, args.resume, &targets);
    targets.finish();
    let mut run = match begun {
        Err(Error::Stopped { .. }) => return nothing(),
        begun => begun?,
    };
    // The state that it begins with is a result.
    progress::has_results();
    for warning in run.warnings() {
        log::warn!("{warning}");
    }
    let first = run.state().iteration;
    if first > 0 && !args.json {
        console::remark(&format!("going on after iteration {first}\n"));
    }
    if let Some(chosen) = run.chosen() {
        method::log(chosen);
    }
    console::remark(&method::remark(&GradientOptions {
        method: run.problem().method,
        walk: run.problem().walk,
        ..GradientOptions::default()
    }));

    let viewer = match args.view {
        true => Some(Viewer::open(output)?),
        false => None,
    };
    let mut live = Live::new(run.problem().limits.iterations, first);
    let pause = args
        .pause_after
        .map(|count| first.saturating_add(count.get()));
    let stop = run.go(&clock, |iteration| {
        let (number, loss) = (iteration.row.iteration, iteration.row.loss);
        log::info!("iteration {number}: loss {loss:.6e}");
        live.show(&iteration.row, &iteration.images);
        let done = iteration.row.iteration.saturating_add(1);
        match pause.is_some_and(|pause| done >= pause) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    });
    live.finish();
    let stop = stop.map_err(|error| match error {
        Error::Refused(refusal) => run.located(&refusal).into(),
        error => error,
    })?;
    if let Some(missing) = run.missing() {
        log::warn!("{missing}");
    }
    let files = run.finish(&stop)?;
    let files: Vec<String> = files
        .iter()
        .map(|file| file.display().to_string())
        .collect();
    report(args, &run, &stop, clock.has_rung(), &files)?;
    // The viewer knows by the folder's lock that the run is over.
    drop(run);
    if let Some(Err(error)) = viewer.map(Viewer::finish) {
        log::warn!("{error:#}");
    }
    Ok(outcome(&stop))
}

/// An error if there is no memory for the images of the job.
fn check_memory(job: &Job) -> Result<()> {
    // What is wrong with the job itself is said where it begins.
    for size in job.sizes().unwrap_or_default() {
        memory::check_size(size, Need::Loss)?;
    }
    Ok(())
}

/// How it ends if it was stopped before the targets were there.
fn nothing() -> Result<Outcome> {
    ensure!(
        progress::interrupted(),
        "the time limit ended before the targets were rendered, and nothing was written; give \
         more time, or render the targets with fewer samples (`spp` of [target])"
    );
    console::remark("stopped before the targets were rendered; nothing was written\n");
    Ok(Outcome::Interrupted)
}

fn outcome(stop: &Stop) -> Outcome {
    match stop {
        Stop::Interrupted if progress::interrupted() => Outcome::Interrupted,
        Stop::Guard(_) | Stop::Outside(_) | Stop::Refused(_) => Outcome::Stopped,
        Stop::NotFinite { .. } => Outcome::NonFinite,
        _ => Outcome::Done,
    }
}

fn report(args: &Optimize, run: &Run, stop: &Stop, is_late: bool, files: &[String]) -> Result<()> {
    let why = match stop {
        Stop::Interrupted if progress::interrupted() => stop.to_string(),
        Stop::Interrupted if is_late => "the time limit is over".into(),
        Stop::Interrupted => "paused; --resume goes on".into(),
        stop => stop.to_string(),
    };
    let (iterations, last) = (run.state().iteration, run.last());
    let unknowns = run.problem().variables.count();
    if args.json {
        return console::print_json(&json!({
            "job": args.job.display().to_string(),
            "iterations": iterations,
            "stopped": why,
            "loss": last.map(|row| row.loss),
            "standard_error": last.map(|row| row.loss_error),
            "noise": last.and_then(|row| row.loss_noise),
            "unknowns": unknowns,
            "missing": run.missing(),
            "files": files,
        }));
    }
    let unknowns = report::count(unknowns as u64);
    let mut text = format!("{iterations} iterations, {unknowns} unknowns: {why}\n");
    if let Some(row) = last {
        let loss = report::plus_minus(row.loss, row.loss_error);
        text += &format!("loss {loss} in iteration {}", row.iteration);
        match row.loss_noise {
            Some(noise) => {
                let noise = report::significant(noise, 2);
                text += &format!(", without the {noise} that noise of the image adds\n");
            }
            None => text += ", with what noise of the image adds\n",
        }
    }
    console::print(&(text + &report::written(files)))
}
