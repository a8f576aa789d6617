//! The derivative of a path's light at one place of the path.

use capwalk_geometry::Hit;
use capwalk_math::{Rgb, Vec3};
use capwalk_scene::lobe::Specular;
use capwalk_scene::{EmitterId, SurfacePoint, TextureId};

/// What the light of a path depends on at one of its places, with the covector on it.
#[derive(Clone, Copy, Debug)]
pub enum PathAdjoint {
    /// What an emitter sends back along a ray.
    Emitted {
        /// The emitter.
        emitter: EmitterId,
        /// The point of it, if it is on a surface.
        hit: Option<Hit>,
        /// Origin and direction of the ray.
        ray: [Vec3; 2],
        /// On the radiance, or on the irradiance of an emitter without extent.
        covector: Rgb,
    },
    /// What a diffuse surface reflects.
    Reflectance {
        /// The texture of it.
        texture: TextureId,
        /// Where.
        point: SurfacePoint<f64>,
        /// On its value.
        covector: Rgb,
    },
    /// What another surface scatters.
    Scattered {
        /// Where.
        hit: Hit,
        /// Origin and direction of the ray that hits it.
        ray: [Vec3; 2],
        /// Light towards which it was sampled, and along which the path goes on.
        arrives: [Option<Arriving>; 2],
    },
}

/// Light that arrives at a surface.
#[derive(Clone, Copy, Debug)]
pub struct Arriving {
    /// The unit direction that it comes from.
    pub direction: Vec3,
    /// The specular event by which it is seen.
    pub specular: Option<Specular>,
    /// On the BSDF times the cosine, or on the fraction of light of the event.
    pub covector: Rgb,
}
