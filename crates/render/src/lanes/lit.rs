//! Directions towards emitters, and the light that arrives by them.

use capwalk_geometry::Hit;
use capwalk_math::Rgb;
use capwalk_scene::EmitterId;
use capwalk_scene::emitter::MapPlace;

use crate::lanes::vectors::{LANES, Numbers, Vectors};

/// Directions towards emitters.
#[derive(Clone, Debug)]
pub struct Lit {
    /// Unit directions, and the distances between which something hides the emitters: zero and
    /// their own.
    pub direction: Vectors,
    pub range: [Numbers; 2],
    /// The inverse of the density with which all directions are drawn together.
    pub inverse_density: Numbers,
    /// Where surfaces are diffuse, the cosine over π, times the weight, over the density; where
    /// they have lobes, the weight over the density.
    pub weight: Numbers,
    /// What the emitters send from there.
    pub radiance: Vectors,
    /// One bit for each that leads to an emitter, and for each that leads to one without extent.
    pub mask: u32,
    pub of_delta: u32,
    /// The emitters, the points of those that are surfaces but no rectangles, and those of
    /// environment maps.
    pub emitters: [EmitterId; LANES],
    pub hits: [Option<Hit>; LANES],
    pub sky: [SkyPoint; LANES],
}

/// A point of an environment map.
#[derive(Clone, Copy, Debug, Default)]
pub struct SkyPoint {
    pub place: MapPlace<f64>,
    /// What comes from there, and the density with which directions to it are drawn.
    pub radiance: Rgb,
    pub pdf: f64,
}

/// What of an emitter is seen in a direction.
#[derive(Clone, Copy, Debug, Default)]
pub struct SeenEmitter {
    /// The point of it, if it is a surface.
    pub hit: Option<Hit>,
    /// The point of an environment map.
    pub sky: Option<SkyPoint>,
}

impl SeenEmitter {
    /// Of an emitter that is no environment map.
    pub fn on(hit: Option<Hit>) -> Self {
        Self { hit, sky: None }
    }
}

impl Default for Lit {
    fn default() -> Self {
        Self {
            direction: Vectors::UP,
            range: [[0.0; LANES]; 2],
            inverse_density: [0.0; LANES],
            weight: [0.0; LANES],
            radiance: Vectors::ZERO,
            mask: 0,
            of_delta: 0,
            emitters: [EmitterId(0); LANES],
            hits: [None; LANES],
            sky: [SkyPoint::default(); LANES],
        }
    }
}
