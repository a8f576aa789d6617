//! The field around a camera whose rays are parallel, and meet in no point.
//!
//! It is the field around the origin of picture space, in which the camera-space
//! point `(X, Y, Z)` lies at `(X, Y, 1)`: there, all rays start. Straight edges stay
//! straight and their points divide them as before, so that the tree of silhouettes
//! serves as it is. What the map loses is depth, which is looked up where an edge was
//! found. A point that moves with `ẋ` moves with the first two components of
//!
//! ```text
//! A⁻¹ (ẋ - ȯ - X ȧ - Y ḃ - Z ċ)
//! ```
//!
//! in picture space: `A` has the camera's axes `a`, `b`, `c` as columns, and `o` is
//! where it stands.

use capwalk_geometry::{Edge, Mesh, SilhouettePoint, SilhouetteTree};
use capwalk_math::Vec3;
use capwalk_scene::sensor::view::View;

use super::boundary::{Eye, Field, Site};

/// The edges in picture space, if the rays of a view are parallel.
pub fn picture_tree(view: &View<f64>, mesh: &Mesh, edges: &[Edge]) -> Option<SilhouetteTree> {
    view.is_parallel().then(|| {
        let positions = mesh.positions.iter().map(|&p| view.towards(p)).collect();
        let faces = mesh.faces.clone();
        SilhouetteTree::build(&Mesh { positions, faces }, edges)
    })
}

impl Field<'_> {
    /// The angular velocity of a boundary point, or its image in mirrors, for a
    /// velocity `ẋ - ȯ` relative to the eye, `P_x̂ (ẋ - ȯ) / |x - o|`; if the eye's
    /// rays are parallel, that of its direction in picture space.
    #[inline]
    pub fn seen_velocity(&self, site: &Site, relative: Vec3) -> Vec3 {
        match site.place {
            None => site.angular(relative),
            Some(_) => site.angular(self.accel.view.picture_velocity(relative)),
        }
    }

    /// The transpose of [`Field::seen_velocity`].
    #[inline]
    pub fn pull_seen_velocity(&self, site: &Site, covector: Vec3) -> Vec3 {
        let on_velocity = site.angular(covector);
        match site.place {
            None => on_velocity,
            Some(_) => self.accel.view.pull_picture_velocity(on_velocity),
        }
    }

    /// Where a point is that an eye's tree found around `apex`, and how far along the
    /// eye's ray.
    pub(super) fn located<R>(
        &self,
        eye: &Eye<R>,
        apex: Vec3,
        found: &SilhouettePoint,
    ) -> (Vec3, f64) {
        match eye.axes {
            None => (apex + found.direction * found.distance, found.distance),
            Some(_) => {
                let edge = self.boundaries.edge(found.edge);
                let point = self.boundaries.point(edge.vertices, found.t);
                (point, self.accel.view.depth(point))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::Accel;
    use crate::diff::boundary::{Counts, Draw, Numbers};
    use crate::diff::motion::InMotion;
    use crate::options::Method;
    use crate::sampler::Sampler;
    use crate::world::World;
    use capwalk_geometry::edge::closest_direction;
    use capwalk_math::{Affine, Real};
    use capwalk_scene::{Film, Scene, SensorModel, builtin, params};
    use capwalk_walk::{Domain, WalkSettings};

    /// The built-in ball under parallel rays, on a film of so many units' half width.
    fn flattened(half_width: f64) -> Scene {
        let mut scene = builtin::scene("ball").expect("built in");
        scene.sensor.model = SensorModel::Orthographic;
        let scale = Affine::scale(Vec3::new(half_width, half_width, 1.0));
        scene.sensor.world_from_camera = scene.sensor.world_from_camera * scale;
        scene
    }

    /// Film points at fractions of the film that fill a square in its middle evenly.
    fn lattice(film: &Film, part: f64) -> impl Iterator<Item = [f64; 2]> {
        let [width, height] = film.size.map(f64::from);
        (0..2000).map(move |i| {
            let at = [0.754_877_666, 0.569_840_291].map(|a| (f64::from(i) * a).fract() - 0.5);
            [width * (0.5 + part * at[0]), height * (0.5 + part * at[1])]
        })
    }

    /// All edges, one after the other: those whose closest point is the first that its
    /// ray meets between the clip planes.
    #[test]
    fn the_closest_edge_in_the_picture() {
        let mut scene = flattened(1.0);
        scene.sensor.near_clip = 2.5;
        let accel = Accel::new(&scene);
        let field = Field::new(&accel, Method::Walk);
        let (view, edges) = (&accel.view, &field.boundaries.edges);
        let eye: Eye<f64> = Eye::camera(view, 0);
        let sphere = field.sphere(&eye);
        let limit = 0.05;
        let mut found = 0;
        for at in lattice(&scene.film, 1.0).take(300) {
            let q = view.direction(at);
            let in_picture = |edge: &Edge| {
                let ends = edge.vertices.map(|i| field.boundaries.point([i; 2], 0.0));
                let [a, b] = ends.map(|p| view.towards(p));
                let closest = closest_direction(a, b, q).filter(|it| it.angle < limit)?;
                let place = view.place(ends[0] + (ends[1] - ends[0]) * closest.t);
                let ray = accel.camera_ray(view.eye, closest.direction);
                let first = accel.first_hit_within(&ray).map_or(ray.t_max, |hit| hit.t);
                let is_seen = place.z > ray.t_min && place.z < first + 1e-7;
                is_seen.then_some(closest.angle)
            };
            let expected = edges.iter().filter_map(in_picture).reduce(f64::min);
            let nearest = sphere.closest(q, limit);
            let angle = nearest.as_ref().map(|nearest| nearest.distance);
            assert_eq!(angle.is_some(), expected.is_some(), "{at:?}");
            if let Some((angle, expected)) = angle.zip(expected) {
                assert!((angle - expected).abs() < 1e-12, "{at:?}");
                found += 1;
            }
        }
        assert!(found > 50, "{found} edges");
    }

    /// Far away, a camera with a small field of view has nearly parallel rays, and
    /// outlines move on its film as on that of the orthographic sensor.
    #[test]
    fn a_camera_far_away_sees_the_same() {
        const DISTANCE: f64 = 1e5;
        // So wide that its picture space is nearly flat in the middle, as directions
        // are from far away.
        let half_width = 100.0;
        let mut near = flattened(half_width);
        near.sensor.far_clip = 1e7;
        let mut far = builtin::scene("ball").expect("built in");
        let [.., forward] = far.sensor.state().axes;
        far.sensor.world_from_camera.translation += forward * -DISTANCE;
        far.sensor.model = SensorModel::Perspective {
            fov_x: 2.0 * (half_width / DISTANCE).atan(),
            principal_point_offset: [0.0; 2],
        };
        far.sensor.near_clip = DISTANCE + near.sensor.near_clip;
        far.sensor.far_clip = 1e7;

        let expression = "ball.translate.x + 0.5*ball.scale + 0.3*sensor.translate.z \
                          - 0.4*sensor.rotate.x + 0.3*sensor.rotate.z";
        let motion = params::motion(&near, expression).expect("names");
        let mut farther = motion.clone();
        // Both turn about the place of the near one.
        let rotation = motion.sensor.rotation;
        farther.sensor.translation += rotation.cross(forward * -DISTANCE);
        let motions = [motion, farther];
        let scenes = [near, far];
        let accels = scenes.each_ref().map(Accel::new);
        let fields = accels
            .each_ref()
            .map(|accel| Field::new(accel, Method::Walk));
        let worlds = [0, 1].map(|i| InMotion::new(&accels[i], &fields[i], &motions[i]));
        let sampler = Sampler::new(&scenes[0].settings, 0, 1);
        let (stream, counts) = (sampler.stream(0, 0), Counts::default());
        let draw = Draw {
            stream: &stream,
            counts: &counts,
        };
        let numbers = Numbers { draw, dimension: 0 };
        let pixels = f64::from(scenes[0].film.size[0]) / (2.0 * half_width); // per unit
        // Film points and their velocities on the edge that is closest to a film point.
        let edge_at = |i: usize, at: [f64; 2]| {
            let (scene, rest) = (&scenes[i], &accels[i].view);
            let half_film = 0.5 * f64::from(scene.film.size[0]);
            let walk = WalkSettings {
                steps: 0,
                max_radius: 0.1 * rest.pixel_size() * half_film / half_width, // 0.1 units
                ..WalkSettings::default()
            };
            let eye = Eye::camera(rest, 0);
            let sphere = fields[i].sphere(&eye);
            let edge = sphere.closest(rest.direction(at), walk.max_radius)?.point;
            let view = View::new(&scene.sensor, &scene.film, &worlds[i].sensor(), [0.0; 2]);
            let carried = worlds[i].carry_value(&Eye::camera(&view, 0), edge, &walk, numbers);
            Some(view.film(carried))
        };
        let (mut found, mut differ) = (0, 0);
        for at in lattice(&scenes[0].film, 0.008) {
            let [seen, expected] = [0, 1].map(|i| edge_at(i, at));
            let agree = match (seen, expected) {
                (None, None) => continue,
                (Some(seen), Some(expected)) => (0..2).all(|i| {
                    let value = seen[i].value() - expected[i].value();
                    let velocity = seen[i].tangent[0] - expected[i].tangent[0];
                    value.abs() < 1e-3 * pixels && velocity.abs() < 1e-3 * pixels
                }),
                _ => false,
            };
            found += 1;
            differ += usize::from(!agree);
        }
        assert!(found > 500, "{found} edges");
        assert!(differ < 5, "{differ} differ");
    }
}
