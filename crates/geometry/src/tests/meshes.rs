//! Meshes to test on: small, and as nasty as real ones can be.

use crate::Mesh;
use capwalk_math::Vec3;
use proptest::prelude::*;

/// A coordinate: often from a coarse grid, so that things coincide and line up.
pub fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-4..=4_i32).prop_map(|v| f64::from(v) * 0.25),
        -1.0..1.0_f64
    ]
}

pub fn point() -> impl Strategy<Value = Vec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(Vec3::from)
}

/// A unit vector, often along an axis.
pub fn direction() -> impl Strategy<Value = Vec3> {
    point()
        .prop_filter("zero has no direction", |v| v.length() > 0.1)
        .prop_map(Vec3::normalized)
}

/// Unrelated triangles over few vertices: duplicates, non-manifold edges,
/// zero areas.
fn soup() -> impl Strategy<Value = Mesh> {
    (3..30_usize).prop_flat_map(|vertices| {
        let positions = prop::collection::vec(point(), vertices);
        let index = 0..vertices as u32;
        let faces = prop::collection::vec([index.clone(), index.clone(), index], 1..60);
        (positions, faces).prop_map(|(positions, faces)| Mesh { positions, faces })
    })
}

/// An open sheet of `n x n` quads with the given heights.
pub fn sheet(n: usize, height: impl Fn(usize, usize) -> f64) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..=n {
        for j in 0..=n {
            let [x, y] = [i, j].map(|k| 2.0 * k as f64 / n as f64 - 1.0);
            mesh.positions.push(Vec3::new(x, y, height(i, j)));
        }
    }
    let at = |i: usize, j: usize| (i * (n + 1) + j) as u32;
    for i in 0..n {
        for j in 0..n {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            mesh.faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// A closed surface: an octahedron, each face split in `n²`, on radii given
/// for each direction.
pub fn ball(n: usize, radius: impl Fn(Vec3) -> f64) -> Mesh {
    let mut mesh = Mesh::default();
    for signs in 0..8 {
        let sign = |bit: usize| if signs >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let corners = [
            Vec3::new(sign(0), 0.0, 0.0),
            Vec3::new(0.0, sign(1), 0.0),
            Vec3::new(0.0, 0.0, sign(2)),
        ];
        let is_mirrored = sign(0) * sign(1) * sign(2) < 0.0;
        // Each octant has its own vertices: topology must weld them.
        let start = mesh.positions.len() as u32;
        for i in 0..=n {
            for j in 0..=n - i {
                let k = n - i - j;
                let p = corners[0] * (i as f64) + corners[1] * (j as f64) + corners[2] * (k as f64);
                let direction = p.normalized();
                mesh.positions.push(direction * radius(direction));
            }
        }
        let at = |i: usize, j: usize| start + (i * (n + 1) - i * (i.max(1) - 1) / 2 + j) as u32;
        let mut push = |a: u32, b: u32, c: u32| {
            mesh.faces
                .push(if is_mirrored { [a, c, b] } else { [a, b, c] });
        };
        for i in 0..n {
            for j in 0..n - i {
                push(at(i, j), at(i + 1, j), at(i, j + 1));
                if j + 1 < n - i {
                    push(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
                }
            }
        }
    }
    mesh
}

/// Faces wound at random: an inconsistent mesh.
fn rewound(mesh: Mesh, coins: &[bool]) -> Mesh {
    let faces = mesh.faces.iter().zip(coins.iter().cycle());
    let faces = faces.map(|(&[a, b, c], &coin)| if coin { [a, c, b] } else { [a, b, c] });
    Mesh {
        faces: faces.collect(),
        positions: mesh.positions,
    }
}

/// A flat strip of needles: long triangles of a tiny width.
fn needles(count: usize, width: f64) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..=count {
        let y = i as f64 * width;
        mesh.positions.push(Vec3::new(-1.0, y, 0.1 * y));
        mesh.positions.push(Vec3::new(1.0, y, -0.2 * y));
    }
    for i in 0..count as u32 {
        mesh.faces.push([2 * i, 2 * i + 1, 2 * i + 3]);
        mesh.faces.push([2 * i, 2 * i + 3, 2 * i + 2]);
    }
    mesh
}

/// A mesh around the origin, of a size about 1.
fn mesh_at_home() -> impl Strategy<Value = Mesh> {
    let heights = prop::collection::vec(coordinate(), 49);
    let coins = prop::collection::vec(any::<bool>(), 7);
    prop_oneof![
        3 => soup(),
        2 => (1..7_usize, heights, 0.0..1.0_f64)
            .prop_map(|(n, heights, z)| sheet(n, |i, j| z * heights[7 * i + j])),
        2 => (1..6_usize, 0.0..0.5_f64, 1.0..9.0_f64)
            .prop_map(|(n, bump, k)| ball(n, |d| 1.0 - bump * (k * (d.x + 2.0 * d.y)).sin().abs())),
        1 => (1..5_usize, coins).prop_map(|(n, coins)| rewound(ball(n, |_| 1.0), &coins)),
        1 => (1..20_usize, -12..-1_i32).prop_map(|(n, digits)| needles(n, 10_f64.powi(digits))),
        1 => [point(), point(), point()]
            .prop_map(|p| Mesh { positions: p.to_vec(), faces: vec![[0, 1, 2]] }),
    ]
}

/// A place and a size: most meshes stay at home.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub offset: Vec3,
    pub size: f64,
}

impl Place {
    /// Takes a point from around the origin to the place.
    pub fn put(&self, p: Vec3) -> Vec3 {
        p * self.size + self.offset
    }
}

pub fn place() -> impl Strategy<Value = Place> {
    let far = |size| {
        (point(), Just(size)).prop_map(|(p, size)| Place {
            offset: p * 1e6,
            size,
        })
    };
    prop_oneof![
        4 => Just(Place { offset: Vec3::zero(), size: 1.0 }),
        1 => far(1.0),
        1 => far(1e-3),
        1 => Just(Place { offset: Vec3::zero(), size: 1e-6 }),
        1 => Just(Place { offset: Vec3::zero(), size: 1e7 }),
    ]
}

/// A mesh at a place.
pub fn mesh() -> impl Strategy<Value = (Mesh, Place)> {
    (mesh_at_home(), place()).prop_map(|(mut mesh, place)| {
        for p in &mut mesh.positions {
            *p = place.put(*p);
        }
        (mesh, place)
    })
}

/// A point to look from: anywhere around, on a vertex, on an edge, in a face,
/// or far away.
#[derive(Clone, Copy, Debug)]
pub enum Spot {
    Free(Vec3),
    OnFace { face: usize, weights: [f64; 3] },
}

pub fn spot() -> impl Strategy<Value = Spot> {
    let weights = prop_oneof![
        Just([1.0, 0.0, 0.0]),
        Just([0.5, 0.5, 0.0]),
        [0.0..1.0_f64, 0.0..1.0_f64, 0.1..1.0_f64],
    ];
    prop_oneof![
        4 => (point(), prop_oneof![Just(0.3), Just(1.0), Just(2.0), Just(1e4)])
            .prop_map(|(p, distance)| Spot::Free(p * distance)),
        2 => (0..1000_usize, weights).prop_map(|(face, weights)| Spot::OnFace { face, weights }),
    ]
}

impl Spot {
    /// Its position in the world.
    pub fn position(&self, mesh: &Mesh, place: &Place) -> Vec3 {
        match *self {
            Self::Free(p) => place.put(p),
            Self::OnFace { face, weights } => {
                let corners = mesh.corners(face % mesh.faces.len());
                let total: f64 = weights.iter().sum();
                let weighted = |i: usize| corners[i] * (weights[i] / total);
                weighted(0) + weighted(1) + weighted(2)
            }
        }
    }
}

/// The mesh with every vertex moved, by up to its size.
pub fn moved(mesh: &Mesh, place: &Place, amount: f64, seed: u64) -> Mesh {
    let mut state = seed;
    let mut random = || {
        // Marsaglia's xorshift: any numbers will do.
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let mut moved = mesh.clone();
    for p in &mut moved.positions {
        *p += Vec3::new(random(), random(), random()) * (amount * place.size);
    }
    moved
}

/// Where a point moves to.
pub type Motion = fn(Vec3) -> Vec3;

/// Motions of a mesh about the size of 1, from harmless to ruinous: each is
/// applied to the mesh before it moves.
pub const MOTIONS: [(&str, Motion); 9] = [
    ("a little", |p| p + Vec3::new(p.y, p.z, p.x) * 1e-3),
    ("ripples", |p| {
        p + p * (0.02 * (40.0 * p.x).sin() * (40.0 * p.y).sin())
    }),
    ("crumpled", |p| {
        Vec3::new(
            (5.0 * p.x + 3.0 * p.y).sin(),
            (4.0 * p.y - 2.0 * p.z).sin(),
            (6.0 * p.z + p.x).sin(),
        )
    }),
    ("inside out", |p| -p),
    ("flat", |p| Vec3::new(p.x, p.y, 0.0)),
    ("a line", |p| Vec3::new(p.x, 0.0, 0.0)),
    ("a point", |_| Vec3::splat(0.3)),
    ("far and small", |p| p * 1e-3 + Vec3::new(1e6, -2e6, 3e5)),
    ("as before", |p| p),
];

/// The mesh with every vertex moved.
pub fn with_positions(mesh: &Mesh, motion: Motion) -> Mesh {
    Mesh {
        positions: mesh.positions.iter().map(|&p| motion(p)).collect(),
        faces: mesh.faces.clone(),
    }
}
