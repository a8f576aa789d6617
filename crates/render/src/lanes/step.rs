//! The steps of paths: loops over the lanes without a branch, compiled for the CPU's
//! vectors. Where they read and write arrays behind references they are functions: arguments that are
//! references are known to refer to different things, others would have to be copied.

use std::f64::consts::FRAC_1_PI;

use capwalk_boundary::Streams;
use capwalk_geometry::simd::{Computation, Simd};
use capwalk_math::{Frame, Rgb, Vec3};
use capwalk_scene::lobe::sample_cosine;
use capwalk_scene::sensor::view::View;

use crate::lanes::lit::Lit;
use crate::lanes::vectors::{LANES, Numbers, Vectors, fill};
use crate::light::NARROW;
use crate::triangle_sampler::Node;

/// Random numbers of consecutive dimensions.
pub struct RandomNumbers<'a, const K: usize> {
    pub streams: &'a Streams<LANES>,
    pub first: u32,
    /// One bit for each lane that needs them.
    pub lanes: u32,
    pub numbers: &'a mut [Numbers; K],
}

impl<const K: usize> Computation for RandomNumbers<'_, K> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        for (dimension, numbers) in (self.first..).zip(self.numbers) {
            *numbers = self.streams.numbers(dimension, self.lanes);
        }
    }
}

/// Rays through points of the film.
pub struct FilmRays<'a> {
    pub view: &'a View<f64>,
    pub film: &'a [Numbers; 2],
    pub vertices: &'a mut Vertices,
    /// Distances between which the rays meet something.
    pub range: &'a mut [Numbers; 2],
}

impl Computation for FilmRays<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        film_rays(self.view, self.film, self.vertices, self.range);
    }
}

#[inline(always)]
fn film_rays(
    view: &View<f64>,
    film: &[Numbers; 2],
    vertices: &mut Vertices,
    range: &mut [Numbers; 2],
) {
    for lane in 0..LANES {
        let direction = view.direction([film[0][lane], film[1][lane]]);
        let ray = view.ray(direction);
        vertices.origin.set(lane, ray.origin);
        vertices.direction.set(lane, ray.direction);
        (range[0][lane], range[1][lane]) = (ray.range[0], ray.range[1]);
    }
}

/// Sets the face that some lanes hit.
pub struct SetFace<'a> {
    pub corners: [Vec3; 3],
    pub lanes: u32,
    pub vertices: &'a mut Vertices,
}

impl Computation for SetFace<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            corners: [a, b, c],
            lanes,
            vertices,
        } = self;
        vertices.corner.fill(lanes, a.to_array());
        vertices.edges[0].fill(lanes, (b - a).to_array());
        vertices.edges[1].fill(lanes, (c - a).to_array());
    }
}

/// Sets the fraction of light that a side of diffuse surfaces reflects, 1 or -1, in some lanes.
pub struct SetDiffuse<'a> {
    pub reflectance: Rgb,
    pub side: f64,
    pub lanes: u32,
    pub vertices: &'a mut Vertices,
}

impl Computation for SetDiffuse<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            reflectance,
            side,
            lanes,
            vertices,
        } = self;
        vertices.scattered.fill(lanes, reflectance.to_array());
        fill(&mut vertices.side, lanes, side);
    }
}

/// Counts a ray of some lanes.
pub struct CountRays<'a> {
    pub rays: &'a mut [u64; LANES],
    pub lanes: u32,
}

impl Computation for CountRays<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        for (lane, rays) in self.rays.iter_mut().enumerate() {
            *rays += u64::from(self.lanes >> lane & 1);
        }
    }
}

/// Where paths hit surfaces.
#[derive(Clone, Copy, Debug)]
pub struct Vertices {
    /// The rays that led there.
    pub origin: Vectors,
    pub direction: Vectors,
    /// A corner of the face, and the edges from there to the others.
    pub corner: Vectors,
    pub edges: [Vectors; 2],
    /// The unit shading normal on the outside ([`Surfaces`] sets that of the face), and 1 or -1 for the
    /// side of it that is the front of the material that is seen.
    pub outward: Vectors,
    pub side: Numbers,
    /// Fractions of light that are reflected, where surfaces are diffuse; else what their lobes
    /// scatter of the light that was weighed last, over its density if it was drawn from them.
    pub scattered: Vectors,
    /// Where they are; the unit normal of the face by its winding, and 1 or -1 for the side of it
    /// that is seen; the weights of the second and third corner. Known after [`Surfaces`].
    pub position: Vectors,
    pub face_normal: Vectors,
    pub seen: Numbers,
    weights: [Numbers; 2],
}

impl Vertices {
    /// None yet.
    pub const NONE: Self = Self {
        origin: Vectors::ZERO,
        direction: Vectors::ZERO,
        corner: Vectors::ZERO,
        edges: [Vectors::ZERO; 2],
        outward: Vectors::UP,
        side: [1.0; LANES],
        scattered: Vectors::ZERO,
        position: Vectors::ZERO,
        face_normal: Vectors::UP,
        seen: [1.0; LANES],
        weights: [[0.0; LANES]; 2],
    };

    /// Weights of the corners.
    #[inline]
    pub fn barycentric(&self, lane: usize) -> [f64; 3] {
        let [wb, wc] = [0, 1].map(|i| self.weights[i][lane]);
        [1.0 - wb - wc, wb, wc]
    }

    /// The normal on the side of the front.
    #[inline(always)]
    pub fn normal(&self, lane: usize) -> Vec3 {
        self.outward.get(lane) * self.side[lane]
    }

    /// The shading frame, if it does not turn with texture coordinates.
    #[inline]
    pub fn frame(&self, lane: usize) -> Frame {
        Frame {
            n: self.normal(lane),
            ..Frame::from_normal(self.outward.get(lane))
        }
    }
}

/// Intersects the rays with the planes of the faces.
pub struct Surfaces<'a>(pub &'a mut Vertices);

impl Computation for Surfaces<'_> {
    /// One bit for each face whose normal by its winding is on the side that is seen.
    type Output = u32;
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> u32 {
        surfaces(self.0);
        let mut front = 0;
        for (lane, &seen) in self.0.seen.iter().enumerate() {
            front |= u32::from(seen > 0.0) << lane;
        }
        front
    }
}

#[inline(always)]
fn surfaces(vertices: &mut Vertices) {
    for lane in 0..LANES {
        let (origin, direction) = (vertices.origin.get(lane), vertices.direction.get(lane));
        let (corner, [ab, ac]) = (
            vertices.corner.get(lane),
            [vertices.edges[0].get(lane), vertices.edges[1].get(lane)],
        );
        let cross = ab.cross(ac);
        let squared = cross.length_squared();
        let rise = direction.dot(cross);
        let t = (corner - origin).dot(cross) / rise;
        let position = origin + direction * t;
        let offset = position - corner;
        vertices.position.set(lane, position);
        let normal = cross * (1.0 / squared.sqrt());
        vertices.face_normal.set(lane, normal);
        vertices.outward.set(lane, normal);
        vertices.seen[lane] = if rise > 0.0 { -1.0 } else { 1.0 };
        // Weights are the areas opposite to the corners.
        vertices.weights[0][lane] = offset.cross(ac).dot(cross) / squared;
        vertices.weights[1][lane] = ab.cross(offset).dot(cross) / squared;
    }
}

/// One bit for each vertex from which the emitter is seen so narrow that points on it are enough.
pub struct Narrow<'a> {
    pub vertices: &'a Vertices,
    /// All triangles of the emitter.
    pub emitter: &'a Node,
}

impl Computation for Narrow<'_> {
    type Output = u32;
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> u32 {
        let Self { vertices, emitter } = self;
        let mut solid_angles = [0.0; LANES];
        for (lane, solid_angle) in solid_angles.iter_mut().enumerate() {
            *solid_angle = emitter.seen(vertices.position.get(lane));
        }
        let mut narrow = 0;
        for (lane, solid_angle) in solid_angles.into_iter().enumerate() {
            narrow |= u32::from(solid_angle < NARROW) << lane;
        }
        narrow
    }
}

/// The power heuristic's weight of a direction drawn towards an emitter, over its density, of
/// which the inverse is given; `other` is the density with which else it is drawn.
#[inline(always)]
pub fn weight_over_density(inverse: f64, other: f64) -> f64 {
    let ratio = other * inverse;
    inverse / (1.0 + ratio * ratio)
}

/// Weighs directions towards emitters where surfaces are diffuse.
pub struct WeighDiffuse<'a> {
    pub vertices: &'a Vertices,
    pub lit: &'a mut Lit,
    /// Directions that are drawn from each surface that draws some, and one bit for each of those.
    pub bsdf_samples: f64,
    pub of_brdf: u32,
}

impl Computation for WeighDiffuse<'_> {
    /// One bit for each direction that comes from behind.
    type Output = u32;
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> u32 {
        let Self {
            vertices,
            lit,
            bsdf_samples,
            of_brdf,
        } = self;
        let cosines = weigh_diffuse(vertices, lit, bsdf_samples, of_brdf);
        let mut behind = 0;
        for (lane, cos) in cosines.into_iter().enumerate() {
            // What is not a number is not dark: the pixel counts it.
            behind |= u32::from(cos <= 0.0) << lane;
        }
        behind
    }
}

#[inline(always)]
fn weigh_diffuse(vertices: &Vertices, lit: &mut Lit, bsdf_samples: f64, of_brdf: u32) -> Numbers {
    let mut cosines = [0.0; LANES];
    for (lane, cosine) in cosines.iter_mut().enumerate() {
        let cos = lit.direction.get(lane).dot(vertices.normal(lane));
        let has_other = of_brdf >> lane & 1 == 1;
        let other = if has_other {
            bsdf_samples * cos * FRAC_1_PI
        } else {
            0.0
        };
        lit.weight[lane] = cos * FRAC_1_PI * weight_over_density(lit.inverse_density[lane], other);
        *cosine = cos;
    }
    cosines
}

/// Adds light from emitters to what some paths bring: the product of their throughputs, of what
/// is scattered, its weights, and the radiance.
pub struct SumLight<'a> {
    pub light: &'a mut Vectors,
    pub throughput: &'a Vectors,
    pub scattered: &'a Vectors,
    pub weight: &'a Numbers,
    pub radiance: &'a Vectors,
    pub lanes: u32,
}

impl Computation for SumLight<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            light,
            throughput,
            scattered,
            weight,
            radiance,
            lanes,
        } = self;
        for axis in 0..3 {
            let [throughput, scattered, radiance] =
                [throughput, scattered, radiance].map(|v| &v.0[axis]);
            sum_light(
                &mut light.0[axis],
                throughput,
                scattered,
                weight,
                radiance,
                lanes,
            );
        }
    }
}

#[inline(always)]
fn sum_light(
    light: &mut Numbers,
    throughput: &Numbers,
    scattered: &Numbers,
    weight: &Numbers,
    radiance: &Numbers,
    lanes: u32,
) {
    for lane in 0..LANES {
        let more = throughput[lane] * (scattered[lane] * weight[lane] * radiance[lane]);
        let is_asked = lanes >> lane & 1 == 1;
        // What is not a number must not get into sums of lanes that are not asked.
        light[lane] += if is_asked { more } else { 0.0 };
    }
}

/// Directions drawn from surfaces.
#[derive(Clone, Copy, Debug)]
pub struct Brdf {
    pub direction: Vectors,
    /// Directions drawn by the cosine, around the third axis.
    pub local: Vectors,
    /// The densities with which they are drawn.
    pub pdf: Numbers,
    /// One bit for each that comes from a specular event, which has no density.
    pub specular: u32,
}

impl Default for Brdf {
    fn default() -> Self {
        Self {
            direction: Vectors::UP,
            local: Vectors::UP,
            pdf: [0.0; LANES],
            specular: 0,
        }
    }
}

/// Draws directions by the cosine, for surfaces that are diffuse or have a diffuse base.
pub struct Draw<'a> {
    pub vertices: &'a Vertices,
    pub u: &'a [Numbers; 2],
    pub drawn: &'a mut Brdf,
}

impl Computation for Draw<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        self.drawn.specular = 0;
        draw(self.vertices, self.u, self.drawn);
    }
}

#[inline(always)]
fn draw(vertices: &Vertices, [first, second]: &[Numbers; 2], drawn: &mut Brdf) {
    for (lane, (&first, &second)) in first.iter().zip(second).enumerate() {
        let frame = Frame::from_normal(vertices.outward.get(lane));
        let wo = sample_cosine([first, second]);
        let up = frame.n * (vertices.side[lane] * wo.z);
        let direction = (frame.s * wo.x + frame.t * wo.y + up).normalized();
        drawn.direction.set(lane, direction);
        drawn.local.set(lane, wo);
        drawn.pdf[lane] = wo.z * FRAC_1_PI;
    }
}

#[cfg(test)]
mod tests {
    use capwalk_boundary::Sampler;
    use capwalk_geometry::simd::Instructions;
    use capwalk_math::Affine;
    use capwalk_scene::builtin;
    use capwalk_scene::primitive::rectangle;

    use super::*;
    use crate::lanes::vectors::ALL;
    use crate::light::power_heuristic;
    use crate::prepared::PreparedScene;
    use crate::triangle_sampler::TriangleSampler;

    /// Points between -2 and 2.
    fn points() -> impl Iterator<Item = Vectors> {
        let number = |i: usize, k: f64| 4.0 * (i as f64 * k).fract() - 2.0;
        (0..50).map(move |i| {
            let mut points = Vectors::ZERO;
            for lane in 0..LANES {
                let [x, y, z] = [0.618_034, 0.414_214, 0.259_921].map(|k| number(16 * i + lane, k));
                points.set(lane, Vec3::new(x, y, z));
            }
            points
        })
    }

    #[test]
    fn rays_are_those_of_the_view() {
        let scene = builtin::scene("box-room").expect("built in");
        let sampler = Sampler::new(&scene.settings, 3, 64);
        let mut streams = Streams::splat(sampler.stream(7, 0));
        streams.set(0..LANES, &sampler.in_pixel(7), 0);
        let prepared = PreparedScene::new(scene);
        let view = &prepared.accel().view;
        let instructions = Instructions::detect();
        let mut film = [[0.0; LANES]; 2];
        instructions.run(RandomNumbers {
            streams: &streams,
            first: 4,
            lanes: ALL,
            numbers: &mut film,
        });
        let (mut vertices, mut range) = (Vertices::NONE, [[0.0; LANES]; 2]);
        instructions.run(FilmRays {
            view,
            film: &film,
            vertices: &mut vertices,
            range: &mut range,
        });
        for lane in 0..LANES {
            let s = sampler.stream(7, lane as u32).pair(4);
            let expected = view.ray(view.direction(s));
            assert_eq!(vertices.origin.get(lane), expected.origin);
            assert_eq!(vertices.direction.get(lane), expected.direction);
            assert_eq!(range.map(|range| range[lane]), expected.range);
        }
    }

    /// Around the emitter, where it is wide, narrow, and seen from behind.
    #[test]
    fn narrow_emitters_are_those_of_the_sampler() {
        let (mesh, _) = rectangle(Affine::scale(Vec3::splat(0.9)));
        let sampler = TriangleSampler::new(&mesh);
        let mut counts = [0; 2];
        for position in points() {
            let mut vertices = Vertices::NONE;
            vertices.position = position;
            let narrow = Instructions::detect().run(Narrow {
                vertices: &vertices,
                emitter: sampler.root(),
            });
            for lane in 0..LANES {
                let expected = sampler.solid_angle(position.get(lane)) < NARROW;
                assert_eq!(narrow >> lane & 1 == 1, expected);
                counts[usize::from(expected)] += 1;
            }
        }
        assert!(counts[0] > 5 && counts[1] > 5, "{counts:?}");
    }

    /// Only lanes that are asked for get light, whatever is in the others.
    #[test]
    fn light_is_gathered_lane_by_lane() {
        let all: Vec<Vectors> = points().take(3).collect();
        let [before, throughput, mut scattered] = all[..] else {
            unreachable!("there are three");
        };
        scattered.set(1, Vec3::splat(f64::NAN));
        let (colour, lanes) = (Rgb::new(15.0, 14.0, 12.0), 0b1010_1100_0101_1101);
        let radiance = Vectors::splat(colour.to_array());
        let weight = std::array::from_fn(|lane| 0.1 * lane as f64);
        let mut light = before;
        Instructions::detect().run(SumLight {
            light: &mut light,
            throughput: &throughput,
            scattered: &scattered,
            weight: &weight,
            radiance: &radiance,
            lanes,
        });
        for (lane, &weight) in weight.iter().enumerate() {
            let reflected = scattered.colour(lane) * weight * colour;
            let lit = before.colour(lane) + throughput.colour(lane) * reflected;
            let is_asked = lanes >> lane & 1 == 1;
            let expected = if is_asked { lit } else { before.colour(lane) };
            assert_eq!(light.colour(lane), expected, "{lane}");
        }
    }

    #[test]
    fn weights_are_those_of_the_power_heuristic() {
        for solid_angle in [1e-9, 0.3, 2.0, 6.0] {
            for pdf in [0.0, 1e-3, 0.4, 7.0, 1e9] {
                let own = 1.0 / solid_angle;
                let close = |a: f64, b: f64| (a - b).abs() <= 1e-14 * b;
                let expected = power_heuristic(own, pdf) / own;
                assert!(close(weight_over_density(solid_angle, pdf), expected));
            }
        }
    }
}
