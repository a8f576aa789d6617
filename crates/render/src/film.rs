//! The integral over a pixel (METHOD 4). With `s` a film point, `W` the reconstruction
//! filter, `L` the radiance, `u` the field around the camera, `ṡ` the velocity that it
//! gives to film points, and `J` solid angle per film area, its derivative is
//!
//! ```text
//! ∫ [d/dε (W L / J)(warped) + (W L / J) div u] dω  -  ∮ W L ṡ·n dl
//! ```
//!
//! The first is the interior term; the second, the pixel-border term, is over the sides
//! of the support where the filter is discontinuous.

use std::f64::consts::PI;

use capwalk_boundary::{Counts, Draw, Stream, Viewpoint};
use capwalk_math::{Real, Rgb};
use capwalk_scene::sensor::view::{View, ViewRay};

use crate::camera::Camera;
use crate::pixel::Support;
use crate::plan::LENS;
use crate::scene_eval::{Primal, SceneEval};
use crate::tracer::Tracer;

/// First of the two random numbers that choose the place on the film.
pub const FILM: u32 = 0;
/// The random number that chooses between the two densities of film points.
const FILM_CHOICE: u32 = 2;
/// Share of film points drawn uniformly over the support: the derivative of a
/// filter stays finite where the filter goes to zero, so drawing by the filter
/// alone would give derivatives infinite variance.
const UNIFORM: f64 = 0.5;

/// A film point, warped by the field around the camera.
struct FilmPoint<R> {
    /// The camera ray through it.
    ray: ViewRay<R>,
    /// Where it is on the film, pixels.
    film: [R; 2],
    /// `1 / J` relative to its primal value, times the Jacobian of the warp: value 1.
    jacobian: R,
    /// True if a boundary was within the reach of the field.
    near_boundary: bool,
}

impl<R: Real> FilmPoint<R> {
    fn moves(&self) -> bool {
        self.near_boundary || self.film.iter().any(|x| !x.is_constant())
    }
}

impl Tracer<'_> {
    /// One sample of a pixel: filtered radiance, and its derivative if `R` has one.
    pub fn pixel<R: Real, W: SceneEval<R>>(&self, eval: &W, pixel: [u32; 2], draw: Draw) -> Rgb<R> {
        let support = self.supports.pixel(pixel);
        let moving = self.view(eval, draw);
        if eval.is_stationary() {
            return self.interior_of_fixed_points(eval, &moving, &support, draw);
        }
        let camera = Camera {
            primal: moving.value(),
            moving,
        };
        if self.gathers.camera
            && eval.moves()
            && let Some(term) = self.pixel_silhouette_term(eval, &camera, pixel, &support, draw)
        {
            // Film points stay, also those on the border: there is no pixel-border term.
            return self.interior_of_fixed_points(eval, &camera.moving, &support, draw) + term;
        }
        let light = self.interior(eval, &camera, &support, draw);
        match support.is_discontinuous() {
            true => light + self.pixel_border_term(eval, &camera, &support, draw),
            false => light,
        }
    }

    /// The camera's ray of a sample through a film point that stays, and its weight in the pixel.
    pub fn camera_ray<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        pixel: [u32; 2],
        stream: &Stream,
    ) -> (ViewRay<R>, f64) {
        let draw = Draw {
            stream,
            counts: &Counts::default(),
        };
        let support = self.supports.pixel(pixel);
        self.fixed_film_point(&self.view(eval, draw), &support, draw)
    }

    /// The ray through a film point that stays, sampled by the filter, and its weight.
    fn fixed_film_point<R: Real>(
        &self,
        view: &View<R>,
        support: &Support,
        draw: Draw,
    ) -> (ViewRay<R>, f64) {
        let s = support.sample(0.0, 0.0, draw.stream.pair(FILM));
        let ray = view.ray(view.direction(s.map(R::constant)));
        (ray, support.weight_over_pdf(s))
    }

    /// What the camera sees from a point sampled on its lens.
    #[inline]
    pub(crate) fn view<R: Real, W: SceneEval<R>>(&self, eval: &W, draw: Draw) -> View<R> {
        let has_lens = self.accel.scene.sensor.model.has_lens();
        eval.view(has_lens.then(|| uniform_disk(draw.stream.pair(LENS))))
    }

    /// The interior term with film points that stay: `∫ d/dε (W L / J) dω`, sampled as in
    /// a primal rendering; all of a primal image, and of a derivative that moves nothing on the film.
    fn interior_of_fixed_points<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        view: &View<R>,
        support: &Support,
        draw: Draw,
    ) -> Rgb<R> {
        let (ray, weight) = self.fixed_film_point(view, support, draw);
        self.weighted(eval, ray, R::constant(weight), draw)
    }

    /// A sample of the radiance along a camera ray, times its weight in the pixel.
    fn weighted<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        ray: ViewRay<R>,
        weight: R,
        draw: Draw,
    ) -> Rgb<R> {
        // What is missing of it has the same weight.
        let others = draw.counts.missing.replace(Rgb::zero());
        let light = self.radiance(eval, ray, draw) * weight;
        let missing = draw.counts.missing.get() * weight.value();
        draw.counts.missing.set(others + missing);
        light
    }

    /// The interior term with warped film points.
    fn interior<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        support: &Support,
        draw: Draw,
    ) -> Rgb<R> {
        let stream = draw.stream;
        // Sample a film point, half of the time by the filter, half uniformly.
        let s = support.sample(UNIFORM, stream.number(FILM_CHOICE), stream.pair(FILM));
        let density = support.pdf(UNIFORM, s);
        let point = self.film_point(eval, camera, s, 0, draw);
        if support.is_discontinuous() {
            return self.share(eval, support, &point, density, draw);
        }
        // The filter's derivative has opposite signs on opposite sides of its centre: where
        // the image moves, the mean over a film point and its mirror image has far less
        // noise.
        let other = self.film_point(eval, camera, support.mirror(s), 1, draw);
        if !point.moves() && !other.moves() {
            return self.share(eval, support, &point, density, draw);
        }
        // Each of them half.
        let density = 2.0 * density;
        self.share(eval, support, &point, density, draw)
            + self.share(eval, support, &other, density, draw)
    }

    /// What a film point sampled with this density adds: `W L / J` times the Jacobian of the
    /// warp, over the density.
    fn share<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        support: &Support,
        point: &FilmPoint<R>,
        density: f64,
        draw: Draw,
    ) -> Rgb<R> {
        let weight = support.weight(point.film) * point.jacobian * R::constant(1.0 / density);
        self.weighted(eval, point.ray, weight, draw)
    }

    /// The pixel-border term `-∮ W L ṡ·n dl`: a number of value zero, with a derivative.
    /// Opposite sides are sampled at the same place with the same random numbers, so that
    /// their noise cancels where the image moves as a whole.
    fn pixel_border_term<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        support: &Support,
        draw: Draw,
    ) -> Rgb<R> {
        let mut light = Rgb::zero();
        let stream = draw.stream;
        // Choose the pair of sides across one axis, and a place along them.
        let first = self.film_numbers();
        let axis = usize::from(stream.number(first) < 0.5);
        let (side, along) = (support.sides[axis], support.sides[1 - axis]);
        let place = along.bounds[0] + along.width() * stream.number(first + 1);
        for (end, outward) in [(0, -1.0), (1, 1.0)] {
            if !side.discontinuous[end] {
                continue;
            }
            // Evaluate ṡ·n: how fast the warp moves the film point across the side.
            let mut s = [place; 2];
            s[axis] = side.bounds[end];
            let film = self.warped_film_point(eval, camera, s, draw)[axis];
            let flow = film - R::constant(film.value());
            if !flow.is_constant() {
                // Divide by the density: one axis of two, uniform along the side.
                let weight = support.weight(s) * 2.0 * along.width();
                let ray = camera.primal.ray(camera.primal.direction(s));
                let radiance = self.radiance(&Primal(self.accel), ray, draw);
                light += Rgb::constant(radiance * (-outward * weight)) * flow;
            }
        }
        light
    }

    /// A film point, warped by the field.
    fn film_point<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        s: [f64; 2],
        walk: u32,
        draw: Draw,
    ) -> FilmPoint<R> {
        let view = &camera.moving;
        let q = camera.primal.direction(s);
        let (settings, numbers) = self.film_walk(walk, draw);
        let warped = eval.warp(&self.camera_viewpoint(view), q, settings, numbers);
        let area = view.film_area_per_solid_angle(warped.direction);
        FilmPoint {
            ray: view.ray(warped.direction),
            film: view.film(warped.direction),
            jacobian: area * R::constant(1.0 / area.value()) * warped.jacobian,
            near_boundary: warped.near_boundary,
        }
    }

    /// Where the warp moves a film point, pixels.
    fn warped_film_point<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        s: [f64; 2],
        draw: Draw,
    ) -> [R; 2] {
        let (settings, numbers) = self.film_walk(2, draw);
        let q = camera.primal.direction(s);
        let view = &camera.moving;
        view.film(eval.warp_value(&self.camera_viewpoint(view), q, settings, numbers))
    }

    fn camera_viewpoint<R: Real>(&self, view: &View<R>) -> Viewpoint<R> {
        Viewpoint::camera(view, self.events_behind(0))
    }
}

/// A uniform point of the unit disk.
pub fn uniform_disk(u: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = (2.0 * PI * u[1]).sin_cos();
    [cos, sin].map(|x| x * u[0].sqrt())
}
