//! Chains of perfectly specular events that a ray takes part in (METHOD 6): mirrors, glass and panes, flat or
//! curved.

use capwalk_boundary::{Accel, Leaving, Stream, bounded_ray};
use capwalk_geometry::{Hit, Ray};
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::lobe::{Event, Specular};
use capwalk_scene::sensor::view::View;

use crate::estimate::Dips;
use crate::scene_eval::SceneEval;
use crate::shading::{add_lobes, black_vertex_at, vertex_at};
use crate::still::Still;
use crate::surface::surface_at;
use crate::vertex::Vertex;

/// The most events of a chain that is drawn.
const MOST_DRAWN: usize = 16;

/// Smaller cosines count as this one: along curves inside of faces, rays are at right angles to interpolated normals, and
/// nothing ends there.
const LEAST_COSINE: f64 = 0.05;

/// Rays that make a smaller angle with a face than this, radians, meet it by rounding: where they do has no derivative.
const EDGE_ON: f64 = 1e-9;

/// Where rays start whose directions are chosen around a viewpoint.
#[derive(Clone, Copy, Debug)]
pub enum Start<R> {
    /// At the camera.
    Camera(View<R>),
    /// At a point of a surface.
    Surface(Vec3<R>),
}

impl<R: Real> Start<R> {
    /// Origin and direction of the ray in a direction of the viewpoint's sphere.
    pub fn ray(&self, q: Vec3<R>) -> [Vec3<R>; 2] {
        match self {
            Self::Camera(view) => {
                let ray = view.ray(q);
                [ray.origin, ray.direction]
            }
            Self::Surface(origin) => [*origin, q],
        }
    }

    /// Without derivatives.
    pub fn value(&self) -> Start<f64> {
        match self {
            Self::Camera(view) => Start::Camera(view.value()),
            Self::Surface(origin) => Start::Surface(origin.value()),
        }
    }
}

impl Start<f64> {
    /// As numbers whose derivatives are zero.
    pub fn constant<R: Real>(&self) -> Start<R> {
        match self {
            Self::Camera(view) => Start::Camera(view.map(R::constant)),
            Self::Surface(origin) => Start::Surface(Vec3::constant(*origin)),
        }
    }

    /// The ray with its bounds.
    pub fn bounded_ray(&self, accel: &Accel, q: Vec3) -> Ray {
        match self {
            Self::Camera(view) => bounded_ray(&view.ray(q)),
            Self::Surface(origin) => accel.surface_ray(*origin, q),
        }
    }
}

/// One event of a chain.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// Where.
    pub hit: Hit,
    /// What happens there.
    pub event: Event,
}

/// A ray after some events.
#[derive(Clone, Copy, Debug)]
pub struct AfterLink {
    /// The last event.
    pub link: Link,
    /// Where that was, and the unit direction in which the ray goes on.
    pub ray: [Vec3; 2],
    /// How it leaves the face there.
    pub leaving: Leaving,
    /// [`Bent::cosine`] of this event.
    pub cosine: f64,
}

/// A moving ray after some events.
#[derive(Clone, Copy, Debug)]
pub struct Bent<R> {
    /// Where the last event was, and the unit direction in which the ray goes on.
    pub ray: [Vec3<R>; 2],
    /// The smallest cosine of the rays before and after each event with the normal there, at least [`LEAST_COSINE`]: where
    /// it is small, images are shrunk.
    pub cosine: R,
}

/// What a ray meets first, if that has an event of this kind for it, and the ray after that.
pub fn next_link(accel: &Accel, ray: &Ray, event: Event) -> Option<AfterLink> {
    let hit = accel.first_hit_within(ray)?;
    let (eval, incoming) = (Still(accel), [ray.origin, ray.direction]);
    let surface = surface_at(&eval, accel, &hit, incoming[0], incoming[1]);
    if surface.face_normal.dot(ray.direction).abs() < EDGE_ON {
        return None;
    }
    let mut vertex = black_vertex_at(&surface, incoming[1]);
    if !add_lobes(&eval, accel, &surface, &mut vertex) {
        return None;
    }
    let ([_, direction], _) = vertex.specular(own_event(&vertex, event)?, incoming);
    let cosine = cosine(&vertex, direction);
    // Where all light is reflected, nothing is refracted.
    direction.is_finite().then_some(AfterLink {
        link: Link { hit, event },
        ray: [surface.position, direction],
        leaving: vertex.leaving(event),
        cosine,
    })
}

/// The first event of this kind at a vertex. All of them send light the same way.
fn own_event<R: Real>(vertex: &Vertex<R>, event: Event) -> Option<Specular> {
    let mut events = vertex.bsdf.events(vertex.wi);
    events.find(|own| own.event == event)
}

/// [`Bent::cosine`] of an event.
fn cosine<R: Real>(vertex: &Vertex<R>, direction: Vec3<R>) -> R {
    let [before, after] = [vertex.wi, vertex.frame.to_local(direction)].map(|w| w.z.abs());
    let smaller = if before < after { before } else { after };
    match smaller.value() < LEAST_COSINE {
        true => R::constant(LEAST_COSINE),
        false => smaller,
    }
}

/// A moving ray after the events of a chain, whose faces stay the same.
pub fn follow<R: Real, W: SceneEval<R>>(
    eval: &W,
    accel: &Accel,
    ray: [Vec3<R>; 2],
    links: &[Link],
) -> Bent<R> {
    let start = Bent {
        ray,
        cosine: R::constant(1.0),
    };
    links.iter().fold(start, |bent, Link { hit, event }| {
        let ray = bent.ray;
        let surface = surface_at(eval, accel, hit, ray[0], ray[1]);
        let mut vertex = black_vertex_at(&surface, ray[1]);
        add_lobes(eval, accel, &surface, &mut vertex);
        // Rounding may take away what a grazing ray has: then it is NaN, and counted with the sample.
        let direction = own_event(&vertex, *event)
            .map_or(Vec3::constant(Vec3::splat(f64::NAN)), |own| {
                vertex.specular(own, ray).0[1]
            });
        let own = cosine(&vertex, direction);
        Bent {
            ray: [surface.position, direction],
            cosine: if own < bent.cosine { own } else { bent.cosine },
        }
    })
}

/// Where a chain ends.
#[derive(Clone, Copy, Debug)]
pub struct End {
    /// How far away from the last event.
    pub distance: f64,
    /// Position and unit direction of a ray that is scattered there.
    pub scattered: Option<[Vec3; 2]>,
    /// Of the reflections and refractions before the end, up to the first ray whose dip is not continuous.
    pub dips: Dips,
}

/// A chain of events that are drawn at random, by numbers of a stream from `first` on, and its end.
pub fn drawn_chain(
    accel: &Accel,
    start: &Start<f64>,
    q: Vec3,
    stream: &Stream,
    first: u32,
) -> (Vec<Link>, End) {
    let mut links = Vec::new();
    let mut ray = start.bounded_ray(accel, q);
    let mut dips = Dips::default();
    loop {
        let mut end = End {
            distance: f64::INFINITY,
            scattered: None,
            dips,
        };
        let Some(hit) = accel.first_hit_within(&ray) else {
            return (links, end);
        };
        end.distance = hit.t;
        let (eval, incoming) = (Still(accel), [ray.origin, ray.direction]);
        let surface = surface_at(&eval, accel, &hit, incoming[0], incoming[1]);
        let Some(vertex) = vertex_at(&eval, accel, &surface, incoming[1]) else {
            return (links, end);
        };
        let number = first + 3 * links.len() as u32;
        let (choice, u) = (stream.number(number), stream.pair(number + 1));
        let drawn = vertex.bsdf.sample(vertex.wi, choice, u);
        match drawn.map(|drawn| (drawn.specular, drawn.wo)) {
            Some((Some(event), _)) if links.len() < MOST_DRAWN => {
                let ([_, direction], fraction) = vertex.specular(event, incoming);
                let leaving = vertex.leaving(event.event);
                ray = accel.ray_leaving(&leaving, vertex.position, direction);
                if dips.dip == 0 && event.event != Event::Pass {
                    let position = vertex.position;
                    let dips_there = leaving.dips(direction)
                        && fraction != Rgb::zero()
                        && !accel.dips_continuously(&leaving, position, direction);
                    dips.count(dips_there);
                }
                links.push(Link {
                    hit,
                    event: event.event,
                });
            }
            Some((None, wo)) => {
                let direction = vertex.frame.to_world(wo).normalized();
                end.scattered = Some([vertex.position, direction]);
                return (links, end);
            }
            _ => return (links, end),
        }
    }
}
