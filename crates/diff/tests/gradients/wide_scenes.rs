//! Scenes of things of very different sizes, and of many small ones: what a derivative prepares
//! takes time in proportion to n log n, however wide the scene is.
//!
//! `cargo xtask soak` runs many more of them, and larger ones: `CAPWALK_SOAK_SECONDS` says for how
//! long, `CAPWALK_SOAK_SEED` where to begin.

use std::time::{Duration, Instant};

use capwalk_diff::{GradientOptions, Method, PreparedScene, Unwatched, gradient};
use capwalk_math::{Affine, Vec3};
use capwalk_scene::params::Registry;
use capwalk_scene::primitive::{cube, divided_sphere};
use capwalk_scene::{Scene, ShadingNormals};

use crate::common::random::Random;
use crate::common::stages::add_constant_light;
use crate::common::{add, empty, v};

/// CPU time that the preparation may take for each triangle and each doubling of their number: ten
/// times what it takes (1 µs, unoptimised), for busy machines.
const PER_TRIANGLE: Duration = Duration::from_micros(10);

/// What it may take besides, and samples with it.
const BESIDES: Duration = Duration::from_secs(10);

/// Balls of which one is up to 4·10⁹ times as large as the others: beside it, on it, in it, around
/// it.
fn balls(random: &mut Random, division: u32) -> Scene {
    let mut scene = empty(v(0.3, -6.0, 1.2), v(0.0, 0.0, 0.0), 30.0, 6);
    let wide = 10_f64.powf(random.number(0.0, 9.6));
    let centre = match random.below(3) {
        0 => v(0.0, 0.0, -wide - 1.0),
        1 => random.vector(0.5),
        _ => random.vector(2.0 * wide),
    };
    let places = [
        (Vec3::zero(), 1.0),
        (centre, wide),
        (random.vector(1.0), 0.3),
    ];
    for (i, (centre, radius)) in places.into_iter().enumerate() {
        let (mesh, normals) = divided_sphere(Affine::IDENTITY, centre, radius, division);
        add(&mut scene, &format!("thing{i}"), mesh, normals, 0.5);
    }
    scene.sensor.far_clip = 1e12;
    scene
}

/// Many cubes, in a grid or anywhere, on a floor that may be wide.
fn cubes(random: &mut Random, count: usize) -> Scene {
    let mut scene = empty(v(0.3, -6.0, 1.2), v(0.0, 0.0, 0.0), 30.0, 6);
    let side = (count as f64).cbrt().ceil() as usize;
    let is_grid = random.chance(0.5);
    for i in 0..count {
        let place = match is_grid {
            true => [i % side, i / side % side, i / side / side]
                .map(|k| 4.0 * (k as f64 + 0.5) / side as f64 - 2.0)
                .into(),
            false => random.vector(2.0),
        };
        let size = Vec3::splat(1.2 / side as f64);
        let (mesh, _) = cube(Affine::translate(place) * Affine::scale(size));
        add(
            &mut scene,
            &format!("thing{i}"),
            mesh,
            ShadingNormals::Face,
            0.5,
        );
    }
    let wide = 10_f64.powf(random.number(0.0, 9.0));
    let below = Affine::translate(v(0.0, 0.0, -2.0 - wide)) * Affine::scale(Vec3::splat(wide));
    add(
        &mut scene,
        "floor",
        cube(below).0,
        ShadingNormals::Face,
        0.5,
    );
    scene.sensor.far_clip = 1e12;
    scene
}

/// CPU time of this process, where the system says it; else the time that passed.
fn time(started: Instant) -> Duration {
    let Ok(text) = std::fs::read_to_string("/proc/self/stat") else {
        return started.elapsed();
    };
    // Behind the name in parentheses: user and system time are the 12th and 13th, in hundredths.
    let behind = text.rsplit(')').next().unwrap_or_default();
    let ticks = behind.split_whitespace().skip(11).take(2);
    let ticks = ticks.filter_map(|number| number.parse::<u64>().ok());
    Duration::from_millis(10 * ticks.sum::<u64>())
}

#[test]
fn wide_scenes() {
    let variable = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let first: u64 = variable("CAPWALK_SOAK_SEED").unwrap_or(1);
    let seconds: Option<u64> = variable("CAPWALK_SOAK_SECONDS");
    let started = Instant::now();
    // Small scenes where there is little time: they cannot take long, but must be right.
    let (division, most_cubes) = if seconds.is_some() {
        (55, 20_000)
    } else {
        (6, 60)
    };
    for seed in first.. {
        let is_enough = match seconds {
            Some(seconds) => started.elapsed() >= Duration::from_secs(seconds),
            None => seed >= first + 4,
        };
        if is_enough {
            break;
        }
        let mut random = Random(seed);
        let mut scene = match random.chance(0.5) {
            true => balls(&mut random, division),
            false => {
                let count = 30 + random.below(most_cubes);
                cubes(&mut random, count)
            }
        };
        add_constant_light(&mut scene, 1.0);
        let triangles: usize = scene
            .shapes
            .iter()
            .map(|shape| shape.mesh.faces.len())
            .sum();
        let names = Registry::new(&scene);
        let tangent = names
            .tangent(&scene, "thing0.translate.x")
            .expect("it is there");
        let before = time(started);
        let prepared = PreparedScene::new(scene);
        let options = GradientOptions {
            spp: 1,
            method: Method::EDGES,
            ..GradientOptions::default()
        };
        let found = gradient(&prepared, &tangent, &options, &Unwatched).expect("not refused");
        assert_eq!(found.statistics.non_finite, 0, "seed {seed}");
        let taken = time(started) - before;
        let doublings = f64::from(triangles.ilog2());
        let most = PER_TRIANGLE.mul_f64(triangles as f64 * doublings) + BESIDES;
        assert!(
            taken < most,
            "seed {seed}, {triangles} triangles: {taken:?}"
        );
    }
}
