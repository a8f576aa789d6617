//! What is kept of the vertices of paths, for the derivatives of their light.

use capwalk_math::Rgb;
use capwalk_scene::EmitterId;
use capwalk_scene::lobe::Specular;

use crate::lanes::lit::{Lit, SeenEmitter};
use crate::lanes::scene::NOTHING;
use crate::lanes::step::{Brdf, Vertices};
use crate::lanes::vectors::{LANES, Numbers, Vectors};

/// A vertex of sixteen paths.
pub struct Step {
    /// One bit for each that has it.
    pub active: u32,
    pub faces: [u32; LANES],
    pub vertices: Vertices,
    /// What surfaces scatter over the density is in `scattered` of the vertices.
    pub drawn: Brdf,
    /// One bit for each from which a direction was drawn.
    pub is_drawn: u32,
    pub events: [Option<(Specular, f64)>; LANES],
    /// One bit for each whose surface has lobes.
    pub with_lobes: u32,
    pub throughput: Vectors,
    pub lit: Lit,
    /// One bit for each that an emitter lights, and what is scattered of that.
    pub is_lit: u32,
    pub lit_scattered: Vectors,
    /// One bit for each whose drawn direction leads to what emits, and that.
    is_met: u32,
    met: [(EmitterId, SeenEmitter); LANES],
    pub met_radiance: Vectors,
    pub met_weight: Numbers,
    pub survival: Numbers,
}

/// The vertices of sixteen paths, in memory that is used again: a vertex has thousands of numbers.
#[derive(Default)]
pub struct Steps {
    steps: Vec<Step>,
    count: usize,
}

impl Steps {
    /// Removes all.
    pub fn clear(&mut self) {
        self.count = 0;
    }

    /// Adds a vertex that paths reach, before anything is sampled there.
    pub fn push(
        &mut self,
        active: u32,
        faces: [u32; LANES],
        vertices: &Vertices,
        throughput: &Vectors,
        with_lobes: u32,
    ) {
        if self.count == self.steps.len() {
            self.steps.push(Step::default());
        }
        // What has no bit is not read.
        let step = &mut self.steps[self.count];
        (step.active, step.faces, step.with_lobes) = (active, faces, with_lobes);
        (step.vertices, step.throughput) = (*vertices, *throughput);
        (step.is_lit, step.is_drawn, step.is_met) = (0, 0, 0);
        step.survival = [1.0; LANES];
        self.count += 1;
    }

    /// The vertex that is sampled at.
    pub fn last(&mut self) -> Option<&mut Step> {
        self.steps[..self.count].last_mut()
    }

    /// All, in the order of the paths.
    pub fn all(&self) -> &[Step] {
        &self.steps[..self.count]
    }
}

impl Default for Step {
    fn default() -> Self {
        Self {
            active: 0,
            faces: [NOTHING; LANES],
            vertices: Vertices::NONE,
            drawn: Brdf::default(),
            is_drawn: 0,
            events: [None; LANES],
            with_lobes: 0,
            throughput: Vectors::ZERO,
            lit: Lit::default(),
            is_lit: 0,
            lit_scattered: Vectors::ZERO,
            is_met: 0,
            met: [(EmitterId(0), SeenEmitter::default()); LANES],
            met_radiance: Vectors::ZERO,
            met_weight: [0.0; LANES],
            survival: [1.0; LANES],
        }
    }
}

impl Step {
    /// Light towards which directions were drawn, and what of it is scattered.
    pub fn set_lit(&mut self, seen: u32, lit: &Lit, scattered: &Vectors) {
        self.lit = lit.clone();
        self.is_lit = seen;
        self.lit_scattered = *scattered;
    }

    /// What a drawn direction meets that emits.
    pub fn set_met(
        &mut self,
        lane: usize,
        met: (EmitterId, SeenEmitter),
        radiance: Rgb,
        weight: f64,
    ) {
        self.is_met |= 1 << lane;
        self.met[lane] = met;
        self.met_radiance.set_colour(lane, radiance);
        self.met_weight[lane] = weight;
    }

    /// What the drawn direction of a lane meets that emits.
    pub fn met(&self, lane: usize) -> Option<&(EmitterId, SeenEmitter)> {
        (self.is_met >> lane & 1 == 1).then(|| &self.met[lane])
    }

    /// Directions that were drawn.
    pub fn set_drawn(
        &mut self,
        is_drawn: u32,
        drawn: &Brdf,
        scattered: &Vectors,
        events: [Option<(Specular, f64)>; LANES],
    ) {
        self.is_drawn = is_drawn;
        self.drawn = *drawn;
        self.vertices.scattered = *scattered;
        self.events = events;
    }

    /// What the covector on the BSDF times the cosine, or on the reflectance of what is diffuse, has
    /// of the density of a drawn direction.
    pub fn over_density(&self, lane: usize) -> f64 {
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
