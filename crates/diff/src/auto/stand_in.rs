//! The motion by which a pilot compares methods for a gradient in reverse mode, as a stand-in for
//! what that will be multiplied by.

use capwalk_math::Vec3;
use capwalk_scene::{Optic, Scene, ShapeVectors, Tangent};

use crate::adjoint::Wanted;

/// The fraction of the golden ratio.
pub const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A motion of all geometry that is wanted: each shape moves and turns in a direction of its own,
/// at the speed of one.
pub fn motion(scene: &Scene, wanted: &Wanted) -> Tangent {
    let mut motion = Tangent::zero(scene);
    for (number, shape) in scene.shapes.iter().enumerate() {
        if !wanted.shapes[number] {
            continue;
        }
        let (low, high) = shape.mesh.bounds();
        let (centre, radius) = ((low + high) * 0.5, 0.5 * (high - low).length());
        let turn = direction(2 * number + 1) / radius.max(f64::MIN_POSITIVE);
        let velocity = |&p: &Vec3| direction(2 * number) + turn.cross(p - centre);
        motion.shapes[number] = Some(ShapeVectors {
            vertices: shape.mesh.positions.iter().map(velocity).collect(),
            normals: None,
        });
    }
    // Lights without extent are as far from what they light as shapes are wide.
    let shapes = 2 * scene.shapes.len();
    for (number, light) in motion.emitters.iter_mut().enumerate() {
        if wanted.emitters[number] {
            light.translation = direction(shapes + 2 * number);
            light.rotation = direction(shapes + 2 * number + 1);
        }
    }
    let last = shapes + 2 * scene.emitters.len();
    if wanted.sensor_origin {
        motion.sensor.translation = direction(last);
    }
    if wanted.sensor_axes {
        motion.sensor.rotation = direction(last + 1);
    }
    if wanted.aperture {
        motion.sensor.add_optic(Optic::ApertureRadius, 1.0);
    }
    motion
}

/// The `i`-th of unit vectors that are spread over the sphere.
fn direction(i: usize) -> Vec3 {
    let [u, v] = [GOLDEN, GOLDEN * GOLDEN].map(|k| ((i + 1) as f64 * k).fract());
    let z = 1.0 - 2.0 * u;
    let (sin, cos) = (2.0 * std::f64::consts::PI * v).sin_cos();
    Vec3::new(cos, sin, 0.0) * (1.0 - z * z).sqrt() + Vec3::new(0.0, 0.0, z)
}
