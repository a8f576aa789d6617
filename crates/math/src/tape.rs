//! Reverse-mode derivatives: numbers that record how they were computed.
//!
//! A [`Tape`] lists every operation with its slopes; walking it backwards turns
//! the adjoint of a result (the derivative of some final number by it) into the
//! adjoints of all that it was computed from. Constants are not recorded.
//!
//! ```
//! use capwalk_math::tape::Tape;
//! let tape = Tape::default();
//! let (x, y) = (tape.variable(3.0), tape.variable(4.0));
//! let product = x * y;
//! let mut adjoints = tape.adjoints();
//! adjoints.add(product, 1.0);
//! tape.sweep(&mut adjoints, 0..tape.len());
//! assert_eq!((adjoints.of(x), adjoints.of(y)), (4.0, 3.0));
//! ```

use std::cell::RefCell;
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Range, Sub};

use crate::real::Real;
use crate::vec3::Vec3;

/// What was computed, in order.
#[derive(Default)]
pub struct Tape {
    entries: RefCell<Vec<Entry>>,
}

/// An operation: the numbers it was computed from, and its slope in each.
#[derive(Clone, Copy)]
struct Entry {
    parents: [u32; 2],
    slopes: [f64; 2],
}

/// The parent that is a constant.
const CONSTANT: u32 = u32::MAX;

/// A number on a tape, or a constant.
#[derive(Clone, Copy)]
pub struct Var<'t> {
    /// `None` for constants.
    tape: Option<&'t Tape>,
    index: u32,
    value: f64,
}

/// The adjoints of the numbers on a tape.
#[derive(Clone, Debug, Default)]
pub struct Adjoints(Vec<f64>);

impl Tape {
    /// A number that is computed from nothing: an independent variable.
    #[inline]
    pub fn variable(&self, value: f64) -> Var<'_> {
        self.push(value, [CONSTANT; 2], [0.0; 2])
    }

    /// Three of them, on consecutive places.
    #[inline]
    pub fn variables(&self, v: Vec3) -> Vec3<Var<'_>> {
        let [x, y, z] = v.to_array().map(|value| self.variable(value));
        Vec3::new(x, y, z)
    }

    /// How many numbers are on the tape.
    pub fn len(&self) -> usize {
        self.entries.borrow().len()
    }

    /// True if nothing is on the tape.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Forgets everything, and keeps the memory. Numbers of before must not be
    /// used any more.
    pub fn clear(&mut self) {
        self.entries.get_mut().clear();
    }

    /// Adjoints of zero for all numbers on the tape.
    pub fn adjoints(&self) -> Adjoints {
        let mut adjoints = Adjoints::default();
        adjoints.reset(self);
        adjoints
    }

    /// Passes the adjoints of the numbers at `places` on to those they were
    /// computed from, last first. Sweeping a tape in several pieces, the last
    /// one first, is sweeping it as a whole.
    pub fn sweep(&self, adjoints: &mut Adjoints, places: Range<usize>) {
        let entries = self.entries.borrow();
        for place in places.rev() {
            let adjoint = adjoints.0[place];
            if adjoint == 0.0 {
                continue;
            }
            let Entry { parents, slopes } = entries[place];
            for (parent, slope) in parents.into_iter().zip(slopes) {
                if parent != CONSTANT {
                    adjoints.0[parent as usize] += slope * adjoint;
                }
            }
        }
    }

    #[inline]
    fn push(&self, value: f64, parents: [u32; 2], slopes: [f64; 2]) -> Var<'_> {
        let mut entries = self.entries.borrow_mut();
        let index = entries.len() as u32;
        entries.push(Entry { parents, slopes });
        Var {
            tape: Some(self),
            index,
            value,
        }
    }
}

impl Adjoints {
    /// Zero for all numbers on the tape; keeps the memory.
    pub fn reset(&mut self, tape: &Tape) {
        self.0.clear();
        self.0.resize(tape.len(), 0.0);
    }

    /// Adds to the adjoint of a number; nothing if it is a constant.
    #[inline]
    pub fn add(&mut self, var: Var<'_>, adjoint: f64) {
        if var.tape.is_some() {
            self.0[var.index as usize] += adjoint;
        }
    }

    /// Adds to the adjoints of a vector.
    #[inline]
    pub fn add_vector(&mut self, v: Vec3<Var<'_>>, adjoint: Vec3) {
        self.add(v.x, adjoint.x);
        self.add(v.y, adjoint.y);
        self.add(v.z, adjoint.z);
    }

    /// The adjoint of a number; zero for constants.
    #[inline]
    pub fn of(&self, var: Var<'_>) -> f64 {
        match var.tape {
            Some(_) => self.0[var.index as usize],
            None => 0.0,
        }
    }

    /// The adjoint of the number at a place on the tape.
    #[inline]
    pub fn at(&self, place: usize) -> f64 {
        self.0[place]
    }

    /// The adjoints of a vector.
    #[inline]
    pub fn of_vector(&self, v: Vec3<Var<'_>>) -> Vec3 {
        Vec3::new(self.of(v.x), self.of(v.y), self.of(v.z))
    }
}

impl<'t> Var<'t> {
    /// Where it is on its tape; `None` for constants.
    #[inline]
    pub fn place(self) -> Option<usize> {
        self.tape.map(|_| self.index as usize)
    }

    #[inline]
    fn parent(self) -> u32 {
        match self.tape {
            Some(_) => self.index,
            None => CONSTANT,
        }
    }

    /// A function of one number: its value and slope.
    #[inline]
    fn chain(self, value: f64, slope: f64) -> Self {
        match self.tape {
            Some(tape) => tape.push(value, [self.index, CONSTANT], [slope, 0.0]),
            None => Self::constant(value),
        }
    }

    /// A function of two numbers.
    #[inline]
    fn chain2(self, b: Self, value: f64, slopes: [f64; 2]) -> Self {
        match self.tape.or(b.tape) {
            Some(tape) => tape.push(value, [self.parent(), b.parent()], slopes),
            None => Self::constant(value),
        }
    }
}

impl Add for Var<'_> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        self.chain2(b, self.value + b.value, [1.0, 1.0])
    }
}

impl Sub for Var<'_> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        self.chain2(b, self.value - b.value, [1.0, -1.0])
    }
}

impl Mul for Var<'_> {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        self.chain2(b, self.value * b.value, [b.value, self.value])
    }
}

impl Div for Var<'_> {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        let ratio = self.value / b.value;
        self.chain2(b, ratio, [b.value.recip(), -ratio / b.value])
    }
}

impl Neg for Var<'_> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

/// They compare by value: a derivative never steers a branch.
impl PartialEq for Var<'_> {
    fn eq(&self, b: &Self) -> bool {
        self.value == b.value
    }
}

impl PartialOrd for Var<'_> {
    #[inline]
    fn partial_cmp(&self, b: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&b.value)
    }
}

impl fmt::Debug for Var<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.tape {
            Some(_) => write!(f, "{} (#{})", self.value, self.index),
            None => write!(f, "{}", self.value),
        }
    }
}

impl Real for Var<'_> {
    #[inline]
    fn constant(value: f64) -> Self {
        Self {
            tape: None,
            index: CONSTANT,
            value,
        }
    }
    #[inline]
    fn value(self) -> f64 {
        self.value
    }
    #[inline]
    fn is_constant(self) -> bool {
        self.tape.is_none()
    }
    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }
    #[inline]
    fn exp(self) -> Self {
        let exp = self.value.exp();
        self.chain(exp, exp)
    }
    #[inline]
    fn chain(self, value: f64, slope: f64) -> Self {
        Var::chain(self, value, slope)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dual::Dual;

    fn expression<R: Real>(x: R, y: R) -> R {
        let (sin, cos) = (x * y).sin_cos();
        let two = R::constant(2.0);
        (sin / (x + two) - cos * x.sqrt() + two * two) * (-y).exp() - x
    }

    /// Adjoints are the derivatives that duals carry, in one sweep or two.
    #[test]
    fn adjoints_are_derivatives() {
        let mut tape = Tape::default();
        let mut adjoints = Adjoints::default();
        for (x0, y0) in [(0.3, 1.2), (2.0, -0.7)] {
            tape.clear();
            let (x, y) = (tape.variable(x0), tape.variable(y0));
            let result = expression(x, y);
            let dual = expression(Dual::<2>::variable(x0, 0), Dual::variable(y0, 1));
            assert_eq!(result.value(), dual.value);
            for split in [0, 5, tape.len()] {
                adjoints.reset(&tape);
                adjoints.add(result, 1.0);
                tape.sweep(&mut adjoints, split..tape.len());
                tape.sweep(&mut adjoints, 0..split);
                let found = [adjoints.of(x), adjoints.of(y)];
                for (a, b) in found.into_iter().zip(dual.tangent) {
                    assert!((a - b).abs() < 1e-14, "{found:?} {dual:?}");
                }
            }
        }
    }

    /// What is computed from constants takes no place.
    #[test]
    fn constants_are_not_recorded() {
        let tape = Tape::default();
        let x = tape.variable(1.0);
        let constant = expression(Var::constant(1.0), Var::constant(2.0));
        assert_eq!(tape.len(), 1);
        assert_eq!(constant.place(), None);
        assert_eq!((x * constant).place(), Some(1));
    }
}
