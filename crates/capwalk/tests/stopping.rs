//! Work that is stopped returns what is done, with its real counts.

use std::sync::atomic::{AtomicU64, Ordering};

use capwalk::{
    CheckOptions, Distance, Error, GradientOptions, Image, Loader, Loss, Method, Prepared,
    RenderOptions, Rgb, Unwatched, Watch,
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

/// Stops at the question of this number, from 0.
struct StopsAtQuestion {
    number: u64,
    asked: AtomicU64,
}

impl StopsAtQuestion {
    fn new(number: u64) -> Self {
        Self {
            number,
            asked: AtomicU64::new(0),
        }
    }
}

impl Watch for StopsAtQuestion {
    fn progress(&self, _done: u64, _total: u64) {}

    fn should_stop(&self) -> bool {
        self.asked.fetch_add(1, Ordering::SeqCst) >= self.number
    }
}

/// Preparation asks for every few edges whether to stop; stopped anywhere, it leaves nothing
/// behind that a later gradient would see.
#[test]
fn preparation_stops_anywhere() {
    let options = GradientOptions {
        spp: 1,
        ..GradientOptions::default()
    };
    let gradient = |prepared: &Prepared, watch: &dyn Watch| {
        prepared.gradient("leaf.translate.x", &options, watch)
    };
    let expected = gradient(&leaf(), &Unwatched).expect("it is not refused");
    let [mut stopped, mut number] = [0_u64; 2];
    let prepared = leaf();
    while number < 100_000 {
        let watch = StopsAtQuestion::new(number);
        match gradient(&prepared, &watch) {
            Err(Error::Stopped { .. }) => stopped += 1,
            // From now on it is samples that stop.
            result => {
                assert!(!result.expect("it is not refused").statistics.complete);
                break;
            }
        }
        number += 1 + number / 8;
    }
    assert!(stopped > 3, "{stopped}");
    let found = gradient(&prepared, &Unwatched).expect("it is not refused");
    // Of one sample each, they have no errors.
    assert!(found.gradient.mean == expected.gradient.mean);
}

/// So does that of the tree for rays, with the scene itself.
#[test]
fn making_ready_stops() {
    let scene = Loader::new("leaf").load().expect("built in").scene;
    let stopped = Prepared::watched(scene.clone(), &StopsAtOnce);
    assert!(matches!(stopped, Err(Error::Stopped { .. })));
    assert!(Prepared::watched(scene, &Unwatched).is_ok());
}

/// A pass over many pixels is stopped within it: then no pixel has its sample, and all have as many.
#[test]
fn passes_over_many_pixels_stop() {
    let size = [80, 64];
    let scene = Loader::new("leaf")
        .size(size)
        .load()
        .expect("built in")
        .scene;
    let prepared = Prepared::new(scene).expect("it can be rendered");
    let mut adjoint = Image::new(80, 64);
    adjoint.pixels.fill(Rgb::splat(1.0));
    let options = GradientOptions {
        spp: 2,
        method: Method::EDGES,
        ..GradientOptions::default()
    };
    let backward = |watch: &dyn Watch| {
        let found = prepared.backward(&adjoint, &["leaf.translate.x"], &options, watch);
        found.expect("it is not refused").statistics
    };
    assert!(backward(&Unwatched).complete);
    // Now nothing is left to be prepared.
    let whole = StopsAtQuestion::new(u64::MAX);
    assert!(backward(&whole).complete);
    let asked = whole.asked.into_inner();
    assert!(asked > 2 * 80, "{asked} questions");
    let stopped = backward(&StopsAtQuestion::new(asked - 20));
    assert!(!stopped.complete);
    let counts = &stopped.samples_per_pixel;
    assert!(counts.iter().all(|count| *count == counts[0]), "{counts:?}");
}
