//! The gradient of a loss from a device, in reverse mode.

use std::sync::Arc;

use capwalk_boundary::{Boundaries, Field, Sampler, pool};
use capwalk_diff::{Backward, BackwardWork, Chosen, GradientOptions, Reverse, Wanted};
use capwalk_gpu::GpuError;
use capwalk_math::Tape;
use capwalk_render::{
    MotionFacts, Plan, SampleRange, Statistics, Tracer, UsedDevice, Watch, tiles,
};
use capwalk_scene::{Gradient, Image};

use crate::camera_back::CameraBack;
use crate::camera_records::sample_words;
use crate::device_edges::{COLUMNS, DeviceEdges};
use crate::device_error::DeviceError;
use crate::device_scene::DeviceScene;
use crate::edge_records::{EdgeMotion, OfPoints};
use crate::fixed_point::{PartSums, Sums};
use crate::layout::change::ADJOINT_AT;
use crate::layout::reverse_path::CAMERA_BACK;
use crate::part_size::PartSize;
use crate::paths::{Followed, Paths};
use crate::render_kernels::REVERSE;
use crate::texture_records::float;
use crate::unsupported::{by_edges, settled, unsupported_derivative, unsupported_options};

/// Most samples that are on the device at a time: all their vertices are.
const MOST_WITH_VERTICES: usize = 1 << 16;

/// Room for so many vertices of each path to begin with.
const FEW_LEVELS: usize = 8;

/// No sum on the device may have more derivatives than this, see `sums.slang`.
const MOST_DERIVATIVES: usize = 1 << 24;

impl DeviceScene<'_> {
    /// The gradient of `Σ adjoint · image` in what is wanted, as [`capwalk_diff::backward`] has it, with
    /// its batches and refusals: where anything moves by [`Method::EDGES`], or by edges of fewer
    /// segments if these are asked for. An error if memory does not suffice
    /// for so many numbers. Derivatives that are not finite are left out, each by itself, and
    /// counted, at most as many as a part has samples.
    ///
    /// Sums are in fixed point, so their bits do not depend on which thread comes first.
    ///
    /// [`Method::EDGES`]: capwalk_diff::Method::EDGES
    pub fn backward(
        &self,
        adjoint: &Image,
        wanted: &Wanted,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<Backward, DeviceError> {
        self.backward_in_parts(adjoint, wanted, options, MOST_WITH_VERTICES, watch)
    }

    /// [`Self::backward`] with so many samples on the device at a time at most, which changes no bit.
    pub fn backward_in_parts(
        &self,
        adjoint: &Image,
        wanted: &Wanted,
        options: &GradientOptions,
        most: usize,
        watch: &dyn Watch,
    ) -> Result<Backward, DeviceError> {
        BackwardWork::new(self.prepared, adjoint, wanted.clone(), *options).check(watch)?;
        let sampling = options.sampling();
        let unsupported = unsupported_derivative(self.prepared, wanted, options);
        if let Some(unsupported) = unsupported.or_else(|| unsupported_options(&sampling)) {
            return Err(unsupported.into());
        }
        self.check_precision(wanted)?;
        let boundaries = self.prepared.boundaries_if(wanted.moves());
        self.interior_and_back(Some(boundaries), adjoint, wanted, options, most, watch)
    }

    /// The interior term of the gradient alone, see [`DeviceScene::interior_term`].
    #[doc(hidden)]
    pub fn interior_term_back(
        &self,
        adjoint: &Image,
        wanted: &Wanted,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<Backward, DeviceError> {
        self.interior_and_back(None, adjoint, wanted, options, MOST_WITH_VERTICES, watch)
    }

    fn interior_and_back(
        &self,
        boundaries: Option<&Boundaries>,
        adjoint: &Image,
        wanted: &Wanted,
        options: &GradientOptions,
        most: usize,
        watch: &dyn Watch,
    ) -> Result<Backward, DeviceError> {
        let accel = self.prepared.accel();
        let none = self.prepared.boundaries_if(false);
        let method = by_edges(&options.method, accel);
        let field = Field::new(accel, boundaries.unwrap_or(none), method);
        let facts = Arc::new(MotionFacts::of(&accel.scene, true));
        let tracer = Tracer::moving(self.prepared, field, options.walk, &facts);
        let inverse_scale = self.frame.inverse_scale;
        let mut sums = Sums::new(
            accel,
            boundaries.unwrap_or(none),
            &self.textures,
            wanted,
            inverse_scale,
        );
        self.check_room_of_numbers(sums.words())?;
        // A power of two that leaves derivatives with respect to pixels near one.
        let pixels = adjoint.pixels.iter().flat_map(|pixel| pixel.to_array());
        let steepest = pixels.fold(0.0_f64, |most, x| most.max(x.abs()));
        let exponent = match steepest > 0.0 {
            true => steepest.log2().floor().clamp(-1000.0, 1000.0),
            false => 0.0,
        };
        let crossed = boundaries.filter(|_| wanted.geometry());
        let crossed = crossed.map(|boundaries| {
            let points = wanted.points(accel, boundaries);
            let tape = Tape::default();
            let eval = Reverse::new(field, wanted, &points, &tape);
            let of_point = |point: u32| sums.of_point(point).filter(|_| points[point as usize]);
            let motion = EdgeMotion {
                is_blind: true,
                of_points: OfPoints::Sums(&of_point),
            };
            self.edges(&eval, &tracer, boundaries, &motion)
        });
        let crossed = crossed.transpose()?;
        let words = crossed.as_ref().map_or(0, DeviceEdges::words);
        let pixels = 3 * adjoint.pixels.len();
        self.check_room_of_numbers(sums.changes().len() + pixels + words)?;
        let chosen = settled(options, wanted);
        loop {
            let job = Job {
                scene: self,
                crossed: crossed.as_ref(),
                camera: CameraBack::new(&tracer, field, wanted, boundaries.is_some()),
                adjoint,
                unit: exponent.exp2(),
                options,
                chosen: &chosen,
                sums: &sums,
                most,
                watch,
            };
            if let Some(backward) = pool::install(|| job.run())? {
                return Ok(backward);
            }
            sums.widen();
        }
    }
}

/// A gradient with sums of these units.
struct Job<'a> {
    scene: &'a DeviceScene<'a>,
    camera: CameraBack<'a>,
    /// The edges that paths cross.
    crossed: Option<&'a DeviceEdges>,
    adjoint: &'a Image,
    /// What the adjoint is divided by on the device.
    unit: f64,
    options: &'a GradientOptions,
    /// These with the method that the device takes.
    chosen: &'a Chosen,
    sums: &'a Sums<'a>,
    most: usize,
    watch: &'a dyn Watch,
}

/// What becomes of a part.
enum Outcome {
    Done(PartSums),
    Stopped,
    NoLevel,
}

/// Where the samples are taken.
struct Place<'a> {
    sampler: Sampler,
    size: PartSize,
    /// No part may be larger.
    most: usize,
    levels: usize,
    paths: Option<Paths<'a>>,
}

impl<'a> Job<'a> {
    /// The gradient; `None` if units are too small.
    fn run(&self) -> Result<Option<Backward>, DeviceError> {
        let prepared = self.scene.prepared;
        let (scene, options) = (prepared.scene(), self.options);
        let deepest = Plan::new(scene).max_depth.unwrap_or(u32::MAX);
        let mut place = Place {
            sampler: Sampler::new(&scene.settings, options.seed, options.spp),
            size: PartSize::new(self.most),
            most: self.most,
            levels: 0,
            paths: None,
        };
        self.keep(
            &mut place,
            FEW_LEVELS.min(deepest.saturating_sub(1) as usize).max(1),
        );
        let grid = tiles::grid(scene, &options.sampling());
        let pixels = scene.film.pixel_count();
        let mut statistics = Statistics {
            device: UsedDevice::gpu(self.scene.gpu.name()),
            ..Statistics::default()
        };
        let (mut taken, mut done) = (0, 0);
        let mut batches: Vec<(Gradient, u64)> = Vec::new();
        for batch in 0..grid.batches {
            let samples = grid.samples(batch, options.spp, 1);
            let all = samples.len() * pixels;
            // Of whole samples of the image, and of what is begun.
            let mut sum = vec![0_i128; self.sums.count];
            let mut begun = sum.clone();
            let (mut at, mut whole) = (0, 0);
            while at < all && !self.watch.should_stop() {
                // Some samples of all pixels, or some pixels.
                let (most, rest) = (place.size.get(), pixels - at % pixels);
                let count = match at % pixels == 0 && most >= pixels {
                    true => (most / pixels * pixels).min(all - at),
                    false => most.min(rest),
                };
                let start = u64::from(samples.start) * pixels as u64 + at as u64;
                let numbers = start..start + count as u64;
                let some = SampleRange::new(place.sampler, &scene.film, numbers);
                let before = self.scene.gpu.busy();
                let part = match self.part(&some, &mut place) {
                    Ok(Outcome::Done(part)) => part,
                    Ok(Outcome::Stopped) => break,
                    Ok(Outcome::NoLevel) => {
                        let levels = 2 * place.levels;
                        self.keep(&mut place, levels);
                        continue;
                    }
                    Err(DeviceError::Gpu(GpuError::OutOfMemory { .. })) if place.size.halve() => {
                        place.most = place.size.get();
                        place.paths = None;
                        continue;
                    }
                    Err(error) => return Err(error),
                };
                if part.too_large > 0 {
                    return Ok(None);
                }
                let took = self.scene.gpu.busy().saturating_sub(before);
                place.size.follow(took, count);
                // Some samples have several.
                statistics.non_finite += u64::from(part.non_finite).min(count as u64);
                add(&mut begun, part.sums.into_iter());
                at += count;
                if at % pixels == 0 {
                    add(&mut sum, begun.iter_mut().map(std::mem::take));
                    whole = at / pixels;
                }
                done += count as u64;
                let total = u64::from(options.spp) * pixels as u64;
                self.watch.progress(done, total);
            }
            taken += whole as u32;
            if whole > 0 || (batches.is_empty() && batch + 1 == grid.batches) {
                let times = whole.max(1) as f64;
                let gradient = self.sums.gradient(&sum, times);
                let gradient = gradient.scaled(self.unit);
                batches.push((gradient, (whole.max(1) * pixels) as u64));
            }
        }
        statistics.samples_per_pixel = vec![taken; pixels];
        statistics.complete = taken == options.spp;
        statistics.samples = u64::from(taken) * pixels as u64;
        let chosen = self.chosen.clone();
        Ok(Some(Backward::new(batches, chosen, statistics)))
    }

    /// From now on, so many vertices of each path are kept, of as many paths as fit.
    fn keep(&self, place: &mut Place, levels: usize) {
        let sampling = Plan::new(self.scene.prepared.scene()).sampling;
        let by_texels = 2 + sampling.emitter_samples + sampling.bsdf_samples;
        // A lookup may have the same texel four times, and the camera sees emitters.
        let by_sums = MOST_DERIVATIVES / (4 * (levels * by_texels as usize + 1));
        let columns = self.crossed.map_or(1, |_| COLUMNS);
        let bytes = 4 * (REVERSE.words(levels) * columns) as u64;
        let by_memory = (self.scene.gpu.largest_buffer() / bytes) as usize;
        place.most = place.most.min(by_sums).min(by_memory);
        place.size = PartSize::new(place.most);
        place.levels = levels;
        place.paths = None;
    }

    /// What some samples, each of a pixel, add to the sums.
    fn part(&self, samples: &SampleRange, place: &mut Place<'a>) -> Result<Outcome, DeviceError> {
        let capacity = place.size.get();
        let paths = match &mut place.paths {
            Some(paths) if paths.capacity() >= capacity => paths,
            other => {
                *other = None;
                let (mut changes, sums) = (self.sums.changes(), self.sums.words());
                changes[ADJOINT_AT] = changes.len() as u32;
                let adjoint = self.adjoint.pixels.iter();
                changes.extend(adjoint.flat_map(|&x| (x / self.unit).to_array().map(float)));
                if let Some(edges) = self.crossed {
                    edges.append(&mut changes);
                }
                let capacity = [capacity, place.levels];
                let paths = self
                    .scene
                    .paths(&REVERSE, capacity, &changes, sums, self.crossed)?;
                other.insert(paths)
            }
        };
        paths.clear_sums(self.sums.words())?;
        let beginning = sample_words(samples);
        match paths.follow(samples.len(), &beginning, self.watch)? {
            Followed::ToTheEnd(lists) if paths.go_back(&lists, self.watch)? => {}
            Followed::ToTheEnd(_) | Followed::Stopped => return Ok(Outcome::Stopped),
            Followed::NoLevel => return Ok(Outcome::NoLevel),
        }
        let mut part = PartSums::read(&paths.sums(self.sums.words())?);
        if self.camera.rays_are_wanted() {
            let back = paths.numbers_from(CAMERA_BACK, samples.len())?;
            self.camera
                .rays_back(&self.scene.frame, samples, &back, self.sums, &mut part);
        }
        let edges = self
            .camera
            .edges(self.scene, samples, capacity, self.watch)?;
        let Some(edges) = edges else {
            return Ok(Outcome::Stopped);
        };
        for edge in edges {
            let [pixel, _] = samples.pixel_and_sample(edge.sample);
            let adjoint = self.adjoint.pixels[pixel as usize] / self.unit;
            let by_flow = 3.0 * (adjoint * edge.discontinuity).mean();
            for (target, covector) in edge.flow {
                self.sums.add(&mut part, target, covector * by_flow);
            }
        }
        Ok(Outcome::Done(part))
    }
}

fn add(sums: &mut [i128], more: impl Iterator<Item = i128>) {
    sums.iter_mut().zip(more).for_each(|(sum, x)| *sum += x);
}
