//! A sphere above a floor: a smooth silhouette that is seen and casts a shadow.

use capwalk_math::{Affine, Rgb, Vec3};

use super::stage::{self, Sides};
use crate::primitive;
use crate::scene::Scene;

/// The ball hovers a little above the floor, left of the emitter's axis.
pub fn scene() -> Scene {
    let mut scene = stage::empty(Vec3::new(0.9, 2.3, 3.7), Vec3::new(0.16, 0.3, 0.02), 34.0);
    stage::add_floor(&mut scene, 15.0, Rgb::new(0.7, 0.68, 0.64));
    stage::add_emitter(&mut scene, Vec3::new(-0.63, 3.5, 0.21), 0.45, 34.0);
    let ball = primitive::sphere(Affine::IDENTITY, Vec3::new(0.03, 0.66, 0.04), 0.5);
    let colour = Rgb::new(0.75, 0.3, 0.2);
    stage::add(&mut scene, "ball", ball, colour, Sides::Front);
    scene
}
