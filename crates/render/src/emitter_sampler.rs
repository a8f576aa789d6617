//! How directions towards each emitter of a scene are sampled.

use capwalk_scene::emitter::EnvironmentTable;
use capwalk_scene::{Emitter, Scene};

use crate::triangle_sampler::TriangleSampler;

/// How directions towards an emitter are sampled.
#[derive(Clone, Debug)]
pub enum EmitterSampler {
    /// By points on its triangles, as they are seen.
    Area(TriangleSampler),
    /// By the cosine at the surface, or uniformly: light from everywhere.
    Constant,
    /// By the brightness of an environment map, unless it is black.
    Environment(Option<EnvironmentTable>),
    /// Not at all: there is only one.
    Delta,
}

impl EmitterSampler {
    /// The sampler of a scene's emitter.
    pub fn new(scene: &Scene, emitter: &Emitter) -> Self {
        match emitter {
            Emitter::Area { shape, .. } => {
                Self::Area(TriangleSampler::new(&scene.shape(*shape).mesh))
            }
            Emitter::Constant { .. } => Self::Constant,
            Emitter::EnvironmentMap { map, data, .. } => {
                Self::Environment(EnvironmentTable::new(map, scene.texture(*data)))
            }
            Emitter::Point { .. } | Emitter::Spot { .. } | Emitter::Directional { .. } => {
                Self::Delta
            }
        }
    }
}
