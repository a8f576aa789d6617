//! What a probe finds: specular events behind which silhouettes move that no field has.

use capwalk_boundary::Gathers;

/// Why a ray moves against what it shows, as bits.
pub(crate) type Causes = u8;
/// The scene moves: what is seen, the mirror, or the point that the ray comes from.
pub(crate) const MOTION: Causes = 1;
/// The ray moves along the field around the camera, if the camera walks.
pub(crate) const CAMERA_FIELD: Causes = 2;
/// The ray moves along the field around a surface point, if directions towards surfaces walk.
pub(crate) const SURFACE_FIELD: Causes = 4;

/// Specular events behind which silhouettes or the edges of hard shadows move against the rays
/// that show them, and that no field has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UncoveredEvents {
    /// How many there are, by the causes of their motion.
    counts: [u32; 8],
}

impl UncoveredEvents {
    /// One more event, if there is a cause of motion.
    pub(crate) fn add(&mut self, causes: Causes) {
        self.counts[usize::from(causes)] += u32::from(causes != 0);
    }

    /// The sum of these counts and those of another part of a probe.
    #[must_use]
    pub fn and(mut self, other: Self) -> Self {
        let pairs = self.counts.iter_mut().zip(other.counts);
        pairs.for_each(|(own, other)| *own += other);
        self
    }

    /// True if some are left out whatever the method.
    pub fn is_certain(&self) -> bool {
        self.count(Gathers::ALL) > 0
    }

    /// Those that a derivative leaves out which gathers edges along these segments, and walks along
    /// the others.
    pub fn count(&self, gathers: Gathers) -> u64 {
        let mut causes = MOTION;
        if !gathers.camera {
            causes |= CAMERA_FIELD;
        }
        if !gathers.indirect {
            causes |= SURFACE_FIELD;
        }
        let counts = (0..).zip(&self.counts);
        let counts = counts.filter(|(of, _): &(Causes, _)| of & causes != 0);
        counts.map(|(_, &count)| u64::from(count)).sum()
    }
}
