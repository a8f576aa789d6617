//! The sensors of a scene file, of which a scene has one at a time.

use capwalk_scene::{Film, SamplerKind, Scene, Sensor};
use serde::{Deserialize, Serialize};

/// A sensor with what a file says of how it is sampled.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SensorSettings {
    /// The sensor.
    pub sensor: Sensor,
    /// Its film.
    pub film: Film,
    /// Where its random numbers come from.
    pub sampler: SamplerKind,
    /// Samples per pixel.
    pub spp: u32,
    /// Seed of its random numbers.
    pub seed: u64,
}

impl SensorSettings {
    /// The settings of a scene.
    pub fn of(scene: &Scene) -> Self {
        let settings = &scene.settings;
        Self {
            sensor: scene.sensor.clone(),
            film: scene.film.clone(),
            sampler: settings.sampler,
            spp: settings.spp,
            seed: settings.seed,
        }
    }

    /// A scene as it is seen from here.
    pub fn scene(&self, scene: &Scene) -> Scene {
        let mut seen = scene.clone();
        (seen.sensor, seen.film) = (self.sensor.clone(), self.film.clone());
        let settings = &mut seen.settings;
        (settings.sampler, settings.spp, settings.seed) = (self.sampler, self.spp, self.seed);
        seen
    }
}
