//! The shadow of the Voronoi bunny, or of the user's mesh in its place; and that
//! of the Voronoi sphere in a mirror.

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Vec3};
use capwalk_scene::bsdf::Material;
use capwalk_scene::lobe::Conductor;
use capwalk_scene::{
    BsdfId, Integrator, Scene, SensorModel, ShadingNormals, Shape, Texture, builtin, primitive,
};

use crate::bunny_shadow;
use crate::gradients::Subject;
use crate::settings::{Failure, Quality, Settings};

/// The shape that casts the shadow in the built-in scene `lattice-shadow`.
const SPHERE: &str = "lattice";

/// Half the distance of differences, world units: small against the half-shadows.
const STEP: f64 = 4e-3;

/// What casts the shadow, in words: the user's mesh is no bunny.
pub fn name(settings: &Settings) -> &'static str {
    match (&settings.mesh, settings.quality) {
        (Some(_), _) => "given mesh",
        (None, Quality::Smoke) => "Voronoi sphere",
        (None, _) => "Voronoi bunny",
    }
}

/// The id of the shape that casts the shadow.
pub fn shape(settings: &Settings) -> &'static str {
    match settings.quality {
        Quality::Smoke => SPHERE,
        Quality::Draft | Quality::Full => bunny_shadow::SHAPE,
    }
}

/// The scene in so many pixels.
pub fn shadow(settings: &Settings, size: [u32; 2]) -> Result<Subject, Failure> {
    let mut scene = scene(settings);
    if let Some(mesh) = &settings.mesh {
        replace(caster(&mut scene, settings), mesh)?;
    }
    let parameter = format!("{}.translate.y", shape(settings));
    Subject::new(scene, &parameter, size, STEP)
}

/// The mesh that casts the shadow: the bunny's, or the user's.
pub fn mesh(settings: &Settings) -> Mesh {
    match &settings.mesh {
        Some(mesh) => mesh.clone(),
        None => caster(&mut scene(settings), settings).mesh.clone(),
    }
}

/// The bunny takes long to make: tests do with the sphere.
fn scene(settings: &Settings) -> Scene {
    match settings.quality {
        Quality::Smoke => sphere_shadow(),
        Quality::Draft | Quality::Full => bunny_shadow::scene(),
    }
}

fn sphere_shadow() -> Scene {
    builtin::scene("lattice-shadow").expect("it is built in")
}

fn caster<'a>(scene: &'a mut Scene, settings: &Settings) -> &'a mut Shape {
    let mut shapes = scene.shapes_mut();
    let caster = shapes.find(|shape| shape.id == self::shape(settings));
    caster.expect("the scene is made for it")
}

/// The shadow of the Voronoi sphere in a mirror behind it, which is all that the
/// camera sees.
pub fn in_mirror([width, height]: [u32; 2]) -> Result<Subject, Failure> {
    let mut scene = sphere_shadow();
    scene.sensor.world_from_camera = Affine::look_at(
        Vec3::new(0.25, 4.05, 4.0),
        Vec3::new(0.05, 0.0, -5.85),
        Vec3::new(0.0, 1.0, 0.0),
    )
    .expect("it does not look straight up");
    scene.sensor.model = SensorModel::Perspective {
        fov_x: 22_f64.to_radians(),
        principal_point_offset: [0.0, 0.0],
    };
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(3),
        rr_depth: 8,
        hide_emitters: false,
    };
    let mut number = |id: &str, x: f64| scene.add_texture(Texture::number(id, x));
    // Eta of 0 reflects all light.
    let metal = Conductor {
        eta: number("mirror.bsdf.eta", 0.0),
        k: number("mirror.bsdf.k", 1.0),
        specular_reflectance: number("mirror.bsdf.specular_reflectance", 0.95),
    };
    scene.materials.push(Material {
        id: "mirror.bsdf".into(),
        bsdf: metal.into(),
    });
    let material = BsdfId(scene.materials.len() as u32 - 1);
    // It stands on the floor, turned a little, and faces the camera.
    let place = Affine::translate(Vec3::new(0.0, 1.4, -3.0))
        * Affine::rotate(Vec3::new(0.0, 1.0, 0.0), 0.01)
        * Affine::scale(Vec3::new(3.5, 1.4, 1.0));
    let (mesh, normals) = primitive::rectangle(place);
    scene.add_shape(Shape::new("mirror", mesh, normals, material));
    Subject::new(
        scene,
        &format!("{SPHERE}.translate.x"),
        [width, height],
        STEP,
    )
}

/// Puts a mesh in the place of a shape's, of the same size and with the same
/// middle.
fn replace(shape: &mut Shape, mesh: &Mesh) -> Result<(), Failure> {
    let [(low, high), (new_low, new_high)] = [shape.mesh.bounds(), mesh.bounds()];
    let length = (new_high - new_low).length();
    if !(length.is_finite() && length > 0.0) {
        return Err(Failure::Unusable("the given mesh has no extent".into()));
    }
    let scale = (high - low).length() / length;
    let (from, to) = ((new_low + new_high) * 0.5, (low + high) * 0.5);
    let mut mesh = mesh.clone();
    for p in &mut mesh.positions {
        *p = (*p - from) * scale + to;
    }
    shape.mesh = mesh;
    shape.normals = ShadingNormals::Face;
    Ok(())
}
