//! Sixteen samples of a primal image at a time.
//!
//! What is sampled, with which random numbers and weights, is what [`Tracer`](crate::Tracer) samples; a test
//! compares them one by one. Paths advance together, stage by stage: rays,
//! surfaces, directions towards emitters, directions drawn from the surfaces. Rectangles, point
//! emitters, environment maps, diffuse surfaces, rough metal and rough plastic are evaluated in loops over
//! the lanes without a branch, of which the compiler makes vectors; other emitters and lobes one by one,
//! by the functions that the tracer calls.
//!
//! In scenes of few faces and spheres rays come in packets, whose arithmetic is in single precision
//! ([`capwalk_geometry::PacketTree`]): a ray that passes an edge within a millionth of the scene may
//! find another face than it does there. Scenes in which that could be seen have bundles of rays
//! ([`capwalk_geometry::Bundle`]), which find the same: those with thin faces, surfaces close to each
//! other, or something so near in view that it is more than two thousandths of a pixel.

mod alike;
mod film_points;
mod frames;
mod gradient;
mod in_view;
mod kept;
mod lights;
mod lit;
mod lobes;
mod point_emitters;
mod rays;
mod rectangles;
mod rest_of_runs;
mod rough;
mod scattered;
mod scene;
mod sky;
mod step;
#[cfg(test)]
mod tests;
mod vectors;

use capwalk_boundary::{Accel, Leaving, Streams};
use capwalk_geometry::simd::Instructions;
use capwalk_math::Rgb;
use capwalk_scene::lobe::Specular;
use capwalk_scene::sensor::view::View;
use capwalk_scene::{EmitterId, Shape, TextureId};

use crate::film::{FILM, uniform_disk};
use crate::light::power_heuristic;
use crate::pixel::Supports;
use crate::plan::{BSDF_NUMBERS, EMITTER_NUMBERS, LENS, LightSampling, Plan};
use crate::prepared::PreparedScene;
use crate::radiance::{RR_MAX, RR_MIN};
use crate::tiles::{EFFORT_OF_LIGHT, Sample, SampleRun};
use alike::{Alike, FindAlike};
use film_points::DrawAlong;
pub use gradient::Differentiator;
use kept::{Step, Steps};
use lights::{LaneChoices, LaneLights};
use lit::{Lit, SeenEmitter, SkyPoint};
use lobes::LaneLobes;
pub use rays::RayPrecision;
use rays::{ALL_BEHIND, LaneRays, Meets};
use rest_of_runs::RestOfRuns;
use scene::{LaneScene, NOTHING, asked_slots};
use step::{Brdf, Vertices};
use vectors::{LANES, Numbers, Vectors, lanes_of};

/// Takes samples of the pixels of a scene, sixteen at a time.
pub struct LaneTracer<'a> {
    accel: &'a Accel,
    supports: Supports,
    plan: Plan,
    /// The smallest probability that a path survives roulette.
    least_survival: f64,
    scene: LaneScene<'a>,
    lights: LaneLights<'a>,
    meets: Meets<'a>,
    instructions: Instructions,
}

/// Sixteen paths.
struct Paths<'a> {
    streams: Streams<LANES>,
    light: Vectors,
    throughput: Vectors,
    vertices: Vertices,
    /// What scatters light there, if it is not diffuse.
    lobes: LaneLobes<'a>,
    /// Directions towards emitters, and directions drawn from the surfaces.
    choices: LaneChoices,
    lit: Lit,
    drawn: Brdf,
    /// What they hit, or [`NOTHING`], and what those see of an environment map that hit nothing.
    faces: [u32; LANES],
    alike: Alike,
    sky: [SkyPoint; LANES],
    /// How many rays each has taken.
    rays: [u64; LANES],
    /// Their vertices, if light is to be differentiated, and what the camera sees of emitters.
    steps: Option<Steps>,
    seen: [Option<(EmitterId, SeenEmitter)>; LANES],
}

/// The vertex that is sampled at, if light is to be differentiated.
fn last_step(steps: &mut Option<Steps>) -> Option<&mut Step> {
    steps.as_mut()?.last()
}

impl Paths<'_> {
    /// None yet, of samples like those of a run.
    fn new(run: &SampleRun, lights: &LaneLights<'_>) -> Self {
        Self {
            streams: Streams::splat(run.streams.stream(run.numbers.start)),
            light: Vectors::ZERO,
            throughput: Vectors::ZERO,
            vertices: Vertices::NONE,
            lobes: LaneLobes::new(),
            choices: lights.choices(),
            lit: Lit::default(),
            drawn: Brdf::default(),
            faces: [NOTHING; LANES],
            alike: Alike::NONE,
            sky: [SkyPoint::default(); LANES],
            rays: [0; LANES],
            steps: None,
            seen: [None; LANES],
        }
    }

    /// Keeps a vertex of some lanes, if light is to be differentiated.
    fn keep(&mut self, active: u32) {
        let (vertices, with_lobes) = (&self.vertices, self.lobes.with_lobes);
        if let Some(steps) = &mut self.steps {
            let throughput = &self.throughput;
            steps.push(active, self.faces, vertices, throughput, with_lobes);
        }
    }

    /// Keeps the directions drawn there.
    fn keep_drawn(&mut self, is_drawn: u32) {
        if let Some(step) = last_step(&mut self.steps) {
            let (scattered, events) = (&self.vertices.scattered, self.lobes.events());
            step.set_drawn(is_drawn, &self.drawn, scattered, events);
        }
    }
}

impl<'a> LaneTracer<'a> {
    /// A tracer of the light that a plan asks for; `None` if that is something else.
    pub fn of_light(
        plan: Plan,
        prepared: &'a PreparedScene,
        precision: RayPrecision,
    ) -> Option<Self> {
        let is_light = plan.aov.is_none();
        is_light.then(|| Self::new(plan, prepared, &|_| false, precision))
    }

    /// A tracer that also differentiates light with respect to some textures; `None` if that moves
    /// rays, or a vertex takes several samples.
    pub fn differentiating(
        prepared: &'a PreparedScene,
        is_asked_for: &'a (dyn Fn(TextureId) -> bool + Sync),
    ) -> Option<Self> {
        let scene = prepared.scene();
        let plan = Plan::new(scene);
        let LightSampling {
            emitter_samples,
            bsdf_samples,
            ..
        } = plan.sampling;
        let moves_rays = |shape: &Shape| {
            let mut slots = asked_slots(scene, shape, is_asked_for);
            slots.any(|slot| slot.quantity.moves_rays())
        };
        let is_plain = plan.aov.is_none()
            && emitter_samples.max(bsdf_samples) <= 1
            && !scene.shapes.iter().any(|shape| moves_rays(shape));
        is_plain.then(|| Self {
            least_survival: RR_MIN,
            ..Self::new(plan, prepared, is_asked_for, RayPrecision::Resolving)
        })
    }

    fn new(
        plan: Plan,
        prepared: &'a PreparedScene,
        is_asked_for: &'a (dyn Fn(TextureId) -> bool + Sync),
        precision: RayPrecision,
    ) -> Self {
        let accel = prepared.accel();
        Self {
            accel,
            supports: Supports::new(&accel.scene.film),
            plan,
            least_survival: 0.0,
            scene: LaneScene::new(accel, is_asked_for),
            lights: LaneLights::new(prepared, plan.sampling, is_asked_for),
            meets: Meets::new(accel, precision),
            instructions: Instructions::detect(),
        }
    }

    /// True if rays come in packets, in single precision.
    pub fn has_packets(&self) -> bool {
        self.meets.has_packets()
    }

    /// Appends the samples of some runs.
    pub fn take(&self, runs: &[SampleRun], taken: &mut Vec<Sample<3>>) {
        let Some(first) = runs.first() else {
            return;
        };
        // Reused: most of it is written anew where it is needed.
        let mut paths = Paths::new(first, &self.lights);
        let mut rest = RestOfRuns::new(runs);
        while !rest.is_empty() {
            self.take_some(&mut rest, &mut paths, taken);
        }
    }

    /// Takes as many as there are lanes, if so many are left, and gives what each is weighted by in its
    /// pixel.
    fn take_some<'s>(
        &'s self,
        rest: &mut RestOfRuns<'_>,
        paths: &mut Paths<'s>,
        taken: &mut Vec<Sample<3>>,
    ) -> Numbers {
        // Samples of the film, and the camera's rays through them.
        let any = &self.supports.pixel([0, 0]).sides;
        let mut sides = any.map(|side| [side; LANES]);
        let mut count = 0;
        while count < LANES
            && let Some((run, numbers)) = rest.next(LANES - count)
        {
            let lanes = count..count + numbers.len();
            count = lanes.end;
            let support = self.supports.pixel(run.pixel);
            for (sides, side) in sides.iter_mut().zip(support.sides) {
                sides[lanes.clone()].fill(side);
            }
            paths.streams.set(lanes, &run.streams, numbers.start);
        }
        let mask = (1 << count) - 1;
        let mut film = [[0.0; LANES]; 2];
        self.instructions.run(step::RandomNumbers {
            streams: &paths.streams,
            first: FILM,
            lanes: mask,
            numbers: &mut film,
        });
        let mut weights = [1.0; LANES];
        for (film, sides) in film.iter_mut().zip(&sides) {
            self.instructions.run(DrawAlong {
                sides,
                film,
                weights: &mut weights,
            });
        }
        let range = self.set_camera_rays(paths, &film, mask);
        paths.light = Vectors::ZERO;
        paths.throughput = Vectors::splat([1.0; 3]);
        let rays = LaneRays {
            origin: &paths.vertices.origin,
            direction: &paths.vertices.direction,
            range: &range,
            from_surfaces: false,
            mask,
        };
        paths.faces = self.meets.first_hits(&rays);
        paths.alike = self.alike(&paths.faces, mask);
        paths.rays = [1; LANES];
        paths.seen = [None; LANES];
        if let Some(steps) = &mut paths.steps {
            steps.clear();
        }
        self.add_seen(paths, mask);
        self.reflect(paths, mask);
        taken.extend((0..count).map(|lane| Sample {
            numbers: (paths.light.colour(lane) * weights[lane]).to_array(),
            effort: EFFORT_OF_LIGHT + self.meets.effort(paths.rays[lane]),
            ..Sample::default()
        }));
        weights
    }

    fn alike(&self, faces: &[u32; LANES], lanes: u32) -> Alike {
        self.instructions.run(FindAlike { faces, lanes })
    }

    /// Counts a ray of some lanes.
    fn count_rays(&self, paths: &mut Paths<'_>, lanes: u32) {
        self.instructions.run(step::CountRays {
            rays: &mut paths.rays,
            lanes,
        });
    }

    /// Sets the camera's rays, and gives the distances between which they meet something.
    fn set_camera_rays(
        &self,
        paths: &mut Paths<'_>,
        film: &[Numbers; 2],
        mask: u32,
    ) -> [Numbers; 2] {
        let mut range = ALL_BEHIND;
        let scene = &self.accel.scene;
        if !scene.sensor.model.has_lens() {
            self.instructions.run(step::FilmRays {
                view: &self.accel.view,
                film,
                vertices: &mut paths.vertices,
                range: &mut range,
            });
            return range;
        }
        for lane in lanes_of(mask) {
            let lens = uniform_disk([0, 1].map(|i| paths.streams.number(lane, LENS + i)));
            let view = View::new(&scene.sensor, &scene.film, &scene.sensor.state(), lens);
            let ray = view.ray(view.direction([film[0][lane], film[1][lane]]));
            paths.vertices.origin.set(lane, ray.origin);
            paths.vertices.direction.set(lane, ray.direction);
            (range[0][lane], range[1][lane]) = (ray.range[0], ray.range[1]);
        }
        range
    }

    /// Adds what the camera sees of emitters.
    fn add_seen(&self, paths: &mut Paths<'_>, mask: u32) {
        if !self.plan.reaches(1) || self.plan.hide_emitters {
            return;
        }
        let missed = paths.alike.missed & mask;
        let directions = &paths.vertices.direction;
        (self.lights).see_sky(self.instructions, directions, missed, &mut paths.sky);
        for (face, lanes) in paths.alike.of(mask) {
            let Some(emitter) = self.scene.emitter_at(face) else {
                continue;
            };
            for lane in lanes_of(lanes) {
                let (origin, direction) = (
                    paths.vertices.origin.get(lane),
                    paths.vertices.direction.get(lane),
                );
                if !self.scene.is_in_front(face, direction) {
                    continue;
                }
                let hit = self.scene.hit(face, origin, direction);
                let seen = self.lights.seen_at(emitter, hit, &paths.sky[lane]);
                let light = self.lights.radiance(emitter, &seen, origin, direction);
                paths.light.set_colour(lane, light);
                paths.seen[lane] = Some((emitter, seen));
            }
        }
    }

    /// Adds what arrives by reflections.
    fn reflect<'s>(&'s self, paths: &mut Paths<'s>, mask: u32) {
        let (plan, sampling) = (&self.plan, self.plan.sampling);
        let mut active = mask;
        for depth in 0.. {
            // The path goes on from a surface that is hit, if paths so long are sampled.
            if !plan.reaches(depth + 2) {
                return;
            }
            active = self.find_surfaces(paths, active);
            if active == 0 {
                return;
            }
            paths.keep(active);
            let goes_on = plan.reaches(depth + 3);
            let first = plan.vertex_numbers(depth);
            let Paths {
                vertices, lobes, ..
            } = &mut *paths;
            lobes.face_viewers(self.instructions, vertices, active);
            // Where directions are drawn from the surface: see `sample_lights`.
            let of_brdf = match (sampling.bsdf_samples, goes_on) {
                (0, _) => 0,
                (_, true) => active,
                (_, false) => active & !self.sampled_well(paths, active),
            };
            self.add_light(paths, active, first, of_brdf);
            if of_brdf == 0 {
                return;
            }
            // The first one last: along it the path goes on.
            let first = first + sampling.emitter_samples * EMITTER_NUMBERS;
            let (mut drawn, faces) = (0, paths.faces);
            for i in (0..sampling.bsdf_samples).rev() {
                drawn = self.draw_brdf(paths, &faces, of_brdf, first + i * BSDF_NUMBERS);
            }
            paths.keep_drawn(drawn);
            if !goes_on {
                return;
            }
            paths.throughput = paths.throughput.times(&paths.vertices.scattered);
            paths.vertices.direction = paths.drawn.direction;
            paths.vertices.origin = paths.vertices.position;
            active = self.roulette(paths, drawn, depth);
        }
    }

    /// Finds where surfaces were hit, and looks them up; one bit for each that scatters something.
    fn find_surfaces<'s>(&'s self, paths: &mut Paths<'s>, active: u32) -> u32 {
        let Paths {
            vertices,
            lobes,
            alike,
            ..
        } = paths;
        let on_faces = || alike.of(active).filter(|&(face, _)| face != NOTHING);
        for (face, lanes) in on_faces() {
            self.scene.set_face(face, lanes, vertices);
        }
        let front = self.instructions.run(step::Surfaces(vertices));
        on_faces().fold(0, |found, (face, lanes)| {
            found | (self.scene).look_up(face, lanes, front, vertices, lobes)
        })
    }

    /// One bit for each of some lanes where directions from the surface would add more time than they
    /// take noise away, see `light.rs`.
    fn sampled_well(&self, paths: &Paths<'_>, active: u32) -> u32 {
        if self.lights.are_deltas {
            return active;
        }
        let Some(emitter) = self.lights.only() else {
            return 0;
        };
        let narrow = self.instructions.run(step::Narrow {
            vertices: &paths.vertices,
            emitter,
        });
        active & narrow & !paths.lobes.which(active, |lobes| !lobes.is_diffuse)
    }

    /// Adds light from emitters towards which directions are drawn.
    fn add_light(&self, paths: &mut Paths<'_>, active: u32, first: u32, of_brdf: u32) {
        let samples = self.plan.sampling.emitter_samples;
        let with_points = active & !paths.lobes.which(active, |lobes| !lobes.has_smooth);
        let transmits = paths.lobes.which(active, |lobes| lobes.transmits);
        let surfaces = (&paths.vertices, &paths.lobes);
        let masks = [active, with_points, transmits];
        (self.lights).choose(self.instructions, &mut paths.choices, surfaces, masks);
        for i in 0..samples {
            let first = first + i * EMITTER_NUMBERS;
            self.add_points(paths, first, [with_points, transmits, of_brdf]);
        }
    }

    /// Adds light from an emitter to each of some lanes.
    fn add_points(&self, paths: &mut Paths<'_>, first: u32, masks: [u32; 3]) {
        let [lanes, transmits, of_brdf] = masks;
        let (vertices, lobes) = (&mut paths.vertices, &mut paths.lobes);
        let (lit, instructions) = (&mut paths.lit, self.instructions);
        self.lights.draw(
            instructions,
            &mut paths.choices,
            (vertices, lobes),
            &paths.streams,
            first,
            lanes,
            lit,
        );
        // Nothing else draws the direction of an emitter without extent.
        let of_brdf = of_brdf & !lit.of_delta;
        let bsdf_samples = f64::from(self.plan.sampling.bsdf_samples);
        let behind = instructions.run(step::WeighDiffuse {
            vertices,
            lit,
            bsdf_samples,
            of_brdf,
        });
        let wanted = lanes & lit.mask & (transmits | !behind);
        if wanted == 0 {
            return;
        }
        let rays = LaneRays {
            origin: &vertices.position,
            direction: &lit.direction,
            range: &lit.range,
            from_surfaces: true,
            mask: wanted,
        };
        let seen = wanted & !self.meets.occluded(&rays);
        self.lights.shine(vertices, seen, lit);
        let masks = [seen, of_brdf];
        lobes.weigh_points(instructions, vertices, lit, bsdf_samples, masks);
        instructions.run(step::SumLight {
            light: &mut paths.light,
            throughput: &paths.throughput,
            scattered: &vertices.scattered,
            weight: &lit.weight,
            radiance: &lit.radiance,
            lanes: seen,
        });
        if let Some(step) = last_step(&mut paths.steps) {
            step.set_lit(seen, lit, &vertices.scattered);
        }
        self.count_rays(paths, wanted);
    }

    /// Draws directions from the materials of these faces, finds what is there, and adds what emitters send from there;
    /// one bit for each of some lanes that has one.
    fn draw_brdf(
        &self,
        paths: &mut Paths<'_>,
        faces: &[u32; LANES],
        active: u32,
        first: u32,
    ) -> u32 {
        let instructions = self.instructions;
        // The first one chooses among lobes.
        let with_lobes = active & paths.lobes.with_lobes;
        let (mut choice, mut u) = ([[0.0; LANES]; 1], [[0.0; LANES]; 2]);
        if with_lobes != 0 {
            instructions.run(step::RandomNumbers {
                streams: &paths.streams,
                first,
                lanes: with_lobes,
                numbers: &mut choice,
            });
        }
        instructions.run(step::RandomNumbers {
            streams: &paths.streams,
            first: first + 1,
            lanes: active,
            numbers: &mut u,
        });
        let (vertices, lobes) = (&mut paths.vertices, &mut paths.lobes);
        let drawn = &mut paths.drawn;
        instructions.run(step::Draw {
            vertices,
            u: &u,
            drawn,
        });
        let mut of_lobes = 0;
        if with_lobes != 0 {
            of_lobes = lobes.draw(instructions, with_lobes, &choice[0], &u, &drawn.local);
            of_lobes = lobes.weigh_drawn(instructions, vertices, drawn, of_lobes);
        }
        let active = active & !with_lobes | of_lobes;
        let rays = LaneRays {
            origin: &vertices.position,
            direction: &drawn.direction,
            range: &ALL_BEHIND,
            from_surfaces: true,
            mask: active,
        };
        paths.faces = self.meets.first_hits(&rays);
        self.pass(paths, faces, active);
        paths.alike = self.alike(&paths.faces, active);
        self.count_rays(paths, active);
        let missed = paths.alike.missed;
        let directions = &paths.drawn.direction;
        (self.lights).see_sky(instructions, directions, missed, &mut paths.sky);
        let alike = paths.alike;
        for (face, lanes) in alike.of(active) {
            if let Some(emitter) = self.scene.emitter_at(face) {
                lanes_of(lanes).for_each(|lane| self.add_met(paths, lane, emitter));
            }
        }
        active
    }

    /// Lets rays pass that dip below the faces that they leave by specular events.
    fn pass(&self, paths: &mut Paths<'_>, left: &[u32; LANES], active: u32) {
        let Paths {
            vertices,
            lobes,
            drawn,
            faces,
            ..
        } = &mut *paths;
        for lane in lanes_of(active & drawn.specular) {
            let Some((Specular { event, .. }, _)) = lobes.event(lane) else {
                continue;
            };
            let normal = vertices.face_normal.get(lane) * vertices.seen[lane];
            let leaving = Leaving::after(event, left[lane], normal);
            let direction = drawn.direction.get(lane);
            if leaving.dips(direction) {
                let position = vertices.position.get(lane);
                let ray = self.accel.ray_leaving(&leaving, position, direction);
                let hit = self.accel.first_hit_within(&ray);
                faces[lane] = hit.map_or(NOTHING, |hit| hit.face);
            }
        }
    }

    /// Adds what an emitter sends from where a direction drawn from a surface leads.
    #[inline]
    fn add_met(&self, paths: &mut Paths<'_>, lane: usize, emitter: EmitterId) {
        let (face, direction) = (paths.faces[lane], paths.drawn.direction.get(lane));
        if !self.scene.is_in_front(face, direction) {
            return;
        }
        let position = paths.vertices.position.get(lane);
        let hit = self.scene.hit(face, position, direction);
        let seen = self.lights.seen_at(emitter, hit, &paths.sky[lane]);
        let samples = f64::from(self.plan.sampling.bsdf_samples);
        // Nothing else samples a specular direction.
        let weight = match paths.drawn.specular >> lane & 1 {
            1 => 1.0,
            _ => {
                let receiver = || paths.lobes.receiver(&paths.vertices, lane);
                let own = samples * paths.drawn.pdf[lane];
                let choices = &paths.choices;
                let other =
                    (self.lights).density(choices, lane, emitter, &seen, direction, receiver);
                power_heuristic(own, other)
            }
        };
        let radiance = (self.lights).radiance(emitter, &seen, position, direction);
        if let Some(step) = last_step(&mut paths.steps) {
            step.set_met(lane, (emitter, seen), radiance, weight);
        }
        let factor = paths.throughput.colour(lane) * paths.vertices.scattered.colour(lane);
        let light = paths.light.colour(lane) + factor * radiance * (weight / samples);
        paths.light.set_colour(lane, light);
    }

    /// Ends paths that carry nothing, and long ones at random; one bit for each that goes on.
    fn roulette(&self, paths: &mut Paths<'_>, active: u32, depth: u32) -> u32 {
        let is_long = depth + 1 >= self.plan.rr_depth;
        let last = self.plan.vertex_numbers(depth + 1) - 1;
        let numbers = match is_long {
            true => paths.streams.numbers(last, active),
            false => [0.0; LANES],
        };
        let mut alive = 0;
        for lane in lanes_of(active) {
            let throughput = paths.throughput.colour(lane);
            if throughput == Rgb::zero() && paths.steps.is_none() {
                continue;
            }
            if is_long {
                let least = self.least_survival;
                let survival = throughput.max_component().clamp(least, RR_MAX);
                if numbers[lane] >= survival {
                    continue;
                }
                if let Some(step) = last_step(&mut paths.steps) {
                    step.set_survival(lane, survival);
                }
                paths
                    .throughput
                    .set_colour(lane, throughput * (1.0 / survival));
            }
            alive |= 1 << lane;
        }
        alive
    }
}
