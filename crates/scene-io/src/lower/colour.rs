//! Colours of materials and emitters.

use capwalk_math::Rgb;

use crate::fields::{Context, Fields};
use crate::node::{PropertyValue, Spectrum};
use crate::problem::Problem;
use crate::texts::Span;

/// Linear sRGB of a spectrum that is 1 everywhere, which is not white: the
/// white of sRGB is daylight (D65). `xyz_to_srgb(1, 1, 1)` of Mitsuba.
const FLAT_SPECTRUM: Rgb = Rgb::new(1.204794, 0.948292, 0.908916);

/// Reflectance: one number is the same for all colours.
pub(super) fn reflectance(
    context: &Context,
    fields: &Fields,
    name: &'static str,
    default: f64,
) -> Result<Rgb, Problem> {
    let Some(property) = fields.get(name) else {
        return Ok(Rgb::splat(default));
    };
    let span = property.value_span;
    let colour = match property.value {
        PropertyValue::Rgb(rgb) => {
            // Mitsuba refuses these as well.
            if rgb.max_component() > 1.0 {
                return Err(Problem::invalid(
                    span,
                    format!("\"{name}\" is ({}, {}, {})", rgb.r, rgb.g, rgb.b),
                )
                .help(
                    "expected numbers from 0 to 1: a surface cannot reflect more than it receives",
                ));
            }
            rgb
        }
        PropertyValue::Float(x) => Rgb::splat(x),
        PropertyValue::Integer(i) => Rgb::splat(i as f64),
        PropertyValue::Spectrum(Spectrum::Uniform(x)) => Rgb::splat(x),
        ref other => return Err(not_a_colour(name, other, span)),
    };
    refuse_negative(name, colour, span)?;
    if colour.max_component() > 1.0 {
        let message = format!("\"{name}\" is above 1: the surface reflects more than it receives");
        context.warn(span, &message);
    }
    Ok(colour)
}

/// Radiance: a uniform spectrum has the colour that it has under daylight white.
pub(super) fn radiance(fields: &Fields, name: &'static str, default: f64) -> Result<Rgb, Problem> {
    let Some(property) = fields.get(name) else {
        return Ok(Rgb::splat(default));
    };
    let span = property.value_span;
    let colour = match property.value {
        PropertyValue::Rgb(rgb) => rgb,
        PropertyValue::Float(x) => Rgb::splat(x),
        PropertyValue::Integer(i) => Rgb::splat(i as f64),
        PropertyValue::Spectrum(Spectrum::Uniform(x)) => FLAT_SPECTRUM * x,
        ref other => return Err(not_a_colour(name, other, span)),
    };
    refuse_negative(name, colour, span)?;
    Ok(colour)
}

/// Linear colours of any size; a uniform spectrum is the same for all colours.
pub(super) fn unbounded(fields: &Fields, name: &'static str, default: Rgb) -> Result<Rgb, Problem> {
    let Some(property) = fields.get(name) else {
        return Ok(default);
    };
    let span = property.value_span;
    let colour = match property.value {
        PropertyValue::Rgb(rgb) => rgb,
        PropertyValue::Float(x) | PropertyValue::Spectrum(Spectrum::Uniform(x)) => Rgb::splat(x),
        PropertyValue::Integer(i) => Rgb::splat(i as f64),
        ref other => return Err(not_a_colour(name, other, span)),
    };
    refuse_negative(name, colour, span)?;
    Ok(colour)
}

fn refuse_negative(name: &str, colour: Rgb, span: Span) -> Result<(), Problem> {
    if !colour.to_array().iter().any(|&channel| channel < 0.0) {
        return Ok(());
    }
    Err(Problem::invalid(
        span,
        format!("\"{name}\" is ({}, {}, {})", colour.r, colour.g, colour.b),
    )
    .help("expected numbers of at least 0"))
}

fn not_a_colour(name: &str, value: &PropertyValue, span: Span) -> Problem {
    match value {
        PropertyValue::Object { .. } => {
            Problem::invalid(span, format!("\"{name}\" is an object of another kind"))
                .help("expected a <texture>, or <rgb name=\"...\" value=\"r, g, b\"/>")
        }
        PropertyValue::Spectrum(Spectrum::Sampled) => Problem::unsupported(
            span,
            format!("\"{name}\" depends on the wavelength"),
        )
        .help(
            "light is computed in red, green and blue: give <rgb name=\"...\" value=\"r, g, b\"/> \
                 or a <spectrum> with one number",
        ),
        other => Problem::invalid(span, format!("\"{name}\" is a <{}>", other.tag()))
            .help(format!("expected <rgb name=\"{name}\" value=\"r, g, b\"/>")),
    }
}
