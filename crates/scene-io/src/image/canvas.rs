//! A picture to draw on.

use super::font;

/// Black, for text and frames.
const INK: [u8; 3] = [40, 40, 40];

/// Pixels of 8 bits, row by row from the upper left.
pub(super) struct Canvas {
    pub width: usize,
    pub height: usize,
    pub pixels: Vec<[u8; 3]>,
}

impl Canvas {
    /// A white canvas.
    pub fn new(width: usize, height: usize) -> Self {
        Self {
            width,
            height,
            pixels: vec![[255; 3]; width * height],
        }
    }

    /// Fills a rectangle; what lies outside the canvas is not drawn.
    pub fn fill(&mut self, [x, y]: [usize; 2], [width, height]: [usize; 2], colour: [u8; 3]) {
        let (right, bottom) = ((x + width).min(self.width), (y + height).min(self.height));
        for row in y..bottom {
            for column in x..right {
                self.pixels[row * self.width + column] = colour;
            }
        }
    }

    /// Draws a line of one pixel around a rectangle.
    pub fn frame(&mut self, [x, y]: [usize; 2], [width, height]: [usize; 2]) {
        for (corner, size) in [
            ([x - 1, y - 1], [width + 2, 1]),
            ([x - 1, y + height], [width + 2, 1]),
            ([x - 1, y - 1], [1, height + 2]),
            ([x + width, y - 1], [1, height + 2]),
        ] {
            self.fill(corner, size, INK);
        }
    }

    /// Writes text with its upper left corner at a point, each dot of the font
    /// a square of `scale` pixels.
    pub fn text(&mut self, [x, y]: [usize; 2], scale: usize, text: &str) {
        for (i, c) in text.chars().enumerate() {
            let left = x + i * font::ADVANCE * scale;
            for (column, dots) in font::glyph(c).iter().enumerate() {
                for row in (0..8).filter(|row| dots >> row & 1 == 1) {
                    let corner = [left + column * scale, y + row * scale];
                    self.fill(corner, [scale; 2], INK);
                }
            }
        }
    }
}

/// The width of a text in pixels.
pub(super) fn text_width(text: &str, scale: usize) -> usize {
    (text.chars().count() * font::ADVANCE).saturating_sub(1) * scale
}
