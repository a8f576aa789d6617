//! What a sensor sees from one point of its lens.
//!
//! Film points are in pixels. Seen from the origin of camera space, the film
//! point `(x, y)` looks along
//!
//! ```text
//! ((c_x - x) / f, (c_y - y) / f, 1)
//! ```
//!
//! with `f = w / (2 tan(fov_x / 2))` and `c` the film point of the view axis.
//! Through the point `l` of a lens it looks at the same point of the plane in
//! focus, at depth `F`: its direction `d` fulfils `x = c_x - f (l_x / F + d_x /
//! d_z)`. So a lens is a camera for each of its points, which differ in where
//! they are and in `c`.
//!
//! Parallel rays have no point that all of them start from. There, "directions"
//! are those of image space, in which the film point `(x, y)` lies in the
//! direction above with `f = w / 2`: the camera-space point `(X, Y, Z)` is seen
//! along `(X, Y, 1)`. Mapped so, straight edges stay straight, points divide them
//! as before, and all rays meet in the origin of image space; depths are lost.

use capwalk_math::{Real, Vec3};

use super::{Optic, Sensor, SensorModel, SensorState};
use crate::film::Film;

/// A sensor that looks from one point of its lens.
#[derive(Clone, Copy, Debug)]
pub struct View<R> {
    /// World-space position of that point; of the camera if rays are parallel.
    pub origin: Vec3<R>,
    axes: [Vec3<R>; 3],
    /// Rows of the linear part of `camera_from_world`.
    rows: [Vec3<R>; 3],
    /// World-space volume of the unit cube of camera space.
    volume: R,
    is_parallel: bool,
    /// Pixels per unit of `x / z` (the same along y).
    focal: R,
    /// Film point of the view axis.
    centre: [R; 2],
    /// Depths of the clip planes.
    clip: [f64; 2],
}

/// Where a film point looks.
#[derive(Clone, Copy, Debug)]
pub struct ViewRay<R> {
    /// Where the ray starts.
    pub origin: Vec3<R>,
    /// Its unit direction.
    pub direction: Vec3<R>,
    /// Distances along it between which something is seen.
    pub range: [f64; 2],
}

impl<R: Real> ViewRay<R> {
    /// The ray without its derivative.
    pub fn value(&self) -> ViewRay<f64> {
        ViewRay {
            origin: self.origin.value(),
            direction: self.direction.value(),
            range: self.range,
        }
    }
}

impl Sensor {
    /// What it sees from the middle of its lens.
    pub fn view(&self, film: &Film) -> View<f64> {
        View::new(self, film, &self.state(), [0.0; 2])
    }
}

impl<R: Real> View<R> {
    /// The view from the point of the lens that `lens` is on the unit disk.
    /// `state` holds the numbers of the sensor.
    pub fn new(sensor: &Sensor, film: &Film, state: &SensorState<R>, lens: [f64; 2]) -> Self {
        let [w, h] = film.size.map(f64::from);
        let half_width = R::constant(0.5 * w);
        let focal = || {
            let half = state.optics[Optic::FovX as usize] * R::constant(0.5);
            let (sin, cos) = half.sin_cos();
            half_width * cos / sin
        };
        let middle = [0.5 * w, 0.5 * h].map(R::constant);
        let mut origin = state.origin;
        let (focal, centre) = match sensor.model {
            SensorModel::Orthographic => (half_width, middle),
            SensorModel::Perspective {
                principal_point_offset: [x, y],
                ..
            } => (focal(), [w * (0.5 - x), h * (0.5 - y)].map(R::constant)),
            SensorModel::ThinLens { .. } => {
                let [x, y] =
                    lens.map(|l| state.optics[Optic::ApertureRadius as usize] * R::constant(l));
                origin += state.axes[0] * x + state.axes[1] * y;
                let focal = focal();
                let shift = focal / state.optics[Optic::FocusDistance as usize];
                (focal, [middle[0] - x * shift, middle[1] - y * shift])
            }
        };
        let [a, b, c] = state.axes;
        let volume = a.dot(b.cross(c));
        let is_parallel = sensor.model == SensorModel::Orthographic;
        Self {
            origin,
            axes: state.axes,
            rows: [b.cross(c), c.cross(a), a.cross(b)].map(|row| row / volume),
            volume,
            is_parallel,
            focal,
            centre,
            clip: match is_parallel {
                false => [sensor.near_clip, sensor.far_clip],
                true => {
                    let near = sensor.near_clip * c.value().length();
                    [near, near + (sensor.far_clip - sensor.near_clip)]
                }
            },
        }
    }

    /// This view without derivatives.
    pub fn value(&self) -> View<f64> {
        self.map(R::value)
    }

    /// This view with `f` of each number.
    pub fn map<S: Real>(&self, f: impl Fn(R) -> S) -> View<S> {
        let vector = |v: Vec3<R>| Vec3::from(v.to_array().map(&f));
        View {
            origin: vector(self.origin),
            axes: self.axes.map(vector),
            rows: self.rows.map(vector),
            volume: f(self.volume),
            is_parallel: self.is_parallel,
            focal: f(self.focal),
            centre: self.centre.map(&f),
            clip: self.clip,
        }
    }

    /// True if it certainly has no derivative.
    pub fn is_constant(&self) -> bool {
        let vectors = [self.origin, self.axes[0], self.axes[1], self.axes[2]];
        let numbers = [self.focal, self.centre[0], self.centre[1]];
        vectors.iter().all(|v| v.is_constant()) && numbers.iter().all(|x| x.is_constant())
    }

    /// True if all rays have the same direction.
    pub fn is_parallel(&self) -> bool {
        self.is_parallel
    }

    /// World-space images of the camera's axes.
    pub fn axes(&self) -> [Vec3<R>; 3] {
        self.axes
    }

    /// Side of a pixel at depth 1.
    pub fn pixel_size(&self) -> R {
        R::constant(1.0) / self.focal
    }

    /// The film point of the view axis.
    pub fn axis_point(&self) -> [R; 2] {
        self.centre
    }

    fn camera_from_world(&self, v: Vec3<R>) -> Vec3<R> {
        let [a, b, c] = self.rows;
        Vec3::new(a.dot(v), b.dot(v), c.dot(v))
    }

    /// A direction in the space in which film points look along `(.., .., 1)`.
    fn local(&self, direction: Vec3<R>) -> Vec3<R> {
        match self.is_parallel {
            true => direction,
            false => self.camera_from_world(direction),
        }
    }

    /// The film point that looks in a direction (of any length). Meaningless
    /// for directions that point backwards.
    pub fn film(&self, direction: Vec3<R>) -> [R; 2] {
        let d = self.local(direction);
        let scale = self.focal / d.z;
        [self.centre[0] - d.x * scale, self.centre[1] - d.y * scale]
    }

    /// Film area (pixels²) per solid angle around a unit direction.
    pub fn film_area_per_solid_angle(&self, direction: Vec3<R>) -> R {
        let d = self.local(direction);
        let area = self.focal.squared() / (d.z * d.z * d.z);
        match self.is_parallel {
            true => area,
            false => area / self.volume.abs(),
        }
    }

    /// The direction (of any length) in which a world-space point is seen.
    pub fn towards(&self, point: Vec3<R>) -> Vec3<R> {
        let offset = point - self.origin;
        match self.is_parallel {
            true => {
                let Vec3 { x, y, .. } = self.camera_from_world(offset);
                Vec3::new(x, y, R::constant(1.0))
            }
            false => offset,
        }
    }

    /// The unit direction in which a film point looks.
    #[inline(always)]
    pub fn direction(&self, [x, y]: [R; 2]) -> Vec3<R> {
        let [cx, cy] = self.centre;
        let scale = R::constant(1.0) / self.focal;
        let (x, y) = ((cx - x) * scale, (cy - y) * scale);
        match self.is_parallel {
            true => Vec3::new(x, y, R::constant(1.0)).normalized(),
            false => (self.axes[0] * x + self.axes[1] * y + self.axes[2]).normalized(),
        }
    }

    /// The ray in a unit direction.
    #[inline(always)]
    pub fn ray(&self, direction: Vec3<R>) -> ViewRay<R> {
        if self.is_parallel {
            let [left, up, forward] = self.axes;
            let [x, y] = [direction.x / direction.z, direction.y / direction.z];
            return ViewRay {
                origin: self.origin + left * x + up * y,
                direction: forward.normalized(),
                range: self.clip,
            };
        }
        let per_depth = 1.0 / self.rows[2].value().dot(direction.value());
        ViewRay {
            origin: self.origin,
            direction,
            range: self.clip.map(|clip| clip * per_depth),
        }
    }
}

impl View<f64> {
    /// The view from another point of the lens, for rays; the film stays.
    pub fn from(&self, origin: Vec3) -> Self {
        Self { origin, ..*self }
    }

    /// A world-space point in camera space.
    pub fn place(&self, point: Vec3) -> Vec3 {
        self.camera_from_world(point - self.origin)
    }

    /// With parallel rays, the velocity of [`View::towards`] for that of a point
    /// against the camera.
    pub fn image_velocity(&self, relative: Vec3) -> Vec3 {
        let Vec3 { x, y, .. } = self.camera_from_world(relative);
        Vec3::new(x, y, 0.0)
    }

    /// The transpose of [`View::image_velocity`].
    pub fn pull_image_velocity(&self, covector: Vec3) -> Vec3 {
        self.rows[0] * covector.x + self.rows[1] * covector.y
    }

    /// Depth of a world-space point, to be compared with [`View::clip`].
    pub fn depth(&self, point: Vec3) -> f64 {
        let depth = self.rows[2].dot(point - self.origin);
        match self.is_parallel {
            true => depth * self.axes[2].length(),
            false => depth,
        }
    }

    /// A point of the near plane and a normal of it, of any length, that points away from the
    /// camera. Only for rays that are not parallel.
    pub fn near_plane(&self) -> [Vec3; 2] {
        [self.origin + self.axes[2] * self.clip[0], self.rows[2]]
    }

    /// Normals, of any length, of the planes through the camera between which film points from `low` to
    /// `high` look; they point inwards. Only for rays that are not parallel.
    pub fn side_planes(&self, low: [f64; 2], high: [f64; 2]) -> [Vec3; 4] {
        let [x, y, z] = self.rows;
        let slope = |axis: usize, film: f64| (self.centre[axis] - film) / self.focal;
        [
            z * slope(0, low[0]) - x,
            x - z * slope(0, high[0]),
            z * slope(1, low[1]) - y,
            y - z * slope(1, high[1]),
        ]
    }

    /// Depths of the near and the far plane.
    pub fn clip(&self) -> [f64; 2] {
        self.clip
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::filter::Filter;
    use capwalk_math::{Affine, Dual, Frame};

    fn sensors() -> (Vec<Sensor>, Film) {
        let models = [
            SensorModel::Perspective {
                fov_x: 0.7,
                principal_point_offset: [0.1, -0.05],
            },
            SensorModel::ThinLens {
                fov_x: 0.9,
                aperture_radius: 0.3,
                focus_distance: 2.5,
            },
            SensorModel::Orthographic,
        ];
        let place = Affine::translate(Vec3::new(0.3, -1.0, 0.5))
            * Affine::rotate(Vec3::new(1.0, 2.0, 0.5), 0.8)
            * Affine::scale(Vec3::new(1.2, -0.7, 1.4));
        let sensor = |model| Sensor {
            id: "sensor".into(),
            world_from_camera: place,
            model,
            near_clip: 0.01,
            far_clip: 1e4,
        };
        (models.map(sensor).to_vec(), Film::new(30, 20, Filter::Box))
    }

    /// Film to direction and back, the area element against duals, and points
    /// on the ray are seen where it starts.
    #[test]
    fn projection_inverts_and_its_area_element_matches() {
        let (sensors, film) = sensors();
        for sensor in sensors {
            for lens in [[0.0, 0.0], [0.6, -0.3]] {
                let view = View::new(&sensor, &film, &sensor.state(), lens);
                let constant = sensor.moving_state(&Default::default());
                let moving = View::new(&sensor, &film, &constant, lens);
                for point in [[0.0, 0.0], [15.0, 10.0], [27.3, 4.1]] {
                    let is_point = |[x, y]: [f64; 2]| {
                        (x - point[0]).abs() < 1e-12 && (y - point[1]).abs() < 1e-12
                    };
                    let d = view.direction(point);
                    assert!(is_point(view.film(d)));
                    let ray = view.ray(d);
                    let at = |t: f64| ray.origin + ray.direction * t;
                    assert!(is_point(view.film(view.towards(at(3.7)))));
                    let [near, far] = ray.range.map(|t| view.depth(at(t)));
                    let [low, high] = view.clip();
                    assert!((near - low).abs() < 1e-12 && (far - high).abs() < 1e-8);

                    let frame = Frame::from_normal(d);
                    let moved = |axis: Vec3| moving.film(d.with_tangent(axis));
                    let (s, t) = (moved(frame.s), moved(frame.t));
                    let tangent = |x: Dual<1>| x.tangent[0];
                    let area = tangent(s[0]) * tangent(t[1]) - tangent(s[1]) * tangent(t[0]);
                    let expected = view.film_area_per_solid_angle(d);
                    assert!((area.abs() / expected - 1.0).abs() < 1e-12);
                }
            }
        }
    }

    /// Whatever the point of the lens, a film point looks at the same point of
    /// the plane in focus.
    #[test]
    fn a_lens_is_sharp_at_its_focus() {
        let (sensors, film) = sensors();
        let sensor = &sensors[1];
        let focused = |lens| {
            let view = View::new(sensor, &film, &sensor.state(), lens);
            let ray = view.ray(view.direction([3.2, 17.1]));
            let depth = ray.direction.dot(view.rows[2]);
            ray.origin + ray.direction * (2.5 / depth)
        };
        let middle = focused([0.0, 0.0]);
        for lens in [[1.0, 0.0], [-0.3, 0.8]] {
            assert!((focused(lens) - middle).length() < 1e-12);
        }
    }

    /// Film points between the limits look between the side planes, and those beyond a limit beyond its
    /// plane; also of cameras that mirror or have their axis elsewhere.
    #[test]
    fn side_planes_are_those_of_film_points() {
        let (sensors, film) = sensors();
        let (low, high) = ([3.0, -2.0], [11.5, 7.0]);
        let parts = [-0.01, 0.0, 0.4, 1.0, 1.01];
        let mut seen = 0;
        for sensor in sensors {
            let view = sensor.view(&film);
            if view.is_parallel() {
                continue;
            }
            let planes = view.side_planes(low, high);
            for (s, t) in parts.into_iter().flat_map(|s| parts.map(|t| (s, t))) {
                let point = [0, 1].map(|axis| {
                    let part = [s, t][axis];
                    low[axis] + part * (high[axis] - low[axis])
                });
                let direction = view.direction(point);
                let margins = [s, 1.0 - s, t, 1.0 - t];
                for (plane, margin) in planes.iter().zip(margins) {
                    let height = plane.dot(direction);
                    match margin == 0.0 {
                        true => assert!(height.abs() < 1e-12 * plane.length(), "{height}"),
                        false => assert_eq!(height > 0.0, margin > 0.0, "{point:?}"),
                    }
                }
                seen += 1;
            }
        }
        assert!(seen >= 50, "{seen}");
    }
}
