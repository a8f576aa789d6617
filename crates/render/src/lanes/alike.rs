//! Lanes that hit the same face: what they look up there is looked up once.

use capwalk_geometry::simd::{Computation, Simd};

use crate::lanes::scene::NOTHING;
use crate::lanes::vectors::LANES;

/// The face that lanes hit, or most of them where rays are coherent.
#[derive(Clone, Copy, Debug)]
pub struct Alike {
    faces: [u32; LANES],
    /// Those that hit the first one's face.
    same: u32,
    /// Those that hit nothing.
    pub missed: u32,
}

impl Alike {
    /// No lanes.
    pub const NONE: Self = Self {
        faces: [0; LANES],
        same: 0,
        missed: 0,
    };

    /// Faces, each with some lanes that hit it: those of the first face together, others one by one, all
    /// if they are among `lanes`.
    pub fn of(&self, lanes: u32) -> impl Iterator<Item = (u32, u32)> {
        let (faces, mut rest) = (self.faces, lanes);
        std::iter::from_fn(move || {
            let lane = rest.trailing_zeros() as usize;
            let face = *faces.get(lane)?;
            let one = 1 << lane;
            let found = if self.same & one != 0 {
                self.same & rest
            } else {
                one
            };
            rest &= !found;
            Some((face, found))
        })
    }
}

/// Finds which of some lanes hit the same face as the first of them.
pub struct FindAlike<'a> {
    pub faces: &'a [u32; LANES],
    pub lanes: u32,
}

impl Computation for FindAlike<'_> {
    type Output = Alike;
    #[inline(always)]
    fn run<S: Simd>(self, _: S) -> Alike {
        let Self { faces, lanes } = self;
        let first = faces[lanes.trailing_zeros() as usize % LANES];
        let (mut same, mut missed) = (0, 0);
        for (lane, &face) in faces.iter().enumerate() {
            same |= u32::from(face == first) << lane;
            missed |= u32::from(face == NOTHING) << lane;
        }
        Alike {
            faces: *faces,
            same: same & lanes,
            missed: missed & lanes,
        }
    }
}

#[cfg(test)]
mod tests {
    use capwalk_geometry::simd::Instructions;

    use super::*;
    use crate::lanes::vectors::{ALL, lanes_of};

    /// Every lane that is asked for is given once, with its face.
    #[test]
    fn lanes_are_given_with_their_face() {
        let faces = std::array::from_fn(|lane| [7, 2, u32::MAX, 2, 9][lane * lane % 5]);
        for lanes in [0, 1, 0b1010_1100_0101_1101, ALL] {
            let alike = Instructions::detect().run(FindAlike {
                faces: &faces,
                lanes,
            });
            for some in [ALL, 0x0ff0] {
                let mut found = 0;
                let missed = lanes_of(lanes & some).filter(|&lane| faces[lane] == NOTHING);
                assert!(missed.eq(lanes_of(alike.missed & some)));
                for (face, of_face) in alike.of(lanes & some) {
                    assert_eq!(found & of_face, 0);
                    found |= of_face;
                    assert!(lanes_of(of_face).all(|lane| faces[lane] == face));
                }
                assert_eq!(found, lanes & some);
                let first = alike.of(lanes & some).next().map_or(0, |(_, lanes)| lanes);
                assert_eq!(first == 0, lanes & some == 0);
            }
        }
    }
}
