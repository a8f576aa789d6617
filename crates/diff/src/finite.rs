//! Central differences with common random numbers: the reference that
//! gradients are checked against, METHOD 9.

use capwalk_boundary::{Counts, Draw, Refusal};
use capwalk_math::Rgb;
use capwalk_render::tiles::{self, Averages, Sample};
use capwalk_render::{
    GradientImage, Part, Plan, PreparedScene, Primal, RenderOptions, Tracer, Watch,
};
use capwalk_scene::{Scene, Tangent};

/// The derivative of the image along `tangent` by central differences over
/// `±step`, in units of the parameter. The same random numbers on both sides;
/// the mean is right up to terms of order `step²`, the variance grows like
/// `1 / step`. Works for everything that can be rendered; refuses a step that
/// makes the scene invalid.
pub fn finite_difference(
    scene: &Scene,
    tangent: &Tangent,
    step: f64,
    options: &RenderOptions,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    let sides = [step, -step].map(|step| scene.moved(tangent, step));
    for side in &sides {
        side.check().map_err(|error| Refusal::InvalidStep {
            step,
            reason: error.to_string(),
        })?;
    }
    let sides = sides.map(PreparedScene::new);
    let plan = Plan::new(scene).for_differences();
    let tracers = sides
        .each_ref()
        .map(|side| Tracer::primal(side).with_plan(plan));
    let part = Part::whole(tiles::grid(scene, options));
    let sums = tiles::average(scene, options, None, &part, watch, |pixel, stream| {
        let draw = Draw {
            stream,
            counts: &Counts::default(),
        };
        let [plus, minus] =
            [0, 1].map(|i| tracers[i].pixel(&Primal(tracers[i].accel), pixel, draw));
        let value: Rgb = (plus + minus) * 0.5;
        let difference: Rgb = (plus - minus) / (2.0 * step);
        let [[a, b, c], [d, e, f]] = [value, difference].map(|rgb| rgb.to_array());
        Sample {
            numbers: [a, b, c, d, e, f],
            cone_queries: 0,
            uncovered: 0,
        }
    });
    let averages = Averages::new(sums.into_sums(), options);
    Ok(GradientImage {
        value: averages.estimate(scene, 0),
        gradient: averages.estimate(scene, 3),
        missing: None,
        statistics: averages.statistics,
    })
}
