//! Finite differences with common random numbers: the reference that
//! gradients are checked against, METHOD 9. They are central, or one-sided where a
//! parameter is at the end of what it can be.

use std::sync::OnceLock;

use capwalk_boundary::Refusal;
use capwalk_math::Vec3;
use capwalk_render::tiles::{
    self, Averages, PixelSums, Sample, SampleCounts, SampleRun, count_samples,
};
use capwalk_render::{
    Estimate, Part, Partial, Plan, PreparedScene, RayPrecision, RenderOptions, Watch, adaptive,
    take_light,
};
use capwalk_scene::{Scene, Tangent};

use crate::gradient_image::GradientImage;

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
    difference: f64,
}

impl Place {
    /// Adds what is seen there to a sample of the light and its derivative, which lacks the step.
    fn add(&self, light: &Sample<3>, sum: &mut Sample<NUMBERS>) {
        for (i, light) in light.numbers.into_iter().enumerate() {
            sum.numbers[i] += light * self.value;
            sum.numbers[DERIVATIVE + i] += light * self.difference;
        }
        sum.effort += light.effort;
    }
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
    /// darker. Refuses a step that leaves the valid scenes on either side, and one so small that
    /// both sides are the same, unless they are at every step.
    pub fn of(scene: &Scene, tangent: &Tangent, step: f64) -> Result<Self, Refusal> {
        let [above, below] = [step, -step].map(|step| scene.moved(tangent, step));
        let is_lost = above == below && scene.moved(tangent, 1.0) != *scene;
        if is_lost || is_below_rounding(scene, tangent, step) {
            return Err(Refusal::StepTooSmall { step });
        }
        match (above.check(), below.check()) {
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
        let place = |at, value, difference| Place {
            at,
            value,
            difference,
        };
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

/// True if only vertices and the sensor's position move, all of them by less than what rounding
/// leaves of the largest coordinate of their shape or the sensor: what is at zero changes then, and
/// nothing else.
fn is_below_rounding(scene: &Scene, tangent: &Tangent, step: f64) -> bool {
    let largest = |v: &Vec3| v.x.abs().max(v.y.abs()).max(v.z.abs());
    let largest_of = |vectors: &[Vec3]| vectors.iter().map(largest).fold(0.0, f64::max);
    let shapes = scene.shapes.iter().zip(&tangent.shapes);
    let shapes = shapes.filter_map(|(shape, moving)| {
        let velocity = largest_of(&moving.as_ref()?.vertices);
        Some([velocity, largest_of(&shape.mesh.positions)])
    });
    let origin = scene.sensor.state().origin;
    let sensor = [largest(&tangent.sensor.translation), largest(&origin)];
    let moving = shapes
        .chain([sensor])
        .filter(|[velocity, _]| *velocity > 0.0);
    let moving: Vec<[f64; 2]> = moving.collect();
    let mut others = tangent.clone();
    others.sensor.translation = Vec3::zero();
    let turned = others.shapes.iter_mut().flatten();
    turned.for_each(|shape| shape.vertices.fill(Vec3::zero()));
    let is_alone = others.numbers().all(|velocity| velocity == 0.0);
    let is_lost = |&[velocity, size]: &[f64; 2]| step * velocity < f64::EPSILON * size;
    is_alone && !moving.is_empty() && moving.iter().all(is_lost)
}

/// The derivative of the image along `tangent` by central differences over
/// `±step`, in units of the parameter, or by one-sided ones where one of these leaves the
/// valid scenes, see [`Stencil`]. The same random numbers everywhere;
/// the mean is right up to terms of order `step²`, the variance grows like
/// `1 / step`. Works for everything that can be rendered; refuses a step that
/// makes the scene invalid on both sides.
pub fn finite_difference(
    prepared: &PreparedScene,
    tangent: &Tangent,
    step: f64,
    options: &RenderOptions,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    Ok(Differences::new(prepared, tangent, step)?.image(options, watch))
}

/// The scenes that a difference is taken between, ready to be rendered, see
/// [`finite_difference`].
pub struct Differences<'a> {
    scene: &'a Scene,
    step: f64,
    stencil: Stencil,
    places: Vec<Place>,
    /// As many as places.
    scenes: Vec<PreparedScene>,
}

impl<'a> Differences<'a> {
    /// Moves the scene; what stays is not prepared again.
    pub fn new(prepared: &'a PreparedScene, tangent: &Tangent, step: f64) -> Result<Self, Refusal> {
        let scene = &**prepared.scene();
        let stencil = Stencil::of(scene, tangent, step)?;
        let places = stencil.places();
        let moved = |place: &Place| prepared.updated(scene.moved(tangent, place.at * step));
        Ok(Self {
            scene,
            step,
            stencil,
            scenes: places.iter().map(moved).collect(),
            places,
        })
    }

    /// To which sides the parameter moves.
    pub fn stencil(&self) -> Stencil {
        self.stencil
    }

    /// The image and its derivative.
    pub fn image(&self, options: &RenderOptions, watch: &dyn Watch) -> GradientImage {
        let (known, first) = (OnceLock::new(), DERIVATIVE);
        let counts =
            adaptive::sample_counts(&known, self.scene, options, watch, first, |pilot, watch| {
                self.average(pilot, &SampleCounts::Even, watch)
            });
        self.image_of(&counts, options, watch)
    }

    /// [`Self::image`] with as many samples per pixel, which are returned too, as are best beside
    /// a gradient: their difference has the least variance for the time of both if each takes
    /// time in proportion to the root of its variance × time. Those of the options, if nothing
    /// has any noise. One pilot tells how noisy the whole is, and each pixel.
    pub fn image_beside(
        &self,
        gradient: &GradientImage,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> (u32, GradientImage) {
        let noise = adaptive::noise(self.scene, options, watch, DERIVATIVE, |pilot, watch| {
            self.average(pilot, &SampleCounts::Even, watch)
        });
        let effort = gradient.statistics.effort as f64;
        let root = (mean_variance(&gradient.gradient) * effort).sqrt();
        let Some(noise) = noise.filter(|noise| noise.root > 0.0) else {
            let image = self.image_of(&SampleCounts::Even, options, watch);
            return (options.spp, image);
        };
        let spp = match root > 0.0 {
            true => {
                let times = (noise.root / root).clamp(1.0 / MOST_TIMES, MOST_TIMES);
                let spp = times * effort / noise.effort_of_spp;
                (spp.round() as u32).max(FEWEST.min(options.spp))
            }
            false => options.spp,
        };
        let options = RenderOptions { spp, ..*options };
        let counts = match options.adaptive {
            true => noise.counts(self.scene, &options),
            false => SampleCounts::Even,
        };
        (spp, self.image_of(&counts, &options, watch))
    }

    fn image_of(
        &self,
        counts: &SampleCounts,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> GradientImage {
        let averages = Averages::new(self.average(options, counts, watch).into_sums());
        GradientImage {
            value: averages.estimate(self.scene, 0),
            gradient: averages.estimate(self.scene, DERIVATIVE),
            chosen: None,
            statistics: averages.statistics,
        }
    }

    fn average(
        &self,
        options: &RenderOptions,
        counts: &SampleCounts,
        watch: &dyn Watch,
    ) -> Partial<PixelSums> {
        // In double precision: what single precision does not resolve would move between the two sides.
        let plan = Plan::new(self.scene).for_differences();
        let lights =
            (self.scenes.iter()).map(|scene| take_light(plan, scene, RayPrecision::Double));
        let lights: Vec<_> = lights.collect();
        let take = |runs: &[SampleRun], taken: &mut Vec<Sample<NUMBERS>>| {
            let (first, count) = (taken.len(), count_samples(runs));
            taken.resize(first + count, Sample::default());
            let sums = &mut taken[first..];
            let mut light = Vec::with_capacity(count);
            for (take_light, place) in lights.iter().zip(&self.places) {
                light.clear();
                take_light(runs, &mut light);
                for (sum, light) in sums.iter_mut().zip(&light) {
                    place.add(light, sum);
                }
            }
            let differences = sums
                .iter_mut()
                .flat_map(|sum| &mut sum.numbers[DERIVATIVE..]);
            differences.for_each(|difference| *difference /= self.step);
        };
        let part = Part::whole(tiles::grid(self.scene, options));
        tiles::average(self.scene, options, counts, None, &part, watch, take)
    }
}

/// The numbers of a sample: the light, and its derivative.
const NUMBERS: usize = 2 * DERIVATIVE;

/// Which of a sample's numbers is the first of the derivative.
const DERIVATIVE: usize = 3;

/// The time of differences beside a gradient, as a multiple of that of the gradient or a part of
/// it, at most.
const MOST_TIMES: f64 = 4.0;

/// The fewest samples per pixel of differences beside a gradient, unless fewer are asked for.
const FEWEST: u32 = 16;

/// The mean over the pixels of the variance, summed over the channels.
fn mean_variance(estimate: &Estimate) -> f64 {
    let errors = estimate.standard_error.pixels.iter();
    let squares = errors.filter(|e| e.is_finite()).map(|&e| {
        let [r, g, b] = (e * e).to_array();
        r + g + b
    });
    squares.sum::<f64>() / estimate.standard_error.pixels.len() as f64
}
