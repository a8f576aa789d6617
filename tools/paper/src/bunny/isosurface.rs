//! Triangles of the surface where a function is zero: marching tetrahedra on a
//! body-centred cubic lattice (Chan and Purisima 1998).
//!
//! Every tetrahedron has two cube centres and an edge of the face between them.
//! They fill space, so that each crossed edge has one vertex and each crossed
//! tetrahedron one or two triangles, and the surface is closed, without
//! self-intersections, wherever the function is.

use std::collections::HashMap;

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;

/// Where lattice points are: those of one parity of all coordinates, in units
/// of half the side of a cube.
type Point = [i32; 3];

/// A function sampled on the lattice.
pub struct Lattice<'a> {
    /// Negative inside.
    pub function: &'a dyn Fn(Vec3) -> f64,
    /// Side of a cube.
    pub side: f64,
}

impl Lattice<'_> {
    /// The surface inside of which the function is negative, wound outward, in
    /// a box that holds all of it. The function changes by at most twice the
    /// distance of two points.
    pub fn surface(&self, low: Vec3, high: Vec3) -> Mesh {
        let cubes = self.cubes_at_the_surface(low, high);
        let mut values: HashMap<Point, f64> = HashMap::new();
        let mut value = |p: Point| {
            *values
                .entry(p)
                .or_insert_with(|| (self.function)(self.place(p)))
        };
        let mut mesh = Mesh::default();
        let mut vertices: HashMap<(Point, Point), u32> = HashMap::new();
        for cube in cubes {
            for axis in 0..3 {
                for tetrahedron in tetrahedra(cube, axis) {
                    let corners = tetrahedron.map(|p| (p, value(p)));
                    self.march(corners, &mut vertices, &mut mesh);
                }
            }
        }
        mesh
    }

    fn place(&self, p: Point) -> Vec3 {
        let [x, y, z] = p.map(|i| f64::from(i) * 0.5 * self.side);
        Vec3::new(x, y, z)
    }

    /// The centres of the cubes whose tetrahedra the surface can cross.
    fn cubes_at_the_surface(&self, low: Vec3, high: Vec3) -> Vec<Point> {
        // Centres have odd coordinates.
        let first = low.to_array().map(|c| (c / self.side).floor() as i32 - 1);
        let last = high.to_array().map(|c| (c / self.side).ceil() as i32);
        let layer = |i: i32| {
            let mut cubes = Vec::new();
            for j in first[1]..=last[1] {
                for k in first[2]..=last[2] {
                    let centre = [i, j, k].map(|c| 2 * c + 1);
                    // A tetrahedron reaches one side from its cube's centre.
                    if (self.function)(self.place(centre)).abs() < 2.0 * self.side {
                        cubes.push(centre);
                    }
                }
            }
            cubes
        };
        (first[0]..=last[0]).flat_map(layer).collect()
    }

    /// Adds the triangles inside one tetrahedron.
    fn march(
        &self,
        corners: [(Point, f64); 4],
        vertices: &mut HashMap<(Point, Point), u32>,
        mesh: &mut Mesh,
    ) {
        let is_inside = |i: usize| corners[i].1 < 0.0;
        let (inside, outside): (Vec<usize>, Vec<usize>) = (0..4).partition(|&i| is_inside(i));
        let mut vertex = |i: usize, k: usize| {
            let (a, b) = match corners[i].0 < corners[k].0 {
                true => (corners[i], corners[k]),
                false => (corners[k], corners[i]),
            };
            *vertices.entry((a.0, b.0)).or_insert_with(|| {
                mesh.positions.push(self.crossing(a, b));
                mesh.positions.len() as u32 - 1
            })
        };
        let mut faces = Vec::new();
        match (inside.as_slice(), outside.as_slice()) {
            (&[a], &[b, c, d]) | (&[b, c, d], &[a]) => {
                faces.push([vertex(a, b), vertex(a, c), vertex(a, d)]);
            }
            (&[a, b], &[c, d]) => {
                let ring = [vertex(a, c), vertex(a, d), vertex(b, d), vertex(b, c)];
                faces.push([ring[0], ring[1], ring[2]]);
                faces.push([ring[0], ring[2], ring[3]]);
            }
            _ => return,
        }
        // Outward is from the corners inside to those outside.
        let mean = |these: &[usize]| {
            let sum = these
                .iter()
                .fold(Vec3::zero(), |sum, &i| sum + self.place(corners[i].0));
            sum / these.len() as f64
        };
        let outward = mean(&outside) - mean(&inside);
        let mut cross = Vec3::zero();
        for [a, b, c] in &faces {
            let [a, b, c] = [a, b, c].map(|&i| mesh.positions[i as usize]);
            cross += (b - a).cross(c - a);
        }
        if cross.dot(outward) < 0.0 {
            faces.iter_mut().for_each(|f| f.swap(1, 2));
        }
        mesh.faces.extend(faces);
    }

    /// Where the function is zero between two lattice points, by its values;
    /// away from the ends, so that no triangle degenerates.
    fn crossing(&self, (a, at_a): (Point, f64), (b, at_b): (Point, f64)) -> Vec3 {
        const FROM_ENDS: f64 = 0.08;
        let t = (at_a / (at_a - at_b)).clamp(FROM_ENDS, 1.0 - FROM_ENDS);
        let (a, b) = (self.place(a), self.place(b));
        a + (b - a) * t
    }
}

/// The four tetrahedra between a cube and the next one along an axis: both
/// centres and an edge of the face between them.
fn tetrahedra(cube: Point, axis: usize) -> [[Point; 4]; 4] {
    let mut next = cube;
    next[axis] += 2;
    let [s, t] = [(axis + 1) % 3, (axis + 2) % 3];
    let corner = |i: usize| {
        let (ds, dt) = [(-1, -1), (1, -1), (1, 1), (-1, 1)][i % 4];
        let mut p = cube;
        p[axis] += 1;
        p[s] += ds;
        p[t] += dt;
        p
    };
    std::array::from_fn(|i| [cube, next, corner(i), corner(i + 1)])
}

/// Moves vertices towards the middle of their neighbours and back to the surface,
/// some rounds: triangles become regular. After the last two they are not moved
/// back, which opens folds where tubes meet at sharp angles.
pub fn relax(mesh: &mut Mesh, function: &dyn Fn(Vec3) -> f64, rounds: usize, step: f64) {
    for round in 1..=rounds {
        let mut sums = vec![(Vec3::zero(), 0.0); mesh.positions.len()];
        for f in &mesh.faces {
            for k in 0..3 {
                let sum = &mut sums[f[k] as usize];
                sum.0 += mesh.positions[f[(k + 1) % 3] as usize];
                sum.1 += 1.0;
            }
        }
        for (p, (sum, count)) in mesh.positions.iter_mut().zip(sums) {
            let middle = *p + (sum / count - *p) * 0.5;
            *p = match round + 1 < rounds {
                true => to_surface(middle, function, step),
                false => middle,
            };
        }
    }
}

/// The point near `p` where the function is zero, by a few of Newton's steps
/// with differences over `step`.
pub fn to_surface(mut p: Vec3, function: &dyn Fn(Vec3) -> f64, step: f64) -> Vec3 {
    for _ in 0..2 {
        let value = function(p);
        let gradient = gradient(p, function, step);
        let square = gradient.length_squared();
        if square < 1e-12 {
            return p;
        }
        // No farther than a step: gradients are discontinuous where tubes meet.
        let shift = gradient * (value / square);
        let length = shift.length();
        p = p - shift * (step / length.max(step));
    }
    p
}

/// Central differences.
fn gradient(p: Vec3, function: &dyn Fn(Vec3) -> f64, step: f64) -> Vec3 {
    let along = |d: Vec3| (function(p + d * step) - function(p - d * step)) / (2.0 * step);
    Vec3::new(
        along(Vec3::new(1.0, 0.0, 0.0)),
        along(Vec3::new(0.0, 1.0, 0.0)),
        along(Vec3::new(0.0, 0.0, 1.0)),
    )
}
