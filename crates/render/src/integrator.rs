//! The picture itself.

use capwalk_scene::Scene;

use crate::accel::Accel;
use crate::diff::boundary::{Counts, Draw};
use crate::estimate::Rendering;
use crate::options::{Options, Watch};
use crate::path::Tracer;
use crate::tiles::{self, Sample};
use crate::world::AtRest;

/// The picture of a scene. The scene must have passed [`Scene::check`].
pub fn render(scene: &Scene, options: &Options, watch: &dyn Watch) -> Rendering {
    let accel = Accel::new(scene);
    let (tracer, world) = (Tracer::at_rest(&accel), AtRest(&accel));
    let averages = tiles::average(scene, options, watch, |pixel, stream| {
        let draw = Draw {
            stream,
            counts: &Counts::default(),
        };
        Sample {
            numbers: tracer.pixel(&world, pixel, draw).to_array(),
            cone_queries: 0,
            uncovered: 0,
        }
    });
    Rendering {
        value: averages.estimate(scene, 0),
        statistics: averages.statistics,
    }
}
