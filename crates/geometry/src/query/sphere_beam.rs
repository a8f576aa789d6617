//! The rays of a beam against a sphere: how all of them pass it at a time, and which faces they may hit
//! one by one; then pairs of a ray and a face, four at a time.

use capwalk_math::Vec3;

use super::beam::Beam;
use super::bundle::BUNDLE;
use super::local_bundle::Numbers;
use super::passage::Passage;
use super::ray_kernel::{LANES, TriangleBlock};
use super::sphere::Sphere;
use crate::simd::Simd;

/// Rays, each with a face.
struct Pairs {
    block: TriangleBlock,
    rays: [usize; LANES],
    count: usize,
}

impl<S: Simd> Beam<'_, S> {
    /// Calls `found` with each of some rays that hits a face no farther than at its `t_max`, the
    /// face and the distance, where it may take from `t_max`; the rays of which it does not know.
    #[inline(always)]
    pub fn intersect_sphere(
        &self,
        simd: S,
        sphere: &Sphere,
        passages: &Passages,
        rays: u32,
        t_max: &mut Numbers,
        mut found: impl FnMut(usize, u32, f64, &mut Numbers),
    ) -> u32 {
        let mut unknown = rays & !passages.known;
        let mut open = rays & passages.near;
        let mut pairs = Pairs {
            block: TriangleBlock::EMPTY,
            rays: [0; LANES],
            count: 0,
        };
        // The nearer way first: whoever hits something there does not reach the other.
        for number in 0..2 {
            let mut rest = open;
            while rest != 0 {
                let ray = rest.trailing_zeros() as usize % t_max.len();
                rest &= rest - 1;
                let passage = passages.get(ray);
                let Some(way) = passage.ways()[number] else {
                    open &= !(1 << ray);
                    continue;
                };
                let bounds = [self.local.range[0][ray], t_max[ray]];
                let along = sphere.along(&passage, way, bounds);
                let Some(faces) = along.faces() else {
                    unknown |= 1 << ray;
                    open &= !(1 << ray);
                    continue;
                };
                for &face in faces {
                    let (lane, corners) = (pairs.count, sphere.corners_of(face));
                    pairs.block.set(lane, sphere.faces().start + face, corners);
                    pairs.rays[lane] = ray;
                    pairs.count += 1;
                    if pairs.count == LANES {
                        self.intersect_pairs(simd, &pairs, t_max, &mut found);
                        pairs.count = 0;
                    }
                }
            }
            if pairs.count > 0 {
                self.intersect_pairs(simd, &pairs, t_max, &mut found);
                pairs.count = 0;
            }
        }
        unknown
    }

    /// Calls `found` with each ray that hits its face.
    #[inline(always)]
    fn intersect_pairs(
        &self,
        simd: S,
        pairs: &Pairs,
        t_max: &mut Numbers,
        found: &mut impl FnMut(usize, u32, f64, &mut Numbers),
    ) {
        let hits = self.crossings(simd, &pairs.block, pairs.rays, pairs.count, t_max);
        let mut rest = hits.mask;
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize % LANES;
            rest &= rest - 1;
            let (ray, t) = (pairs.rays[lane], hits.t[lane]);
            found(ray, pairs.block.face(lane), t, t_max);
        }
    }
}

/// How the rays of a bundle pass a sphere.
pub struct Passages {
    origin: [Numbers; 3],
    direction: [Numbers; 3],
    margin: Numbers,
    middle: Numbers,
    outer: Numbers,
    inner: Numbers,
    slack: Numbers,
    /// One bit for each that is known.
    pub known: u32,
    /// One bit for each that may hit a face within its range.
    pub near: u32,
    /// One bit for each that surely does.
    pub hits: u32,
}

impl Passages {
    /// Those of rays in the world, with the range of each.
    #[inline(always)]
    pub fn new(
        sphere: &Sphere,
        [ox, oy, oz]: &[Numbers; 3],
        [dx, dy, dz]: &[Numbers; 3],
        [t_min, t_max]: [&Numbers; 2],
    ) -> Self {
        let zero = [0.0; BUNDLE];
        let mut all = Self {
            origin: [zero; 3],
            direction: [zero; 3],
            margin: zero,
            middle: zero,
            outer: zero,
            inner: zero,
            slack: zero,
            known: 0,
            near: 0,
            hits: 0,
        };
        let mut flags = [[false; BUNDLE]; 3];
        for ray in 0..BUNDLE {
            let origin = Vec3::new(ox[ray], oy[ray], oz[ray]);
            let direction = Vec3::new(dx[ray], dy[ray], dz[ray]);
            let own = sphere.passage(origin, direction);
            for axis in 0..3 {
                all.origin[axis][ray] = own.origin[axis];
                all.direction[axis][ray] = own.direction[axis];
            }
            all.margin[ray] = own.margin;
            all.middle[ray] = own.middle;
            all.outer[ray] = own.outer;
            all.inner[ray] = own.inner;
            all.slack[ray] = own.slack;
            let range = [t_min[ray], t_max[ray]];
            flags[0][ray] = own.is_known;
            flags[1][ray] = !own.misses(range);
            flags[2][ray] = own.surely_hits(range);
        }
        let [known, near, hits] = flags.map(|flags| {
            let bits = flags.iter().enumerate();
            bits.fold(0, |mask, (ray, &flag)| mask | u32::from(flag) << ray)
        });
        all.known = known;
        all.near = near & known;
        all.hits = hits & all.near;
        all
    }

    /// That of a ray that is known and may hit a face.
    #[inline(always)]
    pub fn get(&self, ray: usize) -> Passage {
        let vector =
            |numbers: &[Numbers; 3]| Vec3::new(numbers[0][ray], numbers[1][ray], numbers[2][ray]);
        Passage {
            origin: vector(&self.origin),
            direction: vector(&self.direction),
            margin: self.margin[ray],
            middle: self.middle[ray],
            outer: self.outer[ray],
            inner: self.inner[ray],
            slack: self.slack[ray],
            is_known: true,
            meets: true,
        }
    }
}
