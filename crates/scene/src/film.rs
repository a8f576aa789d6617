//! The film: how many pixels, and what part of the image.

use serde::{Deserialize, Serialize};

use crate::filter::Filter;
use crate::scene_error::SceneError;

/// The film of a sensor. Film coordinates are in pixels, `x` to the right and
/// `y` down, `(0, 0)` at the upper left corner of the whole film.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Film {
    /// Width and height of the whole film, pixels.
    pub size: [u32; 2],
    /// Upper left pixel of the part that is rendered.
    pub crop_offset: [u32; 2],
    /// Width and height of the part that is rendered: the image's size.
    pub crop_size: [u32; 2],
    /// The reconstruction filter.
    pub filter: Filter,
    /// True if light that falls outside the rendered part still reaches
    /// pixels whose filter overlaps it. If false, the filters of pixels near
    /// the border are cut off there and normalised again, as in Mitsuba.
    pub sample_border: bool,
}

impl Film {
    /// The most pixels an image may have. While it is computed, a gradient takes up to 900
    /// bytes for each.
    pub const MAX_PIXELS: u64 = 1 << 26;

    /// A film without crop.
    pub fn new(width: u32, height: u32, filter: Filter) -> Self {
        Self {
            size: [width, height],
            crop_offset: [0, 0],
            crop_size: [width, height],
            filter,
            sample_border: false,
        }
    }

    /// Gives it another width and height in pixels, without crop.
    pub fn resize(&mut self, size: [u32; 2]) {
        (self.size, self.crop_offset, self.crop_size) = (size, [0, 0], size);
    }

    /// How many pixels the image has.
    pub fn pixel_count(&self) -> usize {
        self.crop_size[0] as usize * self.crop_size[1] as usize
    }

    /// True if an image of it can be rendered.
    pub fn check(&self) -> Result<(), SceneError> {
        let [w, h] = self.crop_size;
        let pixels = u64::from(w) * u64::from(h);
        let whole = u64::from(self.size[0]) * u64::from(self.size[1]);
        if pixels == 0 || pixels > Self::MAX_PIXELS || whole == 0 {
            return Err(SceneError::ImageSize {
                size: self.crop_size,
                most: Self::MAX_PIXELS,
            });
        }
        for axis in 0..2 {
            let end = u64::from(self.crop_offset[axis]) + u64::from(self.crop_size[axis]);
            if end > u64::from(self.size[axis]) {
                return Err(SceneError::BadNumber {
                    name: format!("film.{}", ["crop_width", "crop_height"][axis]),
                    value: format!("{end} (offset included)"),
                    expected: "a crop window inside the film",
                });
            }
        }
        self.filter.check()
    }
}
