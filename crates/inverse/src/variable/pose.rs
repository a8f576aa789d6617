//! Where a shape is: turned and scaled about its centre, then moved,
//! `p = c + t + s R(r) (p₀ - c)`. `R(r)` turns about the vector `r` by its length
//! in radians, so that a single number of it is a turn about a world axis.

use std::fmt;

use capwalk_geometry::mesh::LARGEST_COORDINATE;
use capwalk_math::{Affine, Vec3};
use capwalk_scene::{ShadingNormals, Shape, ShapeVectors, vertex_normals};

/// A number of a pose; axes are 0, 1, 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PoseComponent {
    /// A component of the translation `t`.
    Translate(usize),
    /// A component of the rotation vector `r`.
    Rotate(usize),
    /// The scale `s`.
    Scale,
}

/// What a number of a pose can be at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PoseLimit {
    /// A scale of 0 flattens a shape to a point, and one below turns it inside out.
    Scale,
    /// An angle whose sine is still accurate.
    Angle,
    /// A distance over which areas stay finite.
    Distance,
}

impl fmt::Display for PoseLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scale => write!(f, "a scale above 0, of at most {LARGEST_COORDINATE:e}"),
            Self::Angle => write!(f, "an angle of at most {:e} radians", Affine::LARGEST_ANGLE),
            Self::Distance => write!(f, "a distance of at most {LARGEST_COORDINATE:e}"),
        }
    }
}

impl PoseComponent {
    /// The limit that the value is beyond.
    pub(crate) fn exceeded(self, value: f64) -> Option<PoseLimit> {
        let (limit, is_within) = match self {
            Self::Translate(_) => (PoseLimit::Distance, value.abs() <= LARGEST_COORDINATE),
            Self::Rotate(_) => (PoseLimit::Angle, value.abs() <= Affine::LARGEST_ANGLE),
            Self::Scale => (PoseLimit::Scale, value > 0.0 && value <= LARGEST_COORDINATE),
        };
        (!is_within).then_some(limit)
    }
}

/// A pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pose {
    translation: Vec3,
    rotation: Vec3,
    scale: f64,
}

impl Default for Pose {
    fn default() -> Self {
        Self {
            translation: Vec3::zero(),
            rotation: Vec3::zero(),
            scale: 1.0,
        }
    }
}

impl Pose {
    /// Replaces one number.
    pub fn set(&mut self, part: PoseComponent, value: f64) {
        let with = |v: Vec3, axis: usize| {
            let mut numbers = v.to_array();
            numbers[axis] = value;
            Vec3::from(numbers)
        };
        match part {
            PoseComponent::Translate(axis) => self.translation = with(self.translation, axis),
            PoseComponent::Rotate(axis) => self.rotation = with(self.rotation, axis),
            PoseComponent::Scale => self.scale = value,
        }
    }

    fn turned(&self) -> Affine {
        match self.rotation.length() {
            0.0 => Affine::IDENTITY,
            angle => Affine::rotate(self.rotation, angle),
        }
    }

    /// Puts a shape where it belongs, and its matrix with it. `base` is the shape before the
    /// first step.
    pub fn apply(&self, base: &Shape, shape: &mut Shape) {
        let (centre, turned) = (base.centre(), self.turned());
        let scaled = Affine::scale(Vec3::splat(self.scale));
        let moved = Affine::translate(centre + self.translation) * turned * scaled;
        shape.world_from_object = moved * Affine::translate(-centre) * base.world_from_object;
        for (p, &rest) in shape.mesh.positions.iter_mut().zip(&base.mesh.positions) {
            let arm = turned.vector(rest - centre);
            *p = centre + self.translation + arm * self.scale;
        }
        match &mut shape.normals {
            ShadingNormals::Face => {}
            ShadingNormals::Given(normals) => {
                let rest = base.normals.per_vertex().unwrap_or_default();
                for (n, &rest) in normals.iter_mut().zip(rest) {
                    *n = turned.vector(rest).normalized();
                }
            }
            ShadingNormals::Computed(normals) => {
                *normals = vertex_normals(&shape.mesh.positions, &shape.mesh.faces);
            }
        }
    }

    /// How the shape moves when one number changes at this velocity.
    pub fn push(&self, base: &Shape, part: PoseComponent, velocity: f64) -> ShapeVectors {
        let turning = match part {
            PoseComponent::Rotate(axis) => left_jacobian(self.rotation, unit(axis) * velocity),
            PoseComponent::Translate(_) | PoseComponent::Scale => Vec3::zero(),
        };
        let (centre, turned) = (base.centre(), self.turned());
        let moving = |&rest: &Vec3| {
            let arm = turned.vector(rest - centre);
            match part {
                PoseComponent::Translate(axis) => unit(axis) * velocity,
                PoseComponent::Rotate(_) => turning.cross(arm * self.scale),
                PoseComponent::Scale => arm * velocity,
            }
        };
        let given = match &base.normals {
            ShadingNormals::Given(normals) if matches!(part, PoseComponent::Rotate(_)) => {
                Some(normals)
            }
            _ => None,
        };
        let turned_by = |&n: &Vec3| turning.cross(turned.vector(n));
        ShapeVectors {
            vertices: base.mesh.positions.iter().map(moving).collect(),
            normals: given.map(|normals| normals.iter().map(turned_by).collect()),
        }
    }

    /// The derivative with respect to one number, the transpose of [`Pose::push`].
    pub fn pull(&self, base: &Shape, part: PoseComponent, gradient: &ShapeVectors) -> f64 {
        let moving = self.push(base, part, 1.0);
        let dot = |a: &[Vec3], b: &[Vec3]| a.iter().zip(b).map(|(a, &b)| a.dot(b)).sum::<f64>();
        let normals = moving.normals.as_ref().zip(gradient.normals.as_ref());
        dot(&moving.vertices, &gradient.vertices) + normals.map_or(0.0, |(a, b)| dot(a, b))
    }
}

fn unit(axis: usize) -> Vec3 {
    Vec3::from([0, 1, 2].map(|i| if i == axis { 1.0 } else { 0.0 }))
}

/// Below this angle (radians) the coefficients are their series, whose next terms
/// are below rounding.
const SMALL_ANGLE: f64 = 1e-4;

/// The angular velocity, in world axes, of `R(r)` when the vector changes at the
/// velocity `change`: the left Jacobian of rotations,
/// `J(r) = 1 + (1 - cos θ)/θ² [r]× + (θ - sin θ)/θ³ [r]×²`.
pub(crate) fn left_jacobian(r: Vec3, change: Vec3) -> Vec3 {
    let angle = r.length();
    let (a, b) = if angle < SMALL_ANGLE {
        (
            0.5 - angle * angle / 24.0,
            1.0 / 6.0 - angle * angle / 120.0,
        )
    } else {
        let half = (0.5 * angle).sin();
        (
            2.0 * (half / angle).powi(2), // 1 - cos θ = 2 sin² (θ/2)
            (angle - angle.sin()) / angle.powi(3),
        )
    };
    let once = r.cross(change);
    change + once * a + r.cross(once) * b
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `R(r + h v) R(r)⁻¹` turns by `h J v`.
    #[test]
    fn jacobian_is_the_angular_velocity() {
        let rotate = |r: Vec3| Pose {
            rotation: r,
            ..Pose::default()
        };
        let v = Vec3::new(0.3, -0.8, 0.5);
        let p = Vec3::new(0.7, 0.2, -1.1);
        for r in [
            Vec3::new(0.4, -0.2, 0.9),
            Vec3::new(-2.0, 1.5, 0.3),
            Vec3::new(3e-5, 5e-5, -2e-5),
            Vec3::zero(),
        ] {
            let at = |h: f64| rotate(r + v * h).turned().vector(p);
            let difference = (at(1e-6) - at(-1e-6)) / 2e-6;
            let expected = left_jacobian(r, v).cross(at(0.0));
            assert!((difference - expected).length() < 1e-9, "{r:?}");
        }
    }
}
