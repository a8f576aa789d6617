//! What pictures are drawn on, and how their type looks.

/// Width and height of a letter, pixels.
pub(super) const LETTER: [usize; 2] = [10, 20];

/// The colour of text and frames.
pub(super) const INK: [u8; 3] = [40, 40, 40];

/// Colours in sRGB, row by row from the upper left.
pub(super) struct Raster {
    pub width: usize,
    pub height: usize,
    pub colours: Vec<[u8; 3]>,
}

/// Something to draw on, in pixels from the upper left; white at first.
pub(super) trait Drawing {
    /// Draws an image with its upper left corner at a point, each of its pixels as wide and high as
    /// `zoom`.
    fn image(&mut self, corner: [usize; 2], zoom: [usize; 2], image: &Raster);

    /// Draws a line of one pixel around a rectangle.
    fn frame(&mut self, corner: [usize; 2], size: [usize; 2]);

    /// Writes one line of text with its upper left corner at a point.
    fn text(&mut self, corner: [usize; 2], text: &str);

    /// The bytes of a file, with metadata in it.
    fn encode(self: Box<Self>, metadata: &[(String, String)]) -> Result<Vec<u8>, String>;
}

/// The width of a line of text at most, pixels.
pub(super) fn text_width(text: &str) -> usize {
    text.chars().count() * LETTER[0]
}
