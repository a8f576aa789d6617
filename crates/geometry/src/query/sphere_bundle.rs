//! The rays of a bundle against a sphere: how all of them pass it at a time, and which faces they may
//! hit one by one; then pairs of a ray and a face, four at a time.

use capwalk_math::Vec3;

use super::bundle::{BUNDLE, Bundle, Numbers, vector};
use super::passage::Passage;
use super::ray_kernel::{Crossing, LANES, crossing};
use super::sphere::MeshSphere;
use crate::ray::RayShear;
use crate::simd::{F64x4, Lanes, Simd};

/// The rays of a bundle in the world.
pub struct RaysToSphere<'a, F> {
    pub rays: &'a Bundle<'a>,
    /// The shear of each.
    pub shear: F,
}

impl<F: Fn(usize) -> RayShear> RaysToSphere<'_, F> {
    /// Ends rays at the nearest face that each hits before its end, of equally near ones the lowest:
    /// one bit for each that hits one, and for each of which this is not known.
    #[inline(always)]
    pub fn first_hits<S: Simd>(
        &self,
        simd: S,
        sphere: &MeshSphere,
        rays: u32,
        t_max: &mut Numbers,
        faces: &mut [u32; BUNDLE],
    ) -> [u32; 2] {
        let passages = Passages::new(sphere, self.rays, t_max);
        let mut hit = 0;
        let found = |ray: usize, face, t, t_max: &mut Numbers| {
            if (t, face) < (t_max[ray], faces[ray]) {
                t_max[ray] = t;
                faces[ray] = face;
                hit |= 1 << ray;
            }
        };
        let unknown = self.intersect(simd, sphere, &passages, rays, t_max, found);
        [hit, unknown]
    }

    /// One bit for each ray that hits a face before its end, and for each of which this is not known.
    #[inline(always)]
    pub fn occluded<S: Simd>(
        &self,
        simd: S,
        sphere: &MeshSphere,
        rays: u32,
        t_max: &Numbers,
    ) -> [u32; 2] {
        let passages = Passages::new(sphere, self.rays, t_max);
        let mut hit = passages.hits & rays;
        let (open, mut t_max) = (rays & !hit, *t_max);
        let found = |ray: usize, _, _, t_max: &mut Numbers| {
            hit |= 1 << ray;
            t_max[ray] = f64::NEG_INFINITY;
        };
        let unknown = self.intersect(simd, sphere, &passages, open, &mut t_max, found);
        [hit, unknown & !hit]
    }

    /// Calls `found` with each of some rays that hits a face no farther than at its `t_max`, the
    /// face and the distance, where it may take from `t_max`; the rays of which it does not know.
    #[inline(always)]
    fn intersect<S: Simd>(
        &self,
        simd: S,
        sphere: &MeshSphere,
        passages: &Passages,
        rays: u32,
        t_max: &mut Numbers,
        mut found: impl FnMut(usize, u32, f64, &mut Numbers),
    ) -> u32 {
        let mut unknown = rays & !passages.known;
        let mut open = rays & passages.near;
        let mut pairs = Pairs::default();
        // The nearer way first: whoever hits something there does not reach the other.
        for number in 0..2 {
            let mut rest = open;
            while rest != 0 {
                let ray = rest.trailing_zeros() as usize % BUNDLE;
                rest &= rest - 1;
                let passage = passages.get(ray);
                let Some(way) = passage.ways()[number] else {
                    open &= !(1 << ray);
                    continue;
                };
                let bounds = [self.rays.range[0][ray], t_max[ray]];
                let along = sphere.along(&passage, way, bounds);
                let Some(faces) = along.faces() else {
                    unknown |= 1 << ray;
                    open &= !(1 << ray);
                    continue;
                };
                let ray = (ray, (self.shear)(ray));
                for &face in faces {
                    let corners = sphere.corners_of(face);
                    self.push(&mut pairs, ray, sphere.faces().start + face, corners);
                    if pairs.count == LANES {
                        pairs.intersect(simd, t_max, &mut found);
                        pairs.count = 0;
                    }
                }
            }
            if pairs.count > 0 {
                pairs.intersect(simd, t_max, &mut found);
                pairs.count = 0;
            }
        }
        unknown
    }

    /// Adds a ray, whose shear this is, with a face.
    #[inline(always)]
    fn push(
        &self,
        pairs: &mut Pairs,
        (ray, shear): (usize, RayShear),
        face: u32,
        corners: [Vec3; 3],
    ) {
        let RayShear {
            axes: [i, j, k],
            shear: [shear_x, shear_y],
            inverse_z,
        } = shear;
        let [ox, oy, oz] = [i, j, k].map(|axis| self.rays.origin[axis][ray]);
        let lane = pairs.count;
        for (own, corner) in pairs.corners.iter_mut().zip(corners) {
            let z = corner[k] - oz;
            own[0][lane] = (corner[i] - ox) - shear_x * z;
            own[1][lane] = (corner[j] - oy) - shear_y * z;
            own[2][lane] = z;
        }
        pairs.inverse_z[lane] = inverse_z;
        pairs.t_min[lane] = self.rays.range[0][ray];
        pairs.rays[lane] = ray;
        pairs.faces[lane] = face;
        pairs.count += 1;
    }
}

/// Rays, each with a face.
#[derive(Default)]
struct Pairs {
    /// Corner by corner and axis by axis, relative to the rays, and sheared.
    corners: [[[f64; LANES]; 3]; 3],
    inverse_z: [f64; LANES],
    t_min: [f64; LANES],
    rays: [usize; LANES],
    faces: [u32; LANES],
    count: usize,
}

impl Pairs {
    /// Calls `found` with each ray that hits its face: exactly
    /// [`TriangleBlock::intersect`](super::ray_kernel::TriangleBlock::intersect), operation by operation.
    #[inline(always)]
    fn intersect<S: Simd>(
        &self,
        simd: S,
        t_max: &mut Numbers,
        found: &mut impl FnMut(usize, u32, f64, &mut Numbers),
    ) {
        let [a, b, c] = &self.corners;
        let corners = [load(simd, a), load(simd, b), load(simd, c)];
        let inverse_z = simd.load_f64(&self.inverse_z);
        let asked = (1 << self.count) - 1;
        let Some(Crossing { inside, t, .. }) = crossing(simd, corners, inverse_z, asked) else {
            return;
        };
        let ends = self.rays.map(|ray| t_max[ray]);
        let in_range = simd.load_f64(&self.t_min).le(t) & t.le(simd.load_f64(&ends));
        let t = t.to_array();
        let mut rest = inside & in_range;
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize % LANES;
            rest &= rest - 1;
            found(self.rays[lane], self.faces[lane], t[lane], t_max);
        }
    }
}

#[inline(always)]
fn load<S: Simd>(simd: S, [x, y, z]: &[[f64; LANES]; 3]) -> [S::F64x4; 3] {
    [simd.load_f64(x), simd.load_f64(y), simd.load_f64(z)]
}

/// How the rays of a bundle pass a sphere.
struct Passages {
    origin: [Numbers; 3],
    direction: [Numbers; 3],
    margin: Numbers,
    middle: Numbers,
    outer: Numbers,
    inner: Numbers,
    slack: Numbers,
    /// One bit for each that is known.
    known: u32,
    /// One bit for each that may hit a face within its range.
    near: u32,
    /// One bit for each that surely does.
    hits: u32,
}

impl Passages {
    /// Those of rays in the world, up to some distances.
    #[inline(always)]
    fn new(sphere: &MeshSphere, rays: &Bundle<'_>, t_max: &Numbers) -> Self {
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
            let own = sphere.passage(vector(rays.origin, ray), vector(rays.direction, ray));
            for axis in 0..3 {
                all.origin[axis][ray] = own.origin[axis];
                all.direction[axis][ray] = own.direction[axis];
            }
            all.margin[ray] = own.margin;
            all.middle[ray] = own.middle;
            all.outer[ray] = own.outer;
            all.inner[ray] = own.inner;
            all.slack[ray] = own.slack;
            let range = [rays.range[0][ray], t_max[ray]];
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
    fn get(&self, ray: usize) -> Passage {
        Passage {
            origin: vector(&self.origin, ray),
            direction: vector(&self.direction, ray),
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
