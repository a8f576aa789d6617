//! Samples of lanes against those of [`Tracer`], and which scenes they are for.

use capwalk_boundary::{Counts, Draw, Sampler};
use capwalk_math::Rgb;
use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
use capwalk_scene::{Bsdf, Filter, Integrator, Pattern, SamplerKind, Scene, builtin};

use super::*;
use crate::scene_eval::Primal;

fn direct(hide_emitters: bool) -> Integrator {
    Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters,
    }
}

fn path(max_depth: Option<u32>) -> Integrator {
    Integrator::Path {
        max_depth,
        rr_depth: 2,
        hide_emitters: false,
    }
}

/// A built-in scene of 24 × 18 pixels.
fn scene(name: &str, integrator: Integrator) -> Scene {
    let mut scene = builtin::scene(name).expect("built in");
    scene.film.size = [24, 18];
    scene.film.crop_size = [24, 18];
    scene.settings.integrator = integrator;
    scene
}

/// The same with a picture on all surfaces.
fn painted(mut scene: Scene) -> Scene {
    let colours = scene
        .materials
        .iter()
        .filter_map(|material| match material.bsdf {
            Bsdf::Diffuse { reflectance } => Some(reflectance),
            _ => None,
        });
    let colours: Vec<_> = colours.collect();
    for id in colours {
        let texture = std::sync::Arc::make_mut(&mut scene.textures[id.0 as usize]);
        texture.channels = 3;
        texture.data = (0..48).map(|i| f64::from(i * 7 % 10) / 10.0).collect();
        texture.pattern = Pattern::Bitmap(Bitmap {
            width: 4,
            height: 4,
            filter: TexelFilter::Bilinear,
            wrap: Wrap::Repeat,
            to_uv: UvTransform::IDENTITY,
        });
    }
    for shape in &mut scene.shapes {
        let shape = std::sync::Arc::make_mut(shape);
        let corners = |i: usize| {
            let [a, b] = [0.37, 0.61].map(|k| (i as f64 * k).fract());
            [[a, b], [a + 0.8, b], [a, b + 0.9]]
        };
        shape.uvs = Some((0..shape.mesh.faces.len()).map(corners).collect());
    }
    scene.check().expect("a valid scene");
    scene
}

/// Sample by sample the same light, but for rays that pass an edge so near that single precision
/// does not resolve it, and what becomes of these paths.
fn samples_are_those_of_the_tracer(what: &str, scene: Scene) {
    let prepared = PreparedScene::new(scene);
    let (scene, tracer) = (prepared.scene(), Tracer::primal(&prepared));
    let lanes = LaneTracer::like(&tracer, &prepared).expect("for lanes");
    let sampler = Sampler::new(&scene.settings, 3, 64);
    let [width, height] = scene.film.crop_size;
    let place = |i: u32| {
        let pixel = i * 29 % (width * height);
        SamplePlace {
            pixel: [pixel % width, pixel / width],
            stream: sampler.stream(u64::from(pixel), i % 64),
        }
    };
    // Not a multiple of eight.
    let places: Vec<SamplePlace> = (0..20_005).map(place).collect();
    let mut taken = Vec::new();
    lanes.take(&places, &mut taken);
    assert_eq!(taken.len(), places.len());
    let eval = Primal(prepared.accel());
    let (mut differ, mut lit, mut means) = (0, 0, [0.0; 2]);
    for (place, sample) in places.iter().zip(&taken) {
        let draw = Draw {
            stream: &place.stream,
            counts: &Counts::default(),
        };
        let expected: Rgb = tracer.pixel(&eval, place.pixel, draw);
        let found = Rgb::from(sample.numbers);
        lit += u32::from(expected.r > 0.0);
        let error = (found - expected).to_array().map(f64::abs);
        let size = expected.max_component().max(1e-3);
        differ += u32::from(error.iter().any(|&error| error > 1e-9 * size));
        means[0] += found.r;
        means[1] += expected.r;
    }
    println!(
        "{what}: {differ} differ, {lit} lit, {}",
        means[0] / means[1]
    );
    assert!(lit > 5000, "{what}: {lit}");
    assert!(differ < 60, "{what}: {differ} differ");
    assert!(
        (means[0] / means[1] - 1.0).abs() < 0.01,
        "{what}: {means:?}"
    );
}

#[test]
fn lanes_sample_what_the_tracer_does() {
    for (name, integrator) in [
        ("leaf", direct(false)),
        // So many triangles that reflected rays are traced one by one.
        ("ball", path(Some(4))),
        ("box-room", direct(true)),
        ("box-room", path(Some(3))),
        ("box-room", path(None)),
    ] {
        samples_are_those_of_the_tracer(name, scene(name, integrator));
    }
}

/// With a picture on all surfaces, with normals at vertices and points that are not independent,
/// and filters with weights.
#[test]
fn lanes_sample_pictures() {
    let mut scene = scene("ball", path(Some(4)));
    scene.settings.sampler = SamplerKind::Sobol;
    scene.film.filter = Filter::Gaussian { stddev: 0.5 };
    let has_normals = |scene: &Scene| {
        let mut shapes = scene.shapes.iter();
        shapes.any(|shape| shape.normals.per_vertex().is_some())
    };
    assert!(has_normals(&scene));
    samples_are_those_of_the_tracer("painted ball", painted(scene));
}

/// Whatever is taken along with it, a sample is the same to the bit.
#[test]
fn samples_do_not_depend_on_each_other() {
    let prepared = PreparedScene::new(scene("box-room", path(None)));
    let tracer = Tracer::primal(&prepared);
    let lanes = LaneTracer::like(&tracer, &prepared).expect("for lanes");
    let sampler = Sampler::new(&prepared.scene().settings, 5, 64);
    let place = |i: u32| SamplePlace {
        pixel: [i % 24, i / 24 % 18],
        stream: sampler.stream(u64::from(i % 432), i / 432),
    };
    let places: Vec<SamplePlace> = (0..4000).map(place).collect();
    let (mut together, mut shifted) = (Vec::new(), Vec::new());
    lanes.take(&places, &mut together);
    lanes.take(&places[3..], &mut shifted);
    for (a, b) in together[3..].iter().zip(&shifted) {
        assert_eq!((a.numbers, a.effort), (b.numbers, b.effort));
    }
}

/// Other scenes are left to the tracer.
#[test]
fn other_scenes_are_not_for_lanes() {
    let is_for_lanes = |scene: Scene| {
        let prepared = PreparedScene::new(scene);
        LaneTracer::like(&Tracer::primal(&prepared), &prepared).is_some()
    };
    let room = || scene("box-room", path(None));
    assert!(is_for_lanes(room()));
    // No emitter, two of them, more samples, and a shape that packets do not resolve.
    let mut dark = room();
    dark.emitters.clear();
    dark.shapes
        .iter_mut()
        .for_each(|shape| std::sync::Arc::make_mut(shape).emitter = None);
    assert!(!is_for_lanes(dark));
    let mut more = room();
    more.settings.integrator = Integrator::Direct {
        emitter_samples: 2,
        bsdf_samples: 1,
        hide_emitters: false,
    };
    assert!(!is_for_lanes(more));
    let mut tiny = room();
    let last = tiny.shapes.len() - 1;
    let shape = std::sync::Arc::make_mut(&mut tiny.shapes[last]);
    shape.mesh.positions.iter_mut().for_each(|p| *p = *p * 1e-3);
    assert!(!is_for_lanes(tiny));
}
