//! What both modes refuse, and a mirror in which it is seen.

use capwalk_diff::{
    GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, Wanted, backward, gradient,
};
use capwalk_math::Rgb;
use capwalk_scene::lobe::{Conductor, Diffuse};
use capwalk_scene::texture::UvTransform;
use capwalk_scene::*;

use super::stages::{shadow_stage, unit_square};
use super::{add_emitter, add_floor, empty, v};
/// Replaces a material.
fn material(scene: &mut Scene, name: &str, bsdf: Bsdf) {
    let found = scene.materials.iter_mut().find(|m| m.id == name);
    found.expect("a material").bsdf = bsdf;
}

fn mirror(scene: &mut Scene) -> Bsdf {
    let mut number = |id: &str, x: f64| scene.add_texture(Texture::number(id, x));
    Bsdf::from(Conductor {
        eta: number("eta", 0.2),
        k: number("k", 3.0),
        specular_reflectance: number("tint", 1.0),
    })
}

/// A mirror for a floor, flat but with normals of its own, and an emitter seen in it.
pub fn mirror_floor() -> Scene {
    let mut scene = empty(v(0.0, -3.0, 2.0), v(0.0, 0.0, 0.0), 30.0, 12);
    add_floor(&mut scene, 3.0);
    add_emitter(&mut scene, v(0.0, 1.6, 1.2), 0.8, 0.3, 10.0);
    let metal = mirror(&mut scene);
    material(&mut scene, "floor.bsdf", metal);
    let floor = scene.shape_mut(ShapeId(0));
    floor.normals = ShadingNormals::computed(&floor.mesh);
    scene.settings.integrator = Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters: false,
    };
    scene
}

/// A floor with a checkerboard of so many squares, an emitter above it, and few pixels.
pub fn checkered_floor(squares: f64) -> Scene {
    let mut scene = shadow_stage();
    (scene.film.size, scene.film.crop_size) = ([4; 2], [4; 2]);
    unit_square(&mut scene, "floor");
    let id = scene.add_texture(Texture {
        id: "squares".into(),
        channels: 1,
        data: vec![0.2, 0.7],
        pattern: Pattern::Checkerboard {
            to_uv: UvTransform {
                rows: [[squares, 0.0, 0.0], [0.0, squares, 0.0]],
            },
        },
    });
    material(&mut scene, "floor.bsdf", Diffuse { reflectance: id }.into());
    scene
}

/// Why forward and reverse mode refuse a method, if they do.
pub fn refusals_with(scene: &Scene, tangent: &Tangent, method: Method) -> [Option<String>; 2] {
    let settings = GradientOptions {
        method,
        ..GradientOptions::new(RenderOptions::new(64, 1))
    };
    let forward = gradient(
        &PreparedScene::new(scene.clone()),
        tangent,
        &settings,
        &Unwatched,
    );
    let [width, height] = scene.film.crop_size.map(|n| n as usize);
    let adjoint = Image {
        width,
        height,
        pixels: vec![Rgb::splat(1.0); width * height],
    };
    let wanted = Wanted::by(tangent);
    let reverse = backward(
        &PreparedScene::new(scene.clone()),
        &adjoint,
        &wanted,
        &settings,
        &Unwatched,
    );
    [forward.err(), reverse.err()].map(|refusal| refusal.map(|refusal| refusal.to_string()))
}
