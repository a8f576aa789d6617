//! Mirror images of edges, as a camera sees them in flat mirrors (METHOD 6), for edges that
//! are gathered in a pixel (METHOD 8).
//!
//! Behind flat mirrors, an edge is seen where its mirror image is. A chain of mirrors makes an
//! image of the scene and, the other way round, of the camera: an edge is gathered around the
//! camera's image, and its own image is what lies on the film. Which chains count in a pixel is
//! found by its pyramid, reflected at each mirror in turn that it may reach. Panes leave images
//! where they are.

use capwalk_geometry::{HalfSpace, Hit, Mesh, Ray};
use capwalk_math::{Real, Vec3};
use capwalk_scene::lobe::Event;

use crate::accel::{Accel, SHORT_OF_TARGET};
use crate::mirror::{MAX_EVENTS, Mirror, Mirrors};
use crate::mirror_planes::Plane;
use crate::motion::Motion;

/// Probability with which an image by one mirror more is drawn.
const GOES_ON: f64 = 0.5;

/// The most images of which edges are gathered in a pixel.
const MOST_IMAGES: usize = 64;

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
        planes.fold(point, |point, (_, plane)| plane.mirror.point(point))
    }

    /// The direction in the scene of which this is the image.
    pub fn direction_in_scene(&self, image: Vec3) -> Vec3 {
        let planes = self.chain.iter();
        planes.fold(image, |direction, (_, plane)| {
            plane.mirror.direction(direction)
        })
    }

    /// The image of a direction in the scene: in which the viewpoint sees what the apex sees there.
    pub fn direction(&self, in_scene: Vec3) -> Vec3 {
        let planes = self.chain.iter().rev();
        planes.fold(in_scene, |direction, (_, plane)| {
            plane.mirror.direction(direction)
        })
    }

    /// One face of each mirror, the nearest one first.
    pub fn mirrors(&self) -> Mirrors {
        let mut mirrors = Mirrors::default();
        let faces = self.chain.iter().map(|(_, plane)| plane.face);
        faces.for_each(|face| mirrors.push(face));
        mirrors
    }

    /// How the image moves of which this is a point, given how what it is the image of moves, and
    /// the vertices and [`MirrorPlanes::spreads`](crate::MirrorPlanes::spreads) of mirrors.
    pub fn motion(
        &self,
        mesh: &Mesh,
        point: Vec3,
        motion: Motion,
        vertex: impl Fn(u32) -> Motion,
        spreads: &[f64],
    ) -> Motion {
        let mirrors = self.mirrors();
        let planes = self.chain.iter();
        let point = planes.fold(point, |point, (_, plane)| plane.mirror.point(point));
        let corner = |i| vertex(i).velocity;
        let velocity = mirrors.velocity(mesh, point, motion.velocity, corner);
        Motion {
            velocity,
            spread: motion.spread + self.spread(spreads),
        }
    }

    /// How much faster what it shows moves, at most, by other faces of its mirrors than by those that
    /// stand for them, as far as [`MirrorPlanes::spreads`](crate::MirrorPlanes::spreads) know.
    pub fn spread(&self, spreads: &[f64]) -> f64 {
        let numbers = self.chain.iter().map(|&(number, _)| number);
        numbers.map(|number| 2.0 * spreads[number as usize]).sum()
    }

    /// How many mirrors there are.
    pub fn count(&self) -> usize {
        self.chain.len()
    }

    /// What the last mirror can show: what is before it.
    pub fn in_front_of(&self) -> Option<HalfSpace> {
        self.chain.last().map(|(_, plane)| HalfSpace {
            point: plane.bounds[0] - plane.mirror.normal * plane.mirror.height(plane.bounds[0]),
            // The apex is behind the last mirror.
            normal: plane.mirror.normal * -plane.mirror.height(self.apex).signum(),
        })
    }

    /// True if points lie in the plane of the last mirror, where they are their own images.
    pub fn is_in_mirror(&self, points: [Vec3; 2], distance: f64) -> bool {
        let last = self.chain.last();
        last.is_some_and(|(_, plane)| {
            points
                .iter()
                .all(|&p| plane.mirror.height(p).abs() <= distance)
        })
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
        self.mirrors_along(image, camera, distance, events)
    }

    /// True if a face that was hit is of the mirror of this number in the chain of an image.
    pub fn reflects_next(&self, image: &MirrorImage, number: usize, hit: &Hit) -> bool {
        let planes = self.mirror_planes();
        let next = image.chain.get(number).zip(planes);
        next.is_some_and(|(&(plane, _), planes)| planes.has(plane, hit.face))
    }

    /// The mirrors by which a ray from a viewpoint leads to a point at a distance, as
    /// [`Self::sees_image`] finds them.
    pub fn mirrors_along(
        &self,
        image: &MirrorImage,
        ray: Ray,
        distance: f64,
        events: u32,
    ) -> Option<Mirrors> {
        let mut mirrors = Mirrors::default();
        let (mut ray, mut left) = (ray, distance);
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
                let is_visible = !is_clipped && mirrors.faces().len() == image.count();
                return is_visible.then_some(mirrors);
            };
            // At the next mirror of the chain the ray is reflected, elsewhere it must pass.
            let events = self.flat_events(&hit);
            let mut direction = ray.direction;
            if self.reflects_next(image, mirrors.faces().len(), &hit) {
                direction = Mirror::new(&self.mesh, hit.face).direction(direction);
                mirrors.push(hit.face);
            } else if !events.contains(Event::Pass) {
                return None;
            }
            left -= hit.t;
            ray = self.surface_ray(ray.at(hit.t), direction);
        }
        None
    }
}

/// An image of the scene that was drawn at random.
#[derive(Clone, Debug)]
pub struct DrawnImage {
    /// The image.
    pub image: MirrorImage,
    /// Its probability.
    pub probability: f64,
}

impl Accel {
    /// Draws one of the images of the scene by one to `events` flat mirrors that may be seen from a
    /// viewpoint, by a random number `u` in `[0, 1)`: at each step a plane by how large its mirrors
    /// look, roughly, and then no further one with a probability of a half. What
    /// is below the horizon of this normal is not seen. `None` if there is none.
    pub fn draw_image(
        &self,
        viewpoint: Vec3,
        horizon: Option<Vec3>,
        events: u32,
        mut u: f64,
    ) -> Option<DrawnImage> {
        let planes = &self.mirror_planes()?.planes;
        let mut drawn = DrawnImage {
            image: MirrorImage::direct(viewpoint),
            probability: 1.0,
        };
        let mut before = horizon.map(|normal| HalfSpace {
            point: viewpoint,
            normal,
        });
        for event in 0..events {
            let (apex, last) = (
                drawn.image.apex,
                drawn.image.chain.last().map(|&(last, _)| last),
            );
            let size = |(number, plane): (u32, &Plane)| {
                let is_behind = |half: HalfSpace| plane.is_outside(half.point, half.normal);
                let is_out = last == Some(number)
                    || plane.mirror.height(apex) == 0.0
                    || before.is_some_and(is_behind);
                if is_out { 0.0 } else { plane.size_from(apex) }
            };
            let sizes = || (0..).zip(planes).map(size);
            let sum: f64 = sizes().sum();
            // The first step is sure, if there is a mirror.
            if event > 0 {
                let goes_on = sum > 0.0 && u < GOES_ON;
                drawn.probability *= match (sum > 0.0, goes_on) {
                    (false, _) => 1.0,
                    (true, true) => GOES_ON,
                    (true, false) => 1.0 - GOES_ON,
                };
                if !goes_on {
                    break;
                }
                u /= GOES_ON;
            } else if sum == 0.0 {
                return None;
            }
            // The random number, rescaled within what was chosen, is uniform again.
            let (mut target, mut chosen) = (u * sum, None);
            for (number, size) in (0..).zip(sizes()) {
                if size > 0.0 {
                    chosen = Some((number, size));
                    if target < size {
                        break;
                    }
                    target -= size;
                }
            }
            let (number, size) = chosen?;
            u = (target / size).clamp(0.0, 1.0 - f64::EPSILON);
            drawn.probability *= size / sum;
            let plane = planes[number as usize];
            drawn.image.apex = plane.mirror.point(apex);
            drawn.image.chain.push((number, plane));
            before = drawn.image.in_front_of();
        }
        Some(drawn)
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
        let height = plane.mirror.height(apex);
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
            apex: plane.mirror.point(apex),
            chain: chain.clone(),
        };
        let (apex, before) = (image.apex, image.in_front_of());
        images.push(image);
        let pyramid = pyramid.map(|normal| plane.mirror.direction(normal));
        add_images(planes, apex, pyramid, before, events - 1, chain, images)?;
        chain.pop();
    }
    Some(())
}

/// Where mirrors that may move make a viewpoint appear, and in which direction it then looks.
pub fn moving_apex<R: Real>(
    mesh: &Mesh,
    mirrors: &Mirrors,
    [point, direction]: [Vec3<R>; 2],
    vertex: impl Fn(u32) -> Vec3<R>,
) -> [Vec3<R>; 2] {
    let faces = mirrors.faces().iter();
    faces.fold([point, direction], |[point, direction], &face| {
        let [a, b, c] = mesh.faces[face as usize].map(&vertex);
        let normal = (b - a).cross(c - a).normalized();
        let twice = |height: R| normal * (height * R::constant(2.0));
        [
            point - twice(normal.dot(point - a)),
            direction - twice(normal.dot(direction)),
        ]
    })
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
    use capwalk_scene::lobe::Conductor;
    use capwalk_scene::{Scene, Texture};

    use super::*;

    /// A room, and a box in it, of mirrors.
    fn mirrors() -> Accel {
        let mut scene: Scene = capwalk_scene::builtin::scene("box-room").expect("built in");
        let grey = |id: &str, x: f64| Texture::colour(id, Rgb::splat(x));
        let metal = Conductor {
            eta: scene.add_texture(grey("eta", 0.0)),
            k: scene.add_texture(grey("k", 1.0)),
            specular_reflectance: scene.add_texture(grey("r", 0.9)),
        };
        let places: Vec<usize> = scene.shapes.iter().map(|s| s.bsdf.0 as usize).collect();
        for place in places {
            scene.materials[place].bsdf = metal.into();
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
                    let is_along = (offset / found - direction).length() < 1e-9;
                    let is_it = is_along && (found / (distance + 0.7 * hit.t) - 1.0).abs() < 1e-9;
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
