//! A shape before it has its material, and where it is.

use std::path::Path;

use capwalk_geometry::mesh::LARGEST_COORDINATE;
use capwalk_math::Affine;

use super::surface::Surface;
use crate::fields::Fields;
use crate::mesh::FileAttribute;
use crate::problem::Problem;

/// A shape before it has its material, as its plugin makes it.
pub(super) struct PlacedSurface {
    pub surface: Surface,
    /// What puts the coordinates that it is described in into the world.
    pub world_from_object: Affine,
    pub attributes: Vec<FileAttribute>,
    /// What it is called without an id.
    pub stem: String,
}

/// The name of a file without its ending.
pub(super) fn file_stem(path: &Path, otherwise: &str) -> String {
    let stem = path.file_stem().unwrap_or(Path::new(otherwise).as_os_str());
    stem.to_string_lossy().into_owned()
}

/// The `to_world` of a shape, which can be inverted.
pub(super) fn placement(fields: &Fields) -> Result<Affine, Problem> {
    let to_world = fields.transform("to_world")?;
    if to_world.determinant() == 0.0 || !to_world.determinant().is_finite() {
        return Err(Problem::invalid(
            fields.span_of("to_world"),
            "\"to_world\" cannot be inverted",
        )
        .help("scale by finite numbers other than 0"));
    }
    let rows = to_world.rows.iter().chain([&to_world.translation]);
    let mut numbers = rows.flat_map(|row| row.to_array());
    if numbers.any(|x| x.abs() > LARGEST_COORDINATE) {
        let span = fields.span_of("to_world");
        let help = format!("scale and translate by numbers up to {LARGEST_COORDINATE:e}");
        return Err(Problem::invalid(span, "\"to_world\" leads out of reach").help(help));
    }
    Ok(to_world)
}
