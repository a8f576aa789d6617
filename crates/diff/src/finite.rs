//! Finite differences with common random numbers: the reference that
//! gradients are checked against, METHOD 9. They are central, or one-sided where a
//! parameter is at the end of what it can be.

use capwalk_boundary::{Counts, Draw, Method, Refusal};
use capwalk_math::Rgb;
use capwalk_render::tiles::{self, Averages, Sample};
use capwalk_render::{
    GradientImage, LeavesOut, Part, Plan, PreparedScene, Primal, RenderOptions, Tracer, Watch,
};
use capwalk_scene::{Scene, Tangent};

use crate::forward::left_out;

/// Where images are taken for a difference, see [`finite_difference`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stencil {
    /// One step away on both sides.
    #[default]
    Both,
    /// Here, and half a step and a step above.
    Above,
    /// Here, and half a step and a step below.
    Below,
}

/// An image of a difference.
struct Place {
    /// Where, in steps.
    at: f64,
    /// Its weight in the image that the derivative is of.
    value: f64,
    /// Its weight in the derivative, over the step.
    slope: f64,
}

impl Stencil {
    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Both => "both",
            Self::Above => "above",
            Self::Below => "below",
        }
    }

    /// Those on which the scene stays valid, both if it can: black does not become
    /// darker. Refuses a step that leaves the valid scenes on either side.
    pub fn of(scene: &Scene, tangent: &Tangent, step: f64) -> Result<Self, Refusal> {
        let side = |step| scene.moved(tangent, step).check();
        match (side(step), side(-step)) {
            (Ok(()), Ok(())) => Ok(Self::Both),
            (Ok(()), Err(_)) => Ok(Self::Above),
            (Err(_), Ok(())) => Ok(Self::Below),
            (Err(error), Err(_)) => Err(Refusal::InvalidStep {
                step,
                reason: error.to_string(),
            }),
        }
    }

    /// What is added up; each has an error of the order of the step squared.
    fn places(self) -> Vec<Place> {
        let place = |at, value, slope| Place { at, value, slope };
        let one_sided = |sign: f64| {
            vec![
                place(0.0, 1.0, -3.0 * sign),
                place(0.5 * sign, 0.0, 4.0 * sign),
                place(sign, 0.0, -sign),
            ]
        };
        match self {
            Self::Both => vec![place(1.0, 0.5, 0.5), place(-1.0, 0.5, -0.5)],
            Self::Above => one_sided(1.0),
            Self::Below => one_sided(-1.0),
        }
    }
}

/// The derivative of the image along `tangent` by central differences over
/// `±step`, in units of the parameter, or by one-sided ones where one of these leaves the
/// valid scenes, see [`Stencil`]. The same random numbers everywhere;
/// the mean is right up to terms of order `step²`, the variance grows like
/// `1 / step`. Works for everything that can be rendered; refuses a step that
/// makes the scene invalid on both sides.
pub fn finite_difference(
    scene: &Scene,
    tangent: &Tangent,
    step: f64,
    options: &RenderOptions,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    difference(scene, tangent, step, options, LeavesOut::Nothing, watch)
}

/// The same of the image that [`gradient_of_rest`](crate::gradient_of_rest) differentiates by
/// this method.
pub fn finite_difference_of_rest(
    scene: &Scene,
    tangent: &Tangent,
    step: f64,
    options: &RenderOptions,
    method: Method,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    difference(scene, tangent, step, options, left_out(method), watch)
}

fn difference(
    scene: &Scene,
    tangent: &Tangent,
    step: f64,
    options: &RenderOptions,
    leaves_out: LeavesOut,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    let places = Stencil::of(scene, tangent, step)?.places();
    let moved = |place: &Place| PreparedScene::new(scene.moved(tangent, place.at * step));
    let scenes: Vec<_> = places.iter().map(moved).collect();
    let plan = Plan::new(scene).for_differences();
    let tracer = |scene| {
        let tracer = Tracer::primal(scene).with_plan(plan);
        tracer.leaving_out(leaves_out)
    };
    let tracers: Vec<_> = scenes.iter().map(tracer).collect();
    let part = Part::whole(tiles::grid(scene, options));
    let sums = tiles::average(scene, options, None, &part, watch, |pixel, stream| {
        let draw = Draw {
            stream,
            counts: &Counts::default(),
        };
        let (mut value, mut difference) = (Rgb::zero(), Rgb::zero());
        for (tracer, place) in tracers.iter().zip(&places) {
            let light: Rgb = tracer.pixel(&Primal(tracer.accel), pixel, draw);
            value += light * place.value;
            difference += light * place.slope;
        }
        let [[a, b, c], [d, e, f]] = [value, difference / step].map(|rgb| rgb.to_array());
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
