//! A problem whose targets are still to be rendered, and their images.

use capwalk_diff::{Chosen, PreparedScene, RenderOptions, Watch};
use capwalk_inverse::Problem;
use capwalk_scene::{Image, Scene};
use capwalk_scene_io::{FilesRead, Warning};

use crate::error::Error;

/// The problem that a job poses.
#[derive(Clone, Debug)]
pub struct LoadedProblem {
    /// The problem, with all of its targets.
    pub problem: Problem,
    /// How its method was chosen; `None` if the job names one, if its derivatives are
    /// refused, or if the watch stopped it.
    pub chosen: Option<Chosen>,
    /// Warnings about the scene files that it was loaded from, each once.
    pub warnings: Vec<Warning>,
}

/// A problem of which some targets are still to be rendered.
#[derive(Debug)]
pub(super) struct PosedProblem {
    pub problem: Problem,
    pub pending: Vec<Pending>,
    pub warnings: Vec<Warning>,
    /// All files that it was read from.
    pub files: FilesRead,
}

/// A target that is still to be rendered.
#[derive(Debug)]
pub(super) struct Pending {
    /// The number of its view.
    pub view: usize,
    pub scene: Scene,
    pub options: RenderOptions,
}

impl PosedProblem {
    /// The problem with all of its targets, and the method that its gradients take.
    pub fn rendered(self, watch: &dyn Watch) -> Result<LoadedProblem, Error> {
        let Self {
            mut problem,
            pending,
            warnings,
            ..
        } = self;
        for (view, target) in render_targets(pending, watch)? {
            problem.views[view].target = target;
        }
        // With the targets, which need no gradient, all that the choice depends on is there.
        let chosen = problem.choose_method(watch);
        Ok(LoadedProblem {
            problem,
            chosen,
            warnings,
        })
    }
}

/// The images of all targets with the numbers of their views; an error if they were
/// stopped, or cannot be computed.
fn render_targets(pending: Vec<Pending>, watch: &dyn Watch) -> Result<Vec<(usize, Image)>, Error> {
    let work =
        |target: &Pending| target.scene.film.pixel_count() as u64 * u64::from(target.options.spp);
    let total = pending.iter().map(work).sum();
    let mut before = 0;
    let mut images = Vec::new();
    for target in pending {
        let work = work(&target);
        let share = Share {
            watch,
            before,
            total,
        };
        let rendering =
            capwalk_diff::render(&PreparedScene::new(target.scene), &target.options, &share);
        if !rendering.statistics.complete {
            return Err(Error::Stopped {
                before: "the targets were rendered",
            });
        }
        if rendering.statistics.too_many_non_finite() {
            return Err(Error::NonFiniteTarget {
                view: target.view + 1,
                non_finite: rendering.statistics.non_finite,
                samples: rendering.statistics.samples,
            });
        }
        images.push((target.view, rendering.value.mean));
        before += work;
    }
    Ok(images)
}

/// One of several pieces of work, as a part of the whole.
struct Share<'a> {
    watch: &'a dyn Watch,
    before: u64,
    total: u64,
}

impl Watch for Share<'_> {
    fn progress(&self, done: u64, _total: u64) {
        self.watch.progress(self.before + done, self.total);
    }

    fn should_stop(&self) -> bool {
        self.watch.should_stop()
    }
}
