//! The brute-force twin of every query: slow, short, and right by reading.

use crate::edge::{Edge, closest_direction};
use crate::mesh::Mesh;
use crate::query::{ConeQuery, EdgeSelection, SilhouettePoint};
use crate::ray::{Hit, Ray, intersect_triangle};
use crate::wedge::{Wedge, WedgePoint};

/// The nearest intersection of the ray with any triangle; of equally near ones
/// that of the lowest face.
pub fn first_hit(mesh: &Mesh, ray: &Ray) -> Option<Hit> {
    (0..mesh.faces.len())
        .filter_map(|face| {
            let (t, barycentric) = intersect_triangle(ray, mesh.corners(face))?;
            Some(Hit {
                face: face as u32,
                t,
                barycentric,
            })
        })
        .min_by(|a, b| a.t.partial_cmp(&b.t).expect("hits are not at NaN"))
}

/// True if the ray meets any triangle.
pub fn occluded(mesh: &Mesh, ray: &Ray) -> bool {
    (0..mesh.faces.len()).any(|face| intersect_triangle(ray, mesh.corners(face)).is_some())
}

/// Where triangles cross a wedge: the faces with their sections, in ascending order.
pub fn across(mesh: &Mesh, wedge: &Wedge) -> Vec<(u32, [WedgePoint; 2])> {
    let faces = 0..mesh.faces.len();
    faces
        .filter_map(|face| Some((face as u32, wedge.section(mesh.corners(face))?)))
        .collect()
}

/// The boundary point under the smallest angle to the axis, Eq. (30); of
/// equally near ones that of the lowest edge.
pub fn closest_silhouette(
    mesh: &Mesh,
    edges: &[Edge],
    query: &ConeQuery,
) -> Option<SilhouettePoint> {
    closest_silhouette_where(mesh, edges, query, |_| true)
}

/// The closest silhouette among the edges whose closest point `accept` does not reject.
pub fn closest_silhouette_where(
    mesh: &Mesh,
    edges: &[Edge],
    query: &ConeQuery,
    accept: impl Fn(&SilhouettePoint) -> bool,
) -> Option<SilhouettePoint> {
    closest_points(mesh, edges, query)
        .filter(accept)
        .min_by(|a, b| a.angle.total_cmp(&b.angle))
}

/// The numbers of all boundary edges that meet the cone, in ascending order.
pub fn gather(mesh: &Mesh, edges: &[Edge], query: &ConeQuery) -> Vec<u32> {
    closest_points(mesh, edges, query)
        .map(|point| point.edge)
        .collect()
}

/// The closest point of each boundary edge that meets the cone.
fn closest_points(
    mesh: &Mesh,
    edges: &[Edge],
    query: &ConeQuery,
) -> impl Iterator<Item = SilhouettePoint> {
    let counts = |edge: &Edge| {
        let [a, b] = edge.vertices.map(|i| mesh.positions[i as usize]);
        edge.groups & query.groups != 0
            && (query.edges == EdgeSelection::All || edge.is_silhouette(mesh, query.apex))
            && !query.in_front_of.is_some_and(|plane| plane.hides([a, b]))
    };
    edges
        .iter()
        .enumerate()
        .filter(move |(_, edge)| counts(edge))
        .filter_map(|(id, edge)| {
            let [a, b] = edge
                .vertices
                .map(|i| mesh.positions[i as usize] - query.apex);
            let closest = closest_direction(a, b, query.axis)?;
            (closest.angle < query.max_angle).then_some(SilhouettePoint {
                edge: id as u32,
                t: closest.t,
                direction: closest.direction,
                distance: closest.distance,
                angle: closest.angle,
            })
        })
}
