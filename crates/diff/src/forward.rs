//! The derivative image in forward mode.

use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

use capwalk_boundary::refuse::{
    refuse_boundaries, refuse_cut_normals, refuse_infinite_derivatives, refuse_many_shadows,
    refuse_motion, refuse_settings, refuse_specular, refuse_turned_without_uvs,
};
use capwalk_boundary::{Boundaries, Counts, Draw, Field, Refusal, Stream};
use capwalk_math::Rgb;
use capwalk_render::tiles::{
    self, Averages, EFFORT_OF_DERIVATIVE, PixelSums, Sample, SampleCounts, SampleRun, count_samples,
};
use capwalk_render::{
    Differentiator, Grid, LaneTracer, MotionFacts, Part, PartError, Partial, PathAdjoint,
    PreparedScene, RenderOptions, SceneEval, Statistics, Tracer, Watch, adaptive,
};
use capwalk_scene::{Tangent, TextureId, fingerprint};

use crate::adjoint::Wanted;
use crate::auto::{Chosen, KeptChoice, Pilot, PilotSize};
use crate::forward_eval::Forward;
use crate::gradient_image::GradientImage;
use crate::options::GradientOptions;
use crate::refused::boundaries;

/// The derivative of the image for a unit change along `tangent`, in forward mode, with
/// its standard error. Refuses what it cannot differentiate rightly, see [`Refusal`].
pub fn gradient(
    prepared: &PreparedScene,
    tangent: &Tangent,
    options: &GradientOptions,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    GradientWork::new(prepared, Cow::Borrowed(tangent), *options).whole(watch)
}

/// A derivative image that is computed in parts.
#[derive(Debug)]
pub struct GradientWork<'a> {
    prepared: &'a PreparedScene,
    tangent: Cow<'a, Tangent>,
    /// What it moves.
    wanted: Wanted,
    options: GradientOptions,
    /// The method, chosen once.
    chosen: OnceLock<Chosen>,
    kept: KeptChoice,
    facts: Arc<MotionFacts>,
    /// How many samples each pixel gets; found by the first call that samples.
    counts: OnceLock<SampleCounts>,
    fingerprint: OnceLock<u64>,
}

impl<'a> GradientWork<'a> {
    /// The derivative of the image along a tangent.
    pub fn new(
        prepared: &'a PreparedScene,
        tangent: Cow<'a, Tangent>,
        options: GradientOptions,
    ) -> Self {
        let wanted = Wanted::by(&tangent);
        let turns_light = wanted.turns_light(prepared.scene());
        Self {
            prepared,
            wanted,
            tangent,
            options,
            chosen: OnceLock::new(),
            kept: KeptChoice::default(),
            facts: Arc::new(MotionFacts::of(prepared.scene(), turns_light)),
            counts: OnceLock::new(),
            fingerprint: OnceLock::new(),
        }
    }

    /// This work by the method that is kept there. If none is, the choice of this work is kept.
    #[must_use]
    pub fn keeping(self, kept: KeptChoice) -> Self {
        Self { kept, ..self }
    }

    /// What changes.
    pub fn tangent(&self) -> &Tangent {
        &self.tangent
    }

    /// The cells that the work can be cut into.
    pub fn grid(&self) -> Grid {
        tiles::grid(self.prepared.scene(), &self.options.sampling())
    }

    /// Builds the boundaries that the work needs, unless they are built. [`Refusal::Stopped`] if the
    /// watch stops it.
    pub fn prepare(&self, watch: &dyn Watch) -> Result<(), Refusal> {
        self.boundaries(watch).map(|_| ())
    }

    /// All of it at once, see [`gradient`].
    pub fn whole(&self, watch: &dyn Watch) -> Result<GradientImage, Refusal> {
        let (chosen, part) = (self.chosen(watch)?, Part::whole(self.grid()));
        let partial = self.sums(&chosen.options, None, &part, watch)?;
        Ok(self.gradient_image(partial.into_sums(), chosen))
    }

    /// The method that the work is done by, see [`Method::Auto`](crate::Method::Auto); found
    /// by the first call. Refused like the work.
    pub fn chosen(&self, watch: &dyn Watch) -> Result<Chosen, Refusal> {
        let choose = || {
            let pilot = Pilot {
                prepared: self.prepared,
                tangent: &self.tangent,
                facts: &self.facts,
                is_blind: self.options.blind,
                options: &self.options,
                size: PilotSize::of(self.prepared.scene(), &self.options, 1),
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
    pub fn part(&self, part: &Part, watch: &dyn Watch) -> Result<Partial<PixelSums>, PartError> {
        part.check(self.grid())?;
        let options = self.chosen(watch)?.options;
        Ok(self.sums(&options, Some(self.fingerprint()), part, watch)?)
    }

    /// The derivative image, from all of its parts. The bits are those of [`gradient`].
    pub fn finish(&self, parts: Partial<PixelSums>) -> Result<GradientImage, PartError> {
        let (scene, grid) = (self.prepared.scene(), self.grid());
        let right = |band: u32, sums: &PixelSums| sums.is_of(scene, grid, band, NUMBERS);
        let sums = parts.complete(self.fingerprint(), grid, right)?;
        let chosen = Chosen::known_or_asked(&self.chosen, &self.options);
        Ok(self.gradient_image(sums, chosen))
    }

    fn sums(
        &self,
        options: &GradientOptions,
        work: Option<u64>,
        part: &Part,
        watch: &dyn Watch,
    ) -> Result<Partial<PixelSums>, Refusal> {
        let (scene, sampling) = (self.prepared.scene(), options.sampling());
        let boundaries = self.boundaries(watch)?;
        let (known, first) = (&self.counts, DERIVATIVE);
        let counts =
            adaptive::sample_counts(known, scene, &sampling, watch, first, |pilot, watch| {
                let part = Part::whole(tiles::grid(scene, pilot));
                let even = SampleCounts::Even;
                self.average(boundaries, options, pilot, &even, None, &part, watch)
            });
        Ok(self.average(boundaries, options, &sampling, &counts, work, part, watch))
    }

    /// Averages samples of this method, taken so, so many of each pixel.
    #[expect(clippy::too_many_arguments)]
    fn average(
        &self,
        boundaries: &Boundaries,
        options: &GradientOptions,
        sampling: &RenderOptions,
        counts: &SampleCounts,
        work: Option<u64>,
        part: &Part,
        watch: &dyn Watch,
    ) -> Partial<PixelSums> {
        let (prepared, scene) = (self.prepared, self.prepared.scene());
        let field = Field::new(prepared.accel(), boundaries, options.method);
        let eval = Forward::new(field, &self.tangent);
        let eval = match options.blind {
            true => eval.blind(),
            false => eval,
        };
        // A sample is one of the image, over numbers that carry their derivative along
        // the tangent.
        let tracer = Tracer::moving(prepared, field, options.walk, &self.facts);
        // Where nothing moves, paths are those of an image.
        let is_asked_for = |id: TextureId| self.tangent.textures[id.0 as usize].is_some();
        let lanes = match self.wanted.moves() {
            true => None,
            false => LaneTracer::differentiating(prepared, &is_asked_for),
        };
        if let Some(lanes) = lanes {
            let take = |runs: &[SampleRun], taken: &mut Vec<_>| {
                take_together(&lanes, &tracer, &eval, runs, taken);
            };
            return tiles::average(scene, sampling, counts, work, part, watch, take);
        }
        // If the watch stops this, no sample is taken either.
        let _ = tracer.build_edge_samplers(watch);
        let sample = |pixel: [u32; 2], stream: &Stream| {
            let counts = Counts::default();
            let draw = Draw {
                stream,
                counts: &counts,
            };
            let light = tracer.pixel(&eval, pixel, draw);
            let (value, derivative) = (light.value(), light.tangent(0));
            let [[a, b, c], [d, e, f]] = [value, derivative].map(|rgb| rgb.to_array());
            Sample {
                numbers: [a, b, c, d, e, f],
                cone_queries: counts.queries.get(),
                ..Sample::default()
            }
        };
        let take = tiles::one_by_one(EFFORT_OF_DERIVATIVE, sample);
        tiles::average(scene, sampling, counts, work, part, watch, take)
    }

    fn boundaries(&self, watch: &dyn Watch) -> Result<&'a Boundaries, Refusal> {
        let moves = self.wanted.moves() || self.facts.turns_light();
        boundaries(self.prepared, moves, watch)
    }

    /// Refuses what cannot be differentiated rightly. That needs no sample, but the boundaries if
    /// something moves: [`Refusal::Stopped`] if the watch stops their construction.
    pub fn check(&self, watch: &dyn Watch) -> Result<(), Refusal> {
        let options = &self.options;
        let (prepared, tangent) = (self.prepared, &*self.tangent);
        let (scene, accel) = (prepared.scene(), prepared.accel());
        refuse_settings(&options.method, &options.walk)?;
        let is_asked_for = |id: TextureId| tangent.textures[id.0 as usize].is_some();
        refuse_infinite_derivatives(scene, is_asked_for)?;
        let moves = self.facts.turns_light();
        let turns = tangent.shapes.iter().any(Option::is_some);
        refuse_cut_normals(scene, turns || moves, is_asked_for)?;
        if moves {
            refuse_motion(accel, &options.method)?;
            refuse_specular(scene, &options.method)?;
            refuse_many_shadows(self.boundaries(watch)?)?;
        } else if turns {
            refuse_turned_without_uvs(scene)?;
        }
        refuse_boundaries(self.boundaries(watch)?, &options.method, &options.walk)
    }

    fn gradient_image(&self, sums: Vec<PixelSums>, chosen: Chosen) -> GradientImage {
        let scene = self.prepared.scene();
        let averages = Averages::new(sums);
        let value = averages.estimate(scene, 0);
        let statistics = Statistics {
            dips: self.facts.dips(self.prepared.accel()),
            ..averages.statistics.clone()
        };
        GradientImage {
            value,
            gradient: averages.estimate(scene, DERIVATIVE),
            chosen: Some(chosen),
            statistics,
        }
    }

    fn fingerprint(&self) -> u64 {
        let scene = self.prepared.scene();
        let inputs = ("gradient", scene, &self.tangent, &self.options);
        *self.fingerprint.get_or_init(|| fingerprint(&inputs))
    }
}

/// The effort of the derivative at one place of a path, about.
const EFFORT_OF_ADJOINT: u64 = 8;

/// Appends samples in which nothing moves.
fn take_together(
    lanes: &LaneTracer<'_>,
    tracer: &Tracer<'_>,
    eval: &Forward<'_>,
    runs: &[SampleRun],
    taken: &mut Vec<Sample<NUMBERS>>,
) {
    let count = count_samples(runs);
    let mut samples = Vec::with_capacity(count);
    let mut derivatives = vec![Rgb::zero(); count];
    let covectors = vec![Rgb::splat(1.0); count];
    let mut efforts = vec![0; count];
    Differentiator::new(lanes).take(runs, &covectors, &mut samples, |sample, on_path| {
        efforts[sample] += EFFORT_OF_ADJOINT;
        let velocity = |texture, index| eval.texel(texture, index).tangent(0);
        derivatives[sample] += match on_path {
            PathAdjoint::Texel {
                texture,
                index,
                covector,
            } => velocity(texture, index) * covector,
            PathAdjoint::MixedTexel {
                texture,
                index,
                covectors: [on_r, on_g, on_b],
            } => {
                let Rgb { r, g, b } = velocity(texture, index);
                on_r * r + on_g * g + on_b * b
            }
            PathAdjoint::Irradiance {
                emitter,
                position,
                covector,
            } => {
                let irradiance = tracer.irradiance(eval, emitter, position);
                irradiance.map_or(Rgb::zero(), |light| light.tangent(0) * covector)
            }
        };
    });
    let derivatives = derivatives.into_iter().zip(efforts);
    taken.extend(
        samples
            .iter()
            .zip(derivatives)
            .map(|(sample, (derivative, effort))| {
                let [[a, b, c], [d, e, f]] = [sample.numbers, derivative.to_array()];
                Sample {
                    numbers: [a, b, c, d, e, f],
                    effort: sample.effort + effort,
                    ..Sample::default()
                }
            }),
    );
}

/// Numbers of a sample: value and derivative.
const NUMBERS: usize = 6;
/// The first of the derivative.
const DERIVATIVE: usize = 3;
