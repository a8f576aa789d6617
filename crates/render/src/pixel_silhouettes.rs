//! The edges that the camera may see in each pixel, gathered (METHOD 8).

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use capwalk_boundary::{Field, MirrorImage, Motion, SEEN, SilhouettePieces, clip, place};
use capwalk_geometry::{ConeQuery, EdgeSelection, uncounted};
use capwalk_math::{Real, Vec3, sphere};
use capwalk_scene::Scene;

use crate::beside_silhouettes::BesideSilhouettes;
use crate::camera::Camera;
use crate::pixel::Support;
use crate::scene_eval::SceneEval;

/// A cache of the edges gathered in each pixel. What it keeps changes no result.
#[derive(Debug, Default)]
pub struct PixelSilhouettes {
    /// Made when the first of them is asked for.
    pixels: OnceLock<Vec<OfPixel>>,
    /// How many there are.
    count: usize,
    width: usize,
    /// How many pieces of edges it keeps in all pixels together.
    kept: AtomicUsize,
}

/// The edges of a pixel; `None` if there are too many images in mirrors, or edges in them. In a box: most pixels of large
/// images have none.
type OfPixel = OnceLock<Option<Box<EdgesInPixel>>>;

/// The edges that the camera may see in a pixel.
#[derive(Clone, Debug)]
pub struct EdgesInPixel {
    /// Where points are drawn on them.
    pub pieces: SilhouettePieces,
    /// Where film points are drawn beside those that are silhouettes of smooth surfaces.
    pub beside: BesideSilhouettes,
}

/// The most pieces that it keeps: some hundred megabytes.
const MOST_KEPT: usize = 1 << 22;

/// The most pieces in mirrors of one pixel that it gathers.
const MOST_MIRRORED: usize = 1 << 14;

/// Length of the longest piece that has one sampling weight, pixels.
const PIECE: f64 = 0.5;
/// Smallest filter value that a sampling weight uses, relative to the filter's mean.
const LEAST_FILTER: f64 = 0.1;
/// Smallest speed that a sampling weight of an edge that moves uses, relative to the fastest
/// one in the pixel.
const LEAST_SPEED: f64 = 0.01;
/// Sampling weight of no edge at all, relative to a silhouette across the filter's
/// support: in pixels with creases alone, where the discontinuity is small, few samples
/// take one.
const NOTHING: f64 = 0.02;
/// Radians by which cones are opened: more than rounding.
const MARGIN: f64 = 1e-9;

impl PixelSilhouettes {
    /// An empty cache for a scene; it keeps nothing if the camera has a lens.
    pub fn of(scene: &Scene) -> Self {
        let [width, height] = scene.film.crop_size.map(|n| n as usize);
        let count = match scene.sensor.model.has_lens() {
            true => 0,
            false => width * height,
        };
        Self {
            pixels: OnceLock::new(),
            count,
            width,
            kept: AtomicUsize::new(0),
        }
    }

    /// Calls `then` with the edges in a pixel, from the cache or else from `make`.
    pub fn with<T>(
        &self,
        [x, y]: [u32; 2],
        make: impl Fn() -> Option<EdgesInPixel>,
        then: impl FnOnce(Option<&EdgesInPixel>) -> T,
    ) -> T {
        let index = y as usize * self.width + x as usize;
        let empty = || (0..self.count).map(|_| OnceLock::new()).collect();
        let cell = self.pixels.get_or_init(empty).get(index);
        if let Some(edges) = cell.and_then(OnceLock::get) {
            return then(edges.as_deref());
        }
        // Kept for all samples, they are no effort of this one.
        let edges = match cell {
            Some(_) => uncounted(make),
            None => make(),
        };
        if let Some(cell) = cell {
            let count = edges.as_ref().map_or(0, |edges| edges.pieces.count());
            let kept = self.kept.fetch_add(count, Ordering::Relaxed);
            let edges = edges.map(Box::new);
            if kept + count > MOST_KEPT {
                self.kept.fetch_sub(count, Ordering::Relaxed);
                return then(edges.as_deref());
            }
            // Another sample of the pixel may have been first.
            if cell.set(edges).is_err() {
                self.kept.fetch_sub(count, Ordering::Relaxed);
            }
            return then(cell.get().and_then(Option::as_deref));
        }
        then(edges.as_ref())
    }
}

/// A piece of an edge that is seen in a pixel, directly or in an image by mirrors.
struct Weighed {
    edge: u32,
    image: u32,
    /// Its ends on the edge.
    range: [f64; 2],
    /// The unit directions in which they are seen.
    directions: [Vec3; 2],
    /// Its sampling weight, but for how fast it moves.
    weight: f64,
    /// How fast both ends move, together.
    speed: f64,
}

/// The edges in the support of a pixel's filter, cut into pieces whose sampling weight is
/// what they contribute (METHOD 8): their length on the film, times the filter, times their
/// angular speed, times a guess of how large the discontinuity is there. Edges count behind at
/// most `events` flat mirrors and panes; `spreads` are those of the mirrors' planes. `None` if there
/// are very many images in mirrors, or pieces of edges in them.
pub fn silhouettes<R: Real, W: SceneEval<R>>(
    field: &Field,
    eval: &W,
    camera: &Camera<R>,
    support: &Support,
    events: u32,
    spreads: &[f64],
) -> Option<EdgesInPixel> {
    let view = &camera.primal;
    // Gather what is in a cone around the support, which is a pyramid of four planes.
    let [x, y] = support.sides.map(|side| side.bounds);
    let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[i, k]| view.direction([x[i], y[k]]));
    let axis = view.direction([0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1])]);
    let widest = corners.iter().map(|&c| sphere::angle_between(axis, c));
    let planes = [0, 1, 2, 3].map(|i| {
        let normal = corners[i].cross(corners[(i + 1) % 4]).normalized();
        normal * normal.dot(axis).signum()
    });
    let area = support.sides[0].width() * support.sides[1].width();
    let (boundaries, accel) = (field.boundaries, field.accel);
    let mesh = &accel.mesh;
    let camera_is_stationary = camera.moving.is_constant();
    // How fast what is seen at an offset moves across the ray through a film point that stays,
    // radians. What neither moves nor is seen from a camera that may has no share of the
    // discontinuities where it lies on other edges.
    let against = |offset: Vec3| {
        let (distance, s) = (offset.length(), view.film(offset));
        let ray = camera.moving.direction(s.map(R::constant));
        let motion = eval.motion_of(camera.moving.origin + ray * R::constant(distance));
        (motion, distance)
    };
    let speed = |points: [u32; 2], t: f64, offset: Vec3, normal: Vec3| {
        let mut motions = points.iter().map(|&point| eval.motion_of_point(point));
        if camera_is_stationary && motions.all(|motion| motion == Motion::STILL) {
            return 0.0;
        }
        let (against, distance) = against(offset);
        eval.speed(points, t, against.velocity, normal) / distance
    };
    let image_speed = |image: &MirrorImage, points, t: f64, offset: Vec3, normal: Vec3| {
        let (against, distance) = against(offset);
        let [a, b]: [u32; 2] = points;
        let [a, b] = [a, b].map(|point| eval.motion_of_point(point));
        let along = Motion {
            velocity: a.velocity + (b.velocity - a.velocity) * t,
            spread: a.spread.max(b.spread),
        };
        let (vertex, place) = (|vertex| eval.motion_of_point(vertex), offset + view.origin);
        let motion = image.motion(mesh, place, along, vertex, spreads);
        let speed = (motion.velocity - against.velocity).dot(normal).abs();
        (speed + motion.spread + against.spread) / distance
    };
    let images = accel.images(view.origin, planes, events)?;
    let mut weighed: Vec<Weighed> = Vec::new();
    let mut beside = BesideSilhouettes::new(support);
    let mut gathered = Vec::new();
    let mut most = usize::MAX;
    for (number, image) in (0..).zip(&images) {
        let query = ConeQuery {
            apex: image.apex,
            axis: image.direction_in_scene(axis),
            max_angle: widest.clone().fold(0.0, f64::max) + MARGIN,
            edges: EdgeSelection::All,
            groups: SEEN,
            in_front_of: image.in_front_of().or_else(|| accel.behind_near_plane()),
        };
        boundaries.gather(&query, None, usize::MAX, &mut gathered);
        for &(edge, ends) in &gathered {
            // What lies in a mirror is its own image.
            if image.is_in_mirror(ends, accel.horizon_distance()) {
                continue;
            }
            let [a, b] = ends.map(|p| image.point(p) - view.origin);
            // Clip each edge to the pyramid.
            let Some([from, to]) = clip(&planes, 0.0, [a, b]) else {
                continue;
            };
            let [first, last] = [from, to].map(|t| a + (b - a) * t);
            let [start, end] = [first, last].map(|p| view.film(p));
            let length = (end[0] - start[0]).hypot(end[1] - start[1]);
            let contrast = boundaries.contrast(edge, mesh, image.apex);
            // Cut it at equal steps on the film, where perspective shortens the far part.
            let [near, far] = [first, last].map(|p| view.depth(view.origin + p));
            let place = |part| place([from, to], [near, far], part);
            let count = (length / PIECE).ceil().clamp(1.0, 1e3);
            let known = weighed.len();
            let (points, normal) = (boundaries.edge(edge).vertices, a.cross(b).normalized());
            for i in 0..count as u32 {
                let part = |k: f64| (f64::from(i) + k) / count;
                let middle = [0, 1].map(|k| start[k] + (end[k] - start[k]) * part(0.5));
                let filter = support.weight(middle).abs() + LEAST_FILTER / area;
                let range = [place(part(0.0)), place(part(1.0))];
                // Linear along the edge: zero at both ends, it is zero between them.
                let offsets = range.map(|t| a + (b - a) * t);
                let [first, last] = [0, 1].map(|k| match image.is_direct() {
                    true => speed(points, range[k], offsets[k], normal),
                    false => image_speed(image, points, range[k], offsets[k], normal),
                });
                // What stays contributes nothing.
                if first + last == 0.0 {
                    continue;
                }
                weighed.push(Weighed {
                    edge,
                    image: number,
                    range,
                    directions: offsets.map(Vec3::normalized),
                    weight: contrast * filter * length / count,
                    speed: first + last,
                });
            }
            let moves = weighed.len() > known;
            if moves && image.is_direct() {
                beside.push(mesh, view, support, boundaries.edge(edge), [first, last]);
            }
            if weighed.len() > most {
                return None;
            }
        }
        most = most.min(weighed.len() + MOST_MIRRORED);
    }
    // Relative to the fastest one.
    let fastest = weighed.iter().map(|piece| piece.speed).fold(0.0, f64::max);
    let mut pieces = SilhouettePieces::of_camera(images);
    for piece in &weighed {
        pieces.push_seen(
            piece.edge,
            piece.image,
            piece.range,
            piece.directions,
            piece.weight * (piece.speed / fastest).max(LEAST_SPEED),
        );
    }
    pieces.push_nothing(NOTHING / area.sqrt());
    Some(EdgesInPixel { pieces, beside })
}
