//! What is said of the surface that the camera sees, instead of its light.

use std::f64::consts::PI;

use capwalk_boundary::Accel;
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::Aov;

use crate::scene_eval::SceneEval;
use crate::shading::vertex_at;
use crate::surface::Surface;

/// An AOV's value at a surface that is met by a moving ray.
pub fn aov_at<R: Real, W: SceneEval<R>>(
    eval: &W,
    accel: &Accel,
    aov: Aov,
    surface: &Surface<R>,
    origin: Vec3<R>,
    direction: Vec3<R>,
) -> Rgb<R> {
    match aov {
        Aov::Depth => Rgb::splat((surface.position - origin).length()),
        Aov::Position => Rgb::from(surface.position.to_array()),
        Aov::Uv => {
            let [u, v] = surface.point.uv;
            Rgb::new(u, v, R::constant(0.0))
        }
        Aov::GeometricNormal => Rgb::from(surface.geometric().to_array()),
        Aov::ShadingNormal => Rgb::from(surface.outward.to_array()),
        Aov::Albedo => {
            let Some(vertex) = vertex_at(eval, accel, surface, direction) else {
                return Rgb::zero();
            };
            // Of a material that reflects to all directions alike; of others
            // what Mitsuba takes, their value straight on; of maps, what is in them.
            let up = Vec3::constant(Vec3::new(0.0, 0.0, 1.0));
            vertex.bsdf.levelled().eval(up, up) * R::constant(PI)
        }
        Aov::Mask => Rgb::splat(R::constant(1.0)),
    }
}
