//! Meshes to measure on, the same every time.

use std::f64::consts::PI;

use capwalk_geometry::Mesh;
use capwalk_math::{Frame, Vec3};

/// A smooth closed surface of radius about 1: an octahedron with each face
/// split in `n²`, bulged by low waves. `8 n²` triangles.
pub fn bumpy_sphere(n: usize) -> Mesh {
    let mut mesh = Mesh::default();
    for octant in 0..8 {
        let sign = |bit: usize| if octant >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let is_mirrored = sign(0) * sign(1) * sign(2) < 0.0;
        let mut rows = Vec::new();
        for i in 0..=n {
            rows.push(mesh.positions.len() as u32);
            for j in 0..=n - i {
                let k = n - i - j;
                let p = Vec3::new(i as f64, j as f64, k as f64);
                let p = Vec3::new(p.x * sign(0), p.y * sign(1), p.z * sign(2)).normalized();
                let wave = (7.0 * p.x).sin() * (5.0 * p.y + 1.0).sin() * (6.0 * p.z).cos();
                mesh.positions.push(p * (0.95 + 0.08 * wave));
            }
        }
        let mut push = |[a, b, c]: [u32; 3]| {
            mesh.faces
                .push(if is_mirrored { [a, c, b] } else { [a, b, c] });
        };
        for i in 0..n {
            for j in 0..(n - i) as u32 {
                let (here, next) = (rows[i] + j, rows[i + 1] + j);
                push([here, next, here + 1]);
                if j + 1 < (n - i) as u32 {
                    push([next, next + 1, here + 1]);
                }
            }
        }
    }
    mesh
}

/// A bent grid of thin closed tubes between `size` nodes, within a radius of
/// about 1: rough, with silhouettes everywhere.
pub fn lattice(size: [usize; 3]) -> Mesh {
    let node = |index: [usize; 3]| {
        let p = Vec3::from(
            [0, 1, 2].map(|axis| 2.0 * index[axis] as f64 / (size[axis] - 1) as f64 - 1.0),
        );
        // From the cube towards the ball, with a twist.
        let (sin, cos) = (0.7 * p.z).sin_cos();
        let ball = p * (p.map(f64::abs).max_component() / p.length().max(1e-9));
        let p = p * 0.2 + ball * 0.6;
        Vec3::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos, p.z)
    };
    let mut mesh = Mesh::default();
    for x in 0..size[0] {
        for y in 0..size[1] {
            for z in 0..size[2] {
                for axis in 0..3 {
                    let mut neighbour = [x, y, z];
                    neighbour[axis] += 1;
                    if neighbour[axis] < size[axis] {
                        push_tube(&mut mesh, node([x, y, z]), node(neighbour), 0.012);
                    }
                }
            }
        }
    }
    mesh
}

/// A closed tube with six sides in two segments: 32 triangles.
fn push_tube(mesh: &mut Mesh, from: Vec3, to: Vec3, radius: f64) {
    const SIDES: u32 = 6;
    let frame = Frame::from_normal((to - from).normalized());
    let start = mesh.positions.len() as u32;
    for ring in 0..3 {
        let along = f64::from(ring) / 2.0;
        let width = radius * (1.2 - 0.4 * (PI * along).sin());
        for side in 0..SIDES {
            let (sin, cos) = (2.0 * PI * f64::from(side) / f64::from(SIDES)).sin_cos();
            let around = frame.s * (width * cos) + frame.t * (width * sin);
            mesh.positions.push(from + (to - from) * along + around);
        }
    }
    for ring in 0..2 {
        for side in 0..SIDES {
            let a = start + ring * SIDES + side;
            let b = start + ring * SIDES + (side + 1) % SIDES;
            mesh.faces
                .extend([[a, b, b + SIDES], [a, b + SIDES, a + SIDES]]);
        }
    }
    let end = start + 2 * SIDES;
    for side in 1..SIDES - 1 {
        mesh.faces.push([start, start + side + 1, start + side]);
        mesh.faces.push([end, end + side, end + side + 1]);
    }
}
