//! What comes back: images with standard errors, and counts.

use std::ops::AddAssign;

use capwalk_scene::Image;

use crate::device::UsedDevice;

/// An estimated image and its error.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Estimated value of each pixel and channel.
    pub mean: Image,
    /// Standard error of each; NaN where there were fewer than two
    /// independent samples.
    pub standard_error: Image,
}

/// A rendered image.
#[derive(Clone, Debug)]
pub struct Rendering {
    /// The image.
    pub value: Estimate,
    /// What was done.
    pub statistics: Statistics,
}

/// What was done.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Samples taken in each pixel, row by row: all equal to the samples asked
    /// for unless the work was stopped, or adaptive.
    pub samples_per_pixel: Vec<u32>,
    /// False if the work was stopped before all samples were taken.
    pub complete: bool,
    /// Samples in all.
    pub samples: u64,
    /// Samples that were infinite or NaN. They count as zero in the image,
    /// so more than a few of them make it wrong.
    pub non_finite: u64,
    /// Queries about silhouettes answered: the closest one, those in a cone, or a subtree.
    pub cone_queries: u64,
    /// What the samples of an image took, in about twenty nanoseconds: counted by what queries
    /// were asked and found, and so the same in every run. 0 in reverse mode.
    pub effort: u64,
    /// Where it was computed.
    pub device: UsedDevice,
    /// Rays that dip below faces where that is not continuous, on 1024 paths from the camera: of derivatives in which what is seen in curved mirrors
    /// or through glass may move, none of others.
    pub dips: Dips,
}

/// How often a ray that is reflected or refracted about an interpolated or mapped normal dips below its face where the
/// surface rises before it, or another one is there. No field knows how the borders of these places move: that part of a derivative is missing
/// (method 6).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dips {
    /// Reflections and refractions on some paths, each followed up to the first that dips.
    pub events: u32,
    /// How many of them dip there.
    pub dip: u32,
}

impl Dips {
    /// One more event.
    pub(crate) fn count(&mut self, dips: bool) {
        self.events += 1;
        self.dip += u32::from(dips);
    }

    /// What a user should know, without a full stop; `None` if there are none.
    pub fn remark(&self) -> Option<String> {
        let Self { events, dip } = self;
        (*dip > 0).then(|| {
            format!(
                "in {dip} of {events} reflections and refractions looked at, the ray dips below its face where the \
                 surface is concave or another one meets it, because normals are interpolated or mapped; how such places move is missing in \
                 the gradient. Finer meshes have fewer of them, flat normals none"
            )
        })
    }
}

impl AddAssign for Dips {
    fn add_assign(&mut self, other: Self) {
        self.events += other.events;
        self.dip += other.dip;
    }
}

impl Statistics {
    /// The largest tolerated fraction of non-finite samples.
    pub const NON_FINITE_LIMIT: f64 = 1e-6;

    /// True if there were too many non-finite samples to trust the image.
    pub fn too_many_non_finite(&self) -> bool {
        self.non_finite as f64 > Self::NON_FINITE_LIMIT * self.samples as f64
    }
}
