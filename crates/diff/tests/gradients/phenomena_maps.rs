//! Gradients against finite differences, one scene per phenomenon: maps of normals
//! and bumps. What is demanded of each case, and how often it raises a false alarm,
//! is said in `phenomena_shadows.rs`.

use crate::common::agree::*;
use crate::common::materials::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_math::{Affine, Vec3};
use capwalk_scene::*;

/// A floor under an emitter, seen from near by, not at grazing angles alone.
fn mapped_floor(material: impl FnOnce(&mut Slots) -> Bsdf) -> Scene {
    let mut scene = empty(v(0.3, -2.0, 2.5), v(0.0, 0.0, 0.0), 40.0, 36);
    add_floor(&mut scene, 3.0);
    unit_square(&mut scene, "floor");
    make(&mut scene, "floor", material);
    add_emitter(&mut scene, v(0.1, 0.4, 2.6), 1.0, 0.3, 10.0);
    scene
}

fn normal_mapped() -> Scene {
    mapped_floor(|n| {
        let nested = n.glossy();
        n.normal_map(nested)
    })
}

fn bumpy() -> Scene {
    mapped_floor(|n| {
        let nested = n.glossy();
        n.bump_map(0.3, nested)
    })
}

fn case(spp: u32) -> Case {
    Case {
        step: 4e-3,
        gradient_spp: spp,
        reference_spp: spp,
        ..Case::default()
    }
}

/// All numbers of a texture change, each at its own velocity.
fn texels_change(scene: &Scene, id: &str) -> Tangent {
    let index = scene.textures.iter().position(|t| t.id == id);
    let index = index.expect("a texture");
    let mut tangent = Tangent::zero(scene);
    let count = scene.textures[index].data.len();
    tangent.textures[index] = Some((0..count).map(|i| (i % 5) as f64 - 1.5).collect());
    tangent
}

/// Gives every path one more segment, so that the floor is seen from everywhere.
fn with_indirect_light(mut scene: Scene) -> Scene {
    let thing = placed(small_ball(), Affine::translate(v(0.2, 0.3, -0.4)));
    add(&mut scene, "thing", thing, ShadingNormals::Face, 0.6);
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(3),
        rr_depth: 100,
        hide_emitters: false,
    };
    scene
}

#[test]
fn normals_of_a_map() {
    let scene = with_indirect_light(normal_mapped());
    let tangent = texels_change(&scene, "floor.bsdf.normalmap");
    agree("normals", scene, &tangent, case(100));
}

#[test]
fn heights_of_bumps_and_their_scale() {
    let scene = with_indirect_light(bumpy());
    let mut along = texels_change(&scene, "floor.bsdf.heights");
    along.add(&tangent(&scene, "0.5*floor.bsdf.scale"));
    agree("heights", scene, &along, case(100));
}

/// The same scene with the map around both sides of its floor, which is seen from behind.
fn around_and_behind(mut scene: Scene) -> Scene {
    let mut materials = scene.materials.iter();
    let map = materials.position(|m| m.id == "floor.bsdf").expect("a map");
    let (map, sides) = (BsdfId(map as u32), BsdfId(map as u32 + 1));
    let around = &mut scene.materials[map.0 as usize].bsdf;
    let (Bsdf::NormalMap { nested, .. } | Bsdf::BumpMap { nested, .. }) = around else {
        panic!("{around:?}");
    };
    let inside = std::mem::replace(nested, sides);
    scene.materials[sides.0 as usize].bsdf = Bsdf::TwoSided {
        front: inside,
        back: inside,
    };
    let floor = scene.shapes_mut().find(|shape| shape.id == "floor");
    let floor = floor.expect("a floor");
    floor.bsdf = map;
    let uvs = floor.uvs.as_mut().expect("a map needs them");
    for (face, uvs) in floor.mesh.faces.iter_mut().zip(uvs) {
        face.swap(1, 2);
        uvs.swap(1, 2);
    }
    scene
}

#[test]
fn maps_around_two_sides_from_behind() {
    let scene = around_and_behind(normal_mapped());
    let along = texels_change(&scene, "floor.bsdf.normalmap");
    agree("normals from behind", scene.clone(), &along, case(100));
    let along = tangent(&scene, "floor.translate.x + 0.3*floor.rotate.z");
    agree("turning from behind", scene, &along, case(100));
    let scene = around_and_behind(bumpy());
    let mut along = texels_change(&scene, "floor.bsdf.heights");
    along.add(&tangent(&scene, "0.5*floor.bsdf.scale"));
    agree("heights from behind", scene, &along, case(100));
}

/// The maps move with the plane.
#[test]
fn mapped_planes_move() {
    for (name, scene) in [("normals", normal_mapped()), ("bumps", bumpy())] {
        let along = tangent(&scene, "floor.translate.x + 0.3*floor.rotate.z");
        agree(&format!("{name} turn"), scene, &along, case(100));
    }
    // Slopes follow the size of the surface.
    let scene = bumpy();
    let along = tangent(&scene, "floor.scale + 0.2*floor.rotate.x");
    agree("growing", scene, &along, case(100));
}

/// The camera moves over bumps.
#[test]
fn camera_over_bumps() {
    let scene = bumpy();
    let along = tangent(&scene, "sensor.translate.y + 0.2*sensor.rotate.z");
    agree("camera over bumps", scene, &along, case(100));
}

/// A plane with interpolated normals, seen at a grazing angle, moves: normals of the
/// map turn away from the viewer.
#[test]
fn mapped_cushion_moves() {
    let mut scene = normal_mapped();
    scene.sensor.world_from_camera =
        capwalk_math::Affine::look_at(v(0.3, -2.4, 0.7), v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0))
            .expect("not along the up vector");
    let floor = scene.shapes_mut().find(|shape| shape.id == "floor");
    let floor = floor.expect("a floor");
    let outward = |p: &Vec3| v(0.1 * p.x, 0.1 * p.y, 1.0).normalized();
    let normals = floor.mesh.positions.iter().map(outward).collect();
    floor.normals = ShadingNormals::Given(normals);
    scene.film.filter = Filter::Gaussian { stddev: 0.5 };
    let along = tangent(&scene, "floor.translate.x + 0.3*floor.rotate.z");
    let case = Case {
        min_pixels: 900,
        ..case(100)
    };
    agree("cushion", scene, &along, case);
}
