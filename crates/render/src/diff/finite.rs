//! Central differences with common random numbers: the reference that
//! gradients are checked against, METHOD 9.

use capwalk_math::Rgb;
use capwalk_scene::{Motion, Scene};

use crate::accel::Accel;
use crate::estimate::GradientImage;
use crate::options::{Options, Refusal, Watch};
use crate::path::Tracer;
use crate::tiles::{self, Sample};
use crate::world::AtRest;

use super::boundary::{Counts, Draw};

/// The derivative of the picture along `motion` by central differences over
/// `±step`, in units of the parameter. The same random numbers on both sides;
/// the mean is right up to terms of order `step²`, the variance grows like
/// `1 / step`. Works for everything that can be rendered; refuses a step that
/// makes the scene invalid.
pub fn finite_difference(
    scene: &Scene,
    motion: &Motion,
    step: f64,
    options: &Options,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    let sides = [step, -step].map(|step| scene.moved(motion, step));
    for side in &sides {
        side.check().map_err(|error| Refusal {
            reason: format!(
                "a finite difference over ±{step} leaves the valid scenes: {error}. \
                 Choose a smaller step"
            ),
        })?;
    }
    let [above, below] = [Accel::new(&sides[0]), Accel::new(&sides[1])];
    let tracers = [Tracer::at_rest(&above), Tracer::at_rest(&below)];
    let averages = tiles::average(scene, options, watch, |pixel, stream| {
        let draw = Draw {
            stream,
            counts: &Counts::default(),
        };
        let [plus, minus] =
            [0, 1].map(|i| tracers[i].pixel(&AtRest(tracers[i].accel), pixel, draw));
        let value: Rgb = (plus + minus) * 0.5;
        let slope: Rgb = (plus - minus) / (2.0 * step);
        Sample {
            numbers: [value.x, value.y, value.z, slope.x, slope.y, slope.z],
            cone_queries: 0,
            uncovered: 0,
        }
    });
    Ok(GradientImage {
        value: averages.estimate(scene, 0),
        gradient: averages.estimate(scene, 3),
        statistics: averages.statistics,
    })
}
