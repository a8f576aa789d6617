//! Edges and the faces at them, welded by position.
//!
//! Seams in normals or texture coordinates duplicate vertices; the surface
//! does not end there. So vertices with bitwise equal positions are one.
//!
//! # What a motion of the vertices can invalidate
//!
//! Which faces meet where, how they are wound, and the order of the list follow
//! from the indices. Positions decide three things, and a motion can change each:
//!
//! - Which vertices are one. Copies that move apart open the surface between them;
//!   vertices that come to lie at one place close it.
//! - Which faces have an area. One that loses it becomes a hole with open edges
//!   around it, one that gains it fills a hole.
//! - Which neighbours are coplanar. An edge appears where coplanar neighbours bend,
//!   and disappears where neighbours become coplanar.
//!
//! (What `differ` in [`edges_with`] says may depend on positions, too.) Whether an
//! old list still holds is therefore asked by listing the edges anew and comparing:
//! `edges(&moved) == old`. This takes linear time but for a sort of the positions, a
//! sixth of the time of [`SilhouetteTree::refit`](crate::SilhouetteTree::refit), and
//! cannot disagree with what a new scene would have. If the lists are equal the tree
//! can be refitted; else it has to be built for the new list.

use capwalk_math::Vec3;
use rayon::prelude::*;

use crate::edge::{Edge, Sides};
use crate::mesh::Mesh;

/// Neighbours whose normals differ by less than this sine (radians) are
/// coplanar. Rounding to single precision tilts the halves of a quad by about
/// 1e-7; a real crease this faint changes the shading by as little.
pub const COPLANAR: f64 = 1e-6;

/// Fewer items than this are not worth a task.
const PARALLEL_MINIMUM: usize = 2048;

/// One side of a face, as a way from one welded vertex to another.
#[derive(Clone, Copy)]
struct HalfEdge {
    /// The larger of the two welded vertices. The smaller is known by where
    /// the half-edge is kept.
    larger: u32,
    /// Three times the face, plus which of its sides.
    side: u32,
    /// True if it leads from the smaller to the larger vertex.
    ascends: bool,
}

/// The edges of one mesh that can be boundaries, with `groups = u8::MAX`, in
/// the order in which the faces first mention them. Coplanar neighbours have
/// none between them unless they are wound against each other (what is seen
/// changes from front to back), degenerate faces (no area) count as holes.
pub fn edges(mesh: &Mesh) -> Vec<Edge> {
    edges_with(mesh, |_| false)
}

/// [`edges`], with the edges between those pairs of coplanar faces for which
/// `differ` says so: something else than their plane changes between them.
pub fn edges_with(mesh: &Mesh, differ: impl Fn([u32; 2]) -> bool + Sync) -> Vec<Edge> {
    let welded = weld(&mesh.positions);
    // Zero for degenerate faces.
    let normals: Vec<Vec3> = (0..mesh.faces.len())
        .into_par_iter()
        .with_min_len(PARALLEL_MINIMUM)
        .map(|face| {
            let cross = mesh.face_cross(face);
            if cross == Vec3::zero() {
                cross
            } else {
                cross.normalized()
            }
        })
        .collect();
    let (starts, mut half_edges) = half_edges_by_smaller_vertex(mesh, &welded, &normals);

    // Within a vertex, the uses of one edge become neighbours, by face.
    let mut vertices: Vec<&mut [HalfEdge]> = Vec::with_capacity(starts.len());
    let mut rest = half_edges.as_mut_slice();
    for ends in starts.windows(2) {
        let (uses, others) = rest.split_at_mut((ends[1] - ends[0]) as usize);
        vertices.push(uses);
        rest = others;
    }
    let mut found: Vec<(u32, Edge)> = vertices
        .into_par_iter()
        .with_min_len(PARALLEL_MINIMUM)
        .flat_map_iter(|uses| {
            uses.sort_unstable_by_key(|half_edge| (half_edge.larger, half_edge.side));
            uses.chunk_by(|a, b| a.larger == b.larger)
                .filter_map(|uses| Some((uses[0].side, edge_of(mesh, &normals, uses, &differ)?)))
        })
        .collect();
    found.par_sort_unstable_by_key(|&(first_side, _)| first_side);
    found.into_iter().map(|(_, edge)| edge).collect()
}

/// The half-edges of all faces with an area, and where those of each vertex
/// start.
fn half_edges_by_smaller_vertex(
    mesh: &Mesh,
    welded: &[u32],
    normals: &[Vec3],
) -> (Vec<u32>, Vec<HalfEdge>) {
    let for_each = |visit: &mut dyn FnMut(u32, HalfEdge)| {
        for (face, corners) in mesh.faces.iter().enumerate() {
            if normals[face] == Vec3::zero() {
                continue;
            }
            for i in 0..3 {
                let [a, b] = [corners[i], corners[(i + 1) % 3]].map(|v| welded[v as usize]);
                if a != b {
                    let half_edge = HalfEdge {
                        larger: a.max(b),
                        side: (3 * face + i) as u32,
                        ascends: a < b,
                    };
                    visit(a.min(b), half_edge);
                }
            }
        }
    };
    // Counting sort.
    let mut starts = vec![0; mesh.positions.len() + 1];
    for_each(&mut |smaller, _| starts[smaller as usize + 1] += 1);
    for vertex in 1..starts.len() {
        starts[vertex] += starts[vertex - 1];
    }
    let unset = HalfEdge {
        larger: 0,
        side: 0,
        ascends: false,
    };
    let mut sorted = vec![unset; starts[mesh.positions.len()] as usize];
    let mut next = starts.clone();
    for_each(&mut |smaller, half_edge| {
        let slot = &mut next[smaller as usize];
        sorted[*slot as usize] = half_edge;
        *slot += 1;
    });
    (starts, sorted)
}

/// The edge with these uses; `None` if nothing changes across it.
fn edge_of(
    mesh: &Mesh,
    normals: &[Vec3],
    uses: &[HalfEdge],
    differ: &impl Fn([u32; 2]) -> bool,
) -> Option<Edge> {
    let first = uses[0].side as usize;
    let corners = mesh.faces[first / 3];
    let sides = match uses {
        [a, b] => {
            let faces = [a.side / 3, b.side / 3];
            let flipped = a.ascends == b.ascends;
            let same_plane = coplanar(faces.map(|face| normals[face as usize]));
            if same_plane && !flipped && !differ(faces) {
                return None;
            }
            Sides::Between { faces, flipped }
        }
        _ => Sides::Open,
    };
    Some(Edge {
        vertices: [corners[first % 3], corners[(first + 1) % 3]],
        sides,
        groups: u8::MAX,
    })
}

/// For each vertex, the first vertex with the same position.
pub fn weld(positions: &[Vec3]) -> Vec<u32> {
    // Adding 0 makes -0 and 0 the same.
    let key = |p: &Vec3| p.to_array().map(|c| (c + 0.0).to_bits());
    let mut sorted: Vec<([u64; 3], u32)> = positions.iter().map(key).zip(0..).collect();
    // Not in parallel: callers are on threads of their own, outside of any pool.
    sorted.sort_unstable();
    let mut first = vec![0; positions.len()];
    for same in sorted.chunk_by(|a, b| a.0 == b.0) {
        for &(_, vertex) in same {
            first[vertex as usize] = same[0].1;
        }
    }
    first
}

/// True if faces with these unit normals at one edge lie side by side in one
/// plane (not folded onto each other), wound the same way.
fn coplanar([first, second]: [Vec3; 2]) -> bool {
    first.dot(second) > 0.0 && first.cross(second).length() < COPLANAR
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh(positions: &[[f64; 3]], faces: &[[u32; 3]]) -> Mesh {
        Mesh {
            positions: positions.iter().map(|&p| p.into()).collect(),
            faces: faces.to_vec(),
        }
    }

    /// The corners of a square, a point above it and one beyond it.
    const CORNERS: [[f64; 3]; 6] = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.5, 0.5, 1.0],
        [2.0, 2.0, 0.0],
    ];

    fn sides_of(edges: &[Edge], vertices: [u32; 2]) -> Option<Sides> {
        let same = |edge: &&Edge| {
            let [a, b] = edge.vertices;
            [a, b] == vertices || [b, a] == vertices
        };
        edges.iter().find(same).map(|edge| edge.sides)
    }

    /// The diagonal of a quad is no edge, unless its halves are wound against
    /// each other or something else differs between them; its border is open.
    #[test]
    fn diagonal_of_a_quad() {
        let quad = mesh(&CORNERS, &[[0, 1, 2], [0, 2, 3]]);
        let border = edges(&quad);
        assert_eq!(border.len(), 4);
        assert!(border.iter().all(|edge| edge.sides == Sides::Open));
        let sides = |flipped| Sides::Between {
            faces: [0, 1],
            flipped,
        };
        let differing = edges_with(&quad, |_| true);
        assert_eq!(sides_of(&differing, [0, 2]), Some(sides(false)));
        let turned = edges(&mesh(&CORNERS, &[[0, 1, 2], [0, 3, 2]]));
        assert_eq!(sides_of(&turned, [0, 2]), Some(sides(true)));
    }

    /// Two coplanar faces on the same side of their edge, folded onto each
    /// other, have an edge, however they are wound.
    #[test]
    fn fold_is_an_edge() {
        for (second, flipped) in [([1, 0, 3], false), ([0, 1, 3], true)] {
            let edges = edges(&mesh(&CORNERS, &[[0, 1, 2], second]));
            let sides = Sides::Between {
                faces: [0, 1],
                flipped,
            };
            assert_eq!(sides_of(&edges, [0, 1]), Some(sides));
        }
    }

    /// Creases have an edge; winding decides how the second normal counts.
    #[test]
    fn crease_knows_its_winding() {
        for (second, flipped) in [([1, 0, 4], false), ([0, 1, 4], true)] {
            let edges = edges(&mesh(&CORNERS, &[[0, 1, 2], second]));
            let sides = Sides::Between {
                faces: [0, 1],
                flipped,
            };
            assert_eq!(sides_of(&edges, [0, 1]), Some(sides));
        }
    }

    /// Copies of vertices, and zeros of either sign, are one vertex.
    #[test]
    fn seams_are_welded() {
        let mut positions = CORNERS.to_vec();
        positions.extend([[-0.0, 0.0, -0.0], [1.0, -0.0, 0.0]]);
        let edges = edges(&mesh(&positions, &[[0, 1, 2], [7, 6, 4]]));
        assert!(matches!(
            sides_of(&edges, [0, 1]),
            Some(Sides::Between { .. })
        ));
        assert_eq!(edges.len(), 5);
    }

    /// More than two faces at an edge: a boundary, even among coplanar ones.
    #[test]
    fn three_faces_make_an_open_edge() {
        let edges = edges(&mesh(&CORNERS, &[[0, 1, 2], [0, 2, 3], [0, 2, 4]]));
        assert_eq!(sides_of(&edges, [0, 2]), Some(Sides::Open));
    }

    /// Faces without area are holes: the edges around them are open.
    #[test]
    fn degenerate_faces_are_holes() {
        let faces = [[0, 1, 2], [0, 2, 5], [3, 3, 3], [0, 2, 0]];
        let edges = edges(&mesh(&CORNERS, &faces));
        assert_eq!(edges.len(), 3);
        assert!(edges.iter().all(|edge| edge.sides == Sides::Open));
    }

    /// Edges come in the order of the faces, whatever the number of threads.
    #[test]
    fn order_is_that_of_the_faces() {
        let mesh = mesh(&CORNERS, &[[2, 4, 1], [0, 1, 4]]);
        let expected = vec![[2, 4], [4, 1], [1, 2], [0, 1], [4, 0]];
        let vertices: Vec<_> = edges(&mesh).iter().map(|edge| edge.vertices).collect();
        assert_eq!(vertices, expected);
    }

    /// What a motion can invalidate, and that rigid and smooth motions do not.
    #[test]
    fn motions_that_invalidate_the_list() {
        // A quad beside a tilted face; 5 is a copy of 1, on which a face stands
        // whose corner 7 is at some distance of 6.
        let mut mesh = mesh(
            &CORNERS,
            &[[0, 1, 2], [0, 2, 3], [2, 1, 4], [5, 6, 0], [7, 3, 0]],
        );
        mesh.positions[5] = mesh.positions[1];
        mesh.positions
            .extend([[0.5, -1.0, 0.0], [-1.0, 0.5, 0.3]].map(Vec3::from));
        let before = edges(&mesh);
        let after = |motion: &dyn Fn(usize, Vec3) -> Vec3| {
            let positions = mesh.positions.iter().enumerate();
            edges(&Mesh {
                positions: positions.map(|(i, &p)| motion(i, p)).collect(),
                faces: mesh.faces.clone(),
            })
        };
        let turned = |p: Vec3| Vec3::new(0.6 * p.x - 0.8 * p.z, p.y, 0.8 * p.x + 0.6 * p.z);
        assert_eq!(after(&|_, p| turned(p) + Vec3::new(5.0, 0.1, -3.0)), before);
        assert_eq!(after(&|_, p| p * 1e-3), before);
        let of_vertex = |vertex: usize, offset: Vec3| {
            after(&move |i, p| if i == vertex { p + offset } else { p })
        };
        let up = Vec3::new(0.0, 0.0, 0.1);
        assert_eq!(of_vertex(4, up), before);
        // The quad bends; a copy moves away; two vertices meet; the tilted face
        // becomes coplanar, or loses its area.
        assert_ne!(of_vertex(3, up), before);
        assert_ne!(of_vertex(5, up), before);
        assert_ne!(of_vertex(7, mesh.positions[6] - mesh.positions[7]), before);
        assert_ne!(of_vertex(4, Vec3::new(1.0, 0.0, -1.0)), before);
        assert_ne!(of_vertex(4, mesh.positions[1] - mesh.positions[4]), before);
    }

    #[test]
    fn no_faces_no_edges() {
        assert_eq!(edges(&Mesh::default()), vec![]);
    }
}
