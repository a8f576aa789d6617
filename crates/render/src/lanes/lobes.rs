//! Surfaces of lanes that are not diffuse: their lobes are evaluated one by one.

use capwalk_math::{Frame, Rgb, Vec3};
use capwalk_scene::Resolved;
use capwalk_scene::lobe::{BsdfDirection, LocalBsdf};

use crate::lanes::step::{Vertices, density};
use crate::light::power_heuristic;

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

impl<'a> Turned<'a> {
    /// The same where the path of a lane hits the face.
    pub fn at(&self, vertices: &Vertices, lane: usize) -> LobesAt<'a> {
        let outward = vertices.outward.get(lane);
        let mut frame = match self.tangent {
            Some(tangent) => Frame::from_normal_and_tangent(outward, tangent),
            None => Frame::from_normal(outward),
        };
        frame.n = frame.n * vertices.side[lane];
        LobesAt {
            bsdf: &self.lobes.bsdf,
            wi: frame.to_local(-vertices.direction.get(lane)),
            frame,
            solid_angle: vertices.solid_angle[lane],
        }
    }
}

/// Lobes where a path hits a surface.
pub struct LobesAt<'a> {
    bsdf: &'a LocalBsdf,
    frame: Frame,
    /// Unit direction to the viewer, in that frame.
    wi: Vec3,
    /// The solid angle under which the emitter is seen.
    solid_angle: f64,
}

/// A direction drawn from lobes.
pub struct Drawn {
    /// The direction.
    pub direction: Vec3,
    /// What is scattered over the density, or the fraction of light over the probability of a
    /// specular event.
    pub factor: Rgb,
    /// The weight of light from the emitter, if it is seen there.
    pub weight: f64,
}

impl LobesAt<'_> {
    /// What is scattered of light from a point on the emitter, times its weight over its density.
    /// `has_other` if directions are drawn from the lobes, too.
    pub fn scattered(&self, direction: Vec3, has_other: bool) -> Rgb {
        let wo = self.frame.to_local(direction);
        let own = density(self.solid_angle);
        let (scattered, other) = match has_other {
            true => self.bsdf.eval_and_pdf(self.wi, wo),
            false => (self.bsdf.eval(self.wi, wo), 0.0),
        };
        scattered * (power_heuristic(own, other) / own)
    }

    /// Draws a direction; `None` if the path ends.
    pub fn draw(&self, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        let BsdfDirection { wo, specular } = self.bsdf.draw(self.wi, choice, u)?;
        let (scattered, pdf, weight) = match specular {
            // Nothing else samples a specular direction.
            Some((event, probability)) => {
                let fraction = self.bsdf.specular(event, self.wi).1;
                (fraction, probability, 1.0)
            }
            None => {
                let (scattered, pdf) = self.bsdf.eval_and_pdf(self.wi, wo);
                let other = density(self.solid_angle);
                (pdf > 0.0).then_some((scattered, pdf, power_heuristic(pdf, other)))?
            }
        };
        Some(Drawn {
            direction: self.frame.to_world(wo).normalized(),
            factor: scattered / pdf,
            weight,
        })
    }
}
