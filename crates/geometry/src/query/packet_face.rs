//! Triangles and parallelograms for packets of rays, as linear functions of a point.
//!
//! Two triangles that make a parallelogram have one plane and the same two weights, so they are
//! asked as one: rooms of rectangles have half as many faces for it. Of faces that lie on each
//! other in one plane either may be found: how two are paired decides the last bit of distances.

use capwalk_math::Vec3;

use super::local_packet::LocalPacket;
use super::packet_precision::{IN_PLANE, MOST_OUT};
use crate::local_frame::LocalFrame;
use crate::mesh::Mesh;
use crate::simd::{F32x16, Lanes, Simd};

/// The fourth corner of a parallelogram is off by less than this part of [`IN_PLANE`].
const OFF_CORNER: f64 = 1e-3;

/// A triangle, or two that make a parallelogram, as linear functions of a point in the tree's
/// coordinates: factors of its coordinates, and a constant.
#[derive(Clone, Copy, Debug)]
pub struct PacketFace {
    height: [f32; 4],
    /// The weights of the second and third corner, plus what they may be off by.
    second: [f32; 4],
    third: [f32; 4],
    /// The largest sum of both in the triangle, or in the first of two.
    most: f32,
    /// The number of the face: exact, because there are fewer than 2²⁴.
    face: f32,
    /// Beyond that sum in a parallelogram.
    beyond: Option<Beyond>,
}

/// The planes in which rays meet faces.
pub struct Met<S: Simd> {
    /// Distances along the rays.
    pub distance: S::F32x16,
    /// The heights above the plane at which they start, and by how much they rise.
    pub height: S::F32x16,
    pub rise: S::F32x16,
    /// One bit for each that meets the plane and does not start in it.
    pub mask: u32,
}

/// The second triangle of a parallelogram.
#[derive(Clone, Copy, Debug)]
struct Beyond {
    face: f32,
    /// The largest weights.
    most: [f32; 2],
}

impl PacketFace {
    /// Some faces of a mesh, and for each face of it its number among them; those without area have
    /// none.
    pub fn all(mesh: &Mesh, some: &[u32], frame: &LocalFrame) -> (Vec<Self>, Vec<Option<u32>>) {
        let corners_of = |&face: &u32| mesh.corners(face as usize);
        let local = |corners: [Vec3; 3]| corners.map(|p| frame.local_from_world(p));
        let corners: Vec<_> = some.iter().map(corners_of).map(local).collect();
        let mut numbers = vec![None; mesh.faces.len()];
        let mut all = Vec::new();
        for (i, &face) in some.iter().enumerate() {
            let face = face as usize;
            if numbers[face].is_some() {
                continue;
            }
            let others = some.iter().zip(&corners).skip(i + 1);
            let mut pairs = others.filter_map(|(&other, &their)| {
                let other = other as usize;
                let is_free = numbers[other].is_none();
                let turned = is_free.then(|| parallelogram(corners[i], their))??;
                Some((turned, Some(other)))
            });
            let (corners, other) = pairs.next().unwrap_or((corners[i], None));
            if let Some(made) = Self::new(corners, face, other) {
                let number = Some(all.len() as u32);
                numbers[face] = number;
                other.into_iter().for_each(|other| numbers[other] = number);
                all.push(made);
            }
        }
        (all, numbers)
    }

    /// A face with its corners, and another one beyond the side between the second and third.
    fn new([a, b, c]: [Vec3; 3], face: usize, other: Option<usize>) -> Option<Self> {
        let (second, third) = (b - a, c - a);
        let cross = second.cross(third);
        let squared = cross.length_squared();
        let normal = cross / squared.sqrt();
        // The gradients of the weights: across the other side, in the plane.
        let along = [third.cross(cross) / squared, cross.cross(second) / squared];
        let has_area = along.iter().all(|gradient| gradient.is_finite()) && squared > 0.0;
        has_area.then(|| {
            let function = |gradient: Vec3, more: f64| {
                let [x, y, z] = gradient.to_array();
                [x, y, z, more - gradient.dot(a)].map(|number| number as f32)
            };
            let sides = [along[0], along[1], along[0] + along[1]];
            let [ab, bc, ca] = [b - a, c - b, a - c].map(Vec3::normalized);
            // Twice the sines of half of the angles.
            let sines = [ab + ca, bc + ab, ca + bc].map(Vec3::length);
            let sharpest = 0.5 * sines.into_iter().fold(2.0, f64::min);
            let out = f64::from(IN_PLANE) * (MOST_OUT * sharpest).min(1.0);
            let margins = sides.map(|gradient| out * gradient.length());
            let beyond = other.map(|other| Beyond {
                face: other as f32,
                most: [0, 1].map(|k| (1.0 + 2.0 * margins[k]) as f32),
            });
            // Only a triangle that ends there is larger by a margin.
            let outside = match beyond {
                Some(_) => 0.0,
                None => margins[2],
            };
            Self {
                height: function(normal, 0.0),
                second: function(along[0], margins[0]),
                third: function(along[1], margins[1]),
                most: (1.0 + margins[0] + margins[1] + outside) as f32,
                face: face as f32,
                beyond,
            }
        })
    }

    /// Where rays meet its plane.
    #[inline(always)]
    pub fn plane<S: Simd>(&self, simd: S, rays: &LocalPacket<S>) -> Met<S> {
        let height = value(simd, &self.height, rays.origin);
        let rise = growth(simd, &self.height, rays.direction);
        let zero = simd.splat_16(0.0);
        let distance = (zero - height) / rise;
        Met {
            distance,
            height,
            rise,
            mask: simd.splat_16(IN_PLANE).lt(height.abs()) & zero.lt(distance),
        }
    }

    /// Which face of this one the rays meet at distances along them, and one bit for each that
    /// meets one.
    #[inline(always)]
    pub fn at<S: Simd>(
        &self,
        simd: S,
        rays: &LocalPacket<S>,
        distance: S::F32x16,
    ) -> (S::F32x16, u32) {
        let place = rays.at(distance);
        let second = value(simd, &self.second, place);
        let third = value(simd, &self.third, place);
        let zero = simd.splat_16(0.0);
        let positive = zero.le(second) & zero.le(third);
        let is_first = (second + third).le(simd.splat_16(self.most));
        let face = simd.splat_16(self.face);
        match self.beyond {
            None => (face, positive & is_first),
            Some(beyond) => {
                let [second_most, third_most] = beyond.most.map(|most| simd.splat_16(most));
                let is_inside = positive & second.le(second_most) & third.le(third_most);
                (
                    simd.splat_16(beyond.face).replaced(is_first, face),
                    is_inside,
                )
            }
        }
    }
}

/// The corners of a triangle in such an order that another one is beyond the side between the
/// second and third, and both make a parallelogram; `None` if they do not.
fn parallelogram(one: [Vec3; 3], other: [Vec3; 3]) -> Option<[Vec3; 3]> {
    let most = OFF_CORNER * f64::from(IN_PLANE);
    let place = |p: Vec3| {
        let mut places = other.iter();
        places.position(|&q| (p - q).length_squared() < most * most)
    };
    let [a, b, c] = one;
    // Most pairs have no corner in common.
    let places = one.map(place);
    let [a, b, c] = match places {
        [None, Some(_), Some(_)] => [a, b, c],
        [Some(_), None, Some(_)] => [b, c, a],
        [Some(_), Some(_), None] => [c, a, b],
        _ => return None,
    };
    let mut found = [b, c, b + c - a].map(place);
    found.sort_unstable();
    // All three of the other's corners, each once.
    (found == [Some(0), Some(1), Some(2)]).then_some([a, b, c])
}

/// A linear function at points.
#[inline(always)]
fn value<S: Simd>(simd: S, function: &[f32; 4], [x, y, z]: [S::F32x16; 3]) -> S::F32x16 {
    let [fx, fy, fz, constant] = [0, 1, 2, 3].map(|i| simd.splat_16(function[i]));
    fx.fused(x, fy.fused(y, fz.fused(z, constant)))
}

/// How it grows along vectors.
#[inline(always)]
fn growth<S: Simd>(simd: S, function: &[f32; 4], [x, y, z]: [S::F32x16; 3]) -> S::F32x16 {
    let [fx, fy, fz] = [0, 1, 2].map(|i| simd.splat_16(function[i]));
    fx.fused(x, fy.fused(y, fz * z))
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: Vec3<f64> = Vec3::new(0.1, 0.2, 0.3);
    const B: Vec3<f64> = Vec3::new(0.9, 0.3, 0.1);
    const C: Vec3<f64> = Vec3::new(0.2, 0.7, 0.4);

    /// Whichever diagonal two triangles have, and whatever their first corners and windings; not
    /// if they lie on each other, or the fourth corner is off, or the other one is small.
    #[test]
    fn pairs_make_parallelograms() {
        let d = B + C - A;
        let turned = |[a, b, c]: [Vec3; 3]| [[a, b, c], [b, c, a], [c, a, b], [a, c, b]];
        for one in turned([A, B, C]) {
            for other in turned([d, C, B]) {
                let [a, b, c] = parallelogram(one, other).expect("a parallelogram");
                assert_eq!(a, A);
                assert!([b, c] == [B, C] || [b, c] == [C, B]);
            }
            for other in turned(one) {
                assert_eq!(parallelogram(one, other), None);
            }
            let off = d + Vec3::splat(1e-8);
            assert_eq!(parallelogram(one, [off, C, B]), None);
            assert_eq!(parallelogram(one, [A + C - B, C, B]), None);
            let near = [0.0, 1e-12, 2e-12].map(|x| B + Vec3::splat(x));
            assert_eq!(parallelogram(one, near), None);
        }
    }
}
