//! Gradients against finite differences, one scene per phenomenon: environment
//! maps and lights without extent. What is demanded of each case, and how often
//! it raises a false alarm, is said in `phenomena_shadows.rs`.

mod common;

use capwalk_math::{Affine, Vec3};
use capwalk_render::{GradientOptions, Options, Unwatched, WalkSettings, gradient};
use capwalk_scene::emitter::EnvironmentMap;
use capwalk_scene::*;
use common::agree::*;
use common::stages::*;
use common::*;

/// A sky of 8 x 4 colours, brighter above, instead of all lamps.
fn under_a_sky(mut scene: Scene) -> Scene {
    for shape in &mut scene.shapes {
        shape.emitter = None;
    }
    scene.shapes.retain(|shape| shape.id != "lamp");
    scene.emitters.clear();
    let number = |i: usize| 0.2 + ((i * i * 5 + i * 11) % 13) as f64 / 4.0;
    let data = scene.add_texture(Texture {
        id: "sky".into(),
        channels: 3,
        data: (0..96).map(number).collect(),
        pattern: Pattern::Environment,
    });
    let scale = scene.add_texture(Texture::number("sky.scale", 0.7));
    scene.emitters.push(Emitter::EnvironmentMap {
        id: "sky".into(),
        map: EnvironmentMap {
            width: 8,
            height: 4,
            world_from_map: Affine::rotate(v(1.0, 0.0, 0.0), 1.3),
        },
        data,
        scale,
    });
    scene.settings.integrator = Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters: false,
    };
    scene
}

fn visible(spp: u32) -> Case {
    Case {
        step: 4e-3,
        gradient_spp: spp,
        reference_spp: 2 * spp,
        ..Case::default()
    }
}

/// The shadow of a thing that moves under a sky, and the thing itself.
#[test]
fn occluder_under_a_sky() {
    let scene = under_a_sky(visible_cube());
    let motion = motion(&scene, "thing.translate.x + 0.5*thing.rotate.z");
    agree("occluder under a sky", scene, &motion, visible(600));
}

/// The camera turns: the sky moves through the picture.
#[test]
fn camera_turns_under_a_sky() {
    let mut scene = under_a_sky(visible_cube());
    *fov_x(&mut scene) = 1.2;
    scene.film.filter = Filter::Tent { radius: 1.0 };
    let motion = motion(&scene, "sensor.rotate.z + 0.5*sensor.rotate.x");
    agree("camera under a sky", scene, &motion, visible(800));
}

/// The texels of the sky and its factor.
#[test]
fn colours_of_a_sky() {
    let scene = under_a_sky(visible_cube());
    let mut motion = Motion::zero(&scene);
    for (texture, motion) in scene.textures.iter().zip(&mut motion.textures) {
        if texture.id.starts_with("sky") {
            let velocity = |i: usize| (i % 5) as f64 - 1.0;
            *motion = Some((0..texture.data.len()).map(velocity).collect());
        }
    }
    agree("colours of a sky", scene, &motion, visible(64));
}

/// Black texels, drawn by nothing but the map.
#[test]
fn colours_of_a_black_sky() {
    let mut scene = under_a_sky(visible_cube());
    scene.settings.integrator = Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 0,
        hide_emitters: true,
    };
    let sky = scene
        .textures
        .iter()
        .position(|t| t.id == "sky")
        .expect("a sky");
    scene.textures[sky].data[24..].fill(0.0);
    let mut change = Motion::zero(&scene);
    change.textures[sky] = Some(vec![1.0; 96]);
    let options = Options {
        spp: 400,
        seed: 1,
        threads: None,
    };
    let settings = GradientOptions {
        options,
        walk: WalkSettings::default(),
    };
    let sum = |estimate: &capwalk_render::Estimate| -> f64 {
        estimate.mean.pixels.iter().map(|p| p.x).sum()
    };
    let ours = gradient(&scene, &change, &settings, &Unwatched).expect("covered");
    // The picture is linear in the sky's colours.
    let [before, after] = [scene.clone(), scene.moved(&change, 1.0)]
        .map(|scene| sum(&capwalk_render::render(&scene, &options, &Unwatched).value));
    let (found, expected) = (sum(&ours.gradient), after - before);
    assert!((found / expected - 1.0).abs() < 0.03, "{found} {expected}");
}

fn under_a_spot() -> Scene {
    let mut scene = under_a_sky(visible_cube());
    scene.emitters.clear();
    let intensity = scene.add_texture(Texture::colour("spot.intensity", Vec3::splat(8.0)));
    let mut angle = |name: &str, value| scene.add_texture(Texture::number(name, value));
    let cutoff_angle = angle("spot.cutoff_angle", 23.0);
    let beam_width = angle("spot.beam_width", 11.5);
    let place = Affine::look_at(v(0.9, -0.6, 2.6), v(0.1, 0.0, 0.0), v(0.0, 1.0, 0.0));
    scene.emitters.push(Emitter::Spot {
        id: "spot".into(),
        world_from_emitter: place.expect("not along the up vector"),
        intensity,
        cutoff_angle,
        beam_width,
    });
    scene
}

/// Colours under a light without extent.
#[test]
fn reflectance_under_a_spot() {
    let scene = under_a_spot();
    let motion = motion(
        &scene,
        "floor.bsdf.reflectance.value - 2*thing.bsdf.reflectance.value",
    );
    let case = Case {
        min_pixels: 300,
        ..visible(500)
    };
    agree("reflectance under a spot", scene, &motion, case);
}

/// Where light falls off moves, but jumps nowhere.
#[test]
fn angles_of_a_spot() {
    let scene = under_a_spot();
    let motion = motion(&scene, "spot.cutoff_angle - 0.5*spot.beam_width");
    let case = Case {
        step: 0.1,
        min_pixels: 300,
        ..visible(500)
    };
    agree("angles of a spot", scene, &motion, case);
}

/// Hard shadows that move are refused by name.
#[test]
fn hard_shadows_are_refused() {
    let scene = under_a_spot();
    let settings = GradientOptions {
        options: Options {
            spp: 1,
            seed: 1,
            threads: None,
        },
        walk: WalkSettings::default(),
    };
    let motion = motion(&scene, "thing.translate.x");
    let refusal = gradient(&scene, &motion, &settings, &Unwatched).expect_err("hard shadows");
    assert!(refusal.reason.contains("\"spot\" (spot)"), "{refusal}");
}
