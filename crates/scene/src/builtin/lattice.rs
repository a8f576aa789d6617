//! A closed lattice of rounded struts along the edges of a Voronoi diagram on
//! the sphere, in the manner of the Voronoi models of Mehta et al. 2022.
//!
//! The surface of a strut is cut along its outer and its inner ridge, which lie
//! above and below the Voronoi edge; each half belongs to the cell on its side.
//! So a cell's part is a ring around its hole: at every point of the cell's
//! border a half-ellipse goes from the outer ridge through the hole's rim to
//! the inner ridge, in the half-plane through the cell's axis and that point.
//! Half-planes about one axis meet nowhere else, and cells are disjoint cones,
//! so nothing can intersect; ridge vertices are shared, so nothing can gap.

use std::collections::HashMap;
use std::f64::consts::PI;

use capwalk_geometry::Mesh;
use capwalk_math::{Frame, Vec3};

use super::voronoi::{Voronoi, spread_directions, voronoi};

/// Number of cells.
const CELLS: usize = 130;
/// Rounds of relaxation: few, so that cells stay irregular.
const RELAXATIONS: usize = 3;
/// Half the width of a strut, radians seen from the centre, and half its
/// height, in radii of the sphere.
const HALF_WIDTH: f64 = 0.027;
/// Exponent of the norm that rounds the holes' corners: 2 would round all of
/// the hole, infinity would leave them sharp.
const ROUNDING: f64 = 7.0;
/// Segments of half a strut's cross-section.
const SEGMENTS: usize = 6;
/// Length of the segments along a strut, radians; sets the triangle count.
const STEP: f64 = 0.026;

/// The lattice around the origin, with mean radius 1: about 72 000 triangles,
/// one closed surface, wound outward.
pub fn mesh() -> Mesh {
    let sites = spread_directions(CELLS, RELAXATIONS);
    let diagram = voronoi(&sites);
    let mut mesh = Mesh::default();
    let mut ridges = Ridges::default();
    for (site, cell) in sites.iter().zip(&diagram.cells) {
        let border = ridges.border(&diagram, cell, &mut mesh);
        add_ring(*site, &diagram, cell, &border, &mut mesh);
    }
    mesh
}

/// A point of a cell's border: its direction and its two ridge vertices.
#[derive(Clone, Copy)]
struct RidgePoint {
    direction: Vec3,
    outer: u32,
    inner: u32,
}

/// The ridge points made so far, so that neighbouring cells share them.
#[derive(Default)]
struct Ridges {
    /// Points from one corner (the smaller index) to the other, both included.
    edges: HashMap<(u32, u32), Vec<RidgePoint>>,
    corners: HashMap<u32, RidgePoint>,
}

impl Ridges {
    /// The ridge points around a cell, counter-clockwise.
    fn border(&mut self, diagram: &Voronoi, cell: &[u32], mesh: &mut Mesh) -> Vec<RidgePoint> {
        let mut border = Vec::new();
        for (i, &a) in cell.iter().enumerate() {
            let b = cell[(i + 1) % cell.len()];
            let mut points = self.edge(diagram, a.min(b), a.max(b), mesh);
            if a > b {
                points.reverse();
            }
            points.pop(); // the next edge begins with it
            border.append(&mut points);
        }
        border
    }

    fn edge(&mut self, diagram: &Voronoi, a: u32, b: u32, mesh: &mut Mesh) -> Vec<RidgePoint> {
        if let Some(points) = self.edges.get(&(a, b)) {
            return points.clone();
        }
        let [first, last] = [a, b].map(|corner| {
            let direction = diagram.corners[corner as usize];
            *self
                .corners
                .entry(corner)
                .or_insert_with(|| ridge_point(direction, mesh))
        });
        let (from, to) = (first.direction, last.direction);
        let angle = from.cross(to).length().atan2(from.dot(to));
        let count = (angle / STEP).round().max(1.0);
        let mut points = vec![first];
        for i in 1..count as usize {
            // Equal steps along the great circle.
            let t = angle * i as f64 / count;
            let direction = from * (angle - t).sin() + to * t.sin();
            points.push(ridge_point(direction.normalized(), mesh));
        }
        points.push(last);
        self.edges.insert((a, b), points.clone());
        points
    }
}

fn ridge_point(direction: Vec3, mesh: &mut Mesh) -> RidgePoint {
    let mut vertex = |radius: f64| push(mesh, direction * radius);
    RidgePoint {
        direction,
        outer: vertex(1.0 + HALF_WIDTH),
        inner: vertex(1.0 - HALF_WIDTH),
    }
}

fn push(mesh: &mut Mesh, position: Vec3) -> u32 {
    mesh.positions.push(position);
    mesh.positions.len() as u32 - 1
}

/// Adds the ring of struts around one cell's hole.
fn add_ring(site: Vec3, diagram: &Voronoi, cell: &[u32], border: &[RidgePoint], mesh: &mut Mesh) {
    // In the tangent plane at the site great circles are straight lines: the
    // cell is a convex polygon, its sides `normal · p = tan(distance)`.
    let frame = Frame::from_normal(site);
    let sides: Vec<(f64, f64)> = (0..cell.len())
        .map(|i| {
            let [a, b] = [i, (i + 1) % cell.len()].map(|k| diagram.corners[cell[k] as usize]);
            let inward = frame.to_local(a.cross(b).normalized());
            let distance = inward.z.asin();
            // The rim's side is parallel, closer by the width of the strut.
            let scale = 1.0 / ((distance - HALF_WIDTH).tan() * distance.cos());
            (-inward.x * scale, -inward.y * scale)
        })
        .collect();
    let arcs: Vec<Vec<u32>> = border
        .iter()
        .map(|point| {
            let local = frame.to_local(point.direction);
            let (x, y) = (local.x / local.z, local.y / local.z);
            // The rim lies where a smooth maximum over all sides of
            // (distance along the side's normal / that of the rim's side) is 1.
            let power_sum: f64 = sides
                .iter()
                .map(|(nx, ny)| (nx * x + ny * y).max(0.0).powf(ROUNDING))
                .sum();
            let rim = power_sum.powf(-1.0 / ROUNDING);
            let between = (1..SEGMENTS).map(|k| {
                let (sin, cos) = (PI * k as f64 / SEGMENTS as f64).sin_cos();
                let along = 1.0 + (rim - 1.0) * sin;
                let tangent = frame.to_world(Vec3::new(x * along, y * along, 1.0));
                push(mesh, tangent.normalized() * (1.0 + HALF_WIDTH * cos))
            });
            let mut arc = vec![point.outer];
            arc.extend(between);
            arc.push(point.inner);
            arc
        })
        .collect();
    for (i, arc) in arcs.iter().enumerate() {
        let next = &arcs[(i + 1) % arcs.len()];
        for k in 0..SEGMENTS {
            let [a, b, c, d] = [arc[k], next[k], next[k + 1], arc[k + 1]];
            mesh.faces.extend([[a, b, d], [b, c, d]]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_geometry::Ray;
    use capwalk_geometry::ray::intersect_triangle;
    use capwalk_geometry::topology::weld;

    #[test]
    fn has_its_size() {
        let mesh = mesh();
        let count = mesh.faces.len() as f64;
        assert!((count / 72_000.0 - 1.0).abs() < 0.05, "{count}");
        let (low, high) = mesh.bounds();
        for axis in 0..3 {
            assert!(high[axis] > 0.97 && high[axis] < 1.0 + 1.01 * HALF_WIDTH);
            assert!(low[axis] < -0.97 && low[axis] > -1.0 - 1.01 * HALF_WIDTH);
        }
    }

    /// Every edge has exactly two faces that agree about the outside; the genus
    /// is that of a sphere with as many holes as cells; the volume is positive
    /// and near that of the struts as cylinders.
    #[test]
    fn is_one_closed_surface_wound_outward() {
        let mesh = mesh();
        let mut uses: HashMap<(u32, u32), u32> = HashMap::new();
        for f in &mesh.faces {
            for i in 0..3 {
                *uses.entry((f[i], f[(i + 1) % 3])).or_default() += 1;
            }
        }
        for (&(a, b), &count) in &uses {
            assert_eq!((count, uses.get(&(b, a))), (1, Some(&1)), "edge {a}-{b}");
        }
        let welded = weld(&mesh.positions);
        assert!(welded.iter().enumerate().all(|(i, &w)| w as usize == i));
        let euler = mesh.positions.len() as i64 - uses.len() as i64 / 2 + mesh.faces.len() as i64;
        // A ball with `CELLS` holes to its hollow inside: genus CELLS - 1.
        assert_eq!(euler, 2 - 2 * (CELLS as i64 - 1));

        // Connected: every vertex is reached from the first.
        let mut reached = vec![false; mesh.positions.len()];
        let mut around = vec![Vec::new(); mesh.positions.len()];
        for &(a, b) in uses.keys() {
            around[a as usize].push(b as usize);
        }
        let mut open = vec![0];
        while let Some(v) = open.pop() {
            if !std::mem::replace(&mut reached[v], true) {
                open.extend(&around[v]);
            }
        }
        assert!(reached.into_iter().all(|r| r));

        let six = (0..mesh.faces.len()).map(|face| {
            let [a, b, c] = mesh.corners(face);
            a.dot(b.cross(c))
        });
        let volume = six.sum::<f64>() / 6.0;
        let diagram = voronoi(&spread_directions(CELLS, RELAXATIONS));
        let lengths = diagram.cells.iter().flat_map(|cell| {
            let corner = |i: usize| diagram.corners[cell[i % cell.len()] as usize];
            (0..cell.len()).map(move |i| corner(i).dot(corner(i + 1)).acos())
        });
        let cylinders = 0.5 * lengths.sum::<f64>() * PI * HALF_WIDTH * HALF_WIDTH;
        assert!(
            volume > cylinders && volume < 1.3 * cylinders,
            "{volume} {cylinders}"
        );
    }

    /// No edge passes through a triangle it has no vertex in common with, and
    /// no triangle is folded back on its neighbour or degenerate.
    #[test]
    fn does_not_intersect_itself() {
        let mesh = mesh();
        const CELL: f64 = 0.05;
        let key = |p: Vec3| p.to_array().map(|c| (c / CELL).floor() as i64);
        let mut grid: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
        for face in 0..mesh.faces.len() {
            let corners = mesh.corners(face);
            let low = key(corners[0].min(corners[1]).min(corners[2]));
            let high = key(corners[0].max(corners[1]).max(corners[2]));
            for x in low[0]..=high[0] {
                for y in low[1]..=high[1] {
                    for z in low[2]..=high[2] {
                        grid.entry([x, y, z]).or_default().push(face);
                    }
                }
            }
        }
        let mut tested = 0_u64;
        for f in &mesh.faces {
            for i in 0..3 {
                let [a, b] = [f[i], f[(i + 1) % 3]];
                if a > b {
                    continue;
                }
                let [p, q] = [a, b].map(|v| mesh.positions[v as usize]);
                let ray = Ray {
                    t_max: 1.0,
                    ..Ray::new(p, q - p)
                };
                // Every cell that the segment can pass through.
                let (low, high) = (key(p.min(q)), key(p.max(q)));
                for x in low[0]..=high[0] {
                    for y in low[1]..=high[1] {
                        for z in low[2]..=high[2] {
                            for &face in grid.get(&[x, y, z]).into_iter().flatten() {
                                if mesh.faces[face].iter().any(|v| [a, b].contains(v)) {
                                    continue;
                                }
                                tested += 1;
                                let hit = intersect_triangle(&ray, mesh.corners(face));
                                assert!(hit.is_none(), "edge {a}-{b} meets face {face}");
                            }
                        }
                    }
                }
            }
        }
        assert!(tested > 1_000_000, "{tested}");

        let mut normals: HashMap<(u32, u32), Vec3> = HashMap::new();
        for (face, f) in mesh.faces.iter().enumerate() {
            assert!(
                mesh.face_cross(face).length() > 1e-9,
                "face {face} has no area"
            );
            let normal = mesh.face_cross(face).normalized();
            for i in 0..3 {
                normals.insert((f[i], f[(i + 1) % 3]), normal);
            }
        }
        for (&(a, b), n) in &normals {
            assert!(n.dot(normals[&(b, a)]) > -0.5, "edge {a}-{b} is folded");
        }
    }
}
