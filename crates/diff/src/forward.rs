//! The derivative image in forward mode.

use capwalk_boundary::refuse::{
    is_specular_somewhere, refuse_cut_normals, refuse_infinite_derivatives, refuse_motion,
    refuse_settings, refuse_turned_without_uvs, refuse_uncovered,
};
use capwalk_boundary::{Counts, Draw, Field, Refusal, Stream};
use capwalk_render::tiles::{self, Sample};
use capwalk_render::{GradientImage, PreparedScene, RenderOptions, SceneEval, Tracer, Watch};
use capwalk_scene::{Tangent, TextureId};

use crate::forward_eval::Forward;
use crate::options::GradientOptions;

/// The derivative of the image for a unit change along `tangent`, in forward mode, with
/// its standard error. Refuses what it cannot differentiate rightly, see [`Refusal`].
pub fn gradient(
    prepared: &PreparedScene,
    tangent: &Tangent,
    options: &GradientOptions,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    let (scene, accel) = (prepared.scene(), prepared.accel());
    refuse_settings(&options.method, &options.walk)?;
    let is_asked_for = |id: TextureId| tangent.textures[id.0 as usize].is_some();
    refuse_infinite_derivatives(scene, is_asked_for)?;
    let field = Field::new(accel, prepared.boundaries(), options.method);
    #[cfg(feature = "paper")]
    capwalk_boundary::refuse::refuse_many_edges(field.boundaries, &options.method)?;
    let eval = Forward::new(field, tangent);
    let turns = tangent.shapes.iter().any(Option::is_some);
    refuse_cut_normals(scene, turns || eval.moves(), is_asked_for)?;
    if eval.moves() {
        refuse_motion(accel, &options.method)?;
    } else if turns {
        refuse_turned_without_uvs(scene)?;
    }
    let tracer = Tracer::moving(prepared, field, options.walk);
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
            uncovered: counts.uncovered.get(),
        }
    };
    // What cannot be covered is found by looking, before the work is done.
    let refuse = |uncovered, samples| refuse_uncovered(scene, uncovered, samples, &options.method);
    if options.method.traits().is_unbiased && is_specular_somewhere(scene) {
        let pilot = RenderOptions {
            spp: options.spp.min(PILOT_SPP),
            seed: options.seed,
        };
        let found = tiles::average(scene, &pilot, &Silent(watch), sample).statistics;
        refuse(found.uncovered, found.samples)?;
    }
    let averages = tiles::average(scene, &options.sampling(), watch, sample);
    refuse(averages.statistics.uncovered, averages.statistics.samples)?;
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
