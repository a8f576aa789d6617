//! The walk of random length (Eqs. 12 to 17) against harmonic functions in
//! closed form, on polygons, disks and the sphere.

use capwalk_geometry::{Mesh, SilhouettePoint, SilhouetteTree, topology};
use capwalk_math::{Moments, Vec2, Vec3, sphere};
use capwalk_paper::walk::plane::{CurvePoint, Plane};
use capwalk_paper::walk::random_step::{ShellSettings, sample_harmonic};
use capwalk_walk::{Domain, Estimator, Sphere, WalkSettings, sample_value};

#[path = "../../../crates/walk/tests/common/mod.rs"]
mod common;
use common::{assert_mean, number};

/// Value and gradient.
type Function = fn(Vec2) -> (f64, Vec2);

/// Harmonic functions and their gradients.
fn functions() -> [(&'static str, Function); 3] {
    [
        ("Re z³", |p| {
            let Vec2 { x, y } = p;
            let gradient = Vec2::new(3.0 * (x * x - y * y), -6.0 * x * y);
            (x * x * x - 3.0 * x * y * y, gradient)
        }),
        ("eˣ cos y", |p| {
            let e = p.x.exp();
            (e * p.y.cos(), Vec2::new(e * p.y.cos(), -e * p.y.sin()))
        }),
        ("log |z - c|", |p| {
            let r = p - Vec2::new(1.5, 1.3);
            (r.length().ln(), r * r.dot(r).recip())
        }),
    ]
}

fn ell() -> Plane {
    let corners = [
        [-1.0, -1.0],
        [1.0, -1.0],
        [1.0, 0.0],
        [0.0, 0.0],
        [0.0, 1.0],
        [-1.0, 1.0],
    ];
    Plane::polygon(&corners.map(|[x, y]| Vec2::new(x, y)))
}

#[test]
fn harmonic_functions_are_found_from_their_boundary() {
    let domains = [
        ("L", ell()),
        ("disk", Plane::circle(Vec2::new(0.0, 0.1), 1.1)),
    ];
    // Inside both; one close to the boundary of the L.
    let points = [[-0.5, -0.5], [0.6, -0.3], [-0.1, 0.2], [-0.04, 0.6]];
    for (name, domain) in &domains {
        for [x, y] in points {
            for estimator in [Estimator::Literal, Estimator::Anchored] {
                let settings = ShellSettings {
                    estimator,
                    ..Default::default()
                };
                let mut sums = [[Moments::default(); 3]; 3];
                for i in 0..30_000 {
                    let at = Vec2::new(x, y);
                    let walk = sample_harmonic(domain, at, &settings, |d| number(1, i, d));
                    let sample = walk.expect("it arrives").sample;
                    for ((_, exact), sums) in functions().iter().zip(&mut sums) {
                        let (value, gradient) = sample.scalar(|site| exact(site.point).0);
                        for (sum, x) in sums.iter_mut().zip([value, gradient.x, gradient.y]) {
                            sum.add(x);
                        }
                    }
                }
                for ((function, exact), [value, dx, dy]) in functions().iter().zip(&sums) {
                    let (v, gradient) = exact(Vec2::new(x, y));
                    let what = format!("{function} on {name} at {x}, {y}, {estimator:?}");
                    // The shell of 1e-4, times gradients of up to 5; for the
                    // gradient over the distance, at least 0.04.
                    assert_mean(value, v, 5e-4, &what);
                    assert_mean(dx, gradient.x, 1e-2, &what);
                    assert_mean(dy, gradient.y, 1e-2, &what);
                }
            }
        }
    }
}

/// A thinner shell takes more steps, as its logarithm, and less bias.
#[test]
fn steps_grow_like_the_logarithm_of_the_shell() {
    let domain = ell();
    let steps = [1e-2, 1e-4, 1e-6].map(|shell| {
        let settings = ShellSettings {
            shell,
            ..Default::default()
        };
        let mut steps = Moments::default();
        for i in 0..4000 {
            let at = Vec2::new(-0.5, -0.5);
            let walk = sample_harmonic(&domain, at, &settings, |d| number(2, i, d));
            steps.add(f64::from(walk.expect("it arrives").steps));
        }
        steps.mean
    });
    let [first, second] = [steps[1] - steps[0], steps[2] - steps[1]];
    assert!(first > 3.0, "{steps:?}");
    // Steps as long as possible arrive soon.
    assert!(steps[0] < 7.0, "{steps:?}");
    assert!((second / first - 1.0).abs() < 0.25, "{steps:?}");
}

/// Near the boundary the printed gradient's noise grows like the inverse
/// distance, the anchored one's like its root: some walks end far away.
#[test]
fn anchored_gradients_are_quieter_at_the_boundary() {
    let domain = ell();
    let exact = functions()[1].1;
    let spread = |estimator: Estimator, distance: f64| {
        let settings = ShellSettings {
            estimator,
            ..Default::default()
        };
        let mut moments = Moments::default();
        for i in 0..4000 {
            let at = Vec2::new(-1.0 + distance, -0.4);
            let walk = sample_harmonic(&domain, at, &settings, |d| number(6, i, d));
            let sample = walk.expect("it arrives").sample;
            moments.add(sample.scalar(|site| exact(site.point).0).1.x);
        }
        moments.variance().sqrt()
    };
    let [far, near] = [0.1, 0.01].map(|distance| {
        let [literal, anchored] = [Estimator::Literal, Estimator::Anchored];
        [spread(literal, distance), spread(anchored, distance)]
    });
    assert!(near[0] > 8.0 * far[0], "{far:?}, {near:?}");
    assert!(near[1] < 5.0 * far[1], "{far:?}, {near:?}");
    assert!(near[1] < 0.3 * near[0], "{near:?}");
}

/// A walk that is given up says so.
#[test]
fn endless_walks_are_given_up() {
    let settings = ShellSettings {
        shell: 1e-12,
        max_steps: 5,
        ..Default::default()
    };
    let at = Vec2::new(-0.5, -0.5);
    let lost =
        (0..100).filter(|&i| sample_harmonic(&ell(), at, &settings, |d| number(3, i, d)).is_none());
    assert!(lost.count() > 90);
    let nothing = Plane { curves: Vec::new() };
    assert!(sample_harmonic(&nothing, at, &settings, |_| 0.5).is_none());
}

/// With many steps the fixed-step field becomes the harmonic one (Section 5.1).
#[test]
fn many_fixed_steps_are_harmonic() {
    let domain = ell();
    let exact = functions()[0].1;
    let value = |site: &CurvePoint| exact(site.point).0;
    let x = Vec2::new(-0.5, 0.1);
    let error = |steps: u32| {
        let walk = WalkSettings {
            steps,
            max_radius: f64::INFINITY,
            ..Default::default()
        };
        let mut moments = Moments::default();
        for i in 0..100_000 {
            let site = sample_value(&domain, x, &walk, |d| number(4, i, d));
            moments.add(value(&site.expect("there is a boundary")));
        }
        (moments.mean - exact(x).0, moments.standard_error())
    };
    let (bias, noise) = error(1);
    assert!(
        bias.abs() > 10.0 * noise,
        "one step is not harmonic: {bias} ± {noise}"
    );
    let (bias, noise) = error(40);
    assert!(bias.abs() < 4.0 * noise, "40 steps: {bias} ± {noise}");
}

/// Around the stereographic image: `Re w²` is harmonic on the sphere, too.
#[test]
fn harmonic_functions_on_the_sphere() {
    let corners = [[-0.9, -0.5, 1.0], [1.0, -0.4, 1.2], [0.1, 0.9, 0.9]];
    let mesh = Mesh {
        positions: corners.map(|[x, y, z]| Vec3::new(x, y, z)).to_vec(),
        faces: vec![[0, 1, 2]],
    };
    let tree = SilhouetteTree::build(&mesh, &topology::edges(&mesh));
    let domain = Sphere::of_silhouettes(&tree, Vec3::zero());
    let exact = |q: Vec3| {
        let (x, y) = (q.x / (1.0 + q.z), q.y / (1.0 + q.z));
        x * x - y * y + x
    };
    let settings = ShellSettings {
        estimator: Estimator::Anchored,
        ..Default::default()
    };
    for q in [[0.05, 0.1, 1.0], [0.3, -0.2, 1.0]] {
        let q = Vec3::new(q[0], q[1], q[2]).normalized();
        let d = domain.tangent(q, 0.2);
        let [mut value, mut derivative] = [Moments::default(); 2];
        for i in 0..30_000 {
            let walk = sample_harmonic(&domain, q, &settings, |k| number(5, i, k));
            let found = walk.expect("it arrives").sample;
            let (v, dv) = found.scalar(|site: &SilhouettePoint| exact(site.direction));
            value.add(v);
            derivative.add(dv.dot(d));
        }
        let h = 1e-5;
        let ahead = exact(sphere::walk_along(q, d, h));
        let behind = exact(sphere::walk_along(q, d, -h));
        assert_mean(&value, exact(q), 2e-4, "value");
        assert_mean(
            &derivative,
            (ahead - behind) / (2.0 * h),
            2e-3,
            "derivative",
        );
    }
}
