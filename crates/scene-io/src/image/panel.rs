//! Previews: images side by side, more than three of them in two rows, with titles and colour bars.

use std::path::Path;

use capwalk_math::Rgb;
use capwalk_scene::Image;

use super::canvas::Canvas;
use super::drawing::{Drawing, LETTER, Raster, text_width};
use super::error::ImageError;
use super::format::{Format, PICTURES, Picture, format, save};
use super::layered::{GRADIENT, LayeredImage, VALUE};
use super::svg::Svg;
use super::tone::Scale;
use super::{png, tone};

/// One of several images side by side.
#[derive(Clone, Debug)]
pub struct Panel<'a> {
    /// Stands above the image, in one line.
    pub title: &'a str,
    /// Linear, before `style`.
    pub image: &'a Image,
    /// How pixels become colours.
    pub style: Style,
}

/// How numbers become colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Style {
    /// Light: multiplied by `2^exposure`, clamped to `[0, 1]`, sRGB.
    Photographic {
        /// Exposure in stops.
        exposure: f64,
    },
    /// Signed numbers (the mean of the channels) from blue to red, with a
    /// colour bar. White is zero.
    Diverging(Scale),
}

/// How a preview looks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Preview {
    /// The value is multiplied by `2^exposure` before the sRGB curve; what is
    /// above 1 is white then.
    pub exposure: f64,
    /// Where the false colours of a gradient end on both sides, spread evenly; `None` chooses
    /// [`Scale::of`].
    pub limit: Option<f64>,
}

impl Preview {
    /// The false colours of gradients and differences.
    pub fn scale<'a>(&self, images: impl IntoIterator<Item = &'a Image>) -> Scale {
        self.limit.map_or_else(|| Scale::of(images), Scale::even)
    }
}

/// What there is to say about a file that was written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Written {
    /// Pixels with an infinity or a NaN in the value or the gradient (in the
    /// layer that a picture shows, where they are magenta).
    pub non_finite_pixels: usize,
    /// Where the false colours of a picture end.
    pub limit: Option<f64>,
}

/// Writes images side by side, more than three of them in two rows, into a PNG or SVG file, and returns how many of their
/// pixels are infinite or NaN (those are magenta). For a check: value,
/// gradient and reference with the same limit, and z.
pub fn write_panels(
    path: &Path,
    panels: &[Panel],
    metadata: &[(String, String)],
) -> Result<usize, ImageError> {
    let Format::Picture(kind) = format(path, PICTURES)? else {
        return Err(ImageError::UnknownEnding {
            path: path.to_owned(),
            known: PICTURES,
        });
    };
    for panel in panels {
        if let Style::Diverging(scale) = panel.style {
            check_limit(path, scale.limit)?;
        }
    }
    save_picture(path, draw(kind, panels), metadata)?;
    let images = panels.iter().map(|panel| panel.image);
    Ok(images.map(tone::non_finite_pixels).sum())
}

/// What stands for the path of what is not written into a file.
const IN_MEMORY: &str = "image in memory";

/// An image as a PNG file in memory, its pixels as they are: no title, no bar.
pub fn pixels_as_png(image: &Image, style: Style) -> Result<Vec<u8>, ImageError> {
    let path = Path::new(IN_MEMORY);
    if let Style::Diverging(scale) = style {
        check_limit(path, scale.limit)?;
    }
    png::encode(&coloured(image, style), &[]).map_err(|reason| ImageError::write(path, reason))
}

/// The colours of [`Style::Diverging`] from its negative limit, at the left, to
/// the positive one, as a PNG file in memory.
pub fn colour_bar_as_png() -> Result<Vec<u8>, ImageError> {
    const STEPS: usize = 121;
    let last = (STEPS - 1) as f64;
    let values = (0..STEPS).map(|i| Rgb::splat(2.0 * i as f64 / last - 1.0));
    let bar = Image {
        width: STEPS,
        height: 1,
        pixels: values.collect(),
    };
    pixels_as_png(&bar, Style::Diverging(Scale::even(1.0)))
}

impl Style {
    /// The colour of a pixel on a screen.
    pub(super) fn colour(self, pixel: Rgb) -> [u8; 3] {
        match self {
            Self::Photographic { exposure } => tone::photographic(pixel, exposure.exp2()),
            Self::Diverging(scale) => tone::diverging(scale.place(tone::mean(pixel))),
        }
    }
}

/// Writes a preview, see [`previewed`].
pub(super) fn write_preview(
    path: &Path,
    kind: Picture,
    layered: &LayeredImage,
    preview: &Preview,
) -> Result<Written, ImageError> {
    let (picture, written) = previewed(path, kind, layered, preview)?;
    save_picture(path, picture, &layered.metadata)?;
    Ok(written)
}

/// A preview as a PNG file in memory, the same as [`write`](super::write) makes.
pub fn preview_as_png(layered: &LayeredImage, preview: &Preview) -> Result<Vec<u8>, ImageError> {
    let path = Path::new(IN_MEMORY);
    let wrong = |reason| ImageError::write(path, reason);
    layered.size().map_err(wrong)?;
    let (picture, _) = previewed(path, Picture::Png, layered, preview)?;
    picture.encode(&layered.metadata).map_err(wrong)
}

/// A preview of a layer: the gradient, beside the value if that is there, or else the value, or else
/// the first.
fn previewed(
    path: &Path,
    kind: Picture,
    layered: &LayeredImage,
    preview: &Preview,
) -> Result<(Box<dyn Drawing>, Written), ImageError> {
    let first = &layered.layers[0]; // there is one, or it had no size
    let names = [GRADIENT, VALUE];
    let name = names.into_iter().find(|name| layered.layer(name).is_some());
    let name = name.unwrap_or(&first.name);
    let image = layered.layer(name).unwrap_or(&first.image);
    let mut limit = None;
    let picture = if name == VALUE {
        photograph(kind, image, preview.exposure)
    } else {
        let scale = preview.scale([image]);
        check_limit(path, scale.limit)?;
        limit = Some(scale.limit);
        let title = title(name, &layered.metadata);
        let shown = Panel {
            title: &title,
            image,
            style: Style::Diverging(scale),
        };
        let value = layered.layer(VALUE).map(|image| Panel {
            title: VALUE,
            image,
            style: Style::Photographic {
                exposure: preview.exposure,
            },
        });
        draw(kind, &value.into_iter().chain([shown]).collect::<Vec<_>>())
    };
    let written = Written {
        non_finite_pixels: tone::non_finite_pixels(image),
        limit,
    };
    Ok((picture, written))
}

/// The name of a layer, and of a gradient with respect to what it is.
fn title(name: &str, metadata: &[(String, String)]) -> String {
    let mut pairs = metadata.iter();
    let parameter = pairs.find(|(key, _)| name == GRADIENT && key == "parameter");
    let Some((_, parameter)) = parameter else {
        return name.to_owned();
    };
    let turns = parameter.contains(".rotate.");
    let is_one = parameter
        .chars()
        .all(|c| c.is_alphanumeric() || "._-".contains(c));
    let unit = match turns && is_one && !parameter.starts_with('-') {
        true => "radian",
        _ => "unit",
    };
    format!("{name} per {unit} of {parameter}")
}

fn check_limit(path: &Path, limit: f64) -> Result<(), ImageError> {
    match limit.is_finite() && limit > 0.0 {
        true => Ok(()),
        false => {
            let reason = format!("the limit of its colours is {limit}; expected a number above 0");
            Err(ImageError::write(path, reason))
        }
    }
}

/// A drawing for a kind of file, with a width and a height.
fn drawing(kind: Picture, size: [usize; 2]) -> Box<dyn Drawing> {
    match kind {
        Picture::Png => Box::new(Canvas::new(size)),
        Picture::Svg => Box::new(Svg::new(size)),
    }
}

fn save_picture(
    path: &Path,
    picture: Box<dyn Drawing>,
    metadata: &[(String, String)],
) -> Result<(), ImageError> {
    let bytes = picture.encode(metadata);
    let bytes = bytes.map_err(|reason| ImageError::write(path, reason))?;
    save(path, &bytes)
}

/// The pixels as they are, without decoration.
fn photograph(kind: Picture, image: &Image, exposure: f64) -> Box<dyn Drawing> {
    let pixels = coloured(image, Style::Photographic { exposure });
    let mut drawing = drawing(kind, [image.width, image.height]);
    drawing.image([0, 0], [1, 1], &pixels);
    drawing
}

/// An image in the colours of a screen.
fn coloured(image: &Image, style: Style) -> Raster {
    Raster {
        width: image.width,
        height: image.height,
        colours: image.pixels.iter().map(|&p| style.colour(p)).collect(),
    }
}

/// Images that are narrower than this are enlarged by a whole factor, pixels.
pub const LEAST_WIDTH: usize = 384;
/// More images than this have two rows: in one, a page that is as wide as they are makes their text too small.
const MOST_IN_A_ROW: usize = 3;
/// Height of a title, pixels at scale 1.
const TITLE: usize = 10;
/// Width of a colour bar, pixels at scale 1.
const BAR: usize = 8;
/// Space between things, pixels at scale 1.
const GAP: usize = 6;

/// Where a panel's parts are, pixels.
struct Layout {
    title: String,
    /// Width and height of the image.
    size: [usize; 2],
    /// Pixels of the canvas for each pixel of the image, along each side.
    zoom: usize,
    /// Marks of the colour bar from top to bottom, with their places from 0 to 1.
    ticks: Vec<(String, f64)>,
}

/// The panels in rows and columns.
fn draw(kind: Picture, panels: &[Panel]) -> Box<dyn Drawing> {
    let tallest = panels.iter().map(|p| p.image.height).max().unwrap_or(0);
    // Text that can be read in a talk, and beside large images.
    let scale = (tallest / 400 + 2).min(4);
    let above = (TITLE + GAP) * scale;
    let columns = match panels.len() {
        count if count > MOST_IN_A_ROW => count.div_ceil(2),
        count => count.max(1),
    };
    let mut layouts = Vec::new();
    let mut widths = vec![0; columns];
    let mut heights = vec![0; panels.len().div_ceil(columns)];
    for (i, panel) in panels.iter().enumerate() {
        let zoom = LEAST_WIDTH.div_ceil(panel.image.width.max(1));
        let size = [panel.image.width * zoom, panel.image.height * zoom];
        let ticks = match panel.style {
            Style::Photographic { .. } => Vec::new(),
            Style::Diverging(scale) => {
                let ticks = scale.ticks().into_iter();
                let place = |value| 0.5 - 0.5 * scale.place(value);
                ticks.map(|value| (label(value), place(value))).collect()
            }
        };
        let labels = ticks.iter().map(|(t, _)| text_width(t)).max();
        let bar = labels.map_or(0, |width| (2 * GAP + BAR) * scale + width);
        let title = match tone::non_finite_pixels(panel.image) {
            0 => panel.title.to_owned(),
            // A magenta pixel alone is easily overlooked.
            count => format!("{} ({count} not finite)", panel.title),
        };
        let (column, row) = (i % columns, i / columns);
        widths[column] = (size[0] + bar).max(text_width(&title)).max(widths[column]);
        heights[row] = size[1].max(heights[row]);
        layouts.push(Layout {
            title,
            size,
            zoom,
            ticks,
        });
    }
    // Each has space around it, and a title above it.
    let space = GAP * scale;
    let ends =
        |sizes: &[usize], around: usize| sizes.iter().map(|size| size + around).sum::<usize>();
    let size = [ends(&widths, 2 * space), ends(&heights, above + space)];
    let mut drawing = drawing(kind, size);
    for (i, (panel, layout)) in panels.iter().zip(&layouts).enumerate() {
        let left = ends(&widths[..i % columns], 2 * space) + space;
        let top = ends(&heights[..i / columns], above + space) + above;
        let corner = [left, top];
        drawing.text([left, top + space / 2 - above], &layout.title);
        drawing.frame(corner, layout.size);
        drawing.image(
            corner,
            [layout.zoom; 2],
            &coloured(panel.image, panel.style),
        );
        if let Style::Diverging(_) = panel.style {
            draw_bar(&mut *drawing, corner, layout, scale);
        }
    }
    drawing
}

fn draw_bar(drawing: &mut dyn Drawing, [left, top]: [usize; 2], layout: &Layout, scale: usize) {
    let height = layout.size[1];
    let left = left + layout.size[0] + GAP * scale;
    // The middle of each row, from 1 at the top to -1 at the bottom.
    let rows = (0..height).map(|row| 1.0 - (2 * row + 1) as f64 / height as f64);
    let bar = Raster {
        width: 1,
        height,
        colours: rows.map(tone::diverging).collect(),
    };
    drawing.frame([left, top], [BAR * scale, height]);
    drawing.image([left, top], [BAR * scale, 1], &bar);
    for (tick, place) in &layout.ticks {
        // The first and the last stay within the bar.
        let y = (height.saturating_sub(LETTER[1]) as f64 * place).round() as usize;
        drawing.text([left + (BAR + GAP / 2) * scale, top + y], tick);
    }
}

/// A number in at most three digits.
fn label(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".into();
    }
    if !(1e-3..1e5).contains(&size) {
        let text = format!("{value:.2e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let digits = digits.trim_end_matches('0').trim_end_matches('.');
        return format!("{digits}e{exponent}");
    }
    let decimals = (2 - size.log10().floor() as i32).max(0) as usize;
    let text = format!("{value:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').into(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_name_the_parameter() {
        for (name, parameter, text) in [
            (
                GRADIENT,
                "ball.translate.x",
                "gradient per unit of ball.translate.x",
            ),
            (
                GRADIENT,
                "ball.rotate.z",
                "gradient per radian of ball.rotate.z",
            ),
            (
                GRADIENT,
                "0.5*ball.rotate.z",
                "gradient per unit of 0.5*ball.rotate.z",
            ),
            (
                GRADIENT,
                "ball.rotate.z - sky.scale",
                "gradient per unit of ball.rotate.z - sky.scale",
            ),
            ("z", "ball.rotate.z", "z"),
        ] {
            let metadata = [("parameter".to_owned(), parameter.to_owned())];
            assert_eq!(title(name, &metadata), text);
        }
        assert_eq!(title(GRADIENT, &[]), GRADIENT);
    }

    #[test]
    fn labels_are_short() {
        for (value, text) in [
            (0.0, "0"),
            (0.014, "0.014"),
            (-0.007, "-0.007"),
            (2.5, "2.5"),
            (1234.0, "1234"),
            (-1.25e-7, "-1.25e-7"),
            (3e8, "3e8"),
        ] {
            assert_eq!(label(value), text);
        }
    }
}
