//! A scene made ready: everything that is built once and answers any number of calls.

use std::sync::{Arc, OnceLock};

use capwalk_boundary::{Accel, Boundaries, pool, same_edges};
use capwalk_scene::Scene;

use crate::emitter_sampler::EmitterSampler;

/// A scene with its trees. It owns what it needs and can be shared between threads; the
/// scene in it does not change but by [`PreparedScene::update`].
#[derive(Debug)]
pub struct PreparedScene {
    accel: Accel,
    emitters: Vec<EmitterSampler>,
    /// Built when the first derivative asks for them.
    boundaries: OnceLock<Boundaries>,
}

impl PreparedScene {
    /// Builds the ray tree of a scene that has passed [`Scene::check`]. The boundaries
    /// and their tree follow with the first derivative.
    pub fn new(scene: impl Into<Arc<Scene>>) -> Self {
        let scene = scene.into();
        let accel = pool::install(|| Accel::new(scene));
        Self {
            emitters: emitter_samplers(&accel.scene),
            accel,
            boundaries: OnceLock::new(),
        }
    }

    /// The scene.
    pub fn scene(&self) -> &Arc<Scene> {
        &self.accel.scene
    }

    /// The joined mesh of all shapes and its rays.
    pub fn accel(&self) -> &Accel {
        &self.accel
    }

    /// How directions towards each emitter are drawn, by its id.
    pub fn emitters(&self) -> &[EmitterSampler] {
        &self.emitters
    }

    /// The boundaries of the scene; built by the first call.
    pub fn boundaries(&self) -> &Boundaries {
        self.boundaries
            .get_or_init(|| pool::install(|| Boundaries::new(&self.accel)))
    }

    /// Goes over to another scene, which must have passed [`Scene::check`] and should
    /// differ in few numbers: moved vertices refit the trees, other colours touch none,
    /// and only what these motions invalidate is built anew. Every later answer is that
    /// of [`PreparedScene::new`] for the scene, to the bit.
    pub fn update(&mut self, scene: impl Into<Arc<Scene>>) {
        let scene = scene.into();
        pool::install(|| {
            self.emitters = emitter_samplers(&scene);
            let same_edges = same_edges(self.scene(), &scene);
            let change = self.accel.update(scene);
            if let Some(boundaries) = self.boundaries.get_mut() {
                boundaries.update(&self.accel, change, same_edges);
            }
        });
    }
}

fn emitter_samplers(scene: &Scene) -> Vec<EmitterSampler> {
    let emitters = scene.emitters.iter();
    emitters
        .map(|emitter| EmitterSampler::new(scene, emitter))
        .collect()
}
