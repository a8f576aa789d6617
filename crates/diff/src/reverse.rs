//! The gradient of a loss in reverse mode: from a covector on the picture to
//! covectors on all parameters, in one pass.

use std::sync::atomic::{AtomicU64, Ordering};

use capwalk_boundary::refuse::{
    is_specular_somewhere, refuse_cut_normals, refuse_infinite_derivatives, refuse_motion,
    refuse_settings, refuse_turned_without_uvs, refuse_uncovered,
};
use capwalk_boundary::{Counts, Draw, Field, Refusal, Sampler, pool};
use capwalk_math::tape::Adjoints;
use capwalk_math::{Moments, Tape};
use capwalk_render::{PreparedScene, Statistics, Tracer, Watch};
use capwalk_scene::{Gradient, Image, Scene, Tangent, TextureId};
use rayon::prelude::*;

use crate::adjoint::{Adjoint, Wanted};
use crate::options::GradientOptions;
use crate::reverse_eval::Reverse;

/// Batches that the samples are split into, whatever the number of threads, so
/// that sums are the same to the bit. Their spread gives the standard errors.
const BATCHES: u32 = 16;

/// The gradient of `Σ adjoint · picture` in all parameters, with errors.
#[derive(Clone, Debug)]
pub struct Backward {
    /// Independent estimates with equal numbers of samples (the last ones may
    /// have fewer if the work was stopped), and how many samples they have.
    batches: Vec<(Gradient, u32)>,
    /// Their mean, weighted by their samples.
    mean: Gradient,
    /// What was done.
    pub statistics: Statistics,
}

impl Backward {
    /// The gradient: what every vertex, normal, colour and the sensor
    /// contribute per unit of their change. Its inner product with a motion is
    /// the derivative along it. Shapes that were not asked for have `None`.
    pub fn gradient(&self) -> &Gradient {
        &self.mean
    }

    /// The derivative along a motion of what was asked for, and its standard
    /// error (NaN from a single batch).
    pub fn along(&self, tangent: &Tangent) -> (f64, f64) {
        let (value, error) = self.numbers(|gradient| vec![gradient.dot(tangent)]);
        (value[0], error[0])
    }

    /// Numbers that are linear in the gradient, and the standard error of each
    /// (NaN from a single batch). `of` gives as many whatever it is given.
    pub fn numbers(&self, of: impl Fn(&Gradient) -> Vec<f64>) -> (Vec<f64>, Vec<f64>) {
        let mut moments: Vec<Moments> = Vec::new();
        for (batch, _) in &self.batches {
            let numbers = of(batch);
            moments.resize(numbers.len(), Moments::default());
            for (moments, number) in moments.iter_mut().zip(numbers) {
                moments.add(number);
            }
        }
        let errors = moments.iter().map(Moments::standard_error).collect();
        (of(&self.mean), errors)
    }

    /// The standard error of every number of the gradient, in its form.
    pub fn standard_error(&self) -> Gradient {
        let mut squares = self.mean.scaled(0.0);
        for (batch, _) in &self.batches {
            let mut difference = batch.clone();
            difference.add(&self.mean.scaled(-1.0));
            squares.add(&difference.map(|x| x * x));
        }
        let n = self.batches.len() as f64;
        squares.map(|x| (x / (n * (n - 1.0))).sqrt())
    }
}

/// The gradient of `Σ adjoint · picture` in what is wanted. `adjoint` has the
/// size of the picture: the derivative of a loss by each pixel's channels.
/// Draw it from a picture with another seed, or the product is biased.
///
/// One pass over the samples, whatever the number of parameters. The same to
/// the bit for every number of threads. Refuses what [`crate::gradient`]
/// refuses, and an adjoint of another size or with numbers that are not finite.
pub fn backward(
    prepared: &PreparedScene,
    adjoint: &Image,
    wanted: &Wanted,
    options: &GradientOptions,
    watch: &dyn Watch,
) -> Result<Backward, Refusal> {
    let (scene, accel) = (prepared.scene(), prepared.accel());
    refuse_settings(&options.method, &options.walk)?;
    let expected = scene.film.crop_size.map(|n| n as usize);
    let found = [adjoint.width, adjoint.height];
    if found != expected {
        return Err(Refusal::AdjointSize { found, expected });
    }
    let [width, height] = expected;
    refuse_non_finite(adjoint)?;
    let is_asked_for = |id: TextureId| wanted.textures[id.0 as usize];
    refuse_infinite_derivatives(scene, is_asked_for)?;
    let turns = wanted.normals.contains(&true);
    refuse_cut_normals(scene, turns || wanted.geometry(), is_asked_for)?;
    if wanted.geometry() {
        refuse_motion(accel, &options.method)?;
    } else if turns {
        refuse_turned_without_uvs(scene)?;
    }
    let field = Field::new(accel, prepared.boundaries(), options.method);
    #[cfg(feature = "paper")]
    capwalk_boundary::refuse::refuse_many_edges(field.boundaries, &options.method)?;
    let pass = Pass {
        scene,
        adjoint,
        wanted,
        points: wanted.points(accel, field.boundaries),
        tracer: Tracer::moving(prepared, field, options.walk),
        field,
        sampler: Sampler::new(&scene.settings, options.seed, options.spp),
        watch,
        done: AtomicU64::new(0),
        total: (width * height) as u64 * u64::from(options.spp),
    };
    let spp = options.spp;
    // Consecutive samples that depend on each other stay together.
    let group = pass.sampler.batch();
    let groups = spp.div_ceil(group);
    let count = groups.min(BATCHES);
    let bounds = |batch: u32| (batch * groups / count * group).min(spp);
    // What cannot be covered is found by looking, before the work is done.
    pass.refuse_uncovered_soon()?;
    let run = || -> Vec<Batch> {
        (0..count)
            .into_par_iter()
            .map(|batch| pass.batch(bounds(batch)..bounds(batch + 1)))
            .collect()
    };
    let batches = pool::install(run);
    let taken: u32 = batches.iter().map(|batch| batch.taken).sum();
    let mut statistics = Statistics {
        samples_per_pixel: vec![taken; width * height],
        complete: taken == spp,
        samples: u64::from(taken) * (width * height) as u64,
        ..Statistics::default()
    };
    let mut gradients = Vec::new();
    for batch in batches {
        statistics.non_finite += batch.non_finite;
        statistics.cone_queries += batch.cone_queries;
        statistics.uncovered += batch.uncovered;
        if batch.taken > 0 || (taken == 0 && gradients.is_empty()) {
            let factor = 1.0 / f64::from(batch.taken.max(1));
            let sums = batch.sums;
            let gradient = sums.gradient(accel, field.boundaries, wanted, factor);
            gradients.push((gradient, batch.taken.max(1)));
        }
    }
    refuse_uncovered(
        scene,
        statistics.uncovered,
        statistics.samples,
        &options.method,
    )?;
    let samples: u32 = gradients.iter().map(|(_, n)| n).sum();
    let mut mean = gradients[0].0.scaled(0.0);
    for (batch, n) in &gradients {
        mean.add(&batch.scaled(f64::from(*n) / f64::from(samples)));
    }
    Ok(Backward {
        batches: gradients,
        mean,
        statistics,
    })
}

/// A NaN would take the samples of its pixel out of the sum.
fn refuse_non_finite(adjoint: &Image) -> Result<(), Refusal> {
    match adjoint.pixels.iter().position(|pixel| !pixel.is_finite()) {
        None => Ok(()),
        Some(index) => {
            let (x, y) = (index % adjoint.width, index / adjoint.width);
            Err(Refusal::AdjointNotFinite {
                pixel: [x, y],
                value: adjoint.pixels[index].to_array(),
            })
        }
    }
}

/// What all batches share.
struct Pass<'a> {
    scene: &'a Scene,
    adjoint: &'a Image,
    wanted: &'a Wanted,
    /// Which points of the boundaries depend on what is wanted.
    points: Vec<bool>,
    tracer: Tracer<'a>,
    field: Field<'a>,
    sampler: Sampler,
    watch: &'a dyn Watch,
    done: AtomicU64,
    total: u64,
}

/// What a batch of samples of all pixels gives.
struct Batch {
    sums: Adjoint,
    /// Samples of each pixel.
    taken: u32,
    non_finite: u64,
    cone_queries: u64,
    uncovered: u64,
}

impl Pass<'_> {
    /// A first look: one sample of each pixel.
    fn refuse_uncovered_soon(&self) -> Result<(), Refusal> {
        if !self.field.method.traits().is_unbiased || !is_specular_somewhere(self.scene) {
            return Ok(());
        }
        let mut statistics = Statistics::default();
        let mut tape = Tape::default();
        let width = self.adjoint.width;
        for index in 0..self.adjoint.pixels.len() {
            if self.watch.should_stop() {
                break;
            }
            let (stream, counts) = (self.sampler.stream(index as u64, 0), Counts::default());
            let draw = Draw {
                stream: &stream,
                counts: &counts,
            };
            let pixel = [(index % width) as u32, (index / width) as u32];
            let eval = Reverse::new(self.field, self.wanted, &self.points, &tape);
            self.tracer.pixel(&eval, pixel, draw);
            tape.clear();
            statistics.samples += 1;
            statistics.uncovered += counts.uncovered.get();
            if statistics.uncovered > 0 && statistics.samples > 1000 {
                break;
            }
        }
        refuse_uncovered(
            self.scene,
            statistics.uncovered,
            statistics.samples,
            &self.field.method,
        )
    }

    fn batch(&self, numbers: std::ops::Range<u32>) -> Batch {
        let mut batch = Batch {
            sums: Adjoint::zero(self.scene, self.field.boundaries, self.wanted),
            taken: 0,
            non_finite: 0,
            cone_queries: 0,
            uncovered: 0,
        };
        let mut tape = Tape::default();
        let (mut adjoints, mut covectors) = (Adjoints::default(), Vec::new());
        let width = self.adjoint.width;
        for number in numbers {
            if self.watch.should_stop() {
                break;
            }
            for (index, &adjoint) in self.adjoint.pixels.iter().enumerate() {
                let stream = self.sampler.stream(index as u64, number);
                let counts = Counts::default();
                let draw = Draw {
                    stream: &stream,
                    counts: &counts,
                };
                let pixel = [(index % width) as u32, (index / width) as u32];
                let eval = Reverse::new(self.field, self.wanted, &self.points, &tape);
                let light = self.tracer.pixel(&eval, pixel, draw);
                eval.pull_back(light, adjoint, &mut adjoints, &mut covectors);
                tape.clear();
                batch.cone_queries += counts.queries.get();
                batch.uncovered += counts.uncovered.get();
                if covectors.iter().all(|(_, covector)| covector.is_finite()) {
                    for &(target, covector) in &covectors {
                        batch.sums.add(target, covector);
                    }
                } else {
                    batch.non_finite += 1;
                }
            }
            batch.taken += 1;
            let work = self.adjoint.pixels.len() as u64;
            let done = self.done.fetch_add(work, Ordering::Relaxed) + work;
            self.watch.progress(done, self.total);
        }
        batch
    }
}
