//! What is said of the surface that the camera sees, instead of its light.

use std::f64::consts::PI;

use capwalk_boundary::Accel;
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::Layer;

use crate::scene_eval::SceneEval;
use crate::shading::vertex_at;
use crate::surface::Surface;

/// A layer's value at a surface that is met by a moving ray.
pub fn layer_at<R: Real, W: SceneEval<R>>(
    eval: &W,
    accel: &Accel,
    layer: Layer,
    surface: &Surface<R>,
    origin: Vec3<R>,
    direction: Vec3<R>,
) -> Rgb<R> {
    match layer {
        Layer::Depth => Rgb::splat((surface.position - origin).length()),
        Layer::Position => Rgb::from(surface.position.to_array()),
        Layer::Uv => {
            let [u, v] = surface.point.uv;
            Rgb::new(u, v, R::constant(0.0))
        }
        Layer::GeometricNormal => Rgb::from(surface.geometric().to_array()),
        Layer::ShadingNormal => Rgb::from(surface.outward.to_array()),
        Layer::Albedo => {
            let Some(vertex) = vertex_at(eval, accel, surface, direction) else {
                return Rgb::zero();
            };
            // Of a material that reflects to all directions alike; of others
            // what Mitsuba takes, their value straight on; of maps, what is in them.
            let up = Vec3::constant(Vec3::new(0.0, 0.0, 1.0));
            vertex.bsdf.levelled().eval(up, up) * R::constant(PI)
        }
        Layer::Mask => Rgb::splat(R::constant(1.0)),
    }
}
