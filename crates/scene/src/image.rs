//! Pixels.

use capwalk_math::Rgb;
use serde::Serialize;

/// An image of linear colours, row by row from the upper left.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Image {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// `width * height` colours.
    pub pixels: Vec<Rgb>,
}

impl Image {
    /// A black image.
    pub fn new(width: usize, height: usize) -> Self {
        Self {
            width,
            height,
            pixels: vec![Rgb::zero(); width * height],
        }
    }

    /// The pixel in column `x` and row `y`.
    pub fn at(&self, x: usize, y: usize) -> Rgb {
        self.pixels[y * self.width + x]
    }
}
