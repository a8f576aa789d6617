//! Edges sampled in cones on the device, against the sampler of the CPU, and against what
//! their probabilities promise.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use capwalk_boundary::{Accel, Boundaries};
use capwalk_geometry::EdgeSelection;
use capwalk_geometry::edge::closest_direction;
use capwalk_geometry::sampler_buffers::{DrawnEdge, EdgeCone, SamplerBuffers};
use capwalk_gpu::{DeviceEdgeSampler, Precision};
use capwalk_math::{Affine, Vec3};
use capwalk_scene::primitive::{cube, icosphere, rectangle};
use capwalk_scene::{BsdfId, Scene, ShadingNormals, Shape, builtin};

use super::adapter;
use super::meshes::Random;

/// Samples of each cone.
const SAMPLES: usize = 20_000;

/// Standard errors by which frequencies may differ from probabilities: with some thousand edges
/// one of as many tests fails by chance in 10 million.
const ERRORS: f64 = 6.5;

/// Waves on a ball, a box that crosses it, an open sheet.
fn accel() -> Accel {
    let mut scene: Scene = builtin::scene("leaf").expect("built in");
    scene.shapes.clear();
    scene.emitters.clear();
    let mut ball = icosphere(7);
    for p in &mut ball.positions {
        *p = *p * (1.0 + 0.1 * (7.0 * p.x).sin() * (6.0 * p.y).cos() * (5.0 * p.z).sin());
    }
    let place = |x: f64, size: f64| {
        Affine::translate(Vec3::new(x, 0.3, -0.2))
            * Affine::rotate(Vec3::new(0.3, 0.8, 0.5), 0.7)
            * Affine::scale(Vec3::splat(size))
    };
    for mesh in [ball, cube(place(1.1, 0.4)).0, rectangle(place(-1.6, 0.5)).0] {
        scene.add_shape(Shape::new("", mesh, ShadingNormals::Face, BsdfId(0)));
    }
    Accel::new(scene)
}

/// From around the shapes, inside and far away, wide and narrow.
fn cones(random: &mut Random) -> Vec<EdgeCone> {
    let mut cones = Vec::new();
    for (distance, max_angle) in [
        (3.0, PI),
        (3.0, 0.3),
        (1.3, 1.2),
        (0.2, 2.0),
        (40.0, 0.02),
        (2.0, 2.9),
    ] {
        let from = random.direction();
        cones.push(EdgeCone {
            apex: from * distance,
            axis: (random.direction() * 0.7 - from * distance).normalized(),
            max_angle,
            numbers: [0.0; 2],
        });
    }
    cones
}

/// The cone with other random numbers.
fn repeated(cone: &EdgeCone, random: &mut Random, count: usize) -> Vec<EdgeCone> {
    let again = |_| EdgeCone {
        numbers: [(); 2].map(|()| random.number()),
        ..*cone
    };
    (0..count).map(again).collect()
}

/// In double precision, the edges and probabilities of the CPU, number by number.
#[test]
fn samples_are_those_of_the_cpu() {
    let accel = accel();
    let boundaries = Boundaries::new(&accel);
    adapter::each(|gpu| {
        if gpu.precision() == Precision::Single {
            return;
        }
        let mut random = Random(41);
        for selection in [EdgeSelection::Silhouettes, EdgeSelection::All] {
            let sampler = boundaries.edge_sampler(&accel, selection);
            let device = DeviceEdgeSampler::new(gpu, &sampler.buffers()).expect("enough memory");
            let mut all = cones(&mut random);
            all.extend([0.0, -1.0, f64::NAN].map(|max_angle| EdgeCone {
                max_angle,
                ..all[0]
            }));
            let (mut found, mut different) = (0, 0);
            for cone in &all {
                let some = repeated(cone, &mut random, 1000);
                let samples = device.sample(&some).expect("answers");
                for (cone, sample) in some.iter().zip(samples) {
                    let expected = sampler.sample_in_cone(cone);
                    found += usize::from(sample.is_some());
                    let is_same = match (sample, expected) {
                        (Some(a), Some(b)) => {
                            a.edge == b.edge && (a.probability / b.probability - 1.0).abs() < 1e-9
                        }
                        (a, b) => a == b,
                    };
                    different += usize::from(!is_same);
                    if adapter::is_exact(gpu) {
                        assert_eq!(sample, expected, "{cone:?}");
                    }
                }
            }
            // Rounding decides where a number is at the border of two shares.
            assert!(different <= 2, "{different} of {found} are other ones");
            assert!(found > 2000, "{found} samples prove little");
        }
    });
}

/// The edges that count and meet a cone, by brute force, each with its size.
fn counting(
    boundaries: &Boundaries,
    accel: &Accel,
    buffers: &SamplerBuffers,
    cone: &EdgeCone,
) -> BTreeMap<u32, f64> {
    let factors = buffers.factors.as_chunks::<2>().0;
    let all = buffers.edges.iter().zip(factors);
    let counting = all.filter_map(|(&number, factors)| {
        let edge = &boundaries.edges()[number as usize];
        let is_silhouette = edge.is_silhouette(&accel.mesh, cone.apex);
        let [a, b] = boundaries.ends(number).map(|p| p - cone.apex);
        let angle = closest_direction(a, b, cone.axis)?.angle;
        let counts = factors[usize::from(!is_silhouette)] > 0.0 && angle < cone.max_angle;
        counts.then(|| (number, (b - a).length() / (a.dot(a) + b.dot(b))))
    });
    counting.collect()
}

/// Edges are met as often as their probabilities say, and over these they sum up to what brute
/// force finds: none that counts is left out.
#[test]
fn frequencies_are_probabilities() {
    let accel = accel();
    let boundaries = Boundaries::new(&accel);
    adapter::each(|gpu| {
        let mut random = Random(42);
        let mut found = 0;
        for selection in [EdgeSelection::Silhouettes, EdgeSelection::All] {
            let sampler = boundaries.edge_sampler(&accel, selection);
            let device = DeviceEdgeSampler::new(gpu, &sampler.buffers()).expect("enough memory");
            for cone in cones(&mut random) {
                let some = repeated(&cone, &mut random, SAMPLES);
                let samples = device.sample(&some).expect("answers");
                // How often each edge is met, and its probability.
                let mut met: BTreeMap<u32, (f64, f64)> = BTreeMap::new();
                for DrawnEdge { edge, probability } in samples.into_iter().flatten() {
                    let entry = met.entry(edge).or_insert((0.0, probability));
                    assert!(probability > 0.0 && (entry.1 / probability - 1.0).abs() < 1e-3);
                    entry.0 += 1.0;
                }
                let n = SAMPLES as f64;
                let (mut chi_squared, mut degrees) = (0.0, 0.0);
                for (edge, &(count, p)) in &met {
                    let error = (n * p * (1.0 - p)).sqrt();
                    // Poisson where few are expected.
                    let off = (count - n * p).abs() / error.max(1.0);
                    assert!(off < ERRORS, "edge {edge}: {count} of {n}, not {p}");
                    if n * p > 10.0 {
                        chi_squared += (count - n * p).powi(2) / (n * p);
                        degrees += 1.0;
                    }
                }
                // The statistic has a mean of its degrees, and twice that as variance.
                let limit = degrees + ERRORS * (2.0_f64 * degrees).sqrt() + 10.0;
                assert!(chi_squared < limit, "{chi_squared} of {degrees}");
                // What all edges that count sum up to, and an estimate of it.
                let expected = counting(&boundaries, &accel, &sampler.buffers(), &cone);
                let size = |edge: u32| expected.get(&edge).copied().unwrap_or(0.0);
                let terms = met
                    .iter()
                    .map(|(&edge, &(count, p))| (count, size(edge) / p));
                let mean = terms.clone().map(|(count, term)| count * term).sum::<f64>() / n;
                let square = terms.map(|(count, term)| count * term * term).sum::<f64>() / n;
                let error = ((square - mean * mean) / n).sqrt();
                let sum: f64 = expected.values().sum();
                println!(
                    "{sum:.4}, {mean:.4} +- {error:.4}, {} of {}",
                    met.len(),
                    expected.len()
                );
                assert!(
                    (mean - sum).abs() < ERRORS * error + 1e-9 * sum,
                    "{mean}, not {sum}"
                );
                if gpu.precision() == Precision::Double {
                    assert!(met.keys().all(|edge| expected.contains_key(edge)));
                }
                found += met.len();
            }
        }
        assert!(found > 500, "{found} edges prove little");
    });
}
