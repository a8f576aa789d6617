//! A lattice of struts along Voronoi cells on the surface of a rabbit, in the
//! manner of the Voronoi bunny of Mehta et al. 2022.
//!
//! The rabbit is a smooth union of ellipsoids. Sites are spread over its surface;
//! where the surface meets the plane between a site and its neighbour, a strut
//! runs. So a strut is what lies within [`RADIUS`] of both the surface and such a
//! plane, and the lattice is the surface where that distance is reached: closed,
//! and without self-intersections.

mod isosurface;

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;

use crate::random::uniform;
use isosurface::{Lattice, relax, to_surface};

/// Number of cells.
const CELLS: usize = 200;
/// Rounds of relaxation of their sites.
const RELAXATIONS: usize = 4;
/// Radius of a strut; the rabbit is about 2.4 long.
const RADIUS: f64 = 0.024;
/// Side of the cubes that it is divided into; sets the triangle count.
const SIDE: f64 = 0.0273;

/// An ellipsoid, turned about two axes.
struct Part {
    centre: [f64; 3],
    radii: [f64; 3],
    /// Radians about z, then about x.
    turn: [f64; 2],
}

/// The rabbit looks along x, y is up. Its right half; parts off the middle have a
/// mirror image.
const PARTS: [Part; 7] = [
    // Body, haunch, chest.
    part([-0.1, -0.15, 0.0], [0.72, 0.55, 0.5], [0.25, 0.0]),
    part([-0.42, -0.25, 0.22], [0.4, 0.42, 0.3], [0.0, 0.0]),
    part([0.32, -0.1, 0.0], [0.36, 0.46, 0.36], [0.5, 0.0]),
    // Head, ear, foot, tail.
    part([0.6, 0.48, 0.0], [0.36, 0.29, 0.27], [-0.15, 0.0]),
    part([0.4, 1.03, 0.2], [0.15, 0.48, 0.1], [0.3, 0.22]),
    part([0.42, -0.62, 0.2], [0.32, 0.13, 0.14], [0.0, 0.0]),
    part([-0.92, -0.05, 0.0], [0.19, 0.19, 0.19], [0.0, 0.0]),
];

const fn part(centre: [f64; 3], radii: [f64; 3], turn: [f64; 2]) -> Part {
    Part {
        centre,
        radii,
        turn,
    }
}

/// All of it lies inside.
const BOUNDS: [[f64; 3]; 2] = [[-1.3, -0.95, -0.75], [1.15, 1.65, 0.75]];

/// The lattice around the origin: about 168 000 triangles, one closed surface,
/// wound outward. The rabbit lies on its side, as seen from above.
pub fn mesh() -> Mesh {
    let cells = Cells::new(sites());
    let lattice = |p: Vec3| body(p).hypot(cells.distance(p)) - RADIUS;
    let [low, high] = BOUNDS.map(Vec3::from);
    let mut mesh = Lattice {
        function: &lattice,
        side: SIDE,
    }
    .surface(low, high);
    relax(&mut mesh, &lattice, 4, 0.25 * SIDE);
    for p in &mut mesh.positions {
        *p = Vec3::new(p.x, p.z, -p.y);
    }
    mesh
}

/// About the distance to the rabbit's surface, negative inside.
fn body(p: Vec3) -> f64 {
    // Creases are rounded over this distance.
    const ROUND: f64 = 0.09;
    let mut distance = f64::INFINITY;
    for part in &PARTS {
        // Parts off the middle are there twice.
        let z = if part.centre[2] > 0.0 { p.z.abs() } else { p.z };
        let other = ellipsoid(part, Vec3::new(p.x, p.y, z));
        let h = (0.5 + 0.5 * (distance - other) / ROUND).clamp(0.0, 1.0);
        distance = match distance.is_finite() {
            true => distance + (other - distance) * h - ROUND * h * (1.0 - h),
            false => other,
        };
    }
    distance
}

/// About the distance to an ellipsoid: right to first order at its surface.
fn ellipsoid(part: &Part, p: Vec3) -> f64 {
    let q = p - Vec3::from(part.centre);
    let (sin, cos) = part.turn[1].sin_cos();
    let q = Vec3::new(q.x, cos * q.y + sin * q.z, cos * q.z - sin * q.y);
    let (sin, cos) = part.turn[0].sin_cos();
    let q = Vec3::new(cos * q.x + sin * q.y, cos * q.y - sin * q.x, q.z);
    let r = Vec3::from(part.radii);
    let once = Vec3::new(q.x / r.x, q.y / r.y, q.z / r.z);
    let twice = Vec3::new(once.x / r.x, once.y / r.y, once.z / r.z);
    let (k, steepness) = (once.length(), twice.length());
    match steepness > 0.0 {
        true => k * (k - 1.0) / steepness,
        // At its centre.
        false => -r.x.min(r.y).min(r.z),
    }
}

/// Points on the rabbit, evenly but irregularly: random ones, each moved some
/// times to the middle of the surface that is closest to it (Lloyd 1982).
fn sites() -> Vec<Vec3> {
    /// Points of the surface for each site.
    const DENSITY: usize = 40;
    let mut state = 0x0b0_b0b0_u64;
    let [low, high] = BOUNDS.map(Vec3::from);
    let mut points = Vec::new();
    while points.len() < DENSITY * CELLS {
        let t = [0; 3].map(|_| uniform(&mut state));
        let size = high - low;
        let p = low + Vec3::new(size.x * t[0], size.y * t[1], size.z * t[2]);
        // A thin shell has as much volume everywhere.
        if body(p).abs() < 0.03 {
            points.push(to_surface(p, &body, 1e-3));
        }
    }
    let mut sites: Vec<Vec3> = points.iter().step_by(DENSITY).copied().collect();
    for _ in 0..RELAXATIONS {
        let mut sums = vec![(Vec3::zero(), 0.0); sites.len()];
        for &p in &points {
            let nearest = |a: &&Vec3, b: &&Vec3| {
                let [a, b] = [a, b].map(|s| (**s - p).length_squared());
                a.total_cmp(&b)
            };
            let site = sites.iter().enumerate().min_by(|a, b| nearest(&a.1, &b.1));
            let (index, _) = site.expect("there are sites");
            sums[index].0 += p;
            sums[index].1 += 1.0;
        }
        for (site, (sum, count)) in sites.iter_mut().zip(sums) {
            if count > 0.0 {
                let mut p = sum / count;
                // The middle may be deep inside: several short ways.
                for _ in 0..100 {
                    p = to_surface(p, &body, 0.01);
                }
                *site = p;
            }
        }
    }
    sites
}

/// Voronoi cells in space, with the sites near every place.
struct Cells {
    sites: Vec<Vec3>,
    /// For each cell of a grid the sites that matter inside it.
    grid: Vec<Vec<u32>>,
    size: [usize; 3],
}

impl Cells {
    /// Side of a cell of the grid.
    const CELL: f64 = 0.1;
    /// Distances to the planes between sites are right up to this.
    const REACH: f64 = 2.0 * RADIUS + 4.0 * SIDE;

    fn new(sites: Vec<Vec3>) -> Self {
        let [low, high] = BOUNDS.map(Vec3::from);
        let size = (high - low)
            .to_array()
            .map(|c| (c / Self::CELL).ceil() as usize + 1);
        let half_diagonal = 0.5 * Self::CELL * 3.0_f64.sqrt();
        let mut grid = Vec::new();
        for x in 0..size[0] {
            for y in 0..size[1] {
                for z in 0..size[2] {
                    let [x, y, z] = [x, y, z].map(|i| (i as f64 + 0.5) * Self::CELL);
                    let centre = low + Vec3::new(x, y, z);
                    let distance = |s: &Vec3| (*s - centre).length();
                    let least = sites.iter().map(distance).fold(f64::INFINITY, f64::min);
                    // A plane at a distance d from p belongs to a site that is
                    // at most 2 d farther from p than the closest one.
                    let most = least + 2.0 * half_diagonal + 2.0 * Self::REACH;
                    let near = sites
                        .iter()
                        .enumerate()
                        .filter(|(_, s)| distance(s) <= most);
                    grid.push(near.map(|(i, _)| i as u32).collect());
                }
            }
        }
        Self { sites, grid, size }
    }

    /// The distance to the closest plane between two cells.
    fn distance(&self, p: Vec3) -> f64 {
        let offset = (p - Vec3::from(BOUNDS[0])).to_array();
        let index: [usize; 3] = std::array::from_fn(|k| {
            ((offset[k] / Self::CELL).max(0.0) as usize).min(self.size[k] - 1)
        });
        let near = &self.grid[(index[0] * self.size[1] + index[1]) * self.size[2] + index[2]];
        let site = |i: &u32| self.sites[*i as usize];
        let square = |i: &u32| (site(i) - p).length_squared();
        let own = near.iter().min_by(|a, b| square(a).total_cmp(&square(b)));
        let own = own.expect("every cell of the grid has a closest site");
        let others = near.iter().filter(|i| *i != own);
        let planes =
            others.map(|i| (square(i) - square(own)) / (2.0 * (site(i) - site(own)).length()));
        planes.fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_geometry::topology::weld;
    use std::collections::HashMap;

    #[test]
    fn is_one_closed_surface_of_its_size() {
        let mesh = mesh();
        let count = mesh.faces.len() as f64;
        assert!((count / 168_000.0 - 1.0).abs() < 0.02, "{count}");
        let (low, high) = mesh.bounds();
        assert!((high.x - low.x - 2.1).abs() < 0.1 && (high.z - low.z - 2.3).abs() < 0.1);

        // Every edge has exactly two faces that agree about the outside.
        let mut uses: HashMap<(u32, u32), usize> = HashMap::new();
        for (face, f) in mesh.faces.iter().enumerate() {
            for i in 0..3 {
                let edge = (f[i], f[(i + 1) % 3]);
                assert!(uses.insert(edge, face).is_none(), "{edge:?} is used twice");
            }
        }
        let normal = |face: usize| mesh.face_cross(face).normalized();
        let mut folded = 0;
        for (&(a, b), &face) in &uses {
            let other = *uses.get(&(b, a)).expect("every edge has two sides");
            folded += usize::from(normal(face).dot(normal(other)) < -0.5);
        }
        let euler = mesh.positions.len() as i64 - uses.len() as i64 / 2 + mesh.faces.len() as i64;
        // A ball with `CELLS` holes to its hollow inside has genus CELLS - 1;
        // where struts touch on the thin ears there are a few more.
        let genus = 1 - euler / 2;
        assert!(
            (CELLS as i64 - 1..CELLS as i64 + 8).contains(&genus),
            "{genus}"
        );
        assert_eq!(folded, 0, "edges where the surface folds back");
        assert!((0..mesh.faces.len()).all(|face| mesh.face_cross(face).length() > 1e-10));
        let welded = weld(&mesh.positions);
        assert!(welded.iter().enumerate().all(|(i, &w)| w as usize == i));

        // Connected: every vertex is reached from the first.
        let mut around = vec![Vec::new(); mesh.positions.len()];
        for &(a, b) in uses.keys() {
            around[a as usize].push(b as usize);
        }
        let mut reached = vec![false; mesh.positions.len()];
        let mut open = vec![0];
        while let Some(v) = open.pop() {
            if !std::mem::replace(&mut reached[v], true) {
                open.extend(&around[v]);
            }
        }
        let lost = reached.iter().filter(|r| !**r).count();
        assert_eq!(lost, 0, "vertices in other pieces");

        // Wound outward: its volume is about that of struts as cylinders.
        let six = (0..mesh.faces.len()).map(|face| {
            let [a, b, c] = mesh.corners(face);
            a.dot(b.cross(c))
        });
        let volume = six.sum::<f64>() / 6.0;
        let area: f64 = (0..mesh.faces.len())
            .map(|f| 0.5 * mesh.face_cross(f).length())
            .sum();
        // Of a cylinder, volume over area is half the radius.
        let ratio = volume / (0.5 * RADIUS * area);
        assert!((ratio - 1.0).abs() < 0.15, "{ratio}");
    }
}
