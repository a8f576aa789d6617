//! The derivative picture in forward mode.

use capwalk_scene::{Motion, Scene, TextureId};

use crate::accel::Accel;
use crate::estimate::GradientImage;
use crate::options::{GradientOptions, Options, Refusal, Watch};
use crate::path::Tracer;
use crate::sampler::Stream;
use crate::tiles::{self, Sample};
use crate::world::World;

use super::boundary::{Counts, Draw, Field};
use super::motion::InMotion;
use super::refuse::{
    is_specular_somewhere, refuse_cut_normals, refuse_many_edges, refuse_motion, refuse_settings,
    refuse_turned_without_uvs, refuse_uncovered,
};
use super::slope::refuse_infinite_slopes;

/// The derivative of the picture for a unit change along `motion`, in forward
/// mode, with its standard error. Refuses what it cannot differentiate rightly:
/// surfaces that move while a clip plane of the camera cuts them, and things that
/// move in curved mirrors and refracting glass.
pub fn gradient(
    scene: &Scene,
    motion: &Motion,
    options: &GradientOptions,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    refuse_settings(options)?;
    let is_asked_for = |id: TextureId| motion.textures[id.0 as usize].is_some();
    refuse_infinite_slopes(scene, is_asked_for)?;
    let accel = Accel::new(scene);
    let field = Field::new(&accel, options.method);
    refuse_many_edges(&field)?;
    let world = InMotion::new(&accel, &field, motion);
    let turns = motion.shapes.iter().any(Option::is_some);
    refuse_cut_normals(scene, turns || world.moves(), is_asked_for)?;
    if world.moves() {
        refuse_motion(&accel, &options.method)?;
    } else if turns {
        refuse_turned_without_uvs(scene)?;
    }
    let tracer = Tracer::moving(&accel, &field, options.walk);
    let sample = |pixel: [u32; 2], stream: &Stream| {
        let counts = Counts::default();
        let draw = Draw {
            stream,
            counts: &counts,
        };
        let light = tracer.pixel(&world, pixel, draw);
        let (value, slope) = (light.value(), light.tangent(0));
        Sample {
            numbers: [value.x, value.y, value.z, slope.x, slope.y, slope.z],
            cone_queries: counts.queries.get(),
            uncovered: counts.uncovered.get(),
        }
    };
    // What cannot be covered is found by looking, before the work is done.
    if options.method.is_unbiased() && is_specular_somewhere(scene) {
        let pilot = Options {
            spp: options.options.spp.min(PILOT_SPP),
            ..options.options
        };
        let statistics = tiles::average(scene, &pilot, &Silent(watch), sample).statistics;
        refuse_uncovered(scene, &statistics, &options.method)?;
    }
    let averages = tiles::average(scene, &options.options, watch, sample);
    refuse_uncovered(scene, &averages.statistics, &options.method)?;
    Ok(GradientImage {
        value: averages.estimate(scene, 0),
        gradient: averages.estimate(scene, 3),
        statistics: averages.statistics,
    })
}

/// Stops when another watch does, and says nothing.
struct Silent<'a>(&'a dyn Watch);

impl Watch for Silent<'_> {
    fn progress(&self, _done: u64, _total: u64) {}
    fn should_stop(&self) -> bool {
        self.0.should_stop()
    }
}

/// Samples per pixel of a first look.
const PILOT_SPP: u32 = 2;
