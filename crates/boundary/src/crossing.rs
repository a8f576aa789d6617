//! Where surfaces pass through each other.
//!
//! The camera sees a jump along the curve in which two faces cross, though no
//! mesh has an edge there. The curve is made of straight pieces, one for each
//! pair of crossing faces, and its motion follows from theirs: a point of it
//! stays in both moving planes. Shadows need none of it, since both faces hide,
//! unless one of them is the emitter.

use std::collections::BTreeMap;

use capwalk_geometry::Ray;
use capwalk_math::Vec3;
use rayon::prelude::*;

use crate::accel::Accel;

/// The piece of curve in which two faces cross, and how it moves; or another piece of
/// a curve on faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Its ends.
    pub ends: [CrossingEnd; 2],
    /// True if emitted light jumps there: if one of the faces belongs to an emitter.
    pub emits: bool,
}

/// An end of a crossing. It stays in the faces that the curve is on and does not move
/// along it, so its velocity depends linearly on those of the faces' vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrossingEnd {
    /// Where it is.
    pub position: Vec3,
    /// What adds to its velocity: each of the faces.
    pub(crate) pulls: [Pull; 2],
}

/// The velocity `column (normal · Σ weight v)` of a face with vertices that
/// move with `v`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pull {
    pub(crate) vertices: [u32; 3],
    pub(crate) weights: [f64; 3],
    pub(crate) normal: Vec3,
    pub(crate) column: Vec3,
}

impl CrossingEnd {
    /// Its velocity, across the curve, for velocities of the joined mesh's
    /// vertices.
    pub fn velocity(&self, velocities: &[Vec3]) -> Vec3 {
        let pull = |pull: &Pull| {
            let vertices = pull.vertices.iter().zip(pull.weights);
            let v = vertices.fold(Vec3::zero(), |sum, (&i, weight)| {
                sum + velocities[i as usize] * weight
            });
            pull.column * pull.normal.dot(v)
        };
        pull(&self.pulls[0]) + pull(&self.pulls[1])
    }

    /// The vertices of the joined mesh that it depends on.
    pub fn vertices(&self) -> impl Iterator<Item = u32> {
        self.pulls.iter().flat_map(|pull| pull.vertices)
    }

    /// The transpose: passes a covector on its velocity on to covectors on the
    /// velocities of the joined mesh's vertices.
    pub fn pull_back(&self, covector: Vec3, covectors: &mut [Vec3]) {
        for pull in &self.pulls {
            let along = pull.normal * pull.column.dot(covector);
            for (&i, weight) in pull.vertices.iter().zip(pull.weights) {
                covectors[i as usize] += along * weight;
            }
        }
    }
}

/// Fraction of an edge at its ends that may touch another face without
/// crossing it: things that stand on each other do not cross. Far less than the
/// fraction by which a hidden point is taken for a visible one, and than the
/// single precision of mesh files, which sinks what should stand: no edge is
/// left out as hidden where no crossing takes its place.
const TOUCHING: f64 = 1e-11;
/// Faces whose unit normals differ by less than this sine lie in each other
/// rather than cross.
const COPLANAR: f64 = 1e-6;

/// All crossings of faces of the joined mesh, in a fixed order.
pub fn crossings(accel: &Accel) -> Vec<Crossing> {
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
            [a, b] => crossing(accel, faces, [a, b]),
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
fn crossing(accel: &Accel, faces: [u32; 2], ends: [Vec3; 2]) -> Option<Crossing> {
    let normals = faces.map(|face| accel.mesh.face_cross(face as usize).normalized());
    let along = normals[0].cross(normals[1]);
    let square = along.length_squared();
    if square.sqrt() < COPLANAR || !square.is_finite() {
        return None;
    }
    // ẋ with n₁·ẋ = n₁·v₁, n₂·ẋ = n₂·v₂, and no motion along the curve.
    let columns = [normals[1].cross(along), along.cross(normals[0])];
    let end = |position: Vec3| CrossingEnd {
        position,
        pulls: [0, 1].map(|k| Pull {
            vertices: accel.mesh.faces[faces[k] as usize],
            weights: weights_on_face(accel, faces[k], position),
            normal: normals[k],
            column: columns[k] / square,
        }),
    };
    Some(Crossing {
        ends: ends.map(end),
        emits: faces.iter().any(|&face| {
            let shape = accel.shape_of_face[face as usize];
            accel.scene.shape(shape).emitter.is_some()
        }),
    })
}

/// Barycentric weights of a point on a face.
fn weights_on_face(accel: &Accel, face: u32, x: Vec3) -> [f64; 3] {
    let [a, b, c] = accel.mesh.corners(face as usize);
    let cross = (b - a).cross(c - a);
    let square = cross.length_squared();
    let wb = (x - a).cross(c - a).dot(cross) / square;
    let wc = (b - a).cross(x - a).dot(cross) / square;
    [1.0 - wb - wc, wb, wc]
}
