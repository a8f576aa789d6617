//! One triangle over a floor: the least that casts a shadow.

use capwalk_geometry::Mesh;
use capwalk_math::{Rgb, Vec3};

use super::stage::{self, Sides};
use crate::scene::Scene;
use crate::shape::ShadingNormals;

/// The camera stands lower than the leaf and looks down: it sees the shadow,
/// never the leaf.
pub fn scene() -> Scene {
    let mut scene = stage::empty(Vec3::new(0.5, 1.25, 2.6), Vec3::new(0.03, 0.0, 0.12), 46.0);
    stage::add_floor(&mut scene, 12.0, Rgb::new(0.7, 0.68, 0.64));
    stage::add_emitter(&mut scene, Vec3::new(0.07, 4.0, -0.04), 0.35, 70.0);
    let leaf = Mesh {
        positions: vec![
            Vec3::new(-0.47, 1.53, -0.31),
            Vec3::new(-0.06, 1.77, 0.53),
            Vec3::new(0.56, 1.61, -0.17),
        ],
        faces: vec![[0, 1, 2]],
    };
    let colour = Rgb::new(0.25, 0.5, 0.15);
    stage::add(
        &mut scene,
        "leaf",
        (leaf, ShadingNormals::Face),
        colour,
        Sides::Both,
    );
    scene
}
