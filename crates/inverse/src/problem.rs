//! What is looked for, and how: the data of an optimisation.

use capwalk_diff::{Method, WalkSettings};
use capwalk_scene::{Film, Image, Scene, Sensor};

use crate::adam::Adam;
use crate::guard::Guards;
use crate::loss::Loss;
use crate::samples::ByNoise;
use crate::schedule::Schedule;
use crate::variable::Variables;

/// What is looked for, and how.
#[derive(Clone, Debug)]
pub struct Problem {
    /// The scene before the first step. It has passed [`Scene::check`].
    pub scene: Scene,
    /// Which of its numbers are looked for.
    pub variables: Variables,
    /// From where it is seen, and what should be seen; at least one.
    pub views: Vec<TargetView>,
    /// How images are compared.
    pub loss: Loss,
    /// How steps are made of gradients.
    pub adam: Adam,
    /// The learning rate, for variables without their own.
    pub lr: f64,
    /// What is made of learning rates.
    pub schedule: Schedule,
    /// What a step must not do.
    pub guards: Guards,
    /// When to stop.
    pub limits: Limits,
    /// The seed that all others are derived from.
    pub seed: u64,
    /// Samples per pixel of images, at least 2: their spread is the error.
    pub spp: u32,
    /// Samples per pixel of gradients.
    pub spp_grad: u32,
    /// If there is a rule, `spp` and `spp_grad` are those of the first iteration.
    pub by_noise: Option<ByNoise>,
    /// How gradients are estimated.
    pub method: Method,
    /// The walk that builds the velocity field, for methods that walk.
    pub walk: WalkSettings,
}

/// An image that is compared with a target.
#[derive(Clone, Debug)]
pub struct TargetView {
    /// Another sensor than the scene's, with its film.
    pub sensor: Option<(Sensor, Film)>,
    /// What should be seen.
    pub target: Image,
    /// How much each pixel and channel counts, at least 0; all the same without.
    pub mask: Option<Image>,
    /// How much the view counts, above 0.
    pub weight: f64,
}

/// When to stop.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// After so many steps.
    pub iterations: u32,
    /// When the loss is at most this.
    pub loss_below: Option<f64>,
    /// When the smallest loss is so many iterations old.
    pub patience: Option<u32>,
}

impl TargetView {
    /// The scene, as it is seen from here.
    pub fn scene(&self, scene: &Scene) -> Scene {
        let mut seen = scene.clone();
        if let Some((sensor, film)) = &self.sensor {
            (seen.sensor, seen.film) = (sensor.clone(), film.clone());
        }
        seen
    }
}

impl Problem {
    /// The share of each view in the loss; their sum is 1.
    pub(crate) fn shares(&self) -> Vec<f64> {
        // Against the largest, as sums of large weights are infinite.
        let weights = || self.views.iter().map(|view| view.weight);
        let largest = weights().fold(0.0, f64::max);
        let sum: f64 = weights().map(|weight| weight / largest).sum();
        weights().map(|weight| weight / largest / sum).collect()
    }
}
