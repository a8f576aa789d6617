//! The gradient of a loss in reverse mode: from a covector on the image to
//! covectors on all parameters, in one pass.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};

use capwalk_boundary::refuse::{
    refuse_boundaries, refuse_cut_normals, refuse_infinite_derivatives, refuse_many_shadows,
    refuse_motion, refuse_settings, refuse_specular, refuse_turned_without_uvs,
};
use capwalk_boundary::{Boundaries, Counts, Draw, Field, Refusal, Sampler, pool};
use capwalk_math::tape::Adjoints;
use capwalk_math::{Moments, Rgb, Tape, Vec3};
use capwalk_render::tiles::{self, Sample, SampleRun};
use capwalk_render::{
    Accumulate, Along, Differentiator, Grid, LaneTracer, MotionFacts, OrderedSum, Part, PartError,
    Partial, PathAdjoint, PreparedScene, Statistics, Tracer, Unwatched, Watch,
};
use capwalk_scene::{Gradient, Image, Scene, Tangent, TextureId, fingerprint, memory};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::adjoint::{Adjoint, Target, Wanted};
use crate::auto::{Chosen, KeptChoice, Pilot, PilotSize, motion};
use crate::options::GradientOptions;
use crate::refused::{boundaries, refuse_sums_beyond_memory};
use crate::reverse_eval::Reverse;

/// The gradient of `Σ adjoint · image` in all parameters, with errors.
#[derive(Clone, Debug)]
pub struct Backward {
    /// Independent estimates, and how many samples they have: the same number unless the
    /// work was stopped.
    batches: Vec<(Gradient, u64)>,
    /// Their mean, weighted by their samples.
    mean: Gradient,
    /// The method that samples were differentiated by, or the one that was asked for if others chose
    /// it and computed all parts.
    pub chosen: Chosen,
    /// What was done.
    pub statistics: Statistics,
}

impl Backward {
    /// From independent estimates, at least one, each with how many samples it has, at least one.
    pub fn new(batches: Vec<(Gradient, u64)>, chosen: Chosen, statistics: Statistics) -> Self {
        // The mean over all samples, however many each batch has.
        let samples: u64 = batches.iter().map(|(_, n)| n).sum();
        let mut mean = batches[0].0.scaled(0.0);
        for (batch, n) in &batches {
            mean.add_scaled(batch, *n as f64 / samples as f64);
        }
        Self {
            batches,
            mean,
            chosen,
            statistics,
        }
    }

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
    pub fn numbers<'s, N: AsRef<[f64]>>(
        &'s self,
        of: impl Fn(&'s Gradient) -> N,
    ) -> (Vec<f64>, Vec<f64>) {
        let mean = of(&self.mean).as_ref().to_vec();
        let mut moments = vec![Moments::default(); mean.len()];
        for (batch, _) in &self.batches {
            let numbers = of(batch);
            let pairs = moments.iter_mut().zip(numbers.as_ref());
            pairs.for_each(|(moments, &number)| moments.add(number));
        }
        let errors = moments.iter().map(Moments::standard_error).collect();
        (mean, errors)
    }

    /// The standard error of every number of the gradient, in its form.
    pub fn standard_error(&self) -> Gradient {
        let mut squares = self.mean.scaled(0.0);
        for (batch, _) in &self.batches {
            let mut difference = batch.clone();
            difference.add_scaled(&self.mean, -1.0);
            squares.add(&difference.map(|x| x * x));
        }
        let n = self.batches.len() as f64;
        squares.map(|x| (x / (n * (n - 1.0))).sqrt())
    }
}

/// The gradient of `Σ adjoint · image` in what is wanted. `adjoint` has the
/// size of the image: the derivative of a loss with respect to each pixel's channels.
/// Draw it from an image with another seed, or the product is biased.
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
    BackwardWork::new(prepared, adjoint, wanted.clone(), *options).whole(watch)
}

/// A gradient in reverse mode that is computed in parts.
#[derive(Debug)]
pub struct BackwardWork<'a> {
    prepared: &'a PreparedScene,
    adjoint: &'a Image,
    wanted: Wanted,
    options: GradientOptions,
    chosen: OnceLock<Chosen>,
    kept: KeptChoice,
    size: PilotSize,
    facts: Arc<MotionFacts>,
    fingerprint: OnceLock<u64>,
}

impl<'a> BackwardWork<'a> {
    /// The gradient of `Σ adjoint · image` in what is wanted, see [`backward`].
    pub fn new(
        prepared: &'a PreparedScene,
        adjoint: &'a Image,
        wanted: Wanted,
        options: GradientOptions,
    ) -> Self {
        let turns_light = wanted.turns_light(prepared.scene());
        Self {
            prepared,
            adjoint,
            wanted,
            options,
            chosen: OnceLock::new(),
            kept: KeptChoice::default(),
            size: PilotSize::of(prepared.scene(), &options, 1),
            facts: Arc::new(MotionFacts::of(prepared.scene(), turns_light)),
            fingerprint: OnceLock::new(),
        }
    }

    /// This work by the method that is kept there. If none is, the choice of this work is kept.
    #[must_use]
    pub fn keeping(self, kept: KeptChoice) -> Self {
        Self { kept, ..self }
    }

    /// What this work finds out about the motion, for others of the same scene and with respect to the same.
    pub fn facts(&self) -> Arc<MotionFacts> {
        Arc::clone(&self.facts)
    }

    /// This work with what another one of the same scene, with respect to the same, found out.
    #[must_use]
    pub fn knowing(self, facts: Arc<MotionFacts>) -> Self {
        Self { facts, ..self }
    }

    /// This work with a pilot as for so many of its kind, for which its choice will be used.
    #[must_use]
    pub fn repeated(self, times: u64) -> Self {
        let size = PilotSize::of(self.prepared.scene(), &self.options, times);
        Self { size, ..self }
    }

    /// The cells that the work can be cut into.
    pub fn grid(&self) -> Grid {
        tiles::grid(self.prepared.scene(), &self.options.sampling())
    }

    /// All of it at once, see [`backward`].
    pub fn whole(&self, watch: &dyn Watch) -> Result<Backward, Refusal> {
        let part = Part::whole(self.grid());
        let chosen = self.chosen_within_memory(&part, watch)?;
        let partial = self.sums(&chosen.options, None, &part, watch)?;
        self.backward(partial.into_sums(), chosen)
    }

    /// The method that the work is done by, see [`Method::Auto`](crate::Method::Auto); found
    /// by the first call. Refused like the work.
    pub fn chosen(&self, watch: &dyn Watch) -> Result<Chosen, Refusal> {
        let choose = || {
            let pilot = Pilot {
                prepared: self.prepared,
                tangent: &motion(self.prepared.scene(), &self.wanted),
                // The motion of the pilot is not what the passes know.
                facts: &Arc::new(MotionFacts::of(
                    self.prepared.scene(),
                    self.facts.turns_light(),
                )),
                is_blind: true,
                options: &self.options,
                size: self.size,
                watch,
            };
            pilot.choose()
        };
        let refuse = || self.check(watch);
        let (known, kept) = (&self.chosen, &self.kept);
        Chosen::of(&self.options, known, kept, watch, refuse, choose)
    }

    /// What a part of the work gives: of its cells those that are finished when `watch` stops
    /// the work. Refused like the whole.
    pub fn part(&self, part: &Part, watch: &dyn Watch) -> Result<Partial<BatchSums>, PartError> {
        part.check(self.grid())?;
        let options = self.chosen_within_memory(part, watch)?.options;
        Ok(self.sums(&options, Some(self.fingerprint()), part, watch)?)
    }

    /// The gradient, from all of its parts. The bits are those of [`backward`].
    pub fn finish(&self, parts: Partial<BatchSums>) -> Result<Backward, PartError> {
        let boundaries = self.boundaries(&Unwatched)?;
        let zero = Adjoint::zero(self.prepared.scene(), boundaries, &self.wanted);
        let right = |_, sums: &BatchSums| sums.mean.fits(&zero);
        let sums = parts.complete(self.fingerprint(), self.grid(), right)?;
        let chosen = Chosen::known_or_asked(&self.chosen, &self.options);
        Ok(self.backward(sums, chosen)?)
    }

    /// [`Self::chosen`], unless the sums of a part do not fit into memory.
    fn chosen_within_memory(&self, part: &Part, watch: &dyn Watch) -> Result<Chosen, Refusal> {
        let numbers = self.wanted.numbers(self.prepared.scene());
        refuse_sums_beyond_memory(numbers, self.copies(part), memory::available())?;
        self.chosen(watch)
    }

    fn sums(
        &self,
        options: &GradientOptions,
        work: Option<u64>,
        part: &Part,
        watch: &dyn Watch,
    ) -> Result<Partial<BatchSums>, Refusal> {
        // Where nothing moves, paths are those of an image.
        let is_asked_for = |id: TextureId| self.wanted.textures[id.0 as usize];
        let lanes = match self.wanted.moves() {
            true => None,
            false => LaneTracer::differentiating(self.prepared, &is_asked_for),
        };
        self.sums_by(lanes.as_ref(), options, work, part, watch)
    }

    /// [`Self::sums`], of samples that are taken together if lanes take them.
    fn sums_by(
        &self,
        lanes: Option<&LaneTracer<'_>>,
        options: &GradientOptions,
        work: Option<u64>,
        part: &Part,
        watch: &dyn Watch,
    ) -> Result<Partial<BatchSums>, Refusal> {
        let mut pass = Pass {
            lanes,
            ..self.pass(options, watch)?
        };
        let grid = pass.grid;
        let cells = grid.cells().filter(|&cell| part.contains(cell));
        pass.total = cells
            .map(|cell| (pass.pixels(cell.band).len() * pass.samples(cell.batch).len()) as u64)
            .sum();
        let is_part = work.is_some();
        let sums = pool::install(|| {
            let batches = (0..grid.batches).into_par_iter();
            let sum_of = |batch| pass.batch(batch, &part.bands_of(batch), is_part);
            batches.map(sum_of).collect()
        });
        Ok(Partial::new(
            work.unwrap_or_default(),
            grid,
            Along::Bands,
            sums,
        ))
    }

    /// How many sums there are at a time: of every batch, and of every band that a thread works at,
    /// twice where they must be kept in case that it is stopped; or in their place what is made of
    /// them in the end.
    fn copies(&self, part: &Part) -> u64 {
        let grid = self.grid();
        let batches = (0..grid.batches).filter(|&batch| !part.bands_of(batch).is_empty());
        let batches = batches.count() as u64;
        let threads = pool::install(rayon::current_num_threads) as u64;
        let kept = match self.prepared.scene().film.pixel_count() > FEW_PIXELS {
            true => 2,
            false => 1,
        };
        let at_work = threads.min(batches) * u64::from(grid.bands) * kept;
        batches + at_work.max(COPIES_IN_THE_END)
    }

    /// What all samples of the work share; nothing is done yet.
    fn pass<'b>(
        &'b self,
        options: &GradientOptions,
        watch: &'b dyn Watch,
    ) -> Result<Pass<'b>, Refusal> {
        let (prepared, wanted) = (self.prepared, &self.wanted);
        let (scene, accel) = (prepared.scene(), prepared.accel());
        let field = Field::new(accel, self.boundaries(watch)?, options.method);
        let tracer = Tracer::moving(prepared, field, options.walk, &self.facts);
        // If the watch stops this, no sample is taken either.
        let _ = tracer.build_edge_samplers(watch);
        Ok(Pass {
            scene,
            adjoint: self.adjoint,
            wanted,
            points: wanted.points(accel, field.boundaries),
            tracer,
            lanes: None,
            field,
            sampler: Sampler::new(&scene.settings, options.seed, options.spp),
            spp: options.spp,
            grid: self.grid(),
            bands_at_once: (self.grid().batches as usize)
                < pool::install(rayon::current_num_threads),
            watch,
            done: AtomicU64::new(0),
            total: 0,
        })
    }

    fn boundaries(&self, watch: &dyn Watch) -> Result<&'a Boundaries, Refusal> {
        let moves = self.wanted.moves() || self.facts.turns_light();
        boundaries(self.prepared, moves, watch)
    }

    /// Refuses what cannot be differentiated rightly. That needs no sample, but the boundaries if
    /// something moves: [`Refusal::Stopped`] if the watch stops their construction.
    pub fn check(&self, watch: &dyn Watch) -> Result<(), Refusal> {
        let options = &self.options;
        let (prepared, wanted) = (self.prepared, &self.wanted);
        let (scene, accel) = (prepared.scene(), prepared.accel());
        refuse_settings(&options.method, &options.walk)?;
        let expected = scene.film.crop_size.map(|n| n as usize);
        let found = [self.adjoint.width, self.adjoint.height];
        if found != expected {
            return Err(Refusal::AdjointSize { found, expected });
        }
        refuse_non_finite(self.adjoint)?;
        let is_asked_for = |id: TextureId| wanted.textures[id.0 as usize];
        refuse_infinite_derivatives(scene, is_asked_for)?;
        let turns = wanted.normals.contains(&true);
        refuse_cut_normals(scene, turns || self.facts.turns_light(), is_asked_for)?;
        if self.facts.turns_light() {
            refuse_motion(accel, &options.method)?;
            refuse_specular(scene, &options.method)?;
            refuse_many_shadows(self.boundaries(watch)?)?;
        } else if turns {
            refuse_turned_without_uvs(scene)?;
        }
        refuse_boundaries(self.boundaries(watch)?, &options.method, &options.walk)
    }

    fn backward(&self, batches: Vec<BatchSums>, chosen: Chosen) -> Result<Backward, Refusal> {
        let (scene, accel) = (self.prepared.scene(), self.prepared.accel());
        // Built already, by what took the samples, or else in another process.
        let boundaries = self.boundaries(&Unwatched)?;
        let mut statistics = Statistics {
            samples_per_pixel: vec![0; scene.film.pixel_count()],
            dips: self.facts.dips(accel),
            ..Statistics::default()
        };
        let is_empty = batches.iter().all(|batch| batch.samples() == 0);
        let mut gradients: Vec<(Gradient, u64)> = Vec::new();
        for batch in batches {
            batch.add_to(&mut statistics);
            let samples = batch.samples();
            if samples > 0 || (is_empty && gradients.is_empty()) {
                let gradient = batch.mean.gradient(accel, boundaries, &self.wanted);
                gradients.push((gradient, samples.max(1)));
            }
        }
        let taken = &statistics.samples_per_pixel;
        statistics.complete = taken.iter().all(|&taken| taken == self.options.spp);
        statistics.samples = taken.iter().map(|&taken| u64::from(taken)).sum();
        Ok(Backward::new(gradients, chosen, statistics))
    }

    fn fingerprint(&self) -> u64 {
        let scene = self.prepared.scene();
        let inputs = ("backward", scene, self.adjoint, &self.wanted, &self.options);
        *self.fingerprint.get_or_init(|| fingerprint(&inputs))
    }
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

/// What a batch of samples gives: of some bands of the image, or of all.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct BatchSums {
    /// The mean over the samples, summed over the pixels.
    mean: Adjoint,
    /// Samples of each pixel in each band.
    bands: Vec<Band>,
    non_finite: u64,
    cone_queries: u64,
}

/// How many samples the pixels of a band have.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct Band {
    pixels: u32,
    taken: u32,
}

impl BatchSums {
    /// Samples in all; 0 if some pixel has none, because the work was stopped: the sum over
    /// the pixels says nothing then.
    fn samples(&self) -> u64 {
        match self.bands.iter().any(|band| band.taken == 0) {
            true => 0,
            false => {
                let of = |band: &Band| u64::from(band.pixels) * u64::from(band.taken);
                self.bands.iter().map(of).sum()
            }
        }
    }

    /// Adds the covectors of a sample, if all of them are numbers.
    fn add_all(&mut self, covectors: &[(Target, Vec3)]) {
        if covectors.iter().all(|(_, covector)| covector.is_finite()) {
            for &(target, covector) in covectors {
                self.mean.add(target, covector);
            }
        } else {
            self.non_finite += 1;
        }
    }

    fn add_to(&self, statistics: &mut Statistics) {
        let bands = self.bands.iter();
        let taken = bands.flat_map(|band| (0..band.pixels).map(|_| band.taken));
        let counts = statistics.samples_per_pixel.iter_mut();
        counts.zip(taken).for_each(|(count, taken)| *count += taken);
        statistics.non_finite += self.non_finite;
        statistics.cone_queries += self.cone_queries;
    }
}

impl Accumulate for BatchSums {
    fn fits(&self, next: &Self) -> bool {
        self.mean.fits(&next.mean)
    }

    fn add(&mut self, next: &Self) {
        Accumulate::add(&mut self.mean, &next.mean);
        self.bands.extend(&next.bands);
        self.non_finite += next.non_finite;
        self.cone_queries += next.cone_queries;
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
    /// Takes samples in which nothing moves.
    lanes: Option<&'a LaneTracer<'a>>,
    field: Field<'a>,
    sampler: Sampler,
    spp: u32,
    grid: Grid,
    /// True if there are more threads than batches, so that bands of one are done at once, too.
    bands_at_once: bool,
    watch: &'a dyn Watch,
    done: AtomicU64,
    total: u64,
}

/// What is made of the sums of all batches, in copies of one: means and errors, by name and in a
/// file. Measured with textures of 3000 x 3000 texels: 5.4.
const COPIES_IN_THE_END: u64 = 6;

/// A sample of each of so many pixels takes a fifth of a second at most.
const FEW_PIXELS: usize = 4096;

/// One pixel of so many asks whether to stop.
const LOOK_UP: usize = 64;

/// Memory for one sample after another.
#[derive(Default)]
struct Memory<'a> {
    /// Takes samples together in which nothing moves.
    together: Option<Differentiator<'a>>,
    tape: Tape,
    adjoints: Adjoints,
    covectors: Vec<(Target, Vec3)>,
    /// Samples that are taken together: which, the covectors on their light, those on the scene, and
    /// the samples.
    runs: Vec<SampleRun>,
    on_light: Vec<Rgb>,
    on_scene: Vec<Vec<(Target, Vec3)>>,
    taken: Vec<Sample<3>>,
}

impl Pass<'_> {
    /// The pixels of a band, which are consecutive.
    fn pixels(&self, band: u32) -> Range<usize> {
        let [width, height] = self.scene.film.crop_size;
        let rows = self.grid.rows(band, height);
        (rows.start * width) as usize..(rows.end * width) as usize
    }

    /// The samples of a batch.
    fn samples(&self, batch: u32) -> Range<u32> {
        self.grid.samples(batch, self.spp, self.sampler.group())
    }

    /// The samples of a batch in some bands, in a part without those that were stopped.
    fn batch(&self, batch: u32, bands: &[u32], is_part: bool) -> OrderedSum<BatchSums> {
        let samples = self.samples(batch);
        let sums: Vec<BatchSums> = match is_part {
            // A part may be one batch: its bands are done at once.
            true => bands
                .par_iter()
                .flat_map_iter(|&band| self.bands(samples.clone(), &[band]))
                .collect(),
            false => self.bands(samples.clone(), bands),
        };
        let mut sum = OrderedSum::default();
        for (&band, mut sums) in bands.iter().zip(sums) {
            let taken = sums.bands[0].taken;
            if !is_part || taken == samples.len() as u32 {
                sums.mean.scale(1.0 / f64::from(taken.max(1)));
                sum.insert(band, sums);
            }
        }
        sum
    }

    /// Samples of some bands, one after the other, so that all pixels have as many when the
    /// work is stopped.
    fn bands(&self, samples: Range<u32>, bands: &[u32]) -> Vec<BatchSums> {
        let at_once = if self.bands_at_once { bands.len() } else { 1 };
        let mut memories: Vec<Memory<'_>> = (0..at_once).map(|_| self.memory()).collect();
        let mut sums: Vec<BatchSums> = bands.iter().map(|&band| self.nothing(band)).collect();
        let pixels: usize = bands.iter().map(|&band| self.pixels(band).len()).sum();
        for number in samples {
            if self.watch.should_stop() {
                break;
            }
            // One sample of each of many pixels takes long: if it is stopped, none of them has it.
            let before = (pixels > FEW_PIXELS).then(|| sums.clone());
            let can_stop = before.is_some();
            let mut pairs = bands.iter().zip(&mut sums);
            let is_whole = match memories.as_mut_slice() {
                [memory] => pairs
                    .all(|(&band, sums)| self.add_samples(band, number, sums, memory, can_stop)),
                memories => {
                    let all = bands.par_iter().zip(&mut sums).zip(memories);
                    let add = |((&band, sums), memory): ((&u32, _), _)| {
                        self.add_samples(band, number, sums, memory, can_stop)
                    };
                    all.map(add).reduce(|| true, |all, one| all & one)
                }
            };
            if let Some(before) = before.filter(|_| !is_whole) {
                return before;
            }
        }
        sums
    }

    fn memory(&self) -> Memory<'_> {
        Memory {
            together: self.lanes.map(Differentiator::new),
            ..Memory::default()
        }
    }

    /// Adds a sample of each pixel of a band; false if it can be stopped there and was.
    fn add_samples(
        &self,
        band: u32,
        number: u32,
        sums: &mut BatchSums,
        memory: &mut Memory<'_>,
        can_stop: bool,
    ) -> bool {
        let pixels = self.pixels(band);
        let work = pixels.len() as u64;
        for first in pixels.clone().step_by(LOOK_UP) {
            if can_stop && self.watch.should_stop() {
                return false;
            }
            let some = first..pixels.end.min(first + LOOK_UP);
            match self.lanes {
                Some(_) => self.add_together(some, number, sums, memory),
                None => {
                    for pixel in some {
                        self.add_sample(pixel, number, sums, memory);
                    }
                }
            }
        }
        sums.bands[0].taken += 1;
        let done = self.done.fetch_add(work, Ordering::Relaxed) + work;
        self.watch.progress(done, self.total);
        true
    }

    /// A band before its first sample.
    fn nothing(&self, band: u32) -> BatchSums {
        BatchSums {
            mean: Adjoint::zero(self.scene, self.field.boundaries, self.wanted),
            bands: vec![Band {
                pixels: self.pixels(band).len() as u32,
                taken: 0,
            }],
            non_finite: 0,
            cone_queries: 0,
        }
    }

    /// Adds a sample of each of some pixels in which nothing moves.
    fn add_together(
        &self,
        pixels: Range<usize>,
        number: u32,
        sums: &mut BatchSums,
        memory: &mut Memory<'_>,
    ) {
        let Memory {
            together,
            tape,
            adjoints,
            runs,
            on_light,
            on_scene,
            taken,
            ..
        } = memory;
        let width = self.adjoint.width;
        runs.clear();
        runs.extend(pixels.clone().map(|pixel| SampleRun {
            pixel: [(pixel % width) as u32, (pixel / width) as u32],
            streams: self.sampler.in_pixel(pixel as u64),
            numbers: number..number + 1,
        }));
        on_light.clear();
        on_light.extend_from_slice(&self.adjoint.pixels[pixels]);
        on_scene.resize(LOOK_UP, Vec::new());
        on_scene.iter_mut().for_each(Vec::clear);
        taken.clear();
        let together = together.as_mut().expect("there are lanes");
        together.take(runs, on_light, taken, |sample, on_path| {
            self.pull_back(on_path, tape, adjoints, &mut on_scene[sample]);
        });
        for covectors in &*on_scene {
            sums.add_all(covectors);
        }
    }

    /// From the covector on what is made of numbers of the scene to those on the numbers.
    fn pull_back(
        &self,
        on_path: PathAdjoint,
        tape: &mut Tape,
        adjoints: &mut Adjoints,
        covectors: &mut Vec<(Target, Vec3)>,
    ) {
        match on_path {
            PathAdjoint::Texel {
                texture,
                index,
                covector,
            } => {
                let covector = Vec3::from(covector.to_array());
                covectors.push((Target::Texel(texture, index), covector));
            }
            PathAdjoint::MixedTexel {
                texture,
                index,
                covectors: on_light,
            } => {
                let on_channels = on_light.map(|Rgb { r, g, b }| r + g + b);
                covectors.push((Target::Texel(texture, index), Vec3::from(on_channels)));
            }
            PathAdjoint::Irradiance {
                emitter,
                position,
                covector,
            } => {
                let eval = Reverse::new(self.field, self.wanted, &self.points, tape);
                let irradiance = self.tracer.irradiance(&eval, emitter, position);
                if let Some(irradiance) = irradiance {
                    eval.pull_back(&[(irradiance, covector)], adjoints, covectors);
                }
                tape.clear();
            }
        }
    }

    /// Adds one sample of one pixel.
    fn add_sample(&self, pixel: usize, number: u32, sums: &mut BatchSums, memory: &mut Memory<'_>) {
        let Memory {
            tape,
            adjoints,
            covectors,
            ..
        } = memory;
        let width = self.adjoint.width;
        let position = [(pixel % width) as u32, (pixel / width) as u32];
        let (stream, counts) = (self.sampler.stream(pixel as u64, number), Counts::default());
        let draw = Draw {
            stream: &stream,
            counts: &counts,
        };
        // The sample is one of the image, over numbers that record how they came about.
        let eval = Reverse::new(self.field, self.wanted, &self.points, tape);
        let light = self.tracer.pixel(&eval, position, draw);
        // Backwards through the record: from the pixel's covector to those on the scene.
        covectors.clear();
        eval.pull_back(&[(light, self.adjoint.pixels[pixel])], adjoints, covectors);
        tape.clear();
        sums.cone_queries += counts.queries.get();
        sums.add_all(covectors);
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use capwalk_render::RenderOptions;
    use capwalk_scene_io::load_scene;

    use super::*;

    /// In all scenes that the project has, with respect to all numbers that move no ray: what is
    /// kept of paths that are traced together gives the derivatives of the same samples that a tape
    /// has recorded.
    #[test]
    fn lanes_differentiate_as_tapes_do() {
        let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests");
        let files_in = |folder: &str| {
            let entries = fs::read_dir(tests.join(folder)).expect("a folder of scenes");
            let paths = entries.map(|entry| entry.expect("readable").path());
            paths.collect::<Vec<_>>()
        };
        let folders = files_in("scenes").into_iter();
        let mut files: Vec<_> = folders
            .map(|folder| folder.join("scene.xml"))
            .chain(files_in("parity"))
            .filter(|file| file.extension().is_some_and(|kind| kind == "xml") && file.exists())
            .collect();
        files.sort();
        let (mut wrong, mut compared) = (Vec::new(), 0);
        for (i, file) in files.into_iter().enumerate() {
            let mut scene = load_scene(&file, &[]).expect("a scene").scene;
            // Numbers may come from colours.
            for texture in scene.textures.iter_mut().filter(|_| i % 2 == 1) {
                if texture.channels == 1 {
                    let texture = Arc::make_mut(texture);
                    let colour = |&x: &f64| [0.9 * x, x, 0.8 * x];
                    texture.data = texture.data.iter().flat_map(colour).collect();
                    texture.channels = 3;
                }
            }
            let prepared = PreparedScene::new(scene);
            let scene = prepared.scene();
            let mut wanted = Wanted::by(&Tangent::zero(scene));
            wanted.textures = vec![true; scene.textures.len()];
            for shape in &scene.shapes {
                for slot in scene.slots_below(shape.bsdf) {
                    let id = scene.numbers_of(slot.texture, shape);
                    wanted.textures[id.0 as usize] &= !slot.quantity.moves_rays();
                }
            }
            let is_asked_for = |id: TextureId| wanted.textures[id.0 as usize];
            let Some(lanes) = LaneTracer::differentiating(&prepared, &is_asked_for) else {
                continue;
            };
            let [width, height] = scene.film.crop_size.map(|n| n as usize);
            let colour = |i: usize| Rgb::new(1.0, 0.5 + (i % 7) as f64 * 0.1, -0.3);
            let adjoint = Image {
                width,
                height,
                pixels: (0..width * height).map(colour).collect(),
            };
            let options = GradientOptions::new(RenderOptions::new(2, 5));
            let work = BackwardWork::new(&prepared, &adjoint, wanted.clone(), options);
            let part = Part::whole(work.grid());
            let arrays = |lanes: Option<&LaneTracer<'_>>| {
                let sums = work.sums_by(lanes, &options, None, &part, &Unwatched);
                let mut sums = sums.expect("nothing moves").into_sums().into_iter();
                let mut sum = sums.next().expect("a batch");
                sums.for_each(|next| sum.add(&next));
                sum.mean.textures()
            };
            let (found, expected) = (arrays(Some(&lanes)), arrays(None));
            // Packets let single rays pass edges on the other side.
            let tolerance = if lanes.has_packets() { 1e-3 } else { 1e-7 };
            let mut off = 0;
            for (found, expected) in found.iter().zip(&expected) {
                let size: f64 = expected.iter().map(|x| x.abs()).sum();
                let size = size / expected.len().max(1) as f64;
                let errors = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
                let error: f64 = errors.sum::<f64>() / expected.len().max(1) as f64;
                compared += u32::from(size > 0.0);
                off += u32::from(error.is_nan() || error > tolerance * size.max(1e-9));
            }
            if off > 0 {
                let name = file.strip_prefix(&tests).unwrap_or(&file).display();
                wrong.push(format!("{name}: {off} textures of {}", found.len()));
            }
        }
        assert!(compared > 800, "{compared}");
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
}
