//! Stages: what the cases of the phenomena play on.

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::emitter::EnvironmentMap;
use capwalk_scene::primitive::{cube, icosphere, rectangle, sphere};
use capwalk_scene::*;

use super::*;

/// A camera that sees only the floor (its middle ±1.2) from above.
pub fn shadow_stage() -> Scene {
    let mut scene = empty(v(0.3, -0.4, 6.0), v(0.0, 0.0, 0.0), 22.0, 40);
    scene.sensor.near_clip = 5.6; // what is above the floor is not seen
    add_floor(&mut scene, 3.0);
    add_emitter(&mut scene, v(0.1, 0.0, 3.0), 0.8, 0.3, 10.0);
    scene
}

pub fn triangle() -> Mesh {
    Mesh {
        positions: vec![v(-0.45, -0.3, 1.2), v(0.5, -0.25, 1.0), v(0.05, 0.5, 1.1)],
        faces: vec![[0, 1, 2]],
    }
}

pub fn placed(mut mesh: Mesh, map: Affine) -> Mesh {
    mesh.positions.iter_mut().for_each(|p| *p = map.point(*p));
    mesh
}

pub fn small_ball() -> Mesh {
    placed(
        icosphere(4),
        Affine::translate(v(0.0, 0.0, 1.0)) * Affine::scale(Vec3::splat(0.5)),
    )
}

pub fn tilted_cube() -> (Mesh, ShadingNormals) {
    let turn = Affine::rotate(v(0.3, 0.8, 0.5), 0.7);
    cube(Affine::translate(v(0.0, 0.0, 1.1)) * turn * Affine::scale(v(0.3, 0.4, 0.25)))
}

pub fn with(mesh: Mesh) -> Scene {
    let mut scene = shadow_stage();
    add(&mut scene, "thing", mesh, ShadingNormals::Face, 0.5);
    scene
}

/// A visible, shaded thing over a lit floor, its shadow in the image too.
pub fn visible_stage(from: Vec3) -> Scene {
    let mut scene = empty(from, v(0.0, 0.05, 0.4), 22.0, 36);
    add_floor(&mut scene, 4.0);
    add_emitter(&mut scene, v(0.9, -0.6, 2.6), 0.8, 0.3, 10.0);
    scene
}

pub fn visible_ball(filter: Filter) -> Scene {
    let mut scene = visible_stage(v(1.2, -4.0, 1.9));
    let (mesh, normals) = sphere(Affine::IDENTITY, v(0.0, 0.0, 0.55), 0.5);
    add(&mut scene, "ball", mesh, normals, 0.6);
    scene.film.filter = filter;
    scene
}

pub fn visible_cube() -> Scene {
    let mut scene = visible_stage(v(1.2, -4.0, 1.9));
    let (mesh, normals) = tilted_cube();
    let mesh = placed(mesh, Affine::translate(v(0.0, 0.0, -0.5)));
    add(&mut scene, "thing", mesh, normals, 0.6);
    scene
}

/// The scene seen through a lens.
pub fn through_lens(mut scene: Scene, aperture_radius: f64, focus_distance: f64) -> Scene {
    scene.sensor.model = SensorModel::ThinLens {
        fov_x: *fov_x(&mut scene),
        aperture_radius,
        focus_distance,
    };
    scene
}

/// The scene under parallel rays, on a film of the given half width whose pixels are
/// not square in the world, seen by a sensor whose axes are neither of unit length nor
/// orthogonal.
pub fn with_parallel_rays(mut scene: Scene, half_width: f64) -> Scene {
    scene.sensor.model = SensorModel::Orthographic;
    let mut shape = Affine::scale(v(half_width, 0.9 * half_width, 1.3));
    shape.rows[0].z = 0.1;
    let camera = &mut scene.sensor.world_from_camera;
    *camera = *camera * shape;
    scene
}

/// Texture coordinates from corner to corner of a horizontal rectangle.
pub fn unit_square(scene: &mut Scene, shape: &str) {
    let shape = scene.shapes_mut().find(|s| s.id == shape).expect("a shape");
    let uv = |i: u32| {
        let p = shape.mesh.positions[i as usize];
        let (low, high) = shape.mesh.bounds();
        [
            (p.x - low.x) / (high.x - low.x),
            (p.y - low.y) / (high.y - low.y),
        ]
    };
    shape.uvs = Some(shape.mesh.faces.iter().map(|face| face.map(uv)).collect());
}

fn without_emitters(scene: &mut Scene) {
    for shape in scene.shapes_mut() {
        shape.emitter = None;
    }
    scene.shapes.retain(|shape| shape.id != "lamp");
    scene.emitters.clear();
}

/// Adds light of one colour from everywhere.
pub fn add_constant_light(scene: &mut Scene, radiance: f64) {
    let radiance = Texture::colour("sky.radiance", Rgb::splat(radiance));
    let radiance = scene.add_texture(radiance);
    let id = "sky".into();
    scene.emitters.push(Emitter::Constant { id, radiance });
}

/// Light of one colour from everywhere, instead of all emitters.
pub fn under_constant_light(mut scene: Scene) -> Scene {
    without_emitters(&mut scene);
    add_constant_light(&mut scene, 1.0);
    scene
}

/// A sky of 8 x 4 colours, brighter above, instead of all emitters.
pub fn under_a_sky(mut scene: Scene) -> Scene {
    without_emitters(&mut scene);
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

/// A box of six rectangles over a floor, and the motion of all of them.
pub fn box_of_sides() -> (Scene, String) {
    let mut scene = shadow_stage();
    let (mesh, _) = tilted_cube();
    let mut parts = Vec::new();
    for (i, faces) in mesh.faces.chunks(2).enumerate() {
        let id = format!("side{i}");
        let side = Mesh {
            positions: mesh.positions.clone(),
            faces: faces.to_vec(),
        };
        parts.push(format!("{id}.translate.x"));
        add(&mut scene, &id, side, ShadingNormals::Face, 0.5);
    }
    (scene, parts.join(" + "))
}

/// One thing before nothing, as a mask; its angles are a few times the reach of
/// the field, so that most samples tell something.
pub fn mask(mesh: Mesh, normals: ShadingNormals) -> Scene {
    let mut scene = empty(v(0.0, 0.0, 4.0), Vec3::zero(), 3.0, 8);
    scene.film.filter = Filter::Gaussian { stddev: 0.5 };
    add(&mut scene, "thing", mesh, normals, 0.5);
    scene.settings.integrator = Integrator::Aov(Aov::Mask);
    scene
}

/// Half of the image's width in the plane through the origin.
pub fn half_width() -> f64 {
    4.0 * 1.5_f64.to_radians().tan()
}

/// Half as wide as the image, so that its area is 16 pixels.
pub fn card() -> Scene {
    let half = 0.5 * half_width();
    let (mesh, normals) = rectangle(Affine::scale(v(half, half, 1.0)));
    mask(mesh, normals)
}
