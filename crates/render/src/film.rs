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
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::sensor::view::{View, ViewRay};

use crate::camera::Camera;
use crate::chain::Start;
use crate::pixel::{DrawnPoint, Support};
use crate::plan::LENS;
use crate::radiance::Shown;
use crate::scene_eval::{Primal, SceneEval, Warped};
use crate::tracer::Tracer;

/// First of the two random numbers that choose the place on the film.
pub const FILM: u32 = 0;
/// The random number that chooses between two densities of film points.
pub(crate) const FILM_CHOICE: u32 = 2;
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

/// A point on a side of a pixel's support where the filter is discontinuous.
struct Border {
    s: [f64; 2],
    /// The axis across that side.
    axis: usize,
    /// What the radiance there times the motion along the axis is multiplied by.
    weight: f64,
}

impl<R: Real> FilmPoint<R> {
    fn new(view: &View<R>, warped: Warped<R>) -> Self {
        let area = view.film_area_per_solid_angle(warped.direction);
        Self {
            ray: view.ray(warped.direction),
            film: view.film(warped.direction),
            jacobian: area * R::constant(1.0 / area.value()) * warped.jacobian,
            near_boundary: warped.near_boundary,
        }
    }

    fn moves(&self) -> bool {
        self.near_boundary || self.film.iter().any(|x| !x.is_constant())
    }
}

impl Tracer<'_> {
    /// One sample of a pixel: filtered radiance, and its derivative if `R` has one.
    pub fn pixel<R: Real, W: SceneEval<R>>(&self, eval: &W, pixel: [u32; 2], draw: Draw) -> Rgb<R> {
        let support = self.supports.pixel(pixel);
        let moving = self.view(eval, draw);
        let walks_chains = self.walks_chains(eval);
        if eval.is_stationary() && !walks_chains {
            let point = support.sample_by_filter(draw.stream.pair(FILM));
            return self.interior_of_fixed_point(eval, &moving, point, Shown::All, draw);
        }
        let camera = Camera {
            primal: moving.value(),
            moving,
        };
        // Light by way of curved mirrors and glass has fields of its own.
        match walks_chains {
            true => {
                self.pixel_of(eval, &camera, (pixel, &support), Shown::Covered, draw)
                    + self.chained_pixel(eval, &camera, &support, draw)
            }
            false => self.pixel_of(eval, &camera, (pixel, &support), Shown::All, draw),
        }
    }

    /// One sample of what is shown of it, by the field around the camera.
    fn pixel_of<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        (pixel, support): ([u32; 2], &Support),
        shown: Shown,
        draw: Draw,
    ) -> Rgb<R> {
        if eval.is_stationary() {
            let point = support.sample_by_filter(draw.stream.pair(FILM));
            return self.interior_of_fixed_point(eval, &camera.moving, point, shown, draw);
        }
        if self.gathers.camera
            && eval.moves()
            && let Some((term, point)) =
                self.pixel_silhouette_term(eval, camera, pixel, support, draw)
        {
            // Film points stay, also those on the border: there is no pixel-border term.
            return self.interior_of_fixed_point(eval, &camera.moving, point, shown, draw) + term;
        }
        let light = self.interior(eval, camera, support, shown, draw);
        match support.is_discontinuous() {
            true => light + self.pixel_border_term(eval, camera, support, shown, draw),
            false => light,
        }
    }

    /// One sample of what arrives at it by chains of specular events that have fields of their own: both terms.
    fn chained_pixel<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        support: &Support,
        draw: Draw,
    ) -> Rgb<R> {
        let stream = draw.stream;
        let s = support.sample(UNIFORM, stream.number(FILM_CHOICE), stream.pair(FILM));
        let density = support.pdf(UNIFORM, s);
        // As in [`Self::interior`].
        let points = match support.is_discontinuous() {
            true => vec![s],
            false => vec![s, support.mirror(s)],
        };
        let view = &camera.moving;
        let (viewpoint, start) = (self.camera_viewpoint(view), Start::Camera(*view));
        let mut light = Rgb::zero();
        for (walk, &s) in (0..).zip(&points) {
            let q = camera.primal.direction(s);
            let ahead = self.ahead_of_camera(eval, &view.ray(Vec3::constant(q)), draw);
            let (settings, numbers) = self.film_walk(walk, draw);
            for (events, shown) in ahead.chains() {
                let field = self.chain_field(&viewpoint, &start, events);
                let point = FilmPoint::new(view, field.warp(eval, q, settings, numbers));
                let density = density * points.len() as f64;
                light += self.share(eval, support, &point, density, shown, draw);
            }
        }
        for Border { s, axis, weight } in self.borders(support, draw) {
            let primal = Primal(self.accel);
            let q = camera.primal.direction(s);
            let ray = camera.primal.ray(q);
            let ahead = self.ahead_of_camera(&primal, &ray, draw);
            let (settings, numbers) = self.film_walk(2, draw);
            for (events, shown) in ahead.chains() {
                let field = self.chain_field(&viewpoint, &start, events);
                let film = view.film(field.warp_value(eval, q, settings, numbers))[axis];
                let radiance = self.radiance(&primal, ray, shown, draw);
                light += Rgb::constant(radiance * weight) * (film - R::constant(film.value()));
            }
        }
        light
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
        let point = support.sample_by_filter(stream.pair(FILM));
        (
            ray_of_fixed_point(&self.view(eval, draw), point.place),
            point.weight,
        )
    }

    /// What the camera sees from a point sampled on its lens.
    #[inline]
    pub(crate) fn view<R: Real, W: SceneEval<R>>(&self, eval: &W, draw: Draw) -> View<R> {
        let has_lens = self.accel.scene.sensor.model.has_lens();
        eval.view(has_lens.then(|| uniform_disk(draw.stream.pair(LENS))))
    }

    /// The interior term with film points that stay: `∫ d/dε (W L / J) dω`, by one of them; all of a primal image, and
    /// of a derivative that moves nothing on the film.
    fn interior_of_fixed_point<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        view: &View<R>,
        DrawnPoint { place, weight }: DrawnPoint,
        shown: Shown,
        draw: Draw,
    ) -> Rgb<R> {
        // Outside of the support nothing is to be traced.
        if weight == 0.0 {
            return Rgb::zero();
        }
        self.weighted(
            eval,
            ray_of_fixed_point(view, place),
            R::constant(weight),
            shown,
            draw,
        )
    }

    /// A sample of the radiance along a camera ray, times its weight in the pixel.
    fn weighted<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        ray: ViewRay<R>,
        weight: R,
        shown: Shown,
        draw: Draw,
    ) -> Rgb<R> {
        self.radiance(eval, ray, shown, draw) * weight
    }

    /// The interior term with warped film points.
    fn interior<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        support: &Support,
        shown: Shown,
        draw: Draw,
    ) -> Rgb<R> {
        let stream = draw.stream;
        // Sample a film point, half of the time by the filter, half uniformly.
        let s = support.sample(UNIFORM, stream.number(FILM_CHOICE), stream.pair(FILM));
        let density = support.pdf(UNIFORM, s);
        let point = self.film_point(eval, camera, s, 0, draw);
        if support.is_discontinuous() {
            return self.share(eval, support, &point, density, shown, draw);
        }
        // The filter's derivative has opposite signs on opposite sides of its centre: where
        // the image moves, the mean over a film point and its mirror image has far less
        // noise.
        let other = self.film_point(eval, camera, support.mirror(s), 1, draw);
        if !point.moves() && !other.moves() {
            return self.share(eval, support, &point, density, shown, draw);
        }
        // Each of them half.
        let density = 2.0 * density;
        self.share(eval, support, &point, density, shown, draw)
            + self.share(eval, support, &other, density, shown, draw)
    }

    /// What a film point sampled with this density adds: `W L / J` times the Jacobian of the
    /// warp, over the density.
    fn share<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        support: &Support,
        point: &FilmPoint<R>,
        density: f64,
        shown: Shown,
        draw: Draw,
    ) -> Rgb<R> {
        let weight = support.weight(point.film) * point.jacobian * R::constant(1.0 / density);
        self.weighted(eval, point.ray, weight, shown, draw)
    }

    /// The pixel-border term `-∮ W L ṡ·n dl`: a number of value zero, with a derivative.
    fn pixel_border_term<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        support: &Support,
        shown: Shown,
        draw: Draw,
    ) -> Rgb<R> {
        let mut light = Rgb::zero();
        for Border { s, axis, weight } in self.borders(support, draw) {
            // Evaluate ṡ·n: how fast the warp moves the film point across the side.
            let film = self.warped_film_point(eval, camera, s, draw)[axis];
            let flow = film - R::constant(film.value());
            if !flow.is_constant() {
                let ray = camera.primal.ray(camera.primal.direction(s));
                let radiance = self.radiance(&Primal(self.accel), ray, shown, draw);
                light += Rgb::constant(radiance * weight) * flow;
            }
        }
        light
    }

    /// A point on each of two opposite sides of the support, as far as the filter is discontinuous there: at the same
    /// place, and with the same random numbers, so that their noise cancels where the image moves as a whole.
    fn borders<'s>(&self, support: &'s Support, draw: Draw) -> impl Iterator<Item = Border> + 's {
        // Choose the pair of sides across one axis, and a place along them.
        let first = self.film_numbers();
        let axis = usize::from(draw.stream.number(first) < 0.5);
        let (side, along) = (support.sides[axis], support.sides[1 - axis]);
        let place = along.bounds[0] + along.width() * draw.stream.number(first + 1);
        let ends = [(0, -1.0), (1, 1.0)].into_iter();
        let ends = ends.filter(move |&(end, _)| side.discontinuous[end]);
        ends.map(move |(end, outward)| {
            let mut s = [place; 2];
            s[axis] = side.bounds[end];
            // Divide by the density: one axis of two, uniform along the side.
            let weight = -outward * support.weight(s) * 2.0 * along.width();
            Border { s, axis, weight }
        })
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
        FilmPoint::new(view, warped)
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

/// The ray through a film point that stays.
fn ray_of_fixed_point<R: Real>(view: &View<R>, s: [f64; 2]) -> ViewRay<R> {
    view.ray(view.direction(s.map(R::constant)))
}

/// A uniform point of the unit disk.
pub fn uniform_disk(u: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = (2.0 * PI * u[1]).sin_cos();
    [cos, sin].map(|x| x * u[0].sqrt())
}
