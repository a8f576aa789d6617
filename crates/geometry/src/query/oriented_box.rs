//! Boxes with axes of their own, those stored in fixed point: for patches of a
//! surface, thin along their normals, and for thin things at an angle to the
//! world's axes.

use capwalk_math::{Frame, Vec3};

use super::edge_block::LocalEdge;

/// Length of a first axis as stored.
pub(super) const FIRST_SCALE: f32 = i16::MAX as f32;
/// Length of a second axis as stored.
pub(super) const SECOND_SCALE: f32 = i8::MAX as f32;

/// Three directions, almost orthogonal and almost of unit length: what rounding
/// leaves of two axes, and their cross product. Boxes are measured along these
/// as they are, so rounding costs some tightness and nothing else.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// The first axis, times [`FIRST_SCALE`], rounded towards zero: it is no
    /// longer than a unit vector.
    pub first: [i16; 3],
    /// The second one, times [`SECOND_SCALE`].
    pub second: [i8; 3],
}

impl Axes {
    /// The axes nearest to two orthogonal unit vectors.
    fn near(first: Vec3, second: Vec3) -> Self {
        Self {
            first: [0, 1, 2].map(|i| (first[i] * f64::from(FIRST_SCALE)) as i16),
            second: [0, 1, 2].map(|i| (second[i] * f64::from(SECOND_SCALE)).round() as i8),
        }
    }

    /// The first axis.
    pub fn first(&self) -> Vec3 {
        Vec3::from(self.first.map(|v| f64::from(v) / f64::from(FIRST_SCALE)))
    }

    /// All three.
    fn directions(&self) -> [Vec3; 3] {
        let first = self.first();
        let second = Vec3::from(self.second.map(|v| f64::from(v) / f64::from(SECOND_SCALE)));
        [first, second, first.cross(second)]
    }

    /// The vectors whose inner products with `v` are the three coordinates of
    /// `v`: the numbers such that `v` is the sum of the directions times them.
    pub fn duals(&self) -> [Vec3; 3] {
        let [a, b, c] = self.directions();
        let volume = a.cross(b).dot(c);
        [b.cross(c), c.cross(a), a.cross(b)].map(|v| v * (1.0 / volume))
    }
}

/// A box: the points `centre + Σ x_i axis_i` with `|x_i| <= half_i`.
#[derive(Clone, Copy, Debug)]
pub struct OrientedBox {
    pub axes: Axes,
    pub centre: Vec3,
    /// In units of the axes.
    pub half: [f64; 3],
}

impl OrientedBox {
    /// The box of the edges with the given first axis, a unit vector. The second
    /// one is that of their largest spread across it.
    pub fn along(axis: Vec3, edges: &[LocalEdge]) -> Self {
        let Frame { s, t, .. } = Frame::from_normal(axis);
        let (mut sum, mut squares) = ([0.0; 2], [0.0; 3]);
        for end in ends(edges) {
            let (x, y) = (s.dot(end), t.dot(end));
            sum = [sum[0] + x, sum[1] + y];
            squares = [squares[0] + x * x, squares[1] + x * y, squares[2] + y * y];
        }
        let count = 2.0 * edges.len() as f64;
        let [xx, xy, yy] = [
            squares[0] - sum[0] * sum[0] / count,
            squares[1] - sum[0] * sum[1] / count,
            squares[2] - sum[1] * sum[1] / count,
        ];
        // The principal axis of a symmetric 2 x 2 matrix.
        let (sin, cos) = (0.5 * (2.0 * xy).atan2(xx - yy)).sin_cos();
        Self::with_axes(Axes::near(axis, s * cos + t * sin), edges)
    }

    /// The smaller one of two boxes: along the world's axes, and along the
    /// longest edge and the one that reaches farthest across it.
    pub fn around(edges: &[LocalEdge]) -> Self {
        let world = Axes::near(Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
        let upright = Self::with_axes(world, edges);
        let longest = |across: Option<Vec3>| {
            let direction = |edge: &LocalEdge| {
                let along = edge.ends[1] - edge.ends[0];
                across.map_or(along, |axis| along.reject_from(axis))
            };
            let (mut longest, mut length) = (Vec3::zero(), 0.0);
            for along in edges.iter().map(direction) {
                if along.length_squared() > length {
                    (longest, length) = (along, along.length_squared());
                }
            }
            longest.normalized()
        };
        let first = longest(None);
        if !first.is_finite() {
            return upright;
        }
        let second = longest(Some(first)).reject_from(first).normalized();
        let second = if second.is_finite() {
            second
        } else {
            Frame::from_normal(first).s
        };
        let tilted = Self::with_axes(Axes::near(first, second), edges);
        if tilted.half_area() < upright.half_area() {
            tilted
        } else {
            upright
        }
    }

    fn with_axes(axes: Axes, edges: &[LocalEdge]) -> Self {
        let duals = axes.duals();
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for end in ends(edges) {
            for i in 0..3 {
                let x = duals[i].dot(end);
                low[i] = if x < low[i] { x } else { low[i] };
                high[i] = if x > high[i] { x } else { high[i] };
            }
        }
        let [a, b, c] = axes.directions();
        let middle = [0, 1, 2].map(|i| 0.5 * (low[i] + high[i]));
        Self {
            axes,
            centre: a * middle[0] + b * middle[1] + c * middle[2],
            half: [0, 1, 2].map(|i| 0.5 * (high[i] - low[i])),
        }
    }

    fn half_area(&self) -> f64 {
        let [x, y, z] = self.half;
        x * y + y * z + z * x
    }
}

fn ends(edges: &[LocalEdge]) -> impl Iterator<Item = Vec3> {
    edges.iter().flat_map(|edge| edge.ends)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(a: [f64; 3], b: [f64; 3]) -> LocalEdge {
        LocalEdge {
            ends: [a.into(), b.into()],
            normals: None,
            open: false,
            groups: 1,
        }
    }

    /// A needle at an angle has a thin box; coordinates along rounded axes are
    /// exact all the same.
    #[test]
    fn needle_has_a_thin_box() {
        let needle = [
            edge([-0.3, -0.2, 0.1], [0.6, 0.5, -0.7]),
            edge([-0.3, -0.2, 0.1], [-0.29, -0.2, 0.1]),
        ];
        let tight = OrientedBox::around(&needle);
        assert!(tight.half[1].max(tight.half[2]) < 0.01, "{tight:?}");
        let duals = tight.axes.duals();
        for end in ends(&needle) {
            for (dual, half) in duals.iter().zip(tight.half) {
                assert!(dual.dot(end - tight.centre).abs() <= half + 1e-15);
            }
        }
    }

    /// Points only: any axes will do.
    #[test]
    fn edges_without_length() {
        let tight = OrientedBox::around(&[edge([0.1; 3], [0.1; 3])]);
        assert!((tight.centre - Vec3::splat(0.1)).length() < 1e-15);
        assert!(tight.half.iter().all(|half| half.abs() < 1e-15));
    }
}
