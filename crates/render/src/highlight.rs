//! Where a glossy material scatters most of its light to, as far as sampling weights know.

use capwalk_math::Vec3;

use crate::vertex::Vertex;

/// What a highlight scatters at least beside its peak, as a guess, over the cosine.
const LEAST: f64 = 0.01;
/// Materials that scatter no more than this, BSDF times cosine, scatter to all directions nearly
/// alike: a white diffuse one has 0.32.
const FLAT: f64 = 1.0;

/// The highlight of a glossy vertex: around the direction of a mirror.
#[derive(Clone, Copy, Debug)]
pub struct Highlight {
    mirror: Vec3,
    /// BSDF times cosine in that direction.
    peak: f64,
}

impl Highlight {
    /// That of a vertex; `None` if it scatters to all directions nearly alike. The same where
    /// others are not looked for: behind what transmits light, and about normals of lobes.
    pub fn of(vertex: &Vertex<f64>) -> Option<Self> {
        if vertex.bsdf.is_diffuse() || vertex.transmits || vertex.bsdf.is_tilted() {
            return None;
        }
        let wi = vertex.wi;
        let mirror = vertex.frame.to_world(Vec3::new(-wi.x, -wi.y, wi.z));
        let peak = vertex.eval(mirror).max_component();
        (peak > FLAT).then_some(Self { mirror, peak })
    }

    /// About the largest BSDF times cosine of light that comes from a ball, of the vertex that
    /// this is the highlight of: in the direction to the ball that is closest to the mirror's.
    /// `cosine` is the largest one; 0 only if that is.
    pub fn largest(&self, vertex: &Vertex<f64>, centre: Vec3, radius: f64, cosine: f64) -> f64 {
        let offset = centre - vertex.position;
        let distance = offset.length();
        let towards = offset / distance;
        let cos = towards.dot(self.mirror);
        let sin_ball = radius / distance;
        let cos_ball = (1.0 - sin_ball * sin_ball).max(0.0).sqrt();
        let scattered = match distance <= radius || cos >= cos_ball {
            true => self.peak,
            false => {
                let across = self.mirror.reject_from(towards).normalized();
                let closest = towards * cos_ball + across * sin_ball;
                // Not a number opposite to the mirror's direction.
                vertex.eval(closest).max_component().max(0.0)
            }
        };
        scattered + LEAST * cosine
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
        Vertex::new(Vec3::new(1.0, 2.0, 3.0), normal, frame, wi, bsdf)
    }

    fn metal(alpha: f64) -> LocalBsdf {
        LocalBsdf::from(Lobe::RoughConductor(RoughConductor {
            microfacets: Microfacets::isotropic(Distribution::Ggx, alpha),
            eta: Rgb::splat(0.0),
            k: Rgb::splat(1.0),
            specular_reflectance: Rgb::splat(0.8),
        }))
    }

    /// The largest of many directions to balls, near and far, wide and narrow, is not
    /// underestimated by much, and of narrow balls it is not overestimated.
    #[test]
    fn guesses_are_near_the_largest() {
        for alpha in [0.03, 0.1, 0.2] {
            let vertex = vertex(metal(alpha));
            let highlight = Highlight::of(&vertex).expect("glossy");
            let mut narrow = 0;
            for i in 0..200 {
                let [x, y, z] =
                    [0.618_034, 0.381_966 * 1.3, 0.754_878].map(|k| (f64::from(i) * k).fract());
                let towards = vertex.frame.to_world(sphere::sample_cap(FRAC_PI_2, [x, y]));
                // From a degree to half of all directions.
                let angle = 0.02 * 60f64.powf(z);
                let (centre, radius) = (vertex.position + towards * 3.0, 3.0 * angle.sin());
                let cosine = vertex.largest_cosine(centre, radius);
                let found = highlight.largest(&vertex, centre, radius, cosine);
                let around = Frame::from_normal(towards);
                let largest = (0..2000)
                    .map(|k| [0.754_878, 0.569_84].map(|s| (f64::from(k) * s).fract()))
                    .map(|u| vertex.eval(around.to_world(sphere::sample_cap(angle, u))))
                    .fold(0.0, |largest, f| f.max_component().max(largest));
                assert!(found >= 0.5 * largest, "{alpha}, {i}: {found} < {largest}");
                if angle < 0.3 * alpha {
                    narrow += 1;
                    assert!(
                        found <= 1.2 * largest + LEAST,
                        "{alpha}, {i}: {found} > {largest}"
                    );
                }
            }
            assert!(alpha < 0.1 || narrow > 10, "{narrow} balls are narrow");
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
