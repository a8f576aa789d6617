//! Faces that the camera sees exactly edge-on and moves against: there, an image has no
//! derivative. One side of the face comes into view to one side of the motion, the other side of it
//! to the other.

use capwalk_math::{Dual, Real, Vec3};
use capwalk_scene::sensor::view::View;
use capwalk_scene::{Film, Scene, Tangent};

use crate::coplanar::{SAME_PLANE, largest};

/// Part of the largest velocity by which something moves that is no rounding.
const MOVES: f64 = 1e-6;

/// A face that is seen edge-on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeOnFace {
    /// The id of its shape.
    pub shape: String,
    /// Its number in the shape's mesh, from 0.
    pub face: usize,
}

/// The faces within the image in whose planes the camera is, or, with parallel rays, the direction
/// of its rays, and which leave it with the motion. None where a lens is open: of its points, only
/// those of a line are in the plane.
pub fn edge_on(scene: &Scene, tangent: &Tangent) -> Vec<EdgeOnFace> {
    let (sensor, film) = (&scene.sensor, &scene.film);
    if sensor.model.has_lens() {
        return Vec::new();
    }
    let moving = View::new(
        sensor,
        film,
        &sensor.moving_state(&tangent.sensor),
        [0.0, 0.0],
    );
    if tangent.shapes.iter().all(Option::is_none) && moving.is_constant() {
        return Vec::new();
    }
    let view = moving.value();
    let middle = [0.0, 0.0].map(Dual::constant);
    let forward = moving.ray(moving.direction(middle)).direction;
    let mut found = Vec::new();
    for (shape, velocities) in scene.shapes.iter().zip(&tangent.shapes) {
        for (face, indices) in shape.mesh.faces.iter().enumerate() {
            let corners = indices.map(|i| {
                let velocity = match velocities {
                    Some(vectors) => vectors.vertices[i as usize],
                    None => Vec3::zero(),
                };
                shape.mesh.positions[i as usize].with_tangent(velocity)
            });
            // Distance and direction of the plane, as the camera sees it, and how they change.
            let [a, b, c] = corners;
            let cross = (b - a).cross(c - a);
            if cross.value() == Vec3::zero() {
                continue;
            }
            let normal = cross.normalized();
            let (across, size) = match view.is_parallel() {
                true => (normal.dot(forward), 1.0),
                // The rounding of a small face does not depend on how wide the scene is.
                false => {
                    let points = corners.iter().chain([&moving.origin]);
                    let sizes = points.map(|p| largest(&p.value()));
                    (normal.dot(a - moving.origin), sizes.fold(0.0, f64::max))
                }
            };
            if across.value.abs() > SAME_PLANE * size {
                continue;
            }
            let speeds = corners.iter().chain([&moving.origin, &forward]);
            let fastest = speeds.map(|p| p.tangent(0).length()).fold(0.0, f64::max);
            if across.tangent[0].abs() > MOVES * fastest
                && is_in_image(&view, film, corners.map(|p| p.value()))
            {
                found.push(EdgeOnFace {
                    shape: shape.id.clone(),
                    face,
                });
            }
        }
    }
    found
}

/// True if part of a triangle is seen, unless something hides it.
fn is_in_image(view: &View<f64>, film: &Film, corners: [Vec3; 3]) -> bool {
    let [near, far] = view.clip();
    // Points beside the camera are nowhere on the film.
    let near = near.max(f64::MIN_POSITIVE);
    let polygon = clipped(corners.to_vec(), |p| view.depth(*p) - near, mixed);
    let polygon = clipped(polygon, |p| far - view.depth(*p), mixed);
    let mut polygon: Vec<[f64; 2]> = polygon
        .into_iter()
        .map(|p| view.film(view.towards(p)))
        .filter(|[x, y]| x.is_finite() && y.is_finite())
        .collect();
    let reach = film.filter.radius();
    for axis in [0, 1] {
        let low = f64::from(film.crop_offset[axis]) - reach;
        let high = low + f64::from(film.crop_size[axis]) + 2.0 * reach;
        let between =
            |p: [f64; 2], q: [f64; 2], t: f64| [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])];
        polygon = clipped(polygon, |p| p[axis] - low, between);
        polygon = clipped(polygon, |p| high - p[axis], between);
    }
    !polygon.is_empty()
}

/// A point between two others.
fn mixed(p: Vec3, q: Vec3, t: f64) -> Vec3 {
    p + (q - p) * t
}

/// The part of a polygon where a linear function is above 0 (Sutherland and Hodgman 1974).
fn clipped<P: Copy>(
    polygon: Vec<P>,
    inside: impl Fn(&P) -> f64,
    between: impl Fn(P, P, f64) -> P,
) -> Vec<P> {
    let mut part = Vec::new();
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let (at_p, at_q) = (inside(&p), inside(&q));
        if at_p > 0.0 {
            part.push(p);
        }
        if (at_p > 0.0) != (at_q > 0.0) {
            part.push(between(p, q, at_p / (at_p - at_q)));
        }
    }
    part
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use capwalk_math::Affine;
    use capwalk_scene::SensorModel;
    use capwalk_scene::params::Registry;
    use capwalk_scene::primitive::rectangle;

    use super::*;

    /// What is found where the built-in leaf is a rectangle with its middle this far in front of the
    /// camera and to its left, in a plane that is this far above it.
    fn found(
        ahead: f64,
        left: f64,
        above: f64,
        change: impl Fn(&mut Scene),
        motion: &str,
    ) -> usize {
        let mut scene = capwalk_scene::builtin::scene("leaf").unwrap();
        change(&mut scene);
        let view = scene.sensor.view(&scene.film);
        let [x, y, z] = view.axes().map(Vec3::normalized);
        let leaf = scene.shapes.iter_mut().find(|s| s.id == "leaf").unwrap();
        let mut mesh = rectangle(Affine::scale(Vec3::splat(0.1))).0;
        for p in &mut mesh.positions {
            *p = view.origin + x * (left + p.x) + y * (above + p.z) + z * (ahead + p.y);
        }
        Arc::make_mut(leaf).mesh = mesh;
        let tangent = Registry::new(&scene).tangent(&scene, motion).unwrap();
        let found = edge_on(&scene, &tangent);
        assert!(found.iter().all(|face| face.shape == "leaf"), "{found:?}");
        found.len()
    }

    #[test]
    fn faces_before_a_camera_in_their_plane_are_found() {
        let same = |_: &mut Scene| {};
        for motion in ["leaf.translate.x", "leaf.translate.y", "leaf.rotate.x"] {
            assert_eq!(found(1.0, 0.0, 0.0, same, motion), 2, "{motion}");
        }
        assert_eq!(found(1.0, 0.0, 0.0, same, "sensor.translate.y"), 2);
        // A camera that turns stays where it is.
        assert_eq!(found(1.0, 0.0, 0.0, same, "sensor.rotate.y"), 0);
        // Motion within the plane, none, and that of both.
        let both = "leaf.translate.y + sensor.translate.y";
        for motion in [both, "floor.bsdf.reflectance.value", "lamp.translate.x"] {
            assert_eq!(found(1.0, 0.0, 0.0, same, motion), 0, "{motion}");
        }
        // Beside the image, behind the camera, in another plane, and around the camera.
        let is_found = |ahead, left, above| found(ahead, left, above, same, "leaf.translate.y") > 0;
        assert!(!is_found(1.0, 5.0, 0.0) && !is_found(-1.0, 0.0, 0.0));
        assert!(!is_found(1.0, 0.0, 1e-4) && is_found(1.0, 0.0, 1e-12));
        assert!(is_found(0.05, 0.0, 0.0));
    }

    /// How wide the scene is does not matter to a small face.
    #[test]
    fn faces_beside_the_plane_of_a_camera_are_told_apart_in_wide_scenes() {
        let wide = |scene: &mut Scene| {
            let wall =
                Affine::translate(Vec3::new(3.0, 2e6, 1.0)) * Affine::scale(Vec3::splat(1e6));
            let ((mesh, normals), bsdf) = (rectangle(wall), scene.shapes[0].bsdf);
            let wall = capwalk_scene::Shape::new("wall", mesh, normals, bsdf);
            scene.shapes.push(Arc::new(wall));
        };
        let found = |above| found(1.0, 0.0, above, wide, "leaf.translate.y");
        assert_eq!([found(1e-4), found(1e-12)], [0, 2]);
    }

    /// Parallel rays see a face edge-on from everywhere, until one of both turns; a lens sees it
    /// from both sides.
    #[test]
    fn parallel_rays_and_lenses_see_edge_on_by_their_direction_or_never() {
        let parallel = |scene: &mut Scene| scene.sensor.model = SensorModel::Orthographic;
        assert_eq!(found(1.0, 0.0, 0.0, parallel, "leaf.translate.y"), 0);
        let turned = found(1.0, 0.0, 0.0, parallel, "leaf.rotate.x + leaf.rotate.y");
        assert_eq!(turned, 2);
        let lens = |scene: &mut Scene| {
            scene.sensor.model = SensorModel::ThinLens {
                fov_x: 0.7,
                aperture_radius: 0.1,
                focus_distance: 2.0,
            };
        };
        assert_eq!(found(1.0, 0.0, 0.0, lens, "leaf.translate.y"), 0);
    }
}
