//! How each emitter of a scene is sampled.

use std::f64::consts::PI;

use capwalk_boundary::Accel;
use capwalk_scene::emitter::EnvironmentTable;
use capwalk_scene::{Emitter, EmitterId, Pattern, Scene, Texture};

use crate::plan::Plan;
use crate::receiver::Receiver;
use crate::triangle_sampler::TriangleSampler;

/// How an emitter is sampled.
#[derive(Clone, Debug)]
pub struct EmitterSampler {
    /// How directions towards it are.
    pub directions: DirectionSampler,
    /// The mean of the largest channel of its radiance, or of what it has instead.
    pub brightness: f64,
}

/// How directions towards an emitter are sampled.
#[derive(Clone, Debug)]
pub enum DirectionSampler {
    /// By points on its triangles, as they are seen.
    Area(TriangleSampler),
    /// By the cosine at the surface, or uniformly: light from everywhere.
    Constant,
    /// By the brightness of an environment map.
    Environment(EnvironmentTable),
    /// Not at all: there is only one.
    Delta,
}

impl EmitterSampler {
    /// The sampler of a scene's emitter.
    pub fn new(scene: &Scene, emitter: &Emitter) -> Self {
        let directions = match emitter {
            Emitter::Area { shape, .. } => {
                DirectionSampler::Area(TriangleSampler::new(&scene.shape(*shape).mesh))
            }
            Emitter::Constant { .. } => DirectionSampler::Constant,
            Emitter::EnvironmentMap { map, data, .. } => {
                let surfaces_draw = Plan::new(scene).sampling.bsdf_samples > 0;
                let texels = scene.texture(*data);
                DirectionSampler::Environment(EnvironmentTable::new(map, texels, surfaces_draw))
            }
            Emitter::Point { .. }
            | Emitter::Spot { .. }
            | Emitter::Projector { .. }
            | Emitter::Directional { .. } => DirectionSampler::Delta,
        };
        Self {
            directions,
            brightness: brightness(scene, emitter),
        }
    }

    /// About how much light arrives at a shading point, over [`Self::brightness`], if nothing is
    /// in between; 0 only if none can, whatever it emits. `id` is that of the emitter.
    pub fn view(&self, accel: &Accel, id: EmitterId, receiver: &Receiver) -> f64 {
        let position = receiver.position;
        match &self.directions {
            DirectionSampler::Area(triangles) => {
                let (centre, radius) = triangles.ball();
                triangles.solid_angle(position) * receiver.largest_cosine(centre, radius)
            }
            DirectionSampler::Constant | DirectionSampler::Environment(_) => PI,
            DirectionSampler::Delta => {
                let light = accel.delta_light(id, position);
                light.map_or(0.0, |light| {
                    light.factor * receiver.cosine_in(light.direction)
                })
            }
        }
    }
}

/// [`EmitterSampler::brightness`] of an emitter.
pub fn brightness(scene: &Scene, emitter: &Emitter) -> f64 {
    // What its radiance is multiplied by, and for numbers at vertices the texture that has them.
    let factors = textures(scene, emitter).into_iter().map(|texture| {
        let texels = (0..texture.texels()).map(|i| texture.texel(i).max_component());
        texels.sum::<f64>() / texture.texels() as f64
    });
    let scale = match &scene.texture(emitter.radiance()).pattern {
        Pattern::MeshAttribute { scale, .. } => scale.max(0.0),
        _ => 1.0,
    };
    scale * factors.product::<f64>()
}

/// The textures whose numbers make its brightness.
pub fn textures<'a>(scene: &'a Scene, emitter: &Emitter) -> Vec<&'a Texture> {
    let numbers = |id| match emitter.shape() {
        Some(shape) => scene.numbers_of(id, scene.shape(shape)),
        None => id,
    };
    let own = numbers(emitter.radiance());
    let ids = [Some(own), emitter.factor()].into_iter().flatten();
    ids.map(|id| scene.texture(id)).collect()
}
