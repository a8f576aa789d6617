//! Surfaces of lanes that are not diffuse: their lobes are drawn from one by one, and evaluated one
//! by one but for what their facets do.

use capwalk_geometry::simd::Instructions;
use capwalk_math::{Frame, Rgb, Vec3};
use capwalk_scene::Resolved;
use capwalk_scene::lobe::{BsdfDirection, LocalBsdf, Microfacets, Specular};

use crate::lanes::facets::{LaneFacets, LaneMirrored, Mirror, Seen};
use crate::lanes::frames::{FindFrames, LaneFrames, ToLocal, ToWorld};
use crate::lanes::step::{Vertices, weight_beside_points, weight_over_density};
use crate::lanes::vectors::{LANES, Vectors, lanes_of, mask_of};

/// The lobes of one side of a surface, the same all over it.
pub struct Lobes {
    bsdf: LocalBsdf,
    /// 1 or -1 for the side of the normal that is their front.
    pub front: f64,
    /// True if it is worth sampling emitters.
    pub has_smooth: bool,
    /// True if light can come from both sides.
    pub transmits: bool,
    /// True if all of them are diffuse.
    pub is_diffuse: bool,
    /// What decides nearly all of them, if anything does.
    pub facets: Option<Microfacets>,
}

impl Lobes {
    /// Those of a material.
    pub fn new(material: Resolved<f64>) -> Self {
        let Resolved { bsdf, flipped } = material;
        Self {
            front: if flipped { -1.0 } else { 1.0 },
            has_smooth: bsdf.has_smooth(),
            transmits: bsdf.transmits(),
            is_diffuse: bsdf.is_diffuse(),
            facets: bsdf.facets(),
            bsdf,
        }
    }
}

/// Lobes of a face, which may turn with its texture coordinates.
#[derive(Clone, Copy)]
pub struct Turned<'a> {
    /// The lobes.
    pub lobes: &'a Lobes,
    /// Along the first texture coordinate.
    pub tangent: Option<Vec3>,
}

/// The lobes of those surfaces that are not diffuse, and light that they scatter.
pub struct LaneLobes<'a> {
    turned: [Option<Turned<'a>>; LANES],
    /// One bit for each that has lobes, and for each that has facets.
    pub with_lobes: u32,
    with_facets: u32,
    frames: LaneFrames,
    facets: LaneFacets,
    /// Unit directions of light in the frames, and what facets do to it.
    light: Vectors,
    mirrored: LaneMirrored,
    /// Perfectly specular events that send it there, and their probabilities.
    specular: [Option<(Specular, f64)>; LANES],
}

impl<'a> LaneLobes<'a> {
    /// None yet.
    pub fn new() -> Self {
        Self {
            turned: [None; LANES],
            with_lobes: 0,
            with_facets: 0,
            frames: LaneFrames::NONE,
            facets: LaneFacets::ANY,
            light: Vectors::ZERO,
            mirrored: LaneMirrored::default(),
            specular: [None; LANES],
        }
    }

    /// Sets those of a lane; `None` if its surface is diffuse.
    #[inline]
    pub fn set(&mut self, lane: usize, turned: Option<Turned<'a>>) {
        self.turned[lane] = turned;
        let facets = turned.and_then(|turned| turned.lobes.facets);
        let others = !(1 << lane);
        self.with_lobes = self.with_lobes & others | u32::from(turned.is_some()) << lane;
        self.with_facets = self.with_facets & others | u32::from(facets.is_some()) << lane;
    }

    /// Those of a lane.
    pub fn get(&self, lane: usize) -> Option<&'a Lobes> {
        self.turned[lane].map(|turned| turned.lobes)
    }

    /// One bit for each of some lanes that has any of which something holds.
    #[inline]
    pub fn which(&self, lanes: u32, holds: impl Fn(&Lobes) -> bool) -> u32 {
        let of_lane = |lane| self.get(lane).is_some_and(&holds);
        mask_of(self.with_lobes & lanes, of_lane)
    }

    /// Finds the frames of some lanes, and what is seen of their facets.
    pub fn face_viewers(&mut self, instructions: Instructions, vertices: &Vertices, lanes: u32) {
        let with_lobes = self.with_lobes & lanes;
        if with_lobes == 0 {
            return;
        }
        let frames = &mut self.frames;
        instructions.run(FindFrames { vertices, frames });
        for lane in lanes_of(with_lobes) {
            let Some(Turned { lobes, tangent }) = self.turned[lane] else {
                continue;
            };
            if let Some(tangent) = tangent {
                let outward = vertices.outward.get(lane);
                let frame = Frame::from_normal_and_tangent(outward, tangent);
                let direction = vertices.direction.get(lane);
                frames.set(lane, frame, vertices.side[lane], direction);
            }
            if let Some(own) = &lobes.facets {
                self.facets.set(lane, own);
            }
        }
        if self.with_facets & lanes != 0 {
            let facets = &mut self.facets;
            instructions.run(Seen { frames, facets });
        }
    }

    /// Sends light to some lanes, from unit directions of the world.
    pub fn light_from(&mut self, instructions: Instructions, world: &Vectors, lanes: u32) {
        if self.with_lobes & lanes != 0 {
            self.light = *world;
            instructions.run(ToLocal {
                frames: &self.frames,
                directions: &mut self.light,
            });
        }
        self.mirror(instructions, lanes);
    }

    /// Draws a direction from the lobes of a lane, which is to have some, and sends light from
    /// there; false if the path ends.
    pub fn draw(&mut self, lane: usize, choice: f64, u: [f64; 2]) -> bool {
        let drawn = self.get(lane).and_then(|lobes| {
            let wi = self.frames.wi.get(lane);
            match lobes.facets {
                None => lobes.bsdf.draw(wi, choice, u),
                Some(_) => {
                    let visible = self.facets.visible(lane);
                    let wo = lobes.bsdf.draw_visible(wi, visible, choice, u);
                    wo.map(|wo| BsdfDirection { wo, specular: None })
                }
            }
        });
        drawn.is_some_and(|BsdfDirection { wo, specular }| {
            self.light.set(lane, wo);
            self.specular[lane] = specular;
            true
        })
    }

    /// Where the light of some lanes comes from in the world, and what facets do to it.
    pub fn drawn(&mut self, instructions: Instructions, lanes: u32) -> Vectors {
        self.mirror(instructions, lanes);
        let mut directions = self.light;
        instructions.run(ToWorld {
            frames: &self.frames,
            directions: &mut directions,
        });
        directions
    }

    fn mirror(&mut self, instructions: Instructions, lanes: u32) {
        if self.with_facets & lanes != 0 {
            instructions.run(Mirror {
                frames: &self.frames,
                facets: &self.facets,
                directions: &self.light,
                mirrored: &mut self.mirrored,
            });
        }
    }

    /// What the lobes of a lane scatter of light that comes from a point on the emitter, which is
    /// seen under a solid angle, and its weight over its density. `has_other` if directions are
    /// drawn from the lobes, too.
    pub fn scattered(
        &self,
        lobes: &Lobes,
        lane: usize,
        solid_angle: f64,
        has_other: bool,
    ) -> (Rgb, f64) {
        let (scattered, pdf) = self.eval_and_pdf(lobes, lane);
        let other = if has_other { pdf } else { 0.0 };
        (scattered, weight_over_density(solid_angle, other))
    }

    /// What becomes of light from the direction drawn from the lobes of a lane; `None` if the path
    /// ends. What is scattered over the density, or the fraction of light over the probability of
    /// a specular event, and the weight of light from the emitter, if it is seen there.
    pub fn weighed(&self, lobes: &Lobes, lane: usize, solid_angle: f64) -> Option<(Rgb, f64)> {
        // Nothing else samples a specular direction.
        if let Some((event, probability)) = self.specular[lane] {
            let fraction = lobes.bsdf.specular(event, self.frames.wi.get(lane)).1;
            return Some((fraction / probability, 1.0));
        }
        let (scattered, pdf) = self.eval_and_pdf(lobes, lane);
        let weight = weight_beside_points(solid_angle, pdf);
        (pdf > 0.0).then(|| (scattered / pdf, weight))
    }

    fn eval_and_pdf(&self, lobes: &Lobes, lane: usize) -> (Rgb, f64) {
        let (wi, wo) = (self.frames.wi.get(lane), self.light.get(lane));
        match lobes.facets {
            Some(_) => lobes.bsdf.eval_and_pdf_of(wi, wo, self.mirrored.get(lane)),
            None => lobes.bsdf.eval_and_pdf(wi, wo),
        }
    }
}
