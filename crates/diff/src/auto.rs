//! The methods that choose ([`Method::Auto`], [`Method::FittedWalk`]): before the work, a few
//! samples are taken by each of several methods, and the one of the least variance × time does
//! all of it.
//!
//! Time is counted by what queries are asked and find ([`effort`]), not measured, and the
//! pilot has random numbers of its own, whatever the seed: the choice is the same in every run and
//! for every number of threads, and independent of the samples that follow. It is a function of the
//! scene, what moves, the method that is asked for, and the [size](PilotSize) of the work.

mod chosen;
mod size;
mod stand_in;
mod trial;

pub use chosen::{Chosen, KeptChoice};
pub use size::PilotSize;
pub use stand_in::motion;
pub use trial::Trial;

use std::f64::consts::FRAC_1_SQRT_2;
use std::sync::Arc;

use capwalk_boundary::{Counts, Draw, Field, Gathers, Method, Sampler, pool};
use capwalk_geometry::effort;
use capwalk_math::{Moments, Vec3};
use capwalk_render::{MotionFacts, PreparedScene, Tracer, Watch};
use capwalk_scene::{BsdfId, Scene, Tangent};
use capwalk_walk::WalkSettings;
use rayon::prelude::*;

use crate::adjoint::Wanted;
use crate::forward_eval::Forward;
use crate::options::GradientOptions;
use stand_in::GOLDEN;
use trial::PER_PIXEL;

/// One over the part of a trial's pixels after which a hopeless one ends.
const FIRST_PART: usize = 4;
/// One over the part of these after which it is known what a trial costs.
const PROBE: usize = 8;

/// What leaves the camera's rays where they are although gloss moves must be better by this factor: it can have
/// rare and large values, of which a pilot sees a few at best.
/// In scenes of this kind it has from a thousandth of the variance to 250 times.
const SURELY: f64 = 0.2;
/// The factor if what moves is glossy itself. A pilot found it sixteen times better in
/// `rough_plastic_ball_moves` where it is thirteen times worse.
const MOST_SURELY: f64 = 0.05;

/// So many emitters say how wide they are.
const MOST_EMITTERS: usize = 16;

/// What is not better than by this factor is not preferred.
const CLEARLY: f64 = 0.9;

/// Where walks are tried in the place of gathered edges, one kind of segment each. Towards other surfaces none
/// are: where these are near, as at the foot of an object, and where curves of different velocities cross, walks have
/// values so rare and large that hardly any pilot sees them (in the built-in `ball`, with paths of four segments, a
/// variance of 0.4 instead of 1500; beside a mirror that turns, 0.05 instead of 300).
#[rustfmt::skip]
const WALKS_TRIED: [Gathers; 3] = [
    Gathers { camera: true, ..Gathers::NONE },
    Gathers { emitters: true, ..Gathers::NONE },
    Gathers { environment: true, ..Gathers::NONE },
];

/// The best cutoff before an emitter, as a part of the emitter's angular width (METHOD 10).
/// Narrower fields are met by few samples: a pilot may not see them at all.
const PART_OF_EMITTER: f64 = 0.4;

/// The seed of all pilots, unlike those that people choose; e.
const PILOT_SEED: u64 = 0xadf8_5458_a2bb_4a9a;

/// What a pilot differentiates, and by which samples.
pub struct Pilot<'a> {
    pub prepared: &'a PreparedScene,
    pub tangent: &'a Tangent,
    /// What is known of that motion.
    pub facts: &'a Arc<MotionFacts>,
    /// True if sampling may not use how fast edges move, as in reverse mode.
    pub is_blind: bool,
    pub options: &'a GradientOptions,
    pub size: PilotSize,
    pub watch: &'a dyn Watch,
}

/// What was tried so far.
#[derive(Default)]
struct Trials {
    list: Vec<Trial>,
    /// The effort of them and of those that were too costly to be finished.
    spent: f64,
}

/// More points in pixels cost little if all of a sample costs less than so many times what it does with
/// one.
const CHEAP: f64 = 1.5;

/// How many points in a pixel are tried, as long as more are better.
const CAMERA_POINTS_TRIED: [u32; 2] = [4, 16];

impl Pilot<'_> {
    /// The method of the least variance × time. `Walk` if nothing was tried because nothing needs a
    /// choice: neither geometry nor the sensor moves.
    pub fn choose(&self) -> Chosen {
        let mut trials = Trials::default();
        let mut options = *self.options;
        (options.method, options.walk.max_radius) = self.best(&mut trials);
        Chosen {
            options,
            trials: trials.list,
        }
    }

    /// The method of the least cost that was found, and its cutoff. Tries to gather edges along all
    /// segments, if gloss moves also with walks for the camera and indirect light, then with walks in the
    /// place of each of [`WALKS_TRIED`] in turn, then with more and fewer points, and more in pixels, as long as trials are worth it.
    /// Where none is, edges are gathered wherever they can be, but for the camera and indirect light
    /// if gloss moves ([`Self::moves_gloss`]); walks have the cutoff that is asked for.
    fn best(&self, trials: &mut Trials) -> (Method, f64) {
        let asked_radius = self.options.walk.max_radius;
        if !Wanted::by(self.tangent).geometry() {
            return (Method::Walk, asked_radius);
        }
        let tracer = self.tracer(self.field(Method::Walk), self.options.walk);
        let mut everywhere = match self.options.method {
            Method::FittedWalk => Gathers::NONE,
            _ => tracer.can_gather(),
        };
        let cautious = Gathers {
            camera: false,
            indirect: false,
            ..everywhere
        };
        let surely = match cautious != everywhere {
            true => self.moves_gloss(&tracer),
            false => None,
        };
        if self.size.samples_of_trial() == 0 {
            let gathers = if surely.is_some() {
                cautious
            } else {
                everywhere
            };
            return (by_gathering(gathers), asked_radius);
        }
        let fitting = self.emitter_width().map(|width| PART_OF_EMITTER * width);
        // Where it walks around surfaces, the cutoff that is asked for, and the fitting one.
        let mut with_cutoffs = |gathers: Gathers| {
            let fitting = fitting.filter(|_| tracer.walks_around_surfaces(gathers));
            self.with_cutoffs(gathers, fitting, trials)
        };
        // Nothing was spent before the first trial.
        let Some(mut best) = with_cutoffs(everywhere) else {
            return (by_gathering(everywhere), asked_radius);
        };
        if let Some(surely) = surely {
            let Some(walking) = with_cutoffs(cautious) else {
                return (by_gathering(cautious), asked_radius);
            };
            if !best.beats(&walking, surely) {
                (best, everywhere) = (walking, cautious);
            }
        }
        let mut gathers = everywhere;
        for segment in WALKS_TRIED {
            if !everywhere.along(segment) {
                continue;
            }
            let without = gathers.without(segment);
            if let Some(trial) = with_cutoffs(without).filter(|trial| trial.beats(&best, CLEARLY)) {
                (best, gathers) = (trial, without);
            }
        }
        // More points on the edges before emitters, as long as that is better, or else fewer.
        if gathers.emitters {
            let mut with = |points: u32, than: &Trial| {
                let method = Method::Edges(Gathers { points, ..gathers });
                let trial = self.trial(method, than.max_radius, trials)?;
                trial.beats(than, CLEARLY).then_some(trial)
            };
            best = match with(16, &best) {
                Some(more) => with(64, &more).unwrap_or(more),
                None => with(1, &best).unwrap_or(best),
            };
        }
        // Then more in pixels. Where few of them have edges that move, they have most of the noise, of
        // which a pilot sees little, and more points there cost little.
        let gathers = best.method.traits().gathers;
        let of_one = best.effort;
        for camera_points in CAMERA_POINTS_TRIED {
            let more = Method::Edges(Gathers {
                camera_points,
                ..gathers
            });
            let is_tried = gathers.camera;
            let trial = is_tried.then(|| self.trial(more, best.max_radius, trials));
            let Some(trial) = trial.flatten() else {
                break;
            };
            // Where there are no edges, more points cost nothing.
            let is_cheap = trial.effort > of_one && trial.effort < CHEAP * of_one;
            if !is_cheap && !trial.beats_with_all(&best, CLEARLY) {
                break;
            }
            best = trial;
        }
        (best.method, best.max_radius)
    }

    /// The share of a walk's cost below which rays that stay must be, if something with interpolated normals moves
    /// against the camera that is glossy, or lit by something glossy. They can have derivatives there
    /// so rare and so large that a pilot does not see them; the rays of a walk move along. Where surfaces
    /// see flat mirrors or panes, walks have such values as well ([`WALKS_TRIED`]), and are only preferred
    /// where what moves is glossy itself.
    fn moves_gloss(&self, tracer: &Tracer) -> Option<f64> {
        let scene = self.prepared.scene();
        let camera_moves = self.tangent.sensor.moves_rays();
        let mut materials = scene.shapes.iter().map(|shape| shape.bsdf);
        let lights = tracer.plan.reaches(3)
            && !tracer.shows_surfaces_mirrors()
            && materials.any(|id| is_glossy(scene, id));
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

    /// The better one of the cutoff that is asked for and another one, if that is narrower; `None`
    /// if the pilot has cost enough.
    fn with_cutoffs(
        &self,
        gathers: Gathers,
        other: Option<f64>,
        trials: &mut Trials,
    ) -> Option<Trial> {
        let method = by_gathering(gathers);
        let asked = self.trial(method, self.options.walk.max_radius, trials)?;
        let is_hopeless = asked.is_hopeless(&trials.list);
        let narrow = other
            .filter(|&angle| angle < asked.max_radius && !is_hopeless)
            .and_then(|angle| self.trial(method, angle, trials));
        Some(match narrow {
            Some(narrow) if narrow.beats(&asked, CLEARLY) => narrow,
            _ => asked,
        })
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
        let count = (self.size.samples_of_trial() / u64::from(PER_PIXEL)).min(pixels);
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

    /// Variance and effort of some samples by a method; `None` if the pilot has cost enough without
    /// them. All trials take the same pixels and random numbers, but for those which are hopeless
    /// after the first of them.
    fn trial(&self, method: Method, max_radius: f64, trials: &mut Trials) -> Option<Trial> {
        let is_this = |trial: &&Trial| (trial.method, trial.max_radius) == (method, max_radius);
        if let Some(known) = trials.list.iter().find(is_this) {
            return Some(*known);
        }
        let pixels = self.pixels();
        let first = pixels.len().div_ceil(FIRST_PART);
        // What is known so far from these pixels and some more.
        let mut found = Vec::new();
        let mut tried = |end: usize| {
            found.extend(self.samples(method, max_radius, &pixels[found.len()..end]));
            Trial::new(method, max_radius, &found)
        };
        let probe = tried(first.div_ceil(PROBE));
        let all = pixels.len() as f64 * f64::from(PER_PIXEL);
        if !self.affords(all * probe.effort, trials) {
            trials.spent += probe.spent();
            return None;
        }
        let mut trial = tried(first);
        if !trial.is_hopeless(&trials.list) {
            trial = tried(pixels.len());
        }
        trials.spent += trial.spent();
        trials.list.push(trial);
        Some(trial)
    }

    /// True if all trials together with so much more effort cost no more than a part of the work by
    /// the best of them. The first one is free.
    fn affords(&self, effort: f64, trials: &Trials) -> bool {
        let by_cost = |a: &&Trial, b: &&Trial| a.upper_cost().total_cmp(&b.upper_cost());
        let best = trials.list.iter().min_by(by_cost);
        best.is_none_or(|best| trials.spent + effort <= self.size.allowed_effort(best.effort))
    }

    /// Variance of the samples of each of these pixels by a method, and their effort in all.
    fn samples(&self, method: Method, max_radius: f64, pixels: &[[u32; 2]]) -> Vec<(f64, u64)> {
        let scene = self.prepared.scene();
        let mut walk = self.options.walk;
        walk.max_radius = max_radius;
        let field = self.field(method);
        let eval = Forward::new(field, self.tangent);
        let eval = match self.is_blind {
            true => eval.blind(),
            false => eval,
        };
        let tracer = self.tracer(field, walk);
        // If the watch stops this, no sample is taken either.
        let _ = tracer.build_edge_samplers(self.watch);
        let sampler = Sampler::new(&scene.settings, PILOT_SEED, 1);
        let width = scene.film.crop_size[0];
        let sampled = |&[x, y]: &[u32; 2]| {
            let pixel = u64::from(y * width + x);
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
                let derivative = light.tangent(0).to_array();
                // What is not finite is reported with the work itself.
                if derivative.iter().all(|x| x.is_finite()) {
                    let moments = moments.iter_mut().zip(derivative);
                    moments.for_each(|(moments, x)| moments.add(x));
                }
            }
            let variance: f64 = moments.iter().map(|m| m.variance()).sum();
            (variance, effort().wrapping_sub(before))
        };
        pool::install(|| pixels.par_iter().map(sampled).collect())
    }
}

/// The method that gathers edges along these segments, and walks along the others.
fn by_gathering(gathers: Gathers) -> Method {
    match gathers.is_nowhere() {
        true => Method::Walk,
        false => Method::Edges(gathers),
    }
}

/// True if a material, or one that it is made of, is glossy.
fn is_glossy(scene: &Scene, id: BsdfId) -> bool {
    let material = &scene.material(id).bsdf;
    let mut parts = material.parts().into_iter();
    let traits = material.traits();
    (traits.is_glossy && !traits.is_specular) || parts.any(|part| is_glossy(scene, part))
}
