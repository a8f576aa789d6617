//! Point emitters, all lanes at a time.

use capwalk_geometry::simd::{Computation, Simd};
use capwalk_math::{Rgb, Vec3};

use crate::lanes::lit::Lit;
use crate::lanes::step::Vertices;
use crate::lanes::vectors::{LANES, Numbers, Vectors};
use crate::receiver::cosine_in;

/// A point emitter, which sends as much in all directions.
#[derive(Clone, Copy, Debug)]
pub struct PointEmitter {
    pub position: Vec3,
    /// Its intensity.
    pub intensity: Rgb,
}

/// Finds how much surfaces receive of a point emitter, over its brightness, if nothing is in between:
/// [`EmitterSampler::view`](crate::emitter_sampler::EmitterSampler::view).
pub struct ViewPointEmitter<'a> {
    pub position: Vec3,
    pub vertices: &'a Vertices,
    /// One bit for each surface that transmits light.
    pub transmits: u32,
}

impl Computation for ViewPointEmitter<'_> {
    type Output = Numbers;
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> Numbers {
        let mut views = [0.0; LANES];
        for (lane, view) in views.iter_mut().enumerate() {
            let offset = self.position - self.vertices.position.get(lane);
            let squared = offset.length_squared();
            let direction = offset * (1.0 / squared.sqrt());
            let transmits = self.transmits >> lane & 1 == 1;
            let seen = cosine_in(direction.dot(self.vertices.normal(lane)), transmits) / squared;
            // Nothing arrives where it is.
            *view = if squared == 0.0 { 0.0 } else { seen };
        }
        views
    }
}

/// Finds the directions from surfaces towards point emitters, and what arrives from there.
pub struct LookAtPointEmitters<'a> {
    pub vertices: &'a Vertices,
    /// The positions of those of some lanes, whose intensities `lit.radiance` has.
    pub positions: &'a Vectors,
    pub lanes: u32,
    pub lit: &'a mut Lit,
}

impl Computation for LookAtPointEmitters<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            vertices,
            positions,
            lanes,
            lit,
        } = self;
        let squares = look_at(vertices, positions, lanes, lit);
        for (lane, &squared) in squares.iter().enumerate() {
            lit.mask |= (lanes >> lane & u32::from(squared != 0.0)) << lane;
        }
        lit.of_delta |= lanes & lit.mask;
    }
}

#[inline(always)]
fn look_at(vertices: &Vertices, positions: &Vectors, lanes: u32, lit: &mut Lit) -> Numbers {
    let mut squares = [0.0; LANES];
    for (lane, square) in squares.iter_mut().enumerate() {
        let offset = positions.get(lane) - vertices.position.get(lane);
        let squared = offset.length_squared();
        let distance = squared.sqrt();
        let is_asked = lanes >> lane & 1 == 1;
        let (direction, radiance) = (lit.direction.get(lane), lit.radiance.get(lane));
        let (towards, arrives) = (offset * (1.0 / distance), radiance * (1.0 / squared));
        lit.direction
            .set(lane, if is_asked { towards } else { direction });
        lit.radiance
            .set(lane, if is_asked { arrives } else { radiance });
        lit.range[1][lane] = if is_asked {
            distance
        } else {
            lit.range[1][lane]
        };
        *square = squared;
    }
    squares
}
