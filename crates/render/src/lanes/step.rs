//! The steps of eight paths: loops over the lanes without a branch, compiled for the processor's
//! vectors.

use std::f64::consts::FRAC_1_PI;

use capwalk_geometry::simd::{Computation, Simd};
use capwalk_math::{Frame, Vec3};
use capwalk_scene::lobe::sample_cosine;

use crate::lanes::vectors::{LANES, Numbers, Vectors};
use crate::light::power_heuristic;
use crate::rectangle_sampler::RectangleSampler;

/// Where eight paths hit surfaces.
#[derive(Clone, Copy, Debug)]
pub struct Vertices {
    /// The rays that led there.
    pub origin: Vectors,
    pub direction: Vectors,
    /// A corner of the face, and its unit normal by its winding.
    pub corner: Vectors,
    pub face_normal: Vectors,
    /// The unit shading normal on the outside, and 1 or -1 for the side of it that is the front of
    /// the material that is seen.
    pub outward: Vectors,
    pub side: Numbers,
    /// Fractions of light that are reflected, where surfaces are diffuse.
    pub albedo: Vectors,
    /// Where they are; known after [`Surfaces`].
    pub position: Vectors,
    /// The solid angle under which the emitter is seen; known after [`Light`].
    pub solid_angle: Numbers,
}

impl Vertices {
    /// None yet.
    pub const NONE: Self = Self {
        origin: Vectors::ZERO,
        direction: Vectors::ZERO,
        corner: Vectors::ZERO,
        face_normal: Vectors::UP,
        outward: Vectors::UP,
        side: [1.0; LANES],
        albedo: Vectors::ZERO,
        position: Vectors::ZERO,
        solid_angle: [0.0; LANES],
    };
}

/// The normal on the side of the front.
#[inline(always)]
fn normal(outward: &Vectors, side: &Numbers, lane: usize) -> Vec3 {
    outward.get(lane) * side[lane]
}

/// Intersects the rays with the planes of the faces.
pub struct Surfaces<'a>(pub &'a mut Vertices);

impl Computation for Surfaces<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        // Copies, which nothing else refers to; so in all steps.
        let Vertices {
            origin,
            direction,
            corner,
            face_normal,
            ..
        } = *self.0;
        let mut position = origin;
        for lane in 0..LANES {
            let (origin, direction) = (origin.get(lane), direction.get(lane));
            let normal = face_normal.get(lane);
            let t = (corner.get(lane) - origin).dot(normal) / direction.dot(normal);
            position.set(lane, origin + direction * t);
        }
        self.0.position = position;
    }
}

/// Density of points sampled on an emitter that is seen under a solid angle. Where it is not seen
/// from the front, none of it is hit.
#[inline(always)]
pub fn density(solid_angle: f64) -> f64 {
    if solid_angle > 0.0 {
        1.0 / solid_angle
    } else {
        0.0
    }
}

/// Points sampled on the emitter.
#[derive(Clone, Copy, Debug)]
pub struct Lit {
    /// Unit directions to them, and their distances.
    pub direction: Vectors,
    pub distance: Numbers,
    /// Where surfaces are diffuse, the cosine over π, times the weight, over the density.
    pub weight: Numbers,
    /// One bit for each that may be seen.
    pub mask: u32,
}

impl Default for Lit {
    fn default() -> Self {
        Self {
            direction: Vectors::UP,
            distance: [0.0; LANES],
            weight: [0.0; LANES],
            mask: 0,
        }
    }
}

/// Samples points on the emitter.
pub struct Light<'a> {
    pub vertices: &'a mut Vertices,
    pub rectangle: &'a RectangleSampler,
    pub u: &'a [Numbers; 2],
    /// One bit for each where directions are drawn from the surface, too.
    pub of_brdf: u32,
    /// One bit for each where light comes through the surface, too.
    pub transmits: u32,
    pub lit: &'a mut Lit,
}

impl Computation for Light<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            vertices,
            rectangle,
            u,
            of_brdf,
            transmits,
            lit,
        } = self;
        let (position, outward, side) = (vertices.position, vertices.outward, vertices.side);
        let (u, rectangle) = (*u, rectangle.clone());
        let (mut directions, mut distances) = (lit.direction, [0.0; LANES]);
        let (mut weights, mut solid_angles) = ([0.0; LANES], [0.0; LANES]);
        let mut cosines = [0.0; LANES];
        for lane in 0..LANES {
            let (seen, _) = rectangle.seen(position.get(lane));
            let offset = rectangle.offset(&seen, [u[0][lane], u[1][lane]]);
            let distance = offset.length();
            let direction = offset * (1.0 / distance);
            let cos = direction.dot(normal(&outward, &side, lane));
            solid_angles[lane] = seen.solid_angle;
            directions.set(lane, direction);
            distances[lane] = distance;
            let own = 1.0 / seen.solid_angle;
            let has_other = of_brdf >> lane & 1 == 1;
            let other = if has_other { cos * FRAC_1_PI } else { 0.0 };
            weights[lane] = cos * FRAC_1_PI * (power_heuristic(own, other) / own);
            cosines[lane] = cos;
        }
        let mut mask = 0;
        for lane in 0..LANES {
            // What is not a number is not dark: the pixel counts it.
            let is_behind = cosines[lane] <= 0.0 && transmits >> lane & 1 == 0;
            let is_dark = solid_angles[lane] <= 0.0 || is_behind;
            mask |= u32::from(!is_dark) << lane;
        }
        vertices.solid_angle = solid_angles;
        *lit = Lit {
            direction: directions,
            distance: distances,
            weight: weights,
            mask,
        };
    }
}

/// Directions drawn from surfaces.
#[derive(Clone, Copy, Debug)]
pub struct Brdf {
    pub direction: Vectors,
    /// That of light from the emitter, if it is seen there.
    pub weight: Numbers,
}

impl Default for Brdf {
    fn default() -> Self {
        Self {
            direction: Vectors::UP,
            weight: [0.0; LANES],
        }
    }
}

/// Draws directions by the cosine, for surfaces that are diffuse.
pub struct Draw<'a> {
    pub vertices: &'a Vertices,
    pub u: &'a [Numbers; 2],
    pub drawn: &'a mut Brdf,
}

impl Computation for Draw<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self { vertices, u, drawn } = self;
        let (outward, side) = (vertices.outward, vertices.side);
        let (solid_angle, u) = (vertices.solid_angle, *u);
        let (mut directions, mut weights) = (drawn.direction, [0.0; LANES]);
        for lane in 0..LANES {
            let frame = Frame::from_normal(outward.get(lane));
            let wo = sample_cosine([u[0][lane], u[1][lane]]);
            let up = frame.n * (side[lane] * wo.z);
            let direction = (frame.s * wo.x + frame.t * wo.y + up).normalized();
            directions.set(lane, direction);
            let own = wo.z * FRAC_1_PI;
            weights[lane] = power_heuristic(own, density(solid_angle[lane]));
        }
        (drawn.direction, drawn.weight) = (directions, weights);
    }
}
