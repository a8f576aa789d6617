//! The derivative picture in forward mode.

use std::cell::Cell;

use capwalk_scene::{Motion, Scene};
use capwalk_walk::WalkSettings;

use crate::accel::Accel;
use crate::estimate::GradientImage;
use crate::options::{GradientOptions, Refusal, Watch};
use crate::path::Tracer;
use crate::tiles::{self, Sample};
use crate::unsupported::unsupported_text;

use super::boundary::{Draw, Field};
use super::clip::refuse_clipped;
use super::motion::InMotion;

/// The derivative of the picture for a unit change along `motion`, in forward
/// mode, with its standard error. Refuses what it cannot differentiate rightly:
/// surfaces that move while a clip plane of the camera cuts them.
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
        refuse_clipped(&accel)?;
    }
    let tracer = Tracer::moving(&accel, &field, options.walk);
    let averages = tiles::average(scene, &options.options, watch, |pixel, stream| {
        let queries = Cell::new(0);
        let draw = Draw {
            stream,
            queries: &queries,
        };
        let light = tracer.pixel(&world, pixel, draw);
        let (value, slope) = (light.value(), light.tangent(0));
        Sample {
            numbers: [value.x, value.y, value.z, slope.x, slope.y, slope.z],
            cone_queries: queries.get(),
        }
    });
    Ok(GradientImage {
        value: averages.estimate(scene, 0),
        gradient: averages.estimate(scene, 3),
        statistics: averages.statistics,
    })
}

/// The reason why derivatives by whatever moves edges are refused for the scene,
/// if they are.
pub fn refusal(scene: &Scene) -> Option<Refusal> {
    if let Err(refusal) = refuse_unsupported(scene) {
        return Some(refusal);
    }
    refuse_clipped(&Accel::new(scene)).err()
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
