//! Light that arrives by chains of specular events whose silhouettes are in no field of a viewpoint: by curved mirrors
//! and glass. Each sequence of events is an integral of its own, with the field along its chain ([`ChainField`]); all
//! other light is left to the terms of [`crate::radiance`] and [`crate::film`].

use capwalk_boundary::{Draw, Viewpoint};
use capwalk_geometry::Hit;
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::lobe::Event;
use capwalk_scene::sensor::view::ViewRay;

use crate::chain::Start;
use crate::chain_field::ChainField;
use crate::light::emitter_towards;
use crate::plan::EMITTER_NUMBERS;
use crate::radiance::{Shown, SpecularChain};
use crate::scene_eval::SceneEval;
use crate::tracer::Tracer;
use crate::vertex::Vertex;

/// The specular events that a path will meet, before it is traced.
#[derive(Default)]
pub(crate) struct Ahead {
    events: Vec<Event>,
    /// After how many of them light may arrive that no field of the viewpoint covers.
    counts: Vec<u32>,
}

impl Ahead {
    /// The sequences of events by which such light may arrive, each with what of a path it is.
    pub(crate) fn chains(&self) -> impl Iterator<Item = (&[Event], Shown)> {
        let counts = self.counts.iter();
        counts.map(|&count| (&self.events[..count as usize], Shown::After(count)))
    }

    /// Notes that light may arrive after all events so far.
    fn note(&mut self) {
        let count = self.events.len() as u32;
        if self.counts.last() != Some(&count) {
            self.counts.push(count);
        }
    }
}

impl Tracer<'_> {
    /// The events of a path along a ray that hits this at the vertex of number `first`; it draws them by the same
    /// random numbers.
    pub(crate) fn ahead<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        mut ray: [Vec3<R>; 2],
        mut hit: Option<Hit>,
        first: u32,
        mut chain: SpecularChain,
        draw: Draw,
    ) -> Ahead {
        let (accel, plan) = (self.accel, &self.plan);
        let (mut ahead, mut is_missed) = (Ahead::default(), false);
        let mut throughput = Rgb::splat(1.0);
        for depth in first.. {
            let Some(vertex) = self.path_vertex(eval, ray, hit, depth, &mut chain) else {
                break;
            };
            if is_missed && vertex.bsdf.has_smooth() {
                ahead.note();
            }
            let primal = eval.primal(&vertex);
            let number =
                plan.vertex_numbers(depth) + plan.sampling.emitter_samples * EMITTER_NUMBERS;
            let (choice, u) = (draw.stream.number(number), draw.stream.pair(number + 1));
            let drawn = primal.bsdf.sample(primal.wi, choice, u);
            let Some((event, probability)) =
                drawn.and_then(|drawn| Some((drawn.specular?, drawn.pdf)))
            else {
                break;
            };
            is_missed |= self.misses(chain, event);
            chain = chain.followed_by(event.event);
            ahead.events.push(event.event);
            let fraction;
            (ray, fraction) = vertex.specular(event, ray);
            // What passes keeps its origin, before the surface.
            let direction = ray[1].value();
            let leaving = primal.leaving(event.event);
            hit = accel.first_hit_within(&accel.ray_leaving(&leaving, primal.position, direction));
            if is_missed && emitter_towards(accel, hit.as_ref(), direction).is_some() {
                ahead.note();
            }
            throughput = throughput * (fraction.value() * (1.0 / probability));
            let Some(weight) = self.roulette(eval, throughput, depth, draw) else {
                break;
            };
            throughput = throughput * weight;
        }
        ahead
    }

    /// [`Self::ahead`] along a ray of the camera.
    pub(crate) fn ahead_of_camera<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        ray: &ViewRay<R>,
        draw: Draw,
    ) -> Ahead {
        let still = ray.value();
        let hit = self.first_hit(&still);
        let chain = SpecularChain::of_camera(&self.accel.view);
        self.ahead(eval, [ray.origin, ray.direction], hit, 0, chain, draw)
    }

    /// Such light along a direction drawn from the surface at the vertex of number `depth`, times BSDF and cosine.
    pub(crate) fn chained<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        vertex: &Vertex<R>,
        direction: Vec3,
        hit: Option<Hit>,
        depth: u32,
        draw: Draw,
    ) -> Rgb<R> {
        let mut light = Rgb::zero();
        let (position, first) = (vertex.position, depth + 1);
        let chain = SpecularChain::default();
        let still = [position, Vec3::constant(direction)];
        let ahead = self.ahead(eval, still, hit, first, chain, draw);
        let viewpoint = Viewpoint::towards_surfaces(position, vertex.face_normal, 0);
        let start = Start::Surface(position);
        let (walk, numbers) = self.vertex_walk(depth, 1, draw);
        for (events, shown) in ahead.chains() {
            let field = self.chain_field(&viewpoint, &start, events);
            let warped = field.warp(eval, direction, walk, numbers);
            let ray = [position, warped.direction];
            let arrives = self.reflected(eval, ray, hit, first, chain, shown, draw);
            light += vertex.eval(warped.direction) * arrives * warped.jacobian;
        }
        light
    }

    /// What of the light beside edges counts that a viewpoint sees.
    pub(crate) fn beside_edges(&self) -> Shown {
        match self.has_chains {
            true => Shown::Covered,
            false => Shown::All,
        }
    }

    /// The field along a chain of events.
    pub(crate) fn chain_field<'f, R>(
        &'f self,
        viewpoint: &'f Viewpoint<R>,
        start: &'f Start<R>,
        events: &'f [Event],
    ) -> ChainField<'f, R> {
        let moving = self.moving.as_ref();
        ChainField {
            field: &moving.expect("only scenes that move have fields").field,
            viewpoint,
            start,
            events,
            survey: self.facts.chain_survey(self.accel),
        }
    }
}
