//! Irradiance at a point and its derivative: the integral that METHOD's
//! reference set-up is made of, without a camera.

use std::cell::Cell;

use capwalk_math::{Moments, Rgb, Vec3};
use capwalk_scene::{Motion, Scene};
use capwalk_walk::WalkSettings;

use crate::accel::Accel;
use crate::integrator::FIRST_VERTEX;
use crate::light::{LightSampling, sample_lights};
use crate::options::Refusal;
use crate::sampler::Sampler;
use crate::world::{AtRest, Surface, World};

use super::boundary::Draw;
use super::forward::{Forward, check_walk};

/// Statistics of single samples of the red irradiance at a point at rest, and
/// of its derivative along a motion.
#[derive(Clone, Copy, Debug, Default)]
pub struct Irradiance {
    /// The irradiance.
    pub value: Moments,
    /// Its derivative.
    pub gradient: Moments,
}

/// Samples of the irradiance at each point (with its unit normal), from one
/// point drawn on an emitter and, for the derivative, one on the lamps' edges.
pub fn irradiance(
    scene: &Scene,
    motion: &Motion,
    points: &[(Vec3, Vec3)],
    walk: WalkSettings,
    samples: u32,
    seed: u64,
) -> Result<Vec<Irradiance>, Refusal> {
    check_walk(&walk)?;
    let accel = Accel::new(scene);
    let sampling = LightSampling {
        emitter_samples: 1,
        bsdf_samples: 0,
    };
    let forward = Forward::new(&accel, motion, walk, sampling, false);
    let sampler = Sampler::new(&scene.settings, seed, 1);
    // A reflectance of π reflects the irradiance itself.
    let reflectance = Rgb::constant(Rgb::splat(std::f64::consts::PI));
    let at = |index: usize, &(position, normal): &(Vec3, Vec3)| {
        let surface = Surface {
            position: Vec3::constant(position),
            normal: Vec3::constant(normal),
            face_normal: normal,
            bsdf: None,
        };
        let mut irradiance = Irradiance::default();
        for number in 0..samples {
            let stream = sampler.stream(index as u64, number);
            let draw = Draw {
                stream: &stream,
                queries: &Cell::new(0),
            };
            let light = forward.reflected(&surface, reflectance, draw);
            irradiance.value.add(light.x.value);
            irradiance.gradient.add(light.x.tangent[0]);
        }
        irradiance
    };
    Ok(points
        .iter()
        .enumerate()
        .map(|(index, point)| at(index, point))
        .collect())
}

/// Statistics of single samples of the difference of the red irradiance
/// between two scenes, with common random numbers.
pub fn difference(
    scenes: &[Scene; 2],
    points: &[(Vec3, Vec3)],
    samples: u32,
    seed: u64,
) -> Vec<Moments> {
    let accels = [Accel::new(&scenes[0]), Accel::new(&scenes[1])];
    let sampling = LightSampling {
        emitter_samples: 1,
        bsdf_samples: 0,
    };
    let sampler = Sampler::new(&scenes[0].settings, seed, 1);
    let at = |index: usize, &(position, normal): &(Vec3, Vec3)| {
        let mut moments = Moments::default();
        for number in 0..samples {
            let stream = sampler.stream(index as u64, number);
            let [above, below] = [0, 1].map(|i| {
                let accel = &accels[i];
                let world = AtRest(accel);
                let mut light = 0.0;
                sample_lights(
                    accel,
                    position,
                    normal,
                    sampling,
                    &stream,
                    FIRST_VERTEX,
                    |_, sample| {
                        let cos_o = normal.dot(sample.direction);
                        light += world.radiance(sample.emitter).x * cos_o * sample.weight;
                    },
                );
                light
            });
            moments.add(above - below);
        }
        moments
    };
    points
        .iter()
        .enumerate()
        .map(|(index, point)| at(index, point))
        .collect()
}
