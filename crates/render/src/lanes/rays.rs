//! Rays of lanes: in packets where single precision resolves the scene and rays that were reflected at
//! random still have something in common, else in bundles, which find what single rays do.

use capwalk_boundary::Accel;
use capwalk_geometry::{BUNDLE, Bundle, PacketTree, Ray};

use crate::lanes::in_view::nearest_in_view;
use crate::lanes::scene::NOTHING;
use crate::lanes::vectors::{LANES, Numbers, Vectors, lanes_of};

const _: () = assert!(LANES == BUNDLE);

/// The range of rays that start where something was met.
pub const ALL_BEHIND: [Numbers; 2] = [[0.0; LANES], [f64::INFINITY; LANES]];

/// In scenes of more triangles and spheres, rays that were reflected at random have little in common.
const MOST_PIECES: usize = 1024;

/// What lies in a plane is at most this part of a pixel where the nearest surface in view may be.
const NEAREST: f64 = 2e-3;

/// How many levels of the tree take a ray of a packet an effort of one: measured on a diffuse room
/// of 36 triangles when there were eight lanes.
const LEVELS_PER_EFFORT: u64 = 3;
/// The effort of a ray of a bundle, for each level.
const EFFORT_OF_LEVEL: u64 = 2;

/// In which precision rays meet surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayPrecision {
    /// Single where that resolves the scene, else double.
    Resolving,
    /// Double everywhere.
    Double,
}

/// What rays meet.
pub struct Meets<'a> {
    accel: &'a Accel,
    packets: Option<PacketTree>,
    /// Where rays start that do not meet again the surfaces on which they begin.
    beyond_surfaces: Numbers,
    levels: u64,
}

/// A ray of each lane. Those without a bit in the mask are not asked for.
pub struct LaneRays<'a> {
    pub origin: &'a Vectors,
    /// Unit directions.
    pub direction: &'a Vectors,
    /// Distances between which something is met.
    pub range: &'a [Numbers; 2],
    /// True if they start at surfaces, which they do not meet again.
    pub from_surfaces: bool,
    pub mask: u32,
}

impl<'a> Meets<'a> {
    /// All surfaces of a scene.
    pub fn new(accel: &'a Accel, precision: RayPrecision) -> Self {
        let packets = match precision {
            RayPrecision::Resolving => packets(accel),
            RayPrecision::Double => None,
        };
        let pieces = match packets {
            Some(_) => accel.rays().piece_count(),
            None => accel.mesh.faces.len(),
        };
        Self {
            accel,
            packets,
            beyond_surfaces: [accel.horizon_distance(); LANES],
            levels: u64::from(pieces.max(1).ilog2() + 2),
        }
    }

    /// True if rays come in packets.
    pub fn has_packets(&self) -> bool {
        self.packets.is_some()
    }

    /// True if rays know by themselves the surfaces on which they start and end: planes, in packets.
    fn know_surfaces(&self) -> bool {
        (self.packets.as_ref()).is_some_and(|tree| !tree.has_spheres())
    }

    /// The effort of so many rays.
    pub fn effort(&self, rays: u64) -> u64 {
        match self.packets {
            Some(_) => rays * self.levels / LEVELS_PER_EFFORT,
            None => rays * self.levels * EFFORT_OF_LEVEL,
        }
    }

    /// The nearest face that each ray meets, of those that are asked for.
    pub fn first_hits(&self, rays: &LaneRays<'_>) -> [u32; LANES] {
        let [start, end] = rays.range.each_ref();
        let range = match rays.from_surfaces && !self.know_surfaces() {
            true => [&self.beyond_surfaces, end],
            false => [start, end],
        };
        if let Some(tree) = &self.packets {
            return tree.first_hits(&rays.bundle(range));
        }
        if !self.accel.has_flush_emitters() {
            return self.accel.rays().first_hits(&rays.bundle(range));
        }
        let mut faces = [NOTHING; LANES];
        for lane in lanes_of(rays.mask) {
            let hit = self.accel.first_hit_within(&Ray {
                origin: rays.origin.get(lane),
                direction: rays.direction.get(lane),
                t_min: range[0][lane],
                t_max: range[1][lane],
            });
            faces[lane] = hit.map_or(NOTHING, |hit| hit.face);
        }
        faces
    }

    /// One bit for each ray that meets something before its end.
    pub fn occluded(&self, rays: &LaneRays<'_>) -> u32 {
        let shorter;
        let range = match self.know_surfaces() {
            true => rays.range,
            false => {
                shorter = self.accel.ranges_to_targets(&rays.range[1]);
                &shorter
            }
        };
        let bundle = rays.bundle(range.each_ref());
        match &self.packets {
            Some(tree) => tree.occluded(&bundle),
            None => self.accel.rays().occluded_rays(&bundle),
        }
    }
}

/// A tree for packets, where rays are to come in packets.
fn packets(accel: &Accel) -> Option<PacketTree> {
    let mesh = &accel.mesh;
    let rays = accel.rays();
    let are_few = rays.piece_count() <= MOST_PIECES;
    let may_be = are_few && !accel.has_flush_emitters() && !accel.view.is_parallel();
    let tree = may_be.then(|| PacketTree::new(rays, mesh))?;
    let pixel = NEAREST * accel.view.pixel_size() * nearest_in_view(accel);
    (tree.in_plane() <= pixel && tree.resolves(rays, mesh)).then_some(tree)
}

impl LaneRays<'_> {
    /// The rays, between some distances.
    fn bundle<'b>(&'b self, range: [&'b Numbers; 2]) -> Bundle<'b> {
        Bundle {
            origin: &self.origin.0,
            direction: &self.direction.0,
            range,
            mask: self.mask,
        }
    }
}
