//! Surfaces of lanes that are not diffuse. Rough metal and rough plastic scatter light all lanes at a
//! time (`rough.rs`), other lobes one by one.

use capwalk_geometry::simd::Instructions;
use capwalk_math::{Frame, Vec3};
use capwalk_scene::Resolved;
use capwalk_scene::lobe::{BsdfDirection, LocalBsdf, RoughSurface, Specular};

use crate::lanes::frames::{FindFrames, LaneFrames, ToLocal, ToWorld};
use crate::lanes::lit::Lit;
use crate::lanes::rough::{
    DrawFacets, LaneRough, LaneScattered, Scatter, Seen, WeighDrawn, WeighPoints,
};
use crate::lanes::step::{Brdf, Vertices, weight_over_density};
use crate::lanes::vectors::{LANES, Numbers, Vectors, lanes_of, mask_of};
use crate::receiver::Receiver;

/// The lobes of one side of a surface, the same all over it or at a point.
#[derive(Default)]
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
    /// All of them, if they are those of rough metal or rough plastic.
    pub rough: Option<RoughSurface>,
}

impl Lobes {
    /// The lobes of a material.
    pub fn new(material: Resolved<f64>) -> Self {
        let mut lobes = Self {
            bsdf: material.bsdf,
            ..Self::default()
        };
        lobes.describe(material.flipped);
        lobes
    }

    /// Finds what is known of them.
    fn describe(&mut self, flipped: bool) {
        let bsdf = &self.bsdf;
        self.front = if flipped { -1.0 } else { 1.0 };
        self.has_smooth = bsdf.has_smooth();
        self.transmits = bsdf.transmits();
        self.is_diffuse = bsdf.is_diffuse();
        self.rough = bsdf.rough_surface();
    }
}

/// The lobes of surfaces, by lanes.
struct LaneSurfaces<'a> {
    /// Those that are the same all over a shape.
    constant: [Option<&'a Lobes>; LANES],
    /// Those found at points, in the lanes that have their bit.
    own: [Option<Box<Lobes>>; LANES],
    own_lanes: u32,
}

impl LaneSurfaces<'_> {
    fn get(&self, lane: usize) -> Option<&Lobes> {
        match self.own_lanes >> lane & 1 {
            1 => self.own[lane].as_deref(),
            _ => self.constant[lane],
        }
    }
}

/// The lobes of those surfaces that are not diffuse, and light that they scatter.
pub struct LaneLobes<'a> {
    surfaces: LaneSurfaces<'a>,
    /// Along the first texture coordinate, if frames turn with it.
    tangents: [Option<Vec3>; LANES],
    /// One bit for each that has lobes, and for each that is rough metal or plastic.
    pub with_lobes: u32,
    rough_lanes: u32,
    frames: LaneFrames,
    rough: LaneRough<'a>,
    /// Unit directions of light in the frames.
    light: Vectors,
    /// What rough surfaces scatter of it.
    scattered: LaneScattered,
    /// Perfectly specular events that send it there, and their probabilities.
    specular: [Option<(Specular, f64)>; LANES],
}

impl<'a> LaneLobes<'a> {
    /// None yet.
    pub fn new() -> Self {
        Self {
            surfaces: LaneSurfaces {
                constant: [None; LANES],
                own: [const { None }; LANES],
                own_lanes: 0,
            },
            tangents: [None; LANES],
            with_lobes: 0,
            rough_lanes: 0,
            frames: LaneFrames::NONE,
            rough: LaneRough::NONE,
            light: Vectors::ZERO,
            scattered: LaneScattered::NONE,
            specular: [None; LANES],
        }
    }

    /// Removes those of some lanes: their surfaces are diffuse, or black.
    #[inline]
    pub fn clear(&mut self, lanes: u32) {
        self.with_lobes &= !lanes;
        self.rough_lanes &= !lanes;
    }

    /// Sets those of a lane that had none, the same all over its shape; the tangent is along the
    /// first texture coordinate, if the material turns with it.
    #[inline]
    pub fn set(&mut self, lane: usize, lobes: &'a Lobes, tangent: Option<Vec3>) {
        self.surfaces.constant[lane] = Some(lobes);
        self.surfaces.own_lanes &= !(1 << lane);
        self.tangents[lane] = tangent;
        self.with_lobes |= 1 << lane;
        if let Some(rough) = &lobes.rough {
            self.rough_lanes |= 1 << lane;
            self.rough.set(lane, rough);
        }
    }

    /// [`Self::set`] for those at a point: `find` adds them to none, and says whether the normal is
    /// to be turned over, if there are any. Gives the side of it that is their front.
    pub fn set_own(
        &mut self,
        lane: usize,
        tangent: Option<Vec3>,
        find: impl FnOnce(&mut LocalBsdf) -> Option<bool>,
    ) -> Option<f64> {
        let lobes = self.surfaces.own[lane].get_or_insert_default();
        lobes.bsdf.clear();
        let flipped = find(&mut lobes.bsdf)?;
        lobes.describe(flipped);
        if let Some(rough) = lobes.rough.take() {
            self.rough_lanes |= 1 << lane;
            self.rough.set_own(lane, rough);
        }
        self.surfaces.own_lanes |= 1 << lane;
        self.tangents[lane] = tangent;
        self.with_lobes |= 1 << lane;
        Some(lobes.front)
    }

    /// One bit for each of some lanes that has any of which something holds.
    #[inline]
    pub fn which(&self, lanes: u32, holds: impl Fn(&Lobes) -> bool) -> u32 {
        let of_lane = |lane| self.surfaces.get(lane).is_some_and(&holds);
        mask_of(self.with_lobes & lanes, of_lane)
    }

    /// Specular events that were drawn, and their probabilities.
    pub fn events(&self) -> [Option<(Specular, f64)>; LANES] {
        std::array::from_fn(|lane| self.event(lane))
    }

    /// The specular event that was drawn in a lane, and its probability.
    pub fn event(&self, lane: usize) -> Option<(Specular, f64)> {
        match self.with_lobes >> lane & !self.rough_lanes >> lane & 1 {
            1 => self.specular[lane],
            _ => None,
        }
    }

    /// What of a surface, whose frame is known, matters to directions towards emitters.
    #[inline]
    pub fn receiver(&self, vertices: &Vertices, lane: usize) -> Receiver {
        let with_lobes = self.with_lobes >> lane & 1 == 1;
        let lobes = with_lobes.then(|| self.surfaces.get(lane)).flatten();
        Receiver {
            position: vertices.position.get(lane),
            frame: match with_lobes {
                true => self.frames.get(lane),
                false => vertices.frame(lane),
            },
            transmits: lobes.is_some_and(|lobes| lobes.transmits),
        }
    }

    /// Finds the frames of some lanes, and what the viewers see of rough surfaces.
    pub fn face_viewers(&mut self, instructions: Instructions, vertices: &Vertices, lanes: u32) {
        let with_lobes = self.with_lobes & lanes;
        if with_lobes == 0 {
            return;
        }
        let frames = &mut self.frames;
        instructions.run(FindFrames { vertices, frames });
        for lane in lanes_of(with_lobes) {
            if let Some(tangent) = self.tangents[lane] {
                let outward = vertices.outward.get(lane);
                let frame = Frame::from_normal_and_tangent(outward, tangent);
                let direction = vertices.direction.get(lane);
                frames.set(lane, frame, vertices.side[lane], direction);
            }
        }
        let lanes = self.rough_lanes & lanes;
        if lanes != 0 {
            instructions.run(Seen {
                frames,
                rough: &mut self.rough,
                lanes,
            });
        }
    }

    /// Sets `vertices.scattered` of some lanes, the first, to what their lobes scatter of light that
    /// comes from directions drawn towards emitters, and `lit.weight` to its weight over its density;
    /// the second are those where so many directions are drawn from the surface, too.
    pub fn weigh_points(
        &mut self,
        instructions: Instructions,
        vertices: &mut Vertices,
        lit: &mut Lit,
        bsdf_samples: f64,
        [lanes, of_brdf]: [u32; 2],
    ) {
        let lanes = lanes & self.with_lobes;
        if lanes == 0 {
            return;
        }
        self.light = lit.direction;
        instructions.run(ToLocal {
            frames: &self.frames,
            directions: &mut self.light,
        });
        let rough = self.scatter(instructions, lanes);
        if rough != 0 {
            instructions.run(WeighPoints {
                scattered: &self.scattered,
                inverse_density: &lit.inverse_density,
                lanes: rough,
                bsdf_samples,
                of_brdf,
                colours: &mut vertices.scattered,
                weights: &mut lit.weight,
            });
        }
        for lane in lanes_of(lanes & !self.rough_lanes) {
            let Some(lobes) = self.surfaces.get(lane) else {
                continue;
            };
            let (wi, wo) = (self.frames.wi.get(lane), self.light.get(lane));
            let (colour, pdf) = lobes.bsdf.eval_and_pdf(wi, wo);
            let has_other = of_brdf >> lane & 1 == 1;
            let other = if has_other { bsdf_samples * pdf } else { 0.0 };
            vertices.scattered.set_colour(lane, colour);
            lit.weight[lane] = weight_over_density(lit.inverse_density[lane], other);
        }
    }

    /// Draws directions from the lobes of some lanes, which are to have some, and sends light from
    /// there; one bit for each where the path goes on. `cosine` are directions drawn by the cosine
    /// from the same numbers.
    pub fn draw(
        &mut self,
        instructions: Instructions,
        lanes: u32,
        choice: &Numbers,
        u: &[Numbers; 2],
        cosine: &Vectors,
    ) -> u32 {
        self.light = *cosine;
        let mut rough = lanes & self.rough_lanes;
        if rough != 0 {
            rough = instructions.run(DrawFacets {
                frames: &self.frames,
                rough: &self.rough,
                choice,
                u,
                lanes: rough,
                directions: &mut self.light,
            });
        }
        let others = mask_of(lanes & !self.rough_lanes, |lane| {
            let (wi, u) = (self.frames.wi.get(lane), [u[0][lane], u[1][lane]]);
            let lobes = self.surfaces.get(lane);
            let drawn = lobes.and_then(|lobes| lobes.bsdf.draw(wi, choice[lane], u));
            drawn.is_some_and(|BsdfDirection { wo, specular }| {
                self.light.set(lane, wo);
                self.specular[lane] = specular;
                true
            })
        });
        rough | others
    }

    /// Weighs light from the directions drawn from the lobes of some lanes; one bit for each where the
    /// path goes on. Sets `drawn.direction` to where it comes from in the world, `vertices.scattered`
    /// to what is scattered over the density `drawn.pdf`, or to the fraction of light over the
    /// probability of a specular event, which gets its bit in `drawn.specular`.
    pub fn weigh_drawn(
        &mut self,
        instructions: Instructions,
        vertices: &mut Vertices,
        drawn: &mut Brdf,
        lanes: u32,
    ) -> u32 {
        if lanes == 0 {
            return 0;
        }
        let mut rough = self.scatter(instructions, lanes);
        if rough != 0 {
            rough = instructions.run(WeighDrawn {
                scattered: &self.scattered,
                lanes: rough,
                colours: &mut vertices.scattered,
                pdf: &mut drawn.pdf,
            });
        }
        let others = mask_of(lanes & !self.rough_lanes, |lane| {
            let Some(lobes) = self.surfaces.get(lane) else {
                return false;
            };
            let wi = self.frames.wi.get(lane);
            if let Some((event, probability)) = self.specular[lane] {
                let fraction = lobes.bsdf.specular(event, wi).1;
                vertices.scattered.set_colour(lane, fraction / probability);
                drawn.specular |= 1 << lane;
                return true;
            }
            let (scattered, pdf) = lobes.bsdf.eval_and_pdf(wi, self.light.get(lane));
            vertices.scattered.set_colour(lane, scattered / pdf);
            drawn.pdf[lane] = pdf;
            pdf > 0.0
        });
        instructions.run(ToWorld {
            frames: &self.frames,
            directions: &self.light,
            lanes: rough | others,
            world: &mut drawn.direction,
        });
        rough | others
    }

    /// Scatters light at the rough ones among some lanes; one bit for each.
    fn scatter(&mut self, instructions: Instructions, lanes: u32) -> u32 {
        let lanes = lanes & self.rough_lanes;
        if lanes != 0 {
            instructions.run(Scatter {
                frames: &self.frames,
                rough: &self.rough,
                directions: &self.light,
                lanes,
                scattered: &mut self.scattered,
            });
        }
        lanes
    }
}
