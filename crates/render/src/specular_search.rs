//! The part of a probe that aims by mirrors at what moves (METHOD 6): small things are seen in few
//! directions, which paths at random hardly meet.
//!
//! Of some directions from a viewpoint to mirrors, the one is improved whose chain of specular
//! events ends nearest to a point of what moves, by Newton's method.

use capwalk_math::{Frame, Real, Vec3};

use crate::scene_eval::{Primal, SceneEval};
use crate::specular_probe::{RULES, Random, Segment, SpecularProbe};
use crate::uncovered_events::UncoveredEvents;

/// How many searches there are: half of them from the camera, half from surfaces that it sees.
const SEARCHES: u32 = 32;
/// Directions that a search begins with.
const BEGINNINGS: u32 = 8;
/// Most steps of a search, and how often each is halved until it is one to the better.
const STEPS: u32 = 8;
const SHORTER: u32 = 4;
/// Over this part of the width of a mirror derivatives are taken.
const SHORT: f64 = 1e-3;
/// The width of a mirror, radians, of which only one direction is known.
const LONE_WIDTH: f64 = 0.01;

/// Keeps random numbers of searches apart from those of paths.
const FIRST_SEARCH: u64 = 1 << 32;

impl SpecularProbe<'_> {
    /// How many searches there are; none where no shape moves.
    pub fn searches(&self) -> u32 {
        let is_aimed = self.point_that_moves(&mut Random::new(0)).is_some()
            && self.point_on_mirror(&mut Random::new(0)).is_some();
        if is_aimed { SEARCHES } else { 0 }
    }

    /// What a search finds.
    pub fn search<R: Real, W: SceneEval<R>>(&self, eval: &W, search: u32) -> UncoveredEvents {
        let mut found = UncoveredEvents::default();
        let mut random = Random::new(FIRST_SEARCH + u64::from(search));
        let rule = (search / 2) % RULES as u32;
        let segment = match search % 2 {
            0 => self.search_from_camera(eval, rule, &mut random),
            _ => self.search_from_surface(eval, rule, &mut random),
        };
        if let Some(segment) = segment {
            self.along(eval, segment, rule, &mut found);
        }
        found
    }

    fn search_from_camera<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        rule: u32,
        random: &mut Random,
    ) -> Option<Segment<R>> {
        let view = self.view(eval, random);
        let still = view.value();
        let begin = |random: &mut Random| {
            let point = self.point_on_mirror(random)?;
            Some(still.towards(point).normalized())
        };
        let launch = |direction: Vec3| {
            let film = still.film(direction);
            let is_before = still.direction(film).dot(direction) > 0.0;
            (is_before && self.is_on_film(film)).then(|| self.camera_segment(&still, film))
        };
        let direction = self.best_direction(begin, launch, rule, random)?;
        Some(self.camera_segment(&view, still.film(direction)))
    }

    fn search_from_surface<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        rule: u32,
        random: &mut Random,
    ) -> Option<Segment<R>> {
        let view = self.view(eval, random);
        let first = self.camera_segment(&view, self.film_point(random.pair()));
        let (vertex, _) = self.arrive(eval, &first, &mut UncoveredEvents::default())?;
        if !vertex.bsdf.has_smooth() || !self.goes_on(&first) {
            return None;
        }
        let primal = vertex.value();
        let past = self.past(&first, &primal, random);
        let begin = |random: &mut Random| self.aim(&primal, random);
        let still = Primal(self.tracer.accel);
        let launch = |direction: Vec3| self.scattered(&still, &primal, direction, past);
        let direction = self.best_direction(begin, launch, rule, random)?;
        self.scattered(eval, &vertex, direction, past)
    }

    /// The direction whose chain of specular events by a rule ends nearest to a point of what
    /// moves; `None` if no direction of the beginning leads to a chain that is not covered.
    fn best_direction(
        &self,
        begin: impl Fn(&mut Random) -> Option<Vec3>,
        launch: impl Fn(Vec3) -> Option<Segment<f64>>,
        rule: u32,
        random: &mut Random,
    ) -> Option<Vec3> {
        let target = self.point_that_moves(random)?;
        let eval = Primal(self.tracer.accel);
        // What the chain's last ray is off the direction to the target.
        let error = |direction: Vec3| {
            let found = &mut UncoveredEvents::default();
            let last = self.along(&eval, launch(direction)?, rule, found)?;
            let [origin, towards] = last.ray;
            Some(towards - (target - origin).normalized())
        };
        let beginnings = (0..BEGINNINGS).filter_map(|_| {
            let direction = begin(random)?;
            Some((error(direction)?, direction))
        });
        let beginnings: Vec<(Vec3, Vec3)> = beginnings.collect();
        let by_size = |a: &&(Vec3, Vec3), b: &&(Vec3, Vec3)| a.0.length().total_cmp(&b.0.length());
        let &(mut least, mut direction) = beginnings.iter().min_by(by_size)?;
        // About as long as the mirror is wide from here.
        let others = beginnings
            .iter()
            .map(|(_, other)| (*other - direction).length());
        let others = others.filter(|&length| length > 0.0);
        let width = others.reduce(f64::min).unwrap_or(LONE_WIDTH);
        for _ in 0..STEPS {
            let Some(mut step) = newton_step(error, direction, least, SHORT * width) else {
                break;
            };
            step = step * (width / step.length()).min(1.0);
            let mut tries = (0..SHORTER).map(|_| {
                let next = (direction + step).normalized();
                step = step * 0.5;
                error(next).map(|error| (error, next))
            });
            let closer = |next: &(Vec3, Vec3)| next.0.length() < least.length();
            let Some(next) = tries.find_map(|next| next.filter(closer)) else {
                break;
            };
            (least, direction) = next;
        }
        Some(direction)
    }
}

/// The change of a direction that would make an error zero if it were linear; its derivatives are
/// differences over a short distance. `None` where one of them is not known.
fn newton_step(
    error: impl Fn(Vec3) -> Option<Vec3>,
    direction: Vec3,
    value: Vec3,
    short: f64,
) -> Option<Vec3> {
    let frame = Frame::from_normal(direction);
    let derivative = |axis: Vec3| {
        let moved = error((direction + axis * short).normalized())?;
        Some((moved - value) * (1.0 / short))
    };
    let (a, b) = (derivative(frame.s)?, derivative(frame.t)?);
    // Least squares.
    let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
    let (ar, br) = (a.dot(value), b.dot(value));
    let scale = -1.0 / (aa * bb - ab * ab);
    let step = (frame.s * (bb * ar - ab * br) + frame.t * (aa * br - ab * ar)) * scale;
    step.is_finite().then_some(step)
}
