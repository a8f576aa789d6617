//! Rough surfaces of lanes: what their facets do to light, all lanes at a time.

use capwalk_geometry::simd::{Computation, Simd};
use capwalk_math::Vec3;
use capwalk_scene::lobe::{Distribution, Microfacets, Mirrored, branchless};

use crate::lanes::frames::LaneFrames;
use crate::lanes::vectors::{LANES, Numbers, Vectors};

/// The facets of the surfaces.
#[derive(Clone, Copy, Debug)]
pub struct LaneFacets {
    alpha: [Numbers; 2],
    distribution: [Distribution; LANES],
    /// What is seen of them; known after [`Seen`].
    visible: Numbers,
}

impl LaneFacets {
    /// Any.
    pub const ANY: Self = Self {
        alpha: [[1.0; LANES]; 2],
        distribution: [Distribution::Ggx; LANES],
        visible: [0.0; LANES],
    };

    /// Sets those of a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, facets: &Microfacets) {
        self.alpha[0][lane] = facets.alpha_u;
        self.alpha[1][lane] = facets.alpha_v;
        self.distribution[lane] = facets.distribution;
    }

    /// [`Microfacets::visible_over_cos`] of the direction to the viewer of a lane.
    #[inline]
    pub fn visible(&self, lane: usize) -> f64 {
        self.visible[lane]
    }

    #[inline(always)]
    fn get(&self, lane: usize) -> Microfacets {
        Microfacets {
            distribution: self.distribution[lane],
            alpha_u: self.alpha[0][lane],
            alpha_v: self.alpha[1][lane],
        }
    }
}

/// The direction to the viewer, on the side of the front.
#[inline(always)]
fn raised(wi: &Vectors, lane: usize) -> Vec3 {
    let wi = wi.get(lane);
    Vec3::new(wi.x, wi.y, wi.z.abs())
}

/// Finds what is seen of the facets.
pub struct Seen<'a> {
    pub frames: &'a LaneFrames,
    pub facets: &'a mut LaneFacets,
}

impl Computation for Seen<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let (wi, facets) = (self.frames.wi, *self.facets);
        let mut visible = [0.0; LANES];
        for (lane, visible) in visible.iter_mut().enumerate() {
            *visible = branchless::visible_over_cos(&facets.get(lane), raised(&wi, lane));
        }
        self.facets.visible = visible;
    }
}

/// What the facets do to light from some directions.
#[derive(Clone, Copy, Debug, Default)]
pub struct LaneMirrored {
    cos: Numbers,
    pdf: Numbers,
    scattered: Numbers,
}

impl LaneMirrored {
    /// That of a lane.
    pub fn get(&self, lane: usize) -> Mirrored {
        Mirrored {
            cos: self.cos[lane],
            pdf: self.pdf[lane],
            scattered: self.scattered[lane],
        }
    }
}

/// Mirrors light from directions in the frames of the lobes.
pub struct Mirror<'a> {
    pub frames: &'a LaneFrames,
    pub facets: &'a LaneFacets,
    pub directions: &'a Vectors,
    pub mirrored: &'a mut LaneMirrored,
}

impl Computation for Mirror<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let (wi, facets, directions) = (self.frames.wi, *self.facets, *self.directions);
        let mut all = LaneMirrored::default();
        for lane in 0..LANES {
            let (wi, wo) = (raised(&wi, lane), directions.get(lane));
            let visible = facets.visible[lane];
            let found = branchless::mirrored(&facets.get(lane), wi, visible, wo);
            all.cos[lane] = found.cos;
            all.pdf[lane] = found.pdf;
            all.scattered[lane] = found.scattered;
        }
        *self.mirrored = all;
    }
}
