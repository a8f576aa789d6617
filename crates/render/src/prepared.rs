//! A scene made ready: everything that is built once and answers any number of calls.

use std::collections::BTreeSet;
use std::sync::{Arc, OnceLock};

use capwalk_boundary::{Accel, Boundaries, pool, same_edges, touching};
use capwalk_geometry::{Halt, Halted};
use capwalk_scene::{Emitter, Scene, Tangent, Texture};

use crate::emitter_sampler::{EmitterSampler, brightness, textures};
use crate::options::{Unwatched, Watch};

/// A scene with its trees. It owns what it needs and can be shared between threads; the
/// scene in it does not change but by [`PreparedScene::update`].
#[derive(Debug)]
pub struct PreparedScene {
    accel: Accel,
    emitters: Vec<EmitterSampler>,
    /// Built when the first derivative with respect to a motion asks for them.
    boundaries: OnceLock<Boundaries>,
    /// The boundaries of a derivative with respect to what moves nothing: none.
    no_boundaries: OnceLock<Boundaries>,
}

impl PreparedScene {
    /// Builds the ray tree of a scene that has passed [`Scene::check`]. The boundaries
    /// and their tree follow with the first derivative with respect to a motion.
    pub fn new(scene: impl Into<Arc<Scene>>) -> Self {
        Self::try_new(scene, &Unwatched).expect("nobody stops it")
    }

    /// [`Self::new`], unless the watch stops it.
    pub fn try_new(scene: impl Into<Arc<Scene>>, watch: &dyn Watch) -> Result<Self, Halted> {
        let scene = scene.into();
        let accel = halting(watch, |halt| Accel::try_new(scene, halt))?;
        Ok(Self {
            emitters: emitter_samplers(&accel.scene),
            accel,
            boundaries: OnceLock::new(),
            no_boundaries: OnceLock::new(),
        })
    }

    /// The scene.
    pub fn scene(&self) -> &Arc<Scene> {
        &self.accel.scene
    }

    /// The joined mesh of all shapes and its rays.
    pub fn accel(&self) -> &Accel {
        &self.accel
    }

    /// How each emitter is sampled, by its id.
    pub fn emitters(&self) -> &[EmitterSampler] {
        &self.emitters
    }

    /// The boundaries of the scene; built by the first call.
    pub fn boundaries(&self) -> &Boundaries {
        self.try_boundaries(&Unwatched).expect("nobody stops it")
    }

    /// [`Self::boundaries`], unless they are not built yet and the watch stops that.
    pub fn try_boundaries(&self, watch: &dyn Watch) -> Result<&Boundaries, Halted> {
        if let Some(boundaries) = self.boundaries.get() {
            return Ok(boundaries);
        }
        // Built outside of the lock: a worker that waits for others while it builds may take
        // up other work on this scene, which asks for them, too. Who is first is kept.
        let boundaries = halting(watch, |halt| Boundaries::try_new(&self.accel, halt))?;
        Ok(self.boundaries.get_or_init(|| boundaries))
    }

    /// True once [`Self::boundaries`] are built.
    pub fn has_boundaries(&self) -> bool {
        self.boundaries.get().is_some()
    }

    /// Pairs of shapes, by their indices: an edge of the first lies on a face of the second and moves
    /// off it. Fails if the watch stops the search.
    pub fn touching(
        &self,
        tangent: &Tangent,
        watch: &dyn Watch,
    ) -> Result<BTreeSet<[usize; 2]>, Halted> {
        let moves = tangent.shapes.iter().any(Option::is_some);
        let boundaries = self.try_boundaries_if(moves, watch)?;
        halting(watch, |halt| {
            halt.unless_halted(touching(&self.accel, boundaries, tangent, halt))
        })
    }

    /// The boundaries that a derivative asks for: none if nothing moves, which takes no time.
    pub fn boundaries_if(&self, moves: bool) -> &Boundaries {
        let found = self.try_boundaries_if(moves, &Unwatched);
        found.expect("nobody stops it")
    }

    /// [`Self::boundaries_if`], unless they are not built yet and the watch stops that.
    pub fn try_boundaries_if(&self, moves: bool, watch: &dyn Watch) -> Result<&Boundaries, Halted> {
        match moves {
            true => self.try_boundaries(watch),
            false => Ok((self.no_boundaries).get_or_init(|| Boundaries::none(&self.accel))),
        }
    }

    /// Goes over to another scene, which must have passed [`Scene::check`] and should
    /// differ in few numbers: moved vertices refit the trees, other colours touch none,
    /// and only what these motions invalidate is built anew. Every later answer is that
    /// of [`PreparedScene::new`] for the scene, to the bit.
    pub fn update(&mut self, scene: impl Into<Arc<Scene>>) {
        self.update_watched(scene, &Unwatched);
    }

    /// [`Self::update`]. If the watch stops it, the boundaries are built anew when they are next asked for.
    pub fn update_watched(&mut self, scene: impl Into<Arc<Scene>>, watch: &dyn Watch) {
        let scene = scene.into();
        let followed = halting(watch, |halt| {
            self.update_emitters(&scene);
            let old = self.scene();
            let same_sensor = old.sensor == scene.sensor && old.film == scene.film;
            let same_edges = same_edges(old, &scene);
            let change = self.accel.update(scene);
            self.no_boundaries = OnceLock::new();
            match self.boundaries.get_mut() {
                Some(boundaries) => {
                    boundaries.update(&self.accel, change, same_edges, same_sensor, halt)
                }
                None => Ok(()),
            }
        });
        if followed.is_err() {
            self.boundaries = OnceLock::new();
        }
    }

    /// Another scene made ready, which must have passed [`Scene::check`]: what
    /// [`PreparedScene::update`] makes of a copy. Its boundaries are not copied, but built when they
    /// are asked for.
    #[must_use]
    pub fn updated(&self, scene: impl Into<Arc<Scene>>) -> Self {
        let mut other = Self {
            accel: self.accel.clone(),
            emitters: self.emitters.clone(),
            boundaries: OnceLock::new(),
            no_boundaries: OnceLock::new(),
        };
        other.update(scene);
        other
    }

    /// Keeps the samplers of emitters whose light and shape are the same.
    fn update_emitters(&mut self, scene: &Scene) {
        let old = Arc::clone(self.scene());
        if scene.emitters.len() != old.emitters.len() {
            self.emitters = emitter_samplers(scene);
            return;
        }
        let radiance = |scene: &Scene, emitter: &Emitter| {
            std::ptr::from_ref(scene.texture(emitter.radiance()))
        };
        let brightness_from = |scene: &Scene, emitter: &Emitter| -> Vec<*const Texture> {
            let textures = textures(scene, emitter).into_iter();
            textures.map(std::ptr::from_ref).collect()
        };
        let shape = |scene: &Scene, emitter: &Emitter| {
            let shape = emitter.shape();
            shape.map(|id| std::ptr::from_ref(scene.shape(id)))
        };
        let pairs = scene.emitters.iter().zip(&old.emitters);
        for (sampler, (new, before)) in self.emitters.iter_mut().zip(pairs) {
            let is_same = new == before
                && radiance(scene, new) == radiance(&old, before)
                && shape(scene, new) == shape(&old, before);
            if !is_same {
                *sampler = EmitterSampler::new(scene, new);
            } else if brightness_from(scene, new) != brightness_from(&old, before) {
                sampler.brightness = brightness(scene, new);
            }
        }
    }
}

/// Does work on the threads of the renderer that may be given up when the watch says so.
fn halting<T: Send>(
    watch: &dyn Watch,
    work: impl FnOnce(&Halt) -> Result<T, Halted> + Send,
) -> Result<T, Halted> {
    let should_stop = || watch.should_stop();
    let halt = Halt::when(&should_stop);
    pool::install(|| work(&halt))
}

fn emitter_samplers(scene: &Scene) -> Vec<EmitterSampler> {
    let emitters = scene.emitters.iter();
    emitters
        .map(|emitter| EmitterSampler::new(scene, emitter))
        .collect()
}
