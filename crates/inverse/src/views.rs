//! The views of a problem, ready to be rendered again and again.

use capwalk_diff::{PreparedScene, Watch};
use capwalk_scene::Scene;

use crate::problem::Problem;

/// A prepared scene for every view, kept from iteration to iteration: where vertices move
/// a little, trees are refitted instead of built, and where colours change, nothing is.
/// What they were used for before changes no bit of a result.
#[derive(Debug, Default)]
pub struct PreparedViews {
    prepared: Vec<PreparedScene>,
}

impl PreparedViews {
    /// None yet: the first iteration prepares them.
    pub fn new() -> Self {
        Self::default()
    }

    /// A scene as each view of the problem sees it; `None` if the watch stops the preparation.
    pub(crate) fn of(
        &mut self,
        problem: &Problem,
        scene: &Scene,
        watch: &dyn Watch,
    ) -> Option<&[PreparedScene]> {
        self.prepared.truncate(problem.views.len());
        for (i, view) in problem.views.iter().enumerate() {
            let seen = view.scene(scene);
            match self.prepared.get_mut(i) {
                Some(prepared) => prepared.update_watched(seen, watch),
                None => self
                    .prepared
                    .push(PreparedScene::try_new(seen, watch).ok()?),
            }
        }
        Some(&self.prepared)
    }
}
