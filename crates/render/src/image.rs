//! The primal image.

use std::sync::OnceLock;

use capwalk_boundary::{Counts, Draw};
use capwalk_math::Rgb;
use capwalk_scene::fingerprint;

use crate::adaptive;
use crate::estimate::Rendering;
use crate::grid::{Grid, Part};
use crate::lanes::{LaneTracer, RayPrecision};
use crate::options::{RenderOptions, Watch};
use crate::part_error::PartError;
use crate::partial::Partial;
use crate::plan::Plan;
use crate::prepared::PreparedScene;
use crate::scene_eval::Primal;
use crate::tiles::{self, Averages, EFFORT_OF_LIGHT, PixelSums, Sample, SampleCounts, TakeSamples};
use crate::tracer::Tracer;

/// The image of a scene, with its standard error.
pub fn render(prepared: &PreparedScene, options: &RenderOptions, watch: &dyn Watch) -> Rendering {
    let work = RenderWork::new(prepared, *options);
    let partial = work.sums(None, &Part::whole(work.grid()), watch);
    work.rendering(partial.into_sums())
}

/// What appends samples of an image: many at a time if that is of light, else one by one.
pub fn take_light<'a>(
    plan: Plan,
    prepared: &'a PreparedScene,
    precision: RayPrecision,
) -> Box<TakeSamples<'a>> {
    if let Some(lanes) = LaneTracer::of_light(plan, prepared, precision) {
        return Box::new(move |runs, taken| lanes.take(runs, taken));
    }
    let tracer = Tracer::primal(prepared).with_plan(plan);
    Box::new(tiles::one_by_one(EFFORT_OF_LIGHT, move |pixel, stream| {
        let draw = Draw {
            stream,
            counts: &Counts::default(),
        };
        let light: Rgb = tracer.pixel(&Primal(tracer.accel), pixel, draw);
        Sample {
            numbers: light.to_array(),
            ..Sample::default()
        }
    }))
}

/// An image that is rendered in parts.
#[derive(Debug)]
pub struct RenderWork<'a> {
    prepared: &'a PreparedScene,
    options: RenderOptions,
    /// How many samples each pixel gets; found by the first call that samples.
    counts: OnceLock<SampleCounts>,
    fingerprint: OnceLock<u64>,
}

impl<'a> RenderWork<'a> {
    /// The image of a scene.
    pub fn new(prepared: &'a PreparedScene, options: RenderOptions) -> Self {
        Self {
            prepared,
            options,
            counts: OnceLock::new(),
            fingerprint: OnceLock::new(),
        }
    }

    /// The cells that the work can be cut into.
    pub fn grid(&self) -> Grid {
        tiles::grid(self.prepared.scene(), &self.options)
    }

    /// What a part of the work gives: of its cells those that are finished when `watch` stops
    /// the work.
    pub fn part(&self, part: &Part, watch: &dyn Watch) -> Result<Partial<PixelSums>, PartError> {
        part.check(self.grid())?;
        Ok(self.sums(Some(self.fingerprint()), part, watch))
    }

    /// The image, from all of its parts. The bits are those of [`render`].
    pub fn finish(&self, parts: Partial<PixelSums>) -> Result<Rendering, PartError> {
        let (scene, grid) = (self.prepared.scene(), self.grid());
        let right = |band: u32, sums: &PixelSums| sums.is_of(scene, grid, band, 3);
        let sums = parts.complete(self.fingerprint(), grid, right)?;
        Ok(self.rendering(sums))
    }

    fn sums(&self, work: Option<u64>, part: &Part, watch: &dyn Watch) -> Partial<PixelSums> {
        let (scene, options) = (self.prepared.scene(), &self.options);
        let counts = &self.counts;
        let counts = adaptive::sample_counts(counts, scene, options, watch, 0, |pilot, watch| {
            let part = Part::whole(tiles::grid(scene, pilot));
            self.average(pilot, &SampleCounts::Even, None, &part, watch)
        });
        self.average(options, &counts, work, part, watch)
    }

    /// Averages samples that are taken so.
    fn average(
        &self,
        options: &RenderOptions,
        counts: &SampleCounts,
        work: Option<u64>,
        part: &Part,
        watch: &dyn Watch,
    ) -> Partial<PixelSums> {
        let scene = self.prepared.scene();
        let take = take_light(Plan::new(scene), self.prepared, RayPrecision::Resolving);
        tiles::average(scene, options, counts, work, part, watch, take)
    }

    fn rendering(&self, sums: Vec<PixelSums>) -> Rendering {
        let averages = Averages::new(sums);
        Rendering {
            value: averages.estimate(self.prepared.scene(), 0),
            statistics: averages.statistics,
        }
    }

    fn fingerprint(&self) -> u64 {
        let inputs = ("image", self.prepared.scene(), &self.options);
        *self.fingerprint.get_or_init(|| fingerprint(&inputs))
    }
}
