//! A run in the terminal: how far it is, the loss so far, and the image. Nothing
//! where the standard error is no terminal.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use capwalk::optimize::Row;
use capwalk::scene_io::image::photographic;
use capwalk::{Image, Rgb, Watch};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::{progress, report};

/// Largest width of the image, in characters.
const COLUMNS: usize = 64;
/// Largest height of the image, in lines of two pixels.
const LINES: usize = 20;
/// Losses in the curve.
const CURVE: usize = 48;

/// What is shown of a run.
pub struct Live {
    bar: ProgressBar,
    losses: Vec<f64>,
    is_shown: bool,
}

/// Stops a run when it is time, or on Ctrl-C.
pub struct Clock {
    deadline: Option<Instant>,
}

impl Clock {
    /// That rings after `limit` from now.
    pub fn new(limit: Option<Duration>) -> Self {
        let now = Instant::now();
        Self {
            deadline: limit.and_then(|limit| now.checked_add(limit)),
        }
    }

    /// True if it is time.
    pub fn has_rung(&self) -> bool {
        self.deadline.is_some_and(|at| Instant::now() >= at)
    }

    /// How long until it rings; `None` if it never does.
    pub fn remaining(&self) -> Option<Duration> {
        let now = Instant::now();
        self.deadline.map(|at| at.saturating_duration_since(now))
    }
}

impl Watch for Clock {
    fn progress(&self, _done: u64, _total: u64) {}

    fn should_stop(&self) -> bool {
        progress::interrupted() || self.has_rung()
    }
}

impl Live {
    /// The display of a run of so many iterations, some of which are done.
    pub fn new(iterations: u32, done: u32) -> Self {
        let is_shown = std::io::stderr().is_terminal();
        let target = match is_shown {
            true => ProgressDrawTarget::stderr(),
            false => ProgressDrawTarget::hidden(),
        };
        let bar = ProgressBar::with_draw_target(Some(u64::from(iterations)), target);
        let style = ProgressStyle::with_template(
            "{pos}/{len} {wide_bar:.cyan/dim} {elapsed} elapsed, {eta} left\n{msg}",
        );
        bar.set_style(style.expect("the template is constant and valid"));
        bar.set_position(u64::from(done));
        bar.reset_eta();
        if is_shown {
            // Time passes during long iterations, too.
            bar.enable_steady_tick(Duration::from_secs(1));
        }
        Self {
            bar,
            losses: Vec::new(),
            is_shown,
        }
    }

    /// Shows an iteration.
    pub fn show(&mut self, row: &Row, images: &[Image]) {
        if !self.is_shown {
            return;
        }
        self.losses.push(row.loss);
        let recent = &self.losses[self.losses.len().saturating_sub(CURVE)..];
        let loss = report::plus_minus(row.loss, row.loss_error);
        let mut text = format!("loss {loss}  {}", curve(recent));
        if let Some(image) = images.first() {
            text += &format!("\n{}", half_blocks(image, COLUMNS, LINES));
        }
        self.bar.set_message(text);
        let done = u64::from(row.iteration) + 1;
        self.bar
            .set_position(done.min(self.bar.length().unwrap_or(done)));
    }

    /// Clears it.
    pub fn finish(self) {
        self.bar.finish_and_clear();
    }
}

/// Numbers as a row of bars, by their logarithms from the smallest to the largest
/// that is above 0.
fn curve(numbers: &[f64]) -> String {
    const BARS: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
    let logs = || numbers.iter().filter(|&&x| x > 0.0).map(|x| x.ln());
    let (low, high) = logs().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
        (low.min(x), high.max(x))
    });
    let bar = |&x: &f64| match x > 0.0 && high > low {
        true => BARS[(((x.ln() - low) / (high - low)) * 7.0).round() as usize],
        false => BARS[0],
    };
    numbers.iter().map(bar).collect()
}

/// An image in half blocks, each two pixels, of at most so many columns and
/// lines: means of what falls into each.
fn half_blocks(image: &Image, columns: usize, lines: usize) -> String {
    let (width, height) = (image.width, image.height);
    let shrink = (width.div_ceil(columns))
        .max(height.div_ceil(2 * lines))
        .max(1);
    let mean = |x: usize, y: usize| {
        let (xs, ys) = (x * shrink..(x + 1) * shrink, y * shrink..(y + 1) * shrink);
        let ys = ys.start.min(height)..ys.end.min(height);
        let xs = xs.start.min(width)..xs.end.min(width);
        let count = (xs.len() * ys.len()) as f64;
        let rows = ys.flat_map(|y| xs.clone().map(move |x| (x, y)));
        let sum = rows.fold(Rgb::zero(), |sum, (x, y)| sum + image.at(x, y));
        match count > 0.0 {
            true => photographic(sum / count, 1.0),
            false => [0; 3],
        }
    };
    let (columns, rows) = (width.div_ceil(shrink), height.div_ceil(shrink));
    let mut text = String::new();
    for y in (0..rows).step_by(2) {
        for x in 0..columns {
            let ([r, g, b], [s, h, c]) = (mean(x, y), mean(x, y + 1));
            text += &format!("\x1b[38;2;{r};{g};{b}m\x1b[48;2;{s};{h};{c}m▀");
        }
        text += "\x1b[0m\n";
    }
    text.truncate(text.trim_end_matches('\n').len());
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_fit_and_keep_their_colours() {
        let mut image = Image::new(100, 60);
        for (i, pixel) in image.pixels.iter_mut().enumerate() {
            // White above, red below.
            *pixel = match i < 100 * 30 {
                true => Rgb::splat(1.0),
                false => Rgb::new(1.0, 0.0, 0.0),
            };
        }
        let text = half_blocks(&image, 25, 40);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 8, "15 rows of pixels");
        assert!(lines.iter().all(|line| line.matches('▀').count() == 25));
        let white = "\x1b[38;2;255;255;255m\x1b[48;2;255;255;255m▀";
        assert!(lines[0].starts_with(white));
        assert!(lines[7].starts_with("\x1b[38;2;255;0;0m\x1b[48;2;0;0;0m▀"));
        assert!(lines.iter().all(|line| line.ends_with("\x1b[0m")));
        assert_eq!(half_blocks(&image, 1000, 1000).lines().count(), 30);
    }

    #[test]
    fn curves_go_from_low_to_high() {
        assert_eq!(curve(&[100.0, 10.0, 1.0, -1.0]), "█▅▁▁");
        assert_eq!(curve(&[2.0, 2.0]), "▁▁");
        assert_eq!(curve(&[]), "");
    }
}
