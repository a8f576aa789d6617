//! Spheres among the triangles of a mesh: icospheres under some affine map, each of which is one
//! thing to a tree.
//!
//! All faces lie between an inner and an outer sphere. Where a ray passes between them, its
//! direction from the centre tells which face it can hit, and that is tested exactly as any other:
//! answers are those of brute force, to the bit. A segment that begins outside and ends inside of
//! both is known to hit something. All of it in coordinates in which the sphere is the unit sphere,
//! with a margin for rounding.

use std::ops::Range;
use std::sync::Arc;

use capwalk_math::Vec3;

use super::passage::Passage;
use super::ray_kernel::{LANES, LocalRay, TriangleBlock};
use super::sphere_grid::{Along, SphereGrid};
use crate::bvh::Hierarchy;
use crate::mesh::Mesh;
use crate::ray::Hit;
use crate::simd::Simd;

/// Spheres with a smaller frequency, which have fewer than 320 faces, are triangles like others.
const LEAST_FREQUENCY: u32 = 4;

/// Those with a larger one, which have millions of faces, are, too.
const LARGEST_FREQUENCY: u32 = 1000;

/// How far vertices may be from those of the unit sphere.
const DEVIATION: f64 = 1e-9;

/// What is computed in the sphere's coordinates is off by no more than `MARGIN[0] + MARGIN[1] r`: the
/// deviation, and sixty-four roundings, where `r` is how far the origin of the line is from the centre
/// in the world and how large the sphere is there, times the stretch.
const MARGIN: [f64; 2] = [4.0 * DEVIATION, 1.0 / (1_u64 << 47) as f64];

/// What is a thousand times as long as it is thin is no sphere: distances along rays, which are measured
/// in the world, would be too rough.
const LARGEST_REACH: f64 = 1000.0;

/// With a larger margin the sphere is searched as a tree.
const LARGEST_MARGIN: f64 = 1e-4;

/// Squares of the lengths of directions are within these limits, or the sphere is searched as a tree.
const SQUARES: [f64; 2] = [1e-300, 1e300];

/// A face is hit where the line meets it, or so many margins from there at most, if the sine of the
/// angle between them is larger than this: each of the weights that a distance is made of is off by a
/// tenth of that, over the sine. Along others a line may hit a face anywhere.
const STEEP: f64 = 0.1;
const MARGINS_OF_STEEP: f64 = 100.0;

/// One of the spheres of a mesh.
#[derive(Clone, Debug)]
pub struct MeshSphere {
    grid: Arc<SphereGrid>,
    first_face: u32,
    first_vertex: u32,
    /// True if faces are wound the other way round.
    is_reversed: bool,
    /// Those of its vertices, world units.
    positions: Vec<Vec3>,
    centre: Vec3,
    /// The map to its coordinates from where the centre is 0, and back.
    rows: [Vec3; 3],
    world_rows: [Vec3; 3],
    /// Distances there are no longer than this times those in the world.
    stretch: f64,
    /// The corners of the box around it in the world, and half its extents; these added up, times
    /// the stretch.
    corners: [Vec3; 2],
    half: Vec3,
    reach: f64,
}

impl MeshSphere {
    /// The spheres of a mesh, in the order of their faces. Some had been found before it moved, whose
    /// tables are used again.
    pub fn all(mesh: &Mesh, before: &[Arc<Self>]) -> Vec<Arc<Self>> {
        let mut grids: Vec<Arc<SphereGrid>> = Vec::new();
        for sphere in before {
            if !grids.iter().any(|grid| Arc::ptr_eq(grid, &sphere.grid)) {
                grids.push(sphere.grid.clone());
            }
        }
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
        let half = (high - low) * 0.5;
        let stretch = rows.map(Vec3::length_squared).iter().sum::<f64>().sqrt();
        let reach = stretch * (half.x + half.y + half.z);
        (reach < LARGEST_REACH).then_some(Self {
            first_face: first_face as u32,
            first_vertex,
            is_reversed,
            centre,
            rows,
            world_rows: world_from_unit.rows,
            stretch,
            corners: [low, high],
            half,
            reach,
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

    /// The first of its vertices, which are consecutive.
    pub fn first_vertex(&self) -> u32 {
        self.first_vertex
    }

    /// True if all corners of one of its faces are so near to a plane, which has a point and a unit
    /// normal.
    pub fn lies_in_plane(&self, [point, normal]: [Vec3; 2], within: f64) -> bool {
        // Only planes that touch it, or nearly do, have such faces.
        let [x, y, z] = self.world_rows;
        let largest = (x * normal.x + y * normal.y + z * normal.z).length();
        let height = normal.dot(self.centre - point).abs();
        let is_beside = height > largest + within || height < self.grid.inner * largest - within;
        let is_near = |p: Vec3| normal.dot(p - point).abs() <= within;
        let mut faces = 0..self.faces().len() as u32;
        !is_beside && faces.any(|face| self.corners_of(face).into_iter().all(is_near))
    }

    /// The corners of the box around it.
    pub fn corners(&self) -> [Vec3; 2] {
        self.corners
    }

    /// The vertices of one of its faces, all counted from its first, in their order in the mesh.
    #[inline(always)]
    pub fn vertices_of(&self, face: u32) -> [u32; 3] {
        let [a, b, c] = self.grid.faces[face as usize];
        if self.is_reversed {
            [a, c, b]
        } else {
            [a, b, c]
        }
    }

    /// The corners of one of its faces, counted from its first, in their order in the mesh.
    #[inline(always)]
    pub fn corners_of(&self, face: u32) -> [Vec3; 3] {
        self.vertices_of(face).map(|i| self.positions[i as usize])
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

    /// How a line in the world passes it, without a branch.
    #[inline(always)]
    pub fn passage(&self, origin: Vec3, world_direction: Vec3) -> Passage {
        let from = origin - self.centre;
        let distance = from.x.abs() + from.y.abs() + from.z.abs();
        let margin = MARGIN[0] + MARGIN[1] * (self.stretch * distance + self.reach);
        let origin = times(self.rows, from);
        let direction = times(self.rows, world_direction);
        let square = direction.length_squared();
        let middle = -origin.dot(direction) / square;
        let nearest = (origin + direction * middle).length_squared();
        let (largest, least) = (1.0 + margin, self.grid.inner - margin);
        let within_outer = largest * largest - nearest;
        let within_inner = least * least - nearest;
        let speed = square.sqrt();
        let per_length = 1.0 / speed;
        // Distances along rays are measured along the axis on which they are fastest in the world;
        // along it the sphere is so long, in units of its own.
        let Vec3 { x, y, z } = world_direction.map(f64::abs);
        let is_x = (x >= y) & (x >= z);
        let is_y = y >= z;
        let (half_yz, fastest_yz) = if is_y {
            (self.half.y, y)
        } else {
            (self.half.z, z)
        };
        let (half, fastest) = if is_x {
            (self.half.x, x)
        } else {
            (half_yz, fastest_yz)
        };
        let length = 1.0 + half * speed / fastest;
        // The sine of the angle between the line and the sphere; faces are tilted by less than
        // their width.
        let steepness = within_inner.max(0.0).sqrt();
        let width = self.grid.width_of_face;
        let is_steep = steepness > width + STEEP;
        let slack = if is_steep {
            MARGINS_OF_STEEP * margin
        } else {
            width
        };
        let meets_inner = within_inner > 0.0;
        Passage {
            origin,
            direction,
            margin,
            middle,
            outer: within_outer.max(0.0).sqrt() * per_length,
            inner: if meets_inner {
                steepness * per_length
            } else {
                -1.0
            },
            slack: slack * length * per_length,
            // False for NaN.
            is_known: (margin < LARGEST_MARGIN) & (square > SQUARES[0]) & (square < SQUARES[1]),
            meets: within_outer >= 0.0,
        }
    }

    /// The faces, counted from its first, that a ray may hit on a way of its passage, within bounds.
    #[inline(always)]
    pub fn along(&self, passage: &Passage, way: [f64; 2], bounds: [f64; 2]) -> Along {
        let start = way[0].max(bounds[0] - passage.slack);
        let end = way[1].min(bounds[1] + passage.slack);
        if start > end {
            return Along::NONE;
        }
        let at = |t: f64| passage.origin + passage.direction * t;
        self.grid.along([at(start), at(end)], passage.margin)
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
        let along = self.along(passage, way, bounds);
        let Some(faces) = along.faces() else {
            return false;
        };
        for faces in faces.chunks(LANES) {
            self.block(faces).intersect(simd, local, bounds, &mut found);
        }
        true
    }
}

/// The frequency of the icosphere that may begin with these faces, by how they are numbered.
fn frequency_at(faces: &[[u32; 3]]) -> Option<u32> {
    let [first, second, third, ..] = faces else {
        return None;
    };
    let vertex = |i: u32| first[0].wrapping_add(i);
    let sorted = |[a, b, c]: [u32; 3]| [a, b.min(c), b.max(c)];
    let begins = sorted(*first) == [0, 1, 2].map(vertex)
        && sorted(*second) == [1, 2, 3].map(vertex)
        && sorted(*third) == [1, 3, 4].map(vertex);
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
