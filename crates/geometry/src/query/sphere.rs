//! Spheres among the triangles of a mesh: icospheres under some affine map, each of which is one
//! thing to a tree.
//!
//! All faces lie between an inner and an outer sphere. Where a ray passes between them, its
//! direction from the centre tells which face it can hit, and that is tested exactly as any other:
//! answers are those of brute force, to the bit. A segment that begins outside and ends inside of
//! both is known to hit something. All of it in coordinates in which the sphere is the unit sphere,
//! with a margin for all rounding.

use std::ops::Range;
use std::sync::Arc;

use capwalk_math::Vec3;

use super::ray_kernel::{LANES, LocalRay, TriangleBlock};
use super::sphere_grid::SphereGrid;
use crate::bvh::Hierarchy;
use crate::mesh::Mesh;
use crate::ray::{Hit, Ray};
use crate::simd::Simd;

/// Spheres with a smaller frequency, which have fewer than 320 faces, are triangles like others.
const LEAST_FREQUENCY: u32 = 4;

/// Those with a larger one are, too: their tables would be as large as they are.
const LARGEST_FREQUENCY: u32 = 1000;

/// How far vertices may be from those of the unit sphere.
const DEVIATION: f64 = 1e-9;

/// What is computed in the sphere's coordinates is off by no more than `MARGIN[0] + MARGIN[1] r`, on
/// a line whose origin is `r` from the centre: the deviation, and sixty-four roundings.
const MARGIN: [f64; 2] = [4.0 * DEVIATION, 1.0 / (1_u64 << 47) as f64];

/// With a larger margin the sphere is searched as a tree.
const LARGEST_MARGIN: f64 = 1e-4;

/// Components of directions are within these limits, or the sphere is searched as a tree.
const SPEEDS: [f64; 2] = [1e-150, 1e150];

/// Rays whose angle to the faces has a larger sine hit them where they meet them, but for so many
/// times the margin: each of the weights that a distance is made of is off by a tenth of that, over
/// the sine. Others may hit a face anywhere on their way along it.
const STEEP: f64 = 0.1;
const MARGINS_OF_STEEP: f64 = 100.0;

/// One of the spheres of a mesh.
#[derive(Clone, Debug)]
pub struct Sphere {
    grid: Arc<SphereGrid>,
    first_face: u32,
    /// True if faces are wound the other way round.
    is_reversed: bool,
    /// Those of its vertices, world units.
    positions: Vec<Vec3>,
    centre: Vec3,
    /// The map to its coordinates from where the centre is 0.
    rows: [Vec3; 3],
    /// Distances there are no longer than this times those in the world.
    stretch: f64,
    /// The corners of the box around it.
    corners: [Vec3; 2],
}

/// Where a line passes a sphere, as distances along it.
pub struct Passage {
    origin: Vec3,
    direction: Vec3,
    margin: f64,
    /// Where it is next to the centre, how long before and after it is within the outer sphere,
    /// and how long in the inner one, if it meets that.
    middle: f64,
    outer: f64,
    inner: Option<f64>,
    /// Hits may be found so much before or after where the line meets the face.
    slack: f64,
}

/// How a line lies to a sphere.
pub enum Meeting {
    /// No face is hit.
    Misses,
    Passes(Passage),
    /// Double precision does not tell.
    Unknown,
}

impl Sphere {
    /// The spheres of a mesh, in the order of their faces.
    pub fn all(mesh: &Mesh) -> Vec<Arc<Self>> {
        let mut grids: Vec<Arc<SphereGrid>> = Vec::new();
        let mut spheres = Vec::new();
        let mut face = 0;
        while face < mesh.faces.len() {
            let found = frequency_at(&mesh.faces[face..]).and_then(|frequency| {
                let known = grids.iter().find(|grid| grid.frequency == frequency);
                let grid = known.cloned().unwrap_or_else(|| {
                    grids.push(Arc::new(SphereGrid::new(frequency)));
                    grids[grids.len() - 1].clone()
                });
                Self::new(grid, mesh, face)
            });
            face += found.as_ref().map_or(1, |sphere| sphere.grid.faces.len());
            spheres.extend(found.map(Arc::new));
        }
        spheres
    }

    /// The sphere whose faces begin with this one; `None` if they are no sphere.
    fn new(grid: Arc<SphereGrid>, mesh: &Mesh, first_face: usize) -> Option<Self> {
        let faces = mesh.faces.get(first_face..first_face + grid.faces.len())?;
        let first_vertex = faces[0][0];
        let is_reversed = faces[0][1] > faces[0][2];
        let pairs = faces.iter().zip(&grid.faces);
        let are_same = pairs.into_iter().all(|(own, &[a, b, c])| {
            let [b, c] = if is_reversed { [c, b] } else { [b, c] };
            *own == [a, b, c].map(|vertex| first_vertex.wrapping_add(vertex))
        });
        if !are_same {
            return None;
        }
        let first = first_vertex as usize;
        let positions = mesh.positions[first..first + grid.directions.len()].to_vec();
        let world_from_unit = grid.map_to(&positions);
        let unit_from_world = world_from_unit.inverse()?;
        let (rows, centre) = (unit_from_world.rows, world_from_unit.translation);
        let unit = |p: Vec3| times(rows, p - centre);
        let mut pairs = positions.iter().zip(&grid.directions);
        if !pairs.all(|(&p, &u)| (unit(p) - u).length() < DEVIATION) {
            return None; // also for NaN
        }
        let low = positions.iter().fold(positions[0], |low, &p| low.min(p));
        let high = positions.iter().fold(positions[0], |high, &p| high.max(p));
        Some(Self {
            first_face: first_face as u32,
            is_reversed,
            centre,
            rows,
            stretch: rows.map(Vec3::length_squared).iter().sum::<f64>().sqrt(),
            corners: [low, high],
            positions,
            grid,
        })
    }

    /// The same faces of a mesh whose vertices moved; `None` if they are no sphere any more.
    pub fn moved(&self, mesh: &Mesh) -> Option<Self> {
        Self::new(self.grid.clone(), mesh, self.first_face as usize)
    }

    /// The numbers of its faces.
    pub fn faces(&self) -> Range<u32> {
        self.first_face..self.first_face + self.grid.faces.len() as u32
    }

    /// The corners of the box around it.
    pub fn corners(&self) -> [Vec3; 2] {
        self.corners
    }

    /// The corners of one of its faces, counted from its first, in their order in the mesh.
    #[inline(always)]
    pub fn corners_of(&self, face: u32) -> [Vec3; 3] {
        let [a, b, c] = self.grid.faces[face as usize].map(|i| self.positions[i as usize]);
        if self.is_reversed {
            [a, c, b]
        } else {
            [a, b, c]
        }
    }

    /// A tree over its faces, counted from its first.
    pub fn hierarchy(&self) -> &Hierarchy {
        self.grid.hierarchy()
    }

    /// A block of some of its faces, counted from its first.
    #[inline(always)]
    pub fn block(&self, faces: &[u32]) -> TriangleBlock {
        let mut block = TriangleBlock::EMPTY;
        for (lane, &face) in faces.iter().enumerate() {
            block.set(lane, self.first_face + face, self.corners_of(face));
        }
        block
    }

    /// How a ray meets it within bounds.
    #[inline(always)]
    pub fn meet(&self, ray: &Ray, [t_min, t_max]: [f64; 2]) -> Meeting {
        let from = ray.origin - self.centre;
        let margin =
            MARGIN[0] + MARGIN[1] * self.stretch * (from.x.abs() + from.y.abs() + from.z.abs());
        let direction = times(self.rows, ray.direction);
        let speed = direction.map(f64::abs).max_component();
        let is_known = margin < LARGEST_MARGIN && SPEEDS[0] < speed && speed < SPEEDS[1];
        if !is_known {
            return Meeting::Unknown; // also for NaN
        }
        let origin = times(self.rows, from);
        let square = direction.length_squared();
        let middle = -origin.dot(direction) / square;
        let distance = (origin + direction * middle).length_squared();
        let within = |radius: f64| radius * radius - distance;
        if within(1.0 + margin) < 0.0 {
            return Meeting::Misses;
        }
        let speed = square.sqrt();
        let inner = within(self.grid.inner - margin);
        // The sine of the angle between the line and the sphere; faces are tilted by less than
        // their width.
        let steepness = inner.max(0.0).sqrt();
        let width = self.grid.width_of_face;
        let slack = match steepness > width + STEEP {
            true => MARGINS_OF_STEEP * margin,
            false => width,
        } / speed;
        let outer = within(1.0 + margin).sqrt() / speed;
        if t_min > middle + outer + slack || t_max < middle - outer - slack {
            return Meeting::Misses;
        }
        Meeting::Passes(Passage {
            origin,
            direction,
            margin,
            middle,
            outer,
            inner: (inner > 0.0).then_some(steepness / speed),
            slack,
        })
    }

    /// Calls `found` for each triangle that the ray hits on a way of its passage, within its bounds;
    /// false if they may be too many.
    #[inline(always)]
    pub fn intersect<S: Simd>(
        &self,
        simd: S,
        local: &LocalRay<S>,
        passage: &Passage,
        way: [f64; 2],
        bounds: [f64; 2],
        mut found: impl FnMut(Hit),
    ) -> bool {
        let start = way[0].max(bounds[0] - passage.slack);
        let end = way[1].min(bounds[1] + passage.slack);
        if start > end {
            return true;
        }
        let at = |t: f64| passage.origin + passage.direction * t;
        let along = self.grid.along([at(start), at(end)], passage.margin);
        let Some(faces) = along.faces() else {
            return false;
        };
        for faces in faces.chunks(LANES) {
            self.block(faces).intersect(simd, local, bounds, &mut found);
        }
        true
    }
}

impl Passage {
    /// Between which distances the line is between the outer and the inner sphere: on one way or
    /// two, the nearer first.
    #[inline(always)]
    pub fn ways(&self) -> [Option<[f64; 2]>; 2] {
        let Self { middle, outer, .. } = *self;
        match self.inner {
            None => [Some([middle - outer, middle + outer]), None],
            Some(inner) => [
                Some([middle - outer, middle - inner]),
                Some([middle + inner, middle + outer]),
            ],
        }
    }

    /// True if the ray goes in from outside, or out from inside, within its bounds: then it hits a
    /// face, the mesh being closed.
    #[inline(always)]
    pub fn surely_hits(&self, [t_min, t_max]: [f64; 2]) -> bool {
        let is_within =
            |[start, end]: [f64; 2]| t_min < start - self.slack && end + self.slack < t_max;
        match self.ways() {
            [Some(inward), Some(outward)] => is_within(inward) || is_within(outward),
            _ => false,
        }
    }
}

/// The frequency of the icosphere that may begin with these faces, by how they are numbered.
fn frequency_at(faces: &[[u32; 3]]) -> Option<u32> {
    let [first, second, ..] = faces else {
        return None;
    };
    let vertex = |i: u32| first[0].wrapping_add(i);
    let sorted = |[a, b, c]: [u32; 3]| [a, b.min(c), b.max(c)];
    let begins =
        sorted(*first) == [0, 1, 2].map(vertex) && sorted(*second) == [1, 2, 3].map(vertex);
    // Its second row begins with the third vertex.
    let most = 2 * LARGEST_FREQUENCY as usize;
    let row = begins.then(|| {
        faces
            .iter()
            .take(most)
            .position(|face| face[0] == vertex(2))
    })??;
    let frequency = row.div_ceil(2) as u32;
    // Those that are not tell by their last face, as a rule.
    let last = faces.get(sphere_faces(frequency) - 1)?;
    let vertices = 10 * frequency * frequency + 2;
    let is_one = last
        .iter()
        .all(|i| (0..vertices).contains(&i.wrapping_sub(first[0])));
    (frequency >= LEAST_FREQUENCY && is_one).then_some(frequency)
}

fn sphere_faces(frequency: u32) -> usize {
    20 * (frequency as usize).pow(2)
}

#[inline(always)]
fn times([a, b, c]: [Vec3; 3], v: Vec3) -> Vec3 {
    Vec3::new(a.dot(v), b.dot(v), c.dot(v))
}
