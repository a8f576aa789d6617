//! Sixteen samples of the primal image at a time, where scenes allow it: all light comes from one
//! rectangle, and what surfaces do to it is the same all over them, but for textures of what is
//! diffuse.
//!
//! What is sampled, with which random numbers and weights, is what [`Tracer`] samples; a test
//! compares them one by one. (But the rectangle is always sampled by solid angle, also where it is
//! seen under less than a millionth of a steradian.) Rays come in packets, whose arithmetic is in
//! single precision ([`PacketTree`]); points on the emitter, diffuse surfaces, rough metal and rough
//! plastic in loops over the lanes without a branch, of which the compiler makes vectors; other lobes
//! one by one, but for their frames. A ray that passes an edge within a millionth of the scene may
//! find another face than it does there. Scenes in which that could be seen are left to the tracer:
//! with thin faces, surfaces close to each other, or a camera so near that it is more than two
//! thousandths of a pixel ([`PacketTree::resolves`], [`NEAREST`]).

mod frames;
mod lobes;
mod rays;
mod rough;
mod scene;
mod step;
#[cfg(test)]
mod tests;
mod vectors;

use capwalk_boundary::{Accel, Stream, Streams};
use capwalk_geometry::PacketTree;
use capwalk_math::Rgb;

use crate::film::FILM;
use crate::pixel::Supports;
use crate::plan::{BSDF_NUMBERS, EMITTER_NUMBERS, Plan};
use crate::prepared::PreparedScene;
use crate::radiance::RR_MAX;
use crate::tiles::{Sample, SamplePlace};
use crate::tracer::{LeavesOut, Tracer};
use lobes::LaneLobes;
use rays::{ALL_BEHIND, LaneRays};
use scene::{LaneScene, NOTHING};
use step::{Brdf, Lit, Vertices};
use vectors::{LANES, Vectors, lanes_of, mask_of};

/// In scenes of more triangles, rays that were reflected at random have little in common.
const MOST_FACES: usize = 1024;

/// What lies in a plane is at most this part of a pixel where the nearest surface may be.
const NEAREST: f64 = 2e-3;

/// The effort of a sample besides its rays, and how many levels of the tree take a ray an effort of
/// one: measured on a diffuse room of 36 triangles when there were eight lanes.
const EFFORT_OF_LANE: u64 = 10;
const LEVELS_PER_EFFORT: u64 = 3;

/// Takes samples of the pixels of a scene, sixteen at a time.
pub struct LaneTracer<'a> {
    accel: &'a Accel,
    supports: Supports,
    plan: Plan,
    scene: LaneScene<'a>,
    packets: PacketTree,
    levels: u64,
}

/// Sixteen paths.
struct Paths<'a> {
    streams: Streams<LANES>,
    light: Vectors,
    throughput: Vectors,
    vertices: Vertices,
    /// What scatters light there, if it is not diffuse.
    lobes: LaneLobes<'a>,
    /// Points on the emitter, and directions drawn from the surfaces.
    lit: Lit,
    drawn: Brdf,
    /// What they hit, or [`NOTHING`].
    faces: [u32; LANES],
    /// How many rays each has taken.
    rays: [u64; LANES],
}

impl Paths<'_> {
    /// None yet.
    fn new(stream: Stream) -> Self {
        Self {
            streams: Streams::splat(stream),
            light: Vectors::ZERO,
            throughput: Vectors::ZERO,
            vertices: Vertices::NONE,
            lobes: LaneLobes::new(),
            lit: Lit::default(),
            drawn: Brdf::default(),
            faces: [NOTHING; LANES],
            rays: [0; LANES],
        }
    }
}

impl<'a> LaneTracer<'a> {
    /// A tracer that does the same as another one; `None` if the scene does not allow it.
    pub fn like(tracer: &Tracer<'a>, prepared: &'a PreparedScene) -> Option<Self> {
        let (accel, plan) = (tracer.accel, tracer.plan);
        let sampling = plan.sampling;
        let is_plain = plan.aov.is_none()
            && tracer.leaves_out == LeavesOut::Nothing
            && tracer.moving.is_none()
            && (sampling.emitter_samples, sampling.bsdf_samples) == (1, 1)
            && !accel.scene.sensor.model.has_lens()
            && !accel.view.is_parallel()
            && !accel.has_flush_emitters()
            && accel.mesh.faces.len() <= MOST_FACES;
        let scene = is_plain.then(|| LaneScene::of(prepared))??;
        let packets = PacketTree::new(accel.rays(), &accel.mesh);
        let pixel = NEAREST * accel.view.pixel_size() * scene.distance(accel.view.origin);
        let is_resolved = packets.in_plane() <= pixel && packets.resolves(&accel.mesh);
        let faces = accel.mesh.faces.len();
        is_resolved.then(|| Self {
            accel,
            supports: Supports::new(&accel.scene.film),
            plan,
            scene,
            packets,
            levels: u64::from(faces.max(1).ilog2() + 2),
        })
    }

    /// Appends the samples of some places.
    pub fn take(&self, places: &[SamplePlace], taken: &mut Vec<Sample<3>>) {
        let Some(first) = places.first() else {
            return;
        };
        // Reused: most of it is written anew where it is needed.
        let mut paths = Paths::new(first.stream);
        for places in places.chunks(LANES) {
            self.take_packet(places, &mut paths, taken);
        }
    }

    fn take_packet<'s>(
        &'s self,
        places: &[SamplePlace],
        paths: &mut Paths<'s>,
        taken: &mut Vec<Sample<3>>,
    ) {
        // Samples of the film, and the camera's rays through them.
        let instructions = self.packets.instructions();
        for (lane, place) in places.iter().enumerate() {
            paths.streams.set(lane, place.stream);
        }
        let mut film = [[0.0; LANES]; 2];
        let mask = (1 << places.len()) - 1;
        instructions.run(step::RandomNumbers {
            streams: &paths.streams,
            first: FILM,
            lanes: mask,
            numbers: &mut film,
        });
        let mut weights = [0.0; LANES];
        for (lane, place) in places.iter().enumerate() {
            let support = self.supports.pixel(place.pixel);
            let s = support.sample(0.0, 0.0, film.map(|numbers| numbers[lane]));
            (film[0][lane], film[1][lane]) = (s[0], s[1]);
            weights[lane] = support.weight_over_pdf(s);
        }
        let mut range = ALL_BEHIND;
        instructions.run(step::FilmRays {
            view: &self.accel.view,
            film: &film,
            vertices: &mut paths.vertices,
            range: &mut range,
        });
        paths.light = Vectors::ZERO;
        paths.throughput = Vectors::splat([1.0; 3]);
        let rays = LaneRays {
            origin: &paths.vertices.origin,
            direction: &paths.vertices.direction,
            range: &range,
            mask,
        };
        paths.faces = rays.first_hits(&self.packets);
        paths.rays = [1; LANES];
        self.add_seen(paths, mask);
        self.reflect(paths, mask);
        taken.extend((0..places.len()).map(|lane| Sample {
            numbers: (paths.light.colour(lane) * weights[lane]).to_array(),
            effort: EFFORT_OF_LANE + paths.rays[lane] * self.levels / LEVELS_PER_EFFORT,
            ..Sample::default()
        }));
    }

    /// Adds what the camera sees of the emitter.
    fn add_seen(&self, paths: &mut Paths<'_>, mask: u32) {
        if !self.plan.reaches(1) || self.plan.hide_emitters {
            return;
        }
        for lane in lanes_of(mask) {
            let direction = paths.vertices.direction.get(lane);
            if self.scene.emits(paths.faces[lane], direction) {
                paths.light.set_colour(lane, self.scene.radiance);
            }
        }
    }

    /// Adds what arrives by reflections.
    fn reflect<'s>(&'s self, paths: &mut Paths<'s>, mask: u32) {
        let plan = &self.plan;
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
            let goes_on = plan.reaches(depth + 3);
            let first = plan.vertex_numbers(depth);
            let instructions = self.packets.instructions();
            let Paths {
                vertices, lobes, ..
            } = &mut *paths;
            lobes.face_viewers(instructions, vertices, active);
            // Where directions are drawn from the surface: see `sample_lights`.
            let of_brdf = match goes_on {
                true => active,
                false => {
                    let narrow = instructions.run(step::Narrow {
                        vertices: &paths.vertices,
                        emitter: self.scene.triangles,
                    });
                    active & !narrow | paths.lobes.which(active, |lobes| !lobes.is_diffuse)
                }
            };
            self.add_light(paths, active, first, of_brdf);
            if of_brdf == 0 {
                return;
            }
            let drawn = self.draw_brdf(paths, of_brdf, first + EMITTER_NUMBERS);
            if !goes_on {
                return;
            }
            active = self.roulette(paths, drawn, depth);
        }
    }

    /// Finds where surfaces were hit, and looks them up; one bit for each that scatters something.
    fn find_surfaces<'s>(&'s self, paths: &mut Paths<'s>, active: u32) -> u32 {
        let Paths {
            vertices,
            lobes,
            faces,
            ..
        } = paths;
        let active = mask_of(active, |lane| faces[lane] != NOTHING);
        if active == 0 {
            return 0;
        }
        for lane in lanes_of(active) {
            self.scene.set_plane(faces[lane], lane, vertices);
        }
        let instructions = self.packets.instructions();
        instructions.run(step::Surfaces(vertices));
        mask_of(active, |lane| {
            let found = self.scene.look_up(faces[lane], lane, vertices);
            lobes.set(lane, found.flatten());
            found.is_some()
        })
    }

    /// Adds light from a point sampled on the emitter.
    fn add_light(&self, paths: &mut Paths<'_>, active: u32, first: u32, of_brdf: u32) {
        let lobes = &paths.lobes;
        let active = active & !lobes.which(active, |lobes| !lobes.has_smooth);
        let transmits = lobes.which(active, |lobes| lobes.transmits);
        let instructions = self.packets.instructions();
        let (vertices, lobes) = (&mut paths.vertices, &mut paths.lobes);
        let lit = &mut paths.lit;
        instructions.run(step::Light {
            vertices,
            rectangle: self.scene.rectangle,
            streams: &paths.streams,
            first,
            lanes: active,
            of_brdf,
            transmits,
            lit,
        });
        let wanted = active & lit.mask;
        if wanted == 0 {
            return;
        }
        let rays = LaneRays {
            origin: &vertices.position,
            direction: &lit.direction,
            range: &lit.range,
            mask: wanted,
        };
        for lane in lanes_of(wanted) {
            paths.rays[lane] += 1;
        }
        let seen = wanted & !rays.occluded(&self.packets);
        lobes.weigh_points(instructions, vertices, lit, [seen, of_brdf]);
        instructions.run(step::SumLight {
            light: &mut paths.light,
            throughput: &paths.throughput,
            scattered: &vertices.scattered,
            weight: &lit.weight,
            radiance: self.scene.radiance,
            lanes: seen,
        });
    }

    /// Draws directions from the surfaces, adds what the emitter sends from there, and goes on
    /// along them; one bit for each that does.
    fn draw_brdf(&self, paths: &mut Paths<'_>, active: u32, first: u32) -> u32 {
        let instructions = self.packets.instructions();
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
        vertices.direction = drawn.direction;
        vertices.origin = vertices.position;
        let rays = LaneRays {
            origin: &vertices.origin,
            direction: &vertices.direction,
            range: &ALL_BEHIND,
            mask: active,
        };
        paths.faces = rays.first_hits(&self.packets);
        let faces = &paths.faces;
        let emits = |lane| self.scene.emits(faces[lane], drawn.direction.get(lane));
        let seen = mask_of(active, emits);
        if seen != 0 {
            instructions.run(step::SumLight {
                light: &mut paths.light,
                throughput: &paths.throughput,
                scattered: &vertices.scattered,
                weight: &drawn.weight,
                radiance: self.scene.radiance,
                lanes: seen,
            });
        }
        for lane in lanes_of(active) {
            paths.rays[lane] += 1;
        }
        paths.throughput = paths.throughput.times(&vertices.scattered);
        active
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
            if throughput == Rgb::zero() {
                continue;
            }
            if is_long {
                let survival = throughput.max_component().clamp(0.0, RR_MAX);
                if numbers[lane] >= survival {
                    continue;
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

const _: () = assert!(BSDF_NUMBERS == 3 && EMITTER_NUMBERS == 3);
