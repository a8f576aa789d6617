//! Reverse-mode derivatives: numbers that record how they were computed.
//!
//! A [`Tape`] lists every operation with its partial derivatives; walking it
//! backwards turns the adjoint of a result (the derivative of some final number with
//! respect to it) into the adjoints of all that it was computed from. An operation
//! may have any number of operands: an inner product is one. Constants are not
//! recorded, and a number plus a constant shares the number's place.
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
use crate::rgb::Rgb;
use crate::vec3::Vec3;

/// What was computed, in order. The first place stands for all constants: what
/// falls on it is not looked at.
#[derive(Default)]
pub struct Tape {
    operations: RefCell<Operations>,
}

/// Operations, in order.
struct Operations {
    /// What all of them were computed from, one after another.
    operands: Vec<Operand>,
    /// Where the operands of each end; they begin where those of the one before end.
    ends: Vec<u32>,
}

/// A number that another was computed from, and the other's partial derivative with
/// respect to it.
#[derive(Clone, Copy, Default)]
struct Operand {
    place: u32,
    derivative: f64,
}

/// The place of constants.
const CONSTANT: u32 = 0;

/// A number on a tape, or a constant.
#[derive(Clone, Copy)]
pub struct Var<'t> {
    /// `None` for constants.
    tape: Option<&'t Tape>,
    /// The place on it.
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
        let index = self.operations.borrow_mut().end();
        Var {
            tape: Some(self),
            index,
            value,
        }
    }

    /// Three of them, on consecutive places.
    #[inline]
    pub fn variables(&self, v: Vec3) -> Vec3<Var<'_>> {
        let [x, y, z] = v.to_array().map(|value| self.variable(value));
        Vec3::new(x, y, z)
    }

    /// How many places there are: one for each number, and that of constants.
    pub fn len(&self) -> usize {
        self.operations.borrow().ends.len()
    }

    /// True if no number is on the tape.
    pub fn is_empty(&self) -> bool {
        self.len() == CONSTANT as usize + 1
    }

    /// Forgets everything, and keeps the memory. Numbers of before must not be
    /// used any more.
    pub fn clear(&mut self) {
        let operations = self.operations.get_mut();
        operations.operands.clear();
        operations.ends.truncate(CONSTANT as usize + 1);
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
        let Operations { operands, ends } = &*self.operations.borrow();
        let begin = |place: usize| place.checked_sub(1).map_or(0, |before| ends[before]);
        // Everything computed from a number comes after it: going backwards, its
        // adjoint is complete when it is reached.
        for place in places.rev() {
            let adjoint = adjoints.0[place];
            if adjoint == 0.0 {
                continue; // Nothing that counts was computed from it.
            }
            // The chain rule: x̄ += ∂y/∂x ȳ for each operand x of y.
            for operand in &operands[begin(place) as usize..ends[place] as usize] {
                adjoints.0[operand.place as usize] += operand.derivative * adjoint;
            }
        }
    }
}

impl Default for Operations {
    /// The entry of constants, which are computed from nothing.
    fn default() -> Self {
        Self {
            operands: Vec::new(),
            ends: vec![0],
        }
    }
}

impl Operations {
    /// Ends an operation, and gives its place.
    #[inline]
    fn end(&mut self) -> u32 {
        let place = self.ends.len() as u32;
        self.ends.push(self.operands.len() as u32);
        place
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

    /// Adds to the adjoints of a colour's channels.
    #[inline]
    pub fn add_colour(&mut self, c: Rgb<Var<'_>>, adjoint: Rgb) {
        self.add(c.r, adjoint.r);
        self.add(c.g, adjoint.g);
        self.add(c.b, adjoint.b);
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
}

impl Add for Var<'_> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        if b.tape.is_none() {
            let value = self.value + b.value;
            return Self { value, ..self };
        }
        if self.tape.is_none() {
            let value = self.value + b.value;
            return Self { value, ..b };
        }
        Self::chain(self.value + b.value, [(self, 1.0), (b, 1.0)])
    }
}

impl Sub for Var<'_> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        if b.tape.is_none() {
            let value = self.value - b.value;
            return Self { value, ..self };
        }
        Self::chain(self.value - b.value, [(self, 1.0), (b, -1.0)])
    }
}

impl Mul for Var<'_> {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        Self::chain(self.value * b.value, [(self, b.value), (b, self.value)])
    }
}

impl Div for Var<'_> {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        let ratio = self.value / b.value;
        let inverse = b.value.recip();
        Self::chain(ratio, [(self, inverse), (b, -ratio * inverse)])
    }
}

impl Neg for Var<'_> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::chain(-self.value, [(self, -1.0)])
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
    #[inline(always)]
    fn chain<const N: usize>(value: f64, terms: [(Self, f64); N]) -> Self {
        let mut tape = None;
        for (x, _) in &terms {
            tape = tape.or(x.tape);
        }
        let Some(tape) = tape else {
            return Self::constant(value);
        };
        let operations = &mut *tape.operations.borrow_mut();
        let mut operands = [Operand::default(); N];
        for (operand, (x, derivative)) in operands.iter_mut().zip(terms) {
            *operand = Operand {
                place: x.index,
                derivative,
            };
        }
        operations.operands.extend_from_slice(&operands);
        Self {
            tape: Some(tape),
            index: operations.end(),
            value,
        }
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
        assert_eq!(tape.len(), 2);
        assert_eq!(constant.place(), None);
        assert_eq!((x * constant).place(), Some(2));
    }

    /// A number plus a constant takes no place either, and passes its adjoint on.
    #[test]
    fn shifted_numbers_share_their_place() {
        let tape = Tape::default();
        let x = tape.variable(1.5);
        let shifted = Var::constant(1.0) + x - Var::constant(4.0);
        assert_eq!((shifted.value(), shifted.place()), (-1.5, x.place()));
        let result = shifted * x; // (x - 3) x
        let mut adjoints = tape.adjoints();
        adjoints.add(result, 2.0);
        tape.sweep(&mut adjoints, 0..tape.len());
        assert_eq!(adjoints.of(x), 0.0); // 2 x - 3, at 1.5
        assert_eq!(tape.len(), 3);
    }
}
