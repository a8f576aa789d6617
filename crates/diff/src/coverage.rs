//! Whether silhouettes move that are seen in curved mirrors or behind refracting glass, and that no
//! field has: asked before the work, in all modes alike.
//!
//! The answer follows from the scene and from what moves in it, by facts where these suffice and else
//! by a probe ([`SpecularProbe`]), which does not depend on the samples that are asked for. It is kept
//! with the prepared scene.

use std::sync::Arc;

use capwalk_boundary::refuse::uncovered_motion;
use capwalk_boundary::{Field, Method, Refusal, bends_images, pool};
use capwalk_math::Tape;
use capwalk_render::{
    MotionFacts, PreparedScene, ProbedMotion, SpecularProbe, Tracer, UncoveredEvents, Watch,
};
use capwalk_scene::{Quantity, Scene, fingerprint};
use capwalk_walk::WalkSettings;
use rayon::prelude::*;

use crate::adjoint::Wanted;
use crate::options::GradientOptions;
use crate::refused::boundaries;
use crate::reverse_eval::Reverse;

/// What of a derivative with respect to what is wanted is covered, method by method.
pub(crate) struct Coverage<'a> {
    pub(crate) prepared: &'a PreparedScene,
    pub(crate) wanted: &'a Wanted,
}

impl Coverage<'_> {
    /// Refuses what the method does not cover, unless that may be missing. A method that chooses
    /// takes what covers most. [`Refusal::Stopped`] if the watch stops the construction of the
    /// boundaries, which a probe needs.
    pub(crate) fn check(
        &self,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<(), Refusal> {
        boundaries(self.prepared, self.wanted.moves(), watch)?;
        match !options.allow_missing.specular && self.is_incomplete(options) {
            true => Err(self.refusal(options)),
            false => Ok(()),
        }
    }

    /// True if an unbiased method leaves something out.
    pub(crate) fn is_incomplete(&self, options: &GradientOptions) -> bool {
        options.method.traits().is_unbiased && self.uncovered(options) > 0
    }

    /// How many specular events of a probe the method does not cover.
    pub(crate) fn uncovered(&self, options: &GradientOptions) -> u64 {
        if !may_turn_light(self.prepared.scene(), self.wanted) {
            return 0;
        }
        let method = covering_most(options.method);
        let is_spherical = method.traits().is_spherical;
        let alone = (!is_spherical).then(|| method.name());
        let motion = fingerprint(&(self.wanted, alone));
        let probe = || match is_spherical {
            // Which segments walk is known to the probe.
            true => self.probe(Method::EDGES),
            false => self.probe(method),
        };
        let events = self.prepared.uncovered_events(motion, probe);
        match events == UncoveredEvents::default() {
            true => 0,
            false => events.count(self.tracer(method).gathers),
        }
    }

    fn refusal(&self, options: &GradientOptions) -> Refusal {
        let by_edges = GradientOptions {
            method: Method::EDGES,
            ..*options
        };
        let by_walks = options.method.traits().is_spherical && !self.is_incomplete(&by_edges);
        uncovered_motion(self.prepared.scene(), &options.method, by_walks)
    }

    fn field(&self, method: Method) -> Field<'_> {
        let boundaries = self.prepared.boundaries_if(self.wanted.moves());
        Field::new(self.prepared.accel(), boundaries, method)
    }

    fn tracer(&self, method: Method) -> Tracer<'_> {
        let facts = Arc::new(MotionFacts::default());
        Tracer::moving(
            self.prepared,
            self.field(method),
            WalkSettings::default(),
            &facts,
        )
    }

    /// What a probe finds. Numbers on a tape know what they depend on, and nothing is swept.
    fn probe(&self, method: Method) -> UncoveredEvents {
        let (wanted, tracer) = (self.wanted, self.tracer(method));
        let motion = ProbedMotion {
            shapes: &wanted.shapes,
            moves_curves: wanted.geometry(),
        };
        let Some(probe) = SpecularProbe::new(&tracer, &motion) else {
            return UncoveredEvents::default();
        };
        let field = self.field(method);
        let points = wanted.points(self.prepared.accel(), field.boundaries);
        let of = |count: u32, estimate: &(dyn Fn(&Reverse, u32) -> UncoveredEvents + Sync)| {
            let one = |tape: &mut Tape, number: u32| {
                let found = estimate(&Reverse::new(field, wanted, &points, tape), number);
                tape.clear();
                found
            };
            let all = (0..count).into_par_iter().map_init(Tape::default, one);
            all.reduce(UncoveredEvents::default, UncoveredEvents::and)
        };
        pool::install(|| {
            let found = of(probe.paths(), &|eval, path| probe.path(eval, path));
            match found.is_certain() {
                true => found,
                false => found.and(of(probe.searches(), &|eval, search| {
                    probe.search(eval, search)
                })),
            }
        })
    }
}

/// The method among those that one chooses from which leaves least out.
fn covering_most(method: Method) -> Method {
    match method {
        Method::Auto => Method::EDGES,
        method => method,
    }
}

/// True if something wanted moves what is seen, or turns specular directions.
fn may_turn_light(scene: &Scene, wanted: &Wanted) -> bool {
    let turns = |quantity: Quantity| {
        matches!(
            quantity,
            Quantity::RefractiveIndex { bends: true } | Quantity::Normal | Quantity::Height
        )
    };
    let by_texture = || {
        let mut shapes = scene
            .shapes
            .iter()
            .filter(|shape| bends_images(scene, shape));
        shapes.any(|shape| {
            let slots = scene.slots_below(shape.bsdf);
            slots.iter().any(|slot| {
                let numbers = scene.numbers_of(slot.texture, shape);
                turns(slot.quantity) && wanted.textures[numbers.0 as usize]
            })
        })
    };
    wanted.geometry() || wanted.normals.contains(&true) || by_texture()
}
