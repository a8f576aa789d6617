//! The calls into the renderer, all in one place.

use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

use capwalk_diff::{
    BackwardWork, Differences, GradientOptions, GradientWork, Halted, KeptChoice, PreparedScene,
    Refusal, RenderOptions, RenderWork, Rendering, Wanted, Watch,
};
use capwalk_scene::params::Registry;
use capwalk_scene::{Image, Scene, Tangent};

use crate::choices::{Choices, Differentiated};

/// A scene that is ready to be rendered.
#[derive(Debug)]
pub struct Engine {
    prepared: PreparedScene,
    /// Made when the first name is asked for. Numbers that change do not change names.
    registry: OnceLock<Registry>,
    /// The methods that were chosen for this scene, or before numbers of it changed.
    choices: Choices,
}

impl Engine {
    pub fn new(scene: impl Into<Arc<Scene>>) -> Self {
        Self {
            prepared: PreparedScene::new(scene),
            registry: OnceLock::new(),
            choices: Choices::default(),
        }
    }

    pub fn watched(scene: Arc<Scene>, watch: &dyn Watch) -> Result<Self, Halted> {
        Ok(Self {
            prepared: PreparedScene::try_new(scene, watch)?,
            registry: OnceLock::new(),
            choices: Choices::default(),
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

    /// Goes over to a scene with the same names and other numbers. Its methods stay chosen.
    pub fn update(&mut self, scene: impl Into<Arc<Scene>>) {
        self.prepared.update(scene);
    }

    /// Goes over to any other scene.
    pub fn replace(&mut self, scene: Arc<Scene>) {
        self.prepared.update(scene);
        self.registry = OnceLock::new();
        self.choices = Choices::default();
    }

    pub fn render(&self, options: &RenderOptions, watch: &dyn Watch) -> Rendering {
        capwalk_diff::render(&self.prepared, options, watch)
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
        let kept = self.choice(Differentiated::Loss(wanted.clone()), options);
        BackwardWork::new(&self.prepared, adjoint, wanted, *options).keeping(kept)
    }

    /// The derivative along a tangent; with its name, the method is kept.
    pub fn gradient_work<'a>(
        &'a self,
        tangent: Cow<'a, Tangent>,
        name: Option<&str>,
        options: &GradientOptions,
    ) -> GradientWork<'a> {
        let work = GradientWork::new(&self.prepared, tangent, *options);
        match name {
            Some(name) => work.keeping(self.choice(Differentiated::Along(name.into()), options)),
            None => work,
        }
    }

    /// The place of the method that these options leave to be chosen; one of its own if none.
    fn choice(&self, what: Differentiated, options: &GradientOptions) -> KeptChoice {
        match options.method.is_open() {
            true => self.choices.of(self.scene(), what, options),
            false => KeptChoice::default(),
        }
    }

    pub fn render_work(&self, options: &RenderOptions) -> RenderWork<'_> {
        RenderWork::new(&self.prepared, *options)
    }

    /// Why derivatives with respect to what moves edges are refused, if they are.
    pub fn refusal(&self) -> Option<Refusal> {
        capwalk_diff::refusal(&self.prepared)
    }
}
