//! Things that nearly touch, by as much as single precision in mesh files sets
//! apart or sinks what should stand: each edge and each curve where surfaces cross
//! counts once.

use crate::common::agree::{Case, agree, tangent};
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::Method;
use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::primitive::{cube, rectangle};
use capwalk_scene::*;

/// A white sky and no floor, seen by few pixels.
fn under_sky(from: Vec3, to: Vec3, fov: f64) -> Scene {
    let mut scene = empty(from, to, fov, SIZE);
    scene.film.filter = Filter::Tent { radius: 1.0 };
    let radiance = scene.add_texture(Texture::colour("sky.radiance", Rgb::splat(1.0)));
    let id = "sky".into();
    scene.emitters.push(Emitter::Constant { id, radiance });
    scene
}

fn add_box(scene: &mut Scene, half: Vec3, centre: Vec3, grey: f64) {
    let (mesh, normals): (Mesh, _) = cube(Affine::translate(centre) * Affine::scale(half));
    add(scene, "thing", mesh, normals, grey);
}

/// The foot of a light cube that has sunk into a dark floor.
fn sunk(depth: f64) -> Scene {
    let mut scene = under_sky(v(0.2, -5.0, 3.0), v(0.0, -0.5, 0.0), 14.0);
    let (mesh, normals) = rectangle(Affine::scale(v(4.0, 4.0, 1.0)));
    add(&mut scene, "floor", mesh, normals, 0.1);
    add_box(&mut scene, Vec3::splat(0.5), v(0.0, 0.0, 0.5 - depth), 0.9);
    scene
}

const SIZE: u32 = 36;

fn case(method: Method) -> Case {
    Case {
        size: SIZE,
        gradient_spp: 500,
        reference_spp: 1200,
        step: 3e-3,
        method,
        min_pixels: 60,
        patience: 6.0,
        ..Case::default()
    }
}

/// What has sunk by less than rounding moves rays cannot be told from what stands;
/// what has sunk by more has a curve where it crosses the floor.
#[test]
fn sunk_by_the_rounding_of_files() {
    for (depth, method) in [(2e-8, Method::EDGES), (5e-7, Method::Walk)] {
        let scene = sunk(depth);
        let tangent = tangent(&scene, "thing.translate.y");
        let name = format!("{depth}, {}", method.name());
        agree(&name, scene, &tangent, case(method));
    }
}

#[test]
fn sunk_before_parallel_rays() {
    let scene = with_parallel_rays(sunk(5e-8), 0.7);
    let tangent = tangent(&scene, "thing.translate.y");
    agree("parallel", scene, &tangent, case(Method::Walk));
}

/// Two silhouettes that no viewpoint tells apart, far and near.
#[test]
fn slabs_as_thin_as_rounding() {
    let near = (v(0.2, -3.0, 1.2), 40.0, 3e-7);
    let far = (v(20.0, -300.0, 120.0), 0.4, 2.5e-6);
    for (from, fov, thin) in [near, far] {
        let mut scene = under_sky(from, Vec3::zero(), fov);
        add_box(&mut scene, v(0.5, thin, 0.5), Vec3::zero(), 0.1);
        let tangent = tangent(&scene, "thing.translate.x");
        let case = Case {
            gradient_spp: 1000,
            ..case(Method::EDGES)
        };
        agree(&format!("{thin}"), scene, &tangent, case);
    }
}
