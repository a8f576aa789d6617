//! Gradients against finite differences: the numbers of materials, where they
//! are at their limits and in textures; things that move are in `tests/scenes`.
//! What is demanded of each case, and how often it raises a false alarm, is said
//! in `phenomena_shadows.rs`.

use crate::common::agree::*;
use crate::common::materials::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::check::{Verdict, compare};
use capwalk_diff::{GradientOptions, PreparedScene, RenderOptions, Unwatched, gradient};
use capwalk_math::Affine;
use capwalk_scene::lobe::Distribution;
use capwalk_scene::primitive::rectangle;
use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
use capwalk_scene::*;

/// A floor of some material with a thing on it, under an emitter, and an emitter below.
fn sample_of<B: Into<Bsdf>>(material: impl FnOnce(&mut Slots) -> B) -> Scene {
    let mut scene = empty(v(0.3, -2.0, 2.5), v(0.0, 0.0, 0.0), 40.0, 36);
    add_floor(&mut scene, 3.0);
    add_emitter(&mut scene, v(0.1, 0.5, 2.5), 1.5, 0.3, 4.0);
    let (below, normals) = rectangle(Affine::translate(v(0.5, 0.5, -2.0)));
    add(&mut scene, "below", below, normals, 0.0);
    light_up(&mut scene, 3.0);
    add(&mut scene, "thing", small_ball(), ShadingNormals::Face, 0.6);
    make(&mut scene, "floor", material);
    paths(&mut scene, 3);
    scene
}

/// Numbers of the floor's material change, nothing moves.
fn numbers_change(name: &str, scene: Scene, expression: &str, gradient_spp: u32) {
    let along = tangent(&scene, expression);
    let case = Case {
        step: 1e-2,
        gradient_spp,
        reference_spp: 2 * gradient_spp,
        min_pixels: 900,
        ..Case::default()
    };
    agree(&format!("{name}, {expression}"), scene, &along, case);
}

#[test]
fn numbers_of_a_rough_metal() {
    let metal = |n: &mut Slots| rough_metal(n.copper(), n.facets(Distribution::Ggx, 0.3));
    for name in ["eta", "k", "specular_reflectance"] {
        let expression = format!("floor.bsdf.{name}.value");
        numbers_change(name, sample_of(metal), &expression, 60);
    }
}

#[test]
fn numbers_of_rough_glass() {
    let glass = |n: &mut Slots| rough_glass(n.glass(), n.facets(Distribution::Beckmann, 0.3));
    let expression = "floor.bsdf.int_ior.value + 0.3*floor.bsdf.alpha.value \
                      - 0.2*floor.bsdf.specular_transmittance.value";
    for expression in [expression, "floor.bsdf.ext_ior.value"] {
        numbers_change("rough glass", sample_of(glass), expression, 100);
    }
}

#[test]
fn numbers_of_plastic() {
    let plastic = |n: &mut Slots| n.coat(true);
    let expression = "floor.bsdf.int_ior.value + 0.5*floor.bsdf.diffuse_reflectance.value";
    numbers_change("plastic", sample_of(plastic), expression, 200);
}

#[test]
fn numbers_of_rough_plastic() {
    let rough =
        |n: &mut Slots| rough_plastic(n.coat(false), Distribution::Ggx, n.number("alpha", 0.25));
    for name in ["alpha", "int_ior"] {
        let expression = format!("floor.bsdf.{name}.value");
        numbers_change("rough plastic", sample_of(rough), &expression, 60);
    }
}

#[test]
fn numbers_of_principled() {
    let principled = |n: &mut Slots| n.principled(0.4);
    for expression in [
        "floor.bsdf.roughness.value + 0.5*floor.bsdf.base_color.value",
        "floor.bsdf.metallic.value - 0.3*floor.bsdf.spec_trans.value + 0.2*floor.bsdf.eta.value",
    ] {
        numbers_change("principled", sample_of(principled), expression, 100);
    }
    // Where a number decides what is drawn, differences are noisy. It depends on
    // these almost linearly, so that steps can be long.
    for (expression, step, gradient_spp) in [
        ("floor.bsdf.clearcoat.value", 0.4, 100),
        // A narrow lobe, which few samples meet.
        ("floor.bsdf.clearcoat_gloss.value", 0.045, 400),
        ("floor.bsdf.anisotropic.value", 0.1, 100),
        (
            "floor.bsdf.flatness.value + floor.bsdf.spec_tint.value + floor.bsdf.sheen.value",
            0.1,
            100,
        ),
    ] {
        let case = Case {
            step,
            gradient_spp,
            reference_spp: 3 * gradient_spp,
            min_pixels: 900,
            ..Case::default()
        };
        let scene = sample_of(principled);
        let along = tangent(&scene, expression);
        agree(expression, scene, &along, case);
    }
}

#[test]
fn numbers_of_principled_thin() {
    let thin = |n: &mut Slots| n.principled_thin();
    for expression in [
        "floor.bsdf.roughness.value + 0.5*floor.bsdf.base_color.value",
        "floor.bsdf.diff_trans.value - 0.3*floor.bsdf.spec_trans.value + 0.2*floor.bsdf.eta.value",
        "floor.bsdf.flatness.value + floor.bsdf.spec_tint.value + floor.bsdf.sheen.value",
    ] {
        numbers_change("principled thin", sample_of(thin), expression, 100);
    }
}

#[test]
fn numbers_of_polarized_plastic() {
    let plastic =
        |n: &mut Slots| polarized_plastic(n.coat(false), n.facets(Distribution::Beckmann, 0.3));
    let expression = "floor.bsdf.int_ior.value + 0.5*floor.bsdf.diffuse_reflectance.value \
                      + 0.3*floor.bsdf.alpha.value";
    numbers_change("polarized plastic", sample_of(plastic), expression, 100);
}

fn masked_floor(opacity: f64) -> Scene {
    sample_of(|n| Bsdf::Mask {
        opacity: n.number("opacity", opacity),
        nested: n.diffuse("first", [0.8, 0.2, 0.1]),
    })
}

/// Where there is all of a material or nothing of it, differences would need
/// numbers that are not allowed. Paths that meet it once are linear in how much
/// there is: the derivative is the same everywhere.
#[test]
fn weights_at_their_limits() {
    let derivative = |scene: &Scene, name: &str, seed: u64| {
        let settings = GradientOptions::new(RenderOptions::new(200, seed));
        let result = gradient(
            &PreparedScene::new(scene.clone()),
            &tangent(scene, name),
            &settings,
            &Unwatched,
        );
        result.expect("covered").gradient
    };
    let same = |name: &str, half: Scene, limit: Scene, parameter: &str| {
        let half = derivative(&half, parameter, 1);
        let result = compare(&derivative(&limit, parameter, 2), &half);
        assert_eq!(result.verdict, Verdict::Right, "{name}: {result:?}");
        assert!(result.pixels >= 900, "{name}: {} pixels", result.pixels);
    };
    let opacity = "floor.bsdf.opacity.value";
    for limit in [0.0, 1.0] {
        same("mask", masked_floor(0.5), masked_floor(limit), opacity);
    }
    let glass = |part: f64| sample_of(|n| n.principled(part));
    let spec_trans = "floor.bsdf.spec_trans.value";
    same("glass", glass(0.5), glass(0.0), spec_trans);
}

/// A texture of ends of its range, in blocks, and a motion that takes them inside.
fn at_the_ends(scene: &mut Scene, id: &str, ends: [f64; 2]) -> Tangent {
    let index = scene.textures.iter().position(|texture| texture.id == id);
    let index = index.expect("a texture");
    let texture = scene.texture_mut(TextureId(index as u32));
    texture.pattern = Pattern::Bitmap(Bitmap {
        width: 4,
        height: 4,
        filter: TexelFilter::Bilinear,
        wrap: Wrap::Clamp,
        to_uv: UvTransform::IDENTITY,
    });
    texture.data = (0..16).map(|i| ends[i / 2 % 2]).collect();
    let inside = |&x: &f64| if x < 0.5 { 1.0 } else { -1.0 };
    let velocities = texture.data.iter().map(inside).collect();
    let mut tangent = Tangent::zero(scene);
    tangent.textures[index] = Some(velocities);
    tangent
}

/// Derivatives by texels where there is all of something or nothing of it, against
/// differences towards the inside. Paths that meet the floor once are linear in
/// them.
fn texels_at_the_ends(name: &str, mut scene: Scene, ends: [f64; 2]) {
    unit_square(&mut scene, "floor");
    let tangent = at_the_ends(&mut scene, &format!("floor.bsdf.{name}"), ends);
    let case = Case {
        step: 0.125, // sums of it are exact, and stay inside
        one_sided: true,
        gradient_spp: 50,
        reference_spp: 150,
        min_pixels: 900,
        ..Case::default()
    };
    agree(&format!("{name} from {ends:?}"), scene, &tangent, case);
}

#[test]
fn texels_without_glass_or_metal() {
    let principled = || sample_of(|n| n.principled(0.4));
    texels_at_the_ends("spec_trans", principled(), [0.0, 0.0]);
    texels_at_the_ends("spec_trans", principled(), [0.0, 0.5]);
    texels_at_the_ends("metallic", principled(), [0.0, 1.0]);
}

#[test]
fn texels_without_sheen_or_coat() {
    let principled = || sample_of(|n| n.principled(0.0));
    texels_at_the_ends("clearcoat", principled(), [0.0, 0.0]);
    texels_at_the_ends("sheen", principled(), [0.0, 1.0]);
}

#[test]
fn texels_of_weights() {
    texels_at_the_ends("opacity", masked_floor(0.5), [0.0, 1.0]);
    let blend = sample_of(|n| Bsdf::Blend {
        weight: n.number("weight", 0.3),
        nested: [
            n.diffuse("first", [0.8, 0.2, 0.1]),
            n.diffuse("second", [0.1, 0.4, 0.7]),
        ],
    });
    texels_at_the_ends("weight", blend, [0.0, 1.0]);
}
