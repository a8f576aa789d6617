//! Runs a gradient and its finite differences, and demands agreement.

use capwalk_diff::check::{Comparison, Verdict, compare};
use capwalk_diff::{
    GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, WalkSettings,
    finite_difference, gradient,
};
use capwalk_scene::*;

/// Sizes and seeds of a case.
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
    agree_by(&[case.method], name, scene, tangent, case);
}

/// A factor that is wrong by this is excluded at two standard errors, where a part of the samples is
/// drawn; where all are, one of a tenth is.
const SEEN_BY_PART: f64 = 0.2;

/// Runs several methods, and demands agreement with one reference. `CAPWALK_ALL_SAMPLES` asks for all
/// samples; `cargo xtask soak` does.
pub fn agree_by(methods: &[Method], name: &str, mut scene: Scene, tangent: &Tangent, case: Case) {
    scene.film.size = [case.size; 2];
    scene.film.crop_size = [case.size; 2];
    scene.check().expect("a valid scene");
    let middle = match case.one_sided {
        true => scene.moved(tangent, case.step),
        false => scene.clone(),
    };
    let mut methods = methods.to_vec();
    // Samples are divided by these, by one after the other until all methods agree.
    let parts: &[u32] = match std::env::var_os("CAPWALK_ALL_SAMPLES") {
        None => &[4, 2, 1],
        Some(_) => &[1],
    };
    for &part in parts {
        let options = |spp: u32, seed: u64| RenderOptions::new(spp / part, seed);
        let reference = finite_difference(
            &PreparedScene::new(middle.clone()),
            tangent,
            case.step,
            &options(case.reference_spp, 2),
            &Unwatched,
        )
        .expect("covered");
        methods.retain(|&method| {
            let settings = GradientOptions {
                method,
                walk: case.walk,
                ..GradientOptions::new(options(case.gradient_spp, 1))
            };
            let ours = gradient(
                &PreparedScene::new(scene.clone()),
                tangent,
                &settings,
                &Unwatched,
            )
            .expect("covered");
            assert_eq!(
                ours.statistics.non_finite + reference.statistics.non_finite,
                0,
                "{name}"
            );
            let result = compare(&ours.gradient, &reference.gradient);
            println!(
                "{name}, {}, 1/{part} of the samples: {result}, worst {:?}",
                method.name(),
                result.worst.first()
            );
            let wrong = wrong(&result, case, part);
            assert!(
                part > 1 || wrong.is_none(),
                "{name}: {}",
                wrong.unwrap_or_default()
            );
            wrong.is_some()
        });
        if methods.is_empty() {
            return;
        }
    }
}

/// In which respect a derivative does not agree with its reference by a part of the samples, if it
/// does not.
fn wrong(result: &Comparison, case: Case, part: u32) -> Option<String> {
    let off = (result.scale_factor - 1.0).abs();
    let tells = part > 1 && off + 2.0 * result.scale_factor_error <= SEEN_BY_PART;
    match &result.verdict {
        Verdict::Right => {}
        Verdict::Inconclusive { doubt: None, .. } if tells => {}
        Verdict::Inconclusive { samples_factor, .. } if *samples_factor <= case.patience => {}
        verdict => return Some(format!("{verdict:?}")),
    }
    let (pixels, z2, sign) = (result.pixels, result.mean_z_squared, result.sign);
    if pixels < case.min_pixels {
        Some(format!("only {pixels} pixels have noise"))
    } else if !(0.8..=1.25).contains(&z2) {
        Some(format!("mean z² {z2}"))
    } else if sign.abs() >= 4.0 {
        Some(format!("systematic sign {sign}"))
    } else {
        None
    }
}

pub fn tangent(scene: &Scene, expression: &str) -> Tangent {
    params::Registry::new(scene)
        .tangent(scene, expression)
        .expect("a known name")
}
