//! Image files. The ending of the name chooses the format:
//!
//! | ending | what is in it |
//! |---|---|
//! | `.exr` | all layers in single precision as `R, G, B` (the layer `value`) and `<layer>.R, .G, .B`; sample counts as `samples`; metadata as text attributes `capwalk:<key>` |
//! | `.npz` | one array `(height, width, 3)` of `float32` per layer; `samples` as `(height, width)` of `uint32`; `metadata` as pairs of strings |
//! | `.png`, `.svg` | a preview of 8 bits: the gradient in false colours with a colour bar if there is one, the value otherwise; type as text in SVG |
//!
//! EXR and NPZ files can be read back, also such as other programs write. [`ImageFile`] reads
//! headers first, then the layers that are asked for.
//! Files appear whole or not at all, and the same image always gives the
//! same bytes.

mod canvas;
mod drawing;
mod error;
mod exr;
mod exr_file;
mod file;
mod format;
mod layered;
mod npz_file;
mod panel;
mod pixels;
mod png;
mod svg;
mod tone;

pub use error::ImageError;
pub(crate) use exr::encode as encode_exr;
pub(crate) use exr_file::decode_value as decode_exr_value;
pub use file::{ImageFile, check_writable, read, write};
pub use format::is_picture;
pub use layered::{GRADIENT, Layer, LayeredImage, VALUE};
pub use panel::{
    LEAST_WIDTH, Panel, Preview, Style, Written, colour_bar_as_png, pixels_as_png, preview_as_png,
    write_panels,
};
pub use tone::{Scale, photographic};

#[cfg(test)]
mod tests;
