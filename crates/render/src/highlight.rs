//! Where a glossy material scatters most of its light to, as far as sampling weights use it.

use capwalk_geometry::add_effort;
use capwalk_math::Vec3;

use crate::vertex::Vertex;

/// The least peak, BSDF times cosine, that is worth the time: that of GGX of a roughness of a
/// tenth or so. A white diffuse material has 0.32.
const BRIGHT: f64 = 10.0;
/// The least that is scattered beside it, as a guess, over the cosine.
const LEAST: f64 = 0.01;
/// The effort of BSDF and cosine in one direction.
const EFFORT: u64 = 4;

/// The highlight of a glossy vertex: around the direction of a mirror.
#[derive(Clone, Copy, Debug)]
pub struct Highlight {
    mirror: Vec3,
    /// BSDF times cosine in that direction.
    peak: f64,
    /// What is scattered to elsewhere, over the cosine.
    base: f64,
}

impl Highlight {
    /// The highlight of a vertex; `None` if it is not bright, if the material transmits light, and if
    /// its lobes have normals of their own.
    pub fn of(vertex: &Vertex<f64>) -> Option<Self> {
        if vertex.bsdf.is_diffuse() || vertex.transmits || vertex.bsdf.is_tilted() {
            return None;
        }
        add_effort(2 * EFFORT);
        let (wi, frame) = (vertex.wi, &vertex.frame);
        let mirror = frame.to_world(Vec3::new(-wi.x, -wi.y, wi.z.abs()));
        let [peak, base] = [mirror, frame.n].map(|q| vertex.eval(q).max_component());
        let base = base.max(LEAST);
        (peak > BRIGHT).then_some(Self { mirror, peak, base })
    }

    /// About the largest BSDF times cosine of light that comes from a ball, of the vertex that
    /// this is the highlight of: in the direction to the ball that is closest to the mirror's,
    /// or where the cosine is largest, `cosine`. 0 only if that is.
    pub fn largest(&self, vertex: &Vertex<f64>, centre: Vec3, radius: f64, cosine: f64) -> f64 {
        if cosine == 0.0 {
            return 0.0;
        }
        let offset = centre - vertex.position;
        let distance = offset.length();
        let towards = offset / distance;
        let cos = towards.dot(self.mirror);
        let sin_ball = radius / distance;
        let cos_ball = (1.0 - sin_ball * sin_ball).max(0.0).sqrt();
        let in_highlight = match distance <= radius || cos >= cos_ball {
            true => self.peak,
            false => {
                add_effort(EFFORT);
                let across = self.mirror.reject_from(towards).normalized();
                let closest = towards * cos_ball + across * sin_ball;
                vertex.eval(closest).max_component()
            }
        };
        // Opposite to the mirror's direction, that is not a number, which `max` leaves out.
        (self.base * cosine).max(in_highlight)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use capwalk_math::{Frame, Rgb, sphere};
    use capwalk_scene::lobe::{
        Diffuse, Distribution, Lobe, LocalBsdf, Microfacets, RoughConductor,
    };

    use super::*;

    fn vertex(bsdf: LocalBsdf) -> Vertex<f64> {
        let normal = Vec3::new(0.2, -0.3, 0.9).normalized();
        let frame = Frame::from_normal(normal);
        let wi = frame.to_world(Vec3::new(0.6, 0.1, 0.5).normalized());
        Vertex::new(Vec3::new(1.0, 2.0, 3.0), 0, normal, frame, wi, bsdf)
    }

    fn metal(alpha: f64) -> LocalBsdf {
        LocalBsdf::from(Lobe::RoughConductor(RoughConductor {
            microfacets: Microfacets::isotropic(Distribution::Ggx, alpha),
            eta: Rgb::splat(0.0),
            k: Rgb::splat(1.0),
            specular_reflectance: Rgb::splat(0.8),
        }))
    }

    /// The largest of many directions to balls, wide and narrow, in the highlight and beside it, is
    /// neither under- nor, of narrow balls, overestimated by much.
    #[test]
    fn guesses_are_near_the_largest() {
        for (alpha, paint) in [(0.03, 0.0), (0.05, 0.0), (0.08, 0.0), (0.05, 0.5)] {
            let mut bsdf = metal(alpha);
            let reflectance = Rgb::splat(paint);
            bsdf.push(1.0, Lobe::Diffuse(Diffuse { reflectance }));
            let vertex = vertex(bsdf);
            let highlight = Highlight::of(&vertex).expect("glossy");
            let mut narrow = 0;
            for i in 0..400 {
                let [x, y, z] =
                    [0.618_034, 0.896_556, 0.754_878].map(|k| (f64::from(i) * k).fract());
                // Half of them around the mirror's direction, all from a degree to much.
                let (around, reach) = match i % 2 {
                    0 => (vertex.frame, FRAC_PI_2),
                    _ => (Frame::from_normal(highlight.mirror), 4.0 * alpha),
                };
                let towards = around.to_world(sphere::sample_cap(reach, [x, y]));
                let angle = 0.01 * 100f64.powf(z);
                let (centre, radius) = (vertex.position + towards * 3.0, 3.0 * angle.sin());
                let cosine = vertex.receiver().largest_cosine(centre, radius);
                let found = highlight.largest(&vertex, centre, radius, cosine);
                let around = Frame::from_normal(towards);
                let largest = (0..2000)
                    .map(|k| [0.754_878, 0.569_84].map(|s| (f64::from(k) * s).fract()))
                    .map(|u| vertex.eval(around.to_world(sphere::sample_cap(angle, u))))
                    .fold(0.0, |largest, f| f.max_component().max(largest));
                let what = format!("{alpha}, {paint}, {i}: {found}, really {largest}");
                assert!(found >= 0.5 * largest, "{what}");
                if angle < 0.5 * alpha {
                    narrow += 1;
                    assert!(found <= 1.5 * largest + 2.0 * LEAST, "{what}");
                }
                assert!(found > 0.0 || cosine == 0.0, "{what}");
            }
            assert!(narrow > 20, "{narrow} balls are narrow");
        }
    }

    /// Rough metal scatters to all directions nearly alike, as a diffuse material does.
    #[test]
    fn flat_materials_have_none() {
        let reflectance = Rgb::splat(0.9);
        let diffuse = LocalBsdf::from(Lobe::Diffuse(Diffuse { reflectance }));
        assert!(Highlight::of(&vertex(diffuse)).is_none());
        assert!(Highlight::of(&vertex(metal(0.7))).is_none());
    }
}
