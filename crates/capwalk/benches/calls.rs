//! What a call costs of which there is next to nothing to do, as `cargo bench -p capwalk --bench
//! calls` prints it: one pixel before a cube, the scene of `python/benchmarks`. What a call from
//! Python takes longer is the cost of Python. Medians, milliseconds.

use std::path::Path;
use std::time::Instant;

use capwalk::{GradientOptions, Image, Method, Prepared, RenderOptions, Rgb, Unwatched, load};

/// Odd, so that there is a median.
const ROUNDS: usize = 2001;

fn main() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../python/benchmarks/pixel.xml");
    let scene = load(&file).expect("a valid scene").scene;
    let prepared = Prepared::new(scene).expect("a valid scene");
    let sampling = RenderOptions::new(1, 1);
    let edges = GradientOptions {
        method: Method::EDGES,
        ..GradientOptions::new(sampling)
    };
    let mut ones = Image::new(1, 1);
    ones.pixels.fill(Rgb::splat(1.0));
    let render = || {
        let image = prepared.render(&sampling, &Unwatched);
        std::hint::black_box(image.expect("it can be rendered"));
    };
    let gradient = || {
        let gradient = prepared.gradient("box.translate.x", &edges, &Unwatched);
        std::hint::black_box(gradient.expect("covered"));
    };
    let backward = || {
        let gradients = prepared.backward(&ones, &["box.positions"], &edges, &Unwatched);
        std::hint::black_box(gradients.expect("covered"));
    };
    let calls: [(&str, &dyn Fn()); 3] = [
        ("render", &render),
        ("gradient", &gradient),
        ("backward", &backward),
    ];
    for (what, call) in calls {
        println!("one pixel, {what:10}{:8.3} ms", median(call));
    }
}

fn median(call: &dyn Fn()) -> f64 {
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let started = Instant::now();
            call();
            1e3 * started.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[ROUNDS / 2]
}
