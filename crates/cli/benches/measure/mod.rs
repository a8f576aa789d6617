//! What benches of derivative images measure.

use std::time::Instant;

use capwalk_diff::GradientImage;

/// Variance of a sample, averaged over pixels and channels.
pub fn variance(image: &GradientImage) -> f64 {
    let errors = image.gradient.standard_error.pixels.iter();
    let samples = image.statistics.samples_per_pixel.iter();
    let pixels = errors.zip(samples);
    let sum: f64 = pixels.map(|(&e, &n)| e.dot(e) / 3.0 * f64::from(n)).sum();
    sum / image.gradient.mean.pixels.len() as f64
}

/// Time of the CPU where the system says it, which other programs disturb
/// less; else time on the wall.
pub struct Clock {
    cpu: Option<f64>,
    wall: Instant,
}

impl Clock {
    /// Begins to measure.
    pub fn start() -> Self {
        Self {
            cpu: cpu_seconds(),
            wall: Instant::now(),
        }
    }

    /// Seconds since then.
    pub fn seconds(&self) -> f64 {
        match (self.cpu, cpu_seconds()) {
            (Some(start), Some(end)) => end - start,
            _ => self.wall.elapsed().as_secs_f64(),
        }
    }
}

/// Ticks of `/proc/self/stat` in a second.
const TICKS: f64 = 100.0;

/// Seconds that the CPU has worked for this process, all threads.
fn cpu_seconds() -> Option<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The second field is the name in parentheses, which may contain anything.
    let (_, fields) = stat.rsplit_once(')')?;
    let mut ticks = fields.split_whitespace().skip(11);
    let mut next = || ticks.next()?.parse::<f64>().ok();
    Some((next()? + next()?) / TICKS)
}

/// Three digits that count, and powers of ten where there were many.
pub fn digits(x: f64) -> String {
    let magnitude = x.abs().log10().floor();
    match magnitude < 4.0 {
        true => format!("{x:.*}", (2.0 - magnitude).clamp(0.0, 9.0) as usize),
        false => format!("{x:.1e}"),
    }
}
