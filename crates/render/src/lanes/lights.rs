//! Light that reaches the surfaces of lanes from emitters. Rectangles, point emitters, and the
//! environment map are sampled all lanes at a time, other emitters one by one.

use capwalk_boundary::{Accel, Streams};
use capwalk_geometry::Hit;
use capwalk_geometry::simd::Instructions;
use capwalk_math::{Rgb, Vec3};
use capwalk_scene::{Emitter, EmitterId, Scene, TextureId};

use crate::emitter_choice::{EmitterChoice, MANY};
use crate::emitter_sampler::{DirectionSampler, EmitterSampler};
use crate::lanes::lit::{Lit, SeenEmitter, SkyPoint};
use crate::lanes::lobes::LaneLobes;
use crate::lanes::point_emitters::{LookAtPointEmitters, PointEmitter, ViewPointEmitter};
use crate::lanes::rectangles::{Rectangles, SampleRectangles};
use crate::lanes::scene::LaneScene;
use crate::lanes::sky::{DrawSky, SeeSky, Sky};
use crate::lanes::step::Vertices;
use crate::lanes::vectors::{LANES, Numbers, Vectors, lanes_of};
use crate::light::{TowardsEmitter, all_are_deltas, emitter_pdf};
use crate::path_adjoint::PathAdjoint;
use crate::plan::LightSampling;
use crate::prepared::PreparedScene;
use crate::receiver::Receiver;
use crate::rectangle_sampler::RectangleSampler;
use crate::scene_eval::Primal;
use crate::surface::{emitted_at, irradiance_of};
use crate::triangle_sampler::Node;

/// The emitters of a scene.
pub struct LaneLights<'a> {
    accel: &'a Accel,
    samplers: &'a [EmitterSampler],
    sampling: LightSampling,
    kinds: Vec<Kind<'a>>,
    /// The environment map.
    sky: Option<Sky<'a>>,
    /// All of the only emitter, if that is a surface.
    only: Option<&'a Node>,
    /// True if no direction drawn from a surface leads to an emitter.
    pub are_deltas: bool,
    /// Those whose numbers are asked for.
    asked: Vec<bool>,
}

/// What is known of an emitter.
struct Kind<'a> {
    /// If it is one.
    rectangle: Option<&'a RectangleSampler>,
    /// True for an environment map.
    is_sky: bool,
    /// What it emits, if that is the same everywhere.
    radiance: Option<Rgb>,
    /// True if it has no extent.
    is_delta: bool,
    /// If it is one.
    point: Option<PointEmitter>,
}

/// Which emitters surfaces choose.
pub struct LaneChoices {
    choices: [EmitterChoice; LANES],
    /// True if all emitters are alike in all lanes.
    are_alike: bool,
    /// How much the surfaces receive of point emitters.
    views: Vec<Numbers>,
    /// Where the point emitters are that they chose.
    positions: Vectors,
    rectangles: Rectangles,
}

impl<'a> LaneLights<'a> {
    /// The emitters of a scene.
    pub fn new(
        prepared: &'a PreparedScene,
        sampling: LightSampling,
        is_asked_for: &dyn Fn(TextureId) -> bool,
    ) -> Self {
        let accel = prepared.accel();
        let samplers = prepared.emitters();
        let kind = |(emitter, sampler): (&Emitter, &'a EmitterSampler)| {
            let texture = accel.scene.texture(emitter.radiance());
            let is_delta = matches!(sampler.directions, DirectionSampler::Delta);
            let is_sky = matches!(sampler.directions, DirectionSampler::Environment(_));
            let is_same = texture.is_constant() && !is_delta && !is_sky;
            Kind {
                is_sky,
                rectangle: match &sampler.directions {
                    DirectionSampler::Area(triangles) => triangles.rectangle(),
                    _ => None,
                },
                radiance: is_same.then(|| texture.texel(0)),
                is_delta,
                point: match emitter {
                    Emitter::Point { position, .. } if texture.is_constant() => {
                        Some(PointEmitter {
                            position: *position,
                            intensity: texture.texel(0),
                        })
                    }
                    _ => None,
                },
            }
        };
        let only = match samplers {
            [sampler] => match &sampler.directions {
                DirectionSampler::Area(triangles) => Some(triangles.root()),
                _ => None,
            },
            _ => None,
        };
        let emitters = accel.scene.emitters.iter().zip(samplers);
        let kinds = emitters.clone().map(kind).collect();
        Self {
            accel,
            samplers,
            sampling,
            asked: (accel.scene.emitters.iter())
                .map(|emitter| is_asked(&accel.scene, emitter, is_asked_for))
                .collect(),
            sky: emitters.clone().find_map(|pair| sky(&accel.scene, pair)),
            kinds,
            only,
            are_deltas: all_are_deltas(samplers),
        }
    }

    /// All of the only emitter, if points on it may be enough where it is seen narrow.
    pub fn only(&self) -> Option<&'a Node> {
        self.only.filter(|_| self.sampling.emitter_samples > 0)
    }

    /// No choices yet.
    pub fn choices(&self) -> LaneChoices {
        let mut rectangles = Rectangles::NONE;
        if let [
            Kind {
                rectangle: Some(rectangle),
                ..
            },
        ] = &self.kinds[..]
        {
            rectangles.fill(&rectangle.rectangle);
        }
        LaneChoices {
            choices: std::array::from_fn(|_| EmitterChoice::alike(self.samplers.len())),
            are_alike: true,
            views: vec![[0.0; LANES]; self.kinds.len()],
            positions: Vectors::ZERO,
            rectangles,
        }
    }

    /// True if numbers of an emitter are asked for.
    pub fn is_asked_for(&self, emitter: EmitterId) -> bool {
        self.asked[emitter.0 as usize]
    }

    /// Finds the probabilities of emitters at some surfaces, of which some transmit light: all the
    /// same where `on_emitters` has no bit.
    pub fn choose(
        &self,
        instructions: Instructions,
        choices: &mut LaneChoices,
        (vertices, lobes): (&Vertices, &LaneLobes<'_>),
        [lanes, on_emitters, transmits]: [u32; 3],
    ) {
        let count = self.samplers.len();
        let by_light = match (2..=MANY).contains(&count) && !self.sampling.alike {
            true => lanes & on_emitters,
            false => 0,
        };
        if by_light == 0 {
            if !choices.are_alike {
                let all = &mut choices.choices;
                all.iter_mut().for_each(|choice| choice.make_alike(count));
                choices.are_alike = true;
            }
            return;
        }
        choices.are_alike = false;
        for (views, kind) in choices.views.iter_mut().zip(&self.kinds) {
            if let Some(PointEmitter { position, .. }) = kind.point {
                *views = instructions.run(ViewPointEmitter {
                    position,
                    vertices,
                    transmits,
                });
            }
        }
        for lane in lanes_of(lanes) {
            let choice = &mut choices.choices[lane];
            if by_light >> lane & 1 == 0 {
                choice.make_alike(count);
                continue;
            }
            let receiver = lobes.receiver(vertices, lane);
            choice.follow_light(count, |i| {
                let (sampler, id) = (&self.samplers[i], EmitterId(i as u32));
                let view = match self.kinds[i].point {
                    Some(_) => choices.views[i][lane],
                    None => sampler.view(self.accel, id, &receiver),
                };
                [view, sampler.brightness]
            });
        }
    }

    /// Draws directions towards emitters at some lanes, whatever is in between.
    pub fn draw(
        &self,
        instructions: Instructions,
        choices: &mut LaneChoices,
        (vertices, lobes): (&Vertices, &LaneLobes<'_>),
        streams: &Streams<LANES>,
        first: u32,
        lanes: u32,
        lit: &mut Lit,
    ) {
        (lit.mask, lit.of_delta) = (0, 0);
        let [rectangles, skies] = match &self.kinds[..] {
            // There is nothing to choose.
            [
                Kind {
                    rectangle: Some(_), ..
                },
            ] => {
                lit.emitters = [EmitterId(0); LANES];
                lit.inverse_density = [1.0 / f64::from(self.sampling.emitter_samples); LANES];
                [lanes, 0]
            }
            _ => {
                let surfaces = (vertices, lobes);
                self.choose_and_draw(instructions, choices, surfaces, streams, first, lanes, lit)
            }
        };
        if rectangles != 0 {
            instructions.run(SampleRectangles {
                rectangles: &choices.rectangles,
                vertices,
                streams,
                first: first + 1,
                lanes: rectangles,
                lit,
            });
        }
        if let Some(sky) = self.sky
            && skies != 0
        {
            instructions.run(DrawSky {
                sky,
                streams,
                first: first + 1,
                lanes: skies,
                lit,
            });
        }
    }

    /// Chooses emitters, and draws directions towards those that are neither rectangles nor the
    /// environment map; one bit for each that is one, and for each that is the other. Their inverse
    /// densities lack the density of directions, which is not known yet.
    fn choose_and_draw(
        &self,
        instructions: Instructions,
        choices: &mut LaneChoices,
        (vertices, lobes): (&Vertices, &LaneLobes<'_>),
        streams: &Streams<LANES>,
        first: u32,
        lanes: u32,
        lit: &mut Lit,
    ) -> [u32; 2] {
        let (mut rectangles, mut skies, mut points) = (0, 0, 0);
        let choice = match self.samplers.len() {
            0 | 1 => [0.0; LANES],
            _ => streams.numbers(first, lanes),
        };
        for lane in lanes_of(lanes) {
            let Some((chosen, probability)) = choices.choices[lane].choose(choice[lane]) else {
                continue;
            };
            let kind = &self.kinds[chosen];
            lit.emitters[lane] = EmitterId(chosen as u32);
            let times = f64::from(self.sampling.emitter_samples) * probability;
            lit.inverse_density[lane] = 1.0 / times;
            if let Some(rectangle) = kind.rectangle {
                choices.rectangles.set(lane, &rectangle.rectangle);
                rectangles |= 1 << lane;
            } else if kind.is_sky {
                skies |= 1 << lane;
            } else if let Some(point) = kind.point {
                choices.positions.set(lane, point.position);
                lit.radiance.set_colour(lane, point.intensity);
                lit.hits[lane] = None;
                points |= 1 << lane;
            } else if kind.is_delta {
                self.look_at_delta(lit.emitters[lane], vertices.position.get(lane), lane, lit);
            } else {
                let u = [1, 2].map(|i| streams.number(lane, first + i));
                let receiver = lobes.receiver(vertices, lane);
                self.draw_one(chosen, &receiver, u, times, lane, lit);
            }
        }
        if points != 0 {
            instructions.run(LookAtPointEmitters {
                vertices,
                positions: &choices.positions,
                lanes: points,
                lit,
            });
        }
        [rectangles, skies]
    }

    /// Finds the direction towards any other emitter without extent, and with it the light from there.
    fn look_at_delta(&self, emitter: EmitterId, position: Vec3, lane: usize, lit: &mut Lit) {
        let Some(light) = self.accel.delta_light(emitter, position) else {
            return;
        };
        let own = self.accel.scene.emitter(emitter);
        let irradiance = irradiance_of(&Primal(self.accel), own, &light);
        lit.radiance.set_colour(lane, irradiance);
        lit.direction.set(lane, light.direction);
        lit.range[1][lane] = light.distance;
        lit.hits[lane] = None;
        lit.mask |= 1 << lane;
        lit.of_delta |= 1 << lane;
    }

    /// Draws a direction towards any other emitter.
    fn draw_one(
        &self,
        chosen: usize,
        receiver: &Receiver,
        u: [f64; 2],
        times: f64,
        lane: usize,
        lit: &mut Lit,
    ) {
        let (emitter, sampler) = (EmitterId(chosen as u32), &self.samplers[chosen].directions);
        let drawn = TowardsEmitter::draw(self.accel, emitter, sampler, receiver, u);
        // False for no density, as well as for a direction that leads nowhere.
        let Some(drawn) = drawn.filter(|drawn| drawn.pdf > 0.0) else {
            return;
        };
        lit.direction.set(lane, drawn.direction);
        lit.range[1][lane] = drawn.distance;
        lit.inverse_density[lane] = 1.0 / (times * drawn.pdf);
        lit.hits[lane] = drawn.hit;
        lit.mask |= 1 << lane;
    }

    /// Finds what some lanes receive from the emitters towards which directions were drawn.
    pub fn shine(&self, vertices: &Vertices, lanes: u32, lit: &mut Lit) {
        if let [
            Kind {
                radiance: Some(radiance),
                ..
            },
        ] = &self.kinds[..]
        {
            lit.radiance = Vectors::splat(radiance.to_array());
            return;
        }
        for lane in lanes_of(lanes) {
            let emitter = lit.emitters[lane];
            let kind = &self.kinds[emitter.0 as usize];
            let (position, direction) = (vertices.position.get(lane), lit.direction.get(lane));
            let radiance = match kind.radiance {
                Some(radiance) => radiance,
                None if kind.is_delta => continue,
                None if kind.is_sky => lit.sky[lane].radiance,
                None => {
                    let seen = self.seen(vertices, lit, lane);
                    self.radiance(emitter, &seen, position, direction)
                }
            };
            lit.radiance.set_colour(lane, radiance);
        }
    }

    /// What of an emitter is seen in the direction that was drawn towards it.
    pub fn seen(&self, vertices: &Vertices, lit: &Lit, lane: usize) -> SeenEmitter {
        let emitter = lit.emitters[lane];
        let kind = &self.kinds[emitter.0 as usize];
        if kind.is_sky {
            return SeenEmitter {
                hit: None,
                sky: Some(lit.sky[lane]),
            };
        }
        let Some(rectangle) = kind.rectangle else {
            return SeenEmitter::on(lit.hits[lane]);
        };
        let t = lit.range[1][lane];
        let point = vertices.position.get(lane) + lit.direction.get(lane) * t;
        let (face, barycentric) = rectangle.place_of(point);
        SeenEmitter::on(Some(Hit {
            t,
            face: self.accel.emitter_face(emitter, face),
            barycentric,
        }))
    }

    /// What of an emitter is seen along a ray that hits it there, or misses everything and sees this
    /// of the environment map ([`Self::see_sky`]).
    pub fn seen_at(&self, emitter: EmitterId, hit: Option<Hit>, sky: &SkyPoint) -> SeenEmitter {
        let is_sky = self.kinds[emitter.0 as usize].is_sky;
        SeenEmitter {
            hit,
            sky: is_sky.then_some(*sky),
        }
    }

    /// Finds what of the environment map, if there is one, some lanes see that miss everything.
    pub fn see_sky(
        &self,
        instructions: Instructions,
        directions: &Vectors,
        lanes: u32,
        seen: &mut [SkyPoint; LANES],
    ) {
        if let Some(sky) = self.sky
            && lanes != 0
        {
            instructions.run(SeeSky {
                sky,
                directions,
                lanes,
                seen,
            });
        }
    }

    /// What an emitter sends back along a ray that hits it, or misses everything.
    pub fn radiance(
        &self,
        emitter: EmitterId,
        seen: &SeenEmitter,
        origin: Vec3,
        direction: Vec3,
    ) -> Rgb {
        let kind = &self.kinds[emitter.0 as usize];
        match (kind.radiance, &seen.sky) {
            (Some(radiance), _) => radiance,
            (None, Some(sky)) => sky.radiance,
            (None, None) => emitted_at(
                &Primal(self.accel),
                self.accel,
                emitter,
                seen.hit.as_ref(),
                origin,
                direction,
            ),
        }
    }

    /// The density with which a direction in which an emitter is seen is drawn by all points on
    /// emitters together.
    pub fn density(
        &self,
        choices: &LaneChoices,
        lane: usize,
        emitter: EmitterId,
        seen: &SeenEmitter,
        direction: Vec3,
        receiver: impl FnOnce() -> Receiver,
    ) -> f64 {
        let index = emitter.0 as usize;
        let probability = choices.choices[lane].probability(index);
        let pdf = match &seen.sky {
            Some(sky) => sky.pdf,
            None => {
                let (sampler, hit) = (&self.samplers[index].directions, seen.hit.as_ref());
                emitter_pdf(self.accel, emitter, sampler, hit, direction, &receiver())
            }
        };
        f64::from(self.sampling.emitter_samples) * probability * pdf
    }
}

impl LaneLights<'_> {
    /// From the covector on what is seen of an emitter to those on its numbers that are asked for;
    /// `position` is where it was drawn from.
    pub fn pull(
        &self,
        emitter: EmitterId,
        seen: &SeenEmitter,
        position: Option<Vec3>,
        covector: Rgb,
        scene: &LaneScene<'_>,
        depends: &mut impl FnMut(PathAdjoint),
    ) {
        if !self.is_asked_for(emitter) {
            return;
        }
        match (self.accel.scene.emitter(emitter), position) {
            (
                Emitter::Point { .. }
                | Emitter::Spot { .. }
                | Emitter::Projector { .. }
                | Emitter::Directional { .. },
                Some(position),
            ) => depends(PathAdjoint::Irradiance {
                emitter,
                position,
                covector,
            }),
            (Emitter::EnvironmentMap { data, scale, .. }, _) => {
                let (Some(sky), Some(point)) = (&self.sky, &seen.sky) else {
                    return;
                };
                let (map, on_texels) = (sky.table.map(), covector * sky.scale);
                for (index, weight) in map.weights(&point.place) {
                    scene.add_texel(*data, index, on_texels * weight, depends);
                }
                let texel = |index| sky.texels.texel(index);
                let on_scale = covector * map.at(&point.place, texel);
                scene.add_texel(*scale, 0, on_scale, depends);
            }
            (emitter, _) => {
                let at = seen.hit.as_ref().map(|hit| scene.point_of(hit));
                scene.pull_texture(emitter.radiance(), at.as_ref(), covector, depends);
            }
        }
    }
}

/// An emitter, if it is an environment map.
fn sky<'a>(
    scene: &'a Scene,
    (emitter, sampler): (&'a Emitter, &'a EmitterSampler),
) -> Option<Sky<'a>> {
    match (emitter, &sampler.directions) {
        (Emitter::EnvironmentMap { data, scale, .. }, DirectionSampler::Environment(table)) => {
            Some(Sky {
                table,
                texels: scene.texture(*data),
                scale: scene.texture(*scale).texel(0),
            })
        }
        _ => None,
    }
}

/// True if the radiance of an emitter, or another of its numbers, is asked for.
fn is_asked(scene: &Scene, emitter: &Emitter, is_asked_for: &dyn Fn(TextureId) -> bool) -> bool {
    emitter.slots().into_iter().any(|slot| {
        is_asked_for(match emitter.shape() {
            Some(shape) => scene.numbers_of(slot.texture, scene.shape(shape)),
            None => slot.texture,
        })
    })
}
