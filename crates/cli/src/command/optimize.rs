//! `capwalk optimize`: which numbers of a scene make its pictures look like given
//! ones?

mod folder;
mod job;
mod live;
mod problem;

use std::time::Instant;

use anyhow::{Result, ensure};
use capwalk_inverse::record::Row;
use capwalk_inverse::{Problem, State, Stop};
use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::Document;
use serde_json::json;

use crate::args::Optimize;
use crate::diagnostics::Outcome;
use crate::{console, method, progress, report};
use folder::Folder;
use job::Job;
use live::{Clock, Live};

pub fn run(args: &Optimize) -> Result<Outcome> {
    let document = Document::read(&args.job)?;
    let job = job::read(&document, &args.job)?;
    let clock = Clock::new(args.time_limit.or(job.time_limit));
    let output = args.output.as_ref().unwrap_or(&job.output);
    let files = job.scenes().chain(job.input_pictures());
    let files = files.map(|named| document.path(&named.text));
    let inputs: Vec<_> = std::iter::once(args.job.clone()).chain(files).collect();
    let claimed = folder::claim(output, args.resume, &inputs)?;
    let Some(made) = problem::problem(&document, &job, &clock)? else {
        ensure!(
            progress::interrupted(),
            "the time limit is over before the targets were rendered, and nothing was written; \
             give more time, or the targets fewer samples (`spp` of [target])"
        );
        console::remark("stopped before the targets were rendered; nothing was written\n");
        return Ok(Outcome::Interrupted);
    };
    let problem = made.problem;
    problem.check_start().map_err(|stop| {
        let place = job.parameters[0].1;
        let message = match stop {
            Stop::Guard(violation) => format!("before the first step, {violation}"),
            stop => stop.to_string(),
        };
        let help = "change the start; [guards] says what is looked for";
        document.error_with_help(place, message, help)
    })?;
    let (mut folder, first) = claimed.begin(&problem, made.fingerprint)?;
    if first.iteration > 0 && !args.json {
        console::remark(&format!("going on after iteration {}\n", first.iteration));
    }

    console::remark(&method::remark(&job.method));
    let mut live = Live::new(problem.limits.iterations, first.iteration);
    let ended = go(&problem, &job, first, &mut folder, &mut live, &clock);
    live.finish();
    let Ended { state, stop, last } = ended?;
    if let Stop::Refused(refusal) = &stop {
        return Err(refused(&document, &job, &problem, &state, &refusal.to_string()).into());
    }
    let files = folder.finish(&problem, &state, &stop.to_string())?;
    report(args, &problem, &state, &stop, last.as_ref(), &files)?;
    Ok(outcome(&stop))
}

/// How a run ended.
struct Ended {
    state: State,
    stop: Stop,
    /// The last iteration that was written down.
    last: Option<Row>,
}

/// Iterates, and writes down what happens.
fn go(
    problem: &Problem,
    job: &Job,
    mut state: State,
    folder: &mut Folder,
    live: &mut Live,
    clock: &Clock,
) -> Result<Ended> {
    let mut last = None;
    loop {
        let started = Instant::now();
        let iteration = match problem.iterate(&state, clock) {
            Ok(iteration) => iteration,
            Err(stop) => return Ok(Ended { state, stop, last }),
        };
        let number = state.iteration;
        let row = iteration.row.csv(problem);
        folder.append(&row, number, started.elapsed().as_secs_f64())?;
        let is_last = iteration.next.is_err();
        if job.pictures > 0 && (number.is_multiple_of(job.pictures) || is_last) {
            folder.draw(problem, &format!("{number:06}"), &iteration.pictures)?;
        }
        live.show(&iteration.row, &iteration.pictures);
        last = Some(iteration.row);
        match iteration.next {
            Ok(next) => {
                folder.keep(&next)?;
                state = next;
            }
            Err(stop) => return Ok(Ended { state, stop, last }),
        }
    }
}

/// A refusal with the place of the parameter that it is about.
fn refused(
    document: &Document,
    job: &Job,
    problem: &Problem,
    state: &State,
    reason: &str,
) -> LoadError {
    let alone = problem.refused_variable(state);
    let (wish, place) = &job.parameters[alone.unwrap_or(0)];
    let message = format!("the derivative by \"{}\" is refused", wish.name);
    document.error_with_help(*place, message, reason)
}

fn outcome(stop: &Stop) -> Outcome {
    match stop {
        Stop::Interrupted if progress::interrupted() => Outcome::Interrupted,
        Stop::Done | Stop::LossBelow { .. } | Stop::NoProgress { .. } | Stop::Interrupted => {
            Outcome::Done
        }
        Stop::Guard(_) | Stop::Outside(_) | Stop::Refused(_) => Outcome::Stopped,
        Stop::NotFinite { .. } => Outcome::NonFinite,
    }
}

fn report(
    args: &Optimize,
    problem: &Problem,
    state: &State,
    stop: &Stop,
    last: Option<&Row>,
    files: &[String],
) -> Result<()> {
    let why = match stop {
        Stop::Interrupted if !progress::interrupted() => "the time limit is over".into(),
        stop => stop.to_string(),
    };
    if args.json {
        return console::print_json(&json!({
            "job": args.job.display().to_string(),
            "iterations": state.iteration,
            "stopped": why,
            "loss": last.map(|row| row.loss),
            "standard_error": last.map(|row| row.loss_error),
            "noise": last.and_then(|row| row.loss_noise),
            "unknowns": problem.variables.count(),
            "files": files,
        }));
    }
    let unknowns = report::count(problem.variables.count() as u64);
    let mut text = format!(
        "{} iterations, {unknowns} unknowns: {why}\n",
        state.iteration
    );
    if let Some(row) = last {
        let loss = report::plus_minus(row.loss, row.loss_error);
        text += &format!("loss {loss} in iteration {}", row.iteration);
        match row.loss_noise {
            Some(noise) => {
                let noise = report::significant(noise, 2);
                text += &format!(", without the {noise} that noise of the picture adds\n");
            }
            None => text += ", with what noise of the picture adds\n",
        }
    }
    console::print(&(text + &report::written(files)))
}
