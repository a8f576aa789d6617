//! Edges and the faces at them, welded by position.
//!
//! Seams in normals or texture coordinates duplicate vertices; the surface
//! does not end there. So vertices with bitwise equal positions are one.

use std::collections::HashMap;

use capwalk_math::Vec3;

use crate::edge::{Edge, Sides};
use crate::mesh::Mesh;

/// Neighbours whose normals differ by less than this sine (radians) are
/// coplanar. Rounding to single precision tilts the halves of a quad by about
/// 1e-7; a real crease this faint changes the shading by as little.
pub const COPLANAR: f64 = 1e-6;

/// The edges of one mesh that can be boundaries, in a fixed order, with
/// `groups = u8::MAX`. Coplanar neighbours have none between them, degenerate
/// faces (no area) count as holes.
pub fn edges(mesh: &Mesh) -> Vec<Edge> {
    let representative = weld(&mesh.positions);
    // Directed uses of each undirected edge, in order of first appearance.
    let mut slots: HashMap<(u32, u32), usize> = HashMap::new();
    let mut uses: Vec<([u32; 2], Vec<(u32, bool)>)> = Vec::new();
    for (face, corners) in mesh.faces.iter().enumerate() {
        if mesh.face_cross(face) == Vec3::zero() {
            continue;
        }
        for i in 0..3 {
            let ends = [corners[i], corners[(i + 1) % 3]];
            let [a, b] = ends.map(|v| representative[v as usize]);
            if a == b {
                continue;
            }
            let slot = *slots.entry((a.min(b), a.max(b))).or_insert_with(|| {
                uses.push((ends, Vec::new()));
                uses.len() - 1
            });
            uses[slot].1.push((face as u32, a < b));
        }
    }
    uses.into_iter()
        .filter_map(|(vertices, uses)| {
            let sides = match uses[..] {
                [(first, forward), (second, also_forward)] => {
                    let flipped = forward == also_forward;
                    if coplanar(mesh, first, second, flipped) {
                        return None;
                    }
                    Sides::Between {
                        faces: [first, second],
                        flipped,
                    }
                }
                _ => Sides::Open,
            };
            Some(Edge {
                vertices,
                sides,
                groups: u8::MAX,
            })
        })
        .collect()
}

/// For each vertex, the first vertex with the same position.
pub fn weld(positions: &[Vec3]) -> Vec<u32> {
    let mut first: HashMap<[u64; 3], u32> = HashMap::with_capacity(positions.len());
    positions
        .iter()
        .enumerate()
        .map(|(i, p)| {
            // Adding 0 makes -0 and 0 the same.
            let key = p.to_array().map(|c| (c + 0.0).to_bits());
            *first.entry(key).or_insert(i as u32)
        })
        .collect()
}

/// True if the two faces lie side by side in one plane (not folded onto each
/// other).
fn coplanar(mesh: &Mesh, first: u32, second: u32, flipped: bool) -> bool {
    let n1 = mesh.face_cross(first as usize).normalized();
    let n2 = mesh.face_cross(second as usize).normalized();
    let n2 = if flipped { -n2 } else { n2 };
    n1.dot(n2) > 0.0 && n1.cross(n2).length() < COPLANAR
}
