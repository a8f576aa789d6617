//! A court between two storeys of arcades with cloth, as a scene to trace rays in.
//!
//! Metres, z upwards. Its triangles are between millimetres and tens of metres long; columns,
//! slabs, walls and cloth are open, vases and balusters closed.

use std::f64::consts::PI;

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;

/// From one column to the next.
const BAY: f64 = 3.0;
/// Bays along x and y.
const BAYS: [i32; 2] = [9, 4];
/// Half of the court's length and width.
const HALF: [f64; 2] = [BAY * 4.5, BAY * 2.0];
/// From the columns to the wall behind them.
const AISLE: f64 = 3.5;
/// Height of a storey, and where its arches begin and how wide they are.
const STOREY: f64 = 5.5;
const SPRING: f64 = 3.6;
const SPAN: f64 = 2.5;

/// The arcade, some 250,000 triangles.
pub fn arcade() -> Mesh {
    let mut mesh = Mesh::default();
    let [x, y] = HALF;
    let (wide_x, wide_y) = (x + AISLE, y + AISLE);
    // The ground; around the court two floors and a roof, and the walls behind.
    push_slab(&mut mesh, [-wide_x, wide_x], [-wide_y, wide_y], 0.0);
    for level in [1.0, 2.0] {
        for (side, thickness) in [-1.0, 1.0].into_iter().flat_map(|s| [(s, 0.0), (s, 0.3)]) {
            let z = level * STOREY + thickness;
            push_slab(&mut mesh, [-wide_x, wide_x], [side * y, side * wide_y], z);
            push_slab(&mut mesh, [side * x, side * wide_x], [-y, y], z);
        }
    }
    for side in [-1.0, 1.0] {
        let wall = |u: f64, v: f64, on_x: bool| {
            let (along, z) = (2.0 * u - 1.0, v * (2.0 * STOREY + 1.0));
            match on_x {
                true => Vec3::new(side * wide_x, along * wide_y, z),
                false => Vec3::new(along * wide_x, side * wide_y, z),
            }
        };
        push_grid(&mut mesh, [6, 4], |u, v| wall(u, v, true));
        push_grid(&mut mesh, [14, 4], |u, v| wall(u, v, false));
    }
    // A column at each corner of a bay, and from it to the next an arch.
    for ground in [0.0, STOREY + 0.3] {
        for (axis, side) in [(0, -1.0), (0, 1.0), (1, -1.0), (1, 1.0)] {
            for bay in 0..BAYS[axis] {
                let along = |t: f64, away: f64, z: f64| {
                    let mut p = [0.0; 3];
                    p[axis] = BAY * (f64::from(bay) + t) - HALF[axis];
                    p[1 - axis] = side * (HALF[1 - axis] + away);
                    Vec3::new(p[0], p[1], ground + z)
                };
                let is_corner = axis == 1 && bay == 0;
                if !is_corner {
                    push_column(&mut mesh, along(0.0, 0.0, 0.0));
                }
                push_arch(&mut mesh, along);
                if ground > 0.0 {
                    push_balusters(&mut mesh, along);
                }
                let number = bay + if side > 0.0 { 1 } else { 0 };
                if axis == 0 && number % 3 == 1 {
                    push_curtain(&mut mesh, along, f64::from(bay) + side + ground);
                }
                if axis == 0 && ground == 0.0 && bay % 2 == 0 {
                    push_vase(&mut mesh, along(0.5, -1.2, 0.0));
                }
            }
        }
    }
    mesh
}

/// A surface of `2 nu nv` triangles.
fn push_grid(mesh: &mut Mesh, [nu, nv]: [u32; 2], at: impl Fn(f64, f64) -> Vec3) {
    let start = mesh.positions.len() as u32;
    for (j, i) in (0..=nv).flat_map(|j| (0..=nu).map(move |i| (j, i))) {
        let (u, v) = (f64::from(i) / f64::from(nu), f64::from(j) / f64::from(nv));
        mesh.positions.push(at(u, v));
    }
    for (j, i) in (0..nv).flat_map(|j| (0..nu).map(move |i| (j, i))) {
        let a = start + j * (nu + 1) + i;
        let c = a + nu + 1;
        mesh.faces.extend([[a, a + 1, c], [a + 1, c + 1, c]]);
    }
}

/// A horizontal rectangle of two triangles.
fn push_slab(mesh: &mut Mesh, x: [f64; 2], y: [f64; 2], z: f64) {
    let between = |[low, high]: [f64; 2], t: f64| low + (high - low) * t;
    push_grid(mesh, [1, 1], |u, v| {
        Vec3::new(between(x, u), between(y, v), z)
    });
}

/// A surface of revolution about the vertical axis above `foot`: its radius and height by
/// direction and `v`.
fn push_turned(mesh: &mut Mesh, n: [u32; 2], foot: Vec3, profile: impl Fn(f64, f64) -> [f64; 2]) {
    push_grid(mesh, n, |u, v| {
        let [radius, z] = profile(2.0 * PI * u, v);
        let (sin, cos) = (2.0 * PI * u).sin_cos();
        foot + Vec3::new(radius * cos, radius * sin, z)
    });
}

/// A column with base, twelve flutes and capital, up to where the arches begin.
fn push_column(mesh: &mut Mesh, foot: Vec3) {
    push_turned(mesh, [48, 20], foot, |angle, v| {
        let shaft = (1.0 - ((v - 0.5).abs() / 0.38).powi(12)).max(0.0);
        let ends = 0.06 * (20.0 * PI * v).sin().abs() + 0.12 * (v - 0.5).abs();
        let flutes = 0.02 * shaft * (12.0 * angle).cos().abs();
        // Rings lie close together at the ends.
        let height = v + 0.12 * (2.0 * PI * v).sin() * (2.0 * PI * v).cos().abs();
        [
            0.17 + ends * (1.0 - shaft) - flutes,
            SPRING * height.clamp(0.0, 1.0),
        ]
    });
}

/// The wall above a bay with the arch under it: a moulded ring along the bay.
fn push_arch(mesh: &mut Mesh, at: impl Fn(f64, f64, f64) -> Vec3) {
    push_grid(mesh, [40, 12], |u, v| {
        let from_middle = (u - 0.5) * BAY / (0.5 * SPAN);
        let rise = (1.0 - from_middle * from_middle).max(0.0).sqrt() * 0.5 * SPAN;
        let (sin, cos) = (2.0 * PI * v).sin_cos();
        // A rounded square, from the arch to the storey's end.
        let corner = |c: f64| c.signum() * c.abs().powf(0.3);
        let bottom = SPRING + rise;
        let z = bottom + (STOREY - bottom) * (0.5 + 0.5 * corner(sin));
        at(u, 0.22 * corner(cos), z)
    });
}

/// A closed baluster every quarter of a metre, and a rail.
fn push_balusters(mesh: &mut Mesh, at: impl Fn(f64, f64, f64) -> Vec3) {
    for i in 1..12 {
        push_turned(mesh, [8, 6], at(f64::from(i) / 12.0, 0.0, 0.0), |_, v| {
            [
                0.04 * (PI * v).sin() * (1.3 + (4.0 * PI * v).cos()),
                0.9 * v,
            ]
        });
    }
    push_grid(mesh, [1, 4], |u, v| {
        let (sin, cos) = (2.0 * PI * v).sin_cos();
        at(u, 0.06 * cos, 0.93 + 0.06 * sin)
    });
}

/// Cloth from the top of an arch, in folds that widen downwards.
fn push_curtain(mesh: &mut Mesh, at: impl Fn(f64, f64, f64) -> Vec3, phase: f64) {
    push_grid(mesh, [72, 36], |u, v| {
        let fold = (40.0 * u + 3.0 * (4.0 * u + 2.0 * v + phase).sin()).sin();
        let sway = 0.3 * (3.0 * u + phase).sin() * v * v;
        at(
            0.12 + 0.76 * u,
            -0.3 + fold * (0.03 + 0.12 * v) + sway,
            4.8 - 3.6 * v,
        )
    });
}

/// A closed vase.
fn push_vase(mesh: &mut Mesh, foot: Vec3) {
    push_turned(mesh, [40, 28], foot, |_, v| {
        // Outside up to the rim, then inside down again.
        let height = (PI * v).sin();
        let belly = 0.32 * (PI * (0.1 + 0.75 * height)).sin().max(0.02);
        let radius = if v < 0.5 { belly } else { belly - 0.03 };
        [
            radius * (40.0 * v).min(40.0 - 40.0 * v).min(1.0),
            1.1 * height,
        ]
    });
}
