//! What pictures are drawn on, and the size of their type.

use super::canvas::Canvas;
use super::format::Picture;
use super::svg::Svg;

/// Width and height of a letter, pixels.
pub(super) const LETTER: [usize; 2] = [10, 20];

/// Something to draw on, in pixels from the upper left; white at first.
pub(super) trait Surface {
    /// Draws an image with its upper left corner at a point, each of its pixels as wide and high as
    /// `zoom`.
    fn image(&mut self, corner: [usize; 2], zoom: [usize; 2], image: &Canvas);

    /// Draws a line of one pixel around a rectangle.
    fn frame(&mut self, corner: [usize; 2], size: [usize; 2]);

    /// Writes one line of text with its upper left corner at a point.
    fn text(&mut self, corner: [usize; 2], text: &str);

    /// The bytes of a file, with metadata in it.
    fn encode(self: Box<Self>, metadata: &[(String, String)]) -> Result<Vec<u8>, String>;
}

/// A surface for a kind of file, with a width and a height.
pub(super) fn surface(kind: Picture, size: [usize; 2]) -> Box<dyn Surface> {
    match kind {
        Picture::Png => Box::new(Canvas::new(size)),
        Picture::Svg => Box::new(Svg::new(size)),
    }
}

/// The width of a line of text at most, pixels.
pub(super) fn text_width(text: &str) -> usize {
    text.chars().count() * LETTER[0]
}
