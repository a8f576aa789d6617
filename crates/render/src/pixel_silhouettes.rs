//! The edges that the camera may see in each pixel, gathered (METHOD 8).

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use capwalk_boundary::{Field, SEEN, SilhouettePieces, clip, place};
use capwalk_geometry::{ConeQuery, EdgeSelection};
use capwalk_math::sphere;
use capwalk_scene::Scene;
use capwalk_scene::sensor::view::View;

use crate::pixel::Support;

/// A cache of the edges gathered in each pixel. What it keeps changes no result.
#[derive(Default)]
pub struct PixelSilhouettes {
    pixels: Vec<OnceLock<SilhouettePieces>>,
    width: usize,
    /// How many pieces of edges it keeps in all pixels together.
    kept: AtomicUsize,
}

/// The most pieces that it keeps: some hundred megabytes.
const MOST_KEPT: usize = 1 << 22;

/// Length of the longest piece that has one sampling weight, pixels.
const PIECE: f64 = 0.5;
/// Smallest filter value that a sampling weight uses, relative to the filter's mean.
const LEAST_FILTER: f64 = 0.1;
/// Sampling weight of no edge at all, relative to a silhouette across the filter's
/// support: in pixels with creases alone, where the discontinuity is small, few samples
/// take one.
const NOTHING: f64 = 0.05;
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
            pixels: (0..count).map(|_| OnceLock::new()).collect(),
            width,
            kept: AtomicUsize::new(0),
        }
    }

    /// Calls `then` with the pieces of a pixel, from the cache or else from `make`.
    pub fn with<T>(
        &self,
        [x, y]: [u32; 2],
        make: impl Fn() -> SilhouettePieces,
        then: impl FnOnce(&SilhouettePieces) -> T,
    ) -> T {
        let index = y as usize * self.width + x as usize;
        let cell = self.pixels.get(index);
        if let Some(pieces) = cell.and_then(OnceLock::get) {
            return then(pieces);
        }
        let pieces = make();
        if let Some(cell) = cell {
            let kept = self.kept.fetch_add(pieces.count(), Ordering::Relaxed);
            if kept + pieces.count() <= MOST_KEPT {
                return then(cell.get_or_init(|| pieces));
            }
            self.kept.fetch_sub(pieces.count(), Ordering::Relaxed);
        }
        then(&pieces)
    }
}

/// The edges in the support of a pixel's filter, cut into pieces whose sampling weight is
/// their length on the film, times the filter, times a guess of how large the
/// discontinuity is there.
pub fn silhouettes(field: &Field, view: &View<f64>, support: &Support) -> SilhouettePieces {
    // Gather what is in a cone around the support, which is a pyramid of four planes.
    let [x, y] = support.sides.map(|side| side.bounds);
    let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[i, k]| view.direction([x[i], y[k]]));
    let axis = view.direction([0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1])]);
    let widest = corners.iter().map(|&c| sphere::angle_between(axis, c));
    let planes = [0, 1, 2, 3].map(|i| {
        let normal = corners[i].cross(corners[(i + 1) % 4]).normalized();
        normal * normal.dot(axis).signum()
    });
    let query = ConeQuery {
        apex: view.origin,
        axis,
        max_angle: widest.fold(0.0, f64::max) + MARGIN,
        edges: EdgeSelection::All,
        groups: SEEN,
        in_front_of: None,
    };
    let area = support.sides[0].width() * support.sides[1].width();
    let (boundaries, mesh) = (field.boundaries, &field.accel.mesh);
    let mut pieces = SilhouettePieces::of_camera();
    let mut gathered = Vec::new();
    boundaries.gather(&query, &mut gathered);
    for (edge, ends) in gathered {
        let [a, b] = ends.map(|p| p - view.origin);
        // Clip each edge to the pyramid.
        let Some([from, to]) = clip(&planes, 0.0, [a, b]) else {
            continue;
        };
        let [first, last] = [from, to].map(|t| a + (b - a) * t);
        let [start, end] = [first, last].map(|p| view.film(p));
        let length = (end[0] - start[0]).hypot(end[1] - start[1]);
        let contrast = boundaries.contrast(edge, mesh, view.origin);
        // Cut it at equal steps on the film, where perspective shortens the far part.
        let [near, far] = [first, last].map(|p| view.depth(view.origin + p));
        let place = |part| place([from, to], [near, far], part);
        let count = (length / PIECE).ceil().clamp(1.0, 1e3);
        for i in 0..count as u32 {
            let part = |k: f64| (f64::from(i) + k) / count;
            let middle = [0, 1].map(|k| start[k] + (end[k] - start[k]) * part(0.5));
            let filter = support.weight(middle) + LEAST_FILTER / area;
            let range = [place(part(0.0)), place(part(1.0))];
            pieces.push(edge, range, contrast * filter * length / count);
        }
    }
    pieces.push_nothing(NOTHING / area.sqrt());
    pieces
}
