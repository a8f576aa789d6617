//! How the light of paths depends on colours, roughness, and other numbers of materials and emitters,
//! which move no ray: path replay (Vicini et al. 2021) without the replay, because what it would find
//! again is kept of each vertex.
//!
//! With the throughput `T` that a path has when it reaches a vertex, the pixel's covector `A` and what
//! arrives there by a direction, `L`, the light of the path is `T f L` and its covector on `f` is
//! `A T L`. What arrives by the direction in which the path goes on is known when the vertices behind
//! are: they are visited last first. Densities, weights and roulette are detached.

use capwalk_math::Rgb;

use crate::lanes::kept::{Step, Steps};
use crate::lanes::rest_of_runs::RestOfRuns;
use crate::lanes::scattered::{Arriving, Place};
use crate::lanes::vectors::LANES;
use crate::lanes::{LaneTracer, Paths};
use crate::path_adjoint::PathAdjoint;
use crate::tiles::{Sample, SampleRun, count_samples};

/// Takes samples of some runs after others, and differentiates their light.
pub struct Differentiator<'a> {
    tracer: &'a LaneTracer<'a>,
    /// In memory that is used again.
    paths: Option<Paths<'a>>,
}

impl<'a> Differentiator<'a> {
    /// Differentiates the samples of a tracer that was made for it.
    pub fn new(tracer: &'a LaneTracer<'a>) -> Self {
        let paths = None;
        Self { tracer, paths }
    }

    /// Appends the samples of some runs, and calls `depends` with all numbers on which their light
    /// depends and that are asked for, for each with the number of the sample. `covectors` are those
    /// on the samples' light.
    pub fn take(
        &mut self,
        runs: &[SampleRun],
        covectors: &[Rgb],
        taken: &mut Vec<Sample<3>>,
        mut depends: impl FnMut(usize, PathAdjoint),
    ) {
        let Some(first) = runs.first() else {
            return;
        };
        let tracer = self.tracer;
        let paths = self.paths.get_or_insert_with(|| Paths {
            steps: Some(Steps::default()),
            ..Paths::new(first, &tracer.lights)
        });
        debug_assert_eq!(covectors.len(), count_samples(runs));
        let mut rest = RestOfRuns::new(runs);
        for (chunk, covectors) in covectors.chunks(LANES).enumerate() {
            let weights = tracer.take_some(&mut rest, paths, taken);
            for (lane, (&covector, weight)) in covectors.iter().zip(weights).enumerate() {
                let depends = &mut |adjoint| depends(chunk * LANES + lane, adjoint);
                tracer.pull(paths, lane, covector * weight, depends);
            }
        }
    }
}

impl LaneTracer<'_> {
    /// Through the vertices of a path, last first.
    fn pull(
        &self,
        paths: &Paths<'_>,
        lane: usize,
        covector: Rgb,
        depends: &mut impl FnMut(PathAdjoint),
    ) {
        // What the vertex behind sends back.
        let mut behind = Rgb::zero();
        let steps = paths.steps.iter().flat_map(Steps::all).rev();
        for step in steps.filter(|step| step.active >> lane & 1 == 1) {
            behind = self.pull_step(step, lane, covector, behind, depends);
        }
        // What the camera sees of emitters.
        if let Some((emitter, seen)) = &paths.seen[lane] {
            self.lights
                .pull(*emitter, seen, None, covector, &self.scene, depends);
        }
    }

    /// At a vertex; gives what it sends back.
    fn pull_step(
        &self,
        step: &Step,
        lane: usize,
        covector: Rgb,
        behind: Rgb,
        depends: &mut impl FnMut(PathAdjoint),
    ) -> Rgb {
        let (vertices, lit) = (&step.vertices, &step.lit);
        let on_light = covector * step.throughput.colour(lane);
        let position = vertices.position.get(lane);
        let mut sent = Rgb::zero();
        let mut arrives = [None; 2];
        // Light from an emitter towards which a direction was drawn.
        if step.is_lit >> lane & 1 == 1 {
            let (radiance, direction) = (lit.radiance.colour(lane), lit.direction.get(lane));
            let scattered = step.lit_scattered.colour(lane) * lit.weight[lane];
            sent += scattered * radiance;
            arrives[0] = Some(Arriving {
                direction,
                specular: None,
                covector: on_light * radiance * lit.weight[lane],
            });
            let emitter = lit.emitters[lane];
            if self.lights.is_asked_for(emitter) {
                let seen = self.lights.seen(vertices, lit, lane);
                let covector = on_light * scattered;
                self.lights.pull(
                    emitter,
                    &seen,
                    Some(position),
                    covector,
                    &self.scene,
                    depends,
                );
            }
        }
        // Light by the direction in which the path goes on.
        if step.is_drawn >> lane & 1 == 1 {
            let direction = step.drawn.direction.get(lane);
            let factor = vertices.scattered.colour(lane);
            let mut arriving = behind * (1.0 / step.survival[lane]);
            if let Some((emitter, seen)) = step.met(lane) {
                let weight = step.met_weight[lane];
                arriving += step.met_radiance.colour(lane) * weight;
                let covector = on_light * factor * weight;
                self.lights
                    .pull(*emitter, seen, None, covector, &self.scene, depends);
            }
            sent += factor * arriving;
            let covector = on_light * arriving * step.over_density(lane);
            arrives[1] = (covector != Rgb::zero()).then(|| Arriving {
                direction,
                specular: step.events[lane].map(|(event, _)| event),
                covector,
            });
        }
        let face = step.faces[lane];
        let is_lit = arrives.iter().any(Option::is_some);
        if is_lit && self.scene.is_asked_for(face) {
            let at = Place {
                face,
                lane,
                vertices,
            };
            self.scene.pull(at, &arrives, depends);
        }
        sent
    }
}
