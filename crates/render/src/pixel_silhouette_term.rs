//! The boundary term of the edges that the camera sees (METHOD 8): film points do not
//! move, and points are sampled on the projected edges instead.
//!
//! ```text
//! Σ ∫ W [L(behind) - L(before)] ṡ·n dl
//! ```
//!
//! over all edges in the support of the filter that are visible, as they are, through panes or
//! in flat mirrors, with `W` the filter, `L` the
//! radiance on either side of an edge, `ṡ` the velocity of its projection on the film,
//! and `n` the normal of the projection, from behind to before.

use capwalk_boundary::{Counts, Draw, MirrorImage, SilhouettePieces, Stream, moving_image};
use capwalk_math::{Real, Rgb};
use capwalk_scene::sensor::view::ViewRay;

use crate::camera::Camera;
use crate::film::{FILM, FILM_CHOICE};
use crate::pixel::{DrawnPoint, Support};
use crate::pixel_silhouettes::{EdgesInPixel, silhouettes};
use crate::scene_eval::{Primal, SceneEval};
use crate::tracer::{EDGE_NUMBERS, Tracer};

/// A point on an edge that the camera sees, in a sample of a pixel. It gives the number
/// `(light behind - light before) * weight * flow`, a sample of the boundary term.
#[derive(Clone, Copy, Debug)]
pub struct CameraEdge<R> {
    /// The rays beside it, behind the edge and before it. They are so close to it that only double
    /// precision tells what they hit.
    pub sides: [ViewRay<f64>; 2],
    /// The filter, times film area per solid angle.
    pub weight: f64,
    /// `ṡ·n` in the solid angle over the density of the point: a number of value zero, with a
    /// derivative.
    pub flow: R,
}

impl<R> CameraEdge<R> {
    /// This point with something else in place of the flow.
    pub fn map_flow<T>(self, map: impl FnOnce(R) -> T) -> CameraEdge<T> {
        CameraEdge {
            sides: self.sides,
            weight: self.weight,
            flow: map(self.flow),
        }
    }
}

/// There are too many images in mirrors, or edges in them, to gather all of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyImages;

impl Tracer<'_> {
    /// A point on an edge that the camera sees in a pixel, drawn with the random numbers of a
    /// sample; `None` if there is none, it is hidden, or nothing moves there. For devices that
    /// follow the rays beside it themselves, with the sample's random numbers for both.
    pub fn camera_edge<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        pixel: [u32; 2],
        stream: &Stream,
    ) -> Result<Option<CameraEdge<R>>, TooManyImages> {
        let draw = Draw {
            stream,
            counts: &Counts::default(),
        };
        let moving = self.view(eval, draw);
        let camera = Camera {
            primal: moving.value(),
            moving,
        };
        let support = self.supports.pixel(pixel);
        let u = stream.number(EDGE_NUMBERS);
        self.with_silhouettes(eval, &camera, (pixel, &support), |edges| {
            let pieces = &edges.ok_or(TooManyImages)?.pieces;
            Ok(self.draw_camera_edge(eval, &camera, &support, pieces, u, draw))
        })
    }

    /// A sample of this term for one pixel: a number of value zero, with a derivative; and the film point of the
    /// interior term, which stays. `None` if there are too many images in mirrors to gather edges of all of them.
    pub(super) fn pixel_silhouette_term<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        pixel: [u32; 2],
        support: &Support,
        draw: Draw,
    ) -> Option<(Rgb<R>, DrawnPoint)> {
        let count = self.gathers.camera_points.max(1);
        let u = draw.stream.number(EDGE_NUMBERS);
        self.with_silhouettes(eval, camera, (pixel, support), |edges| {
            let Some(EdgesInPixel { pieces, beside }) = edges else {
                draw.count_queries(1);
                return None;
            };
            let mut sum = Rgb::zero();
            for i in 0..count {
                // Points that are spread evenly, each with random numbers of its own for the light.
                let stream = match i {
                    0 => *draw.stream,
                    _ => draw.stream.branch(EDGE_NUMBERS).branch(i),
                };
                let draw = Draw {
                    stream: &stream,
                    ..draw
                };
                let u = (u + f64::from(i)) / f64::from(count);
                let drawn = self.draw_camera_edge(eval, camera, support, pieces, u, draw);
                let Some(edge) = drawn else {
                    continue;
                };
                let shown = self.beside_edges();
                // Trace both sides with the same random numbers, so that their noise cancels.
                let [behind, before] = edge
                    .sides
                    .map(|ray| self.radiance(&Primal(self.accel), ray, shown, draw));
                let weight = edge.weight / f64::from(count);
                sum += Rgb::constant((behind - before) * weight) * edge.flow;
            }
            let point = match self.gathers.beside_silhouettes {
                true => beside.sample(
                    support,
                    draw.stream.number(FILM_CHOICE),
                    draw.stream.pair(FILM),
                ),
                false => support.sample_by_filter(draw.stream.pair(FILM)),
            };
            Some((sum, point))
        })
    }

    /// Calls `then` with the edges in a pixel, gathered now or by another sample; with nothing if
    /// there are too many images in mirrors.
    fn with_silhouettes<R: Real, W: SceneEval<R>, T>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        (pixel, support): ([u32; 2], &Support),
        then: impl FnOnce(Option<&EdgesInPixel>) -> T,
    ) -> T {
        let moving = self.moving.as_ref();
        let field = &moving.expect("only scenes that move have this term").field;
        let events = self.events_behind(0);
        let spreads = match events {
            0 => &[],
            _ => self.mirror_spreads(eval),
        };
        let make = || silhouettes(field, eval, camera, support, events, spreads);
        self.facts.silhouettes.with(pixel, make, then)
    }

    /// The point on an edge that the camera sees that a random number chooses.
    fn draw_camera_edge<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        support: &Support,
        silhouettes: &SilhouettePieces,
        u: f64,
        draw: Draw,
    ) -> Option<CameraEdge<R>> {
        let moving = self.moving.as_ref();
        let field = &moving.expect("only scenes that move have this term").field;
        let view = &camera.primal;
        // The count of queries is the same whichever sample gathers the edges.
        draw.count_queries(1);
        let (accel, events) = (self.accel, self.events_behind(0));
        let sees = |image: &MirrorImage, direction, distance| {
            accel.sees_image(image, view.origin, direction, distance, events)
        };
        // Sample a point on one of them, as it is or in a mirror.
        let is_seen = |image: &_, q, distance| sees(image, q, distance).is_some();
        let point = silhouettes.draw(field.boundaries, view.origin, u, is_seen)?;
        // Hidden edges contribute nothing.
        let image = silhouettes.image(&point);
        let mirrors = sees(image, point.direction, point.distance)?;
        // Evaluate ṡ·n over the density: the motion of the edge against the ray of a fixed
        // film point, which moves with the camera.
        let s = view.film(point.direction);
        let film = camera.moving.direction(s.map(R::constant));
        let ends = point.ends().map(|i| {
            let end = eval.boundary_point(i);
            moving_image(&accel.mesh, &mirrors, end, |vertex| eval.vertex(vertex))
        });
        let flow = point.flow(ends, camera.moving.origin, film);
        // Stop where nothing moves. A camera on the edge itself gives a NaN, which is not
        // constant and is counted with the sample.
        if flow.is_constant() {
            return None;
        }
        Some(CameraEdge {
            sides: point
                .sides_of_paths(field.boundaries, accel)
                .map(|direction| view.ray(direction)),
            weight: support.weight(s) * view.film_area_per_solid_angle(point.direction),
            flow,
        })
    }
}
