//! Spectra that are objects, `<spectrum type="...">`: textures of one colour or number.

use capwalk_math::{Rgb, Vec3};
use capwalk_scene::{Quantity, Texture, TextureId};

use super::colour::is_light;
use super::lowering::Lowering;
use crate::fields::{Child, Fields};
use crate::node::{Kind, PropertyValue, Spectrum};
use crate::problem::Problem;
use crate::spectrum::{Samples, black_body};
use crate::texts::Span;
use crate::value;

/// Values of `type` that are read.
pub(super) const SPECTRA: [&str; 7] = [
    "blackbody",
    "d65",
    "irregular",
    "rawconstant",
    "regular",
    "srgb",
    "uniform",
];

/// True for plugins whose colour depends on whether they are light or reflect it.
pub(super) fn depends_on_use(plugin: &str) -> bool {
    ["blackbody", "irregular", "regular"].contains(&plugin)
}

impl Lowering<'_> {
    /// The texture of a spectrum, whose plugin is one of [`SPECTRA`].
    pub(super) fn spectrum_plugin(
        &mut self,
        fields: &Fields,
        id: &str,
        quantity: Quantity,
    ) -> Result<TextureId, Problem> {
        let span = fields.node.span;
        let reason = "the spectrum is the same at all wavelengths";
        let texture = match fields.node.plugin.as_str() {
            "blackbody" => Texture::colour(id, self.black_body(fields, quantity)?),
            "d65" => return self.daylight(fields, id, quantity),
            "irregular" | "regular" => {
                let samples = samples(fields)?;
                Texture::colour(id, self.colour_of_samples(&samples, id, quantity, span))
            }
            "srgb" => {
                required(
                    fields,
                    "color",
                    "<rgb name=\"color\" value=\"0.1, 0.2, 0.3\"/>",
                )?;
                let bound = match fields.boolean("unbounded", false)? {
                    true => Quantity::Radiance,
                    false => Quantity::Reflectance,
                };
                Texture::colour(id, self.plain_colour(fields, "color", bound, Rgb::zero())?)
            }
            "rawconstant" => match required(fields, "value", A_NUMBER)? {
                PropertyValue::Vector(v) => Texture::colour(id, rgb(*v)),
                _ => Texture::number(id, fields.float("value", 0.0)?),
            },
            _ => {
                fields.cosmetic(&["wavelength_min", "wavelength_max"], reason);
                required(fields, "value", A_NUMBER)?;
                Texture::number(id, fields.float("value", 0.0)?)
            }
        };
        Ok(self.add_texture(texture, span))
    }

    /// Daylight is white: it changes nothing but the brightness of what it is multiplied by.
    fn daylight(
        &mut self,
        fields: &Fields,
        id: &str,
        quantity: Quantity,
    ) -> Result<TextureId, Problem> {
        let scale = fields.float("scale", 1.0)?;
        let colour = self.plain_colour(fields, "color", Quantity::Radiance, Rgb::splat(1.0))?;
        let texture = match (fields.child(Kind::Texture)?, fields.get("color")) {
            (Some(Child { span, .. }), Some(_)) => {
                let message = "the spectrum \"d65\" has both a color and a texture";
                return Err(Problem::invalid(span, message).help("keep one of them"));
            }
            (Some(Child { node, span, .. }), None) => {
                if scale != 1.0 {
                    let message = "\"scale\" has no effect on the texture in a \"d65\"";
                    self.context.warn(span, message);
                }
                return self.texture(node, id, quantity);
            }
            (None, Some(_)) => Texture::colour(id, colour * scale),
            (None, None) => Texture::number(id, scale),
        };
        Ok(self.add_texture(texture, fields.node.span))
    }

    /// A colour that can be no texture, and may be given as three numbers.
    fn plain_colour(
        &self,
        fields: &Fields,
        name: &'static str,
        quantity: Quantity,
        default: Rgb,
    ) -> Result<Rgb, Problem> {
        match fields.get(name).map(|property| &property.value) {
            Some(PropertyValue::Vector(v)) => {
                let span = fields.span_of(name);
                self.allowed(rgb(*v), name, quantity, true, span)
            }
            _ => self.colour(fields, name, quantity, default),
        }
    }

    fn black_body(&self, fields: &Fields, quantity: Quantity) -> Result<Rgb, Problem> {
        let span = fields.node.span;
        if !is_light(quantity) {
            let message = format!("a black body is used as a {}", quantity.name());
            return Err(Problem::invalid(span, message).help("it is the spectrum of an emitter"));
        }
        required(
            fields,
            "temperature",
            "<float name=\"temperature\" value=\"5000\"/>",
        )?;
        let temperature = fields.float("temperature", 0.0)?;
        let scale = fields.float("scale", 1.0)?;
        if temperature <= 0.0 || scale < 0.0 {
            let message = format!("\"temperature\" is {temperature} and \"scale\" is {scale}");
            return Err(Problem::invalid(fields.span_of("temperature"), message)
                .help("expected kelvin above 0, and a scale of at least 0"));
        }
        let first = fields.float("wavelength_min", f64::NEG_INFINITY)?;
        let last = fields.float("wavelength_max", f64::INFINITY)?;
        let colour = black_body(temperature, [first, last]) * scale;
        Ok(self.clamped(colour, f64::INFINITY, "blackbody", span))
    }
}

fn rgb(v: Vec3) -> Rgb {
    Rgb::new(v.x, v.y, v.z)
}

/// What a spectrum with one number needs.
const A_NUMBER: &str = "<float name=\"value\" value=\"0.5\"/>";

/// The wavelengths and values of a `regular` or `irregular` spectrum.
fn samples(fields: &Fields) -> Result<Samples, Problem> {
    if let Some(property) = fields.get("value") {
        let PropertyValue::Spectrum(Spectrum::Sampled(samples)) = &property.value else {
            let message = format!("\"value\" of {} has no wavelengths", fields.title());
            return Err(Problem::invalid(property.value_span, message).help(value::PAIRS_HELP));
        };
        return Ok(samples.clone());
    }
    let values = numbers(fields, "values")?;
    let wavelengths = match fields.node.plugin.as_str() {
        "regular" => {
            let (first, last) = ("wavelength_min", "wavelength_max");
            for bound in [first, last] {
                required(fields, bound, "both, as <float>, in nanometers")?;
            }
            let (first, last) = (fields.float(first, 0.0)?, fields.float(last, 0.0)?);
            let steps = values.len().saturating_sub(1).max(1) as f64;
            let place = |i| first + (last - first) * i as f64 / steps;
            (0..values.len()).map(place).collect()
        }
        _ => numbers(fields, "wavelengths")?,
    };
    let pairs = match wavelengths.len() == values.len() {
        true => Ok(wavelengths.into_iter().zip(values).collect::<Vec<_>>()),
        false => Err(format!(
            "there are {} wavelengths and {} values",
            wavelengths.len(),
            values.len()
        )),
    };
    pairs
        .and_then(|pairs| Samples::new(&pairs))
        .map_err(|message| {
            Problem::invalid(fields.span_of("values"), message).help(value::PAIRS_HELP)
        })
}

/// The numbers in a text property.
fn numbers(fields: &Fields, name: &'static str) -> Result<Vec<f64>, Problem> {
    required(fields, name, "a <string> of numbers")?;
    let text = fields.string(name)?.unwrap_or("");
    let span: Span = fields.span_of(name);
    value::words(text)
        .map(|word| value::float(word, span))
        .collect()
}

/// The value of a property, or an error that asks for it.
fn required<'a>(
    fields: &Fields<'a>,
    name: &'static str,
    help: &str,
) -> Result<&'a PropertyValue, Problem> {
    match fields.get(name) {
        Some(property) => Ok(&property.value),
        None => {
            let message = format!("{} has no \"{name}\"", fields.title());
            Err(Problem::missing(fields.node.span, message).help(format!("add {help}")))
        }
    }
}
