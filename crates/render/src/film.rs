//! The integral over a pixel: film points that move with the field around the
//! camera, and the flux where the filter ends.

use std::f64::consts::PI;

use capwalk_boundary::{Draw, Viewpoint};
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::sensor::view::{View, ViewRay};

use crate::camera::Camera;
use crate::pixel::Support;
use crate::plan::LENS;
use crate::scene_eval::{Primal, SceneEval};
use crate::tracer::Tracer;

/// Random numbers by purpose: where in the pixel.
const FILM: u32 = 0;
/// Which way to draw the film point.
const FILM_CHOICE: u32 = 2;
/// Share of film points drawn uniformly over the support: the derivative of a
/// filter stays finite where the filter goes to zero, so drawing by the filter
/// alone would give derivatives infinite variance.
const UNIFORM: f64 = 0.5;

/// A film point that moves with the field around the camera.
struct FilmPoint<R> {
    /// Where it looks.
    ray: ViewRay<R>,
    /// The moving film point.
    film: [R; 2],
    /// Film area per solid angle over its value, times the field's jacobian: 1,
    /// and its change.
    jacobian: R,
    near_boundary: bool,
}

impl<R: Real> FilmPoint<R> {
    fn moves(&self) -> bool {
        self.near_boundary || self.film.iter().any(|x| !x.is_constant())
    }
}

impl Tracer<'_> {
    /// One sample of a pixel.
    pub fn pixel<R: Real, W: SceneEval<R>>(&self, eval: &W, pixel: [u32; 2], draw: Draw) -> Rgb<R> {
        let support = self.supports.pixel(pixel);
        let camera = self.camera(eval, draw);
        if W::MOVES && self.gathers_for_camera() && eval.moves() {
            // Film points stay, also at the border of the pixel.
            return self.interior_at_rest(eval, &camera, &support, draw)
                + self.pixel_silhouette_term(eval, &camera, pixel, &support, draw);
        }
        let light = self.interior(eval, &camera, &support, draw);
        match W::MOVES && support.jumps() {
            true => light + self.pixel_border_term(eval, &camera, &support, draw),
            false => light,
        }
    }

    /// The camera, from a point of its lens.
    fn camera<R: Real, W: SceneEval<R>>(&self, eval: &W, draw: Draw) -> Camera<R> {
        let scene = &self.accel.scene;
        let lens = match scene.sensor.model.has_lens() {
            true => uniform_disk(draw.stream.pair(LENS)),
            false => [0.0; 2],
        };
        let moving = View::new(&scene.sensor, &scene.film, &eval.sensor(), lens);
        Camera {
            primal: moving.value(),
            moving,
        }
    }

    /// The integral at film points that stay, drawn as for the image.
    fn interior_at_rest<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        support: &Support,
        draw: Draw,
    ) -> Rgb<R> {
        let stream = draw.stream;
        let s = support.sample(0.0, stream.number(FILM_CHOICE), stream.pair(FILM));
        let view = &camera.moving;
        let ray = view.ray(view.direction(s.map(R::constant)));
        let weight = support.weight(s) / support.pdf(0.0, s);
        self.radiance(eval, ray, draw) * R::constant(weight)
    }

    fn interior<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        support: &Support,
        draw: Draw,
    ) -> Rgb<R> {
        let stream = draw.stream;
        let uniform = if W::MOVES { UNIFORM } else { 0.0 };
        let s = support.sample(uniform, stream.number(FILM_CHOICE), stream.pair(FILM));
        let density = support.pdf(uniform, s);
        let point = self.film_point(eval, camera, s, 0, draw);
        if !W::MOVES || support.jumps() {
            return self.share(eval, support, &point, density, draw);
        }
        // The filter's derivative points opposite ways on opposite sides of its
        // centre: where the image moves, averaging both removes most of its
        // noise.
        let other = self.film_point(eval, camera, support.mirror(s), 1, draw);
        if !point.moves() && !other.moves() {
            return self.share(eval, support, &point, density, draw);
        }
        let both = self.share(eval, support, &point, density, draw)
            + self.share(eval, support, &other, density, draw);
        both * R::constant(0.5)
    }

    /// The share of a film point drawn with `density`: `W L / J` times the
    /// field's jacobian.
    fn share<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        support: &Support,
        point: &FilmPoint<R>,
        density: f64,
        draw: Draw,
    ) -> Rgb<R> {
        let weight = support.weight(point.film) * point.jacobian * R::constant(1.0 / density);
        self.radiance(eval, point.ray, draw) * weight
    }

    /// `-∮ W L ṡ·n dl` along the sides of the support where the filter jumps.
    /// Opposite sides are sampled at the same place with the same numbers, so
    /// that an image that moves as a whole costs little noise.
    fn pixel_border_term<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        support: &Support,
        draw: Draw,
    ) -> Rgb<R> {
        let mut flux = Rgb::zero();
        let stream = draw.stream;
        let first = self.film_numbers();
        let axis = usize::from(stream.number(first) < 0.5);
        let (side, along) = (support.sides[axis], support.sides[1 - axis]);
        let place = along.bounds[0] + along.width() * stream.number(first + 1);
        for (end, outward) in [(0, -1.0), (1, 1.0)] {
            if !side.jumps[end] {
                continue;
            }
            let mut s = [place; 2];
            s[axis] = side.bounds[end];
            let film = self.carried_film_point(eval, camera, s, draw)[axis];
            let flow = film - R::constant(film.value());
            if !flow.is_constant() {
                // Two axes, each drawn half of the time.
                let weight = support.weight(s) * 2.0 * along.width();
                let ray = camera.primal.ray(camera.primal.direction(s));
                let light = self.radiance(&Primal(self.accel), ray, draw);
                flux += Rgb::constant(light * (-outward * weight)) * flow;
            }
        }
        flux
    }

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
        if !W::MOVES {
            return FilmPoint {
                ray: view.ray(Vec3::constant(q)),
                film: s.map(R::constant),
                jacobian: R::constant(1.0),
                near_boundary: false,
            };
        }
        let (settings, numbers) = self.film_walk(walk, draw);
        let warped = eval.warp(&self.camera_eye(view), q, settings, numbers);
        let area = view.film_area_per_solid_angle(warped.direction);
        FilmPoint {
            ray: view.ray(warped.direction),
            film: view.film(warped.direction),
            jacobian: area * R::constant(1.0 / area.value()) * warped.jacobian,
            near_boundary: warped.near_boundary,
        }
    }

    /// Where the field carries a film point, pixels.
    fn carried_film_point<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        camera: &Camera<R>,
        s: [f64; 2],
        draw: Draw,
    ) -> [R; 2] {
        let (settings, numbers) = self.film_walk(2, draw);
        let q = camera.primal.direction(s);
        let view = &camera.moving;
        view.film(eval.warp_value(&self.camera_eye(view), q, settings, numbers))
    }

    fn camera_eye<R: Real>(&self, view: &View<R>) -> Viewpoint<R> {
        Viewpoint::camera(view, self.events_behind(0))
    }
}

/// A uniform point of the unit disk.
fn uniform_disk(u: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = (2.0 * PI * u[1]).sin_cos();
    [cos, sin].map(|x| x * u[0].sqrt())
}
