//! The shadow of the Voronoi lattice, or of the user's mesh in its place.

use capwalk_geometry::Mesh;
use capwalk_scene::{Scene, ShadingNormals, builtin};

use crate::gradients::Subject;
use crate::settings::{Failure, Settings};

/// The built-in scene, the shape in it, and the parameter that moves it.
const SCENE: &str = "lattice-shadow";
const SHAPE: &str = "lattice";

/// Half the distance of differences, world units: small against the half-shadows.
const STEP: f64 = 4e-3;

/// What casts the shadow, in words.
pub fn name(settings: &Settings) -> &'static str {
    match settings.mesh {
        Some(_) => "the shadow of the given mesh",
        None => "the shadow of a Voronoi lattice",
    }
}

/// The scene in so many pixels.
pub fn shadow(settings: &Settings, size: [u32; 2]) -> Result<Subject, Failure> {
    let mut scene = scene()?;
    if let Some(mesh) = &settings.mesh {
        replace(&mut scene, mesh)?;
    }
    let parameter = builtin::default_parameter(SCENE).expect("it is built in");
    Subject::new(scene, parameter, size, STEP)
}

/// The lattice, or the user's mesh.
pub fn mesh(settings: &Settings) -> Result<Mesh, Failure> {
    match &settings.mesh {
        Some(mesh) => Ok(mesh.clone()),
        None => {
            let scene = scene()?;
            let shape = scene.shapes.into_iter().find(|shape| shape.id == SHAPE);
            Ok(shape.ok_or_else(missing)?.mesh)
        }
    }
}

fn scene() -> Result<Scene, Failure> {
    builtin::scene(SCENE).ok_or_else(missing)
}

fn missing() -> Failure {
    Failure::Unusable(format!("the built-in scene {SCENE} has no {SHAPE}"))
}

/// Puts a mesh in the place of the lattice, of the same size and with the same
/// middle.
fn replace(scene: &mut Scene, mesh: &Mesh) -> Result<(), Failure> {
    let shape = scene.shapes.iter_mut().find(|shape| shape.id == SHAPE);
    let shape = shape.ok_or_else(missing)?;
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
