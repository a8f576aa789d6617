//! Pixels of 8 bits to draw on.

use std::convert::Infallible;

use embedded_graphics::Drawable;
use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::mono_font::iso_8859_1::{FONT_6X10, FONT_10X20};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::primitives::{Primitive, PrimitiveStyle, Rectangle};
use embedded_graphics::text::{Baseline, Text};

/// The colour of text and frames.
const INK: Rgb888 = Rgb888::new(40, 40, 40);

/// An image in sRGB, row by row from the upper left.
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

    /// Fills a rectangle.
    pub fn fill(&mut self, corner: [usize; 2], size: [usize; 2], [r, g, b]: [u8; 3]) {
        let style = PrimitiveStyle::with_fill(Rgb888::new(r, g, b));
        let Ok(()) = rectangle(corner, size).into_styled(style).draw(self);
    }

    /// Draws a line of one pixel around a rectangle.
    pub fn frame(&mut self, corner: [usize; 2], size: [usize; 2]) {
        let outside = rectangle(corner, size).offset(1);
        let style = PrimitiveStyle::with_stroke(INK, 1);
        let Ok(()) = outside.into_styled(style).draw(self);
    }

    /// Writes one line of text with its upper left corner at a point. A letter
    /// that is not in Latin-1 becomes a question mark.
    pub fn text(&mut self, corner: [usize; 2], scale: usize, text: &str) {
        let style = MonoTextStyle::new(font(scale), INK);
        let text = Text::with_baseline(text, point(corner), style, Baseline::Top);
        let Ok(_) = text.draw(self);
    }
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(self.width as u32, self.height as u32)
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb888>>,
    {
        for Pixel(Point { x, y }, colour) in pixels {
            let (Ok(x), Ok(y)) = (usize::try_from(x), usize::try_from(y)) else {
                continue;
            };
            if x < self.width && y < self.height {
                self.pixels[y * self.width + x] = [colour.r(), colour.g(), colour.b()];
            }
        }
        Ok(())
    }
}

/// A small font for scale 1, a larger one for all others.
fn font(scale: usize) -> &'static MonoFont<'static> {
    match scale {
        1 => &FONT_6X10,
        _ => &FONT_10X20,
    }
}

/// Width and height of a line of text, pixels.
pub(super) fn text_size(text: &str, scale: usize) -> [usize; 2] {
    let Size { width, height } = font(scale).character_size;
    [text.chars().count() * width as usize, height as usize]
}

fn point([x, y]: [usize; 2]) -> Point {
    Point::new(x as i32, y as i32)
}

fn rectangle(corner: [usize; 2], [width, height]: [usize; 2]) -> Rectangle {
    Rectangle::new(point(corner), Size::new(width as u32, height as u32))
}
