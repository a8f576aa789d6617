//! The flux through the edges that the camera sees, METHOD 8: film points stay, and
//! what moves across them is sampled on the edges themselves.
//!
//! With `W` the filter, `L` the radiance on either side of an edge, and `ṡ` the
//! velocity of the edge on the film,
//!
//! ```text
//! Σ ∫ W [L(behind) - L(before)] ṡ·n dl
//! ```
//!
//! over all visible edges in the support of the filter.

use capwalk_boundary::Draw;
use capwalk_math::{Real, Rgb};

use crate::camera::Camera;
use crate::pixel::Support;
use crate::pixel_silhouettes::silhouettes;
use crate::scene_eval::{Primal, SceneEval};
use crate::tracer::{EDGE_NUMBERS, Moving, Tracer};

impl Tracer<'_> {
    /// True if film points stay, and edges before the camera are gathered: if none
    /// of them is seen in a mirror.
    pub(super) fn gathers_for_camera(&self) -> bool {
        let gathers = |moving: &Moving| moving.field.method.traits().gathers;
        self.moving.as_ref().is_some_and(gathers)
            && !self.accel.view.is_parallel()
            && self.events_behind(0) == 0
    }

    /// A sample of the flux in a pixel.
    pub(super) fn pixel_silhouette_term<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        pixel: [u32; 2],
        support: &Support,
        draw: Draw,
    ) -> Rgb<R> {
        let moving = self.moving.as_ref();
        let field = &moving.expect("only scenes that move have this term").field;
        let view = &camera.primal;
        // Whether the list is kept does not show in what is counted.
        draw.count_queries(1);
        let make = || silhouettes(field, view, support);
        let u = draw.stream.number(EDGE_NUMBERS);
        let point = self.silhouettes.with(pixel, make, |silhouettes| {
            silhouettes.draw(field.boundaries, view.eye, u)
        });
        let Some(point) = point else {
            return Rgb::zero();
        };
        let s = view.film(point.direction);
        let film = camera.moving.direction(s.map(R::constant));
        let ends = point.ends().map(|i| eval.boundary_point(i));
        let flow = point.flow(ends, camera.moving.eye, film);
        // Not a number where the camera touches the edge: it goes on, to be counted.
        if flow.is_constant() {
            return Rgb::zero();
        }
        let accel = self.accel;
        if !accel.camera_sees(view.eye, point.direction, point.distance) {
            return Rgb::zero();
        }
        let weight = support.weight(s) * view.film_area_per_solid_angle(point.direction);
        // The same random numbers on both sides.
        let [behind, before] = point
            .sides()
            .map(|direction| self.radiance(&Primal(accel), view.ray(direction), draw));
        Rgb::constant((behind - before) * weight) * flow
    }
}
