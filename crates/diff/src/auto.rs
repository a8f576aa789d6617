//! The methods that choose ([`Method::Auto`], [`Method::FittedWalk`]): before the work, a few
//! samples are taken by each of several methods, and the one of the least variance × time does
//! all of it.
//!
//! Time is counted by what queries are asked and find ([`effort`]), not measured, and the
//! pilot has random numbers of its own: the choice is the same in every run and for every
//! number of threads, and independent of the samples that follow.

use std::f64::consts::FRAC_1_SQRT_2;
use std::sync::{Arc, OnceLock};

use capwalk_boundary::refuse::is_specular_somewhere;
use capwalk_boundary::{Counts, Draw, Field, Gathers, Method, Refusal, Sampler, pool};
use capwalk_geometry::effort;
use capwalk_math::{Moments, Rgb, Vec3};
use capwalk_render::tiles::EFFORT_OF_SAMPLE;
use capwalk_render::{MotionFacts, PreparedScene, Tracer, Watch};
use capwalk_scene::{BsdfId, Image, Optic, Scene, ShapeVectors, Tangent};
use capwalk_walk::WalkSettings;
use rayon::prelude::*;

use crate::adjoint::Wanted;
use crate::forward_eval::Forward;
use crate::options::GradientOptions;

/// A gradient's options with the method that a pilot chose, and what it tried.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// The options that were asked for, with the chosen method and its walk.
    pub options: GradientOptions,
    /// What was tried, in this order; nothing if nothing had to be chosen.
    pub trials: Vec<Trial>,
}

impl Chosen {
    /// What is known; else, unless `refuse` has an objection, the options themselves if they
    /// leave nothing to be chosen, or what `choose` gives. That becomes known unless the watch
    /// stopped it: what was stopped says nothing.
    pub(crate) fn of(
        options: &GradientOptions,
        known: &OnceLock<Self>,
        watch: &dyn Watch,
        refuse: impl FnOnce() -> Result<(), Refusal>,
        choose: impl FnOnce() -> Self,
    ) -> Result<Self, Refusal> {
        if let Some(known) = known.get() {
            return Ok(known.clone());
        }
        refuse()?;
        let is_open = options.method.is_open();
        let chosen = match is_open {
            true => choose(),
            false => Self {
                options: *options,
                trials: Vec::new(),
            },
        };
        match is_open && watch.should_stop() {
            true => Ok(chosen),
            false => Ok(known.get_or_init(|| chosen).clone()),
        }
    }
}

/// A method that was tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    /// The method.
    pub method: Method,
    /// The angular cutoff of its walks around surfaces, radians.
    pub max_radius: f64,
    /// The mean over the pixels of a sample's variance, summed over the channels; the
    /// hundredth of them where it is largest counts like the next one.
    pub variance: f64,
    /// The same with all that was met.
    pub whole_variance: f64,
    /// The mean effort of a sample, in about twenty nanoseconds.
    pub effort: f64,
}

impl Trial {
    /// What was found of some pixels by a method: the variance of the samples of each, and their
    /// effort in all.
    fn new(method: Method, max_radius: f64, found: &[(f64, u64)]) -> Self {
        let count = found.len() as f64;
        // The worst pixels count like the next one: an event that few pilots see would decide
        // alone. They all count where hardly any others have a variance at all.
        let mut variances: Vec<f64> = found.iter().map(|&(variance, _)| variance).collect();
        variances.sort_by(|a, b| b.total_cmp(a));
        let whole_variance: f64 = variances.iter().sum();
        let worst = variances.len().div_ceil(WORST);
        if let Some(&next) = variances.get(worst).filter(|&&next| next > 0.0) {
            variances[..worst].fill(next);
        }
        let variance: f64 = variances.iter().sum();
        let spent: u64 = found.iter().map(|(_, spent)| spent).sum();
        Self {
            method,
            max_radius,
            variance: variance / count,
            whole_variance: whole_variance / count,
            effort: EFFORT_OF_SAMPLE as f64 + spent as f64 / (count * f64::from(PER_PIXEL)),
        }
    }

    /// Variance × time: what is to be small.
    pub fn cost(&self) -> f64 {
        self.variance * self.effort
    }

    /// So much worse than one of these that more samples would not change it.
    fn is_hopeless(&self, trials: &[Self]) -> bool {
        let least = trials.iter().map(Self::cost).fold(f64::INFINITY, f64::min);
        self.cost() > HOPELESS * least
    }

    /// Better than another one by so much that so few samples can tell.
    fn beats(&self, other: &Self, clearly: f64) -> bool {
        // A trial without variance met nothing.
        self.variance > 0.0 && self.cost() < clearly * other.cost()
    }

    /// The same even with the worst pixels.
    fn beats_with_all(&self, other: &Self, clearly: f64) -> bool {
        let whole = |trial: &Self| trial.whole_variance * trial.effort;
        self.beats(other, clearly) && whole(self) < clearly * whole(other)
    }
}

/// Share of the work that each trial may take, and bounds of its samples.
const SHARE: u64 = 128;
const SAMPLES: [u64; 2] = [2048, 1 << 14];
/// Samples of each pixel in a trial: variances are those within pixels.
const PER_PIXEL: u32 = 4;

/// A trial that costs so many times as much as another one in the first part of its samples takes
/// no more, and none with another cutoff follows: a fitting one has cost a seventh at best.
const HOPELESS: f64 = 10.0;
/// One over that part.
const FIRST_PART: usize = 4;

/// One pixel of so many is taken for an accident, that of the largest variance.
const WORST: usize = 100;

/// What leaves the camera's rays at rest where gloss moves must be better by this factor, with the
/// worst pixels and without: it can have rare and large values, of which a pilot sees a few at best.
/// In scenes of this kind it has from a thousandth of the variance to 250 times.
const SURELY: f64 = 0.2;
/// The same where what moves is glossy itself. A pilot found it sixteen times better in
/// `rough_plastic_ball_moves` where it is thirteen times worse.
const MOST_SURELY: f64 = 0.05;

/// So many emitters say how wide they are.
const MOST_EMITTERS: usize = 16;

/// What is not better than by this factor is not preferred.
const CLEARLY: f64 = 0.9;
/// The same for walks towards other surfaces. Where those are near, as at the foot of an object,
/// walks have rare and large values, which hardly any pilot sees: in the built-in `ball`, with
/// paths of four segments, a variance of 0.4 instead of 1500.
const FAR: f64 = 1.0 / 3.0;

/// The best cutoff before an emitter, as a part of the emitter's angular width (METHOD 10).
/// Narrower fields are met by few samples: a pilot may not see them at all.
const PART_OF_EMITTER: f64 = 0.4;

/// Makes the random numbers of a pilot independent of those of the work; e.
const PILOT_SEED: u64 = 0xadf8_5458_a2bb_4a9a;

/// What a pilot differentiates, and by which samples.
pub struct Pilot<'a> {
    pub prepared: &'a PreparedScene,
    pub tangent: &'a Tangent,
    /// What is known of that motion.
    pub facts: &'a Arc<MotionFacts>,
    /// The factor of each pixel's derivative in what is asked for; without, the derivative
    /// image is.
    pub adjoint: Option<&'a Image>,
    pub options: &'a GradientOptions,
    pub watch: &'a dyn Watch,
}

impl Pilot<'_> {
    /// The method to be used. `Walk` if nothing was tried because nothing needs a choice:
    /// no curve in the image moves. Edges are gathered wherever they can be if that leaves fewer
    /// specular events `uncovered`: directions that stay do not move what is seen in curved
    /// mirrors and through glass.
    pub fn choose(&self, uncovered: impl Fn(&GradientOptions) -> u64) -> Chosen {
        let chosen = self.cheapest();
        if self.options.method != Method::Auto || !is_specular_somewhere(self.prepared.scene()) {
            return chosen;
        }
        let edges = GradientOptions {
            method: Method::EDGES,
            ..chosen.options
        };
        let missed = uncovered(&chosen.options);
        match missed > 0 && uncovered(&edges) < missed {
            true => Chosen {
                options: edges,
                ..chosen
            },
            false => chosen,
        }
    }

    /// The method of the least variance × time.
    fn cheapest(&self) -> Chosen {
        let mut trials = Vec::new();
        let best = self.best(&mut trials);
        let (method, max_radius) = best.map_or(
            (Method::Walk, self.options.walk.max_radius),
            |best: Trial| (best.method, best.max_radius),
        );
        let mut options = *self.options;
        options.method = method;
        options.walk.max_radius = max_radius;
        Chosen { options, trials }
    }

    /// Tries to gather edges along all segments, if gloss moves also with walks for the camera and
    /// indirect light, then without each kind of segment in turn, then with more and fewer points.
    fn best(&self, trials: &mut Vec<Trial>) -> Option<Trial> {
        if !Wanted::by(self.tangent).geometry() {
            return None;
        }
        let tracer = self.tracer(self.field(Method::Walk), self.options.walk);
        let mut everywhere = match self.options.method {
            Method::FittedWalk => Gathers::NONE,
            _ => tracer.can_gather(),
        };
        let fitting = self.emitter_width().map(|width| PART_OF_EMITTER * width);
        // Where it walks around surfaces, the cutoff that is asked for, and the fitting one.
        let mut with_cutoffs = |gathers: Gathers| {
            let fitting = fitting.filter(|_| tracer.walks_around_surfaces(gathers));
            self.with_cutoffs(gathers, fitting, trials)
        };
        let mut best = with_cutoffs(everywhere);
        let cautious = Gathers {
            camera: false,
            indirect: false,
            ..everywhere
        };
        if cautious != everywhere
            && let Some(surely) = self.moves_gloss(&tracer)
        {
            let walking = with_cutoffs(cautious);
            if !best.beats_with_all(&walking, surely) {
                (best, everywhere) = (walking, cautious);
            }
        }
        let mut gathers = everywhere;
        for segment in Gathers::SEGMENTS {
            if !everywhere.along(segment) {
                continue;
            }
            let without = gathers.without(segment);
            let trial = with_cutoffs(without);
            let clearly = if segment.indirect { FAR } else { CLEARLY };
            if trial.beats(&best, clearly) {
                (best, gathers) = (trial, without);
            }
        }
        if gathers.emitters {
            // More points on the edges before emitters, as long as that is better, or else fewer.
            let mut with = |points: u32, than: &Trial| {
                let method = Method::Edges(Gathers { points, ..gathers });
                let trial = self.trial(method, than.max_radius, trials);
                trial.beats(than, CLEARLY).then_some(trial)
            };
            best = match with(16, &best) {
                Some(more) => with(64, &more).unwrap_or(more),
                None => with(1, &best).unwrap_or(best),
            };
        }
        Some(best)
    }

    /// The share of a walk's cost below which rays that stay must be, if something with interpolated normals moves
    /// against the camera that is glossy, or lit by something glossy. They can have derivatives there
    /// so rare and so large that a pilot does not see them; the rays of a walk move along.
    fn moves_gloss(&self, tracer: &Tracer) -> Option<f64> {
        let scene = self.prepared.scene();
        let camera_moves = self.tangent.sensor.moves_rays();
        let mut materials = scene.shapes.iter().map(|shape| shape.bsdf);
        let lights = tracer.plan.reaches(3) && materials.any(|id| is_glossy(scene, id));
        let shapes = scene.shapes.iter().zip(&self.tangent.shapes);
        let factors = shapes.filter_map(|(shape, motion)| {
            let moves = camera_moves || motion.is_some();
            match moves && shape.normals.per_vertex().is_some() {
                true if is_glossy(scene, shape.bsdf) => Some(MOST_SURELY),
                true if lights => Some(SURELY),
                _ => None,
            }
        });
        factors.reduce(f64::min)
    }

    /// The better one of the cutoff that is asked for and another one, if that is narrower.
    fn with_cutoffs(&self, gathers: Gathers, other: Option<f64>, trials: &mut Vec<Trial>) -> Trial {
        let method = match gathers.is_nowhere() {
            true => Method::Walk,
            false => Method::Edges(gathers),
        };
        let asked = self.trial(method, self.options.walk.max_radius, trials);
        let is_hopeless = asked.is_hopeless(trials);
        let Some(angle) = other.filter(|&angle| angle < asked.max_radius && !is_hopeless) else {
            return asked;
        };
        let narrow = self.trial(method, angle, trials);
        match narrow.beats(&asked, CLEARLY) {
            true => narrow,
            false => asked,
        }
    }

    /// The mean angle under which what the camera sees is lit by area emitters, from side to
    /// side, radians; `None` if it sees nothing, or there are none.
    fn emitter_width(&self) -> Option<f64> {
        let (accel, scene) = (self.prepared.accel(), self.prepared.scene());
        let shapes = scene.emitters.iter().filter_map(|emitter| emitter.shape());
        let balls = shapes.take(MOST_EMITTERS).map(|shape| {
            let (low, high) = scene.shape(shape).mesh.bounds();
            ((low + high) * 0.5, 0.5 * (high - low).length())
        });
        let balls: Vec<(Vec3, f64)> = balls.collect();
        if balls.is_empty() {
            return None;
        }
        let mut widths = Moments::default();
        for [x, y] in self.pixels() {
            let offset = scene.film.crop_offset;
            let s = [(x, offset[0]), (y, offset[1])].map(|(k, first)| f64::from(k + first) + 0.5);
            let ray = accel.camera_ray(accel.view.origin, accel.view.direction(s));
            let Some(hit) = accel.first_hit_within(&ray) else {
                continue;
            };
            let seen = ray.origin + ray.direction * hit.t;
            for (centre, radius) in &balls {
                // A square is narrower than the ball around it.
                let sine = radius / (*centre - seen).length() * FRAC_1_SQRT_2;
                widths.add(2.0 * sine.min(1.0).asin());
            }
        }
        (widths.mean > 0.0).then_some(widths.mean)
    }

    /// The pixels that trials look at: evenly spread, of every row and column, at what the
    /// multiples of the golden ratio leave over.
    fn pixels(&self) -> Vec<[u32; 2]> {
        let [width, height] = self.prepared.scene().film.crop_size;
        let pixels = u64::from(width) * u64::from(height);
        let work = pixels * u64::from(self.options.spp);
        let samples = (work / SHARE).clamp(SAMPLES[0], SAMPLES[1]);
        let count = (samples / u64::from(PER_PIXEL)).min(pixels);
        let pixel = |i: u64| ((i as f64 * GOLDEN).fract() * pixels as f64) as u32;
        let pixels = (0..count).map(pixel);
        pixels.map(|pixel| [pixel % width, pixel / width]).collect()
    }

    fn tracer<'b>(&'b self, field: Field<'b>, walk: WalkSettings) -> Tracer<'b> {
        Tracer::moving(self.prepared, field, walk, self.facts)
    }

    fn field(&self, method: Method) -> Field<'_> {
        Field::new(self.prepared.accel(), self.prepared.boundaries(), method)
    }

    /// Variance and effort of some samples by a method. All trials take the same pixels and
    /// random numbers, but for those which are hopeless after the first of them.
    fn trial(&self, method: Method, max_radius: f64, trials: &mut Vec<Trial>) -> Trial {
        let is_this = |trial: &&Trial| (trial.method, trial.max_radius) == (method, max_radius);
        if let Some(known) = trials.iter().find(is_this) {
            return *known;
        }
        let pixels = self.pixels();
        let first = &pixels[..pixels.len().div_ceil(FIRST_PART)];
        let mut found = self.samples(method, max_radius, first);
        let short = Trial::new(method, max_radius, &found);
        let trial = match short.is_hopeless(trials) {
            true => short,
            false => {
                found.extend(self.samples(method, max_radius, &pixels[first.len()..]));
                Trial::new(method, max_radius, &found)
            }
        };
        trials.push(trial);
        trial
    }

    /// Variance of the samples of each of these pixels by a method, and their effort in all.
    fn samples(&self, method: Method, max_radius: f64, pixels: &[[u32; 2]]) -> Vec<(f64, u64)> {
        let scene = self.prepared.scene();
        let mut walk = self.options.walk;
        walk.max_radius = max_radius;
        let field = self.field(method);
        let eval = Forward::new(field, self.tangent);
        // Reverse mode samples without knowing velocities.
        let is_blind = self.adjoint.is_some() || self.options.blind;
        let eval = if is_blind { eval.blind() } else { eval };
        let tracer = self.tracer(field, walk);
        // If the watch stops this, no sample is taken either.
        let _ = tracer.build_edge_samplers(self.watch);
        let sampler = Sampler::new(&scene.settings, self.options.seed ^ PILOT_SEED, 1);
        let width = scene.film.crop_size[0];
        let look = |&[x, y]: &[u32; 2]| {
            let pixel = u64::from(y * width + x);
            let factor = self.adjoint.map(|image| image.pixels[pixel as usize]);
            let before = effort();
            let mut moments = [Moments::default(); 3];
            for number in 0..PER_PIXEL {
                if self.watch.should_stop() {
                    break;
                }
                let (stream, counts) = (sampler.stream(pixel, number), Counts::default());
                let draw = Draw {
                    stream: &stream,
                    counts: &counts,
                };
                let light = tracer.pixel(&eval, [x, y], draw);
                let derivative = asked_for(light.tangent(0), factor);
                // What is not finite is reported with the work itself.
                if derivative.iter().all(|x| x.is_finite()) {
                    let moments = moments.iter_mut().zip(derivative);
                    moments.for_each(|(moments, x)| moments.add(x));
                }
            }
            let variance: f64 = moments.iter().map(|m| m.variance()).sum();
            (variance, effort().wrapping_sub(before))
        };
        pool::install(|| pixels.par_iter().map(look).collect())
    }
}

/// True if a material, or one that it is made of, is glossy.
fn is_glossy(scene: &Scene, id: BsdfId) -> bool {
    let material = &scene.material(id).bsdf;
    let mut parts = material.parts().into_iter();
    let traits = material.traits();
    (traits.is_glossy && !traits.is_specular) || parts.any(|part| is_glossy(scene, part))
}

/// The fraction of the golden ratio.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// What of a pixel's derivative is asked for: itself, or its product with an adjoint.
fn asked_for(derivative: Rgb, adjoint: Option<Rgb>) -> [f64; 3] {
    let channels = derivative.to_array();
    match adjoint {
        None => channels,
        Some(adjoint) => {
            let products = adjoint.to_array().into_iter().zip(channels);
            [products.map(|(a, b)| a * b).sum(), 0.0, 0.0]
        }
    }
}

/// A motion of all geometry that is wanted, as a stand-in for what a gradient in reverse mode
/// will be multiplied by: each shape moves and turns in a direction of its own, at the
/// speed of one.
pub fn motion(scene: &Scene, wanted: &Wanted) -> Tangent {
    let mut motion = Tangent::zero(scene);
    for (number, shape) in scene.shapes.iter().enumerate() {
        if !wanted.shapes[number] {
            continue;
        }
        let (low, high) = shape.mesh.bounds();
        let (centre, radius) = ((low + high) * 0.5, 0.5 * (high - low).length());
        let turn = direction(2 * number + 1) / radius.max(f64::MIN_POSITIVE);
        let velocity = |&p: &Vec3| direction(2 * number) + turn.cross(p - centre);
        motion.shapes[number] = Some(ShapeVectors {
            vertices: shape.mesh.positions.iter().map(velocity).collect(),
            normals: None,
        });
    }
    let last = 2 * scene.shapes.len();
    if wanted.sensor_origin {
        motion.sensor.translation = direction(last);
    }
    if wanted.sensor_axes {
        motion.sensor.rotation = direction(last + 1);
    }
    if wanted.aperture {
        motion.sensor.add_optic(Optic::ApertureRadius, 1.0);
    }
    motion
}

/// The `i`-th of unit vectors that are spread over the sphere.
fn direction(i: usize) -> Vec3 {
    let [u, v] = [GOLDEN, GOLDEN * GOLDEN].map(|k| ((i + 1) as f64 * k).fract());
    let z = 1.0 - 2.0 * u;
    let (sin, cos) = (2.0 * std::f64::consts::PI * v).sin_cos();
    Vec3::new(cos, sin, 0.0) * (1.0 - z * z).sqrt() + Vec3::new(0.0, 0.0, z)
}
