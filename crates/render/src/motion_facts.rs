//! What follows from a motion, whichever samples ask for it first.

use std::sync::OnceLock;

use capwalk_boundary::{Accel, Motion};
use capwalk_geometry::{EdgeSubset, uncounted};
use capwalk_scene::Scene;

use crate::chain_survey::{ChainSurvey, may_have_chains};
use crate::estimate::Dips;
use crate::pixel_silhouettes::PixelSilhouettes;

/// What tracers find out about one motion of a prepared scene; kept, it changes no result. Tracers
/// of the same motion, as far as sampling knows it, can share it, whatever their methods: with the
/// same boundaries and plan, and either all in forward mode or all blind to velocities. A pass that
/// does not know how fast something moves must not know what does not move.
#[derive(Debug, Default)]
pub struct MotionFacts {
    /// True if it may move what is seen in mirrors or through glass.
    turns_light: bool,
    /// The silhouettes in each pixel, where the camera's rays all start from one point.
    pub(crate) silhouettes: PixelSilhouettes,
    /// The motions of the nodes of both edge samplers.
    pub(crate) edge_motions: [OnceLock<Vec<Motion>>; 2],
    /// The edges that may move.
    pub(crate) moving_edges: OnceLock<EdgeSubset>,
    /// True if a flat mirror may move.
    pub(crate) mirrors_move: OnceLock<bool>,
    /// How much the motion differs within the planes of flat mirrors.
    pub(crate) mirror_spreads: OnceLock<Vec<f64>>,
    /// What some paths tell of chains of specular events.
    chain_survey: OnceLock<ChainSurvey>,
}

impl MotionFacts {
    /// None yet, of a motion of a scene, which may move what is seen in mirrors or through glass if it
    /// `turns_light`.
    pub fn of(scene: &Scene, turns_light: bool) -> Self {
        Self {
            turns_light,
            silhouettes: PixelSilhouettes::of(scene),
            ..Self::default()
        }
    }

    /// What some paths tell of chains of specular events.
    pub(crate) fn chain_survey(&self, accel: &Accel) -> &ChainSurvey {
        let known = &self.chain_survey;
        known.get_or_init(|| uncounted(|| ChainSurvey::of(accel)))
    }

    /// How often rays dip below faces in a scene, if this moves what is seen in curved mirrors or through glass there.
    pub fn dips(&self, accel: &Accel) -> Dips {
        match self.turns_light && may_have_chains(accel) {
            true => self.chain_survey(accel).dips,
            false => Dips::default(),
        }
    }

    /// True if it may move what is seen in mirrors or through glass.
    pub fn turns_light(&self) -> bool {
        self.turns_light
    }
}
