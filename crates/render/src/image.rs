//! The primal image.

use capwalk_boundary::{Counts, Draw};

use crate::estimate::Rendering;
use crate::options::{RenderOptions, Watch};
use crate::prepared::PreparedScene;
use crate::scene_eval::Primal;
use crate::tiles::{self, Sample};
use crate::tracer::Tracer;

/// The image of a scene, with its standard error.
pub fn render(prepared: &PreparedScene, options: &RenderOptions, watch: &dyn Watch) -> Rendering {
    let (tracer, eval) = (Tracer::primal(prepared), Primal(prepared.accel()));
    let averages = tiles::average(prepared.scene(), options, watch, |pixel, stream| {
        let draw = Draw {
            stream,
            counts: &Counts::default(),
        };
        Sample {
            numbers: tracer.pixel(&eval, pixel, draw).to_array(),
            cone_queries: 0,
            uncovered: 0,
        }
    });
    Rendering {
        value: averages.estimate(prepared.scene(), 0),
        statistics: averages.statistics,
    }
}
