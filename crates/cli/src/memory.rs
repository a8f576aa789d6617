//! Whether there is memory for an image, before work begins that cannot end.

use std::fs;

use anyhow::{Result, ensure};
use capwalk::Scene;

/// What commands take for each pixel, bytes: the sums of up to 16 batches, of which five wait
/// for each other, and the results in memory and as a file. Measured with 16 samples or more
/// per pixel: 473, 863 and 918.
#[derive(Clone, Copy)]
pub enum Need {
    /// An image.
    Image = 500,
    /// A derivative image and the image that comes with it.
    Gradient = 900,
    /// The same twice, of which one is sums.
    Check = 1000,
}

/// An error if the machine has not the memory for an image of this scene.
pub fn check(scene: &Scene, need: Need) -> Result<()> {
    match available() {
        Some(free) => fits(scene, need, free),
        None => Ok(()),
    }
}

fn fits(scene: &Scene, need: Need, free: u64) -> Result<()> {
    let [width, height] = scene.film.crop_size;
    let bytes = u64::from(width) * u64::from(height) * need as u64;
    let mib = |bytes: u64| bytes.div_ceil(1 << 20);
    ensure!(
        bytes <= free,
        "{width} x {height} pixels need up to {} MiB of memory, and {} MiB are free; choose fewer \
         pixels with --size, or render crop windows one after the other",
        mib(bytes),
        mib(free)
    );
    Ok(())
}

/// How many bytes can be taken, where the system says that.
fn available() -> Option<u64> {
    let text = |path: &str| fs::read_to_string(path).ok();
    let of_machine = text("/proc/meminfo").and_then(|text| of_meminfo(&text));
    let number = |path| text(path)?.trim().parse::<u64>().ok();
    // A container may have less than its machine.
    let group = number("/sys/fs/cgroup/memory.max")
        .zip(number("/sys/fs/cgroup/memory.current"))
        .map(|(most, taken)| most.saturating_sub(taken));
    of_machine.into_iter().chain(group).min()
}

fn of_meminfo(text: &str) -> Option<u64> {
    let line = text
        .lines()
        .find_map(|line| line.strip_prefix("MemAvailable:"));
    let kib: u64 = line?.trim().strip_suffix(" kB")?.parse().ok()?;
    kib.checked_mul(1 << 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_that_do_not_fit_are_refused() {
        let mut scene = capwalk::Loader::new("leaf").load().expect("built in").scene;
        scene.film.crop_size = [8000, 8000];
        assert!(fits(&scene, Need::Image, 40 << 30).is_ok());
        let error = fits(&scene, Need::Gradient, 40 << 30).expect_err("too large");
        let text = error.to_string();
        assert!(
            text.starts_with("8000 x 8000 pixels need up to 54932 MiB"),
            "{text}"
        );
        assert!(text.contains("40960 MiB are free"), "{text}");
    }

    #[test]
    fn what_linux_says() {
        let text = "MemTotal:       24604192 kB\nMemAvailable:   23265440 kB\n";
        assert_eq!(of_meminfo(text), Some(23_265_440 << 10));
        assert_eq!(of_meminfo("MemTotal: 1 kB"), None);
        if cfg!(target_os = "linux") {
            assert!(available().is_some_and(|free| free > 1 << 20));
        }
    }
}
