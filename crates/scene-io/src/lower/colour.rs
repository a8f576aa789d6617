//! Colours of materials and emitters.

use capwalk_math::Rgb;
use capwalk_scene::Quantity;

use super::lowering::Lowering;
use crate::fields::Fields;
use crate::node::{PropertyValue, Spectrum};
use crate::problem::Problem;
use crate::spectrum::{Samples, equal_energy};
use crate::texts::Span;

impl Lowering<'_> {
    /// The linear sRGB colour of a property, as Mitsuba's `rgb` variants read it for this
    /// quantity: reflectances are under daylight and at most 1, a flat spectrum of light is
    /// not white.
    pub(super) fn colour(
        &self,
        fields: &Fields,
        name: &'static str,
        quantity: Quantity,
        default: Rgb,
    ) -> Result<Rgb, Problem> {
        let Some(property) = fields.get(name) else {
            return Ok(default);
        };
        let span = property.value_span;
        let colour = match &property.value {
            PropertyValue::Rgb(rgb) => *rgb,
            PropertyValue::Float(x) => Rgb::splat(*x),
            PropertyValue::Integer(i) => Rgb::splat(*i as f64),
            PropertyValue::Spectrum(Spectrum::Uniform(x)) if is_light(quantity) => {
                equal_energy() * *x
            }
            PropertyValue::Spectrum(Spectrum::Uniform(x)) => Rgb::splat(*x),
            PropertyValue::Spectrum(Spectrum::Sampled(samples)) => {
                return Ok(self.colour_of_samples(samples, name, quantity, span));
            }
            PropertyValue::Spectrum(Spectrum::File(file)) => {
                let samples = self.spectrum_file(file, span)?;
                return Ok(self.colour_of_samples(&samples, name, quantity, span));
            }
            other => return Err(not_a_colour(name, other, span)),
        };
        // Mitsuba refuses such an <rgb>, and takes one number above 1.
        let strict = matches!(property.value, PropertyValue::Rgb(_));
        self.allowed(colour, name, quantity, strict, span)
    }

    /// The colour, if the quantity may be that; above 1 only with a warning, or not if `strict`.
    pub(super) fn allowed(
        &self,
        colour: Rgb,
        name: &str,
        quantity: Quantity,
        strict: bool,
        span: Span,
    ) -> Result<Rgb, Problem> {
        let shown = || format!("\"{name}\" is ({}, {}, {})", colour.r, colour.g, colour.b);
        if colour.to_array().iter().any(|&channel| channel < 0.0) {
            if matches!(quantity, Quantity::MetalIndex | Quantity::Extinction) {
                self.context
                    .warn(span, &format!("{}: the sign has no effect", shown()));
                return Ok(colour.map(f64::abs));
            }
            return Err(Problem::invalid(span, shown()).help("expected numbers of at least 0"));
        }
        if is_fraction(quantity) && colour.max_component() > 1.0 {
            if strict {
                return Err(Problem::invalid(span, shown()).help(
                    "expected numbers from 0 to 1: a surface cannot reflect more than it receives",
                ));
            }
            let message =
                format!("\"{name}\" is above 1: the surface reflects more than it receives");
            self.context.warn(span, &message);
        }
        Ok(colour)
    }

    /// The spectrum in a file.
    fn spectrum_file(&self, name: &str, span: Span) -> Result<Samples, Problem> {
        let (bytes, path) = self.read_file(name, span)?;
        let text = String::from_utf8(bytes).map_err(|_| "it is not a text".to_owned());
        let samples = text.and_then(|text| Samples::parse_file(&text));
        samples.map_err(|message| {
            let message = format!("\"{}\": {message}", path.display());
            Problem::invalid(span, message).help(
                "expected two or more lines with a wavelength in nanometers and a value, the \
                 wavelengths increasing",
            )
        })
    }

    /// The colour of a spectrum, brought into the range that the quantity has.
    pub(super) fn colour_of_samples(
        &self,
        samples: &Samples,
        name: &str,
        quantity: Quantity,
        span: Span,
    ) -> Rgb {
        let colour = match is_light(quantity) {
            true => samples.colour_of_light(),
            false => samples.colour_by_daylight(),
        };
        let most = match is_fraction(quantity) {
            true => 1.0,
            false => f64::INFINITY,
        };
        self.clamped(colour, most, name, span)
    }

    /// The colour with channels from 0 to `most`, and a warning if it changes.
    pub(super) fn clamped(&self, colour: Rgb, most: f64, name: &str, span: Span) -> Rgb {
        let clamped = colour.map(|channel| channel.clamp(0.0, most));
        if clamped != colour {
            let (from, to) = (shown(colour), shown(clamped));
            let message =
                format!("\"{name}\" has a colour that sRGB lacks: {from} is read as {to}");
            self.context.warn(span, &message);
        }
        clamped
    }
}

/// True for what emitters emit.
pub(super) fn is_light(quantity: Quantity) -> bool {
    matches!(
        quantity,
        Quantity::Radiance | Quantity::Intensity | Quantity::Irradiance
    )
}

/// True for what a surface makes of light.
fn is_fraction(quantity: Quantity) -> bool {
    matches!(quantity, Quantity::Reflectance | Quantity::Transmittance)
}

fn shown(colour: Rgb) -> String {
    format!("({:.4}, {:.4}, {:.4})", colour.r, colour.g, colour.b)
}

fn not_a_colour(name: &str, value: &PropertyValue, span: Span) -> Problem {
    match value {
        PropertyValue::Object { .. } => {
            Problem::invalid(span, format!("\"{name}\" is an object of another kind"))
                .help("expected a <texture>, or <rgb name=\"...\" value=\"r, g, b\"/>")
        }
        other => Problem::invalid(span, format!("\"{name}\" is a <{}>", other.tag()))
            .help(format!("expected <rgb name=\"{name}\" value=\"r, g, b\"/>")),
    }
}
