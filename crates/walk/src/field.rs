//! The result of a walk: weights and covectors on boundary points.

use crate::domain::Vector;

/// One boundary point's share of a field sample.
#[derive(Clone, Copy, Debug)]
pub struct Term<S, V> {
    /// The boundary point, as its domain names it.
    pub site: S,
    /// Weight of its velocity in the field's value.
    pub weight: f64,
    /// The weight's gradient: along a tangent `d`, the velocity's weight in the
    /// field's directional derivative is `gradient·d`.
    pub gradient: V,
}

/// An unbiased sample of a field and its derivatives at one point, linear in
/// the velocities of at most five boundary points (METHOD 5).
#[derive(Clone, Copy, Debug)]
pub struct FieldSample<S, V> {
    terms: [Option<Term<S, V>>; 5],
    /// What the domain's curvature adds to the divergence of the field
    /// projected on the tangent space: its inner product with the value.
    curvature: V,
}

impl<S: Copy, V: Vector> FieldSample<S, V> {
    /// The field that is zero around a point, of a domain with this curvature
    /// there ([`crate::Domain::curvature`]).
    pub fn zero(curvature: V) -> Self {
        Self {
            terms: [None; 5],
            curvature,
        }
    }

    /// Adds a boundary point's share, the fifth at most; a point that does not exist
    /// moves with velocity zero and is left out.
    pub fn add(&mut self, site: Option<S>, weight: f64, gradient: V) {
        let Some(site) = site else { return };
        let free = self.terms.iter_mut().find(|term| term.is_none());
        *free.expect("no estimator uses more than five boundary points") = Some(Term {
            site,
            weight,
            gradient,
        });
    }

    /// The same sample with the boundary points described in another way.
    #[inline]
    pub fn map<T: Copy>(&self, f: impl Fn(&S) -> T) -> FieldSample<T, V> {
        self.filter_map(|site| Some(f(site)))
    }

    /// The part of it that is of some boundary points, described in another way.
    #[inline]
    pub fn filter_map<T: Copy>(&self, f: impl Fn(&S) -> Option<T>) -> FieldSample<T, V> {
        FieldSample {
            terms: self.terms.map(|term| {
                let term = term?;
                Some(Term {
                    site: f(&term.site)?,
                    weight: term.weight,
                    gradient: term.gradient,
                })
            }),
            curvature: self.curvature,
        }
    }

    /// True if no boundary was found: the field and its derivatives are zero.
    #[inline]
    pub fn is_zero(&self) -> bool {
        self.terms().next().is_none()
    }

    /// The boundary points' shares.
    #[inline]
    pub fn terms(&self) -> impl Iterator<Item = &Term<S, V>> {
        self.terms.iter().flatten()
    }

    /// The covector on a boundary point's velocity in the divergence of the
    /// projected field, Eq. (21).
    #[inline]
    pub fn divergence_covector(&self, term: &Term<S, V>) -> V {
        term.gradient + self.curvature * term.weight
    }

    /// The field's value and divergence for the given boundary velocities; on
    /// a curved domain the value still has to be projected on the tangent
    /// space, and the divergence is that of the projected field.
    #[inline]
    pub fn evaluate(&self, velocity: impl Fn(&S) -> V) -> (V, f64) {
        let mut value = V::ZERO;
        let mut divergence = 0.0;
        for term in self.terms() {
            let u = velocity(&term.site);
            value = value + u * term.weight;
            divergence += self.divergence_covector(term).dot(u);
        }
        (value, divergence)
    }

    /// Value and gradient of the field of a scalar given on the boundary.
    #[inline]
    pub fn scalar(&self, value: impl Fn(&S) -> f64) -> (f64, V) {
        self.terms().fold((0.0, V::ZERO), |(sum, gradient), term| {
            let u = value(&term.site);
            (sum + u * term.weight, gradient + term.gradient * u)
        })
    }

    /// The derivative of the field (not projected) along a tangent `d` of any
    /// length, for the given boundary velocities, Eqs. (27) and (34).
    pub fn directional_derivative(&self, d: V, velocity: impl Fn(&S) -> V) -> V {
        let terms = self.terms();
        terms.fold(V::ZERO, |sum, term| {
            sum + velocity(&term.site) * term.gradient.dot(d)
        })
    }
}
