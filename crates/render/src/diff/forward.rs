//! The derivative picture in forward mode.

use capwalk_scene::{Emitter, Motion, Scene};
use capwalk_walk::WalkSettings;

use crate::accel::Accel;
use crate::estimate::{GradientImage, Statistics};
use crate::material::textures_of;
use crate::options::{GradientOptions, Options, Refusal, Unwatched, Watch};
use crate::path::Tracer;
use crate::sampler::Stream;
use crate::tiles::{self, Sample};
use crate::unsupported::unsupported_text;

use super::boundary::{Counts, Draw, Field};
use super::clip::refuse_clipped;
use super::motion::InMotion;

/// The derivative of the picture for a unit change along `motion`, in forward
/// mode, with its standard error. Refuses what it cannot differentiate rightly:
/// surfaces that move while a clip plane of the camera cuts them, and things that
/// move in mirrors and smooth glass.
pub fn gradient(
    scene: &Scene,
    motion: &Motion,
    options: &GradientOptions,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    refuse_unsupported(scene)?;
    check_walk(&options.walk)?;
    let accel = Accel::new(scene);
    let field = Field::new(&accel);
    let world = InMotion::new(&accel, &field, motion);
    if world.moves() {
        refuse_hard_shadows(scene)?;
        refuse_jumping_textures(scene)?;
        refuse_clipped(&accel)?;
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
    let pilot = Options {
        spp: options.options.spp.min(PILOT_SPP),
        ..options.options
    };
    refuse_uncovered(&tiles::average(scene, &pilot, &Unwatched, sample).statistics)?;
    let averages = tiles::average(scene, &options.options, watch, sample);
    refuse_uncovered(&averages.statistics)?;
    Ok(GradientImage {
        value: averages.estimate(scene, 0),
        gradient: averages.estimate(scene, 3),
        statistics: averages.statistics,
    })
}

/// A refusal if there are lights without extent: the edges of their shadows lie on
/// surfaces, not among directions (METHOD 7).
pub(super) fn refuse_hard_shadows(scene: &Scene) -> Result<(), Refusal> {
    let is_delta = |emitter: &&Emitter| {
        matches!(
            emitter,
            Emitter::Point { .. } | Emitter::Spot { .. } | Emitter::Directional { .. }
        )
    };
    match scene.emitters.iter().find(is_delta) {
        None => Ok(()),
        Some(emitter) => Err(Refusal {
            reason: format!(
                "the emitter \"{}\" ({}) has no extent, and the motion of the hard edges of its \
                 shadows is not available. Use a small area lamp instead, or finite differences",
                emitter.name(scene),
                emitter.plugin()
            ),
        }),
    }
}

/// A refusal if a texture jumps inside faces: its motion against the rays would be
/// missed (METHOD 7).
pub(super) fn refuse_jumping_textures(scene: &Scene) -> Result<(), Refusal> {
    for shape in &scene.shapes {
        if let Some(texture) = textures_of(scene, shape).iter().find(|t| t.jumps()) {
            return Err(Refusal {
                reason: format!(
                    "the texture \"{}\" on the shape \"{}\" jumps from texel to texel, and the \
                     motion of these jumps is not available. Use the filter `bilinear`, or finite \
                     differences",
                    texture.id, shape.id
                ),
            });
        }
    }
    Ok(())
}

/// Samples per pixel of a first look.
const PILOT_SPP: u32 = 2;

/// A refusal if something moved in a mirror or behind glass.
pub(super) fn refuse_uncovered(statistics: &Statistics) -> Result<(), Refusal> {
    if statistics.uncovered == 0 {
        return Ok(());
    }
    let share = statistics.uncovered as f64 / statistics.samples as f64;
    Err(Refusal {
        reason: format!(
            "things move that are seen in perfectly specular reflection or refraction (about \
             {:.2} events in 100 samples), and the motion of their outlines there is not \
             available. Shadows seen in a mirror at rest are. Use a rough material (alpha of \
             0.01 or more) instead of the perfectly smooth one, or finite differences",
            100.0 * share
        ),
    })
}

/// The reason why derivatives by whatever moves edges are refused for the scene,
/// if they are.
pub fn refusal(scene: &Scene) -> Option<Refusal> {
    if let Err(refusal) = refuse_unsupported(scene) {
        return Some(refusal);
    }
    refuse_hard_shadows(scene)
        .and_then(|()| refuse_jumping_textures(scene))
        .and_then(|()| refuse_clipped(&Accel::new(scene)))
        .err()
}

/// Refuses what cannot be rendered yet.
pub(super) fn refuse_unsupported(scene: &Scene) -> Result<(), Refusal> {
    match unsupported_text(scene) {
        None => Ok(()),
        Some(reason) => Err(Refusal { reason }),
    }
}

pub(super) fn check_walk(walk: &WalkSettings) -> Result<(), Refusal> {
    if walk.steps == 0 {
        return Err(Refusal {
            reason: "a walk of 0 steps gives a field that is not continuous, and a wrong \
                     derivative; use at least 1 step"
                .into(),
        });
    }
    if !(walk.max_radius > 0.0 && walk.max_radius <= std::f64::consts::PI) {
        return Err(Refusal {
            reason: format!(
                "the largest angle of a walk is {}; expected radians above 0 and at most π",
                walk.max_radius
            ),
        });
    }
    Ok(())
}
