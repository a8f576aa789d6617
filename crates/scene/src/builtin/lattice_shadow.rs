//! The shadow of a lattice, as in the top row of the paper's figure 11.

use capwalk_math::{Rgb, Vec3};

use super::lattice;
use super::stage::{self, Sides};
use crate::scene::Scene;
use crate::shape::ShadingNormals;

/// The camera stands lower than the lattice and looks down: it sees the floor
/// only.
pub fn scene() -> Scene {
    let mut scene = stage::empty(Vec3::new(0.62, 2.7, 4.0), Vec3::new(0.05, 0.0, 0.03), 50.0);
    stage::add_floor(&mut scene, 20.0, Rgb::splat(0.75));
    stage::add_emitter(&mut scene, Vec3::new(0.11, 9.0, -0.07), 0.12, 5600.0);
    let mut mesh = lattice::mesh();
    let centre = Vec3::new(0.04, 4.0, -0.03);
    mesh.positions.iter_mut().for_each(|p| *p += centre);
    let colour = Rgb::splat(0.6);
    stage::add(
        &mut scene,
        "lattice",
        (mesh, ShadingNormals::Face),
        colour,
        Sides::Front,
    );
    scene
}
