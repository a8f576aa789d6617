//! The calls into the renderer, all in one place.

use std::sync::{Arc, OnceLock};

use capwalk_diff::{
    Backward, GradientImage, GradientOptions as Estimation, Options, Prepared, Refusal, Rendering,
    Wanted, Watch,
};
use capwalk_scene::params::Registry;
use capwalk_scene::{Image, Motion, Scene};

use crate::options::{GradientOptions, RenderOptions};

/// A scene that is ready to be rendered.
#[derive(Debug)]
pub struct Engine {
    prepared: Prepared,
    /// Made when the first name is asked for. Numbers that change do not change names.
    registry: OnceLock<Registry>,
}

impl Engine {
    pub fn new(scene: impl Into<Arc<Scene>>) -> Self {
        Self {
            prepared: Prepared::new(scene),
            registry: OnceLock::new(),
        }
    }

    pub fn scene(&self) -> &Arc<Scene> {
        self.prepared.scene()
    }

    pub fn registry(&self) -> &Registry {
        self.registry.get_or_init(|| Registry::new(self.scene()))
    }

    pub fn update(&mut self, scene: Scene) {
        self.prepared.update(scene);
    }

    pub fn render(&self, options: &RenderOptions, watch: &dyn Watch) -> Rendering {
        capwalk_diff::render(&self.prepared, &sampling(options), watch)
    }

    pub fn gradient(
        &self,
        motion: &Motion,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, Refusal> {
        capwalk_diff::gradient(&self.prepared, motion, &estimation(options), watch)
    }

    pub fn finite_difference(
        &self,
        motion: &Motion,
        step: f64,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, Refusal> {
        capwalk_diff::finite_difference(self.scene(), motion, step, &sampling(options), watch)
    }

    pub fn backward(
        &self,
        adjoint: &Image,
        wanted: &Wanted,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<Backward, Refusal> {
        capwalk_diff::backward(&self.prepared, adjoint, wanted, &estimation(options), watch)
    }

    /// Why derivatives with respect to what moves edges are refused, if they are.
    pub fn refusal(&self) -> Option<Refusal> {
        capwalk_diff::refusal(&self.prepared)
    }
}

fn sampling(&RenderOptions { spp, seed }: &RenderOptions) -> Options {
    Options { spp, seed }
}

fn estimation(options: &GradientOptions) -> Estimation {
    Estimation {
        options: sampling(&options.sampling()),
        method: options.method,
        walk: options.walk,
    }
}
