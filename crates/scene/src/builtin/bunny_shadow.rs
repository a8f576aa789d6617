//! The shadow of a Voronoi bunny, as in the paper's figures 1, 10 and 11.

use capwalk_math::{Rgb, Vec3};

use super::bunny;
use super::stage::{self, Sides};
use crate::scene::Scene;
use crate::shape::ShadingNormals;

/// The camera stands lower than the bunny and looks down: it sees the floor only.
pub fn scene() -> Scene {
    let mut scene = stage::empty(Vec3::new(0.62, 2.7, 4.0), Vec3::new(0.05, 0.0, 0.03), 57.0);
    stage::add_floor(&mut scene, 20.0, Rgb::splat(0.75));
    stage::add_lamp(&mut scene, Vec3::new(0.11, 9.0, -0.07), 0.12, 5600.0);
    let mut mesh = bunny::mesh();
    let centre = Vec3::new(0.13, 4.0, 0.02);
    mesh.positions.iter_mut().for_each(|p| *p += centre);
    let colour = Rgb::splat(0.6);
    stage::add(
        &mut scene,
        "bunny",
        (mesh, ShadingNormals::Face),
        colour,
        Sides::Front,
    );
    scene
}
