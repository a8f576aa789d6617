//! The fixed-step walk: Algorithms 2 to 4 in flat domains, 6 and 7 on the
//! sphere, which are one algorithm.
//!
//! The field of no steps is the velocity of the closest boundary point,
//! Eqs. (18) and (31). The field of `M` steps is the mean of the field of
//! `M - 1` steps over the largest empty ball around the point, Eqs. (20) and
//! (32), whose radius is `A`. Its derivative along a tangent `d` is, for any
//! constant vector `c`,
//!
//! ```text
//! ∂_d v = κ { E_rim[ (v(z) - c) (d·(e(z) + g)) ] - (d·g) (v̄ - c) }
//! ```
//!
//! with `κ = |rim|/|ball|`, `e(z)` the unit tangent towards the rim point `z`,
//! and `g = ∇A`, where `A` is a distance pointing away from the closest boundary point (Eqs. 27
//! and 34 after working out the rim's motion). Summed over an orthonormal basis of
//! tangents this is the divergence, Eq. (21), up to the domain's curvature:
//!
//! ```text
//! div v = κ { E_rim[ v(z)·(e(z) + g) ] - g·E_ball[ v(y) ] - c·E_rim[ e(z) ] }
//! ```
//!
//! One sample replaces each mean by one random point, `z` on the rim and `y` inside,
//! and each velocity by that of the boundary point where a walk from there ends. What
//! is returned are these boundary points with their covectors.
//!
//! The radius is limited to `max_radius`, and boundaries beyond it count as
//! absent with velocity zero: the field stays continuous and exact on the
//! boundaries (METHOD 1).

use serde::{Deserialize, Serialize};

use crate::domain::{Domain, Nearest, Vector};
use crate::field::FieldSample;

/// How the field is built, and its divergence estimated.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct WalkSettings {
    /// Number of steps `M`, at least 1: with none the field is not continuous.
    pub steps: u32,
    /// `A_max`, the largest radius of a ball, radians on the sphere. Any value
    /// is unbiased; smaller ones are faster, larger ones smoother.
    pub max_radius: f64,
    /// How the divergence is estimated.
    pub estimator: Estimator,
    /// Average every sample with the one on the opposite azimuth.
    pub antithetic: bool,
}

/// Estimators of the divergence (METHOD 2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Estimator {
    /// `c` is the velocity at the closest boundary point, and the value sample
    /// lies on the same azimuth as the rim sample: finite variance.
    Anchored,
    /// `c = 0` and independent samples, as printed: the second moment grows
    /// like `∫ A⁻² dA` at the boundary, so its variance is infinite.
    Literal,
}

impl Default for WalkSettings {
    fn default() -> Self {
        Self {
            steps: 1,
            max_radius: 0.2,
            estimator: Estimator::Anchored,
            antithetic: false,
        }
    }
}

impl WalkSettings {
    /// How many random numbers a sample takes: their dimensions are
    /// `0 .. dimensions()`. Anchored samples leave out the last one.
    pub fn dimensions(&self) -> u32 {
        self.second_walk()
            + match self.estimator {
                Estimator::Anchored => 0,
                Estimator::Literal => 2 * (self.steps - 1),
            }
    }

    /// The distance within which a sample of the field finds boundaries: each step moves a walk by at
    /// most `max_radius`, and the last query asks as far.
    pub fn reach(&self) -> f64 {
        reach(self.max_radius, self.steps)
    }

    /// Behind the numbers of one walk and an azimuth: those of the literal
    /// estimator's other walk.
    fn second_walk(&self) -> u32 {
        2 * self.steps + 1
    }
}

/// The first number after those of the first step.
const LATER: u32 = 2;

/// An unbiased sample of the field's value and divergence at `x`, Algorithms 3
/// and 7. `random(i)` is the `i`-th uniform number of this sample.
pub fn sample_field<D: Domain>(
    domain: &D,
    x: D::Vector,
    settings: &WalkSettings,
    random: impl Fn(u32) -> f64,
) -> FieldSample<D::Site, D::Vector> {
    debug_assert!(
        settings.steps > 0,
        "the field of no steps is not continuous"
    );
    let mut sample = FieldSample::zero(domain.curvature(x));
    // The largest empty ball around x, Eqs. (15) and (29). If no boundary lies within
    // the distance of the whole walk, the field is zero in all of the ball.
    let nearest = domain.closest(x, max_distance(domain, settings, settings.steps));
    if nearest.is_none() && domain.is_distance() {
        return sample;
    }
    let near = nearest.filter(|nearest| nearest.distance < settings.max_radius);
    let radius = near.map_or(settings.max_radius, |nearest| nearest.distance); // A
    let kappa = domain.rim_over_ball(radius); // κ = |rim|/|ball|
    // g = ∇A: a distance grows away from the closest boundary point. A limited radius
    // does not change with x.
    let g = near.map_or(D::Vector::ZERO, |nearest| domain.growth(x, &nearest));
    let walker = Walker {
        domain,
        settings,
        random: &random,
    };

    // One azimuth, or two opposite ones that each count half.
    let azimuth = random(0);
    let pair = [azimuth, (azimuth + 0.5) % 1.0];
    let azimuths = &pair[..if settings.antithetic { 2 } else { 1 }];
    let share = 1.0 / azimuths.len() as f64;
    let mut mean_e = D::Vector::ZERO;
    for &azimuth in azimuths {
        let e = domain.tangent(x, azimuth);
        mean_e = mean_e + e * share;
        // y inside the ball and z on its rim. Anchored, they share azimuth and later
        // steps, so that v(z) - v(y) is small where the ball is, and κ large. The
        // literal estimator draws both independently, as printed.
        let (e_inside, later) = match settings.estimator {
            Estimator::Anchored => (e, LATER),
            Estimator::Literal => {
                let own = domain.tangent(x, random(2 * settings.steps));
                (own, settings.second_walk())
            }
        };
        let inside = domain.radius_inside(radius, random(1));
        let y = domain.walk(x, e_inside, inside);
        let z = domain.walk(x, e, radius);
        // The velocities at y and z are those of the field of one step less. That at y
        // samples the mean over the ball: it is the value, Eqs. (20) and (32), and in
        // the derivative it has the covector -κ g. That at z has κ (e + g).
        let steps = settings.steps - 1;
        let gradient_y = g * (-kappa * share);
        let value_y = walker.value(y, steps, nearest, later);
        sample.add(value_y, share, gradient_y);
        let gradient_z = (e + g) * (kappa * share);
        let value_z = walker.value(z, steps, nearest, LATER);
        sample.add(value_z, 0.0, gradient_z);
    }
    // The anchor c is the velocity at the closest boundary point, Eq. (18): its covector
    // is -κ E[e]. Beyond the largest radius it is zero, like that of absent boundaries.
    if settings.estimator == Estimator::Anchored {
        let anchor = near.map(|nearest| nearest.site);
        sample.add(anchor, 0.0, mean_e * -kappa);
    }
    sample
}

/// An unbiased sample of the field's value at `x` alone, Algorithms 2 and 6:
/// the boundary point whose velocity it is, or `None` for velocity zero.
pub fn sample_value<D: Domain>(
    domain: &D,
    x: D::Vector,
    settings: &WalkSettings,
    random: impl Fn(u32) -> f64,
) -> Option<D::Site> {
    let walker = Walker {
        domain,
        settings,
        random: &random,
    };
    walker.value(x, settings.steps, None, 0)
}

/// [`WalkSettings::reach`] of so many steps.
fn reach(max_radius: f64, steps: u32) -> f64 {
    max_radius * f64::from(steps + 1)
}

/// The distance within which a walk of `steps` steps can end. If there is no boundary within,
/// the field of `steps` steps is zero. Where the radius is no distance, what is near says nothing of
/// what the walk comes to, and only the radius is asked for.
fn max_distance<D: Domain>(domain: &D, settings: &WalkSettings, steps: u32) -> f64 {
    match domain.is_distance() {
        true => reach(settings.max_radius, steps),
        false => settings.max_radius,
    }
}

struct Walker<'a, D: Domain, R> {
    domain: &'a D,
    settings: &'a WalkSettings,
    random: &'a R,
}

impl<D: Domain, R: Fn(u32) -> f64> Walker<'_, D, R> {
    /// The boundary point whose velocity is a sample of the field of `steps`
    /// steps at `x`. `known` is a boundary point found before: no search needs
    /// to look farther than it. Takes two numbers for each step from `dimension` on.
    fn value(
        &self,
        mut x: D::Vector,
        steps: u32,
        mut known: Option<Nearest<D::Site, D::Vector>>,
        mut dimension: u32,
    ) -> Option<D::Site> {
        let max_radius = self.settings.max_radius;
        for step in (0..=steps).rev() {
            // The last query only asks what is within max_radius; those before it also
            // decide whether the rest of the walk can be skipped.
            let far = max_distance(self.domain, self.settings, step);
            let known_radius = known.and_then(|nearest| self.domain.radius_at(x, &nearest));
            let bound = known_radius.map_or(far, |radius| far.min(radius));
            let found = self.domain.closest(x, bound);
            // The closest boundary point: the one found, or the known one if nothing is
            // nearer and it is within reach. Without either the velocity is zero.
            let nearest = found.or_else(|| {
                known.filter(|_| bound < far).map(|nearest| Nearest {
                    distance: bound,
                    ..nearest
                })
            });
            // After the last step the walk ends at the closest boundary point, Eqs. (18)
            // and (31).
            if step == 0 || (nearest.is_none() && self.domain.is_distance()) {
                return Some(nearest?.site);
            }
            // Otherwise it steps to a uniform point of the largest empty ball, Eqs. (20)
            // and (32).
            known = nearest;
            let radius = nearest.map_or(max_radius, |nearest| nearest.distance.min(max_radius));
            let e = self.domain.tangent(x, (self.random)(dimension));
            let inside = self
                .domain
                .radius_inside(radius, (self.random)(dimension + 1));
            x = self.domain.walk(x, e, inside);
            dimension += 2;
        }
        unreachable!("the loop returns at step 0")
    }
}
