//! An environment map, as lanes see it.

use capwalk_boundary::Streams;
use capwalk_geometry::simd::{Computation, Simd};
use capwalk_math::{Rgb, Vec3};
use capwalk_scene::Texture;
use capwalk_scene::emitter::{EnvironmentTable, MapPlace};
use capwalk_scene::texture::between;

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
    /// What is seen at the places of some lanes. All texels are read before any is used: maps are
    /// larger than caches, and so lanes wait for memory together.
    #[inline(always)]
    fn see(
        &self,
        places: &[MapPlace<f64>; LANES],
        lanes: u32,
        mut seen: impl FnMut(usize, SkyPoint),
    ) {
        let mut around = [([Rgb::zero(); 4], [0.0; 2]); LANES];
        for lane in lanes_of(lanes) {
            let (corners, along) = self.table.map().corners(&places[lane]);
            around[lane] = (corners.map(|index| self.texels.texel(index)), along);
        }
        for lane in lanes_of(lanes) {
            let ((texels, along), place) = (around[lane], places[lane]);
            let point = SkyPoint {
                radiance: between(texels, along) * self.scale,
                pdf: map_pdf(self.table, &place),
                place,
            };
            seen(lane, point);
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
        let is_uniform = |&lane: &usize| sky.table.is_black() || u[0][lane] < UNIFORM_SKY;
        let by_table = lanes_of(lanes).filter(|lane| !is_uniform(lane));
        let rest = |lane: usize| (u[0][lane] - UNIFORM_SKY) / (1.0 - UNIFORM_SKY);
        let cells: [_; LANES] = sky.table.choose(|lane| [rest(lane), u[1][lane]], by_table);
        let mut directions = [Vec3::zero(); LANES];
        let mut places = [MapPlace::default(); LANES];
        for (lane, cell) in cells.iter().enumerate() {
            (directions[lane], places[lane]) = sky.table.within(cell);
        }
        for lane in lanes_of(lanes).filter(is_uniform) {
            (directions[lane], places[lane]) = sample_map(sky.table, [u[0][lane], u[1][lane]]);
        }
        sky.see(&places, lanes, |lane, point| {
            lit.direction.set(lane, directions[lane]);
            lit.range[1][lane] = f64::INFINITY;
            lit.inverse_density[lane] /= point.pdf;
            lit.sky[lane] = point;
        });
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
        sky.see(&places, lanes, |lane, point| seen[lane] = point);
    }
}
