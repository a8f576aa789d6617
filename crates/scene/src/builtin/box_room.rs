//! A box in a room, as in the paper's figure 9.

use capwalk_math::{Affine, Rgb, Vec3};

use super::stage::{self, Sides};
use crate::primitive;
use crate::scene::Scene;

/// The room is 4 wide, 3 high and 6 deep, open behind the camera, with an emitter
/// below its ceiling. The box hovers, turned against the walls.
pub fn scene() -> Scene {
    let mut scene = stage::empty(
        Vec3::new(0.23, 1.58, 3.87),
        Vec3::new(0.04, 1.04, 0.0),
        52.0,
    );
    let v = Vec3::new;
    let (x, y, z) = (v(2.0, 0.0, 0.0), v(0.0, 1.5, 0.0), v(0.0, 0.0, 3.0));
    let grey = Rgb::new(0.7, 0.7, 0.68);
    // Each wall faces the inside, the cross product of its two sides.
    for (id, centre, s, t, reflectance) in [
        ("floor", v(0.0, 0.0, 1.0), z, x, grey),
        ("ceiling", v(0.0, 3.0, 1.0), x, z, grey),
        ("back", v(0.0, 1.5, -2.0), x, y, grey),
        ("left", v(-2.0, 1.5, 1.0), y, z, Rgb::new(0.62, 0.1, 0.08)),
        ("right", v(2.0, 1.5, 1.0), z, y, Rgb::new(0.12, 0.48, 0.12)),
    ] {
        let wall = stage::rectangle(centre, s, t);
        stage::add(&mut scene, id, wall, reflectance, Sides::Front);
    }
    stage::add_emitter(&mut scene, v(0.41, 2.93, 1.27), 0.45, 26.0);
    let place = Affine::translate(v(0.07, 0.83, 0.11))
        * Affine::rotate(v(0.12, 1.0, 0.07), 0.47)
        * Affine::scale(v(0.52, 0.48, 0.45));
    let cube = primitive::cube(place);
    stage::add(
        &mut scene,
        "box",
        cube,
        Rgb::new(0.7, 0.6, 0.4),
        Sides::Front,
    );
    scene
}
