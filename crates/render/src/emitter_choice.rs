//! Which of some emitters a shading point samples: those that seem to light it more are chosen
//! more often, but what hides them is not known.

use capwalk_boundary::Accel;
use capwalk_geometry::add_effort;
use capwalk_scene::EmitterId;

use crate::emitter_sampler::EmitterSampler;
use crate::receiver::Receiver;

/// Share of the choices that do not depend on how bright emitters are: the brightest one may be
/// hidden. So none that can light the point is chosen less than half as often as if all were
/// chosen alike.
pub const UNIFORM: f64 = 0.5;

/// More emitters are chosen alike: to add up their light at each shading point takes too long.
pub const MANY: usize = 32;

/// The probabilities of numbered emitters at a shading point.
pub struct EmitterChoice {
    count: usize,
    /// True if all have the same.
    are_alike: bool,
    /// By number, unless they are alike.
    probabilities: [f64; MANY],
}

impl EmitterChoice {
    /// A choice in which `count` emitters are alike.
    pub fn alike(count: usize) -> Self {
        Self {
            count,
            are_alike: true,
            probabilities: [0.0; MANY],
        }
    }

    /// Makes `count` emitters alike.
    #[inline]
    pub fn make_alike(&mut self, count: usize) {
        (self.count, self.are_alike) = (count, true);
    }

    /// A choice among `count` emitters by how much they seem to light the point. `emitter` gives
    /// them by their numbers, and `samplers` are those of all emitters of the scene.
    pub fn by_light(
        accel: &Accel,
        samplers: &[EmitterSampler],
        receiver: &Receiver,
        count: usize,
        emitter: impl Fn(usize) -> EmitterId,
    ) -> Self {
        let mut choice = Self::alike(count);
        choice.follow_light(count, |i| {
            let id = emitter(i);
            let sampler = &samplers[id.0 as usize];
            [sampler.view(accel, id, receiver), sampler.brightness]
        });
        choice
    }

    /// Makes this a choice among `count` emitters by how much they seem to light the point: `view` gives
    /// what is seen of each ([`EmitterSampler::view`]), and its brightness.
    #[inline]
    pub fn follow_light(&mut self, count: usize, view: impl Fn(usize) -> [f64; 2]) {
        self.make_alike(count);
        if !(2..=MANY).contains(&count) {
            return;
        }
        add_effort(count as u64);
        // How much light each sends, if nothing is in between, and which can send any.
        let (mut all, mut can_light) = (0.0, 0_u32);
        let probabilities = &mut self.probabilities[..count];
        for (i, light) in probabilities.iter_mut().enumerate() {
            let [view, brightness] = view(i);
            *light = view * brightness;
            all += *light;
            can_light |= u32::from(view > 0.0) << i;
        }
        // False for NaN, and where all are black.
        if all > 0.0 && all < f64::INFINITY {
            let alike = UNIFORM / f64::from(can_light.count_ones());
            for (i, probability) in probabilities.iter_mut().enumerate() {
                let alike = if can_light >> i & 1 == 1 { alike } else { 0.0 };
                *probability = alike + (1.0 - UNIFORM) * *probability / all;
            }
            self.are_alike = false;
        }
    }

    /// The number of the emitter that `u` in `[0, 1)` chooses, and its probability; `None` if
    /// there are none.
    pub fn choose(&self, u: f64) -> Option<(usize, f64)> {
        let last = self.count.checked_sub(1)?;
        if self.are_alike {
            let chosen = ((u * self.count as f64) as usize).min(last);
            return Some((chosen, self.probability(chosen)));
        }
        let (mut rest, mut chosen) = (u, None);
        for (i, &probability) in self.probabilities[..self.count].iter().enumerate() {
            if probability > 0.0 {
                // The last one takes what rounding leaves over.
                chosen = Some((i, probability));
            }
            if rest < probability {
                break;
            }
            rest -= probability;
        }
        chosen
    }

    /// The probability of the emitter of a number; 0 only if it cannot light the point.
    pub fn probability(&self, i: usize) -> f64 {
        match self.are_alike {
            true => 1.0 / self.count as f64,
            false => self.probabilities[i],
        }
    }
}

#[cfg(test)]
mod tests {
    use capwalk_math::{Affine, Rgb, Vec3};
    use capwalk_scene::primitive::rectangle;
    use capwalk_scene::{Attribute, Emitter, Pattern, Shape, ShapeId, Texture, builtin};

    use super::*;
    use crate::prepared::PreparedScene;
    use crate::scene_eval::Primal;
    use crate::shading::vertex_at;
    use crate::surface::surface_at;

    /// Emitters are chosen as often as their probabilities say, brighter and nearer ones more
    /// often, those below the horizon or seen from behind never, and hidden ones still.
    #[test]
    fn brighter_emitters_are_chosen_more_often() {
        let mut scene = builtin::scene("leaf").expect("built in");
        let bsdf = scene.shapes[0].bsdf;
        scene.shapes.clear();
        scene.emitters.clear();
        let (floor, normals) = rectangle(Affine::scale(Vec3::splat(5.0)));
        scene.add_shape(Shape::new("floor", floor, normals, bsdf));
        // Height above the floor, radiance, and whether it looks down.
        let emitters = [
            (2.0, 1.0, true),
            (2.0, 10.0, true),
            (4.0, 10.0, true),
            (3.0, 100.0, false),
            (-2.0, 100.0, true),
            (2.5, 0.0, true),
        ];
        for (i, (height, radiance, faces_down)) in emitters.into_iter().enumerate() {
            let turn = if faces_down {
                std::f64::consts::PI
            } else {
                0.0
            };
            let place = Affine::translate(Vec3::new(0.0, 0.0, height))
                * Affine::rotate(Vec3::new(1.0, 0.0, 0.0), turn)
                * Affine::scale(Vec3::splat(0.2));
            let (mesh, normals) = rectangle(place);
            let name = format!("lamp{i}");
            let mut shape = Shape::new(&name, mesh, normals, bsdf);
            // One emitter has its radiance at its faces, as half of it.
            let radiance = match i {
                1 => {
                    let texture = |data, pattern| Texture {
                        id: name.clone(),
                        channels: 1,
                        data,
                        pattern,
                    };
                    let halves = vec![0.5 * radiance; 2];
                    shape.attributes.push(Attribute {
                        name: "face_glow".into(),
                        texture: scene.add_texture(texture(halves, Pattern::PerFace)),
                    });
                    let pattern = Pattern::MeshAttribute {
                        name: "face_glow".into(),
                        scale: 2.0,
                    };
                    scene.add_texture(texture(Vec::new(), pattern))
                }
                _ => scene.add_texture(Texture::colour(&name, Rgb::splat(radiance))),
            };
            scene.add_shape(shape);
            let shape = ShapeId(scene.shapes.len() as u32 - 1);
            scene.emitters.push(Emitter::Area { shape, radiance });
        }
        let prepared = PreparedScene::new(scene);
        let accel = prepared.accel();
        let (origin, down) = (Vec3::new(1.0, 0.5, 0.5), Vec3::new(0.0, 0.0, -1.0));
        let hit = accel.first_hit(origin, down).expect("the floor");
        let eval = Primal(accel);
        let surface = surface_at(&eval, accel, &hit, origin, down);
        let vertex = vertex_at(&eval, accel, &surface, down).expect("diffuse");
        let choice = EmitterChoice::by_light(
            accel,
            prepared.emitters(),
            &vertex.receiver(),
            emitters.len(),
            |i| EmitterId(i as u32),
        );
        let probabilities: Vec<f64> = (0..emitters.len()).map(|i| choice.probability(i)).collect();
        assert!((probabilities.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        let least = UNIFORM / 4.0;
        assert!(
            probabilities[1] > 2.5 * probabilities[0],
            "{probabilities:?}"
        );
        assert!(probabilities[1] > probabilities[2] && probabilities[2] > probabilities[0]);
        assert_eq!(probabilities[3..], [0.0, 0.0, least]);
        let n = 10_000;
        let mut counts = [0.0; 6];
        for k in 0..n {
            let u = (f64::from(k) + 0.5) / f64::from(n);
            let (chosen, probability) = choice.choose(u).expect("one");
            assert_eq!(probability, probabilities[chosen]);
            counts[chosen] += 1.0 / f64::from(n);
        }
        for (count, probability) in counts.iter().zip(&probabilities) {
            assert!((count - probability).abs() < 2.0 / f64::from(n));
        }
    }
}
