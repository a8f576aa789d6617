//! One edge: whether it is a silhouette, and its closest direction.

use capwalk_math::{Vec3, sphere};

use crate::mesh::Mesh;

/// An edge of a mesh and what lies on its sides. Coplanar neighbours have no
/// edge between them: it could never be a boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Its two end points, as vertex indices of the mesh.
    pub vertices: [u32; 2],
    /// What lies on its sides.
    pub sides: Sides,
    /// Bits that a query can select edges by (see `ConeQuery::groups`).
    pub groups: u8,
}

/// The faces at an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sides {
    /// One face, more than two, or a degenerate one: always a boundary.
    Open,
    /// Two faces: a silhouette where one is seen from the front and the other
    /// from behind.
    Between {
        /// The two faces.
        faces: [u32; 2],
        /// True if they are wound against each other, so that the second one's
        /// normal counts reversed.
        flipped: bool,
    },
}

/// A face whose plane passes the eye within this fraction of the coordinates'
/// size counts as seen from the front: it is the face the eye lies on, whose
/// orientation test would be 0/0 (METHOD 1). Ray hits in double precision stay
/// within some 1e-14 of it.
pub const ON_PLANE: f64 = 1e-11;

/// True if the eye sees the front of the face, or lies in its plane.
#[inline]
pub fn faces_eye(mesh: &Mesh, face: u32, flipped: bool, eye: Vec3) -> bool {
    let a = mesh.positions[mesh.faces[face as usize][0] as usize];
    let cross = mesh.face_cross(face as usize);
    let height = cross.dot(eye - a);
    let size = eye.x.abs() + eye.y.abs() + eye.z.abs() + a.x.abs() + a.y.abs() + a.z.abs();
    if height.abs() <= ON_PLANE * size * cross.length() {
        return true;
    }
    (height > 0.0) != flipped
}

impl Edge {
    /// True if the visible surface ends or folds at this edge seen from `eye`.
    #[inline]
    pub fn is_silhouette(&self, mesh: &Mesh, eye: Vec3) -> bool {
        match self.sides {
            Sides::Open => true,
            Sides::Between { faces, flipped } => {
                faces_eye(mesh, faces[0], false, eye) != faces_eye(mesh, faces[1], flipped, eye)
            }
        }
    }
}

/// The direction on a segment closest to an axis, as seen from the origin.
#[derive(Clone, Copy, Debug)]
pub struct ClosestDirection {
    /// Position along the segment, 0 at `a`, 1 at `b`.
    pub t: f64,
    /// Unit direction of that point.
    pub direction: Vec3,
    /// Distance of that point.
    pub distance: f64,
    /// Its angle to the axis, radians.
    pub angle: f64,
}

/// The point of the segment `a b` (relative to the eye) under the smallest
/// angle to the unit vector `axis`, Eq. (30); `None` if the segment passes
/// through the eye.
pub fn closest_direction(a: Vec3, b: Vec3, axis: Vec3) -> Option<ClosestDirection> {
    let along = b - a;
    let normal = a.cross(along); // of the plane of the great circle
    // The plane through axis and normal meets the segment's line where the
    // angle is least: (a + t along) · (axis × normal) = 0.
    let w = axis.cross(normal);
    let t = -a.dot(w) / along.dot(w);
    let at = |t: f64| {
        let point = if t == 1.0 { b } else { a + along * t };
        let distance = point.length();
        let direction = point / distance;
        let angle = sphere::angle_between(axis, direction);
        ClosestDirection {
            t,
            direction,
            distance,
            angle,
        }
    };
    // Also covers the segment seen end-on (NaN) and the line's far branch,
    // whose point lies behind the eye.
    let mut best = at(0.0);
    let end = at(1.0);
    if end.angle < best.angle {
        best = end;
    }
    if t > 0.0 && t < 1.0 {
        let inner = at(t);
        if inner.angle < best.angle {
            best = inner;
        }
    }
    best.angle.is_finite().then_some(best)
}
