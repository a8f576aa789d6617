//! The method that chooses: its choice, and that what it chose is right.

use std::borrow::Cow;
use std::sync::atomic::{AtomicU64, Ordering};

use capwalk_diff::{
    BackwardWork, Chosen, GradientOptions, GradientWork, Method, PreparedScene, RenderOptions,
    Unwatched, Wanted, Watch, gradient, with_threads,
};
use capwalk_math::Rgb;
use capwalk_scene::bsdf::{Facets, Metal};
use capwalk_scene::lobe::Distribution;
use capwalk_scene::{Bsdf, Filter, Image, Scene, Tangent, Texture, builtin};

use crate::common::agree::*;
use crate::common::stages::*;

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
            // Without the worst pixels, where one sample outweighs an image.
            squares.sort_by(f64::total_cmp);
            squares.truncate(squares.len() - squares.len() / 50);
            squares.iter().sum::<f64>() * trial.effort
        };
        let is_chosen = |trial: &&capwalk_diff::Trial| {
            let options = &chosen.options;
            trial.method == options.method && trial.max_radius == options.walk.max_radius
        };
        let own = chosen.trials.iter().find(is_chosen).expect("it was tried");
        let own = cost(own);
        for trial in &chosen.trials {
            let other = cost(trial);
            println!("{name}: {trial:?}: {:.3} of the chosen one", other / own);
            assert!(other > 0.5 * own, "{name}: {trial:?} is better");
        }
    }
}

/// The scene with one of its shapes of rough metal.
fn of_metal(mut scene: Scene, id: &str) -> Scene {
    let [eta, k, one, alpha] = [("eta", 0.2), ("k", 3.0), ("one", 1.0), ("alpha", 0.2)]
        .map(|(name, number)| scene.add_texture(Texture::number(name, number)));
    let metal = Metal {
        eta,
        k,
        specular_reflectance: one,
    };
    let facets = Facets {
        distribution: Distribution::Ggx,
        alpha: [alpha; 2],
    };
    let shape = scene.shapes.iter().find(|shape| shape.id == id);
    let id = shape.expect("it is there").bsdf;
    scene.materials[id.0 as usize].bsdf = Bsdf::RoughConductor(metal, facets);
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
        let work = GradientWork::new(&prepared, Cow::Borrowed(&moving), options(16));
        // Each sample asks whether to stop.
        let watch = StopsAfter(0.into(), u64::MAX);
        let chosen = work.chosen(&watch).expect("covered");
        let trials = &chosen.trials;
        let (mut samples, mut least) = (0, f64::INFINITY);
        for (i, trial) in trials.iter().enumerate() {
            let is_new = |other: &capwalk_diff::Trial| {
                (other.method, other.max_radius) != (trial.method, trial.max_radius)
            };
            assert!(trials[..i].iter().all(is_new), "{trial:?}");
            let is_hopeless = trial.cost() > 10.0 * least;
            short += usize::from(is_hopeless);
            samples += if is_hopeless { 512 } else { 2048 };
            least = least.min(trial.cost());
        }
        let asked = watch.0.into_inner();
        assert!(
            asked.abs_diff(samples) < 10,
            "{asked} of {samples}: {trials:?}"
        );
    }
    assert!(short > 0);
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

/// Against differences: shadows, outlines, light from surfaces.
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
    agree("outline", scene, &motion, automatic(case));
}
