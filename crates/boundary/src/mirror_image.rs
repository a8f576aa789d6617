//! Mirror images of edges, as a camera sees them in flat mirrors (METHOD 6), for edges that
//! are gathered in a pixel (METHOD 8).
//!
//! Behind flat mirrors, an edge is seen where its mirror image is. A chain of mirrors makes an
//! image of the scene and, the other way round, of the camera: an edge is gathered around the
//! camera's image, and its own image is what lies on the film. Which chains count in a pixel is
//! found by its pyramid, reflected at each mirror in turn that it may reach. Panes leave images
//! where they are.

use std::collections::HashMap;

use capwalk_geometry::{HalfSpace, Mesh, Ray};
use capwalk_math::{Real, Vec3};
use capwalk_scene::lobe::Event;

use crate::accel::{Accel, SHORT_OF_TARGET};
use crate::mirror::{MAX_EVENTS, Mirror, Mirrors};
use crate::motion::Motion;

/// The most planes of mirrors of which images are made: all of them are looked at in each pixel.
const MOST_PLANES: usize = 256;

/// The most images of which edges are gathered in a pixel.
const MOST_IMAGES: usize = 64;

/// Faces whose normals differ by less are one mirror, if their heights differ by less of their
/// coordinates than [`SAME_HEIGHT`]: more than rounding, and far less than rays beside an edge are
/// apart. Those that are not, make images by each.
const SAME_PLANE: f64 = 1e-12;
const SAME_HEIGHT: f64 = 1e-13;

/// No plane.
const NONE: u32 = u32::MAX;

/// The planes of all flat mirrors of a scene.
#[derive(Debug)]
pub struct MirrorPlanes {
    planes: Vec<Plane>,
    /// The plane of each face, or [`NONE`].
    plane_of_face: Vec<u32>,
}

/// The plane of some flat mirrors.
#[derive(Clone, Copy, Debug)]
struct Plane {
    /// One of its faces.
    face: u32,
    /// Unit vector.
    normal: Vec3,
    /// `normal · p` of its points.
    height: f64,
    /// The box around its mirrors.
    bounds: [Vec3; 2],
}

impl Plane {
    fn height_of(&self, point: Vec3) -> f64 {
        self.normal.dot(point) - self.height
    }

    fn point(&self, point: Vec3) -> Vec3 {
        point - self.normal * (2.0 * self.height_of(point))
    }

    fn direction(&self, direction: Vec3) -> Vec3 {
        direction - self.normal * (2.0 * self.normal.dot(direction))
    }

    /// True if no part of the box is on the inner side of the plane through a point.
    fn is_outside(&self, point: Vec3, inner: Vec3) -> bool {
        let [low, high] = self.bounds;
        let (centre, half) = ((low + high) * 0.5, (high - low) * 0.5);
        let reach = half.x * inner.x.abs() + half.y * inner.y.abs() + half.z * inner.z.abs();
        let margin = SAME_PLANE * (centre - point).length();
        inner.dot(centre - point) + reach < -margin
    }
}

impl MirrorPlanes {
    /// The planes of the faces that reflect; `None` if there are very many.
    pub(crate) fn new(mesh: &Mesh, reflects: impl Fn(u32) -> bool) -> Option<Self> {
        let mut planes: Vec<Plane> = Vec::new();
        let mut plane_of_face = vec![NONE; mesh.faces.len()];
        // Most faces lie in a plane of those before them: look in the cell of the first normal.
        let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
        for face in 0..mesh.faces.len() as u32 {
            let cross = mesh.face_cross(face as usize);
            if !reflects(face) || cross == Vec3::zero() {
                continue;
            }
            // Both sides of a mirror are one plane.
            let mut normal = cross.normalized();
            let first = [normal.x, normal.y, normal.z].into_iter();
            if first
                .into_iter()
                .find(|x| x.abs() > 1e-3)
                .is_some_and(|x| x < 0.0)
            {
                normal = -normal;
            }
            let corners = mesh.corners(face as usize);
            let height = normal.dot(corners[0]);
            let key = [normal.x, normal.y, normal.z].map(|x| (x * CELLS).round() as i64);
            let is_same = |&&plane: &&u32| {
                let plane = &planes[plane as usize];
                let turned = (plane.normal - normal).length() < SAME_PLANE;
                let is_near = |&p: &Vec3| plane.height_of(p).abs() <= SAME_HEIGHT * p.length();
                turned && corners.iter().all(is_near)
            };
            let known = cells.get(&key).and_then(|known| known.iter().find(is_same));
            let plane = match known {
                Some(&plane) => plane,
                None if planes.len() == MOST_PLANES => return None,
                None => {
                    let plane = planes.len() as u32;
                    planes.push(Plane {
                        face,
                        normal,
                        height,
                        bounds: [corners[0]; 2],
                    });
                    cells.entry(key).or_default().push(plane);
                    plane
                }
            };
            plane_of_face[face as usize] = plane;
            let bounds = &mut planes[plane as usize].bounds;
            for corner in corners {
                *bounds = [bounds[0].min(corner), bounds[1].max(corner)];
            }
        }
        Some(Self {
            planes,
            plane_of_face,
        })
    }

    /// How fast, at most, vertices of each plane leave the plane against how the one of its faces
    /// moves that stands for it, as far as sampling weights know: faces of one plane may move
    /// apart, and be of several shapes.
    pub fn spreads(&self, mesh: &Mesh, vertex: impl Fn(u32) -> Motion) -> Vec<f64> {
        let mut spreads = vec![0.0_f64; self.planes.len()];
        for (face, &number) in self.plane_of_face.iter().enumerate() {
            let Some(plane) = self.planes.get(number as usize) else {
                continue;
            };
            // The velocity of the face that stands for the plane along its normal is linear.
            let own = mesh.faces[plane.face as usize].map(&vertex);
            let height = |p: Vec3| {
                let [a, b, c] = mesh.corners(plane.face as usize);
                let cross = (b - a).cross(c - a);
                let area = cross.length_squared();
                let weight_b = (p - a).cross(c - a).dot(cross) / area;
                let weight_c = (b - a).cross(p - a).dot(cross) / area;
                let weights = [1.0 - weight_b - weight_c, weight_b, weight_c];
                let speeds = own.iter().zip(weights);
                speeds
                    .map(|(motion, w)| w * motion.velocity.dot(plane.normal))
                    .sum::<f64>()
            };
            let spread = &mut spreads[number as usize];
            for (i, p) in mesh.faces[face].into_iter().zip(mesh.corners(face)) {
                let motion = vertex(i);
                let apart = (motion.velocity.dot(plane.normal) - height(p)).abs();
                // Rounding is no motion.
                let is_apart = apart > ROUNDING * motion.velocity.length();
                let apart = if is_apart { apart } else { 0.0 };
                *spread = spread.max(apart + motion.spread);
            }
            *spread = own
                .iter()
                .fold(*spread, |spread, motion| spread.max(motion.spread));
        }
        spreads
    }
}

/// Speeds that differ by less of themselves are equal.
const ROUNDING: f64 = 1e-9;

/// Cells of normals per unit: two normals of one plane may be in different ones, and make a
/// plane twice.
const CELLS: f64 = 1e3;

/// A chain of flat mirrors, and where it makes a viewpoint and the scene appear. Without any,
/// the scene as it is.
#[derive(Clone, Debug)]
pub struct MirrorImage {
    /// The viewpoint, reflected at all mirrors of the chain, the nearest one first.
    pub apex: Vec3,
    /// Planes by their numbers, and as such.
    chain: Vec<(u32, Plane)>,
}

impl MirrorImage {
    /// The scene as it is, around a viewpoint.
    pub fn direct(apex: Vec3) -> Self {
        Self {
            apex,
            chain: Vec::new(),
        }
    }

    /// True without mirrors.
    pub fn is_direct(&self) -> bool {
        self.chain.is_empty()
    }

    /// The image of a point of the scene.
    pub fn point(&self, point: Vec3) -> Vec3 {
        let planes = self.chain.iter().rev();
        planes.fold(point, |point, (_, plane)| plane.point(point))
    }

    /// The image of a direction of the scene.
    pub fn direction(&self, direction: Vec3) -> Vec3 {
        let planes = self.chain.iter().rev();
        planes.fold(direction, |direction, (_, plane)| {
            plane.direction(direction)
        })
    }

    /// The direction in the scene of which this is the image.
    pub fn direction_in_scene(&self, image: Vec3) -> Vec3 {
        let planes = self.chain.iter();
        planes.fold(image, |direction, (_, plane)| plane.direction(direction))
    }

    /// How the image moves of which this is a point, given how what it is the image of moves, and
    /// the vertices and [`MirrorPlanes::spreads`] of mirrors.
    pub fn motion(
        &self,
        mesh: &Mesh,
        point: Vec3,
        motion: Motion,
        vertex: impl Fn(u32) -> Motion,
        spreads: &[f64],
    ) -> Motion {
        let mut mirrors = Mirrors::default();
        self.chain
            .iter()
            .for_each(|(_, plane)| mirrors.push(plane.face));
        let planes = self.chain.iter();
        let point = planes.fold(point, |point, (_, plane)| plane.point(point));
        let corner = |i| vertex(i).velocity;
        let velocity = mirrors.velocity(mesh, point, motion.velocity, corner);
        let numbers = self.chain.iter().map(|&(number, _)| number);
        let spread: f64 = numbers.map(|number| 2.0 * spreads[number as usize]).sum();
        Motion {
            velocity,
            spread: motion.spread + spread,
        }
    }

    /// What the last mirror can show: what is before it.
    pub fn in_front_of(&self) -> Option<HalfSpace> {
        self.chain.last().map(|(_, plane)| HalfSpace {
            point: plane.bounds[0] - plane.normal * plane.height_of(plane.bounds[0]),
            // The apex is behind the last mirror.
            normal: plane.normal * -plane.height_of(self.apex).signum(),
        })
    }

    /// True if points lie in the plane of the last mirror, where they are their own images.
    pub fn is_in_mirror(&self, points: [Vec3; 2], distance: f64) -> bool {
        let last = self.chain.last();
        last.is_some_and(|(_, plane)| points.iter().all(|&p| plane.height_of(p).abs() <= distance))
    }
}

impl Accel {
    /// The images of the scene by at most `events` flat mirrors that may be seen from a viewpoint
    /// in the pyramid of these planes, given by their inner normals; the scene as it is comes
    /// first. `None` if there are very many.
    pub fn images(
        &self,
        viewpoint: Vec3,
        pyramid: [Vec3; 4],
        events: u32,
    ) -> Option<Vec<MirrorImage>> {
        let mut images = vec![MirrorImage::direct(viewpoint)];
        if events > 0 {
            let (planes, mut chain) = (&self.mirror_planes()?.planes, Vec::new());
            add_images(
                planes,
                viewpoint,
                pyramid,
                None,
                events,
                &mut chain,
                &mut images,
            )?;
        }
        Some(images)
    }

    /// The mirrors by which a viewpoint of the camera sees what is in a direction at a distance
    /// along the path of light, the mirrors of the image; through panes as well, after at most
    /// `events` events in all. `None` if that is hidden.
    pub fn sees_image(
        &self,
        image: &MirrorImage,
        viewpoint: Vec3,
        direction: Vec3,
        distance: f64,
        events: u32,
    ) -> Option<Mirrors> {
        if !self.has_flat_events() {
            let is_seen = self.camera_sees(viewpoint, direction, distance);
            return is_seen.then(Mirrors::default);
        }
        let camera = self.camera_ray(viewpoint, direction);
        let mut mirrors = Mirrors::default();
        let mut chain = image.chain.iter();
        let (mut ray, mut left) = (camera, distance);
        for _ in 0..=events.min(MAX_EVENTS) {
            // What is reached without an event must be between the clip planes, as all that is
            // seen first.
            let is_clipped = left <= ray.t_min || left >= ray.t_max;
            let short = left * (1.0 - SHORT_OF_TARGET);
            let hit = self.first_hit_within(&Ray {
                t_max: ray.t_max.min(short),
                ..ray
            });
            let Some(hit) = hit else {
                let is_there = !is_clipped && chain.next().is_none();
                return is_there.then_some(mirrors);
            };
            // At the next mirror of the chain the ray is reflected, elsewhere it must pass.
            let events = self.flat_events(&hit);
            let is_next = |&&(plane, _): &&(u32, Plane)| {
                let planes = self.mirror_planes();
                planes.is_some_and(|planes| planes.plane_of_face[hit.face as usize] == plane)
            };
            let mut direction = ray.direction;
            if chain.clone().next().filter(is_next).is_some() {
                direction = Mirror::new(&self.mesh, hit.face).direction(direction);
                mirrors.push(hit.face);
                chain.next();
            } else if !events.contains(Event::Pass) {
                return None;
            }
            left -= hit.t;
            ray = self.surface_ray(ray.at(hit.t), direction);
        }
        None
    }
}

/// Adds the images by mirrors that the pyramid around an apex may reach, which is behind the last
/// mirror of the chain; `None` if there are too many.
fn add_images(
    planes: &[Plane],
    apex: Vec3,
    pyramid: [Vec3; 4],
    before: Option<HalfSpace>,
    events: u32,
    chain: &mut Vec<(u32, Plane)>,
    images: &mut Vec<MirrorImage>,
) -> Option<()> {
    if events == 0 {
        return Some(());
    }
    for (number, plane) in (0..).zip(planes) {
        let last = chain.last().map(|&(last, _)| last);
        let height = plane.height_of(apex);
        let is_out = |normal: &Vec3| plane.is_outside(apex, *normal);
        let is_behind = |half: HalfSpace| plane.is_outside(half.point, half.normal);
        if last == Some(number)
            || height == 0.0
            || pyramid.iter().any(is_out)
            || before.is_some_and(is_behind)
        {
            continue;
        }
        if images.len() == MOST_IMAGES {
            return None;
        }
        chain.push((number, *plane));
        let image = MirrorImage {
            apex: plane.point(apex),
            chain: chain.clone(),
        };
        let (apex, before) = (image.apex, image.in_front_of());
        images.push(image);
        let pyramid = pyramid.map(|normal| plane.direction(normal));
        add_images(planes, apex, pyramid, before, events - 1, chain, images)?;
        chain.pop();
    }
    Some(())
}

/// The image of a point in mirrors that may move with it.
pub fn moving_image<R: Real>(
    mesh: &Mesh,
    mirrors: &Mirrors,
    point: Vec3<R>,
    vertex: impl Fn(u32) -> Vec3<R>,
) -> Vec3<R> {
    let faces = mirrors.faces().iter().rev();
    faces.fold(point, |point, &face| {
        let [a, b, c] = mesh.faces[face as usize].map(&vertex);
        let normal = (b - a).cross(c - a).normalized();
        point - normal * (normal.dot(point - a) * R::constant(2.0))
    })
}

#[cfg(test)]
mod tests {
    use capwalk_math::Rgb;
    use capwalk_scene::bsdf::{Bsdf, Metal};
    use capwalk_scene::{Scene, Texture};

    use super::*;

    /// A room, and a box in it, of mirrors.
    fn mirrors() -> Accel {
        let mut scene: Scene = capwalk_scene::builtin::scene("box-room").expect("built in");
        let grey = |id: &str, x: f64| Texture::colour(id, Rgb::splat(x));
        let metal = Metal {
            eta: scene.add_texture(grey("eta", 0.0)),
            k: scene.add_texture(grey("k", 1.0)),
            specular_reflectance: scene.add_texture(grey("r", 0.9)),
        };
        let places: Vec<usize> = scene.shapes.iter().map(|s| s.bsdf.0 as usize).collect();
        for place in places {
            scene.materials[place].bsdf = Bsdf::Conductor(metal);
        }
        Accel::new(scene)
    }

    /// A path that is traced by reflection arrives where the image says, the image is among those
    /// of a narrow pyramid around its first direction, and is seen by the mirrors of the path.
    #[test]
    fn images_are_where_paths_lead() {
        let accel = mirrors();
        let origin = accel.view.origin;
        let mut arrived = [0; 4];
        for i in 0..400 {
            let share = |step: f64| 0.9 * (f64::from(i) * step).fract() + 0.05;
            let [width, height] = accel.scene.film.size.map(f64::from);
            let s = [share(0.618_034) * width, share(0.754_878) * height];
            let direction = accel.view.direction(s);
            let (mut ray, mut distance) = (accel.camera_ray(origin, direction), 0.0);
            let mut faces = Vec::new();
            while let Some(hit) = accel.first_hit_within(&ray).filter(|_| faces.len() < 4) {
                // A place before the next surface.
                let place = ray.at(0.7 * hit.t);
                let pyramid = pyramid(&accel, s);
                let images = accel.images(origin, pyramid, faces.len() as u32);
                let images = images.expect("few of them");
                let seen = images.iter().find_map(|image| {
                    let offset = image.point(place) - origin;
                    let found = offset.length();
                    let there = (offset / found - direction).length() < 1e-9;
                    let is_it = there && (found / (distance + 0.7 * hit.t) - 1.0).abs() < 1e-9;
                    let sees = || accel.sees_image(image, origin, offset / found, found, 6);
                    is_it.then(sees).flatten()
                });
                let mirrors = seen.expect("an image shows it");
                assert_eq!(mirrors.faces(), faces);
                arrived[faces.len()] += 1;
                if !accel.flat_events(&hit).contains(Event::Reflect) {
                    break;
                }
                faces.push(hit.face);
                distance += hit.t;
                let mirror = Mirror::new(&accel.mesh, hit.face);
                ray = accel.surface_ray(ray.at(hit.t), mirror.direction(ray.direction));
            }
        }
        assert!(arrived.iter().all(|&n| n > 50), "{arrived:?}");
    }

    /// The planes of a small square on the film.
    fn pyramid(accel: &Accel, [x, y]: [f64; 2]) -> [Vec3; 4] {
        let axis = accel.view.direction([x, y]);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let corners = corners.map(|[i, k]| accel.view.direction([x + 0.1 * i, y + 0.1 * k]));
        [0, 1, 2, 3].map(|i| {
            let normal = corners[i].cross(corners[(i + 1) % 4]).normalized();
            normal * normal.dot(axis).signum()
        })
    }
}
