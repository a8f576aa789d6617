//! SVG 1.1: images as PNG inside, type as text.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

use super::drawing::{Drawing, INK, LETTER, Raster};
use super::png;

/// Size of type, pixels: no letter of a common font without serifs is wider than [`LETTER`] on average.
const TYPE: usize = 17;

/// A picture, its elements as text.
pub(super) struct Svg {
    size: [usize; 2],
    elements: String,
    /// Why an image could not be encoded.
    error: Option<String>,
}

impl Svg {
    /// A white picture.
    pub fn new(size: [usize; 2]) -> Self {
        Self {
            size,
            elements: String::new(),
            error: None,
        }
    }
}

impl Drawing for Svg {
    fn image(&mut self, [x, y]: [usize; 2], zoom: [usize; 2], image: &Raster) {
        let (width, height) = (image.width * zoom[0], image.height * zoom[1]);
        match png::encode(image, &[]) {
            Ok(bytes) => {
                self.elements += &format!(
                    "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" \
                     preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" \
                     xlink:href=\"data:image/png;base64,{}\"/>\n",
                    BASE64_STANDARD.encode(bytes)
                );
            }
            Err(error) => self.error = Some(error),
        }
    }

    fn frame(&mut self, [x, y]: [usize; 2], [width, height]: [usize; 2]) {
        self.elements += &format!(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{}\"/>\n",
            x as f64 - 0.5,
            y as f64 - 0.5,
            width + 1,
            height + 1,
            ink()
        );
    }

    fn text(&mut self, [x, y]: [usize; 2], text: &str) {
        let base = y + (LETTER[1] + TYPE) / 2 - TYPE / 5;
        self.elements += &format!(
            "<text x=\"{x}\" y=\"{base}\" font-family=\"Helvetica, Arial, sans-serif\" \
             font-size=\"{TYPE}\" fill=\"{}\">{}</text>\n",
            ink(),
            escaped(text)
        );
    }

    /// Metadata is the description.
    fn encode(self: Box<Self>, metadata: &[(String, String)]) -> Result<Vec<u8>, String> {
        if let Some(error) = self.error {
            return Err(error);
        }
        let [width, height] = self.size;
        let pairs = metadata.iter();
        let lines: Vec<String> = pairs
            .map(|(key, value)| format!("{key}: {value}"))
            .collect();
        let file = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
             width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
             <desc>{}</desc>\n<rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n{}</svg>\n",
            escaped(&lines.join("\n")),
            self.elements
        );
        Ok(file.into_bytes())
    }
}

fn ink() -> String {
    let [r, g, b] = INK;
    format!("rgb({r},{g},{b})")
}

/// Text that stands between tags. Characters that XML does not allow are left out.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '\n' | '\t' => escaped.push(letter),
            '\u{FFFE}' | '\u{FFFF}' => {}
            _ if letter.is_control() => {}
            _ => escaped.push(letter),
        }
    }
    escaped
}
