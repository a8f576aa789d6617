//! What was done, for people: aligned columns, times, warnings.

use anyhow::{Result, bail};
use capwalk::text::cut;
pub use capwalk::text::{count, list, number, plus_minus, significant};
use capwalk::{Estimate, Image, Rgb, Statistics};
use serde_json::{Value, json};

use crate::diagnostics::Outcome;
use crate::{console, progress};

/// How many of something there are: "1 emitter", "2 emitters".
pub fn counted(n: usize, noun: &str) -> String {
    let plural = if n == 1 { "" } else { "s" };
    format!("{} {noun}{plural}", count(n as u64))
}

/// A time in its usual unit.
pub fn seconds(s: f64) -> String {
    match s {
        s if s < 0.1 => format!("{:.1} ms", 1e3 * s),
        s if s < 120.0 => format!("{s:.1} s"),
        s if s < 7200.0 => format!("{:.1} min", s / 60.0),
        s => format!("{:.1} h", s / 3600.0),
    }
}

/// Rows as a table: the first column to the left, the others to the right. Cells that are too long
/// are cut.
pub fn table(rows: &[Vec<String>]) -> String {
    let cut_row = |row: &Vec<String>| row.iter().map(|cell| cut(cell).into_owned()).collect();
    let rows: Vec<Vec<String>> = rows.iter().map(cut_row).collect();
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |c: usize| {
        let cells = rows.iter().filter_map(|row| row.get(c));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in &rows {
        let cells = row.iter().enumerate().map(|(c, cell)| {
            let pad = " ".repeat(widths[c] - cell.chars().count());
            if c == 0 {
                format!("{cell}{pad}")
            } else {
                format!("{pad}{cell}")
            }
        });
        let line = cells.collect::<Vec<_>>().join("   ");
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

/// One line on what was done, and one for each thing that is not as it should be.
pub fn work(what: &str, statistics: &Statistics, elapsed: f64) -> String {
    let rate = |n: u64| number(n as f64 / elapsed / 1e6);
    let mut text = format!(
        "{what}: {} samples, {} million/s",
        count(statistics.samples),
        rate(statistics.samples)
    );
    if statistics.cone_queries > 0 {
        text += &format!(
            ", {} million silhouette queries/s",
            rate(statistics.cone_queries)
        );
    }
    text += &format!(", {}\n", seconds(elapsed));
    text
}

/// Why it was the CPU, where a GPU was there and could have been meant.
pub fn remark_on_device(statistics: &Statistics) -> String {
    let remark = statistics.device.remark.as_ref();
    remark.map_or_else(String::new, |remark| format!("{remark}\n"))
}

/// The names of the files that were written, on one line.
pub fn written(files: &[String]) -> String {
    format!("wrote {}\n", files.join(", "))
}

/// What is to be said on the standard error about a finished piece of work:
/// that it is partial, what is missing in it, and non-finite samples.
pub fn warnings(what: &str, statistics: &Statistics) -> String {
    let mut text = String::new();
    if !statistics.complete {
        let taken = &statistics.samples_per_pixel;
        let (least, most) = (
            taken.iter().min().copied().unwrap_or(0),
            taken.iter().max().copied().unwrap_or(0),
        );
        text += &format!(
            "warning: the {what} is partial: {least} to {most} samples per pixel were taken\n"
        );
    }
    if let Some(remark) = statistics.dips.remark() {
        text += &format!("warning: {remark}\n");
    }
    if statistics.non_finite > 0 {
        text += &format!(
            "{}: {} of {} samples of the {what} were infinite or NaN; they count as zero{}\n",
            if statistics.too_many_non_finite() {
                "error"
            } else {
                "warning"
            },
            count(statistics.non_finite),
            count(statistics.samples),
            if statistics.too_many_non_finite() {
                ", more than 1 in 10^6: do not use these images"
            } else {
                ""
            }
        );
    }
    text
}

/// How it ends if it was stopped too early to write anything.
pub fn nothing(before: &str) -> Result<Outcome> {
    if !progress::interrupted() {
        bail!(progress::out_of_time(before));
    }
    console::remark(&format!("{}\n", progress::stopped(before)));
    Ok(Outcome::Interrupted)
}

/// How a command ends whose images were made with these statistics.
pub fn outcome(statistics: &[&Statistics]) -> Outcome {
    if statistics.iter().any(|s| s.too_many_non_finite()) {
        Outcome::NonFinite
    } else if progress::interrupted() {
        Outcome::Interrupted
    } else {
        Outcome::Done
    }
}

/// The mean colour of an image.
pub fn mean_colour(image: &Image) -> [f64; 3] {
    let sum = image.pixels.iter().fold(Rgb::zero(), |sum, &p| sum + p);
    let mean = sum / image.pixels.len() as f64;
    [mean.r, mean.g, mean.b]
}

/// Variance of one sample of a pixel: squared standard errors times the
/// pixel's samples, averaged over pixels and channels. Pixels with fewer than
/// two samples do not enter; NaN if none does.
pub fn variance_per_sample(estimate: &Estimate, statistics: &Statistics) -> f64 {
    let errors = estimate.standard_error.pixels.iter();
    let (sum, pixels) = errors
        .zip(&statistics.samples_per_pixel)
        .filter(|(error, _)| error.is_finite())
        .fold((0.0, 0_u64), |(sum, pixels), (error, &samples)| {
            (
                sum + error.dot(*error) / 3.0 * f64::from(samples),
                pixels + 1,
            )
        });
    sum / pixels as f64
}

/// The statistics as JSON.
pub fn statistics_json(statistics: &Statistics, elapsed: f64) -> Value {
    let taken = &statistics.samples_per_pixel;
    json!({
        "complete": statistics.complete,
        "samples": statistics.samples,
        "fewest_samples_per_pixel": taken.iter().min(),
        "most_samples_per_pixel": taken.iter().max(),
        "non_finite": statistics.non_finite,
        "cone_queries": statistics.cone_queries,
        "dips": {"events": statistics.dips.events, "dip": statistics.dips.dip},
        "seconds": elapsed,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn things_are_counted() {
        assert_eq!(counted(1, "emitter"), "1 emitter");
        assert_eq!(counted(2000, "emitter"), "2,000 emitters");
        assert_eq!(counted(0, "emitter"), "0 emitters");
    }

    /// Two samples of a million are too many, one is reported.
    #[test]
    fn non_finite_samples_are_counted_and_reported() {
        let with = |non_finite: u64| Statistics {
            samples_per_pixel: vec![1_000_000],
            complete: true,
            samples: 1_000_000,
            non_finite,
            ..Statistics::default()
        };
        assert_eq!(outcome(&[&with(0), &with(1)]), Outcome::Done);
        assert_eq!(outcome(&[&with(0), &with(2)]), Outcome::NonFinite);
        assert_eq!(warnings("image", &with(0)), "");
        assert!(warnings("image", &with(1)).starts_with("warning: 1 of 1,000,000 samples"));
        assert!(warnings("image", &with(2)).starts_with("error: 2 of 1,000,000 samples"));
    }

    #[test]
    fn columns_align() {
        let rows = [["a", "10"], ["long", "5"]].map(|row| row.map(String::from).to_vec());
        assert_eq!(table(&rows), "a      10\nlong    5\n");
    }
}
