//! Pixels of 8 bits to draw on.

use std::convert::Infallible;

use embedded_graphics::Drawable;
use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::iso_8859_1::FONT_10X20;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::primitives::{Primitive, PrimitiveStyle, Rectangle};
use embedded_graphics::text::{Baseline, Text};

use super::drawing::{Drawing, INK, Raster};
use super::png;

/// What is drawn so far.
pub(super) struct Canvas(Raster);

impl Canvas {
    /// A white canvas.
    pub fn new([width, height]: [usize; 2]) -> Self {
        Self(Raster {
            width,
            height,
            colours: vec![[255; 3]; width * height],
        })
    }
}

impl Drawing for Canvas {
    fn image(&mut self, [left, top]: [usize; 2], zoom: [usize; 2], image: &Raster) {
        for (row, colours) in image.colours.chunks(image.width.max(1)).enumerate() {
            for (column, &rgb) in colours.iter().enumerate() {
                let corner = [left + column * zoom[0], top + row * zoom[1]];
                let style = PrimitiveStyle::with_fill(colour(rgb));
                let Ok(()) = rectangle(corner, zoom).into_styled(style).draw(self);
            }
        }
    }

    fn frame(&mut self, corner: [usize; 2], size: [usize; 2]) {
        let outside = rectangle(corner, size).offset(1);
        let style = PrimitiveStyle::with_stroke(colour(INK), 1);
        let Ok(()) = outside.into_styled(style).draw(self);
    }

    /// A letter that is not in Latin-1 becomes a question mark.
    fn text(&mut self, corner: [usize; 2], text: &str) {
        let style = MonoTextStyle::new(&FONT_10X20, colour(INK));
        let text = Text::with_baseline(text, point(corner), style, Baseline::Top);
        let Ok(_) = text.draw(self);
    }

    fn encode(self: Box<Self>, metadata: &[(String, String)]) -> Result<Vec<u8>, String> {
        png::encode(&self.0, metadata)
    }
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(self.0.width as u32, self.0.height as u32)
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
            if x < self.0.width && y < self.0.height {
                self.0.colours[y * self.0.width + x] = [colour.r(), colour.g(), colour.b()];
            }
        }
        Ok(())
    }
}

fn colour([r, g, b]: [u8; 3]) -> Rgb888 {
    Rgb888::new(r, g, b)
}

fn point([x, y]: [usize; 2]) -> Point {
    Point::new(x as i32, y as i32)
}

fn rectangle(corner: [usize; 2], [width, height]: [usize; 2]) -> Rectangle {
    Rectangle::new(point(corner), Size::new(width as u32, height as u32))
}
