//! What moves in curved mirrors and behind glass that refracts is found and
//! refused, however short the paths are; in flat mirrors it is not. So is what
//! has no derivative.

use std::borrow::Cow;

use crate::common::agree::tangent;
use crate::common::materials::*;
use crate::common::refused::{checkered_floor, mirror_floor, refusals_with};
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{
    AllowMissing, GradientOptions, GradientWork, Method, Part, PreparedScene, RenderOptions,
    Unwatched, gradient,
};
use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::lobe::{Dielectric, Distribution, Principled};
use capwalk_scene::number::Indices;
use capwalk_scene::primitive::{icosphere, rectangle};
use capwalk_scene::*;

/// True if both modes refuse, by name.
fn is_refused(scene: &Scene, name: &str) -> bool {
    let reasons = refusals(scene, &tangent(scene, name))
        .map(|reason| reason.is_some_and(|reason| reason.contains("specular")));
    assert_eq!(reasons[0], reasons[1], "{name}: only one mode refuses");
    reasons[0]
}

/// Why forward and reverse mode refuse, if they do.
fn refusals(scene: &Scene, tangent: &Tangent) -> [Option<String>; 2] {
    refusals_with(scene, tangent, Method::default())
}

#[test]
fn an_emitter_that_moves_in_a_mirror() {
    let mut scene = mirror_floor();
    assert!(is_refused(&scene, "lamp.translate.x"));
    assert!(is_refused(&scene, "sensor.translate.x"));
    assert!(is_refused(&scene, "floor.rotate.x"));
    assert!(!is_refused(&scene, "lamp.emitter.radiance.value"));
    scene.shape_mut(ShapeId(0)).normals = ShadingNormals::Face;
    assert!(!is_refused(&scene, "lamp.translate.x"));
}

/// A black ball hides the sky's reflection: it is met by the last segment, which
/// carries no light.
#[test]
fn a_blocker_that_moves_in_a_mirror() {
    let mut scene = mirror_floor();
    scene.shapes.pop();
    let radiance = scene.textures.len() as u32;
    scene.add_texture(Texture::colour("sky.radiance", Rgb::splat(1.0)));
    scene.emitters = vec![Emitter::Constant {
        id: "sky".into(),
        radiance: TextureId(radiance),
    }];
    // Above the image, seen in the mirror only.
    let mut ball = icosphere(4);
    ball.positions
        .iter_mut()
        .for_each(|p| *p = *p * 0.4 + v(0.0, 1.5, 1.6));
    add(&mut scene, "ball", ball, ShadingNormals::Face, 0.0);
    assert!(is_refused(&scene, "ball.translate.x"));
}

/// A thing behind the surface of a body of glass, lit through it.
fn blocker_in_glass(max_depth: u32) -> Scene {
    let mut scene = empty(v(0.0, -4.0, 0.5), v(0.0, 0.0, 0.0), 30.0, 12);
    add_floor(&mut scene, 3.0);
    add_emitter(&mut scene, v(0.0, 0.0, 3.0), 1.5, 0.3, 10.0);
    let pane = Affine::translate(v(0.0, 0.0, 0.8)) * Affine::scale(v(3.0, 3.0, 1.0));
    let (mesh, normals) = rectangle(pane);
    add(&mut scene, "pane", mesh, normals, 0.0);
    let mut number = |id: &str, x: f64| scene.add_texture(Texture::number(id, x));
    let glass = Bsdf::from(Dielectric {
        eta: Indices {
            int_ior: number("int_ior", 1.5),
            ext_ior: number("ext_ior", 1.0),
        },
        specular_reflectance: number("reflected", 1.0),
        specular_transmittance: number("transmitted", 1.0),
    });
    let shown = scene.shapes.last().expect("the pane").bsdf;
    scene.materials[shown.0 as usize].bsdf = glass;
    let thing = placed(triangle(), Affine::translate(Vec3::new(0.0, 0.0, 0.6)));
    add(&mut scene, "thing", thing, ShadingNormals::Face, 0.5);
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(max_depth),
        rr_depth: 5,
        hide_emitters: false,
    };
    scene
}

#[test]
fn a_blocker_that_moves_in_glass() {
    for depth in [3, 4] {
        let scene = blocker_in_glass(depth);
        assert!(is_refused(&scene, "thing.translate.x"), "depth {depth}");
    }
}

/// The derivative of the light of which nothing is missing is the same whether its tracers know what
/// the whole has found out about the motion, or find it out themselves. Parts of it are no parts of
/// the whole.
#[test]
fn the_rest_is_a_work_of_its_own() {
    let prepared = PreparedScene::new(blocker_in_glass(4));
    let tangent = tangent(
        prepared.scene(),
        "thing.translate.x + 0.1*sensor.translate.x",
    );
    let options = GradientOptions {
        allow_missing: AllowMissing { specular: true },
        ..RenderOptions::new(8, 3).into()
    };
    let work = |options| GradientWork::new(&prepared, Cow::Borrowed(&tangent), options);
    let whole = work(options);
    let image = whole.whole(&Unwatched).expect("covered in part");
    assert!(image.missing.is_some());
    let chosen = whole.chosen(&Unwatched).expect("a method").options;
    let rest = whole.of_rest().whole(&Unwatched).expect("covered");
    let fresh = work(chosen).of_rest().whole(&Unwatched).expect("covered");
    assert_eq!(rest.gradient, fresh.gradient);
    assert_ne!(rest.value, image.value);
    let part = Part::whole(whole.grid());
    let part = whole.of_rest().part(&part, &Unwatched).expect("a part");
    assert!(whole.finish(part).is_err());
}

/// What moves in a mirror, seen under parallel rays, is refused; what moves beside the
/// mirror is not, nor are reflections that do not move.
#[test]
fn mirrors_under_parallel_rays() {
    let mut scene = mirror_floor();
    scene.shape_mut(ShapeId(0)).normals = ShadingNormals::Face;
    assert!(!is_refused(&scene, "lamp.translate.x"));
    scene.sensor.model = SensorModel::Orthographic;
    for reason in refusals(&scene, &tangent(&scene, "lamp.translate.x")) {
        let reason = reason.expect("refused");
        assert!(
            reason.contains("mirrors by an orthographic sensor"),
            "{reason}"
        );
    }
    assert!(!is_refused(&scene, "lamp.emitter.radiance.value"));
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
        for material in &mut scene.materials {
            if let Bsdf::NormalMap { limits, .. } = &mut material.bsdf {
                (limits.flip_invalid, limits.shadowing) = (flip_invalid, shadowing);
            }
        }
        refusals(&scene, &tangent(&scene, name)).map(|reason| reason.unwrap_or_default())
    };
    let (moves, turns, colours) = (
        "lamp.translate.x",
        "floor.bsdf.normalmap.data",
        "lamp.emitter.radiance.value",
    );
    for (limits, name, why) in [
        ([true, true], moves, ""),
        ([true, true], turns, ""),
        ([false, true], moves, "`flip_invalid_normals`"),
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
