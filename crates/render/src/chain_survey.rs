//! What some paths tell of the chains of specular events in a scene: by how much they magnify, roughly, and how often
//! their rays dip below faces where that is not continuous. Magnification is what a small turn of a direction does to that in which the chain sees
//! something at the end, but for the cosines of angles at mirrors and glass ([`Bent::cosine`]).

use capwalk_boundary::{Accel, MAX_EVENTS, Stream, bends_images};
use capwalk_math::{Dual, Frame, Vec3};

use crate::chain::{Bent, Link, Start, drawn_chain, follow};
use crate::estimate::Dips;
use crate::plan::Plan;
use crate::still::Still;

/// How many paths are followed.
const PATHS: u64 = 1024;
/// Keeps their random numbers apart from those of samples.
const SEED: u64 = 0x6d61_676e_6966_7921;

/// Magnifications of chains from the camera and from surfaces, by their number of events, and rays that dip.
#[derive(Clone, Debug, Default)]
pub struct ChainSurvey {
    of_camera: Vec<f64>,
    of_surfaces: Vec<f64>,
    /// On paths that are followed up to the first.
    pub dips: Dips,
}

impl ChainSurvey {
    /// That of a scene; magnifications are medians over some paths.
    pub fn of(accel: &Accel) -> Self {
        let mut all = [Vec::<Vec<f64>>::new(), Vec::new()];
        let mut dips = Dips::default();
        for path in 0..PATHS {
            let stream = Stream::independent(SEED, path);
            let [width, height] = accel.scene.film.crop_size.map(f64::from);
            let [left, top] = accel.scene.film.crop_offset.map(f64::from);
            let [x, y] = stream.pair(0);
            let q = accel.view.direction([left + width * x, top + height * y]);
            let mut start = Some((Start::Camera(accel.view), q));
            let mut of_path = Dips::default();
            for (i, found) in all.iter_mut().enumerate() {
                let Some((from, q)) = start else {
                    break;
                };
                let (links, end) = drawn_chain(accel, &from, q, &stream, 2 + 64 * i as u32);
                if of_path.dip == 0 {
                    of_path += end.dips;
                }
                found.resize_with(found.len().max(links.len()), Vec::new);
                for count in 1..=links.len() {
                    let next = links.get(count).map_or(end.distance, |next| next.hit.t);
                    let magnified = magnification(accel, &from, q, &links[..count], next);
                    found[count - 1].push(magnified);
                }
                start = end.scattered.map(|[x, q]| (Start::Surface(x), q));
            }
            dips += of_path;
        }
        let [of_camera, of_surfaces] = all.map(|all| all.into_iter().map(median).collect());
        Self {
            of_camera,
            of_surfaces,
            dips,
        }
    }

    /// By how much a chain magnifies; where none was met, that of a shorter one.
    pub fn magnification_after<R>(&self, start: &Start<R>, events: usize) -> f64 {
        let all = match start {
            Start::Camera(_) => &self.of_camera,
            Start::Surface(_) => &self.of_surfaces,
        };
        let known = all[..events.min(all.len())].iter().rev();
        known
            .copied()
            .find(|x| x.is_finite() && *x > 0.0)
            .unwrap_or(1.0)
    }
}

/// True if paths may bring light by specular events whose silhouettes no field of a viewpoint has.
pub fn may_have_chains(accel: &Accel) -> bool {
    let (scene, plan) = (&accel.scene, Plan::new(&accel.scene));
    let is_long = plan.events_behind(0) >= MAX_EVENTS;
    let has_flat = accel.has_flat_events() && (accel.view.is_parallel() || is_long);
    let may_miss = || has_flat || scene.shapes.iter().any(|shape| bends_images(scene, shape));
    plan.aov.is_none() && plan.sampling.bsdf_samples > 0 && may_miss()
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.retain(|x| x.is_finite());
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().unwrap_or(f64::NAN)
}

/// What a turn does to the direction of something at a distance after the events, times the cosine.
fn magnification(accel: &Accel, start: &Start<f64>, q: Vec3, links: &[Link], next: f64) -> f64 {
    let (_, bent) = spread(accel, start, q, links);
    let [x, r] = bent.ray;
    let turns = [0, 1].map(|i| {
        let aside = x.tangent(i).reject_from(r.value()).length();
        r.tangent(i).length() + aside / next
    });
    bent.cosine.value * (0.5 * (turns[0] * turns[0] + turns[1] * turns[1])).sqrt()
}

/// Where the ray of a direction is after some events, and how that changes with the direction, along `s` and `t` of the
/// frame around it.
pub fn spread(
    accel: &Accel,
    start: &Start<f64>,
    q: Vec3,
    links: &[Link],
) -> (Frame, Bent<Dual<2>>) {
    let frame = Frame::from_normal(q);
    let [value, s, t] = [q, frame.s, frame.t].map(Vec3::to_array);
    let direction: [Dual<2>; 3] = std::array::from_fn(|i| Dual::new(value[i], [s[i], t[i]]));
    let ray = start.constant().ray(Vec3::from(direction));
    (frame, follow(&Still(accel), accel, ray, links))
}
