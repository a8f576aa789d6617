//! Where surfaces pass through each other.
//!
//! The camera sees a jump along the curve in which two faces cross, though no
//! mesh has an edge there. The curve is made of straight pieces, one for each
//! pair of crossing faces, and its motion follows from theirs: a point of it
//! stays in both moving planes. Shadows need none of it, since both faces hide,
//! unless one of them is the lamp.

use std::collections::BTreeMap;

use capwalk_geometry::Ray;
use capwalk_math::Vec3;
use rayon::prelude::*;

use crate::accel::Accel;

/// The piece of curve in which two faces cross, and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Its ends.
    pub ends: [Vec3; 2],
    /// The velocities of its ends, across the curve.
    pub velocities: [Vec3; 2],
    /// True if one of the faces belongs to a lamp.
    pub emits: bool,
}

/// Fraction of an edge at its ends that may touch another face without
/// crossing it: things that stand on each other do not cross.
const TOUCHING: f64 = 1e-7;
/// Faces whose unit normals differ by less than this sine lie in each other
/// rather than cross.
const COPLANAR: f64 = 1e-6;

/// All crossings of faces of the joined mesh, for the given velocities of its
/// vertices, in a fixed order.
pub fn crossings(accel: &Accel, velocities: &[Vec3]) -> Vec<Crossing> {
    let pierced: Vec<_> = (0..accel.mesh.faces.len() as u32)
        .into_par_iter()
        .flat_map_iter(|face| piercings(accel, face))
        .collect();
    // Two faces cross in a segment; at its ends an edge of one of them pierces
    // the other.
    let mut pairs: BTreeMap<[u32; 2], Vec<Vec3>> = BTreeMap::new();
    for (face, other, point) in pierced {
        pairs
            .entry([face.min(other), face.max(other)])
            .or_default()
            .push(point);
    }
    pairs
        .into_iter()
        .filter_map(|(faces, points)| match points[..] {
            [a, b] => crossing(accel, velocities, faces, [a, b]),
            // Touching, not crossing.
            _ => None,
        })
        .collect()
}

/// Where the edges of a face pierce other faces: the face, the other, the
/// point.
fn piercings(accel: &Accel, face: u32) -> Vec<(u32, u32, Vec3)> {
    let corners = accel.mesh.corners(face as usize);
    let mut found = Vec::new();
    for i in 0..3 {
        let ends = [corners[i], corners[(i + 1) % 3]];
        let mut ray = Ray {
            t_min: TOUCHING,
            t_max: 1.0 - TOUCHING,
            ..Ray::new(ends[0], ends[1] - ends[0])
        };
        while let Some(hit) = accel.first_hit_within(&ray) {
            let others = accel.mesh.corners(hit.face as usize);
            // Neighbours share the ends of the edge.
            if !others.iter().any(|corner| ends.contains(corner)) {
                found.push((face, hit.face, ray.at(hit.t)));
            }
            ray.t_min = hit.t + TOUCHING;
        }
    }
    found
}

/// The crossing of two faces between two points, if they are not coplanar.
fn crossing(
    accel: &Accel,
    velocities: &[Vec3],
    faces: [u32; 2],
    ends: [Vec3; 2],
) -> Option<Crossing> {
    let normals = faces.map(|face| accel.mesh.face_cross(face as usize).normalized());
    let along = normals[0].cross(normals[1]);
    let square = along.length_squared();
    if square.sqrt() < COPLANAR || !square.is_finite() {
        return None;
    }
    // ẋ with n₁·ẋ = n₁·v₁, n₂·ẋ = n₂·v₂, and no motion along the curve.
    let velocity = |x: Vec3| {
        let [first, second] = [0, 1].map(|k| {
            let v = velocity_on_face(accel, velocities, faces[k], x);
            normals[k].dot(v)
        });
        let in_first = normals[1].cross(along) * first;
        let in_second = along.cross(normals[0]) * second;
        (in_first + in_second) / square
    };
    Some(Crossing {
        ends,
        velocities: ends.map(velocity),
        emits: faces.iter().any(|&face| {
            let shape = accel.shape_of_face[face as usize];
            accel.scene.shape(shape).emitter.is_some()
        }),
    })
}

/// Velocity of the material at a point of a face.
fn velocity_on_face(accel: &Accel, velocities: &[Vec3], face: u32, x: Vec3) -> Vec3 {
    let [a, b, c] = accel.mesh.corners(face as usize);
    let [va, vb, vc] = accel.mesh.faces[face as usize].map(|i| velocities[i as usize]);
    let cross = (b - a).cross(c - a);
    let square = cross.length_squared();
    let wb = (x - a).cross(c - a).dot(cross) / square;
    let wc = (b - a).cross(x - a).dot(cross) / square;
    va + (vb - va) * wb + (vc - va) * wc
}
