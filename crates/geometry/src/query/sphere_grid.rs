//! Which faces of an icosphere lie in which directions from its centre.
//!
//! Seen from the centre, the faces in one face of the icosahedron are a regular grid, and great
//! circles are straight: the weights of a direction, as a point of that face, give its place in the
//! grid.

use std::sync::OnceLock;

use capwalk_math::{Affine, Vec3};

use super::ray_kernel::LANES;
use crate::aabb::Aabb;
use crate::bvh::{Hierarchy, Leaves, Splits, build};
use crate::halt::Halt;
use crate::icosphere::{icosahedron, icosphere};

/// Faces of an icosahedron.
const BASES: usize = 20;

/// No more faces may be met along a part of a line between the inner and the outer sphere; where they
/// could be more, the sphere is searched as a tree.
pub const MOST_ALONG: usize = 64;

/// No edge is longer than this over the frequency: those next to the middle of a face of the
/// icosahedron are the longest.
const WIDTH_OF_FACE: f64 = 1.4;

/// The cosine of the angle from the middle of a face of the icosahedron to a corner, or a little
/// less.
const TO_CORNER: f64 = 0.79;

/// The angle between two directions is no larger than this times the distance between points
/// within the faces, and a little more.
const ANGLE_OF_LENGTH: f64 = 1.1;

/// The faces of an icosphere with centre 0 and radius 1.
#[derive(Debug)]
pub struct SphereGrid {
    pub frequency: u32,
    /// The vertices.
    pub directions: Vec<Vec3>,
    pub faces: Vec<[u32; 3]>,
    /// The radius of the largest sphere inside.
    pub inner: f64,
    /// No two points of a face are farther apart.
    pub width_of_face: f64,
    /// For each face of the icosahedron, what gives the weights of a direction, up to a factor;
    /// and the unit vector to its middle.
    weights: [[Vec3; 3]; BASES],
    middles: [Vec3; BASES],
    /// By [`kind_of`]: which of the faces contains a direction.
    base_of_kind: [[u8; 8]; 4],
    hierarchy: OnceLock<Hierarchy>,
}

/// Numbers of faces.
pub struct Along {
    faces: [u32; MOST_ALONG],
    count: usize,
}

impl Along {
    pub const NONE: Self = Self {
        faces: [0; MOST_ALONG],
        count: 0,
    };

    /// The faces; `None` if they were too many to be kept.
    #[inline(always)]
    pub fn faces(&self) -> Option<&[u32]> {
        self.faces.get(..self.count)
    }

    #[inline(always)]
    fn push(&mut self, face: u32) {
        if let Some(place) = self.faces.get_mut(self.count) {
            *place = face;
        }
        self.count += 1;
    }
}

impl SphereGrid {
    /// That of [`icosphere`] with this frequency.
    pub fn new(frequency: u32) -> Self {
        let mesh = icosphere(frequency);
        let depth = |face| {
            mesh.face_cross(face)
                .normalized()
                .dot(mesh.corners(face)[0])
        };
        let inner = (0..mesh.faces.len()).map(depth).fold(1.0, f64::min);
        let (corners, bases) = icosahedron();
        let corners = |base: usize| -> [Vec3; 3] {
            let own: [u32; 3] = bases[base];
            own.map(|corner| corners[corner as usize].normalized())
        };
        let weights = std::array::from_fn(|base| {
            let [a, b, c] = corners(base);
            [b.cross(c), c.cross(a), a.cross(b)].map(|row| row / a.dot(b.cross(c)))
        });
        let middles = std::array::from_fn(|base| {
            let [a, b, c] = corners(base);
            (a + b + c).normalized()
        });
        let mut base_of_kind = [[0; 8]; 4];
        for (base, middle) in middles.iter().enumerate() {
            // A middle in a plane of symmetry has the signs of both sides.
            for signs in 0..8 {
                let moved: [f64; 3] = std::array::from_fn(|axis| {
                    let sign = if signs >> axis & 1 == 1 { -1e-3 } else { 1e-3 };
                    middle[axis] + sign
                });
                let (kind, signs) = kind_of(moved.into());
                base_of_kind[kind][signs] = base as u8;
            }
        }
        Self {
            frequency,
            directions: mesh.positions,
            faces: mesh.faces,
            inner,
            width_of_face: WIDTH_OF_FACE / f64::from(frequency),
            weights,
            middles,
            base_of_kind,
            hierarchy: OnceLock::new(),
        }
    }

    /// The map that takes its vertices to these points as well as any.
    pub fn map_to(&self, positions: &[Vec3]) -> Affine {
        let count = positions.len() as f64;
        let sum = |of: &dyn Fn(Vec3, Vec3) -> Vec3| {
            let pairs = positions.iter().zip(&self.directions);
            pairs.fold(Vec3::zero(), |sum, (&p, &u)| sum + of(p, u)) / count
        };
        let centre = sum(&|p, _| p);
        // The vertices are spread as evenly along each axis: the mean of u uᵀ is a third.
        let column = |axis: usize| sum(&|p, u: Vec3| (p - centre) * (3.0 * u[axis]));
        let columns = [column(0), column(1), column(2)];
        let row = |axis: usize| Vec3::from(columns.map(|column| column[axis]));
        Affine {
            rows: [row(0), row(1), row(2)],
            translation: centre,
        }
    }

    /// A tree over the faces, made when first asked for. By one thread: another task of this thread
    /// that asked for it meanwhile would wait for itself.
    pub fn hierarchy(&self) -> &Hierarchy {
        self.hierarchy.get_or_init(|| {
            let corners = |face: &[u32; 3]| face.map(|i| self.directions[i as usize]);
            let bounds: Vec<Aabb> = self
                .faces
                .iter()
                .map(|face| Aabb::around(corners(face)))
                .collect();
            build(&bounds, Leaves::of(LANES), Splits::Alone, &Halt::never())
        })
    }

    /// The faces that a line crosses between two points within the faces, and a few more: all
    /// that come as near to it as the margin, seen from the centre.
    #[inline(always)]
    pub fn along(&self, ends: [Vec3; 2], margin: f64) -> Along {
        let frequency = f64::from(self.frequency);
        // A grid cell is about a radian wide over the frequency, and up to twice as narrow.
        let margin = 4.0 * margin * frequency;
        let mut along = Along::NONE;
        let (kind, signs) = kind_of(ends[0]);
        let base = usize::from(self.base_of_kind[kind][signs]);
        let places = ends.map(|p| self.place(base, p));
        let [[a, b, c], [d, e, f]] = places;
        let is_in_one = a.min(b).min(c).min(d).min(e).min(f) > margin;
        if is_in_one {
            self.add_cells(base, places, margin, &mut along);
        } else {
            self.add_from_all(ends, margin, &mut along);
        }
        along
    }

    /// [`Self::along`] for a line that is not in one face of the icosahedron.
    #[cold]
    fn add_from_all(&self, ends: [Vec3; 2], margin: f64, along: &mut Along) {
        // Lines are so short that the place of both ends in the grid is known where one of the
        // points between them is in it: an angle of 25° at most, for the smallest frequency.
        let [start, end] = ends;
        let near = TO_CORNER - ANGLE_OF_LENGTH * (end - start).length();
        let (start_near, end_near) = (near * start.length(), near * end.length());
        for base in 0..BASES {
            let middle = self.middles[base];
            if middle.dot(start) > start_near && middle.dot(end) > end_near {
                let places = ends.map(|p| self.place(base, p));
                self.add_cells(base, places, margin, along);
            }
        }
    }

    /// The place of a direction in the grid of a face of the icosahedron: its weights times the
    /// frequency.
    #[inline(always)]
    fn place(&self, base: usize, p: Vec3) -> [f64; 3] {
        let [a, b, c] = self.weights[base].map(|row| row.dot(p));
        let scale = f64::from(self.frequency) / (a + b + c);
        [a * scale, b * scale, c * scale]
    }

    /// Adds the faces that may meet the straight line between two places in the grid of a face of
    /// the icosahedron.
    #[inline(always)]
    fn add_cells(&self, base: usize, [from, to]: [[f64; 3]; 2], margin: f64, along: &mut Along) {
        let frequency = self.frequency as i32;
        let range = |i: usize| {
            let low = (from[i].min(to[i]) - margin).floor() as i32;
            let high = (from[i].max(to[i]) + margin).floor() as i32;
            [low.max(0), high.min(frequency - 1)]
        };
        let [first, second, third] = [range(0), range(1), range(2)];
        for row in third[0]..=third[1] {
            for place in second[0]..=second[1] {
                // Weights add up to the frequency: two triangles are in this row at this place,
                // whose first weights lie in neighbouring intervals.
                for lower in 0..=1 {
                    let top = frequency - 1 - row - place - lower;
                    if (first[0]..=first[1]).contains(&top) {
                        // As `icosphere` counts them.
                        let in_base = row * (2 * frequency - row) + 2 * place + lower;
                        along.push((base as i32 * frequency * frequency + in_base) as u32);
                    }
                }
            }
        }
    }
}

/// Which of the middles of the icosahedron's faces a direction is next to: they are (±1, ±1, ±1)
/// and (0, ±1/φ, ±φ) with its cyclic shifts. Which of the four, and the signs as bits.
#[inline(always)]
fn kind_of(p: Vec3) -> (usize, usize) {
    const PHI: f64 = 1.618_033_988_749_895;
    const INVERSE: f64 = PHI - 1.0;
    let Vec3 { x, y, z } = p.map(f64::abs);
    let nearness = [
        x + y + z,
        INVERSE * y + PHI * z,
        INVERSE * x + PHI * y,
        INVERSE * z + PHI * x,
    ];
    let mut kind = 0;
    for (other, &own) in nearness.iter().enumerate() {
        kind = if own > nearness[kind] { other } else { kind };
    }
    let sign = |v: f64| usize::from(v.is_sign_negative());
    (kind, sign(p.x) | sign(p.y) << 1 | sign(p.z) << 2)
}
