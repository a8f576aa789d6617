//! What has no derivative is found and refused.

use crate::common::agree::tangent;
use crate::common::materials::*;
use crate::common::refused::{checkered_floor, mirror_floor, refusals_with};
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, gradient};
use capwalk_geometry::Mesh;
use capwalk_math::Affine;
use capwalk_scene::lobe::{Distribution, Principled};
use capwalk_scene::primitive::rectangle;
use capwalk_scene::*;

/// Why forward and reverse mode refuse, if they do.
fn refusals(scene: &Scene, tangent: &Tangent) -> [Option<String>; 2] {
    refusals_with(scene, tangent, Method::default())
}

/// What moves behind a blend of two glasses has two images by the same events; colours there have derivatives.
#[test]
fn motion_behind_a_blend_of_glasses() {
    let mut scene = shadow_stage();
    (scene.film.size, scene.film.crop_size) = ([4; 2], [4; 2]);
    make(&mut scene, "floor", |n| {
        let glass = n.glass();
        let nested = ["first", "second"].map(|name| n.part(name, glass));
        let weight = n.number("weight", 0.5);
        Bsdf::Blend { weight, nested }
    });
    for (name, why) in [
        ("lamp.translate.x", "refract or reflect light in different"),
        ("lamp.emitter.radiance.value", ""),
    ] {
        for reason in refusals(&scene, &tangent(&scene, name)) {
            let reason = reason.unwrap_or_default();
            let is_right = reason.contains(why) && reason.is_empty() == why.is_empty();
            assert!(is_right, "{name}: {reason}");
        }
    }
}

/// So has what moves before a blend of two mirrors if one of them has other normals, but not before two plain ones.
#[test]
fn motion_before_a_blend_of_mirrors() {
    for has_map in [false, true] {
        let mut scene = shadow_stage();
        (scene.film.size, scene.film.crop_size) = ([4; 2], [4; 2]);
        unit_square(&mut scene, "floor");
        make(&mut scene, "floor", |n| {
            let mirror = n.mirror();
            let mut nested = ["first", "second"].map(|name| n.part(name, mirror));
            if has_map {
                let mapped = n.normal_map(nested[1]);
                nested[1] = n.part("mapped", mapped);
            }
            let weight = n.number("weight", 0.5);
            Bsdf::Blend { weight, nested }
        });
        for reason in refusals(&scene, &tangent(&scene, "lamp.translate.x")) {
            let is_refused = reason.is_some_and(|reason| reason.contains("has two images"));
            assert_eq!(is_refused, has_map);
        }
    }
}

/// The plane in which the film of an orthographic sensor lies cuts what it passes
/// through, too.
#[test]
fn surface_cut_by_the_film() {
    let mut scene = visible_cube();
    let run = |scene: &Scene| refusals(scene, &tangent(scene, "thing.translate.x"));
    scene.sensor.model = SensorModel::Orthographic;
    assert_eq!(run(&scene), [None, None]);
    let [.., forward] = scene.sensor.state().axes;
    scene.sensor.world_from_camera.translation += forward * 4.2;
    scene.sensor.near_clip = 0.0;
    for reason in run(&scene) {
        let reason = reason.expect("refused");
        assert!(reason.contains("near_clip of 0 cuts"), "{reason}");
    }
}

/// Square roots and hues of what is black have no derivative with respect to it.
#[test]
fn numbers_without_a_derivative() {
    let run = |base: [f64; 3], glass: f64, name: &str| {
        let mut scene = shadow_stage();
        (scene.film.size, scene.film.crop_size) = ([4; 2], [4; 2]);
        make(&mut scene, "floor", |n| Principled {
            base_color: n.colour("base_color", base),
            ..n.principled(glass)
        });
        let tangent = tangent(&scene, &format!("floor.bsdf.{name}.value"));
        refusals(&scene, &tangent).map(|reason| reason.unwrap_or_default())
    };
    for (base, glass, name, why) in [
        ([0.5, 0.0, 0.5], 0.4, "base_color", "square root"),
        ([0.0, 0.0, 0.0], 0.0, "base_color", "hue"),
        ([0.5, 0.0, 0.5], 0.0, "base_color", ""),
        ([0.5, 0.2, 0.5], 0.4, "base_color", ""),
        ([0.0, 0.0, 0.0], 0.4, "roughness", ""),
    ] {
        for reason in run(base, glass, name) {
            let is_right = reason.contains(why) && reason.is_empty() == why.is_empty();
            assert!(is_right, "{base:?} {glass} {name}: {reason}");
        }
    }
}

/// Lines where textures are discontinuous are boundaries, if there are not too many of them.
#[test]
fn motion_beside_discontinuous_textures() {
    for (squares, method, why) in [
        (4.0, Method::Walk, ""),
        (4.0, Method::EDGES, ""),
        (1e7, Method::Walk, "lines"),
    ] {
        let scene = checkered_floor(squares);
        for reason in refusals_with(&scene, &tangent(&scene, "lamp.translate.x"), method) {
            let reason = reason.unwrap_or_default();
            let is_right = reason.contains(why) && reason.is_empty() == why.is_empty();
            assert!(is_right, "{squares} {method:?}: {reason}");
        }
    }
}

/// Maps that cut light off inside faces are refused when the cuts move: by the
/// numbers of the map, by what moves, and not by anything else.
#[test]
fn maps_that_cut_light_off() {
    let run = |flip_invalid: bool, shadowing: bool, name: &str| {
        let mut scene = shadow_stage();
        (scene.film.size, scene.film.crop_size) = ([4; 2], [4; 2]);
        unit_square(&mut scene, "floor");
        make(&mut scene, "floor", |n| {
            let nested = n.diffuse("nested", [0.5; 3]);
            n.normal_map(nested)
        });
        add(&mut scene, "thing", triangle(), ShadingNormals::Face, 0.5);
        make(&mut scene, "thing", |n| n.glass());
        for material in &mut scene.materials {
            if let Bsdf::NormalMap { limits, .. } = &mut material.bsdf {
                (limits.flip_invalid, limits.shadowing) = (flip_invalid, shadowing);
            }
        }
        refusals(&scene, &tangent(&scene, name)).map(|reason| reason.unwrap_or_default())
    };
    let (moves, bends, turns, colours) = (
        "lamp.translate.x",
        "thing.bsdf.int_ior",
        "floor.bsdf.normalmap.data",
        "lamp.emitter.radiance.value",
    );
    for (limits, name, why) in [
        ([true, true], moves, ""),
        ([true, true], turns, ""),
        ([false, true], moves, "`flip_invalid_normals`"),
        ([false, true], bends, "`flip_invalid_normals`"),
        ([false, true], turns, "`flip_invalid_normals`"),
        ([false, false], colours, ""),
        ([true, false], moves, "`use_shadowing_function`"),
        ([true, false], turns, ""),
    ] {
        for reason in run(limits[0], limits[1], name) {
            let is_right = reason.contains(why) && reason.is_empty() == why.is_empty();
            assert!(is_right, "{limits:?} {name}: {reason}");
        }
    }
}

/// A wall that the far plane cuts, seen only between posts.
#[test]
fn cuts_seen_between_posts_are_refused() {
    let scene = |posts: &[f64]| {
        let mut scene = empty(v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0), 40.0, 12);
        scene.sensor.far_clip = 5.0;
        let wall = Mesh {
            positions: vec![v(-60.0, 4.0, -4.0), v(60.0, 4.0, -4.0), v(0.0, 8.0, 12.0)],
            faces: vec![[0, 1, 2]],
        };
        add(&mut scene, "wall", wall, ShadingNormals::Face, 0.5);
        for (i, &x) in posts.iter().enumerate() {
            let place = Affine::translate(v(x, 2.0, 0.0))
                * Affine::rotate(v(1.0, 0.0, 0.0), 1.57)
                * Affine::scale(v(0.15, 3.0, 1.0));
            let (post, normals) = rectangle(place);
            add(&mut scene, &format!("post{i}"), post, normals, 0.5);
        }
        scene
    };
    let refused = |posts: &[f64]| {
        let reasons = refusals(&scene(posts), &tangent(&scene(posts), "wall.translate.x"));
        reasons.map(|reason| reason.is_some_and(|reason| reason.contains("far_clip")))
    };
    assert_eq!(refused(&[-0.73, 0.0, 0.73]), [true; 2]);
    // A fence without gaps.
    let fence: Vec<f64> = (-10..=10).map(|i| 0.2 * f64::from(i)).collect();
    assert_eq!(refused(&fence), [false; 2]);
}

/// A smooth sheet of brushed metal: texture coordinates say how it is brushed if they
/// span its faces.
#[test]
fn collapsed_texture_coordinates_say_nothing() {
    let mut scene = empty(v(0.0, -4.0, 0.0), v(0.0, 0.0, 0.0), 24.0, 8);
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let sheet = Mesh {
        positions: corners.map(|[x, z]| v(x, 0.0, z)).to_vec(),
        faces: vec![[0, 1, 2], [0, 2, 3]],
    };
    let normals = corners.map(|[_, z]| v(0.5, -0.7, 0.5 * z).normalized());
    let normals = ShadingNormals::Given(normals.to_vec());
    add(&mut scene, "sheet", sheet, normals, 0.5);
    add_emitter(&mut scene, v(0.1, 0.0, 3.0), 0.8, 0.3, 10.0);
    make(&mut scene, "sheet", |n| {
        let mut facets = n.facets(Distribution::Ggx, 0.05);
        facets.alpha_v = n.number("alpha_v", 0.5);
        rough_metal(n.copper(), facets)
    });
    let mut refused = |scale: f64| {
        let uvs = [[0, 1, 2], [0, 2, 3]].map(|face| face.map(|i| corners[i].map(|x| x * scale)));
        scene.shape_mut(ShapeId(0)).uvs = Some(uvs.to_vec());
        ["sheet.translate.z", "sheet.normals[2,0]"].map(|name| {
            let reasons = refusals(&scene, &tangent(&scene, name));
            reasons.map(|reason| reason.is_some_and(|reason| reason.contains("without extent")))
        })
    };
    assert_eq!(
        [refused(1.0), refused(0.0)],
        [[[false; 2]; 2], [[true; 2]; 2]]
    );
}

/// No steps make a discontinuous field (paper, Section 5.1), no angle makes none.
#[test]
fn walks_without_steps_or_reach() {
    let scene = mirror_floor();
    let tangent = tangent(&scene, "lamp.translate.x");
    let mut wanted = GradientOptions::new(RenderOptions::new(2, 1));
    let prepared = PreparedScene::new(scene);
    let refused = |wanted: &GradientOptions, expected: &str| {
        let refusal = gradient(&prepared, &tangent, wanted, &Unwatched);
        let refusal = refusal.expect_err("it is refused");
        assert!(refusal.to_string().starts_with(expected), "{refusal}");
    };
    for (steps, max_radius, expected) in [
        (
            0,
            0.2,
            "a walk of 0 steps gives a discontinuous velocity field",
        ),
        (1, 0.0, "the largest angle of a walk is 0"),
    ] {
        wanted.walk.steps = steps;
        wanted.walk.max_radius = max_radius;
        refused(&wanted, expected);
    }
}
