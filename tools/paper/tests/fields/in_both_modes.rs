//! Reverse mode against forward mode with these fields: the same linear map, METHOD 5.

use crate::common::both_modes::{self, agree_by, everything, small};
use crate::common::materials::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{GradientOptions, PreparedScene};
use capwalk_math::{Affine, Rgb};
use capwalk_paper::fields::{
    AMONG_EXPLICIT_BOUNDARIES, ON_TRIANGLES, WasBoundary, WasSettings, psdr_was, was,
};
use capwalk_scene::primitive::cube;
use capwalk_scene::*;

/// A field of another kind, also across the borders of a box filter and before a
/// mirror, where it is biased in both modes alike.
#[test]
fn warped_area_sampling() {
    let mut scene = visible_ball(Filter::Box);
    make(&mut scene, "floor", |n| n.copper());
    small(&mut scene, 4);
    let tangent = everything(&scene, 11);
    let prepared = PreparedScene::new(scene);
    let debiased = WasSettings {
        boundary: WasBoundary::Normals,
        rays: 3,
        debias: true,
        ..WasSettings::default()
    };
    for settings in [WasSettings::default(), debiased] {
        for method in [was(settings), psdr_was(settings)] {
            let options = GradientOptions {
                method,
                ..both_modes::settings(6)
            };
            agree_by(method.name(), &prepared, &tangent, &options);
        }
    }
}

/// Fields on triangles, with surfaces that cross, directions that meet nothing, and
/// pixels that end abruptly.
#[test]
fn fields_on_triangles() {
    let mut scene = visible_cube();
    let (mesh, normals) = cube(Affine::scale(v(0.8, 0.2, 0.7)));
    add(&mut scene, "blade", mesh, normals, 0.4);
    let radiance = scene.add_texture(Texture::colour("sky.radiance", Rgb::new(0.5, 0.7, 1.0)));
    scene.emitters.push(Emitter::Constant {
        id: "sky".into(),
        radiance,
    });
    small(&mut scene, 4);
    let tangent = everything(&scene, 11);
    for (method, steps) in [
        (ON_TRIANGLES, 1),
        (ON_TRIANGLES, 2),
        (AMONG_EXPLICIT_BOUNDARIES, 1),
    ] {
        let mut options = both_modes::settings(32);
        options.method = method;
        options.walk.steps = steps;
        let name = format!("{}, M = {steps}", method.name());
        agree_by(
            &name,
            &PreparedScene::new(scene.clone()),
            &tangent,
            &options,
        );
    }
}
