//! Which paths are sampled, and which random numbers they take.

use capwalk_boundary::MAX_EVENTS;
use capwalk_scene::{Aov, Integrator, Scene};

/// The first vertex's numbers start here, if the camera has no lens.
pub const FIRST_VERTEX: u32 = 3;
/// Where on the lens.
pub const LENS: u32 = FIRST_VERTEX;
/// How many numbers that takes.
const LENS_NUMBERS: u32 = 2;
/// With no largest depth, the numbers of walks start here.
const BEHIND_ALL_VERTICES: u32 = 1 << 20;

/// How many samples of each technique a shading point takes.
#[derive(Clone, Copy, Debug)]
pub struct LightSampling {
    /// Points sampled on emitters.
    pub emitter_samples: u32,
    /// Directions sampled from the material.
    pub bsdf_samples: u32,
    /// True if all emitters are chosen alike, not by how much they seem to light the point.
    pub alike: bool,
}

/// Random numbers that a point on an emitter takes.
pub const EMITTER_NUMBERS: u32 = 3;
/// Random numbers of each material sample.
pub const BSDF_NUMBERS: u32 = 3;

impl LightSampling {
    /// Random numbers that light at a vertex takes.
    pub fn dimensions(&self) -> u32 {
        self.emitter_samples * EMITTER_NUMBERS + self.bsdf_samples * BSDF_NUMBERS
    }
}

/// Which paths are sampled, and how.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// Where the random numbers of the first vertex start.
    pub first_vertex: u32,
    /// Most segments of a path.
    pub max_depth: Option<u32>,
    /// Paths of more segments than this are subject to roulette.
    pub rr_depth: u32,
    /// How light from emitters is sampled at each vertex.
    pub sampling: LightSampling,
    /// Emitters are not seen by the camera.
    pub hide_emitters: bool,
    /// The AOV to render instead of light.
    pub aov: Option<Aov>,
}

impl Plan {
    /// The plan of a scene's integrator.
    pub fn new(scene: &Scene) -> Self {
        let first_vertex = match scene.sensor.model.has_lens() {
            true => FIRST_VERTEX + LENS_NUMBERS,
            false => FIRST_VERTEX,
        };
        match scene.settings.integrator {
            Integrator::Direct {
                emitter_samples,
                bsdf_samples,
                hide_emitters,
            } => Self {
                first_vertex,
                max_depth: Some(2),
                rr_depth: u32::MAX,
                sampling: LightSampling {
                    emitter_samples,
                    bsdf_samples,
                    alike: false,
                },
                hide_emitters,
                aov: None,
            },
            Integrator::Path {
                max_depth,
                rr_depth,
                hide_emitters,
            } => Self {
                first_vertex,
                max_depth,
                rr_depth,
                sampling: LightSampling {
                    emitter_samples: 1,
                    bsdf_samples: 1,
                    alike: false,
                },
                hide_emitters,
                aov: None,
            },
            Integrator::Aov(aov) => Self {
                first_vertex,
                max_depth: Some(1),
                rr_depth: u32::MAX,
                sampling: LightSampling {
                    emitter_samples: 0,
                    bsdf_samples: 0,
                    alike: false,
                },
                hide_emitters: false,
                aov: Some(aov),
            },
        }
    }

    /// This plan for finite differences: to them a choice that changes with the scene is noise.
    #[must_use]
    pub fn for_differences(mut self) -> Self {
        self.sampling.alike = true;
        self
    }

    /// True if paths of this many segments are sampled.
    pub fn reaches(&self, segments: u32) -> bool {
        self.max_depth.is_none_or(|max| segments <= max)
    }

    /// True if light that reaches surfaces is sampled.
    pub fn lights_surfaces(&self) -> bool {
        self.reaches(2) && self.sampling.dimensions() > 0
    }

    /// Most specular events between a point that paths of so many segments lead
    /// to and what they show of the scene.
    pub fn events_behind(&self, segments: u32) -> u32 {
        let left = self.max_depth.map(|max| max.saturating_sub(segments + 1));
        left.map_or(MAX_EVENTS, |left| left.min(MAX_EVENTS))
    }

    /// Random numbers of each vertex: light and continuation, roulette.
    fn numbers_per_vertex(&self) -> u32 {
        self.sampling.dimensions() + 1
    }

    /// Where the random numbers of a vertex start.
    pub fn vertex_numbers(&self, depth: u32) -> u32 {
        let first = self.first_vertex;
        first.saturating_add(depth.saturating_mul(self.numbers_per_vertex()))
    }

    /// Where those of walks start.
    pub fn first_walk(&self) -> u32 {
        match self.max_depth {
            None => BEHIND_ALL_VERTICES,
            Some(max) => self
                .vertex_numbers(max.saturating_sub(1))
                .min(BEHIND_ALL_VERTICES),
        }
    }
}
