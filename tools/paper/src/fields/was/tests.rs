use super::*;

const KAPPA: f64 = 2e3;

/// Numbers between 0 and 1 that look random.
fn number(i: usize) -> f64 {
    (i as f64 * 0.618_033_988_749_894_9 + 0.3).fract()
}

fn rays(q: Vec3, count: usize) -> Vec<Auxiliary> {
    let frame = Frame::from_normal(q);
    let ray = |i: usize| {
        let (local, inverse_density) = sample_direction(KAPPA, [number(3 * i), number(7 * i)]);
        Auxiliary {
            direction: frame.to_world(local),
            inverse_density,
            boundary: number(11 * i),
            hit: None,
        }
    };
    (0..count).map(ray).collect()
}

/// Adds `factor` times the ratio estimate.
fn add_ratio(rays: &[Auxiliary], q: Vec3, kappa: f64, factor: f64, shares: &mut [Share]) {
    let weights: Vec<_> = rays.iter().map(|ray| weight(ray, q, kappa)).collect();
    weighted_mean::add_ratio(&weights, curvature(q), factor, shares);
}

/// What is drawn in a cap, over its density, is the area of the cap.
#[test]
fn directions_have_their_density() {
    let count = 100_000;
    let drawn: Vec<_> = (0..count)
        .map(|i| sample_direction(KAPPA, [0.3, (f64::from(i) + 0.5) / f64::from(count)]))
        .collect();
    let area_up_to = |height: f64| {
        let inside = drawn.iter().filter(|(z, _)| 1.0 - z.z < height);
        inside.map(|(_, inverse)| inverse).sum::<f64>() / height
    };
    let wide = area_up_to(3.0 / KAPPA);
    for height in [0.1, 0.5, 2.0] {
        let error = area_up_to(height / KAPPA) / wide - 1.0;
        assert!(error.abs() < 1e-3, "{height}: {error}");
    }
}

/// With rays and densities held fixed, the divergence is that of the mean.
#[test]
fn divergence_is_that_of_the_mean() {
    let q = Vec3::new(0.48, -0.6, 0.64);
    let rays = rays(q, 9);
    let velocity = |i: usize| {
        let v = Vec3::new(number(i) - 0.5, number(i + 50), number(i + 90) - 0.2);
        v.reject_from(rays[i].direction)
    };
    let shares_at = |q: Vec3| {
        let mut shares = vec![Share::none(); rays.len()];
        add_ratio(&rays, q, KAPPA, 1.0, &mut shares);
        shares
    };
    let field = |q: Vec3| {
        let shares = shares_at(q).into_iter().enumerate();
        let mean = shares.fold(Vec3::zero(), |sum, (i, share)| {
            sum + velocity(i) * share.weight
        });
        mean.reject_from(q)
    };
    let step = 1e-6;
    let frame = Frame::from_normal(q);
    let gradient = |d: Vec3| {
        let at = |side: f64| field((q + d * (side * step)).normalized());
        d.dot(at(1.0) - at(-1.0)) / (2.0 * step)
    };
    let expected = gradient(frame.s) + gradient(frame.t);
    let shares = shares_at(q).into_iter().enumerate();
    let divergence: f64 = shares
        .map(|(i, share)| share.divergence.dot(velocity(i)))
        .sum();
    assert!(expected.abs() > 1.0);
    let error = divergence / expected - 1.0;
    assert!(error.abs() < 1e-6, "{divergence} against {expected}");
}

/// A thing that fills the view warps every direction, a factor scales
/// all of it.
#[test]
fn shares_add_up() {
    let q = Vec3::new(0.0, 0.6, 0.8);
    let rays = rays(q, 8);
    let mut shares = vec![Share::none(); rays.len()];
    add_ratio(&rays, q, KAPPA, 1.0, &mut shares);
    add_ratio(&rays, q, KAPPA, 0.5, &mut shares);
    let sum: f64 = shares.iter().map(|share| share.weight).sum();
    assert!((sum - 1.5).abs() < 1e-12);
    // A constant velocity V has the divergence of its tangent part, -2 q·V.
    let covector = shares
        .iter()
        .fold(Vec3::zero(), |sum, share| sum + share.divergence);
    assert!((covector + q * 3.0).length() < 1e-8, "{covector:?}");
}
