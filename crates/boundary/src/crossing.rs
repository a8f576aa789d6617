//! Crossings: the segments along which surfaces intersect each other.
//!
//! Radiance is discontinuous along the intersection of two surfaces, although no mesh has
//! an edge there. Each pair of intersecting triangles gives one segment, and its motion
//! follows from theirs: its points stay in both moving planes. Shadows do not need it,
//! since both triangles occlude, unless one of them emits.

use std::collections::BTreeMap;

use capwalk_geometry::{Halt, Mesh, Ray};
use capwalk_math::Vec3;
use rayon::prelude::*;

use crate::accel::Accel;

/// The segment in which two faces intersect, and how it moves; or a segment of another
/// curve on faces, such as a line of texels or the edge of a hard shadow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Its ends.
    pub ends: [CrossingEnd; 2],
    /// True if emitted radiance is discontinuous there: one of the faces belongs to an
    /// emitter.
    pub emits: bool,
}

/// An end of a crossing. It stays in two planes, those of both faces, and does not move along
/// the segment, so its velocity is a linear function of those of three points of each plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrossingEnd {
    /// World space.
    pub position: Vec3,
    /// What each of the two faces adds to its velocity.
    pub(crate) pulls: [Pull; 2],
}

/// What a plane adds to the velocity of a crossing's end: `column (normal · Σ weight v)`,
/// with `v` the velocities of three points: vertices of the joined mesh, or anchors of lights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pull {
    pub(crate) vertices: [u32; 3],
    pub(crate) weights: [f64; 3],
    pub(crate) normal: Vec3,
    pub(crate) column: Vec3,
}

impl CrossingEnd {
    /// Its velocity, perpendicular to the segment, for the velocities of the vertices of the
    /// joined mesh and of the anchors of lights.
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

    /// The vertices of the joined mesh, and anchors of lights, that it depends on.
    pub fn vertices(&self) -> impl Iterator<Item = u32> {
        self.pulls.iter().flat_map(|pull| pull.vertices)
    }

    /// The transpose of [`CrossingEnd::velocity`]: adds to the covectors of the vertices of
    /// the joined mesh, and of the anchors of lights, what follows from one on this velocity.
    pub fn pull_back(&self, covector: Vec3, covectors: &mut [Vec3]) {
        for pull in &self.pulls {
            let along = pull.normal * pull.column.dot(covector);
            for (&i, weight) in pull.vertices.iter().zip(pull.weights) {
                covectors[i as usize] += along * weight;
            }
        }
    }
}

/// Fraction of an edge, at each of its ends, in which a hit is contact rather than an
/// intersection: things that stand on each other do not cross. Far less than the margin
/// of visibility tests, and than the single precision of mesh files, by which things sink
/// into what they stand on: wherever an edge counts as hidden, there is a crossing in its
/// place.
const TOUCHING: f64 = 1e-11;
/// Sine of the angle between two faces below which they count as coplanar and not as
/// crossing.
const COPLANAR: f64 = 1e-6;

/// All crossings of faces of the joined mesh, in a fixed order; some of them if the work is given
/// up.
pub fn crossings(accel: &Accel, halt: &Halt) -> Vec<Crossing> {
    // Find every point where an edge of one face passes through another face.
    let pierced: Vec<_> = (0..accel.mesh.faces.len() as u32)
        .into_par_iter()
        .flat_map_iter(|face| piercings(accel, face, halt))
        .collect();
    // Collect these points by pairs of faces. Two triangles intersect in a segment, and at
    // each of its ends an edge of one passes through the other.
    let mut pairs: BTreeMap<[u32; 2], Vec<Vec3>> = BTreeMap::new();
    for (face, other, point) in pierced {
        pairs
            .entry([face.min(other), face.max(other)])
            .or_default()
            .push(point);
    }
    pairs
        .into_iter()
        .filter_map(|(faces, points)| {
            let common = common_segment(&accel.mesh, faces)?;
            let ends = match points[..] {
                [a, b] => [a, b],
                // An end at which borders of both meet: rounding says whether an edge passes
                // there, once, twice or not at all.
                _ => common,
            };
            crossing(accel, faces, ends)
        })
        .collect()
}

/// Where the edges of a face pass through other faces: this face, the other, the point.
fn piercings(accel: &Accel, face: u32, halt: &Halt) -> Vec<(u32, u32, Vec3)> {
    let corners = accel.mesh.corners(face as usize);
    let mut found = Vec::new();
    for i in 0..3 {
        let ends = [corners[i], corners[(i + 1) % 3]];
        let mut ray = Ray {
            t_min: TOUCHING,
            t_max: 1.0 - TOUCHING,
            ..Ray::new(ends[0], ends[1] - ends[0])
        };
        // Continue behind each hit up to the end of the edge.
        while !halt.now()
            && let Some(hit) = accel.first_hit_within(&ray)
        {
            let others = accel.mesh.corners(hit.face as usize);
            // Faces that share a vertex with the edge are its neighbours.
            if !others.iter().any(|corner| ends.contains(corner)) {
                found.push((face, hit.face, ray.at(hit.t)));
            }
            ray.t_min = hit.t + TOUCHING;
        }
    }
    found
}

/// The segment that two faces have in common, each of which has corners on both sides of the
/// other; `None` if they are in contact, or apart.
fn common_segment(mesh: &Mesh, faces: [u32; 2]) -> Option<[Vec3; 2]> {
    let normals = faces.map(|face| mesh.face_cross(face as usize).normalized());
    let corners = faces.map(|face| mesh.corners(face as usize));
    let along = normals[0].cross(normals[1]);
    // Where the sides of each face pass through the plane of the other.
    let mut ranges = [[Vec3::zero(); 2]; 2];
    for (i, range) in ranges.iter_mut().enumerate() {
        let heights = corners[i].map(|p| normals[1 - i].dot(p - corners[1 - i][0]));
        let reach = heights.iter().fold(0.0_f64, |reach, h| reach.max(h.abs()));
        let sides = heights.map(|h| {
            let is_off = h.abs() > TOUCHING * reach;
            if is_off { h.signum() } else { 0.0 }
        });
        if !(sides.contains(&1.0) && sides.contains(&-1.0)) {
            return None;
        }
        let mut passed = (0..3).filter_map(|a| {
            let b = (a + 1) % 3;
            let [p, q] = [corners[i][a], corners[i][b]];
            match sides[a] * sides[b] {
                -1.0 => Some(p + (q - p) * (heights[a] / (heights[a] - heights[b]))),
                _ => (sides[a] == 0.0).then_some(p),
            }
        });
        *range = [passed.next()?, passed.next()?];
        range.sort_by(|a, b| along.dot(*a).total_cmp(&along.dot(*b)));
    }
    // Both lie on one line: what they share of it.
    let later = |a: Vec3, b: Vec3| if along.dot(a) > along.dot(b) { a } else { b };
    let earlier = |a: Vec3, b: Vec3| if along.dot(a) > along.dot(b) { b } else { a };
    let [from, to] = [
        later(ranges[0][0], ranges[1][0]),
        earlier(ranges[0][1], ranges[1][1]),
    ];
    let longest = ranges
        .map(|[a, b]| (b - a).length())
        .into_iter()
        .fold(0.0, f64::max);
    let is_long = along.dot(to - from) > TOUCHING * longest * along.length();
    is_long.then_some([from, to])
}

/// The crossing of two faces between two points; `None` if the faces are coplanar.
fn crossing(accel: &Accel, faces: [u32; 2], ends: [Vec3; 2]) -> Option<Crossing> {
    let planes = faces.map(|face| CrossingPlane::of_face(&accel.mesh, face, ends));
    let emits = faces.iter().any(|&face| {
        let shape = accel.shape_of_face[face as usize];
        accel.scene.shape(shape).emitter.is_some()
    });
    crossing_of_planes(planes, ends, emits)
}

/// A plane through three points of the boundaries that move, and what it is at two places.
pub(crate) struct CrossingPlane {
    /// The points.
    pub(crate) vertices: [u32; 3],
    /// The velocity of the plane, across itself, is that of the sum of the points with these
    /// weights; one triple for each place.
    pub(crate) weights: [[f64; 3]; 2],
    /// Unit normal.
    pub(crate) normal: Vec3,
}

impl CrossingPlane {
    /// The plane of a face of the joined mesh.
    pub(crate) fn of_face(mesh: &Mesh, face: u32, places: [Vec3; 2]) -> Self {
        Self {
            vertices: mesh.faces[face as usize],
            weights: places.map(|x| mesh.weights_on_face(face as usize, x)),
            normal: mesh.face_cross(face as usize).normalized(),
        }
    }
}

/// The segment between two points in which two planes intersect; `None` if they are the same.
pub(crate) fn crossing_of_planes(
    planes: [CrossingPlane; 2],
    ends: [Vec3; 2],
    emits: bool,
) -> Option<Crossing> {
    let normals = [planes[0].normal, planes[1].normal];
    let along = normals[0].cross(normals[1]);
    let square = along.length_squared();
    if square.sqrt() < COPLANAR || !square.is_finite() {
        return None;
    }
    // Solve n₁·ẋ = n₁·v₁, n₂·ẋ = n₂·v₂ and (n₁ × n₂)·ẋ = 0 for the velocity ẋ of the point,
    // with v₁ and v₂ the velocities of the planes there. With s = n₁ × n₂, the solution is
    // ẋ = [(n₂ × s) (n₁·v₁) + (s × n₁) (n₂·v₂)] / |s|².
    let columns = [normals[1].cross(along), along.cross(normals[0])];
    let end = |i: usize| CrossingEnd {
        position: ends[i],
        pulls: [0, 1].map(|k| Pull {
            vertices: planes[k].vertices,
            weights: planes[k].weights[i],
            normal: normals[k],
            column: columns[k] / square,
        }),
    };
    Some(Crossing {
        ends: [end(0), end(1)],
        emits,
    })
}

#[cfg(test)]
mod tests {
    use capwalk_scene::Scene;

    use super::*;

    /// A wall through a floor of the same width: their borders meet at both ends of the line, of
    /// which nothing is missing. Not where it stands on the floor.
    #[test]
    fn crossings_reach_common_borders() {
        let floor: Scene = capwalk_scene::builtin::scene("leaf").expect("built in");
        let across = |half_width: f64, foot: f64| {
            let mut scene = floor.clone();
            let shapes = &mut scene.shapes;
            let place = |x: f64, y: f64, z: f64| Vec3::new(0.3 + x, -0.2 + y, 0.7 + z);
            let quad = |corners: [Vec3; 4]| Mesh {
                positions: corners.to_vec(),
                faces: vec![[0, 1, 2], [0, 2, 3]],
            };
            let lying = [(-3.0, -2.0), (3.0, -2.0), (3.0, 4.0), (-3.0, 4.0)];
            let w = half_width;
            let standing = [(-w, foot), (w, foot), (w, 5.0), (-w, 5.0)];
            let meshes = [
                quad(lying.map(|(x, y)| place(x, y, 0.0))),
                quad(standing.map(|(x, z)| place(x, 0.31, z))),
            ];
            for (shape, mesh) in shapes.iter_mut().zip(meshes) {
                std::sync::Arc::make_mut(shape).mesh = mesh;
            }
            // All others are elsewhere.
            for shape in &mut shapes[2..] {
                let positions = &mut std::sync::Arc::make_mut(shape).mesh.positions;
                positions.iter_mut().for_each(|p| p.z += 100.0);
            }
            let found = crossings(&Accel::new(scene), &Halt::never());
            let ends = found.iter().map(|c| c.ends.map(|end| end.position));
            ends.map(|[a, b]| (b - a).length()).sum::<f64>()
        };
        for half_width in [2.5, 2.999, 3.0] {
            let length = across(half_width, -1.0);
            assert!(
                (length - 2.0 * half_width).abs() < 1e-9,
                "{half_width}: {length}"
            );
            assert_eq!(across(half_width, 0.0), 0.0, "{half_width}");
        }
    }
}
