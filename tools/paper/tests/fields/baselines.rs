//! Warped-area sampling keeps its promises, and breaks those that it is known to
//! break: derivatives of areas in the image, which have closed forms.

use crate::common::agree::tangent;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::check::{Verdict, compare};
use capwalk_diff::{
    Estimate, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, finite_difference,
    gradient,
};
use capwalk_math::{Affine, Vec3};
use capwalk_paper::fields::{WasBoundary, WasSettings, psdr_was, was};
use capwalk_scene::primitive::sphere;
use capwalk_scene::*;

/// Standard errors beyond which a difference is no accident.
const Z: f64 = 4.5;

fn options(spp: u32, seed: u64) -> RenderOptions {
    RenderOptions::new(spp, seed)
}

/// The derivative of the area by the size of the thing, see `relative_change`.
fn relative_growth(
    scene: &Scene,
    exact: f64,
    settings: WasSettings,
    spp: u32,
) -> (Estimate, (f64, f64)) {
    relative_change(scene, "thing.scale", exact, was(settings), spp)
}

/// The derivative of the image, and that of the area divided by what it is, with
/// its standard error.
fn relative_change(
    scene: &Scene,
    what: &str,
    exact: f64,
    method: Method,
    spp: u32,
) -> (Estimate, (f64, f64)) {
    let settings = GradientOptions {
        method,
        ..GradientOptions::new(options(spp, 1))
    };
    let growth = tangent(scene, what);
    let result = gradient(
        &PreparedScene::new(scene.clone()),
        &growth,
        &settings,
        &Unwatched,
    )
    .expect("covered");
    assert_eq!(result.statistics.non_finite, 0);
    let pixels = result.gradient.mean.pixels.iter();
    let errors = result.gradient.standard_error.pixels.iter();
    let sum: f64 = pixels.map(|p| p.r).sum();
    let error = errors.map(|p| p.r * p.r).sum::<f64>().sqrt();
    let (growth, error) = (sum / exact, error / exact.abs());
    println!("{method:?}: {growth:.4} ± {error:.4}");
    (result.gradient, (growth, error))
}

/// The bias falls with the number of auxiliary rays; with few of them it is there.
#[test]
fn more_rays_less_bias() {
    let scene = card();
    let bias = |rays: u32, antithetic: bool, spp: u32| {
        let settings = WasSettings {
            rays,
            antithetic,
            ..WasSettings::default()
        };
        let (_, (growth, error)) = relative_growth(&scene, 32.0, settings, spp);
        (growth - 1.0, error)
    };
    let [few, more, many] = [(8, 2000), (32, 2000), (128, 600)].map(|(n, spp)| bias(n, false, spp));
    assert!(few.0 < -0.2 && -few.0 > 10.0 * few.1, "{few:?}");
    assert!(
        more.0.abs() < 0.5 * few.0.abs() && -more.0 > Z * more.1,
        "{more:?}"
    );
    assert!(many.0.abs() < 0.5 * more.0.abs() + many.1, "{many:?}");
    assert!(many.0.abs() < Z * many.1 && many.1 < 0.03, "{many:?}");
    // Opposite pairs have a bias of their own.
    let [few, many] = [(8, 2000), (128, 600)].map(|(n, spp)| bias(n, true, spp));
    assert!(few.0 > 0.05 && few.0 > Z * few.1, "{few:?}");
    assert!(many.0.abs() < Z * many.1 && many.1 < 0.03, "{many:?}");
}

/// What finite differences say pixel by pixel, and how many standard errors the
/// change of the area is from what it is.
fn verdict(what: &str, exact: f64, settings: WasSettings, spp: u32) -> (Verdict, f64) {
    let scene = card();
    let change = tangent(&scene, what);
    let prepared = PreparedScene::new(scene.clone());
    let reference = finite_difference(&prepared, &change, 0.01, &options(60_000, 2), &Unwatched);
    let reference = reference.expect("covered").gradient;
    let (ours, (size, error)) = relative_change(&scene, what, exact, was(settings), spp);
    let result = compare(&ours, &reference);
    let (z, factor) = (result.mean_z_squared, result.scale_factor);
    println!(
        "{what}: mean z² {z:.2}, scale factor {factor:.3} ± {:.3}",
        result.scale_factor_error
    );
    (result.verdict, (size - 1.0) / error)
}

/// Roulette takes the bias away that is -28 % without: pixel by pixel, and in the
/// sum.
#[test]
fn roulette_removes_the_bias() {
    let with = |debias: bool| WasSettings {
        antithetic: false,
        debias,
        ..WasSettings::default()
    };
    let (biased, z) = verdict("thing.scale", 32.0, with(false), 1000);
    assert!(
        matches!(biased, Verdict::Wrong { .. }) && z < -10.0,
        "{biased:?}"
    );
    let (unbiased, z) = verdict("thing.scale", 32.0, with(true), 4000);
    assert!(
        unbiased == Verdict::Right && z.abs() < Z,
        "{unbiased:?}, {z}"
    );
}

/// A camera that comes nearer sees things grow, twice their area per distance; one
/// that goes sideways sees them go the other way.
#[test]
fn eyes_move() {
    let settings = WasSettings {
        rays: 64,
        ..WasSettings::default()
    };
    let nearer = -2.0 * 16.0 / 4.0;
    let (found, z) = verdict(
        "sensor.translate.z + 0.3*sensor.translate.x",
        nearer,
        settings,
        1200,
    );
    assert!(found == Verdict::Right && z.abs() < Z, "{found:?}, {z}");
}

/// Light from an emitter, whose edges the field knows, too, past something; all of
/// them move, and the ground under them. The size of the derivative, as seen by
/// weights that do not come from it.
#[test]
fn shadows_and_emitters() {
    let mut scene = with(triangle());
    scene.film.size = [12; 2];
    scene.film.crop_size = [12; 2];
    let everything = "thing.translate.x + 0.3*lamp.translate.y - 0.4*floor.translate.x";
    let tangent = tangent(&scene, everything);
    let prepared = PreparedScene::new(scene.clone());
    let reference = finite_difference(&prepared, &tangent, 0.03, &options(8000, 2), &Unwatched);
    let reference = reference.expect("covered").gradient;
    let by = |method, spp, seed| {
        let settings = GradientOptions {
            method,
            ..GradientOptions::new(options(spp, seed))
        };
        let result = gradient(
            &PreparedScene::new(scene.clone()),
            &tangent,
            &settings,
            &Unwatched,
        );
        result.expect("covered").gradient
    };
    let weights = by(Method::Walk, 200, 3).mean.pixels;
    let size = |image: &Estimate| {
        let pixels = image.mean.pixels.iter().zip(&image.standard_error.pixels);
        let terms = pixels
            .zip(&weights)
            .map(|((m, e), w)| (m.r * w.r, (e.r * w.r).powi(2)));
        let (sum, squares) = terms.fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
        (sum, squares.sqrt())
    };
    let (exact, exact_error) = size(&reference);
    let settings = WasSettings {
        kappa: 1e4,
        rays: 16,
        ..WasSettings::default()
    };
    let (ours, error) = size(&by(was(settings), 1500, 1));
    let (ratio, error) = (ours / exact, error.hypot(exact_error) / exact);
    println!("of differences: {ratio:.3} ± {error:.3}");
    assert!((ratio - 1.0).abs() < Z * error && error < 0.06);
}

/// Normals tell where smooth surfaces end, and not where flat ones do, however
/// many rays there are.
#[test]
fn normals_are_for_smooth_surfaces() {
    let settings = WasSettings {
        rays: 128,
        boundary: WasBoundary::Normals,
        ..WasSettings::default()
    };
    let (_, (growth, error)) = relative_growth(&card(), 32.0, settings, 600);
    assert!(1.0 - growth > 0.4 && error < 0.03);
    // The disk of a ball: of area 16, too, far away.
    let radius = half_width() * (16.0 / std::f64::consts::PI).sqrt() / 4.0;
    let (mesh, normals) = sphere(Affine::IDENTITY, Vec3::zero(), radius);
    let (_, (growth, error)) = relative_growth(&mask(mesh, normals), 32.0, settings, 600);
    assert!((growth - 1.0).abs() < Z * error + 0.02 && error < 0.03);
}

/// A black card before a white triangle that fills the image: what is seen of the
/// triangle shrinks when the card grows.
fn card_before_a_wall() -> Scene {
    let mut scene = card();
    let wall = capwalk_geometry::Mesh {
        positions: vec![v(-1.7, -1.3, -1.0), v(1.9, -1.1, -0.7), v(0.1, 1.8, -1.2)],
        faces: vec![[0, 1, 2]],
    };
    add(&mut scene, "wall", wall, ShadingNormals::Face, 1.0);
    let mut textures = scene.textures.iter_mut().map(std::sync::Arc::make_mut);
    let black = textures.find(|texture| texture.id == "thing.bsdf.reflectance");
    black.expect("a reflectance").data.fill(0.0);
    scene.settings.integrator = Integrator::Aov(Aov::Albedo);
    scene.check().expect("a valid scene");
    scene
}

/// In path space, too, the bias falls with the number of auxiliary rays, and roulette
/// removes it. A thing's own border does not move in its material: before nothing, there
/// is no bias, and no noise but that of the image.
#[test]
fn more_rays_less_bias_in_path_space() {
    let scene = card_before_a_wall();
    let bias = |rays: u32, debias: bool, spp: u32| {
        let settings = WasSettings {
            rays,
            debias,
            antithetic: false,
            ..WasSettings::default()
        };
        let method = psdr_was(settings);
        let (_, (growth, error)) = relative_change(&scene, "thing.scale", -32.0, method, spp);
        (growth - 1.0, error)
    };
    let [few, more, many] = [(8, 2000), (32, 2000), (128, 600)].map(|(n, spp)| bias(n, false, spp));
    assert!(few.0.abs() > Z * few.1, "{few:?}");
    assert!(more.0.abs() < 0.5 * few.0.abs(), "{few:?} {more:?}");
    assert!(many.0.abs() < Z * many.1 && many.1 < 0.03, "{many:?}");
    // Roulette is noisier here, but tells.
    let debiased = bias(8, true, 4000);
    assert!(debiased.0.abs() < 3.0 * debiased.1 && debiased.1 < 0.1);

    let own = psdr_was(WasSettings::default());
    let (_, (growth, error)) = relative_change(&card(), "thing.scale", 32.0, own, 800);
    assert!((growth - 1.0).abs() < Z * error && error < 0.02);
}
