//! Spheres of near-uniform triangles: a subdivided icosahedron.

use capwalk_math::Vec3;

use crate::mesh::Mesh;

/// The unit sphere with `20 frequency²` faces: each face of an icosahedron cut
/// into `frequency²` triangles, pushed out to the sphere. Closed, vertices
/// shared, faces wound outward. Frequency 1 is the icosahedron, 4 has 320
/// faces. The largest face is twice as large as the smallest.
///
/// # Panics
/// If `frequency` is 0, or so large (14 000) that indices overflow.
pub fn icosphere(frequency: u32) -> Mesh {
    assert!((1..14_000).contains(&frequency), "frequency {frequency}");
    let (corners, faces) = icosahedron();
    let mut mesh = Mesh::default();
    let mut known = Known::new(frequency);
    for face in faces {
        known.forget_inner();
        // The grid point with these weights of the face's corners, in
        // frequency-ths. Points on shared edges are named by their corners and
        // weights in one order, so both faces compute and find the same.
        let mut vertex = |weights: [u32; 3]| {
            let mut name = [0, 1, 2].map(|i| match weights[i] {
                0 => (0, 0),
                w => (w, face[i]),
            });
            name.sort_unstable_by_key(|&(weight, corner)| (corner, weight));
            let vertex = known.vertex(name, weights);
            if *vertex == NONE {
                let point = name.iter().fold(Vec3::zero(), |sum, &(weight, corner)| {
                    sum + corners[corner as usize] * f64::from(weight)
                });
                *vertex = mesh.positions.len() as u32;
                mesh.positions.push(point.normalized());
            }
            *vertex
        };
        for row in 0..frequency {
            // `row` counts from the edge between corners 0 and 1.
            for i in 0..frequency - row {
                let j = frequency - row - i; // at least 1
                let a = vertex([j, i, row]);
                let b = vertex([j - 1, i + 1, row]);
                let c = vertex([j - 1, i, row + 1]);
                mesh.faces.push([a, b, c]);
                if j >= 2 {
                    let d = vertex([j - 2, i + 1, row + 1]);
                    mesh.faces.push([b, d, c]);
                }
            }
        }
    }
    mesh
}

/// No vertex yet.
const NONE: u32 = u32::MAX;

/// Corners of an icosahedron.
const CORNERS: usize = 12;

/// The vertices that have numbers.
struct Known {
    /// One more than there are parts of an edge.
    places: usize,
    corners: [u32; CORNERS],
    /// By the two corners, then by the weight of the first.
    edges: Vec<u32>,
    /// In the face at hand, by the last two weights.
    inner: Vec<u32>,
}

impl Known {
    fn new(frequency: u32) -> Self {
        let places = frequency as usize + 1;
        Self {
            places,
            corners: [NONE; CORNERS],
            edges: vec![NONE; CORNERS * CORNERS * places],
            inner: vec![NONE; places * places],
        }
    }

    fn forget_inner(&mut self) {
        self.inner.fill(NONE);
    }

    /// The vertex with this name, weights with corners in ascending order, those that are zero
    /// first, and these weights in the face at hand.
    fn vertex(&mut self, name: [(u32, u32); 3], [_, i, row]: [u32; 3]) -> &mut u32 {
        let [(w0, _), (w1, a), (_, b)] = name;
        match (w0, w1) {
            (0, 0) => &mut self.corners[b as usize],
            (0, _) => {
                let edge = CORNERS * a as usize + b as usize;
                &mut self.edges[self.places * edge + w1 as usize]
            }
            _ => &mut self.inner[self.places * row as usize + i as usize],
        }
    }
}

/// Corners `(0, ±1, ±φ)` and their cyclic shifts (not normalised), and the 20
/// triples of mutual neighbours, wound outward.
pub(crate) fn icosahedron() -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let phi = 0.5 * (1.0 + 5.0_f64.sqrt());
    let signs = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
    let corners: Vec<Vec3> = signs
        .iter()
        .flat_map(|&(s, t)| {
            let (a, b) = (s, t * phi);
            [
                Vec3::new(0.0, a, b),
                Vec3::new(a, b, 0.0),
                Vec3::new(b, 0.0, a),
            ]
        })
        .collect();
    // Neighbours are 2 apart; the next distance is 2 φ.
    let adjacent = |i: usize, j: usize| (corners[i] - corners[j]).length() < 2.5;
    let mut faces = Vec::with_capacity(20);
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if adjacent(i, j) && adjacent(j, k) && adjacent(k, i) {
                    let outward = corners[i].dot(corners[j].cross(corners[k])) > 0.0;
                    let (j, k) = if outward { (j, k) } else { (k, j) };
                    faces.push([i as u32, j as u32, k as u32]);
                }
            }
        }
    }
    (corners, faces)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_uniformity() {
        for frequency in [1, 2, 3, 4, 7, 20] {
            let mesh = icosphere(frequency);
            let f = frequency as usize;
            assert_eq!(mesh.faces.len(), 20 * f * f);
            // Euler: V = 2 + E - F with E = 3 F / 2.
            assert_eq!(mesh.positions.len(), 2 + 10 * f * f);
            let areas: Vec<f64> = (0..mesh.faces.len())
                .map(|face| 0.5 * mesh.face_cross(face).length())
                .collect();
            let (low, high) = areas
                .iter()
                .fold((f64::INFINITY, 0.0_f64), |(l, h), &a| (l.min(a), h.max(a)));
            assert!(high / low < 2.0, "{frequency}: {}", high / low);
            for face in 0..mesh.faces.len() {
                let [a, b, c] = mesh.corners(face);
                assert!(mesh.face_cross(face).dot(a + b + c) > 0.0);
            }
        }
    }
}
