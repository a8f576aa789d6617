//! The fields against closed forms: the boundary term of a smooth window is
//! known by quadrature, and must equal the area integral of the
//! window over the field (the divergence theorem, Eq. 3).

use capwalk_geometry::{Edge, Mesh, SilhouettePoint, SilhouetteTree, topology};
use capwalk_math::{Frame, Moments, Vec3, sphere};
use capwalk_walk::{Estimator, Sphere, WalkSettings, sample_field, sample_value};

mod common;
use common::{assert_mean, number, random};

/// One triangle over a shading point, its corners moving differently.
struct Moving {
    mesh: Mesh,
    edges: Vec<Edge>,
    tree: SilhouetteTree,
    velocities: [Vec3; 3],
    viewpoint: Vec3,
    viewpoint_velocity: Vec3,
}

impl Moving {
    fn example() -> Self {
        let mesh = Mesh {
            positions: vec![
                Vec3::new(-0.4, -0.2, 1.0),
                Vec3::new(0.5, -0.1, 1.2),
                Vec3::new(0.0, 0.5, 0.9),
            ],
            faces: vec![[0, 1, 2]],
        };
        let edges = topology::edges(&mesh);
        Self {
            tree: SilhouetteTree::build(&mesh, &edges),
            mesh,
            edges,
            velocities: [
                Vec3::new(1.0, 0.0, 0.2),
                Vec3::new(0.3, -0.8, 0.0),
                Vec3::new(-0.2, 0.5, 1.0),
            ],
            viewpoint: Vec3::new(0.05, 0.02, -0.1),
            viewpoint_velocity: Vec3::new(0.2, -0.1, 0.3),
        }
    }

    fn domain(&self) -> Sphere<'_> {
        Sphere::of_silhouettes(&self.tree, self.viewpoint)
    }

    /// Angular velocity of the direction to a point, METHOD 2.
    fn angular(&self, x: Vec3, velocity: Vec3) -> Vec3 {
        let offset = x - self.viewpoint;
        let q = offset.normalized();
        (velocity - self.viewpoint_velocity).reject_from(q) / offset.length()
    }

    fn velocity(&self, site: &SilhouettePoint) -> Vec3 {
        let [i, k] = self.edges[site.edge as usize].vertices.map(|v| v as usize);
        let v = self.velocities[i] * (1.0 - site.t) + self.velocities[k] * site.t;
        self.angular(self.viewpoint + site.direction * site.distance, v)
    }

    fn hides(&self, d: Vec3) -> bool {
        let [p, q, r] = self.mesh.corners(0).map(|p| p - self.viewpoint);
        let sides = [d.dot(p.cross(q)), d.dot(q.cross(r)), d.dot(r.cross(p))];
        sides.iter().all(|&s| s > 0.0) || sides.iter().all(|&s| s < 0.0)
    }

    /// `-∮ w u·n dl` over the boundary: derivative of the window's integral
    /// over the directions that miss the triangle.
    fn exact(&self, window: impl Fn(Vec3) -> f64) -> f64 {
        let p = &self.mesh.positions;
        let centre = (p[0] + p[1] + p[2]) / 3.0 - self.viewpoint;
        let n = 20_000;
        let mut sum = 0.0;
        for i in 0..3 {
            let next_corner = (i + 1) % 3;
            let (a, b) = (p[i] - self.viewpoint, p[next_corner] - self.viewpoint);
            let normal = a.cross(b).normalized();
            let outward = normal * -normal.dot(centre).signum();
            let at = |k: f64| a + (b - a) * (k / f64::from(n));
            for k in 0..n {
                let k = f64::from(k);
                let t = (k + 0.5) / f64::from(n);
                let middle = at(k + 0.5);
                let v = self.velocities[i] * (1.0 - t) + self.velocities[next_corner] * t;
                let u = self.angular(middle + self.viewpoint, v);
                let length = sphere::angle_between(at(k).normalized(), at(k + 1.0).normalized());
                sum -= window(middle.normalized()) * u.dot(outward) * length;
            }
        }
        sum
    }
}

#[test]
fn field_has_the_boundary_term() {
    let scene = Moving::example();
    let domain = scene.domain();
    // A smooth window, zero with its gradient at the rim of a cap around +z.
    let cap: f64 = 1.1;
    let depth = |q: Vec3| (q.z - cap.cos()).max(0.0);
    let window = |q: Vec3| depth(q).powi(2) * (1.0 + q.x);
    let gradient = |q: Vec3| Vec3::new(depth(q).powi(2), 0.0, 2.0 * depth(q) * (1.0 + q.x));
    let exact = scene.exact(window);
    for (steps, max_radius, antithetic, n) in [
        (1, 0.6, false, 600_000),
        (1, 0.1, true, 600_000),
        (1, 3.2, false, 300_000),
        (2, 0.6, false, 300_000),
        (3, 0.3, true, 300_000),
    ] {
        let settings = WalkSettings {
            steps,
            max_radius,
            estimator: Estimator::Anchored,
            antithetic,
        };
        let mut moments = Moments::default();
        for i in 0..n {
            let number = |d: u32| random(100 * i + u64::from(d));
            let q = sphere::sample_cap(cap, [number(98), number(99)]);
            if scene.hides(q) {
                moments.add(0.0);
                continue;
            }
            let field = sample_field(&domain, q, &settings, number);
            let (mean, divergence) = field.evaluate(|site| scene.velocity(site));
            let integrand = gradient(q).dot(mean.reject_from(q)) + window(q) * divergence;
            moments.add(integrand / sphere::cap_pdf(cap));
        }
        let error = moments.standard_error();
        let z = (moments.mean - exact) / error;
        // Five cases, two-sided: 4 σ fails one run in 3000.
        assert!(
            z.abs() < 4.0,
            "M = {steps}, A_max = {max_radius}: {} ± {error}, exact {exact}",
            moments.mean,
        );
        assert!(
            error < 0.1 * exact.abs(),
            "too noisy to tell: {error} of {exact}"
        );
    }
}

/// The value alone is the same field as the value with the divergence.
#[test]
fn value_agrees_with_field() {
    let scene = Moving::example();
    let domain = scene.domain();
    for steps in 1..=3 {
        let settings = WalkSettings {
            steps,
            ..Default::default()
        };
        for i in 0..500 {
            let number = |d: u32| random(100 * i + u64::from(d));
            let q = sphere::sample_cap(1.0, [number(98), number(99)]);
            let field = sample_field(&domain, q, &settings, number);
            let value: Vec<_> = field.terms().filter(|term| term.weight != 0.0).collect();
            match sample_value(&domain, q, &settings, number) {
                None => assert!(value.is_empty()),
                Some(site) => {
                    assert_eq!(value.len(), 1);
                    assert!((value[0].site.t - site.t).abs() < 1e-9);
                    assert_eq!(value[0].site.edge, site.edge);
                }
            }
        }
    }
}

/// At a fixed direction both estimators have finite variance and the same
/// mean; only over all directions does the literal one's variance diverge.
#[test]
fn literal_and_anchored_agree_at_fixed_directions() {
    let scene = Moving::example();
    let domain = scene.domain();
    for (k, steps) in [1, 1, 1, 2, 3].into_iter().enumerate() {
        let q = sphere::sample_cap(0.8, [random(7 + k as u64), random(70 + k as u64)]);
        let estimate = |estimator: Estimator, antithetic: bool| {
            let settings = WalkSettings {
                steps,
                max_radius: 0.6,
                estimator,
                antithetic,
            };
            let mut moments = Moments::default();
            for i in 0..100_000 {
                let number = |d: u32| random(1_000_000 + 100 * i + u64::from(d));
                let field = sample_field(&domain, q, &settings, number);
                moments.add(field.evaluate(|site| scene.velocity(site)).1);
            }
            moments
        };
        let anchored = estimate(Estimator::Anchored, false);
        let others = [
            estimate(Estimator::Literal, false),
            estimate(Estimator::Anchored, true),
        ];
        for other in others {
            let error = anchored.standard_error().hypot(other.standard_error());
            let z = (anchored.mean - other.mean) / error;
            // Ten cases: 4 σ fails one run in 1500.
            assert!(
                z.abs() < 4.0 && error < 0.2,
                "M = {steps} at {q:?}: {} against {} ± {error}",
                anchored.mean,
                other.mean
            );
        }
    }
}

/// The directional derivative is that of the mean value, both by quadrature
/// over the numbers of one step; also where the radius limit cuts the caps.
#[test]
fn directional_derivative_is_that_of_the_mean() {
    let scene = Moving::example();
    let domain = scene.domain();
    let settings = WalkSettings {
        max_radius: 0.5,
        ..Default::default()
    };
    let n = 300;
    let quadrature = |f: &dyn Fn([f64; 2]) -> Vec3| {
        let mut sum = Vec3::zero();
        for i in 0..n * n {
            let u = [i / n, i % n].map(|k| (f64::from(k) + 0.5) / f64::from(n));
            sum += f(u) / f64::from(n * n);
        }
        sum
    };
    let velocity = |site: &SilhouettePoint| scene.velocity(site);
    let mean = |q: Vec3| {
        quadrature(&|u| {
            let site = sample_value(&domain, q, &settings, |i| u[i as usize]);
            site.map_or(Vec3::zero(), |site| velocity(&site))
        })
    };
    for k in 0..4 {
        let q = sphere::sample_cap(0.9, [random(3 + k), random(30 + k)]);
        let d = sphere::sample_tangent(&Frame::from_normal(q), random(300 + k));
        let h = 0.01;
        let ahead = mean(sphere::walk_along(q, d, h));
        let behind = mean(sphere::walk_along(q, d, -h));
        let expected = (ahead - behind) / (2.0 * h);
        let found = quadrature(&|u| {
            let field = sample_field(&domain, q, &settings, |i| u[i as usize]);
            field.directional_derivative(d, velocity)
        });
        // The quadrature meets discontinuities: it is good to a few parts in a hundred.
        let error = (found - expected).length();
        assert!(error < 0.05, "at {q:?}: {found:?} against {expected:?}");
        assert!(expected.length() > 0.2, "nothing to see at {q:?}");
    }
}

/// The mean of the derivative along a great circle is the difference of the
/// field at its ends, for every number of steps (figure 8, bottom row).
#[test]
fn derivatives_are_differences_of_the_field() {
    let scene = Moving::example();
    let domain = scene.domain();
    let a = Vec3::new(0.02, -0.03, 1.0).normalized();
    // Away from the closest edge, whose velocity has a large part along `onto`.
    let e = sphere::tangent_towards(a, Vec3::new(-0.05, 0.15, 1.0).normalized());
    let (angle, onto) = (0.1, Vec3::new(1.0, 0.2, -0.1));
    let velocity = |site: &SilhouettePoint| scene.velocity(site);
    for (steps, max_radius, estimator) in [
        (1, 3.2, Estimator::Anchored),
        (1, 0.25, Estimator::Literal),
        (2, 3.2, Estimator::Anchored),
        (3, 3.2, Estimator::Anchored),
    ] {
        let settings = WalkSettings {
            steps,
            max_radius,
            estimator,
            antithetic: false,
        };
        let mut derivative = Moments::default();
        for i in 0..100_000 {
            let random = |d| number(7, i, d);
            let at = angle * random(99);
            let q = sphere::walk_along(a, e, at);
            // The direction of travel at q, of length `angle`.
            let along = (e * at.cos() - a * at.sin()) * angle;
            let field = sample_field(&domain, q, &settings, random);
            derivative.add(field.directional_derivative(along, velocity).dot(onto));
        }
        let end = |q: Vec3, set: u64| {
            let mut moments = Moments::default();
            for i in 0..100_000 {
                let site = sample_value(&domain, q, &settings, |d| number(set, i, d));
                moments.add(site.map_or(0.0, |site| velocity(&site).dot(onto)));
            }
            moments
        };
        let (ahead, behind) = (end(sphere::walk_along(a, e, angle), 8), end(a, 9));
        let error = ahead.standard_error().hypot(behind.standard_error());
        let expected = ahead.mean - behind.mean;
        let what = format!("M = {steps}, A ≤ {max_radius}, {estimator:?}");
        assert_mean(&derivative, expected, 4.0 * error, &what);
        let noise = derivative.standard_error().hypot(error);
        assert!(
            expected.abs() > 15.0 * noise,
            "{what}: {expected} ± {noise}"
        );
    }
}
