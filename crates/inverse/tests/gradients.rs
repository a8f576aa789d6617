//! The gradient of a loss, as an iteration takes it, against finite differences of
//! the loss itself.

use capwalk_diff::{Method, PreparedScene, RenderOptions, Unwatched, WalkSettings, render};
use capwalk_inverse::Limits;
use capwalk_inverse::guard::Guards;
use capwalk_inverse::loss::{Distance, Loss};
use capwalk_inverse::samples::ByNoise;
use capwalk_inverse::schedule::{Decay, Schedule};
use capwalk_inverse::variable::vertices::{Directions, Selection};
use capwalk_inverse::variable::{Curve, VariableSpec};
use capwalk_inverse::variable::{Variables, variable};
use capwalk_inverse::{PreparedViews, Problem, State, TargetView, adam::Adam};
use capwalk_math::{Moments, Rgb, Vec3};
use capwalk_scene::params::Registry;
use capwalk_scene::{Film, Filter, Image, Scene, builtin};

/// The leaf over its floor, in so few pixels that silhouettes move little in each.
fn scene() -> Scene {
    let mut scene = builtin::scene("leaf").expect("built in");
    scene.film = Film::new(10, 8, Filter::Tent { radius: 1.0 });
    scene
}

/// Unknowns of every kind of variable, in two views, one of them masked.
fn problem() -> Problem {
    let scene = scene();
    let spec = |name: &str| VariableSpec {
        name: name.into(),
        ..VariableSpec::default()
    };
    let specs = [
        VariableSpec {
            vertices: Some(Selection::All),
            directions: Some(Directions::Plane([
                Vec3::new(1.0, 0.0, 0.0),
                Vec3::new(0.0, 0.0, 1.0),
            ])),
            lambda: Some(2.0),
            ..spec("leaf.positions")
        },
        VariableSpec {
            curve: Some(Curve::Sigmoid),
            ..spec("floor.bsdf.reflectance.value")
        },
        spec("lamp.rotate.x"),
        spec("lamp.scale"),
    ];
    let variables = specs
        .iter()
        .map(|spec| variable(&scene, &Registry::new(&scene), spec).expect("fine"));
    let variables = Variables::new(&scene, variables.collect()).expect("they fit");
    let target = |scene: &Scene, seed: u64| {
        let options = RenderOptions::new(64, seed);
        let prepared = PreparedScene::new(scene.clone());
        let mut target = render(&prepared, &options, &Unwatched).value.mean;
        // Another image than the scene's own: the gradient is not zero.
        for (i, pixel) in target.pixels.iter_mut().enumerate() {
            *pixel = *pixel * (0.7 + 0.5 * (i as f64).sin());
        }
        target
    };
    let mut second = scene.clone();
    second.sensor.world_from_camera.translation.x += 0.2;
    let mut mask = Image::new(10, 8);
    for (i, pixel) in mask.pixels.iter_mut().enumerate() {
        *pixel = Rgb::splat((i % 3) as f64);
    }
    let views = vec![
        TargetView {
            sensor: None,
            target: target(&scene, 1),
            mask: Some(mask),
            weight: 2.0,
        },
        TargetView {
            sensor: Some((second.sensor.clone(), second.film.clone())),
            target: target(&second, 2),
            mask: None,
            weight: 1.0,
        },
    ];
    Problem {
        scene,
        variables,
        views,
        loss: Loss {
            distance: Distance::L2,
            levels: 2,
        },
        adam: Adam::default(),
        lr: 1e-3,
        schedule: Schedule {
            warmup: 0,
            decay: Decay::Constant,
        },
        guards: Guards::default(),
        limits: Limits {
            iterations: 1,
            ..Limits::default()
        },
        seed: 0,
        spp: 24,
        spp_grad: 16,
        by_noise: None,
        method: Method::Walk,
        walk: WalkSettings::default(),
    }
}

/// A state with these unknowns.
fn at(problem: &Problem, unknowns: Vec<f64>) -> State {
    State {
        unknowns,
        ..State::new(problem)
    }
}

/// The mean gradient over many seeds is the derivative of the mean loss, in which
/// noise of the images does not count: along one direction in which all unknowns
/// change, and along one for each variable, in which only its own do. z below 4 in
/// five comparisons: by accident one run in 3000, with fixed seeds.
///
/// The images of a seed and its differences share random numbers. A gradient that
/// shared them with its image would be off by far more.
#[test]
fn gradients_are_derivatives_of_the_loss() {
    let mut problem = problem();
    let initial = problem.variables.initial();
    let all = |i: usize| 1.0 + 0.5 * (1.3 * i as f64).cos();
    let all: Vec<f64> = (0..initial.len()).map(all).collect();
    let mut directions = vec![all.clone()];
    for (_, range) in problem.variables.iter() {
        let own = |i: usize| if range.contains(&i) { all[i] } else { 0.0 };
        directions.push((0..all.len()).map(own).collect());
    }
    let step = 2e-2;
    let mut errors = vec![Moments::default(); directions.len()];
    let mut sizes = vec![Moments::default(); directions.len()];
    let mut views = PreparedViews::new();
    for seed in 0..120 {
        problem.seed = seed;
        let first = problem.iterate(&at(&problem, initial.clone()), &mut views, &Unwatched);
        let next = first.expect("a step").next.expect("a state");
        // The first mean of Adam is a tenth of the gradient.
        let gradient: Vec<f64> = next.first.iter().map(|m| m / (1.0 - 0.9)).collect();
        // Without iterations it only looks.
        let mut looking = problem.clone();
        looking.limits.iterations = 0;
        for (k, direction) in directions.iter().enumerate() {
            let mut loss = |h: f64| {
                let moved = initial.iter().zip(direction).map(|(u, d)| u + h * d);
                let state = at(&problem, moved.collect());
                let looked = looking.iterate(&state, &mut views, &Unwatched);
                looked.expect("an image").row.loss
            };
            let difference = (loss(step) - loss(-step)) / (2.0 * step);
            let along: f64 = gradient.iter().zip(direction).map(|(g, d)| g * d).sum();
            errors[k].add(along - difference);
            sizes[k].add(difference);
        }
    }
    for (k, (error, size)) in errors.iter().zip(&sizes).enumerate() {
        let z = error.mean / error.standard_error();
        assert!(z.abs() < 4.0, "direction {k}: z = {z}");
        // There is something to be wrong.
        let power = size.mean.abs() / error.standard_error();
        assert!(power > 5.0, "direction {k}: {power}");
    }
}

/// Where sample counts follow the noise, the variance of the descent along the last step is known, over both halves of
/// the gradient, whether the noise of images or that of gradients is larger: on average over seeds it is the variance over
/// seeds. Its mean is the one of a gradient in one piece.
#[test]
fn the_noise_of_the_descent_is_known() {
    let mut problem = problem();
    let initial = problem.variables.initial();
    let direction: Vec<f64> = (0..initial.len())
        .map(|i| 0.01 * (1.3 * i as f64).cos())
        .collect();
    let mut views = PreparedViews::new();
    let mut descents = |spp: [u32; 2], by_noise, seeds: std::ops::Range<u64>| {
        [problem.spp, problem.spp_grad] = spp;
        problem.by_noise = by_noise;
        let steps = seeds.map(|seed| {
            problem.seed = seed;
            let mut state = at(&problem, initial.clone());
            state.noise.direction.clone_from(&direction);
            let step = problem
                .iterate(&state, &mut views, &Unwatched)
                .expect("a step");
            step.row.step.expect("a step").descent
        });
        steps.collect::<Vec<_>>()
    };
    let mean = |numbers: Vec<f64>| {
        let mut moments = Moments::default();
        numbers.into_iter().for_each(|x| moments.add(x));
        (moments.mean, moments.standard_error())
    };
    let rule = ByNoise {
        theta: 0.9,
        most: 1000,
        cost: 4.0,
    };
    let whole = descents([24, 16], None, 0..100);
    let (whole, error) = mean(whole.iter().map(|found| found.value).collect());
    for spp in [[2, 64], [32, 4]] {
        let found = descents(spp, Some(rule), 1000..1200);
        let (value, own_error) = mean(found.iter().map(|found| found.value).collect());
        let z = (value - whole) / error.hypot(own_error);
        assert!(z.abs() < 4.0, "{spp:?}: {value} {whole}");
        assert!(
            value.abs() > 5.0 * own_error,
            "{spp:?}: {value} ± {own_error}"
        );
        // Of 200 descents, known to a tenth.
        let variance = own_error * own_error * found.len() as f64;
        let (by_both, _) = mean(
            found
                .iter()
                .map(|found| found.by[0] + found.by[1])
                .collect(),
        );
        let (by_image, _) = mean(found.iter().map(|found| found.by[0]).collect());
        println!(
            "{spp:?}: {value} ± {own_error}, {} of it, {}",
            by_both / variance,
            by_image / variance
        );
        assert!(
            (by_both / variance - 1.0).abs() < 0.3,
            "{spp:?}: {by_both} {variance}"
        );
    }
}
