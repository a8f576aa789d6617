//! The perspective camera, with Mitsuba's conventions.
//!
//! Camera space: `+z` looks forward, `+y` is up, `+x` points to the left of
//! the picture. A film point `(x, y)` in pixels looks along
//! `((1 - 2x'/w) t, (1 - 2y'/h) t h/w, 1)` with `t = tan(fov_x / 2)` and
//! `(x', y') = (x, y) + (w, h) · principal point offset`.

use capwalk_math::{Affine, Real, Vec3};

use crate::film::Film;
use crate::scene::SceneError;

/// A pinhole camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Perspective {
    /// Name, for parameters; `sensor` if none was given.
    pub id: String,
    /// Where it is and how it is turned; a rotation and a translation.
    pub world_from_camera: Affine,
    /// Horizontal field of view of the whole film, radians.
    pub fov_x: f64,
    /// Offset of the principal point from the centre of the film, in film
    /// widths and heights.
    pub principal_point_offset: [f64; 2],
    /// Depth (along the view axis) before which nothing is seen.
    pub near_clip: f64,
    /// Depth beyond which nothing is seen.
    pub far_clip: f64,
}

impl Perspective {
    /// Pixels per unit of `x / z` (the same along y) and the film point of the
    /// view axis.
    fn intrinsics(&self, film: &Film) -> (f64, [f64; 2]) {
        let [w, h] = film.size.map(f64::from);
        let focal = 0.5 * w / (0.5 * self.fov_x).tan();
        let [ox, oy] = self.principal_point_offset;
        (focal, [w * (0.5 - ox), h * (0.5 - oy)])
    }

    /// The film point at which a camera-space direction is seen, pixels.
    /// Meaningless for directions with `z <= 0`.
    pub fn film_from_camera<R: Real>(&self, film: &Film, d: Vec3<R>) -> [R; 2] {
        let (focal, [cx, cy]) = self.intrinsics(film);
        let scale = R::constant(-focal) / d.z;
        [R::constant(cx) + d.x * scale, R::constant(cy) + d.y * scale]
    }

    /// The unit camera-space direction of a film point.
    pub fn camera_from_film(&self, film: &Film, [x, y]: [f64; 2]) -> Vec3 {
        let (focal, [cx, cy]) = self.intrinsics(film);
        Vec3::new((cx - x) / focal, (cy - y) / focal, 1.0).normalized()
    }

    /// Film area (pixels²) per solid angle around a unit camera-space
    /// direction: `focal² / cos³`.
    pub fn film_area_per_solid_angle<R: Real>(&self, film: &Film, d: Vec3<R>) -> R {
        let (focal, _) = self.intrinsics(film);
        R::constant(focal * focal) / (d.z * d.z * d.z)
    }

    /// Where it stands, in world space.
    pub fn origin(&self) -> Vec3 {
        self.world_from_camera.translation
    }

    pub(crate) fn check(&self) -> Result<(), SceneError> {
        let bad = |name: &str, value: String, expected| {
            let name = format!("{}.{name}", self.id);
            Err(SceneError::BadNumber {
                name,
                value,
                expected,
            })
        };
        if !self.world_from_camera.is_rigid(RIGID) || !self.origin().is_finite() {
            return bad(
                "to_world",
                format!("{:?}", self.world_from_camera),
                "a rotation and a translation, without scale",
            );
        }
        if !(self.fov_x > 0.0 && self.fov_x < std::f64::consts::PI) {
            return bad(
                "fov",
                format!("{} degrees", self.fov_x.to_degrees()),
                "an angle between 0 and 180 degrees",
            );
        }
        if !(self.near_clip >= 0.0 && self.far_clip > self.near_clip) {
            return bad(
                "near_clip",
                format!("{} with far_clip {}", self.near_clip, self.far_clip),
                "0 <= near_clip < far_clip",
            );
        }
        if !self.principal_point_offset.iter().all(|x| x.is_finite()) {
            return bad(
                "principal_point_offset",
                format!("{:?}", self.principal_point_offset),
                "finite numbers",
            );
        }
        Ok(())
    }
}

/// Largest deviation of the inner products of a rotation's rows from those of
/// an orthonormal frame. The transpose serves as the inverse.
const RIGID: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::filter::Filter;
    use capwalk_math::Dual;

    fn example() -> (Perspective, Film) {
        let camera = Perspective {
            id: "sensor".into(),
            world_from_camera: Affine::IDENTITY,
            fov_x: 0.7,
            principal_point_offset: [0.1, -0.05],
            near_clip: 0.01,
            far_clip: 1e4,
        };
        (camera, Film::new(30, 20, Filter::Box))
    }

    /// Film to direction and back, and the area element against duals.
    #[test]
    fn projection_inverts_and_its_area_element_matches() {
        let (camera, film) = example();
        for point in [[0.0, 0.0], [15.0, 10.0], [27.3, 4.1]] {
            let d = camera.camera_from_film(&film, point);
            let back = camera.film_from_camera(&film, d);
            assert!((back[0] - point[0]).abs() < 1e-12 && (back[1] - point[1]).abs() < 1e-12);
            let frame = capwalk_math::Frame::from_normal(d);
            let moved = |axis: Vec3| camera.film_from_camera(&film, d.with_tangent(axis));
            let (s, t) = (moved(frame.s), moved(frame.t));
            let tangent = |x: Dual<1>| x.tangent[0];
            let area = tangent(s[0]) * tangent(t[1]) - tangent(s[1]) * tangent(t[0]);
            let expected = camera.film_area_per_solid_angle(&film, d);
            assert!((area.abs() / expected - 1.0).abs() < 1e-12);
        }
    }
}
