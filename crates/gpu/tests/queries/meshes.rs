//! Random meshes, and points and directions around them.

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    /// Between 0 and 1.
    pub fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ z >> 31) as f64 / 2.0_f64.powi(64)
    }

    pub fn below(&mut self, end: usize) -> usize {
        (self.number() * end as f64) as usize
    }

    /// In the cube between -1 and 1.
    pub fn point(&mut self) -> Vec3 {
        Vec3::from([0; 3].map(|_| 2.0 * self.number() - 1.0))
    }

    pub fn direction(&mut self) -> Vec3 {
        loop {
            let direction = self.point();
            if (0.01..1.0).contains(&direction.length_squared()) {
                return direction.normalized();
            }
        }
    }
}

/// A mesh, and where and how large it is.
pub struct Placed {
    pub name: String,
    pub mesh: Mesh,
    pub centre: Vec3,
    pub size: f64,
}

/// Closed and open ones, at several places and of several sizes.
pub fn all() -> Vec<Placed> {
    let mut random = Random(7);
    let grids = [
        ("torus", grid(24, 16, true, &mut random)),
        ("sheet", grid(17, 19, false, &mut random)),
        ("triangles", triangles(150, &mut random)),
        ("cube", cube()),
        ("triangle", triangles(1, &mut random)),
        ("spiral", spiral(300)),
    ];
    let places = [
        ("at the origin", Vec3::zero(), 1.0),
        ("far away", Vec3::new(3e5, -1e6, 7e4), 1.0),
        ("tiny", Vec3::new(1e-3, 0.0, 2e-3), 1e-6),
        ("huge", Vec3::new(0.0, 3e9, 0.0), 1e9),
        ("extreme", Vec3::zero(), 1e28),
    ];
    let mut all = Vec::new();
    for (shape, mesh) in &grids {
        for (place, centre, size) in places {
            let positions = mesh.positions.iter().map(|&p| centre + p * size).collect();
            all.push(Placed {
                name: format!("{shape}, {place}"),
                mesh: Mesh {
                    positions,
                    faces: mesh.faces.clone(),
                },
                centre,
                size,
            });
        }
    }
    all
}

impl Placed {
    /// A point to look from or at: around the mesh, far from it, on a vertex, on a face or
    /// on an edge.
    pub fn spot(&self, random: &mut Random) -> Vec3 {
        let face = random.below(self.mesh.faces.len());
        let [a, b, c] = self.mesh.corners(face);
        match random.below(8) {
            0 => a,
            1 => a + (b - a) * random.number(),
            2 => {
                let [u, v] = [random.number(), random.number()];
                a + (b - a) * (u * (1.0 - v)) + (c - a) * (u * v)
            }
            3 => self.centre + random.point() * (self.size * 300.0),
            _ => self.centre + random.point() * (self.size * 1.5),
        }
    }
}

/// A torus, or a sheet with holes, with noise.
pub fn grid(m: usize, n: usize, is_closed: bool, random: &mut Random) -> Mesh {
    let mut positions = Vec::new();
    for i in 0..m {
        for j in 0..n {
            let [u, v] =
                [(i, m), (j, n)].map(|(k, of)| std::f64::consts::TAU * k as f64 / of as f64);
            let p = if is_closed {
                let radius = 0.6 + 0.3 * v.cos();
                Vec3::new(radius * u.cos(), radius * u.sin(), 0.3 * v.sin())
            } else {
                Vec3::new(0.3 * u - 0.9, 0.3 * v - 0.9, 0.2 * (2.0 * u).sin())
            };
            positions.push(p + random.point() * 0.02);
        }
    }
    let (rows, columns) = if is_closed { (m, n) } else { (m - 1, n - 1) };
    let mut faces = Vec::new();
    for i in 0..rows {
        for j in 0..columns {
            let at = |i: usize, j: usize| (i % m * n + j % n) as u32;
            if is_closed || random.number() < 0.95 {
                faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
    }
    Mesh { positions, faces }
}

fn triangles(count: usize, random: &mut Random) -> Mesh {
    let positions = (0..count).flat_map(|_| {
        let [p, size] = [random.point(), random.point() * 0.3];
        [p, p + size.cross(random.point()), p + random.point() * 0.3]
    });
    Mesh {
        positions: positions.collect(),
        faces: (0..count as u32)
            .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
            .collect(),
    }
}

/// A ribbon that winds towards a point, smaller and smaller: its tree is deep.
pub fn spiral(count: u32) -> Mesh {
    let step = |i: u32| {
        let (sin, cos) = (0.3 * f64::from(i / 2)).sin_cos();
        let radius = 0.9_f64.powi((i / 2) as i32);
        let height = if i.is_multiple_of(2) { 0.0 } else { 0.1 };
        Vec3::new(cos, sin, height + 0.2) * radius
    };
    Mesh {
        positions: (0..count + 2).map(step).collect(),
        faces: (0..count).map(|i| [i, i + 1, i + 2]).collect(),
    }
}

fn cube() -> Mesh {
    let corner = |i: u32| Vec3::from([0, 1, 2].map(|axis| f64::from(i >> axis & 1) - 0.5));
    let quads = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    Mesh {
        positions: (0..8).map(corner).collect(),
        faces: quads
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect(),
    }
}

/// Diagonals of squares one behind the other.
pub fn slivers(count: u32) -> Mesh {
    let corners = |k: u32| {
        let z = f64::from(k) / f64::from(count);
        [[-2.0, -2.0, z], [2.0, 2.0, z], [2.0, 2.0, z + 1e-7]].map(Vec3::from)
    };
    Mesh {
        positions: (0..count).flat_map(corners).collect(),
        faces: (0..count).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
    }
}
