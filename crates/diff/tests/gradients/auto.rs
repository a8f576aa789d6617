//! The method that chooses: its choice, and that what it chose is right.

use std::borrow::Cow;
use std::sync::atomic::{AtomicU64, Ordering};

use capwalk_diff::{
    BackwardWork, Chosen, Gathers, GradientOptions, GradientWork, KeptChoice, Method,
    PreparedScene, RenderOptions, Unwatched, Wanted, Watch, gradient, with_threads,
};
use capwalk_geometry::effort;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::lobe::{Distribution, Microfacets, RoughConductor};
use capwalk_scene::primitive::{cube, rectangle};
use capwalk_scene::{Emitter, Filter, Image, Scene, Tangent, Texture, builtin};

use crate::common::agree::*;
use crate::common::materials::*;
use crate::common::stages::*;
use crate::common::*;

fn built_in(name: &str) -> (Scene, Tangent) {
    let mut scene = builtin::scene(name).expect("built in");
    scene.film.size = [48, 36];
    scene.film.crop_size = [48, 36];
    let parameter = builtin::default_parameter(name).expect("built in");
    let tangent = tangent(&scene, parameter);
    (scene, tangent)
}

fn options(spp: u32) -> GradientOptions {
    GradientOptions::new(RenderOptions::new(spp, 1))
}

fn chosen(scene: &Scene, tangent: &Tangent, options: GradientOptions) -> Chosen {
    let prepared = PreparedScene::new(scene.clone());
    let work = GradientWork::new(&prepared, Cow::Borrowed(tangent), options);
    work.chosen(&Unwatched).expect("covered")
}

/// The same trials to the bit for every number of threads, and the gradient that the choice
/// gives when it is asked for.
#[test]
fn the_choice_is_always_the_same() {
    let (scene, tangent) = built_in("lattice-shadow");
    let options = options(16);
    let one = with_threads(1, || chosen(&scene, &tangent, options));
    let three = with_threads(3, || chosen(&scene, &tangent, options));
    assert_eq!(one, three);
    assert!(one.trials.len() >= 4, "{one:?}");
    let prepared = PreparedScene::new(scene);
    let automatic = gradient(&prepared, &tangent, &options, &Unwatched).expect("covered");
    let same = gradient(&prepared, &tangent, &one.options, &Unwatched).expect("covered");
    assert_eq!(automatic.gradient, same.gradient);
}

/// What is chosen is the best of what was tried, by the variance of its gradients, too.
#[test]
fn the_best_is_chosen() {
    for name in ["ball", "lattice-shadow", "box-room"] {
        let (scene, tangent) = built_in(name);
        let chosen = chosen(&scene, &tangent, options(32));
        let prepared = PreparedScene::new(scene);
        let cost = |trial: &capwalk_diff::Trial| {
            let mut options = options(16);
            options.method = trial.method;
            options.walk.max_radius = trial.max_radius;
            let result = gradient(&prepared, &tangent, &options, &Unwatched).expect("covered");
            let errors = result.gradient.standard_error.pixels;
            let mut squares: Vec<f64> = errors.iter().map(|error| error.dot(*error)).collect();
            // Also without the worst pixels, where one sample outweighs an image, or where outlines are.
            squares.sort_by(f64::total_cmp);
            let rest = squares.len() - squares.len() / 50;
            [rest, squares.len()].map(|n| squares[..n].iter().sum::<f64>() * trial.effort)
        };
        let is_chosen = |trial: &&capwalk_diff::Trial| {
            let options = &chosen.options;
            trial.method == options.method && trial.max_radius == options.walk.max_radius
        };
        let own = chosen.trials.iter().find(is_chosen).expect("it was tried");
        let own = cost(own);
        for trial in &chosen.trials {
            let other = cost(trial);
            let ratios = [0, 1].map(|i| other[i] / own[i]);
            println!("{name}: {trial:?}: {ratios:.3?} of the chosen one");
            let is_better = ratios.iter().all(|&ratio| ratio < 0.5);
            assert!(!is_better, "{name}: {trial:?} is better");
        }
    }
}

/// The scene with one of its shapes of rough metal.
fn of_metal(mut scene: Scene, id: &str) -> Scene {
    let [eta, k, one, alpha] = [("eta", 0.2), ("k", 3.0), ("one", 1.0), ("alpha", 0.2)]
        .map(|(name, number)| scene.add_texture(Texture::number(name, number)));
    let metal = RoughConductor {
        microfacets: Microfacets::isotropic(Distribution::Ggx, alpha),
        eta,
        k,
        specular_reflectance: one,
    };
    let shape = scene.shapes.iter().find(|shape| shape.id == id);
    let id = shape.expect("it is there").bsdf;
    scene.materials[id.0 as usize].bsdf = metal.into();
    scene
}

/// Nothing is tried twice, and what costs ten times as much as something else after a quarter of its
/// samples takes no more.
#[test]
fn hopeless_trials_are_short() {
    let (ball, _) = built_in("ball");
    let parameter = builtin::default_parameter("ball").expect("built in");
    let mut short = 0;
    for scene in [of_metal(ball.clone(), "ball"), ball] {
        let moving = tangent(&scene, parameter);
        let prepared = PreparedScene::new(scene);
        // As many samples as take trials of 2048.
        let work = GradientWork::new(&prepared, Cow::Borrowed(&moving), options(80));
        let chosen = work.chosen(&Unwatched).expect("covered");
        let trials = &chosen.trials;
        let mut least = f64::INFINITY;
        for (i, trial) in trials.iter().enumerate() {
            let is_new = |other: &capwalk_diff::Trial| {
                (other.method, other.max_radius) != (trial.method, trial.max_radius)
            };
            assert!(trials[..i].iter().all(is_new), "{trial:?}");
            let is_hopeless = trial.cost() > 10.0 * least;
            short += usize::from(is_hopeless);
            let samples = if is_hopeless { 512 } else { 2048 };
            assert_eq!(trial.samples, samples, "{trial:?}");
            least = least.min(trial.upper_cost());
        }
    }
    assert!(short > 0);
}

/// The effort of queries on this thread.
fn effort_of<T>(work: impl FnOnce() -> T) -> (T, u64) {
    let before = effort();
    let result = work();
    (result, effort() - before)
}

/// Pilots cost less than the samples for which they choose, however few these are, in both modes.
#[test]
fn pilots_cost_less_than_the_samples() {
    for (name, size, spp) in [
        ("ball", [16, 12], 1),
        ("ball", [48, 36], 16),
        ("lattice-shadow", [16, 12], 1),
        ("lattice-shadow", [48, 36], 10),
    ] {
        let (mut scene, tangent) = built_in(name);
        (scene.film.size, scene.film.crop_size) = (size, size);
        let mut adjoint = Image::new(size[0] as usize, size[1] as usize);
        adjoint.pixels.fill(Rgb::splat(1.0));
        let prepared = PreparedScene::new(scene);
        // Listing the edges is work of both.
        prepared.boundaries();
        with_threads(1, || {
            let forward = GradientWork::new(&prepared, Cow::Borrowed(&tangent), options(spp));
            let wanted = Wanted::by(&tangent);
            let reverse = BackwardWork::new(&prepared, &adjoint, wanted, options(spp));
            let pilots = [
                effort_of(|| forward.chosen(&Unwatched).expect("covered")),
                effort_of(|| reverse.chosen(&Unwatched).expect("covered")),
            ];
            let ((), of_forward) = effort_of(|| drop(forward.whole(&Unwatched)));
            let ((), of_reverse) = effort_of(|| drop(reverse.whole(&Unwatched)));
            for ((chosen, pilot), samples) in pilots.into_iter().zip([of_forward, of_reverse]) {
                let trials = chosen.trials.len();
                println!(
                    "{name}, {spp} samples of {size:?}: {trials} trials, {pilot} of {samples}"
                );
                assert!(
                    pilot < samples,
                    "{name}, {spp} samples of {size:?}: {chosen:?}"
                );
                assert!(
                    trials > 1 || spp == 1,
                    "{name}, {size:?}: nothing was tried"
                );
            }
        });
    }
}

/// Neither seeds nor the adjoint decide, and a few samples more do not: what is chosen for one call
/// is what any other of its kind would choose.
#[test]
fn the_choice_is_one_for_all_seeds_and_losses() {
    let (scene, tangent) = built_in("lattice-shadow");
    let seeded = |seed, spp| GradientOptions::new(RenderOptions::new(spp, seed));
    let method = |chosen: Chosen| (chosen.options.method, chosen.trials);
    let forward = [(1, 16), (2, 16), (2, 17)].map(|(seed, spp)| {
        let chosen = chosen(&scene, &tangent, seeded(seed, spp));
        assert_eq!((chosen.options.seed, chosen.options.spp), (seed, spp));
        method(chosen)
    });
    assert!(forward[0] == forward[1] && forward[1] == forward[2]);
    let prepared = PreparedScene::new(scene.clone());
    let [nothing, mut corner] = [0, 1].map(|_| Image::new(48, 36));
    corner.pixels[0] = Rgb::splat(3.0);
    let reverse = [(&nothing, 1), (&corner, 2)].map(|(adjoint, seed)| {
        let wanted = Wanted::by(&tangent);
        let work = BackwardWork::new(&prepared, adjoint, wanted, seeded(seed, 16));
        method(work.chosen(&Unwatched).expect("covered"))
    });
    assert!(reverse[0] == reverse[1]);
}

/// A choice that is kept spares the pilot, and is that of the work which was first; what is refused
/// is refused all the same.
#[test]
fn kept_choices_spare_pilots() {
    let (scene, tangent) = built_in("lattice-shadow");
    let prepared = PreparedScene::new(scene);
    let kept = KeptChoice::default();
    let ask = |options: GradientOptions| {
        let work = GradientWork::new(&prepared, Cow::Borrowed(&tangent), options);
        let watch = StopsAfter(0.into(), u64::MAX);
        let chosen = work.keeping(kept.clone()).chosen(&watch);
        (chosen, watch.0.into_inner())
    };
    let (first, asked) = ask(options(16));
    let first = first.expect("covered");
    assert!(asked > 2048, "{asked}");
    let other = GradientOptions::new(RenderOptions::new(3, 7));
    let (second, asked) = ask(other);
    let second = second.expect("covered");
    assert!(asked < 2, "{asked}");
    assert_eq!(second.trials, first.trials);
    let method = first.options.method;
    assert_eq!(
        second.options,
        GradientOptions {
            method,
            walk: first.options.walk,
            ..other
        }
    );
    let mut refused = options(16);
    refused.walk.max_radius = -1.0;
    assert!(ask(refused).0.is_err());
}

/// Lights without extent have shadows whose edges are gathered, in reverse mode, too.
#[test]
fn lights_that_move_are_tried() {
    let mut scene = with(triangle());
    let intensity = scene.add_texture(Texture::number("intensity", 1.0));
    scene.emitters.push(Emitter::Point {
        id: "bulb".into(),
        position: Vec3::new(0.2, 0.1, 3.0),
        intensity,
    });
    let wanted = Wanted::by(&tangent(&scene, "bulb.translate.x"));
    let [width, height] = scene.film.crop_size.map(|side| side as usize);
    let adjoint = Image::new(width, height);
    let prepared = PreparedScene::new(scene);
    let work = BackwardWork::new(&prepared, &adjoint, wanted, options(64));
    let chosen = work.chosen(&Unwatched).expect("covered");
    assert!(chosen.options.method.traits().gathers.camera, "{chosen:?}");
}

/// Nothing is tried where no curve in the image moves.
#[test]
fn colours_need_no_choice() {
    let scene = with(triangle());
    let tangent = tangent(&scene, "floor.bsdf.reflectance.value");
    let chosen = chosen(&scene, &tangent, options(4));
    assert_eq!(
        (chosen.options.method, chosen.trials.len()),
        (Method::Walk, 0)
    );
}

/// Says "stop" from the `n`-th question on.
struct StopsAfter(AtomicU64, u64);

impl Watch for StopsAfter {
    fn progress(&self, _done: u64, _total: u64) {}
    fn should_stop(&self) -> bool {
        self.0.fetch_add(1, Ordering::Relaxed) >= self.1
    }
}

/// A pilot that is stopped leaves no choice behind.
#[test]
fn a_stopped_pilot_counts_for_nothing() {
    let (scene, tangent) = built_in("lattice-shadow");
    let prepared = PreparedScene::new(scene.clone());
    // What asks the watch from here on is the pilot.
    prepared.boundaries();
    let work = GradientWork::new(&prepared, Cow::Borrowed(&tangent), options(16));
    let stopped = work.chosen(&StopsAfter(0.into(), 1000)).expect("covered");
    let whole = work.chosen(&Unwatched).expect("covered");
    assert_ne!(stopped, whole);
    assert_eq!(whole, chosen(&scene, &tangent, options(16)));
}

/// A pilot narrows the walk's cutoff before a small emitter, and nothing else.
#[test]
fn the_cutoff_is_fitted() {
    let (scene, tangent) = built_in("lattice-shadow");
    let mut options = options(16);
    options.method = Method::FittedWalk;
    let chosen = chosen(&scene, &tangent, options);
    let prepared = PreparedScene::new(scene);
    assert_eq!(chosen.trials.len(), 2, "{chosen:?}");
    assert_eq!(chosen.options.method, Method::Walk);
    assert!(chosen.options.walk.max_radius < 0.5 * options.walk.max_radius);
    let fitted = gradient(&prepared, &tangent, &options, &Unwatched).expect("covered");
    let same = gradient(&prepared, &tangent, &chosen.options, &Unwatched).expect("covered");
    assert_eq!(fitted.gradient, same.gradient);
}

/// Beside a mirror that turns, walks towards surfaces looked five times better than gathered edges in a pilot, and a few
/// samples carried the result. None is tried now.
#[test]
fn edges_are_gathered_before_surfaces() {
    let mut scene = empty(v(0.6, -3.5, 1.8), v(0.1, 0.0, 0.5), 45.0, 64);
    paths(&mut scene, 4);
    add_floor(&mut scene, 6.0);
    let turned = |x: f64, z: f64| {
        let about = |axis, degrees: f64| Affine::rotate(axis, degrees.to_radians());
        about(v(0.0, 0.0, 1.0), z) * about(v(1.0, 0.0, 0.0), x)
    };
    // So that the camera does not see it in the mirror.
    let tilted = Affine::translate(v(0.2, -1.5, 2.2)) * turned(150.0, 0.0);
    let (mesh, normals) = rectangle(tilted * Affine::scale(v(0.5, 0.5, 1.0)));
    add(&mut scene, "lamp", mesh, normals, 0.0);
    light_up(&mut scene, 12.0);
    let upright = Affine::translate(v(0.1, 1.0, 1.0)) * turned(85.0, 7.0);
    let (mesh, normals) = rectangle(upright * Affine::scale(v(1.5, 0.9, 1.0)));
    add(&mut scene, "wall", mesh, normals, 0.0);
    make(&mut scene, "wall", |n| n.mirror());
    let high = Affine::translate(v(0.3, -0.6, 0.7)) * turned(23.0, 31.0);
    let (mesh, normals) = cube(high * Affine::scale(Vec3::splat(0.25)));
    add(&mut scene, "thing", mesh, normals, 0.8);
    let motion = tangent(&scene, "wall.rotate.z");
    let options = options(64);
    let found = chosen(&scene, &motion, options);
    assert!(found.trials.len() > 2, "{found:?}");
    for trial in &found.trials {
        assert!(trial.method.traits().gathers.indirect, "{trial:?}");
    }
    let prepared = PreparedScene::new(scene);
    for seed in 1..5 {
        let mut options = found.options;
        options.seed = seed;
        let result = gradient(&prepared, &motion, &options, &Unwatched).expect("covered");
        let errors = result.gradient.standard_error.pixels;
        let squares: f64 = errors.iter().map(|error| error.dot(*error)).sum();
        let variance = squares / errors.len() as f64 * f64::from(options.spp);
        println!("seed {seed}: {variance}");
        assert!(variance < 5.0, "seed {seed}: {variance}");
    }
}

/// Beside a flat mirror walks towards surfaces are preferred only where what moves is glossy itself: by a glossy floor they had a
/// variance of 0.2 to 22 by seed, and gathered edges have 0.06 to 0.4.
#[test]
fn gloss_beside_mirrors_walks_where_it_moves_itself() {
    let (mut scene, _) = built_in("ball");
    paths(&mut scene, 3);
    let place = Affine::translate(v(0.0, 0.8, -2.0)) * Affine::scale(v(2.0, 0.6, 1.0));
    let (mesh, normals) = rectangle(place);
    add(&mut scene, "wall", mesh, normals, 0.0);
    make(&mut scene, "wall", |n| n.mirror());
    for (metal, walks) in [("floor", false), ("ball", true)] {
        let scene = of_metal(scene.clone(), metal);
        let motion = tangent(&scene, "ball.translate.x");
        let found = chosen(&scene, &motion, options(32));
        assert!(found.trials.len() > 2, "{found:?}");
        let mut trials = found.trials.iter();
        let tried = trials.any(|trial| !trial.method.traits().gathers.indirect);
        assert_eq!(tried, walks, "{metal}: {found:?}");
    }
}

/// Few pixels have the outline of a box, and nearly all of the noise: many points there cost little.
#[test]
fn outlines_get_many_points() {
    let (scene, motion) = built_in("box-room");
    let found = chosen(&scene, &motion, options(256));
    let Method::Edges(gathers) = found.options.method else {
        panic!("{found:?}");
    };
    assert_eq!(gathers.camera_points, 16, "{found:?}");
    let prepared = PreparedScene::new(scene);
    let [many, one] = [16, 1].map(|camera_points| {
        let method = Method::Edges(Gathers {
            camera_points,
            ..gathers
        });
        let options = GradientOptions {
            method,
            ..options(16)
        };
        let result = gradient(&prepared, &motion, &options, &Unwatched).expect("covered");
        let errors = result.gradient.standard_error.pixels;
        errors.iter().map(|error| error.dot(*error)).sum::<f64>()
    });
    assert!(many < 0.4 * one, "{many} {one}");
}

/// In reverse mode the choice depends on where the loss looks: only at shadows, or at what
/// the camera sees directly.
#[test]
fn reverse_mode_chooses_too() {
    let (scene, _) = built_in("lattice-shadow");
    let prepared = PreparedScene::new(scene.clone());
    let mut adjoint = Image::new(48, 36);
    adjoint.pixels.fill(Rgb::splat(1.0));
    let work = BackwardWork::new(&prepared, &adjoint, Wanted::all(&scene), options(16));
    let chosen = work.chosen(&Unwatched).expect("covered");
    assert!(
        chosen.options.method.traits().gathers.emitters,
        "{chosen:?}"
    );
    let nothing = Wanted::by(&tangent(&scene, "floor.bsdf.reflectance.value"));
    let work = BackwardWork::new(&prepared, &adjoint, nothing, options(16));
    assert!(work.chosen(&Unwatched).expect("covered").trials.is_empty());
}

/// Against differences: shadows, silhouettes, light from surfaces.
#[test]
fn what_is_chosen_is_right() {
    let automatic = |case: Case| Case {
        method: Method::Auto,
        ..case
    };
    let scene = with(triangle());
    let tangent_of = |scene: &Scene, expression| tangent(scene, expression);
    let motion = tangent_of(&scene, "thing.translate.x");
    let case = Case {
        // A longer step blurs more than there is noise.
        step: 1e-2,
        gradient_spp: 32,
        min_pixels: 500,
        ..Case::default()
    };
    agree("shadow", scene, &motion, automatic(case));
    let scene = visible_ball(Filter::Box);
    let motion = tangent_of(&scene, "ball.translate.x");
    let case = Case {
        gradient_spp: 80,
        reference_spp: 600,
        min_pixels: 700,
        ..primary()
    };
    agree("silhouette", scene, &motion, automatic(case));
}
