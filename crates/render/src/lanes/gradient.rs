//! How the light of paths depends on colours, roughness, and other numbers of materials and emitters,
//! which move no ray: path replay (Vicini et al. 2021) without the replay, because what it would find
//! again is kept of each vertex.
//!
//! With the throughput `T` that a path has when it reaches a vertex, the pixel's covector `A` and what
//! arrives there by a direction, `L`, the light of the path is `T f L` and its covector on `f` is
//! `A T L`. What arrives by the direction in which the path goes on is known when the vertices behind
//! are: they are visited last first. Densities, weights and roulette are detached.

use capwalk_math::{Rgb, Vec3};
use capwalk_scene::EmitterId;

use crate::lanes::kept::Step;
use crate::lanes::vectors::LANES;
use crate::lanes::{LaneTracer, Paths};
use crate::path_adjoint::{Arriving, PathAdjoint};
use crate::tiles::{Sample, SamplePlace};

impl LaneTracer<'_> {
    /// Appends the samples of some places, and calls `depends` with all numbers on which their light
    /// depends and that are asked for, for each with the number of the sample. `covectors` are those
    /// on the samples' light.
    pub fn differentiate(
        &self,
        places: &[SamplePlace],
        covectors: &[Rgb],
        taken: &mut Vec<Sample<3>>,
        mut depends: impl FnMut(usize, PathAdjoint),
    ) {
        let Some(first) = places.first() else {
            return;
        };
        let mut paths = Paths::new(first.stream);
        paths.steps = Some(Vec::new());
        let chunks = places.chunks(LANES).zip(covectors.chunks(LANES));
        for (chunk, (places, covectors)) in chunks.enumerate() {
            let weights = self.take_some(places, &mut paths, taken);
            for (lane, (&covector, weight)) in covectors.iter().zip(weights).enumerate() {
                let depends = &mut |adjoint| depends(chunk * LANES + lane, adjoint);
                self.pull(&paths, lane, covector * weight, depends);
            }
        }
    }

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
        let steps = paths.steps.iter().flatten().rev();
        for step in steps.filter(|step| step.active >> lane & 1 == 1) {
            behind = self.pull_step(step, lane, covector, behind, depends);
        }
        // What the camera sees of emitters.
        if let Some((emitter, face, ray)) = paths.seen[lane] {
            self.pull_emitted(emitter, face, ray, covector, depends);
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
                let ray = [position, direction];
                let hit = self.lights.hit(vertices, lit, lane);
                depends(PathAdjoint::Emitted {
                    emitter,
                    hit,
                    ray,
                    covector: on_light * scattered,
                });
            }
        }
        // Light by the direction in which the path goes on.
        if step.is_drawn >> lane & 1 == 1 {
            let direction = step.drawn.direction.get(lane);
            let factor = vertices.scattered.colour(lane);
            let mut arriving = behind * (1.0 / step.survival[lane]);
            if let Some(emitter) = step.met[lane] {
                let weight = step.met_weight[lane];
                arriving += step.met_radiance.colour(lane) * weight;
                let (ray, face) = ([position, direction], step.met_faces[lane]);
                let covector = on_light * factor * weight;
                self.pull_emitted(emitter, face, ray, covector, depends);
            }
            sent += factor * arriving;
            arrives[1] = Some(Arriving {
                direction,
                specular: step.events[lane].map(|(event, _)| event),
                covector: on_light * arriving * step.over_density(lane),
            });
        }
        let face = step.faces[lane];
        if self.scene.is_asked_for(face) {
            let covectors = arrives.iter().flatten().map(|light| light.covector);
            let sum = covectors.fold(Rgb::zero(), |sum, covector| sum + covector);
            depends(match self.scene.reflectance(face, lane, vertices) {
                Some((texture, point)) => PathAdjoint::Reflectance {
                    texture,
                    point,
                    covector: sum,
                },
                None => PathAdjoint::Scattered {
                    hit: self.scene.hit_of(face, lane, vertices),
                    ray: [vertices.origin.get(lane), vertices.direction.get(lane)],
                    arrives,
                },
            });
        }
        sent
    }

    fn pull_emitted(
        &self,
        emitter: EmitterId,
        face: u32,
        ray: [Vec3; 2],
        covector: Rgb,
        depends: &mut impl FnMut(PathAdjoint),
    ) {
        if self.lights.is_asked_for(emitter) {
            depends(PathAdjoint::Emitted {
                emitter,
                hit: self.scene.hit(face, ray[0], ray[1]),
                ray,
                covector,
            });
        }
    }
}
