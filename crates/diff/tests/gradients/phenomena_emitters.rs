//! An environment map that is black in places; the other phenomena under a sky
//! are in `tests/scenes`.

use crate::common::stages::*;
use capwalk_diff::{GradientOptions, PreparedScene, RenderOptions, Unwatched, gradient};
use capwalk_scene::*;

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
    scene.texture_mut(TextureId(sky as u32)).data[24..].fill(0.0);
    let mut change = Tangent::zero(&scene);
    change.textures[sky] = Some(vec![1.0; 96]);
    let options = RenderOptions::new(400, 1);
    let settings = GradientOptions::new(options);
    let sum = |estimate: &capwalk_diff::Estimate| -> f64 {
        estimate.mean.pixels.iter().map(|p| p.r).sum()
    };
    let ours = gradient(
        &PreparedScene::new(scene.clone()),
        &change,
        &settings,
        &Unwatched,
    )
    .expect("covered");
    // The image is linear in the sky's colours.
    let [before, after] = [scene.clone(), scene.moved(&change, 1.0)].map(|scene| {
        sum(&capwalk_diff::render(&PreparedScene::new(scene.clone()), &options, &Unwatched).value)
    });
    let (found, expected) = (sum(&ours.gradient), after - before);
    assert!((found / expected - 1.0).abs() < 0.03, "{found} {expected}");
}
