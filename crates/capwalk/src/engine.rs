//! The calls into the renderer, all in one place.

use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

use capwalk_diff::{
    BackwardWork, Differences, GradientImage, GradientOptions, GradientWork, Halted, PreparedScene,
    Refusal, RenderOptions, RenderWork, Rendering, Wanted, Watch,
};
use capwalk_scene::params::Registry;
use capwalk_scene::{Image, Scene, Tangent};

/// A scene that is ready to be rendered.
#[derive(Debug)]
pub struct Engine {
    prepared: PreparedScene,
    /// Made when the first name is asked for. Numbers that change do not change names.
    registry: OnceLock<Registry>,
}

impl Engine {
    pub fn new(scene: impl Into<Arc<Scene>>) -> Self {
        Self {
            prepared: PreparedScene::new(scene),
            registry: OnceLock::new(),
        }
    }

    pub fn watched(scene: Arc<Scene>, watch: &dyn Watch) -> Result<Self, Halted> {
        Ok(Self {
            prepared: PreparedScene::try_new(scene, watch)?,
            registry: OnceLock::new(),
        })
    }

    pub fn scene(&self) -> &Arc<Scene> {
        self.prepared.scene()
    }

    pub fn prepared(&self) -> &PreparedScene {
        &self.prepared
    }

    pub fn registry(&self) -> &Registry {
        self.registry.get_or_init(|| Registry::new(self.scene()))
    }

    /// Goes over to a scene with the same names and other numbers.
    pub fn update(&mut self, scene: Scene) {
        self.prepared.update(scene);
    }

    /// Goes over to any other scene.
    pub fn replace(&mut self, scene: Arc<Scene>) {
        self.prepared.update(scene);
        self.registry = OnceLock::new();
    }

    pub fn render(&self, options: &RenderOptions, watch: &dyn Watch) -> Rendering {
        capwalk_diff::render(&self.prepared, options, watch)
    }

    pub fn gradient(
        &self,
        tangent: &Tangent,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, Refusal> {
        capwalk_diff::gradient(&self.prepared, tangent, options, watch)
    }

    pub fn differences(&self, tangent: &Tangent, step: f64) -> Result<Differences<'_>, Refusal> {
        Differences::new(&self.prepared, tangent, step)
    }

    pub fn backward_work<'a>(
        &'a self,
        adjoint: &'a Image,
        wanted: Wanted,
        options: &GradientOptions,
    ) -> BackwardWork<'a> {
        BackwardWork::new(&self.prepared, adjoint, wanted, *options)
    }

    pub fn gradient_work<'a>(
        &'a self,
        tangent: Cow<'a, Tangent>,
        options: &GradientOptions,
    ) -> GradientWork<'a> {
        GradientWork::new(&self.prepared, tangent, *options)
    }

    pub fn render_work(&self, options: &RenderOptions) -> RenderWork<'_> {
        RenderWork::new(&self.prepared, *options)
    }

    /// Why derivatives with respect to what moves edges are refused, if they are.
    pub fn refusal(&self) -> Option<Refusal> {
        capwalk_diff::refusal(&self.prepared)
    }
}
