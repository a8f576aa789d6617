//! How the light of paths depends on colours, roughness, and other numbers of materials and emitters,
//! which move no ray: path replay (Vicini et al. 2021) without the replay, because what it would find
//! again is kept of each vertex.
//!
//! With the throughput `T` that a path has when it reaches a vertex, the pixel's covector `A` and what
//! arrives there by a direction, `L`, the light of the path is `T f L` and its covector on `f` is
//! `A T L`. What arrives by the direction in which the path goes on is known when the vertices behind
//! are: they are visited last first. Densities, weights and roulette are detached.

use capwalk_geometry::Hit;
use capwalk_math::{Rgb, Vec3};
use capwalk_scene::lobe::Specular;
use capwalk_scene::{EmitterId, SurfacePoint, TextureId};

use crate::lanes::lights::Lit;
use crate::lanes::step::{Brdf, Vertices};
use crate::lanes::vectors::{LANES, Numbers, Vectors};
use crate::lanes::{LaneTracer, Paths};
use crate::tiles::{Sample, SamplePlace};

/// Numbers of the scene on which the light of a sample depends, with its covector on what is made of
/// them.
#[derive(Clone, Copy, Debug)]
pub enum Dependence {
    /// What an emitter sends back along a ray.
    Emitted {
        /// The emitter.
        emitter: EmitterId,
        /// The point of it, if it is on a surface.
        hit: Option<Hit>,
        /// Origin and direction of the ray.
        ray: [Vec3; 2],
        /// On the radiance, or on the irradiance of an emitter without extent.
        covector: Rgb,
    },
    /// What a diffuse surface reflects.
    Reflectance {
        /// The texture of it.
        texture: TextureId,
        /// Where.
        point: SurfacePoint<f64>,
        /// On its value.
        covector: Rgb,
    },
    /// What another surface scatters.
    Scattered {
        /// Where.
        hit: Hit,
        /// Origin and direction of the ray that hits it.
        ray: [Vec3; 2],
        /// Light towards which it was sampled, and along which the path goes on.
        arrives: [Option<Arriving>; 2],
    },
}

/// Light that arrives at a surface.
#[derive(Clone, Copy, Debug)]
pub struct Arriving {
    /// The unit direction that it comes from.
    pub direction: Vec3,
    /// The specular event by which it is seen.
    pub specular: Option<Specular>,
    /// On the BSDF times the cosine, or on the fraction of light of the event.
    pub covector: Rgb,
}

/// A vertex of sixteen paths.
pub struct Step {
    /// One bit for each that has it.
    active: u32,
    faces: [u32; LANES],
    vertices: Vertices,
    /// What surfaces scatter over the density is in `scattered` of the vertices.
    drawn: Brdf,
    /// One bit for each from which a direction was drawn.
    is_drawn: u32,
    events: [Option<(Specular, f64)>; LANES],
    /// One bit for each whose surface has lobes.
    with_lobes: u32,
    throughput: Vectors,
    lit: Lit,
    /// One bit for each that an emitter lights, and what is scattered of that.
    is_lit: u32,
    lit_scattered: Vectors,
    /// What the drawn directions lead to.
    met_faces: [u32; LANES],
    met: [Option<EmitterId>; LANES],
    met_radiance: Vectors,
    met_weight: Numbers,
    survival: Numbers,
}

impl Step {
    /// A vertex that paths reach, before anything is sampled there.
    pub fn new(active: u32, paths: &Paths<'_>) -> Self {
        Self {
            active,
            faces: paths.faces,
            vertices: paths.vertices,
            drawn: paths.drawn,
            is_drawn: 0,
            events: [None; LANES],
            with_lobes: paths.lobes.with_lobes,
            throughput: paths.throughput,
            lit: Lit::default(),
            is_lit: 0,
            lit_scattered: Vectors::ZERO,
            met_faces: paths.faces,
            met: [None; LANES],
            met_radiance: Vectors::ZERO,
            met_weight: [0.0; LANES],
            survival: [1.0; LANES],
        }
    }

    /// Light towards which directions were drawn, and what of it is scattered.
    pub fn set_lit(&mut self, seen: u32, lit: &Lit, scattered: &Vectors) {
        self.lit = lit.clone();
        self.is_lit = seen;
        self.lit_scattered = *scattered;
    }

    /// What a drawn direction meets that emits.
    pub fn set_met(&mut self, lane: usize, emitter: EmitterId, radiance: Rgb, weight: f64) {
        self.met[lane] = Some(emitter);
        self.met_radiance.set_colour(lane, radiance);
        self.met_weight[lane] = weight;
    }

    /// Directions that were drawn, and what they meet.
    pub fn set_drawn(&mut self, drawn: u32, paths: &Paths<'_>) {
        self.is_drawn = drawn;
        self.drawn = paths.drawn;
        self.vertices.scattered = paths.vertices.scattered;
        self.met_faces = paths.faces;
        self.events = paths.lobes.events();
    }

    /// What the covector on the BSDF times the cosine, or on the reflectance of what is diffuse, has
    /// of the density of a drawn direction.
    fn over_density(&self, lane: usize) -> f64 {
        match (self.with_lobes >> lane & 1, self.events[lane]) {
            (0, _) => 1.0,
            (_, Some((_, probability))) => 1.0 / probability,
            (_, None) => 1.0 / self.drawn.pdf[lane],
        }
    }

    /// With which probability a path survives roulette.
    pub fn set_survival(&mut self, lane: usize, survival: f64) {
        self.survival[lane] = survival;
    }
}

impl LaneTracer<'_> {
    /// Appends the samples of some places, and calls `depends` with all numbers on which their light
    /// depends and that are asked for, for each with the number of the sample. `covectors` are those
    /// on the samples' light.
    pub fn differentiate(
        &self,
        places: &[SamplePlace],
        covectors: &[Rgb],
        taken: &mut Vec<Sample<3>>,
        mut depends: impl FnMut(usize, Dependence),
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
                let depends = &mut |dependence| depends(chunk * LANES + lane, dependence);
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
        depends: &mut impl FnMut(Dependence),
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
        depends: &mut impl FnMut(Dependence),
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
            let emitter = lit.emitter(lane);
            if self.lights.is_asked_for(emitter) {
                let ray = [position, direction];
                let hit = self.lights.hit(vertices, lit, lane);
                depends(Dependence::Emitted {
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
                Some((texture, point)) => Dependence::Reflectance {
                    texture,
                    point,
                    covector: sum,
                },
                None => Dependence::Scattered {
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
        depends: &mut impl FnMut(Dependence),
    ) {
        if self.lights.is_asked_for(emitter) {
            depends(Dependence::Emitted {
                emitter,
                hit: self.scene.hit(face, ray[0], ray[1]),
                ray,
                covector,
            });
        }
    }
}
