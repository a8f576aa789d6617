//! Film points beside silhouettes of smooth surfaces (METHOD 8).
//!
//! Where a smooth surface turns away from the camera, the point that a ray hits moves along the surface by `1 / cos θ`, with
//! `θ` the angle between the ray and the normal, and `cos θ` falls like the root of the distance `t` from the silhouette on
//! the film. So the derivative of what is seen there grows like `1 / √t`: it has an integral, but its square has none. Film
//! points that are drawn with a density in proportion to `1 / √t` see no large values.

use capwalk_boundary::beside;
use capwalk_geometry::{Edge, Mesh, Sides};
use capwalk_math::Vec3;
use capwalk_scene::sensor::view::View;

use crate::pixel::{DrawnPoint, Support};

/// The largest cosine between the camera's rays and both faces at an edge for which they count as a smooth surface that
/// turns away.
const GRAZING: f64 = 0.3;

/// Width of a strip, relative to the side of a support as large.
const WIDTH: f64 = 0.25;

/// Share of the film points that are drawn beside silhouettes in pixels that these cross.
const SHARE: f64 = 0.3;

/// The most strips of a pixel: the density of each film point is a sum over them. Where there would be more, there are none.
const MOST: usize = 64;

/// Strips of the film on the inner sides of silhouettes.
#[derive(Clone, Debug, Default)]
pub struct BesideSilhouettes {
    strips: Vec<Strip>,
    /// Of all strips, pixels.
    length: f64,
    /// Of each strip, pixels.
    width: f64,
    /// Side of a square as large as the support, pixels.
    side: f64,
}

/// A rectangle on the film at a piece of a silhouette.
#[derive(Clone, Copy, Debug)]
struct Strip {
    start: [f64; 2],
    /// The unit vectors along the silhouette and from it to the surface.
    along: [f64; 2],
    inward: [f64; 2],
    length: f64,
    /// Sum of the lengths of those before.
    before: f64,
}

impl BesideSilhouettes {
    /// None yet, in a pixel with this support.
    pub fn new(support: &Support) -> Self {
        let side = (support.sides[0].width() * support.sides[1].width()).sqrt();
        Self {
            width: WIDTH * side,
            side,
            ..Self::default()
        }
    }

    /// Adds the part of an edge in the support, from its first to its last offset from the camera, if it is a silhouette,
    /// and the two faces beside it are seen at grazing angles and lie in the support as well.
    pub fn push(
        &mut self,
        mesh: &Mesh,
        view: &View<f64>,
        support: &Support,
        edge: &Edge,
        [first, last]: [Vec3; 2],
    ) {
        let Sides::Between { faces, .. } = edge.sides else {
            return;
        };
        let ray = (first + last).normalized();
        let is_grazing = |&face: &u32| {
            let normal = mesh.face_cross(face as usize).normalized();
            normal.dot(ray).abs() < GRAZING
        };
        let [start, end] = [first, last].map(|offset| view.film(offset));
        let along = [end[0] - start[0], end[1] - start[1]];
        let length = along[0].hypot(along[1]);
        let is_seen = length > 0.0 && faces.iter().all(is_grazing);
        if !is_seen || !edge.is_silhouette(mesh, view.origin) {
            return;
        }
        // The surface is where the middle of a face is.
        let plane = first.cross(last).normalized();
        let [a, b, c] = mesh.corners(faces[0] as usize);
        let is_before = plane.dot(a + b + c - view.origin * 3.0) > 0.0;
        let [behind, before] = beside(ray, plane).map(|direction| view.film(direction));
        let along = along.map(|x| x / length);
        let across = [-along[1], along[0]];
        let is_across =
            (before[0] - behind[0]) * across[0] + (before[1] - behind[1]) * across[1] > 0.0;
        let inward = match is_before == is_across {
            true => across,
            false => across.map(|x| -x),
        };
        // Where the points of a strip have their median.
        let inside = [0, 1].map(|k| 0.5 * (start[k] + end[k]) + 0.25 * self.width * inward[k]);
        if support.contains(inside) {
            self.add(start, along, inward, length);
        }
    }

    /// Adds a strip from a film point in two unit directions.
    fn add(&mut self, start: [f64; 2], along: [f64; 2], inward: [f64; 2], length: f64) {
        // One more than are used says that there are too many.
        if self.strips.len() > MOST {
            return;
        }
        self.strips.push(Strip {
            start,
            along,
            inward,
            length,
            before: self.length,
        });
        self.length += length;
    }

    /// A film point: beside a silhouette or, as everywhere else, by the filter; `choice` decides. Beside a
    /// silhouette it may be outside of the support, where its weight is 0.
    pub fn sample(&self, support: &Support, choice: f64, [u, v]: [f64; 2]) -> DrawnPoint {
        if self.strips.is_empty() || self.strips.len() > MOST {
            return support.sample_by_filter([u, v]);
        }
        // A short silhouette is worth few film points, and one as short as rounding none, whose strip might not have them.
        let share = SHARE * (self.length / self.side).min(1.0);
        let place = match choice < share {
            true => self.draw(choice / share, [u, v]),
            false => support.sample(0.0, 0.0, [u, v]),
        };
        let weight = match support.contains(place) {
            true => {
                let density = share * self.density(place) + (1.0 - share) * support.pdf(0.0, place);
                support.weight(place) / density
            }
            false => 0.0,
        };
        DrawnPoint { place, weight }
    }

    /// A point on a strip, each in proportion to its length.
    fn draw(&self, choice: f64, [u, v]: [f64; 2]) -> [f64; 2] {
        let target = choice * self.length;
        let after = self.strips.partition_point(|strip| strip.before <= target);
        let strip = &self.strips[after.max(1) - 1];
        let (along, inward) = (v * strip.length, u * u * self.width);
        [0, 1].map(|k| strip.start[k] + along * strip.along[k] + inward * strip.inward[k])
    }

    /// The density of such points, per pixel area.
    fn density(&self, s: [f64; 2]) -> f64 {
        let of_strip = |strip: &Strip| {
            let offset = [0, 1].map(|k| s[k] - strip.start[k]);
            let dot = |v: [f64; 2]| offset[0] * v[0] + offset[1] * v[1];
            let (along, inward) = (dot(strip.along), dot(strip.inward));
            let is_inside =
                (0.0..=strip.length).contains(&along) && inward > 0.0 && inward <= self.width;
            match is_inside {
                true => 0.5 / (self.width * inward).sqrt(),
                false => 0.0,
            }
        };
        self.strips.iter().map(of_strip).sum::<f64>() / self.length
    }
}

#[cfg(test)]
mod tests {
    use capwalk_boundary::Stream;
    use capwalk_math::Moments;
    use capwalk_scene::{Film, Filter};

    use super::*;
    use crate::pixel::Supports;

    /// The means of the weight and of the weight times the point are 1 and the pixel's centre: film points have the density
    /// that is claimed, also where strips cross each other and leave the support, which is cut off for the last pixel.
    #[test]
    fn film_points_have_their_density() {
        for (filter, pixel) in [
            (Filter::Box, [2, 2]),
            (Filter::Gaussian { stddev: 0.5 }, [2, 2]),
            (Filter::Mitchell { b: 0.2, c: 0.4 }, [2, 2]),
            (Filter::Tent { radius: 1.0 }, [2, 4]),
        ] {
            let supports = Supports::new(&Film::new(5, 5, filter));
            let support = supports.pixel(pixel);
            let first = [2.1, f64::from(pixel[1]) + 0.3];
            let second = [2.6, f64::from(pixel[1]) + 0.2];
            let mut beside = BesideSilhouettes::new(&support);
            for (start, turn, length) in [(first, 0.3_f64, 0.7), (second, 1.9, 0.9)] {
                let (sin, cos) = turn.sin_cos();
                beside.add(start, [cos, sin], [-sin, cos], length);
            }
            let mut by_filter = [Moments::default(); 3];
            let mut means = [Moments::default(); 3];
            for number in 0..400_000 {
                let stream = Stream::independent(7, number);
                for (drawn, means) in [
                    (support.sample_by_filter(stream.pair(3)), &mut by_filter),
                    (
                        beside.sample(&support, stream.number(0), stream.pair(1)),
                        &mut means,
                    ),
                ] {
                    let numbers = [1.0, drawn.place[0] - 2.5, drawn.place[1] - first[1]];
                    let numbers = numbers.map(|x| drawn.weight * x);
                    means
                        .iter_mut()
                        .zip(numbers)
                        .for_each(|(mean, x)| mean.add(x));
                }
            }
            for (mean, expected) in means.iter().zip(by_filter) {
                let error = mean.standard_error().hypot(expected.standard_error());
                let z = (mean.mean - expected.mean) / error;
                assert!(z.abs() < 3.5, "{filter:?}: {z}");
            }
        }
    }
}
