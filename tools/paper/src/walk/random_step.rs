//! The classical walk on spheres, Section 4.1: harmonic fields, which solve
//! Laplace's equation with the boundary's velocities as values, Eq. (12).
//!
//! The walk steps to the rim of the largest empty ball, Eq. (14), again and
//! again, because a harmonic function is its mean over any circle around a
//! point, Eq. (13). It ends in a shell of width `ε` at the boundary. That holds
//! on the line, in the plane and on the sphere: circles around a point of a
//! cap are circles around the image of that point in a conformal map to a disk.
//!
//! The renderer does not use it. Its fixed-step walk needs fewer queries and
//! has no shell, see [`capwalk_walk::fixed_step`].

use capwalk_walk::{Domain, Estimator, FieldSample};

/// When a walk of random length ends, and how its gradient is estimated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShellSettings {
    /// `ε`: a walk ends nearer to the boundary than this. The field is wrong by
    /// at most the change of the boundary's velocity over this distance.
    pub shell: f64,
    /// A walk that has not arrived after so many steps is given up. Walks
    /// inside a closed boundary take of the order of `log 1/ε` steps.
    pub max_steps: u32,
    /// [`Estimator::Literal`] is Eq. (17) as printed: its noise grows like the
    /// inverse distance to the boundary. [`Estimator::Anchored`] subtracts the
    /// velocity at the closest boundary point, which changes no mean; what
    /// remains, from walks that end far away, grows like the root of that.
    pub estimator: Estimator,
}

impl Default for ShellSettings {
    fn default() -> Self {
        Self {
            shell: 1e-4,
            max_steps: 10_000,
            estimator: Estimator::Literal,
        }
    }
}

/// A walk that arrived.
#[derive(Clone, Copy, Debug)]
pub struct Arrival<S, V> {
    /// A sample of the harmonic field and its gradient, from the same walk.
    pub sample: FieldSample<S, V>,
    /// How many steps it took.
    pub steps: u32,
}

/// A sample of the harmonic field's value and gradient at `x`, Eqs. (16) and
/// (17). `random(i)` is the `i`-th uniform number of this sample, one for each
/// step. `None` if the walk did not arrive: there is no boundary, or it is
/// longer than `max_steps`. Callers count these; dropping them is a bias.
pub fn sample_harmonic<D: Domain>(
    domain: &D,
    x: D::Vector,
    settings: &ShellSettings,
    random: impl Fn(u32) -> f64,
) -> Option<Arrival<D::Site, D::Vector>> {
    let nearest = domain.closest(x, f64::INFINITY)?;
    let e = domain.tangent(x, random(0));
    // Eq. (17); the first step is made even inside the shell.
    let gradient = e * domain.rim_over_ball(nearest.distance);
    let first = domain.walk(x, e, nearest.distance);
    let (site, steps) = arrive(domain, first, settings, random)?;

    let mut sample = FieldSample::zero(domain.curvature(x));
    sample.add(Some(site), 1.0, gradient);
    if settings.estimator == Estimator::Anchored {
        sample.add(Some(nearest.site), 0.0, -gradient);
    }
    Some(Arrival { sample, steps })
}

/// The boundary point where a walk from `x` ends that has made one step
/// before, and the number of its steps, Eq. (16).
fn arrive<D: Domain>(
    domain: &D,
    mut x: D::Vector,
    settings: &ShellSettings,
    random: impl Fn(u32) -> f64,
) -> Option<(D::Site, u32)> {
    for steps in 1..=settings.max_steps {
        let nearest = domain.closest(x, f64::INFINITY)?;
        if nearest.distance < settings.shell {
            return Some((nearest.site, steps));
        }
        let e = domain.tangent(x, random(steps));
        x = domain.walk(x, e, nearest.distance);
    }
    None
}
