//! Small scenes, put together by code.
#![allow(dead_code, reason = "a benchmark uses some of it")]

pub mod agree;
pub mod both_modes;
pub mod exact;
pub mod irradiance;
pub mod materials;
pub mod random;
pub mod refused;
pub mod stages;
#[path = "../../../../../tests/references/store.rs"]
pub mod store;

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::primitive::{icosphere, rectangle};
use capwalk_scene::*;

pub fn v(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A scene to be filled: a camera at `from` that looks at `to`, direct light
/// from emitters only.
pub fn empty(from: Vec3, to: Vec3, fov_degrees: f64, size: u32) -> Scene {
    let up = v(0.1, 0.2, 1.0);
    Scene {
        shapes: Vec::new(),
        materials: Vec::new(),
        emitters: Vec::new(),
        textures: Vec::new(),
        sensor: Sensor {
            id: "sensor".into(),
            world_from_camera: Affine::look_at(from, to, up).expect("not along the up vector"),
            model: SensorModel::Perspective {
                fov_x: fov_degrees.to_radians(),
                principal_point_offset: [0.0, 0.0],
            },
            near_clip: 1e-2,
            far_clip: 1e4,
        },
        film: Film::new(size, size, Filter::Box),
        settings: Settings {
            integrator: Integrator::Direct {
                emitter_samples: 1,
                bsdf_samples: 0,
                hide_emitters: false,
            },
            spp: 16,
            sampler: SamplerKind::Independent,
            seed: 0,
        },
    }
}

/// The horizontal field of view of the scene's sensor, radians.
pub fn fov_x(scene: &mut Scene) -> &mut f64 {
    let fov_x = scene.sensor.model.optic_mut(Optic::FovX);
    fov_x.expect("a sensor with a field of view")
}

/// Adds a two-sided grey shape.
pub fn add(scene: &mut Scene, id: &str, mesh: Mesh, normals: ShadingNormals, grey: f64) {
    let inner = BsdfId(scene.materials.len() as u32);
    let reflectance = Texture::colour(format!("{id}.bsdf.reflectance"), Rgb::splat(grey));
    let reflectance = scene.add_texture(reflectance);
    scene.materials.push(Material {
        id: format!("{id}.bsdf"),
        bsdf: lobe::Diffuse { reflectance }.into(),
    });
    scene.materials.push(Material {
        id: format!("{id}.twosided"),
        bsdf: Bsdf::TwoSided {
            front: inner,
            back: inner,
        },
    });
    let outer = BsdfId(inner.0 + 1);
    scene.add_shape(Shape::new(id, mesh, normals, outer));
}

/// Makes the last shape added an emitter.
pub fn light_up(scene: &mut Scene, radiance: f64) {
    let shape = ShapeId(scene.shapes.len() as u32 - 1);
    let id = EmitterId(scene.emitters.len() as u32);
    let name = format!("{}.emitter.radiance", scene.shape(shape).id);
    let radiance = scene.add_texture(Texture::colour(name, Rgb::splat(radiance)));
    scene.emitters.push(Emitter::Area { shape, radiance });
    scene.shape_mut(shape).emitter = Some(id);
}

/// Light of paths of at most so many segments, without roulette.
pub fn paths(scene: &mut Scene, segments: u32) {
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(segments),
        rr_depth: 100,
        hide_emitters: false,
    };
}

/// A floor in the plane z = 0, of the given half width.
pub fn add_floor(scene: &mut Scene, half: f64) {
    let (mesh, normals) = rectangle(Affine::scale(v(half, half, 1.0)));
    add(scene, "floor", mesh, normals, 0.7);
}

/// A square emitter of the given side, facing down from `centre`, turned by some
/// radians about the vertical.
pub fn add_emitter(scene: &mut Scene, centre: Vec3, side: f64, turned: f64, radiance: f64) {
    let down = Affine::rotate(v(1.0, 0.0, 0.0), std::f64::consts::PI);
    let turn = Affine::rotate(v(0.0, 0.0, 1.0), turned);
    let scale = Affine::scale(v(0.5 * side, 0.5 * side, 1.0));
    let (mesh, normals) = rectangle(Affine::translate(centre) * turn * down * scale);
    add(scene, "lamp", mesh, normals, 0.0);
    light_up(scene, radiance);
}

/// METHOD's reference set-up: a square emitter of side 1 and radiance 1 at height
/// 2 and an icosphere of 320 faces and radius 0.35 at height 1.
pub fn reference_scene() -> Scene {
    let mut scene = empty(v(0.0, -5.0, 1.0), v(0.0, 0.0, 1.0), 40.0, 4);
    add_emitter(&mut scene, v(0.0, 0.0, 2.0), 1.0, 0.0, 1.0);
    let mut ball = icosphere(4);
    assert_eq!(ball.faces.len(), 320);
    ball.positions
        .iter_mut()
        .for_each(|p| *p = *p * 0.35 + v(0.0, 0.0, 1.0));
    add(&mut scene, "ball", ball, ShadingNormals::Face, 0.5);
    scene.check().expect("a valid scene");
    scene
}

/// Floor points of the reference set-up, with their normals: cell centres of a 12 × 12 grid over [-1.2, 1.2]².
pub fn reference_points() -> Vec<(Vec3, Vec3)> {
    let centre = |i: i32| (f64::from(i) + 0.5) * 0.2 - 1.2;
    (0..144)
        .map(|i| (v(centre(i % 12), centre(i / 12), 0.0), v(0.0, 0.0, 1.0)))
        .collect()
}
