//! Runs a gradient, and demands agreement with finite differences that are kept.

use std::collections::BTreeSet;
use std::sync::Mutex;

use capwalk_diff::check::{Verdict, compare};
use capwalk_diff::{
    Estimate, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, WalkSettings,
    finite_difference, gradient,
};
use capwalk_scene::*;

use super::store::{Reference, plain};

/// Sizes of a case. Of a derivative with little noise few samples are enough: then the noise of its
/// reference decides.
#[derive(Clone, Copy)]
pub struct Case {
    pub size: u32,
    pub gradient_spp: u32,
    pub reference_spp: u32,
    pub step: f64,
    /// Differences between the scene and two steps on, where steps back are not
    /// allowed.
    pub one_sided: bool,
    pub method: Method,
    pub walk: WalkSettings,
    /// Pixels that must have noise.
    pub min_pixels: usize,
    /// By what factor more samples the verdict may want before it says "right",
    /// where derivatives have heavy tails.
    pub patience: f64,
}

impl Default for Case {
    fn default() -> Self {
        Self {
            size: 36,
            gradient_spp: 200,
            reference_spp: 512,
            step: 3e-2,
            one_sided: false,
            method: Method::Walk,
            walk: WalkSettings::default(),
            min_pixels: 1000,
            patience: 1.0,
        }
    }
}

/// For the silhouette of a visible thing, which crosses pixels: short steps, so
/// that the difference does not run over whole pixels.
pub fn primary() -> Case {
    Case {
        size: 46,
        step: 4e-3,
        gradient_spp: 160,
        reference_spp: 480,
        ..Case::default()
    }
}

/// Runs both and demands agreement.
pub fn agree(name: &str, scene: Scene, tangent: &Tangent, case: Case) {
    agree_by(
        &[(case.method, case.gradient_spp)],
        name,
        scene,
        tangent,
        case,
    );
}

/// Runs several methods, each with its samples per pixel, and demands agreement with one reference.
pub fn agree_by(
    methods: &[(Method, u32)],
    name: &str,
    mut scene: Scene,
    tangent: &Tangent,
    case: Case,
) {
    scene.film.size = [case.size; 2];
    scene.film.crop_size = [case.size; 2];
    scene.check().expect("a valid scene");
    let reference = reference(name, &scene, tangent, case);
    for &(method, spp) in methods {
        let settings = GradientOptions {
            method,
            walk: case.walk,
            ..GradientOptions::new(RenderOptions::new(spp, 1))
        };
        let ours = gradient(
            &PreparedScene::new(scene.clone()),
            tangent,
            &settings,
            &Unwatched,
        )
        .expect("covered");
        assert_eq!(ours.statistics.non_finite, 0, "{name}");

        let result = compare(&ours.gradient, &reference);
        println!(
            "{name}, {}: {result}, worst {:?}",
            method.name(),
            result.worst[0]
        );
        match result.verdict {
            Verdict::Inconclusive { samples_factor, .. } if samples_factor <= case.patience => {}
            verdict => assert_eq!(verdict, Verdict::Right, "{name}"),
        }
        assert!(
            result.pixels >= case.min_pixels,
            "{name}: only {} pixels have noise",
            result.pixels
        );
        // What is rare and large raises the error together with the value: z² is small then.
        let least = if case.patience >= 10.0 { 0.6 } else { 0.8 };
        let z2 = result.mean_z_squared;
        assert!((least..=1.25).contains(&z2), "{name}: mean z² {z2}");
        assert!(
            result.sign.abs() < 4.0,
            "{name}: systematic sign {}",
            result.sign
        );
    }
}

/// The differences that are kept under this name.
fn reference(name: &str, scene: &Scene, tangent: &Tangent, case: Case) -> Estimate {
    static NAMES: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    let is_new = NAMES
        .lock()
        .expect("nothing panics in it")
        .insert(name.to_owned());
    assert!(is_new, "two tests have a reference \"{name}\"");
    let kept = Reference {
        name: format!("{}_{}", env!("CARGO_CRATE_NAME"), plain(name)),
        of: name,
        step: case.step,
        spp: case.reference_spp,
    };
    kept.get(|spp| {
        let middle = match case.one_sided {
            true => scene.moved(tangent, case.step),
            false => scene.clone(),
        };
        let differences = finite_difference(
            &PreparedScene::new(middle),
            tangent,
            case.step,
            &RenderOptions::new(spp, 2),
            &Unwatched,
        );
        let differences = differences.expect("covered");
        assert_eq!(differences.statistics.non_finite, 0, "{name}");
        differences.gradient
    })
}

pub fn tangent(scene: &Scene, expression: &str) -> Tangent {
    params::Registry::new(scene)
        .tangent(scene, expression)
        .expect("a known name")
}
