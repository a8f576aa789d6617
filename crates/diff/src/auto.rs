//! The method that chooses ([`Method::Auto`]): before the work, a few samples are taken by
//! each of several methods, and the one of the least variance × time does all of it.
//!
//! Time is counted in the steps of queries ([`effort`]), not measured, and the pilot has
//! random numbers of its own: the choice is the same in every run, on every machine and for
//! every number of threads, and independent of the samples that follow.

use capwalk_boundary::{Counts, Draw, Field, Gathers, Method, Sampler, pool};
use capwalk_geometry::effort;
use capwalk_math::{Moments, Rgb, Vec3};
use capwalk_render::{PreparedScene, Tracer, Watch};
use capwalk_scene::{Image, Optic, Scene, ShapeVectors, Tangent};
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
    /// Options that leave nothing to be chosen.
    pub(crate) fn given(options: GradientOptions) -> Self {
        Self {
            options,
            trials: Vec::new(),
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
    /// The mean over the pixels of a sample's variance, summed over the channels.
    pub variance: f64,
    /// The mean effort of a sample, in nodes of a ray tree.
    pub effort: f64,
}

impl Trial {
    /// Variance × time: what is to be small.
    pub fn cost(&self) -> f64 {
        self.variance * self.effort
    }

    /// Clearly better than another one: as far as so few samples can tell.
    fn beats(&self, other: &Self) -> bool {
        self.cost() < CLEARLY * other.cost()
    }
}

/// Share of the work that each trial may take, and bounds of its samples.
const SHARE: u64 = 128;
const SAMPLES: [u64; 2] = [512, 1 << 14];
/// Samples of each pixel in a trial: variances are those within pixels.
const PER_PIXEL: u32 = 4;

/// Effort of a sample besides its queries: shading, sampling and their derivatives.
const EFFORT_OF_SAMPLE: u64 = 100;

/// What is not better than by this factor is not preferred.
const CLEARLY: f64 = 0.9;
/// From each cutoff that is tried to the next one, and how many are.
const NARROWER: f64 = 1.0 / 3.0;
const CUTOFFS: usize = 4;

/// Makes the random numbers of a pilot independent of those of the work; e.
const PILOT_SEED: u64 = 0xadf8_5458_a2bb_4a9a;

/// What a pilot differentiates, and by which samples.
pub struct Pilot<'a> {
    pub prepared: &'a PreparedScene,
    pub tangent: &'a Tangent,
    /// The factor of each pixel's derivative in what is asked for; without, the derivative
    /// image is.
    pub adjoint: Option<&'a Image>,
    pub options: &'a GradientOptions,
    pub watch: &'a dyn Watch,
}

impl Pilot<'_> {
    /// The method to be used. `Walk` if nothing was tried because nothing needs a choice:
    /// no curve in the image moves.
    pub fn choose(&self) -> Chosen {
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

    /// Tries to gather edges along all segments, then without each kind of them in turn.
    fn best(&self, trials: &mut Vec<Trial>) -> Option<Trial> {
        if !Wanted::by(self.tangent).geometry() {
            return None;
        }
        let tracer = Tracer::moving(self.prepared, self.field(Method::Walk), self.options.walk);
        let everywhere = tracer.can_gather();
        let mut gathers = everywhere;
        let mut best = self.with_cutoffs(&tracer, gathers, trials);
        for segment in Gathers::SEGMENTS {
            if !everywhere.along(segment) {
                continue;
            }
            let without = gathers.without(segment);
            let trial = self.with_cutoffs(&tracer, without, trials);
            if trial.beats(&best) {
                (best, gathers) = (trial, without);
            }
        }
        Some(best)
    }

    /// Where this walks around surfaces, ever narrower cutoffs, as long as they help.
    fn with_cutoffs(&self, tracer: &Tracer, gathers: Gathers, trials: &mut Vec<Trial>) -> Trial {
        let method = match gathers {
            Gathers::NONE => Method::Walk,
            gathers => Method::Edges(gathers),
        };
        let mut best = self.trial(method, self.options.walk.max_radius, trials);
        if !tracer.walks_around_surfaces(gathers) {
            return best;
        }
        for _ in 0..CUTOFFS {
            let next = self.trial(method, best.max_radius * NARROWER, trials);
            if !next.beats(&best) {
                break;
            }
            best = next;
        }
        best
    }

    fn field(&self, method: Method) -> Field<'_> {
        Field::new(self.prepared.accel(), self.prepared.boundaries(), method)
    }

    /// Variance and effort of some samples by a method. All trials take the same pixels and
    /// random numbers.
    fn trial(&self, method: Method, max_radius: f64, trials: &mut Vec<Trial>) -> Trial {
        let scene = self.prepared.scene();
        let mut walk = self.options.walk;
        walk.max_radius = max_radius;
        let field = self.field(method);
        let eval = Forward::new(field, self.tangent);
        // Reverse mode samples without knowing velocities.
        let is_blind = self.adjoint.is_some() || self.options.blind;
        let eval = if is_blind { eval.blind() } else { eval };
        let tracer = Tracer::moving(self.prepared, field, walk);
        let sampler = Sampler::new(&scene.settings, self.options.seed ^ PILOT_SEED, 1);
        let [width, height] = scene.film.crop_size;
        let pixels = u64::from(width) * u64::from(height);
        let work = pixels * u64::from(self.options.spp);
        let samples = (work / SHARE).clamp(SAMPLES[0], SAMPLES[1]);
        let count = (samples / u64::from(PER_PIXEL)).min(pixels);
        // Evenly spread pixels, of every row and column: what a multiple of the golden ratio
        // leaves over.
        let pixel = |i: u64| ((i as f64 * GOLDEN).fract() * pixels as f64) as u64;
        let look = |pixel: u64| {
            let position = [pixel % u64::from(width), pixel / u64::from(width)];
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
                let light = tracer.pixel(&eval, position.map(|x| x as u32), draw);
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
        let found: Vec<(f64, u64)> = pool::install(|| {
            let pixels = (0..count).into_par_iter();
            pixels.map(|i| look(pixel(i))).collect()
        });
        let variance: f64 = found.iter().map(|(variance, _)| variance).sum();
        let spent: u64 = found.iter().map(|(_, spent)| spent).sum();
        let trial = Trial {
            method,
            max_radius,
            variance: variance / count as f64,
            effort: EFFORT_OF_SAMPLE as f64 + spent as f64 / (count * u64::from(PER_PIXEL)) as f64,
        };
        trials.push(trial);
        trial
    }
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
