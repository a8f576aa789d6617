//! Light that arrives by way of curved mirrors and refracting glass, in both modes. (Differences of such images are in
//! the folders of `tests/scenes`.)

use crate::common::both_modes::{agree_by, everything, settings, small};
use crate::common::materials::*;
use crate::common::refused::mirror_floor;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{GradientOptions, Method, PreparedScene};
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::primitive::{cube, icosphere};
use capwalk_scene::*;

/// A cube beside or in a smooth ball under a sky.
fn beside_a_ball(thing: Vec3) -> Scene {
    let mut scene = empty(v(0.0, -4.0, 0.6), v(0.0, 0.0, 0.0), 24.0, 24);
    let ball = placed(icosphere(2), Affine::scale(Vec3::splat(0.6)));
    let normals = ShadingNormals::computed(&ball);
    add(&mut scene, "ball", ball, normals, 0.5);
    let turn = Affine::rotate(v(0.3, 0.2, 1.0), 0.6);
    let place = Affine::translate(thing) * turn * Affine::scale(Vec3::splat(0.2));
    let (thing, normals) = cube(place);
    add(&mut scene, "thing", thing, normals, 0.5);
    let radiance = scene.add_texture(Texture::colour("sky", Rgb::new(0.6, 0.7, 1.0)));
    scene.emitters.push(Emitter::Constant {
        id: "sky".into(),
        radiance,
    });
    scene
}

/// Forward and reverse mode are one linear map, also through chains: everything moves, by both methods.
#[test]
fn both_modes_are_one_map() {
    let mut mirror = beside_a_ball(v(-0.7, -1.0, -0.1));
    make(&mut mirror, "ball", |n| n.mirror());
    make(&mut mirror, "thing", |n| n.coat(false));
    let mut glassy = beside_a_ball(v(0.05, 0.0, 0.0));
    make(&mut glassy, "ball", |n| n.glass());
    let mut parallel = mirror.clone();
    parallel.sensor.model = SensorModel::Orthographic;
    for (name, mut scene) in [
        ("mirror", mirror),
        ("glass", glassy),
        ("parallel rays", parallel),
        ("smooth floor", mirror_floor()),
    ] {
        small(&mut scene, 5);
        let motion = everything(&scene, 7);
        let prepared = PreparedScene::new(scene);
        for method in [Method::Walk, Method::EDGES] {
            let settings = GradientOptions {
                method,
                ..settings(6)
            };
            let name = format!("{name} by {}", method.name());
            agree_by(&name, &prepared, &motion, &settings);
        }
    }
}
