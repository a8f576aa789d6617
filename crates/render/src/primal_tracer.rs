//! Samples of the primal image: several at a time where the scene allows it, else one by one.

use capwalk_boundary::{Counts, Draw};

use crate::lanes::LaneTracer;
use crate::prepared::PreparedScene;
use crate::scene_eval::Primal;
use crate::tiles::{self, Sample, SamplePlace};
use crate::tracer::Tracer;

/// Samples pixels of the primal image.
pub enum PrimalTracer<'a> {
    /// Eight at a time.
    Lanes(Box<LaneTracer<'a>>),
    /// One by one.
    Single(Box<Tracer<'a>>),
}

impl<'a> PrimalTracer<'a> {
    /// What samples like this tracer, which has no motion.
    pub fn new(tracer: Tracer<'a>, prepared: &'a PreparedScene) -> Self {
        match LaneTracer::like(&tracer, prepared) {
            Some(lanes) => Self::Lanes(Box::new(lanes)),
            None => Self::Single(Box::new(tracer)),
        }
    }

    /// Appends the samples of some places: red, green and blue.
    pub fn take(&self, places: &[SamplePlace], taken: &mut Vec<Sample<3>>) {
        match self {
            Self::Lanes(lanes) => lanes.take(places, taken),
            Self::Single(tracer) => {
                let eval = Primal(tracer.accel);
                let take = tiles::one_by_one(|pixel, stream| {
                    let draw = Draw {
                        stream,
                        counts: &Counts::default(),
                    };
                    Sample {
                        numbers: tracer.pixel(&eval, pixel, draw).to_array(),
                        ..Sample::default()
                    }
                });
                take(places, taken);
            }
        }
    }
}
