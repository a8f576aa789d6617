//! The shadow of a Voronoi bunny, as in the paper's figures 1, 10 and 11.

use std::sync::Arc;

use capwalk_math::Vec3;
use capwalk_scene::{Scene, SensorModel, builtin};

use crate::bunny;

/// The id of the bunny in its scene.
pub const SHAPE: &str = "bunny";

/// The built-in scene `lattice-shadow` with the bunny in the lattice's place, seen at a
/// wider angle. The camera sees the floor only.
pub fn scene() -> Scene {
    const LATTICE: &str = "lattice";
    let mut scene = builtin::scene("lattice-shadow").expect("it is built in");
    scene.sensor.model = SensorModel::Perspective {
        fov_x: 57_f64.to_radians(),
        principal_point_offset: [0.0, 0.0],
    };
    for material in &mut scene.materials {
        material.id = material.id.replace(LATTICE, SHAPE);
    }
    let textures = scene.textures.iter_mut().map(Arc::make_mut);
    textures.for_each(|texture| texture.id = texture.id.replace(LATTICE, SHAPE));
    let lattice = scene.shapes_mut().find(|shape| shape.id == LATTICE);
    let shape = lattice.expect("the scene is named after it");
    shape.id = SHAPE.into();
    shape.mesh = bunny::mesh();
    let centre = Vec3::new(0.13, 4.0, 0.02);
    shape.mesh.positions.iter_mut().for_each(|p| *p += centre);
    scene
}
