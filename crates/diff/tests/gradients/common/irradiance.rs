//! Irradiance at a point and its derivative: the integral that METHOD's
//! reference set-up is made of, without a camera.

use std::f64::consts::PI;
use std::sync::Arc;

use capwalk_boundary::refuse::refuse_walk;
use capwalk_boundary::{Counts, Draw, Field, Method, Refusal, Sampler};
use capwalk_diff::Forward;
use capwalk_math::{Frame, Moments, Real, Rgb, Vec3};
use capwalk_render::{
    Arrival, FIRST_VERTEX, LightSampling, Plan, PreparedScene, Primal, SpecularChain, Tracer,
    Vertex,
};
use capwalk_scene::lobe::{Diffuse, Lobe, LocalBsdf};
use capwalk_scene::{Scene, Tangent};
use capwalk_walk::WalkSettings;

/// A fixed surface point that reflects the irradiance itself: its reflectance
/// is π.
fn diffuse_vertex<R: Real>(position: Vec3, normal: Vec3) -> Vertex<R> {
    let reflectance = Rgb::splat(R::constant(PI));
    let [position, unit] = [position, normal].map(Vec3::constant);
    let lobe = Lobe::Diffuse(Diffuse { reflectance });
    Vertex::new(
        position,
        0,
        normal,
        Frame::from_normal(unit),
        unit,
        LocalBsdf::from(lobe),
    )
}

/// Points drawn on emitters, nothing else.
const EMITTERS_ALONE: Plan = Plan {
    first_vertex: FIRST_VERTEX,
    max_depth: Some(2),
    rr_depth: u32::MAX,
    sampling: LightSampling {
        emitter_samples: 1,
        bsdf_samples: 0,
        alike: true,
    },
    hide_emitters: false,
    aov: None,
};

/// Statistics of single samples of the red irradiance at a fixed point, and
/// of its derivative along a motion.
#[derive(Clone, Copy, Debug, Default)]
pub struct Irradiance {
    /// The irradiance.
    pub value: Moments,
    /// Its derivative.
    pub gradient: Moments,
}

/// Samples of the irradiance at each point (with its unit normal), from one
/// point drawn on an emitter and, for the derivative, one on the emitters' edges.
pub fn irradiance(
    scene: &Scene,
    tangent: &Tangent,
    points: &[(Vec3, Vec3)],
    walk: WalkSettings,
    samples: u32,
    seed: u64,
) -> Result<Vec<Irradiance>, Refusal> {
    refuse_walk(&walk)?;
    let prepared = PreparedScene::new(scene.clone());
    let field = Field::new(prepared.accel(), prepared.boundaries(), Method::Walk);
    let eval = Forward::new(field, tangent);
    let tracer = Tracer::moving(&prepared, field, walk, &Arc::default()).with_plan(EMITTERS_ALONE);
    let sampler = Sampler::new(&scene.settings, seed, 1);
    let at = |index: usize, &(position, normal): &(Vec3, Vec3)| {
        let vertex = diffuse_vertex(position, normal);
        let incoming = [position, -normal].map(Vec3::constant);
        let mut irradiance = Irradiance::default();
        for number in 0..samples {
            let stream = sampler.stream(index as u64, number);
            let draw = Draw {
                stream: &stream,
                counts: &Counts::default(),
            };
            let chain = SpecularChain::default();
            let emitted =
                tracer.emitted(&eval, &vertex, incoming, 0, chain, Arrival::default(), draw);
            let light = emitted.light.r;
            irradiance.value.add(light.value);
            irradiance.gradient.add(light.tangent[0]);
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
    let sides = scenes
        .each_ref()
        .map(|scene| PreparedScene::new(scene.clone()));
    let tracers = [0, 1].map(|i| Tracer::primal(&sides[i]).with_plan(EMITTERS_ALONE));
    let sampler = Sampler::new(&scenes[0].settings, seed, 1);
    let at = |index: usize, &(position, normal): &(Vec3, Vec3)| {
        let vertex = diffuse_vertex(position, normal);
        let mut moments = Moments::default();
        for number in 0..samples {
            let stream = sampler.stream(index as u64, number);
            let draw = Draw {
                stream: &stream,
                counts: &Counts::default(),
            };
            let [above, below] = [0, 1].map(|i| {
                let (eval, chain) = (Primal(sides[i].accel()), SpecularChain::default());
                let incoming = [position, -normal];
                let emitted = tracers[i].emitted(
                    &eval,
                    &vertex,
                    incoming,
                    0,
                    chain,
                    Arrival::default(),
                    draw,
                );
                emitted.light.r
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
