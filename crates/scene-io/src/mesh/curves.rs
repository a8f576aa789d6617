//! Curves as Mitsuba reads them: a line of text for each control point, `x y z radius`, and
//! empty lines between curves.

use capwalk_geometry::mesh::LARGEST_COORDINATE;
use capwalk_math::Vec3;
use capwalk_scene::primitive::ControlPoint;

use super::checked::finite_position;
use super::error::{MeshFileError, MeshPlace};

/// The curves in the bytes of a file, each with `least` control points or more, in the
/// coordinates of the file.
pub fn read_curves(bytes: &[u8], least: usize) -> Result<Vec<Vec<ControlPoint>>, MeshFileError> {
    let mut curves = Vec::new();
    let mut curve = Vec::new();
    let mut last_line = 0;
    for (index, line) in bytes.split(|&b| b == b'\n').enumerate() {
        if line.trim_ascii().is_empty() {
            finish(&mut curves, &mut curve, least, last_line)?;
        } else {
            last_line = index + 1;
            curve.push(control_point(line, last_line)?);
        }
    }
    finish(&mut curves, &mut curve, least, last_line)?;
    match curves.is_empty() {
        false => Ok(curves),
        true => Err(MeshFileError::invalid(
            MeshPlace::File,
            "the file has no control points",
            "expected lines of four numbers: x, y, z, radius",
        )),
    }
}

/// Ends a curve, if there is one.
fn finish(
    curves: &mut Vec<Vec<ControlPoint>>,
    curve: &mut Vec<ControlPoint>,
    least: usize,
    line: usize,
) -> Result<(), MeshFileError> {
    match curve.len() {
        0 => Ok(()),
        n if n < least => Err(MeshFileError::invalid(
            MeshPlace::Line(line),
            format!("the curve that ends here has {n} control points"),
            format!("expected {least} or more; empty lines stand between curves only"),
        )),
        _ => {
            curves.push(std::mem::take(curve));
            Ok(())
        }
    }
}

fn control_point(line: &[u8], number: usize) -> Result<ControlPoint, MeshFileError> {
    let place = || MeshPlace::Line(number);
    let text = String::from_utf8_lossy(line);
    let numbers: Vec<Option<f64>> = text
        .split_ascii_whitespace()
        .map(|word| word.parse().ok())
        .collect();
    let [Some(x), Some(y), Some(z), Some(radius)] = numbers[..] else {
        return Err(MeshFileError::damaged(
            place(),
            format!("\"{}\" is no control point", text.trim()),
            "expected four numbers: x, y, z, radius",
        ));
    };
    let position = finite_position(Vec3::new(x, y, z), number, &place)?;
    if !(0.0..=LARGEST_COORDINATE).contains(&radius) {
        return Err(MeshFileError::invalid(
            place(),
            format!("the radius is {radius}"),
            format!("expected a number from 0 to {LARGEST_COORDINATE:e}"),
        ));
    }
    Ok(ControlPoint { position, radius })
}
