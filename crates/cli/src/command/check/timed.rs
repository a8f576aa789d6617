//! A check that shows its progress and takes its time.

use std::time::{Duration, Instant};

use anyhow::Result;
use capwalk::{Check, CheckOptions, Chosen, Error, Prepared, Tangent};

use crate::progress::Progress;

/// A check, and how long it took.
pub struct Checked {
    pub check: Check,
    /// How the gradient was estimated.
    pub chosen: Chosen,
    /// Seconds for the gradient and for the reference.
    pub seconds: [f64; 2],
}

/// Checks a gradient, one bar after the other. Half of what preparation leaves of a time limit is
/// for the gradient; if something may be missing, half of that for the derivative of the rest of
/// the light.
pub fn check(
    prepared: &Prepared,
    tangent: &Tangent,
    options: &CheckOptions,
    limit: Option<Duration>,
) -> Result<Checked> {
    let started = Instant::now();
    let left = || limit.map(|limit| limit.saturating_sub(started.elapsed()));
    let reference = options.reference(prepared.scene(), tangent, || {
        prepared.difference_step(tangent)
    })?;
    let work = prepared.gradient_work(tangent, &options.gradient)?;
    let progress = Progress::new("prepare", left());
    let chosen = work
        .prepare(&progress)
        .and_then(|()| work.chosen(&progress));
    let mut gradient_seconds = progress.finish().as_secs_f64();
    let chosen = chosen.map_err(Error::from)?;

    let half = left().map(|left| left / 2);
    let progress = Progress::new("gradient", half);
    let gradient = work.whole(&progress);
    gradient_seconds += progress.finish().as_secs_f64();
    let gradient = gradient.map_err(Error::from)?;
    drop(work); // what it knows of the motion can be large
    let progress = Progress::new("reference", left());
    let check = prepared.checked(gradient, tangent, reference, &chosen.options, &progress);
    let reference_seconds = progress.finish().as_secs_f64();
    Ok(Checked {
        check: check?,
        chosen,
        seconds: [gradient_seconds, reference_seconds],
    })
}
