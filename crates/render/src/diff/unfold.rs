//! What is seen in flat mirrors and through panes (METHOD 6): edges seen there
//! are boundaries around the eye, too, in the directions of their images.
//!
//! An image stays on the sphere around the eye. From behind the mirror, where
//! the eye's own image is, the edge itself is seen in the reflected direction
//! and at the image's distance: the query is the same with another eye. Which
//! mirrors are looked into is decided by the direction; images that are seen
//! in other mirrors lie behind these mirrors' outlines, which are boundaries.

use capwalk_geometry::topology::COPLANAR;
use capwalk_geometry::{ConeQuery, Hit, Mesh, Plane, Ray, SilhouettePoint};
use capwalk_math::{Real, Vec3};
use capwalk_scene::lobe::Event;
use capwalk_walk::{Domain, Nearest, Sphere};

use crate::accel::Accel;

use super::boundary::{Eye, Field, Visibility};

/// Most specular events between an eye and an edge that is seen.
pub const MAX_EVENTS: u32 = 6;

/// The plane of a face, which may move, as a mirror.
struct Mirror {
    corners: [Vec3; 3],
    normal: Vec3,
}

impl Mirror {
    fn new(mesh: &Mesh, face: u32) -> Self {
        Self {
            corners: mesh.corners(face as usize),
            normal: mesh.face_cross(face as usize).normalized(),
        }
    }

    fn height(&self, point: Vec3) -> f64 {
        self.normal.dot(point - self.corners[0])
    }

    /// The image of a point.
    fn point(&self, point: Vec3) -> Vec3 {
        point - self.normal * (2.0 * self.height(point))
    }

    /// The image of a direction.
    fn direction(&self, direction: Vec3) -> Vec3 {
        direction - self.normal * (2.0 * self.normal.dot(direction))
    }

    /// How the image of a point moves when the corners move by one along the
    /// normal. With `d` the point's height, `y` its foot and `h` the plane's
    /// motion along its normal `n`, linear between the corners, the image moves
    /// by `2 h(y) n + 2 d ∇h`: the normal turns by `-∇h`.
    fn slopes(&self, point: Vec3) -> [Vec3; 3] {
        let [a, b, c] = self.corners;
        let (edge1, edge2) = (b - a, c - a);
        let cross = edge1.cross(edge2);
        let scale = 1.0 / cross.length_squared();
        // Gradients of the barycentric weights.
        let (gradient_b, gradient_c) = (edge2.cross(cross) * scale, cross.cross(edge1) * scale);
        let gradients = [-gradient_b - gradient_c, gradient_b, gradient_c];
        let offset = point - a;
        let (weight_b, weight_c) = (gradient_b.dot(offset), gradient_c.dot(offset));
        let weights = [1.0 - weight_b - weight_c, weight_b, weight_c];
        let height = self.height(point);
        [0, 1, 2].map(|i| self.normal * (2.0 * weights[i]) + gradients[i] * (2.0 * height))
    }
}

/// The mirrors in which a point is seen, the one nearest to the eye first.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mirrors {
    faces: [u32; MAX_EVENTS as usize],
    count: u8,
}

impl Mirrors {
    /// Faces of the joined mesh.
    pub fn faces(&self) -> &[u32] {
        &self.faces[..usize::from(self.count)]
    }

    /// True if it is seen without any.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    fn push(&mut self, face: u32) {
        self.faces[usize::from(self.count)] = face;
        self.count += 1;
    }

    /// The velocity of the image of a point, for velocities of the mirrors' corners.
    pub fn velocity(
        &self,
        mesh: &Mesh,
        mut point: Vec3,
        mut velocity: Vec3,
        corner: impl Fn(u32) -> Vec3,
    ) -> Vec3 {
        for &face in self.faces().iter().rev() {
            let mirror = Mirror::new(mesh, face);
            velocity = mirror.direction(velocity);
            for (slope, i) in mirror
                .slopes(point)
                .into_iter()
                .zip(mesh.faces[face as usize])
            {
                velocity += slope * mirror.normal.dot(corner(i));
            }
            point = mirror.point(point);
        }
        velocity
    }

    /// The covector on the velocity of a point for one on that of its image;
    /// those on the velocities of the mirrors' corners go to `corner`.
    pub fn pull(
        &self,
        mesh: &Mesh,
        mut point: Vec3,
        mut covector: Vec3,
        mut corner: impl FnMut(u32, Vec3),
    ) -> Vec3 {
        let mut points = [Vec3::zero(); MAX_EVENTS as usize];
        for (i, &face) in self.faces().iter().enumerate().rev() {
            points[i] = point;
            point = Mirror::new(mesh, face).point(point);
        }
        for (&face, point) in self.faces().iter().zip(points) {
            let mirror = Mirror::new(mesh, face);
            for (slope, i) in mirror
                .slopes(point)
                .into_iter()
                .zip(mesh.faces[face as usize])
            {
                corner(i, mirror.normal * slope.dot(covector));
            }
            covector = mirror.direction(covector);
        }
        covector
    }
}

/// A boundary point and how it is seen.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// The point; its direction is that of its image.
    pub point: SilhouettePoint,
    /// The mirrors in which it is seen.
    pub mirrors: Mirrors,
    /// True if nothing specular lies before it.
    pub is_direct: bool,
}

/// The sphere of directions around an eye, bounded by edges and their images.
pub struct Unfolded<'a, R, F> {
    /// The edges that are seen without mirrors.
    pub direct: Sphere<'a, F>,
    /// The edges.
    pub field: &'a Field<'a>,
    /// The eye.
    pub eye: &'a Eye<R>,
}

/// A ray on its way from an eye through flat specular surfaces.
#[derive(Clone, Copy)]
struct Sight {
    ray: Ray,
    /// The image of the eye from where the ray seems to come, and in which direction
    /// of the edges' space.
    eye: Vec3,
    axis: Vec3,
    events: [Event; MAX_EVENTS as usize],
    mirrors: Mirrors,
    count: u32,
}

impl Sight {
    fn events(&self) -> &[Event] {
        &self.events[..self.count as usize]
    }

    /// The ray behind an event.
    fn after(&self, accel: &Accel, hit: &Hit, event: Event) -> Self {
        let mut next = *self;
        next.events[self.count as usize] = event;
        next.count += 1;
        let mut direction = self.ray.direction;
        if event == Event::Reflect {
            let mirror = Mirror::new(&accel.mesh, hit.face);
            direction = mirror.direction(direction);
            next.axis = direction;
            next.eye = mirror.point(self.eye);
            next.mirrors.push(hit.face);
        }
        next.ray = accel.surface_ray(self.ray.at(hit.t), direction);
        next
    }
}

/// Fraction of its distance by which each mirror may make the image of a point miss
/// the point, seen in another face of the same mirror: twice the angle between
/// faces without an edge between them, and as much again for rounding.
const SAME_MIRROR: f64 = 4.0 * COPLANAR;

impl<R: Real, F: Fn(&SilhouettePoint) -> bool> Unfolded<'_, R, F> {
    fn first_ray(&self, direction: Vec3) -> Sight {
        let eye = self.eye.position.value();
        Sight {
            ray: match self.eye.visibility {
                Visibility::Camera => self.field.accel.camera_ray(eye, direction),
                Visibility::Surface | Visibility::All => {
                    self.field.accel.surface_ray(eye, direction)
                }
            },
            eye: self.direct.eye,
            axis: direction,
            events: [Event::Pass; MAX_EVENTS as usize],
            mirrors: Mirrors::default(),
            count: 0,
        }
    }

    /// Looks for images closer to a direction than the best point so far, behind
    /// what a ray hits.
    fn look_behind(&self, sight: &Sight, limit: f64, best: &mut Option<Nearest<Seen, Vec3>>) {
        let accel = self.field.accel;
        let Some(hit) = accel.first_hit_within(&sight.ray) else {
            return;
        };
        for event in accel.flat_events(&hit).iter() {
            let is_parallel = self.eye.axes.is_some();
            if is_parallel && event == Event::Reflect {
                continue; // What moves there is refused.
            }
            let behind = sight.after(accel, &hit, event);
            // Only what lies before a mirror is seen in it.
            let normal = accel.mesh.face_cross(hit.face as usize);
            let side = normal.dot(behind.ray.direction).signum();
            let query = ConeQuery {
                eye: behind.eye,
                axis: behind.axis,
                max_angle: best.map_or(limit, |nearest| nearest.distance),
                edges: self.direct.edges,
                groups: self.direct.groups,
                in_front_of: (!is_parallel).then_some(Plane {
                    point: behind.ray.origin,
                    normal: normal * side,
                }),
            };
            self.direct.queries.set(self.direct.queries.get() + 1);
            let is_seen = |point: &SilhouettePoint| self.mirrors_before(&behind, point).is_some();
            if let Some(point) = self.direct.tree.closest_where(&query, is_seen) {
                let mirrors = self.mirrors_before(&behind, &point);
                let direction = self.unfolded(&behind, point.direction);
                *best = Some(Nearest {
                    site: Seen {
                        point: SilhouettePoint { direction, ..point },
                        mirrors: mirrors.expect("what is found is seen"),
                        is_direct: false,
                    },
                    point: direction,
                    distance: point.angle,
                });
            }
            if behind.count < self.eye.events {
                self.look_behind(&behind, limit, best);
            }
        }
    }

    /// A direction from the eye's image as the eye sees it.
    fn unfolded(&self, sight: &Sight, direction: Vec3) -> Vec3 {
        let faces = sight.mirrors.faces().iter().rev();
        faces.fold(direction, |direction, &face| {
            Mirror::new(&self.field.accel.mesh, face).direction(direction)
        })
    }

    /// The mirrors in which a point found from the eye's image is seen by the eye:
    /// faces of the planes that were looked into. `None` if it is hidden.
    fn mirrors_before(&self, sight: &Sight, point: &SilhouettePoint) -> Option<Mirrors> {
        let accel = self.field.accel;
        let direction = self.unfolded(sight, point.direction);
        // What lies in the plane of the eye's own face is seen edge-on: nothing jumps,
        // and whether a ray along the plane meets something is a matter of rounding.
        let height = |normal: Vec3| (direction.dot(normal) * point.distance).abs();
        let horizon = self.eye.face_normal.map(height);
        if horizon.is_some_and(|height| height <= accel.horizon_distance()) {
            return None;
        }
        let (target, distance) = self.field.located(self.eye, sight.eye, point);
        let mut trace = self.first_ray(direction);
        let mut left = distance;
        for &event in sight.events() {
            let hit = accel.first_hit_within(&trace.ray)?;
            if hit.t >= left || !accel.flat_events(&hit).contains(event) {
                return None;
            }
            left -= hit.t;
            trace = trace.after(accel, &hit, event);
        }
        let miss = trace.ray.at(left) - target;
        // Without mirrors it is there up to rounding.
        let reflections = trace.mirrors.faces().len().max(1) as f64;
        let is_there = miss.length() < SAME_MIRROR * reflections * distance;
        let sees = || accel.surface_sees(trace.ray.origin, trace.ray.direction, left);
        (is_there && sees()).then_some(trace.mirrors)
    }
}

impl<R: Real, F: Fn(&SilhouettePoint) -> bool> Domain for Unfolded<'_, R, F> {
    type Vector = Vec3;
    type Site = Seen;

    fn closest(&self, q: Vec3, limit: f64) -> Option<Nearest<Seen, Vec3>> {
        let direct = self.direct.closest(q, limit);
        let mut best = direct.map(|nearest| Nearest {
            site: Seen {
                point: nearest.site,
                mirrors: Mirrors::default(),
                is_direct: true,
            },
            point: nearest.point,
            distance: nearest.distance,
        });
        if self.eye.events > 0 {
            self.look_behind(&self.first_ray(q), limit, &mut best);
        }
        best
    }

    #[inline]
    fn distance(&self, q: Vec3, y: Vec3) -> f64 {
        self.direct.distance(q, y)
    }
    #[inline]
    fn towards(&self, q: Vec3, y: Vec3) -> Vec3 {
        self.direct.towards(q, y)
    }
    #[inline]
    fn tangent(&self, q: Vec3, azimuth: f64) -> Vec3 {
        self.direct.tangent(q, azimuth)
    }
    #[inline]
    fn walk(&self, q: Vec3, e: Vec3, angle: f64) -> Vec3 {
        self.direct.walk(q, e, angle)
    }
    #[inline]
    fn radius_inside(&self, half_angle: f64, u: f64) -> f64 {
        self.direct.radius_inside(half_angle, u)
    }
    #[inline]
    fn rim_over_ball(&self, half_angle: f64) -> f64 {
        self.direct.rim_over_ball(half_angle)
    }
    #[inline]
    fn curvature(&self, q: Vec3) -> Vec3 {
        self.direct.curvature(q)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diff::boundary::Field;
    use crate::options::Method;
    use capwalk_scene::bsdf::Metal;
    use capwalk_scene::{Bsdf, Scene, ShadingNormals, Texture, builtin};

    /// The ball and its lamp, flat-shaded, over a floor that is a mirror.
    fn mirrored() -> Scene {
        let mut scene = builtin::scene("ball").expect("built in");
        let mut number = |id: &str, x: f64| scene.add_texture(Texture::number(id, x));
        let metal = Metal {
            eta: number("eta", 0.0),
            k: number("k", 1.0),
            specular_reflectance: number("tint", 1.0),
        };
        let floor = scene.shapes[0].bsdf;
        scene.materials[floor.0 as usize].bsdf = Bsdf::Conductor(metal);
        for shape in &mut scene.shapes {
            shape.normals = ShadingNormals::Face;
            shape.uvs = None;
        }
        scene
    }

    /// The same world without the mirror, and behind it what it shows.
    fn doubled() -> Scene {
        let mut scene = mirrored();
        let eye = scene.sensor.origin();
        let floor = &mut scene.shapes[0].mesh;
        // Out of sight, above the eye.
        let away = |p: &Vec3| *p * 1e-3 + eye * 50.0;
        floor.positions = floor.positions.iter().map(away).collect();
        for shape in &mut scene.shapes[1..] {
            let mut image = shape.mesh.clone();
            image.positions.iter_mut().for_each(|p| p.y = -p.y);
            shape.mesh.append(&image);
        }
        scene
    }

    /// Images are what one would see if the mirror were a window: the same closest
    /// points, found without any mirror.
    #[test]
    fn images_are_seen_through_windows() {
        let scenes = [mirrored(), doubled()];
        assert_eq!(scenes[0].shapes[0].id, "floor");
        let [with, without] = [Accel::new(&scenes[0]), Accel::new(&scenes[1])];
        let fields = [
            Field::new(&with, Method::Walk),
            Field::new(&without, Method::Walk),
        ];
        let eye: Eye<f64> = Eye::camera(&with.view, 1);
        let [mirror, window] = fields.each_ref().map(|field| field.sphere(&eye));
        let view = scenes[0].sensor.view(&scenes[0].film);
        let [width, height] = scenes[0].film.size.map(f64::from);
        let mut images = 0;
        for i in 0..2000 {
            // A lattice that fills the film evenly.
            let at = [0.754_877_666, 0.569_840_291].map(|a| (f64::from(i) * a).fract());
            let q = view.direction([width * at[0], height * at[1]]);
            let [seen, expected] = [mirror.closest(q, 0.1), window.closest(q, 0.1)];
            let distances = [&seen, &expected].map(|it| it.map_or(0.1, |it| it.distance));
            assert!(
                (distances[0] - distances[1]).abs() < 1e-9,
                "{q:?}: {distances:?}"
            );
            let Some((seen, expected)) = seen.zip(expected) else {
                continue;
            };
            assert!((seen.point - expected.point).length() < 1e-7, "{q:?}");
            images += usize::from(!seen.site.is_direct);
        }
        assert!(images > 100, "{images} images");
    }
}
