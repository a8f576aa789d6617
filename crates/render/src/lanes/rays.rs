//! Rays of lanes, packet by packet.

use std::array;

use capwalk_geometry::{Packet, PacketTree, RAYS};

use crate::lanes::scene::NOTHING;
use crate::lanes::vectors::{LANES, Numbers, Vectors};

const _: () = assert!(LANES.is_multiple_of(RAYS));

/// The range of rays that start where something was met.
pub const ALL_BEHIND: [Numbers; 2] = [[0.0; LANES], [f64::INFINITY; LANES]];

/// A ray of each lane. Those without a bit in the mask are not asked for.
pub struct LaneRays<'a> {
    pub origin: &'a Vectors,
    /// Unit directions.
    pub direction: &'a Vectors,
    /// Distances between which something is met.
    pub range: &'a [Numbers; 2],
    pub mask: u32,
}

impl LaneRays<'_> {
    /// The nearest face that each ray meets, in those it is asked for.
    pub fn first_hits(&self, tree: &PacketTree) -> [u32; LANES] {
        let mut faces = [NOTHING; LANES];
        for (first, packet) in self.packets() {
            faces[first..first + RAYS].copy_from_slice(&tree.first_hits(&packet));
        }
        faces
    }

    /// One bit for each ray that meets something.
    pub fn occluded(&self, tree: &PacketTree) -> u32 {
        let packets = self.packets();
        packets.fold(0, |mask, (first, packet)| {
            mask | tree.occluded(&packet) << first
        })
    }

    /// The packets in which any ray is asked for, and the first lane of each.
    fn packets(&self) -> impl Iterator<Item = (usize, Packet<'_>)> {
        (0..LANES / RAYS).filter_map(|packet| {
            let mask = self.mask >> (packet * RAYS) & ((1 << RAYS) - 1);
            (mask != 0).then(|| {
                let rays = Packet {
                    origin: part(&self.origin.0, packet),
                    direction: part(&self.direction.0, packet),
                    range: part(self.range, packet),
                    mask,
                };
                (packet * RAYS, rays)
            })
        })
    }
}

/// The numbers of a packet.
#[inline]
fn part<const K: usize>(numbers: &[Numbers; K], packet: usize) -> [&[f64; RAYS]; K] {
    array::from_fn(|row| &numbers[row].as_chunks().0[packet])
}
