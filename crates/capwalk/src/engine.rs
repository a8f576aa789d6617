//! The calls into the renderer, all in one place.

use std::sync::Arc;

use capwalk_render::{
    Backward, GradientImage, GradientOptions as MethodOptions, Options, Refusal, Rendering, Wanted,
    Watch,
};
use capwalk_scene::{Image, Motion, Scene};

use crate::options::{GradientOptions, RenderOptions};

/// A scene that is ready to be rendered.
#[derive(Clone, Debug)]
pub struct Engine {
    scene: Arc<Scene>,
}

impl Engine {
    pub fn new(scene: Arc<Scene>) -> Self {
        Self { scene }
    }

    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Replaces the scene by one with the same shapes, textures and emitters, some of
    /// whose numbers are others.
    pub fn update(&mut self, scene: Scene) {
        self.scene = Arc::new(scene);
    }

    pub fn render(&self, options: &RenderOptions, watch: &dyn Watch) -> Rendering {
        capwalk_render::render(&self.scene, &sampling(options), watch)
    }

    pub fn gradient(
        &self,
        motion: &Motion,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, Refusal> {
        capwalk_render::gradient(&self.scene, motion, &estimation(options), watch)
    }

    pub fn finite_difference(
        &self,
        motion: &Motion,
        step: f64,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, Refusal> {
        capwalk_render::finite_difference(&self.scene, motion, step, &sampling(options), watch)
    }

    pub fn backward(
        &self,
        adjoint: &Image,
        wanted: &Wanted,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<Backward, Refusal> {
        capwalk_render::backward(&self.scene, adjoint, wanted, &estimation(options), watch)
    }

    /// Why derivatives with respect to what moves edges are refused, if they are.
    pub fn refusal(&self) -> Option<Refusal> {
        capwalk_render::refusal(&self.scene)
    }
}

/// Work runs on the threads of the caller.
fn sampling(options: &RenderOptions) -> Options {
    Options {
        spp: options.spp,
        seed: options.seed,
        threads: None,
    }
}

fn estimation(options: &GradientOptions) -> MethodOptions {
    MethodOptions {
        options: sampling(&options.sampling()),
        method: options.method,
        walk: options.walk,
    }
}
