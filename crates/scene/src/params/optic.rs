//! The numbers of the sensor's optics, in the units that users have them in.

use super::parameter::ParameterKind;
use crate::scene::Scene;
use crate::sensor::Optic;

/// The sort, the unit and a description of a number of the sensor.
pub(super) fn optic_text(optic: Optic) -> (ParameterKind, &'static str, &'static str) {
    use ParameterKind::*;
    match optic {
        Optic::FovX => (
            FieldOfView,
            "degrees",
            "horizontal field of view of the film",
        ),
        Optic::ApertureRadius => (ApertureRadius, "world units", "radius of the lens"),
        Optic::FocusDistance => (FocusDistance, "world units", "depth that is sharp"),
    }
}

/// How much the sensor's own number changes for a unit of the parameter: users
/// have fields of view in degrees.
pub(super) fn optic_scale(optic: Optic) -> f64 {
    match optic {
        Optic::FovX => 1.0_f64.to_radians(),
        Optic::ApertureRadius | Optic::FocusDistance => 1.0,
    }
}

/// What a number of the sensor is now, in the parameter's unit.
pub(super) fn optic_value(scene: &Scene, optic: Optic) -> f64 {
    let number = scene.sensor.model.optic(optic);
    number.unwrap_or(0.0) / optic_scale(optic)
}
