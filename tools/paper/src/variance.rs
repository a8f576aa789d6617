//! Beyond the paper: the variance of the printed estimator and of the anchored
//! one by the distance to the boundary (METHOD 2), in the plane, on the sphere and
//! on a triangle that is met.

use capwalk_diff::Method;
use capwalk_geometry::{Mesh, SilhouettePoint, SilhouetteTree, topology};
use capwalk_math::{Moments, Vec2, Vec3, sphere};
use capwalk_walk::{Domain, Estimator, Sphere, WalkSettings, sample_field};
use rayon::prelude::*;

use crate::claim::{Claim, Measured, Verdict};
use crate::fields::ON_TRIANGLES;
use crate::figure::{Curve, Figure, Plot, Row, Scale, Table};
use crate::gradients::Subject;
use crate::random::random;
use crate::settings::{Failure, Settings};
use crate::walk::plane::{CurvePoint, Plane};
use crate::walk::triangle::{Triangle, TriangleBoundary};

/// Variances of the divergence at a point, one for each of the replicates.
fn variances<D: Domain>(
    domain: &D,
    x: D::Vector,
    velocity: impl Fn(&D::Site) -> D::Vector,
    estimator: Estimator,
    settings: &Settings,
) -> Vec<f64> {
    let samples = settings.quality.choose(50, 4_000, 40_000);
    let walk = WalkSettings {
        max_radius: 1.0,
        estimator,
        ..WalkSettings::default()
    };
    let replicate = |k: u64| {
        let mut moments = Moments::default();
        for i in 0..samples {
            let number = |d: u32| random([settings.seed, k, i, u64::from(d)]);
            moments.add(sample_field(domain, x, &walk, number).evaluate(&velocity).1);
        }
        moments.variance()
    };
    (0..REPLICATES).map(replicate).collect()
}

const REPLICATES: u64 = 8;

/// How far an exponent may be from what is claimed: over the distances that are
/// measured, the variance then changes by less than a factor of 1.5.
const TOLERANCE: f64 = 0.05;

/// Height of the triangle that is met; what hides it is at height 1.
const BEHIND: f64 = 2.0;

/// Distances to the boundary, from near to far.
fn distances(settings: &Settings) -> Vec<f64> {
    let count = settings.quality.choose(4, 17, 33);
    let exponent = |i: usize| -4.0 + 3.2 * i as f64 / (count - 1) as f64;
    (0..count).map(|i| 10_f64.powf(exponent(i))).collect()
}

/// The curve of the variance, and its exponent between the nearest and the
/// farthest distance on logarithmic axes.
struct Found {
    curve: Curve,
    exponent: Measured,
}

fn measure(
    name: &str,
    settings: &Settings,
    variances_at: impl Fn(f64) -> Vec<f64> + Sync,
) -> Found {
    let distances = distances(settings);
    let all: Vec<Vec<f64>> = distances.par_iter().map(|&d| variances_at(d)).collect();
    let mean = |values: &[f64]| {
        let mut moments = Moments::default();
        values.iter().for_each(|&x| moments.add(x));
        moments
    };
    let points = distances.iter().zip(&all).map(|(&d, values)| {
        let moments = mean(values);
        [d, moments.mean, moments.standard_error()]
    });
    // The nearer half: far away the boundary's other parts come in.
    let near = distances.len() / 2;
    let mut exponents = Moments::default();
    for (nearer, nearest) in all[near].iter().zip(&all[0]) {
        let rise = (nearer / nearest).ln();
        exponents.add(rise / (distances[near] / distances[0]).ln());
    }
    Found {
        curve: Curve {
            name: name.into(),
            points: points.collect(),
        },
        exponent: exponents.into(),
    }
}

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    let watch = (settings.stages)("variance");
    let flat = Plane::polygon(
        &[[-1.0, -0.8], [1.0, -1.0], [0.9, 0.8], [-0.8, 0.9]].map(|[x, y]| Vec2::new(x, y)),
    );
    let in_plane = |estimator: Estimator| {
        let name = name(estimator);
        measure(name, settings, |distance| {
            // Straight in from the middle of the lowest side.
            let x = Vec2::new(0.0, -0.9) + Vec2::new(0.1, 1.0).normalized() * distance;
            let velocity = |site: &CurvePoint| {
                let Vec2 { x, y } = site.point;
                Vec2::new(1.0 + (2.0 * x).sin(), 0.5 + x * y)
            };
            variances(&flat, x, velocity, estimator, settings)
        })
    };
    let mesh = Mesh {
        positions: [[-0.6, -0.5, 1.0], [0.7, -0.4, 1.0], [0.05, 0.7, 1.0]]
            .map(|[x, y, z]| Vec3::new(x, y, z))
            .to_vec(),
        faces: vec![[0, 1, 2]],
    };
    let tree = SilhouetteTree::build(&mesh, &topology::edges(&mesh));
    // The middle of a side, seen from the origin.
    let foot = (mesh.positions[0] + mesh.positions[1]).normalized();
    let inward = mesh.positions[0].cross(mesh.positions[1]).normalized();
    // The mesh turns and shrinks.
    let turning = |q: Vec3| (Vec3::new(0.3, 1.0, 0.2).cross(q) + q * q.x).reject_from(q);
    let on_sphere = |estimator: Estimator| {
        let name = name(estimator);
        measure(name, settings, |distance| {
            let domain = Sphere::of_silhouettes(&tree, Vec3::zero());
            let q = sphere::walk_along(foot, inward, distance);
            let velocity = |site: &SilhouettePoint| turning(site.direction);
            variances(&domain, q, velocity, estimator, settings)
        })
    };
    let on_triangle = |estimator: Estimator| {
        let name = name(estimator);
        measure(name, settings, |distance| {
            // Beside the silhouette a larger triangle is hit, which does not move.
            let domain = Triangle {
                sphere: Sphere::of_silhouettes(&tree, Vec3::zero()),
                corners: [[-9.0, -8.0], [9.0, -8.0], [0.0, 9.0]]
                    .map(|[x, y]| Vec3::new(x, y, BEHIND)),
            };
            let q = sphere::walk_along(foot, -inward, distance);
            let velocity = |site: &TriangleBoundary| match site {
                TriangleBoundary::Border => Vec3::zero(),
                TriangleBoundary::Silhouette(point) => {
                    // On the triangle's plane, Eq. (28), and as it is seen around
                    // the direction in which its divergence is asked for, Eq. (37).
                    let seen = point.direction;
                    let turned = turning(seen) * (BEHIND / seen.z);
                    let on_plane = turned - seen * (turned.z / seen.z);
                    (on_plane * (q.z / BEHIND)).reject_from(q)
                }
            };
            variances(&domain, q, velocity, estimator, settings)
        })
    };
    let estimators = [Estimator::Literal, Estimator::Anchored];
    let mut plots = Vec::new();
    let mut claims = Vec::new();
    for (domain, found) in [
        ("In the plane", estimators.map(in_plane)),
        ("On the sphere", estimators.map(on_sphere)),
        ("On the triangle that is met", estimators.map(on_triangle)),
    ] {
        if watch.should_stop() {
            return Err(Failure::Stopped);
        }
        let [literal, anchored] = &found;
        claims.push(Claim {
            statement: format!(
                "{domain}: the variance of the printed estimator grows like 1/A² towards \
                 the boundary, so that over all points it is infinite"
            ),
            paper: "not mentioned".into(),
            ours: format!("variance ∝ A^({})", literal.exponent),
            verdict: between(literal.exponent, -2.0 - TOLERANCE, -2.0 + TOLERANCE),
        });
        claims.push(Claim {
            statement: format!("{domain}: that of the anchored estimator stays bounded"),
            paper: "not ours to compare".into(),
            ours: format!("variance ∝ A^({})", anchored.exponent),
            // A variance that falls towards the boundary is bounded, too.
            verdict: between(anchored.exponent, -TOLERANCE, f64::INFINITY),
        });
        plots.push(Plot {
            title: format!("Variance: {domain}"),
            axes: [
                "distance A to the boundary".into(),
                "variance of the divergence".into(),
            ],
            scale: Scale::Logarithmic,
            curves: found.map(|found| found.curve).into(),
        });
    }
    Ok(Figure {
        caption: "Variance of a single sample of the field's divergence (M = 1) at points closer \
                  and closer to a moving boundary, by the estimator as printed (Eqs. 27 and 34, \
                  independent samples) and anchored at the closest boundary point (the same mean, \
                  docs/method.md 2). In the plane, on the sphere of directions, and on a triangle \
                  beside the silhouette of another (Eqs. 37 and 38)."
            .into(),
        rows: vec![Row::Plots(plots)],
        tables: vec![in_images(settings)?],
        claims,
        ..Figure::default()
    })
}

/// The variance of a sample of a derivative image, by domain of the field and
/// estimator: that of the printed estimator is infinite, and what is measured
/// grows with the number of samples.
fn in_images(settings: &Settings) -> Result<Table, Failure> {
    let size = settings.quality.choose([8, 6], [32, 24], [64, 48]);
    let spp = settings.quality.choose(8, 128, 1024);
    let subject = Subject::builtin("leaf", size, 1e-3)?;
    let mut rows = Vec::new();
    for (domain, method) in [
        ("all directions", Method::Walk),
        ("the triangle that is met", ON_TRIANGLES),
    ] {
        for estimator in [Estimator::Literal, Estimator::Anchored] {
            let walk = WalkSettings {
                estimator,
                ..WalkSettings::default()
            };
            let run = subject.gradient(method, walk, spp, 1, settings)?;
            rows.push(vec![
                domain.into(),
                name(estimator).into(),
                spp.to_string(),
                run.variance().to_string(),
            ]);
        }
    }
    Ok(Table {
        title: "Shadow of one triangle".into(),
        columns: vec![
            "domain of the field",
            "estimator",
            "samples per pixel",
            "mean variance of a sample",
        ],
        rows,
    })
}

fn name(estimator: Estimator) -> &'static str {
    match estimator {
        Estimator::Literal => "as printed",
        Estimator::Anchored => "anchored",
    }
}

/// That a number lies between two others.
fn between(number: Measured, low: f64, high: f64) -> Verdict {
    let [least, most] = [-3.0, 3.0].map(|z| number.value + z * number.error);
    if least > low && most < high {
        Verdict::Holds
    } else if most < low || least > high {
        Verdict::DoesNotHold(format!("the exponent is {number}"))
    } else {
        Verdict::Inconclusive(format!("the exponent is {number}"))
    }
}
