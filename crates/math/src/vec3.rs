//! Three-component vectors over any [`Real`].

use serde::{Deserialize, Serialize};

use std::ops::{Add, AddAssign, Div, Index, Mul, Neg, Sub};

use crate::dual::Dual;
use crate::real::Real;

/// A vector, point or direction in space.
#[derive(Clone, Copy, Default, Debug, PartialEq, Serialize, Deserialize)]
#[repr(C)]
pub struct Vec3<R = f64> {
    /// First component.
    pub x: R,
    /// Second component.
    pub y: R,
    /// Third component.
    pub z: R,
}

impl<R> Vec3<R> {
    /// A vector from its components.
    #[inline]
    pub const fn new(x: R, y: R, z: R) -> Self {
        Self { x, y, z }
    }

    /// The components as an array.
    #[inline]
    pub fn to_array(self) -> [R; 3] {
        [self.x, self.y, self.z]
    }
}

impl<R: Real> Vec3<R> {
    /// A vector with the number in all three components.
    #[inline]
    pub fn splat(v: R) -> Self {
        Self::new(v, v, v)
    }

    /// The zero vector.
    #[inline]
    pub fn zero() -> Self {
        Self::splat(R::constant(0.0))
    }

    /// A vector whose derivative is zero.
    #[inline]
    pub fn constant(v: Vec3) -> Self {
        v.map(R::constant)
    }

    /// The vector without its derivative.
    #[inline]
    pub fn value(self) -> Vec3 {
        self.map(R::value)
    }

    /// True if its derivatives are known to be zero.
    #[inline]
    pub fn is_constant(self) -> bool {
        self.x.is_constant() && self.y.is_constant() && self.z.is_constant()
    }

    /// Applies a function to each component.
    #[inline]
    pub fn map<S>(self, f: impl Fn(R) -> S) -> Vec3<S> {
        Vec3::new(f(self.x), f(self.y), f(self.z))
    }

    /// Inner product.
    #[inline]
    pub fn dot(self, b: Self) -> R {
        let (u, v) = (self.value(), b.value());
        let (a, value) = (self, u.x * v.x + u.y * v.y + u.z * v.z);
        let [x, y, z] = [(a.x, v.x), (a.y, v.y), (a.z, v.z)];
        R::chain(value, [x, y, z, (b.x, u.x), (b.y, u.y), (b.z, u.z)])
    }

    /// Cross product, right-handed.
    #[inline]
    pub fn cross(self, b: Self) -> Self {
        Self::new(
            determinant([self.y, self.z], [b.y, b.z]),
            determinant([self.z, self.x], [b.z, b.x]),
            determinant([self.x, self.y], [b.x, b.y]),
        )
    }

    /// Squared Euclidean length.
    #[inline]
    pub fn length_squared(self) -> R {
        let v = self.value();
        let terms = [
            (self.x, 2.0 * v.x),
            (self.y, 2.0 * v.y),
            (self.z, 2.0 * v.z),
        ];
        R::chain(v.dot(v), terms)
    }

    /// Euclidean length.
    #[inline]
    pub fn length(self) -> R {
        let v = self.value();
        let length = v.dot(v).sqrt();
        let q = v / length;
        R::chain(length, [(self.x, q.x), (self.y, q.y), (self.z, q.z)])
    }

    /// The unit vector in this direction; not finite for the zero vector.
    #[inline]
    pub fn normalized(self) -> Self {
        let v = self.value();
        let scale = 1.0 / v.dot(v).sqrt();
        let q = v * scale;
        // (I - q qᵀ) / |v|, row by row.
        let row = |i: usize, of: f64| {
            let dq = |j: usize| (f64::from(i == j) - of * q[j]) * scale;
            let terms = [(self.x, dq(0)), (self.y, dq(1)), (self.z, dq(2))];
            R::chain(of, terms)
        };
        Self::new(row(0, q.x), row(1, q.y), row(2, q.z))
    }

    /// The part orthogonal to the unit vector `q`: `(I - q qᵀ) self`.
    #[inline]
    pub fn reject_from(self, q: Self) -> Self {
        self - q * self.dot(q)
    }
}

/// `a₀ b₁ - a₁ b₀`.
#[inline]
fn determinant<R: Real>(a: [R; 2], b: [R; 2]) -> R {
    let ([a0, a1], [b0, b1]) = (a.map(R::value), b.map(R::value));
    let terms = [(a[0], b1), (b[1], a0), (a[1], -b0), (b[0], -a1)];
    R::chain(a0 * b1 - a1 * b0, terms)
}

impl Vec3 {
    /// True if no component is infinite or NaN.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }

    /// Component-wise minimum.
    #[inline]
    pub fn min(self, b: Self) -> Self {
        Self::new(self.x.min(b.x), self.y.min(b.y), self.z.min(b.z))
    }

    /// Component-wise maximum.
    #[inline]
    pub fn max(self, b: Self) -> Self {
        Self::new(self.x.max(b.x), self.y.max(b.y), self.z.max(b.z))
    }

    /// The largest component.
    #[inline]
    pub fn max_component(self) -> f64 {
        self.x.max(self.y).max(self.z)
    }

    /// A vector that carries the velocity `tangent`.
    #[inline]
    pub fn with_tangent(self, tangent: Vec3) -> Vec3<Dual<1>> {
        Vec3::new(
            Dual::new(self.x, [tangent.x]),
            Dual::new(self.y, [tangent.y]),
            Dual::new(self.z, [tangent.z]),
        )
    }
}

impl<const N: usize> Vec3<Dual<N>> {
    /// The derivative in the `i`-th direction.
    #[inline]
    pub fn tangent(self, i: usize) -> Vec3 {
        Vec3::new(self.x.tangent[i], self.y.tangent[i], self.z.tangent[i])
    }
}

impl<R> From<[R; 3]> for Vec3<R> {
    fn from([x, y, z]: [R; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<R> Index<usize> for Vec3<R> {
    type Output = R;
    #[inline]
    fn index(&self, axis: usize) -> &R {
        match axis {
            0 => &self.x,
            1 => &self.y,
            2 => &self.z,
            _ => panic!("axis {axis} of a three-component vector"),
        }
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self::new(self.x + b.x, self.y + b.y, self.z + b.z)
    }
}

impl<R: Real> AddAssign for Vec3<R> {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl<R: Real> Sub for Vec3<R> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self::new(self.x - b.x, self.y - b.y, self.z - b.z)
    }
}

impl<R: Real> Neg for Vec3<R> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<R: Real> Mul<R> for Vec3<R> {
    type Output = Self;
    #[inline]
    fn mul(self, s: R) -> Self {
        Self::new(self.x * s, self.y * s, self.z * s)
    }
}

impl<R: Real> Div<R> for Vec3<R> {
    type Output = Self;
    #[inline]
    fn div(self, s: R) -> Self {
        Self::new(self.x / s, self.y / s, self.z / s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tape::Tape;

    /// Products, lengths and directions, component by component with the rules of
    /// numbers alone.
    fn spelled_out<R: Real>(a: Vec3<R>, b: Vec3<R>) -> [R; 9] {
        let cross = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
        let square = a.x * a.x + a.y * a.y + a.z * a.z;
        let length = square.sqrt();
        let dot = a.x * b.x + a.y * b.y + a.z * b.z;
        let [x, y, z] = [a.x, a.y, a.z].map(|component| component / length);
        [
            dot,
            cross(1, 2),
            cross(2, 0),
            cross(0, 1),
            square,
            length,
            x,
            y,
            z,
        ]
    }

    fn methods<R: Real>(a: Vec3<R>, b: Vec3<R>) -> [R; 9] {
        let (cross, q) = (a.cross(b), a.normalized());
        let [square, length] = [a.length_squared(), a.length()];
        [
            a.dot(b),
            cross.x,
            cross.y,
            cross.z,
            square,
            length,
            q.x,
            q.y,
            q.z,
        ]
    }

    /// What methods give in one step has the values and the derivatives of what numbers
    /// give in several, forward and on a tape; also if one vector is constant.
    #[test]
    fn methods_have_the_derivatives_of_their_formulas() {
        let (a, b) = (Vec3::new(0.3, -1.2, 0.7), Vec3::new(-0.4, 0.9, 2.1));
        let vector = |v: Vec3, first: usize| {
            let component = |i: usize| Dual::<6>::variable(v[i], first + i);
            Vec3::new(component(0), component(1), component(2))
        };
        for is_constant in [[false, false], [true, false], [false, true]] {
            let dual = |v: Vec3, i: usize| match is_constant[i] {
                true => Vec3::constant(v),
                false => vector(v, 3 * i),
            };
            let expected = spelled_out(dual(a, 0), dual(b, 1));
            let forward = methods(dual(a, 0), dual(b, 1));
            let tape = Tape::default();
            let recorded = |v: Vec3, i: usize| match is_constant[i] {
                true => Vec3::constant(v),
                false => tape.variables(v),
            };
            let vectors = [recorded(a, 0), recorded(b, 1)];
            let results = methods(vectors[0], vectors[1]);
            for ((expected, forward), result) in expected.iter().zip(&forward).zip(results) {
                assert!((expected.value - forward.value).abs() < 1e-15);
                assert_eq!(forward.value, result.value());
                let mut adjoints = tape.adjoints();
                adjoints.add(result, 1.0);
                tape.sweep(&mut adjoints, 0..tape.len());
                let found = vectors.map(|v| adjoints.of_vector(v).to_array());
                for (i, &derivative) in expected.tangent.iter().enumerate() {
                    assert!((derivative - forward.tangent[i]).abs() < 1e-15);
                    assert!((derivative - found[i / 3][i % 3]).abs() < 1e-15);
                }
            }
        }
    }
}
