//! The edges of an edge sampler, and from where they are silhouettes.

use std::f64::consts::PI;

use capwalk_geometry::edge::separates;
use capwalk_geometry::{Edge, Mesh, Sides};
use capwalk_math::Vec3;

use crate::accel::Accel;

/// Share of their length that counts of edges which surfaces nearly always hide: the concave
/// ones of closed surfaces, which are silhouettes only where one looks through the surface.
const CONCAVE: f64 = 0.02;

/// Least share that counts of any edge: flat ones are silhouettes only in the plane of the
/// viewpoint.
const LEAST_SHARE: f64 = 1e-6;

/// Share of all viewpoints from which a crease is visible.
const CREASE_SHARE: f64 = 0.5;

/// An edge and what decides from where it is a silhouette.
#[derive(Clone, Copy, Debug)]
pub struct SampledEdge {
    /// Its number.
    pub edge: u32,
    /// Its ends, points of the boundaries.
    pub points: [u32; 2],
    /// Where they are.
    pub ends: [Vec3; 2],
    /// Normals of its faces, of any length; `None` if it always counts.
    crosses: Option<[Vec3; 2]>,
    /// True if the second one counts reversed.
    flipped: bool,
    /// Its length times the share of all viewpoints from which it is a silhouette, and not hidden
    /// by its own surface, roughly. Creases have a share by their contrast.
    pub weight: f64,
    /// What that is of those from which it is a silhouette.
    pub exposure: f64,
    /// How large the discontinuity is where it is no silhouette, at most 1, roughly; 0 if it
    /// does not count then.
    pub crease: f64,
}

/// For each shape whether its normals point outward, if it is closed.
pub fn outward(edges: &[Edge], accel: &Accel) -> Vec<Option<bool>> {
    let count = accel.scene.shapes.len();
    let mut is_closed = vec![true; count];
    for edge in edges {
        if !matches!(edge.sides, Sides::Between { flipped: false, .. }) {
            is_closed[accel.shape_of_vertex(edge.vertices[0]).0 as usize] = false;
        }
    }
    // Six times the volume, by the divergence theorem.
    let mut volumes = vec![0.0; count];
    for (face, shape) in accel.shape_of_face.iter().enumerate() {
        let [a, b, c] = accel.mesh.corners(face);
        volumes[shape.0 as usize] += a.cross(b).dot(c);
    }
    let shapes = is_closed.into_iter().zip(volumes);
    shapes
        .map(|(is_closed, volume)| is_closed.then_some(volume > 0.0))
        .collect()
}

impl SampledEdge {
    /// An edge between two places. `outward` is that of its shape.
    pub fn new(
        number: u32,
        edge: &Edge,
        ends: [Vec3; 2],
        mesh: &Mesh,
        outward: Option<bool>,
        crease: f64,
    ) -> Self {
        let mut sampled = Self {
            edge: number,
            points: edge.vertices,
            ends,
            crosses: None,
            flipped: false,
            weight: (ends[1] - ends[0]).length(),
            exposure: 1.0,
            crease,
        };
        if let Sides::Between { faces, flipped } = edge.sides {
            let crosses = faces.map(|face| mesh.face_cross(face as usize));
            sampled.crosses = Some(crosses);
            sampled.flipped = flipped;
            let [first, second] = sampled.normals().map(|normal| normal.expect("of a face"));
            // The faces turn by this angle, and between their planes are the viewpoints.
            let turn = first.cross(second).length().atan2(first.dot(second));
            let third = mesh.faces[faces[1] as usize].into_iter();
            let third = third.map(|i| first.dot(mesh.positions[i as usize] - ends[0]));
            let height = third.fold(0.0, |height: f64, h| match h.abs() > height.abs() {
                true => h,
                false => height,
            });
            let is_hidden = outward.is_some_and(|outward| (height > 0.0) == outward);
            sampled.exposure = if is_hidden { CONCAVE } else { 1.0 };
            let share = sampled.exposure * turn / PI;
            sampled.weight *= share.max(CREASE_SHARE * crease).max(LEAST_SHARE);
        }
        sampled
    }

    /// Unit normals of its faces, as if both were wound alike.
    pub fn normals(&self) -> [Option<Vec3>; 2] {
        let normals = self.crosses.map(|[first, second]| {
            let second = if self.flipped { -second } else { second };
            [first.normalized(), second.normalized()]
        });
        normals.map_or([None; 2], |normals| normals.map(Some))
    }

    /// Normals of its faces, of any length, as if both were wound alike; zero if it always
    /// counts.
    pub fn outward_crosses(&self) -> [Vec3; 2] {
        let [first, second] = self.crosses.unwrap_or([Vec3::zero(); 2]);
        [first, if self.flipped { -second } else { second }]
    }

    /// What [`Edge::is_silhouette`] says.
    #[inline]
    pub fn is_silhouette(&self, viewpoint: Vec3) -> bool {
        let is_between = |crosses| separates(crosses, self.ends[0], self.flipped, viewpoint);
        self.crosses.is_none_or(is_between)
    }

    /// The point between its ends.
    pub fn middle(&self) -> Vec3 {
        (self.ends[0] + self.ends[1]) * 0.5
    }
}
