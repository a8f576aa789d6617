//! Rough metal and rough plastic of lanes: what they do to light, all lanes at a time but for
//! tables, metals' Fresnel terms, and facets that are drawn.

use std::f64::consts::FRAC_1_PI;

use capwalk_geometry::simd::{Computation, Simd};
use capwalk_math::Vec3;
use capwalk_scene::lobe::branchless::{self, Stretched};
use capwalk_scene::lobe::{Distribution, Microfacets, RoughSurface};

use crate::lanes::frames::LaneFrames;
use crate::lanes::step::weight_over_density;
use crate::lanes::vectors::{LANES, Numbers, Vectors, lanes_of};

/// The rough surfaces, coordinate by coordinate.
#[derive(Debug)]
pub struct LaneRough<'a> {
    surfaces: [Option<Held<'a>>; LANES],
    alpha: [Numbers; 2],
    distribution: [Distribution; LANES],
    specular: Vectors,
    base: Vectors,
    eta2: Numbers,
    choice_weights: [Numbers; 2],
    /// What is seen of the facets, how much passes the coat on the way to the viewer, and how
    /// probably the base is drawn; known after [`Seen`].
    visible: Numbers,
    enters: Numbers,
    base_probability: Numbers,
}

/// A rough surface.
#[derive(Debug)]
enum Held<'a> {
    /// Of a material that is the same everywhere.
    Constant(&'a RoughSurface),
    /// At a point.
    Own(RoughSurface),
}

impl Held<'_> {
    #[inline(always)]
    fn get(&self) -> &RoughSurface {
        match self {
            Held::Constant(surface) => surface,
            Held::Own(surface) => surface,
        }
    }
}

impl<'a> LaneRough<'a> {
    /// None yet.
    pub const NONE: Self = Self {
        surfaces: [const { None }; LANES],
        alpha: [[1.0; LANES]; 2],
        distribution: [Distribution::Ggx; LANES],
        specular: Vectors::ZERO,
        base: Vectors::ZERO,
        eta2: [1.0; LANES],
        choice_weights: [[1.0; LANES]; 2],
        visible: [0.0; LANES],
        enters: [0.0; LANES],
        base_probability: [0.0; LANES],
    };

    /// Sets that of a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, surface: &'a RoughSurface) {
        self.set_numbers(lane, surface);
        self.surfaces[lane] = Some(Held::Constant(surface));
    }

    /// Sets that of a lane, found at a point.
    pub fn set_own(&mut self, lane: usize, surface: RoughSurface) {
        self.set_numbers(lane, &surface);
        self.surfaces[lane] = Some(Held::Own(surface));
    }

    #[inline(always)]
    fn set_numbers(&mut self, lane: usize, surface: &RoughSurface) {
        self.alpha[0][lane] = surface.facets.alpha_u;
        self.alpha[1][lane] = surface.facets.alpha_v;
        self.distribution[lane] = surface.facets.distribution;
        self.specular.set_colour(lane, surface.specular);
        self.base.set_colour(lane, surface.base);
        self.eta2[lane] = surface.eta2;
        [self.choice_weights[0][lane], self.choice_weights[1][lane]] = surface.choice_weights;
    }
}

/// The direction to the viewer, on the side of the front.
#[inline(always)]
fn raised(wi: &Vectors, lane: usize) -> Vec3 {
    let wi = wi.get(lane);
    Vec3::new(wi.x, wi.y, wi.z.abs())
}

/// The facets of a lane.
#[inline(always)]
fn facets(alpha: &[Numbers; 2], distribution: &[Distribution; LANES], lane: usize) -> Microfacets {
    Microfacets {
        distribution: distribution[lane],
        alpha_u: alpha[0][lane],
        alpha_v: alpha[1][lane],
    }
}

/// Finds what the viewers see of some lanes.
pub struct Seen<'a, 's> {
    pub frames: &'a LaneFrames,
    pub rough: &'a mut LaneRough<'s>,
    pub lanes: u32,
}

impl Computation for Seen<'_, '_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            frames,
            rough,
            lanes,
        } = self;
        for lane in lanes_of(lanes) {
            let surface = rough.surfaces[lane].as_ref().map(Held::get);
            let passes = surface.map(|surface| surface.passes(frames.wi.0[2][lane].abs()));
            rough.enters[lane] = passes.unwrap_or(0.0);
        }
        see(&frames.wi, rough);
    }
}

#[inline(always)]
fn see(wi: &Vectors, rough: &mut LaneRough<'_>) {
    for lane in 0..LANES {
        let facets = facets(&rough.alpha, &rough.distribution, lane);
        rough.visible[lane] = branchless::visible_over_cos(&facets, raised(wi, lane));
        let weights = [rough.choice_weights[0][lane], rough.choice_weights[1][lane]];
        rough.base_probability[lane] = branchless::base_probability(rough.enters[lane], weights);
    }
}

/// Directions in front of stretched facets, coordinate by coordinate.
struct LaneStretched([Numbers; 5]);

impl LaneStretched {
    #[inline(always)]
    fn get(&self, lane: usize) -> Stretched {
        let [sin, cos, sin_phi, cos_phi, length] = &self.0;
        Stretched {
            sin: sin[lane],
            cos: cos[lane],
            sin_phi: sin_phi[lane],
            cos_phi: cos_phi[lane],
            length: length[lane],
        }
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, view: Stretched) {
        let [sin, cos, sin_phi, cos_phi, length] = &mut self.0;
        (sin[lane], cos[lane]) = (view.sin, view.cos);
        (sin_phi[lane], cos_phi[lane]) = (view.sin_phi, view.cos_phi);
        length[lane] = view.length;
    }
}

/// Draws facets in those of some lanes that draw no base, and the directions in which they mirror the
/// viewers; one bit for each of the lanes where the path goes on.
pub struct DrawFacets<'a, 's> {
    pub frames: &'a LaneFrames,
    pub rough: &'a LaneRough<'s>,
    pub choice: &'a Numbers,
    pub u: &'a [Numbers; 2],
    pub lanes: u32,
    pub directions: &'a mut Vectors,
}

impl Computation for DrawFacets<'_, '_> {
    type Output = u32;
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> u32 {
        let Self {
            frames,
            rough,
            choice,
            u,
            lanes,
            directions,
        } = self;
        let mut drawn = 0;
        for (lane, &base) in rough.base_probability.iter().enumerate() {
            drawn |= u32::from(choice[lane] >= base) << lane;
        }
        drawn &= lanes;
        if drawn == 0 {
            return lanes;
        }
        draw_facets(&frames.wi, rough, u, drawn, directions);
        let mut up = 0;
        for lane in 0..LANES {
            up |= u32::from(directions.0[2][lane] > 0.0) << lane;
        }
        lanes & (up | !drawn)
    }
}

#[inline(always)]
fn draw_facets(
    wi: &Vectors,
    rough: &LaneRough<'_>,
    u: &[Numbers; 2],
    drawn: u32,
    directions: &mut Vectors,
) {
    let mut views = LaneStretched([[0.0; LANES]; 5]);
    for lane in 0..LANES {
        let facets = facets(&rough.alpha, &rough.distribution, lane);
        views.set(lane, branchless::stretched(&facets, raised(wi, lane)));
    }
    let mut normals = Vectors::UP;
    for lane in lanes_of(drawn) {
        let (visible, u) = (rough.visible[lane], [u[0][lane], u[1][lane]]);
        let distribution = rough.distribution[lane];
        let normal = branchless::stretched_normal(distribution, &views.get(lane), visible, u);
        normals.set(lane, normal);
    }
    for lane in 0..LANES {
        let facets = facets(&rough.alpha, &rough.distribution, lane);
        let (view, wi) = (views.get(lane), raised(wi, lane));
        let wo = branchless::mirrored_at(&facets, &view, normals.get(lane), wi);
        let kept = directions.get(lane);
        let is_drawn = drawn >> lane & 1 == 1;
        directions.set(lane, if is_drawn { wo } else { kept });
    }
}

/// What rough surfaces scatter.
#[derive(Debug)]
pub struct LaneScattered {
    /// `f |cos|`.
    colour: Vectors,
    /// The density with which the direction is drawn from the surface.
    pdf: Numbers,
}

impl LaneScattered {
    /// None yet.
    pub const NONE: Self = Self {
        colour: Vectors::ZERO,
        pdf: [0.0; LANES],
    };
}

/// Scatters light from directions in the frames at some lanes.
pub struct Scatter<'a, 's> {
    pub frames: &'a LaneFrames,
    pub rough: &'a LaneRough<'s>,
    pub directions: &'a Vectors,
    pub lanes: u32,
    pub scattered: &'a mut LaneScattered,
}

impl Computation for Scatter<'_, '_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        scatter(
            self.frames,
            self.rough,
            self.directions,
            self.lanes,
            self.scattered,
        );
    }
}

#[inline(always)]
fn scatter(
    frames: &LaneFrames,
    rough: &LaneRough<'_>,
    wo: &Vectors,
    lanes: u32,
    scattered: &mut LaneScattered,
) {
    // What facets that are perfect mirrors do, and which part of that a coat does.
    let (mut cos, mut pdf) = ([0.0; LANES], [0.0; LANES]);
    let (mut mirrored, mut fresnel) = ([0.0; LANES], [0.0; LANES]);
    for lane in 0..LANES {
        let facets = facets(&rough.alpha, &rough.distribution, lane);
        let (wi, wo) = (raised(&frames.wi, lane), wo.get(lane));
        let found = branchless::mirrored(&facets, wi, rough.visible[lane], wo);
        cos[lane] = found.cos;
        pdf[lane] = found.pdf;
        mirrored[lane] = found.scattered;
        fresnel[lane] = branchless::fresnel_dielectric(found.cos, rough.eta2[lane]);
    }
    // What leaves the coat, and metals.
    let mut specular = rough.specular;
    let mut leaves = [0.0; LANES];
    for lane in lanes_of(lanes) {
        let Some(surface) = rough.surfaces[lane].as_ref().map(Held::get) else {
            continue;
        };
        leaves[lane] = surface.passes(wo.0[2][lane]);
        if let Some(colour) = surface.metal(cos[lane]) {
            specular.set_colour(lane, colour);
            fresnel[lane] = 1.0;
        }
    }
    // Coat and base together; nothing goes below the surface.
    for lane in 0..LANES {
        let is_above = wo.0[2][lane] > 0.0;
        let rise = if is_above { wo.0[2][lane] } else { 0.0 };
        let coat = if is_above {
            fresnel[lane] * mirrored[lane]
        } else {
            0.0
        };
        let passes = rough.enters[lane] * leaves[lane] * rise;
        for axis in 0..3 {
            let base = rough.base.0[axis][lane] * passes;
            scattered.colour.0[axis][lane] = specular.0[axis][lane] * coat + base;
        }
        let probability = rough.base_probability[lane];
        let both = probability * (rise * FRAC_1_PI) + (1.0 - probability) * pdf[lane];
        scattered.pdf[lane] = if is_above { both } else { 0.0 };
    }
}

/// Weighs what is scattered at some lanes of light from directions drawn towards emitters.
pub struct WeighPoints<'a> {
    pub scattered: &'a LaneScattered,
    /// The inverse of the density of those directions.
    pub inverse_density: &'a Numbers,
    pub lanes: u32,
    /// Directions that are drawn from each surface that draws some, and one bit for each of those.
    pub bsdf_samples: f64,
    pub of_brdf: u32,
    pub colours: &'a mut Vectors,
    /// Weights over densities.
    pub weights: &'a mut Numbers,
}

impl Computation for WeighPoints<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            scattered,
            inverse_density,
            lanes,
            bsdf_samples,
            of_brdf,
            colours,
            weights,
        } = self;
        let masks = [lanes, of_brdf];
        weigh_points(
            &scattered.pdf,
            inverse_density,
            bsdf_samples,
            masks,
            weights,
        );
        replace(colours, &scattered.colour, lanes);
    }
}

#[inline(always)]
fn weigh_points(
    pdf: &Numbers,
    inverse_density: &Numbers,
    bsdf_samples: f64,
    [lanes, of_brdf]: [u32; 2],
    weights: &mut Numbers,
) {
    for lane in 0..LANES {
        let is_asked = lanes >> lane & 1 == 1;
        let has_other = of_brdf >> lane & 1 == 1;
        let other = if has_other {
            bsdf_samples * pdf[lane]
        } else {
            0.0
        };
        let weight = weight_over_density(inverse_density[lane], other);
        weights[lane] = if is_asked { weight } else { weights[lane] };
    }
}

/// Replaces those of some lanes.
#[inline(always)]
fn replace(all: &mut Vectors, new: &Vectors, lanes: u32) {
    for lane in 0..LANES {
        let is_asked = lanes >> lane & 1 == 1;
        let kept = all.get(lane);
        all.set(lane, if is_asked { new.get(lane) } else { kept });
    }
}

/// Weighs what is scattered at some lanes of light from directions drawn from the surfaces; one bit
/// for each whose density is positive.
pub struct WeighDrawn<'a> {
    pub scattered: &'a LaneScattered,
    pub lanes: u32,
    /// What is scattered over densities, and these.
    pub colours: &'a mut Vectors,
    pub pdf: &'a mut Numbers,
}

impl Computation for WeighDrawn<'_> {
    type Output = u32;
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> u32 {
        let Self {
            scattered,
            lanes,
            colours,
            pdf,
        } = self;
        weigh_drawn(scattered, lanes, colours, pdf);
        let mut drawn = 0;
        for (lane, pdf) in scattered.pdf.iter().enumerate() {
            drawn |= u32::from(*pdf > 0.0) << lane;
        }
        drawn & lanes
    }
}

#[inline(always)]
fn weigh_drawn(scattered: &LaneScattered, lanes: u32, colours: &mut Vectors, pdf: &mut Numbers) {
    for (lane, pdf) in pdf.iter_mut().enumerate() {
        let is_asked = lanes >> lane & 1 == 1;
        let own = scattered.pdf[lane];
        *pdf = if is_asked { own } else { *pdf };
        let (factor, kept) = (scattered.colour.get(lane) * (1.0 / own), colours.get(lane));
        colours.set(lane, if is_asked { factor } else { kept });
    }
}
