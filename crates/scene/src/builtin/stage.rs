//! What the built-in scenes are put together from.

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb, Vec3};

use crate::emitter::Emitter;
use crate::film::Film;
use crate::filter::Filter;
use crate::ids::{BsdfId, EmitterId, ShapeId};
use crate::material::bsdf::{Bsdf, Material};
use crate::material::lobe::Diffuse;
use crate::primitive;
use crate::scene::Scene;
use crate::sensor::{Sensor, SensorModel};
use crate::settings::{Integrator, SamplerKind, Settings};
use crate::shape::{ShadingNormals, Shape};
use crate::texture::Texture;

/// An empty scene: an image of 256 x 192 pixels with a box filter and direct
/// light, seen from `origin` towards `target` with a horizontal field of view
/// in degrees.
pub fn empty(origin: Vec3, target: Vec3, fov_x: f64) -> Scene {
    Scene {
        shapes: Vec::new(),
        materials: Vec::new(),
        emitters: Vec::new(),
        textures: Vec::new(),
        sensor: Sensor {
            id: "sensor".into(),
            world_from_camera: Affine::look_at(origin, target, Vec3::new(0.0, 1.0, 0.0))
                .expect("no built-in camera looks straight down"),
            model: SensorModel::Perspective {
                fov_x: fov_x.to_radians(),
                principal_point_offset: [0.0, 0.0],
            },
            near_clip: 0.01,
            far_clip: 1000.0,
        },
        film: Film::new(256, 192, Filter::Box),
        settings: Settings {
            integrator: Integrator::Direct {
                emitter_samples: 1,
                bsdf_samples: 1,
                hide_emitters: false,
            },
            spp: 64,
            sampler: SamplerKind::Independent,
            seed: 0,
        },
    }
}

/// Adds a shape that reflects diffusely from both sides, or from the front
/// only.
pub fn add(
    scene: &mut Scene,
    id: &str,
    (mesh, normals): (Mesh, ShadingNormals),
    reflectance: Rgb,
    sides: Sides,
) -> ShapeId {
    let diffuse = |scene: &mut Scene, id: String| {
        let texture = Texture::colour(format!("{id}.reflectance"), reflectance);
        let reflectance = scene.add_texture(texture);
        material(scene, id, Diffuse { reflectance }.into())
    };
    let bsdf = match sides {
        Sides::Front => diffuse(scene, format!("{id}.bsdf")),
        Sides::Both => {
            let side = diffuse(scene, format!("{id}.bsdf.brdf_0"));
            let (front, back) = (side, side);
            material(scene, format!("{id}.bsdf"), Bsdf::TwoSided { front, back })
        }
    };
    scene.add_shape(Shape::new(id, mesh, normals, bsdf))
}

fn material(scene: &mut Scene, id: String, bsdf: Bsdf) -> BsdfId {
    scene.materials.push(Material { id, bsdf });
    BsdfId(scene.materials.len() as u32 - 1)
}

/// Which sides of a shape reflect.
pub enum Sides {
    /// Closed shapes, floors and emitters.
    Front,
    /// Sheets.
    Both,
}

/// Adds a horizontal square that faces up, of half the given width.
pub fn add_floor(scene: &mut Scene, half_width: f64, reflectance: Rgb) {
    let (x, z) = (
        Vec3::new(half_width, 0.0, 0.0),
        Vec3::new(0.0, 0.0, half_width),
    );
    let floor = rectangle(Vec3::zero(), z, x);
    add(scene, "floor", floor, reflectance, Sides::Front);
}

/// Adds a square that emits downwards the same radiance in all channels.
pub fn add_emitter(scene: &mut Scene, centre: Vec3, half_width: f64, radiance: f64) {
    let (x, z) = (
        Vec3::new(half_width, 0.0, 0.0),
        Vec3::new(0.0, 0.0, half_width),
    );
    let emitter = rectangle(centre, x, z);
    let shape = add(scene, "lamp", emitter, Rgb::splat(0.5), Sides::Front);
    let emitter = EmitterId(scene.emitters.len() as u32);
    scene.shape_mut(shape).emitter = Some(emitter);
    let texture = Texture::colour("lamp.emitter.radiance", Rgb::splat(radiance));
    let radiance = scene.add_texture(texture);
    scene.emitters.push(Emitter::Area { shape, radiance });
}

/// The rectangle from `centre - s - t` to `centre + s + t`, facing `s × t`;
/// `s` and `t` are orthogonal.
pub fn rectangle(centre: Vec3, s: Vec3, t: Vec3) -> (Mesh, ShadingNormals) {
    let n = s.cross(t).normalized();
    primitive::rectangle(Affine {
        rows: [
            Vec3::new(s.x, t.x, n.x),
            Vec3::new(s.y, t.y, n.y),
            Vec3::new(s.z, t.z, n.z),
        ],
        translation: centre,
    })
}
