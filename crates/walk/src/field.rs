//! The result of a walk: weights and covectors on boundary points.

use crate::domain::Vector;

/// One boundary point's share of a field sample.
#[derive(Clone, Copy, Debug)]
pub struct Term<S, V> {
    /// The boundary point.
    pub site: S,
    /// Weight of its velocity in the field's value.
    pub weight: f64,
    /// Covector on its velocity in the field's divergence.
    pub divergence: V,
}

/// An unbiased sample of a field and its divergence at one point, linear in
/// the velocities of at most five boundary points (METHOD 5).
#[derive(Clone, Copy, Debug)]
pub struct FieldSample<S, V> {
    terms: [Option<Term<S, V>>; 5],
}

impl<S: Copy, V: Vector> FieldSample<S, V> {
    /// The field that is zero around the point.
    pub fn zero() -> Self {
        Self { terms: [None; 5] }
    }

    /// Adds a boundary point's share; a point that does not exist moves with
    /// velocity zero and is left out.
    pub(crate) fn add(&mut self, site: Option<S>, weight: f64, divergence: V) {
        let Some(site) = site else { return };
        let free = self.terms.iter_mut().find(|term| term.is_none());
        *free.expect("no estimator uses more than five boundary points") = Some(Term {
            site,
            weight,
            divergence,
        });
    }

    /// The boundary points' shares.
    #[inline]
    pub fn terms(&self) -> impl Iterator<Item = &Term<S, V>> {
        self.terms.iter().flatten()
    }

    /// The field's value and divergence for the given boundary velocities; on
    /// a curved domain the value still has to be projected on the tangent
    /// space.
    #[inline]
    pub fn evaluate(&self, velocity: impl Fn(&S) -> V) -> (V, f64) {
        let mut value = V::ZERO;
        let mut divergence = 0.0;
        for term in self.terms() {
            let u = velocity(&term.site);
            value = value + u * term.weight;
            divergence += term.divergence.dot(u);
        }
        (value, divergence)
    }
}
