//! An environment map, as lanes see it.

use capwalk_boundary::Streams;
use capwalk_geometry::simd::{Computation, Simd};
use capwalk_math::{Rgb, Vec3};
use capwalk_scene::Texture;
use capwalk_scene::emitter::{ChosenCell, EnvironmentTable, MapPlace};

use crate::lanes::lit::{Lit, SkyPoint};
use crate::lanes::vectors::{LANES, Vectors, lanes_of};
use crate::light::{UNIFORM_SKY, map_pdf, sample_map};

/// An environment map.
#[derive(Clone, Copy)]
pub struct Sky<'a> {
    pub table: &'a EnvironmentTable,
    pub texels: &'a Texture,
    /// What its texels are multiplied by.
    pub scale: Rgb,
}

impl Sky<'_> {
    #[inline(always)]
    fn point(&self, place: MapPlace<f64>) -> SkyPoint {
        let texel = |index| self.texels.texel(index);
        SkyPoint {
            radiance: self.table.map().at(&place, texel) * self.scale,
            pdf: map_pdf(self.table, &place),
            place,
        }
    }
}

/// Draws directions to it, see [`sample_map`].
pub struct DrawSky<'a> {
    pub sky: Sky<'a>,
    pub streams: &'a Streams<LANES>,
    /// The first of two random numbers.
    pub first: u32,
    /// One bit for each that needs a direction.
    pub lanes: u32,
    /// For those lanes the inverse density still lacks that of directions.
    pub lit: &'a mut Lit,
}

impl Computation for DrawSky<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            sky,
            streams,
            first,
            lanes,
            lit,
        } = self;
        let u = streams.pairs(first, lanes);
        let mut cells = [ChosenCell::default(); LANES];
        let mut uniform = 0;
        for lane in lanes_of(lanes) {
            match sky.table.is_black() || u[0][lane] < UNIFORM_SKY {
                true => uniform |= 1 << lane,
                false => {
                    let rest = (u[0][lane] - UNIFORM_SKY) / (1.0 - UNIFORM_SKY);
                    cells[lane] = sky.table.choose([rest, u[1][lane]]);
                }
            }
        }
        let mut drawn = [(Vec3::zero(), MapPlace::default()); LANES];
        for (drawn, cell) in drawn.iter_mut().zip(&cells) {
            *drawn = sky.table.within(cell);
        }
        for lane in lanes_of(lanes) {
            if uniform >> lane & 1 == 1 {
                drawn[lane] = sample_map(sky.table, [u[0][lane], u[1][lane]]);
            }
            let (direction, place) = drawn[lane];
            let point = sky.point(place);
            lit.direction.set(lane, direction);
            lit.range[1][lane] = f64::INFINITY;
            lit.inverse_density[lane] /= point.pdf;
            lit.sky[lane] = point;
        }
        lit.mask |= lanes;
    }
}

/// Finds what is seen in the directions of some lanes.
pub struct SeeSky<'a> {
    pub sky: Sky<'a>,
    pub directions: &'a Vectors,
    pub lanes: u32,
    pub seen: &'a mut [SkyPoint; LANES],
}

impl Computation for SeeSky<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            sky,
            directions,
            lanes,
            seen,
        } = self;
        let mut places = [MapPlace::default(); LANES];
        for (lane, place) in places.iter_mut().enumerate() {
            *place = sky.table.map().place(directions.get(lane));
        }
        for lane in lanes_of(lanes) {
            seen[lane] = sky.point(places[lane]);
        }
    }
}
