//! Work that is stopped returns what is done, with its real counts.

use std::sync::atomic::{AtomicU64, Ordering};

use capwalk::{
    CheckOptions, Distance, Error, GradientOptions, Image, Loader, Loss, Prepared, RenderOptions,
    Rgb, Unwatched, Watch,
};

const SIZE: [u32; 2] = [12, 9];
const PIXELS: u64 = 12 * 9;

fn leaf() -> Prepared {
    let scene = Loader::new("leaf")
        .size(SIZE)
        .load()
        .expect("built in")
        .scene;
    Prepared::new(scene).expect("it can be rendered")
}

/// Stops when some of the work in so many units is done.
struct StopsIn {
    total: u64,
    seen: AtomicU64,
}

impl StopsIn {
    fn work_of(total: u64) -> Self {
        Self {
            total,
            seen: AtomicU64::new(0),
        }
    }
}

impl Watch for StopsIn {
    fn progress(&self, done: u64, total: u64) {
        if total == self.total {
            self.seen.fetch_max(done, Ordering::SeqCst);
        }
    }

    fn should_stop(&self) -> bool {
        self.seen.load(Ordering::SeqCst) > 0
    }
}

/// Stops before anything is done.
struct StopsAtOnce;

impl Watch for StopsAtOnce {
    fn progress(&self, _done: u64, _total: u64) {}

    fn should_stop(&self) -> bool {
        true
    }
}

#[test]
fn a_stopped_image_has_some_samples() {
    const SPP: u32 = 100_000_000;
    let watch = StopsIn::work_of(PIXELS * u64::from(SPP));
    let options = RenderOptions::new(SPP, 0);
    let rendering = leaf().render(&options, &watch).expect("it has samples");
    let statistics = rendering.statistics;
    assert!(!statistics.complete);
    assert!(0 < statistics.samples && statistics.samples < PIXELS * u64::from(SPP));
    let counts = statistics.samples_per_pixel.iter();
    assert_eq!(
        counts.map(|&n| u64::from(n)).sum::<u64>(),
        statistics.samples
    );
}

/// The gradient is whole; its reference, with other units of work, is stopped.
#[test]
fn a_check_whose_reference_is_stopped_says_so() {
    const SPP: u32 = 100_000_000;
    let options = CheckOptions {
        gradient: GradientOptions {
            spp: 4,
            ..GradientOptions::default()
        },
        reference_spp: Some(SPP),
        step: None,
    };
    let watch = StopsIn::work_of(PIXELS * u64::from(SPP));
    let check = leaf().check("leaf.translate.x", &options, &watch);
    let check = check.expect("nothing is refused");
    assert!(check.gradient.statistics.complete);
    assert_eq!(check.gradient.statistics.samples, 4 * PIXELS);
    let reference = &check.reference.statistics;
    assert!(!reference.complete && reference.samples > 0);
}

#[test]
fn a_loss_without_an_image_is_an_error() {
    let mut target = Image::new(SIZE[0] as usize, SIZE[1] as usize);
    target.pixels.fill(Rgb::splat(0.5));
    let loss = Loss {
        distance: Distance::L2,
        levels: 1,
    };
    let options = RenderOptions::new(4, 0);
    let prepared = leaf();
    let stopped = prepared.loss(&loss, &target, None, &options, &StopsAtOnce);
    assert!(matches!(stopped, Err(Error::Stopped { .. })), "{stopped:?}");
    let small = Image::new(2, 2);
    let other = prepared.loss(&loss, &small, None, &options, &Unwatched);
    let Err(Error::Size { what, found, .. }) = other else {
        panic!("{other:?}");
    };
    assert_eq!((what, found), ("target", [2, 2]));
}
