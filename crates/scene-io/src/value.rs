//! The texts of attributes as numbers, vectors, colours and transforms.

use capwalk_math::{Affine, Rgb, Vec3};

use crate::node::Spectrum;
use crate::problem::Problem;
use crate::spectrum::{Samples, finite};
use crate::texts::Span;
use crate::xml::{Attribute, Element};

/// How far the length of a rotation's axis may be from 1: the rounding of axes
/// written with three digits.
const ROUNDED_AXIS: f64 = 2e-3;

/// What a spectrum needs.
pub(crate) const PAIRS_HELP: &str = "expected two or more increasing wavelengths in nanometers, each with a value: 400:0.1, 700:0.5";

/// The number that a text spells, infinities and NaN refused.
pub(crate) fn float(text: &str, span: Span) -> Result<f64, Problem> {
    let number: Option<f64> = text.trim().parse().ok();
    number.filter(|x| x.is_finite()).ok_or_else(|| {
        Problem::invalid(span, format!("\"{text}\" is not a finite number"))
            .help("expected a number like 1, 0.25 or 1e-3")
    })
}

/// The number that a text spells, without fraction.
pub(crate) fn integer(text: &str, span: Span) -> Result<i64, Problem> {
    text.trim().parse().map_err(|_| {
        Problem::invalid(span, format!("\"{text}\" is not a whole number"))
            .help("expected one like 64")
    })
}

/// True if a text is `true`, capitals or not; an error unless it is `true` or `false`.
pub(crate) fn boolean(text: &str, span: Span) -> Result<bool, Problem> {
    match text.to_ascii_lowercase().as_str() {
        "true" => Ok(true),
        "false" => Ok(false),
        _ => Err(
            Problem::invalid(span, format!("\"{text}\" is not a boolean"))
                .help("expected true or false"),
        ),
    }
}

/// Numbers separated by blanks or commas.
pub(crate) fn floats(attribute: &Attribute) -> Result<Vec<f64>, Problem> {
    words(&attribute.value)
        .map(|word| float(word, attribute.value_span))
        .collect()
}

/// The words between blanks and commas.
pub(crate) fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| c == ',' || c.is_whitespace())
        .filter(|word| !word.is_empty())
}

fn three(attribute: &Attribute, numbers: &[f64]) -> Result<Vec3, Problem> {
    match *numbers {
        [x, y, z] => Ok(Vec3::new(x, y, z)),
        _ => Err(Problem::invalid(
            attribute.value_span,
            format!("\"{}\" has {} numbers", attribute.value, numbers.len()),
        )
        .help(format!("expected three: {}=\"x, y, z\"", attribute.name))),
    }
}

/// A vector from the attributes `x`, `y`, `z`, or from `value` with one number
/// or three. `default` stands for missing components; without it they must be
/// there.
pub(crate) fn vector(element: &Element, default: Option<f64>) -> Result<Vec3, Problem> {
    let Some(value) = element.attribute("value") else {
        let component = |name| match (element.attribute(name), default) {
            (Some(a), _) => float(&a.value, a.value_span),
            (None, Some(default)) => Ok(default),
            (None, None) => element.required(name).map(|_| 0.0),
        };
        return Ok(Vec3::new(component("x")?, component("y")?, component("z")?));
    };
    let mut mixed = ["x", "y", "z"].iter().filter_map(|n| element.attribute(n));
    if let Some(mixed) = mixed.next() {
        return Err(Problem::invalid(
            mixed.name_span,
            format!(
                "<{}> has both \"value\" and \"{}\"",
                element.tag, mixed.name
            ),
        )
        .help("give either value=\"x, y, z\" or x, y and z"));
    }
    match floats(value)?[..] {
        [all] => Ok(Vec3::splat(all)),
        ref numbers => three(value, numbers),
    }
}

/// A linear colour: one number, three, or `#rrggbb` in sRGB.
pub(crate) fn rgb(attribute: &Attribute) -> Result<Rgb, Problem> {
    let help = "expected \"r, g, b\", one number for a grey, or #rrggbb (decoded from sRGB)";
    let text = attribute.value.trim();
    if let Some(digits) = text.strip_prefix('#') {
        let code = u32::from_str_radix(digits, 16).ok();
        let is_hex = digits.len() == 6 && digits.bytes().all(|b| b.is_ascii_hexdigit());
        return code.filter(|_| is_hex).map(hex_colour).ok_or_else(|| {
            Problem::invalid(attribute.value_span, format!("\"{text}\" is not a colour")).help(help)
        });
    }
    match floats(attribute).map_err(|problem| problem.help(help))?[..] {
        [grey] => Ok(Rgb::splat(grey)),
        [r, g, b] => Ok(Rgb::new(r, g, b)),
        ref numbers => Err(Problem::invalid(
            attribute.value_span,
            format!("\"{text}\" has {} numbers", numbers.len()),
        )
        .help(help)),
    }
}

/// The linear colour of `0xrrggbb` in sRGB.
fn hex_colour(code: u32) -> Rgb {
    let channel = |shift: u32| linear_of_srgb(f64::from((code >> shift) & 0xff) / 255.0);
    Rgb::new(channel(16), channel(8), channel(0))
}

/// Linear light of a channel encoded as sRGB, both from 0 to 1 (IEC 61966-2-1).
pub(crate) fn linear_of_srgb(encoded: f64) -> f64 {
    match encoded <= 0.04045 {
        true => encoded / 12.92,
        false => ((encoded + 0.055) / 1.055).powf(2.4),
    }
}

/// `<spectrum value="0.5"/>`, one with a value at each of some wavelengths, or the name of a
/// file of them.
pub(crate) fn spectrum(element: &Element) -> Result<Spectrum, Problem> {
    let (value, filename) = (element.attribute("value"), element.attribute("filename"));
    let help = "write <spectrum name=\"...\" value=\"0.5\"/>, value=\"400:0.1, 700:0.5\" with \
                wavelengths in nanometers, or filename=\"reflectance.spd\"";
    match (value, filename) {
        (None, None) => {
            let message = "<spectrum> has no attribute \"value\"";
            Err(Problem::missing(element.span, message).help(help))
        }
        (Some(_), Some(filename)) => {
            let message = "<spectrum> has both \"value\" and \"filename\"";
            Err(Problem::invalid(filename.name_span, message).help("keep one of them"))
        }
        (None, Some(filename)) => Ok(Spectrum::File(filename.value.clone())),
        (Some(value), None) => match words(&value.value).collect::<Vec<_>>()[..] {
            [] => float("", value.value_span).map(Spectrum::Uniform),
            [word] if !word.contains(':') => float(word, value.value_span).map(Spectrum::Uniform),
            ref pairs => samples(pairs, value.value_span).map(Spectrum::Sampled),
        },
    }
}

/// The spectrum of words such as `400:0.1`, a wavelength in nanometers and a value.
fn samples(words: &[&str], span: Span) -> Result<Samples, Problem> {
    let pair = |word: &&str| {
        let (wavelength, value) = word.split_once(':').unwrap_or((word, ""));
        match (finite(wavelength), finite(value)) {
            (Some(wavelength), Some(value)) => Ok((wavelength, value)),
            _ => Err(format!("\"{word}\" is not a wavelength and a value")),
        }
    };
    let pairs: Result<Vec<_>, String> = words.iter().map(pair).collect();
    pairs
        .and_then(|pairs| Samples::new(&pairs))
        .map_err(|message| Problem::invalid(span, message).help(PAIRS_HELP))
}

/// The children of a `<transform>`; later ones act after earlier ones. What is odd about them
/// is added to `warnings`.
pub(crate) fn transform(
    element: &Element,
    warnings: &mut Vec<(Span, String)>,
) -> Result<Affine, Problem> {
    let mut total = Affine::IDENTITY;
    for step in &element.children {
        if let Some(child) = step.children.first() {
            return Err(Problem::invalid(
                child.span,
                format!("<{}> cannot stand inside <{}>", child.tag, step.tag),
            )
            .help("move it behind"));
        }
        total = transform_step(step, warnings)? * total;
    }
    Ok(total)
}

fn transform_step(step: &Element, warnings: &mut Vec<(Span, String)>) -> Result<Affine, Problem> {
    match step.tag.as_str() {
        "translate" => {
            step.only_attributes(&["value", "x", "y", "z"])?;
            Ok(Affine::translate(vector(step, Some(0.0))?))
        }
        "scale" => {
            step.only_attributes(&["value", "x", "y", "z"])?;
            Ok(Affine::scale(vector(step, Some(1.0))?))
        }
        "rotate" => {
            step.only_attributes(&["value", "x", "y", "z", "angle"])?;
            let angle = step.required("angle")?;
            let degrees = float(&angle.value, angle.value_span)?;
            let most = Affine::LARGEST_ANGLE.to_degrees();
            if degrees.abs() > most {
                let message = format!("the rotation by {degrees} degrees means nothing");
                let help =
                    format!("expected at most {most:.0}: beyond, rounding decides where it ends");
                return Err(Problem::invalid(angle.value_span, message).help(help));
            }
            let axis = vector(step, Some(0.0))?;
            if axis == Vec3::zero() {
                return Err(
                    Problem::invalid(step.span, "the axis of the rotation is zero")
                        .help("write for example <rotate y=\"1\" angle=\"90\"/>, in degrees"),
                );
            }
            let length = axis.length();
            if (length - 1.0).abs() <= ROUNDED_AXIS {
                return Ok(Affine::rotate(axis, degrees.to_radians()));
            }
            let message = format!(
                "the axis of the rotation has the length {length:.4}: with any but 1, Mitsuba \
                 distorts instead of rotating, and so does this"
            );
            warnings.push((step.span, message));
            Ok(Affine::rodrigues(axis, degrees.to_radians()))
        }
        "lookat" => look_at(step),
        "matrix" => matrix(step),
        _ => Err(Problem::unknown(
            step.span,
            format!("<{}> cannot stand inside <transform>", step.tag),
        )
        .help("a transform is made of translate, rotate, scale, lookat and matrix")
        .near(crate::suggest::nearest(
            &step.tag,
            ["translate", "rotate", "scale", "lookat", "matrix"],
        ))),
    }
}

fn look_at(step: &Element) -> Result<Affine, Problem> {
    step.only_attributes(&["origin", "target", "up"])?;
    let point = |attribute: &Attribute| three(attribute, &floats(attribute)?);
    let origin = point(step.required("origin")?)?;
    let target = point(step.required("target")?)?;
    let up = match step.attribute("up") {
        Some(attribute) if !attribute.value.is_empty() => point(attribute)?,
        _ => Vec3::zero(),
    };
    let up = match up == Vec3::zero() {
        true => any_up((target - origin).normalized()),
        false => up,
    };
    Affine::look_at(origin, target, up).ok_or_else(|| {
        let what = match origin == target {
            true => "the view has no direction: \"origin\" and \"target\" are the same point",
            false => "\"up\" is parallel to the view",
        };
        Problem::invalid(step.span, what)
            .help("origin and target must differ, and up must not be parallel to the view")
    })
}

/// The `up` that Mitsuba takes when none is given: the first tangent of its
/// coordinate system around the view (Duff et al. 2017, with its sign).
fn any_up(n: Vec3) -> Vec3 {
    let sign = 1.0_f64.copysign(n.z);
    let a = -1.0 / (sign + n.z);
    let b = n.x * n.y * a;
    Vec3::new(sign * (n.x * n.x * a) + 1.0, sign * b, -sign * n.x)
}

fn matrix(step: &Element) -> Result<Affine, Problem> {
    step.only_attributes(&["value"])?;
    let attribute = step.required("value")?;
    let row = |m: &[f64]| Vec3::new(m[0], m[1], m[2]);
    match &floats(attribute)?[..] {
        m if m.len() == 9 => Ok(Affine {
            rows: [row(m), row(&m[3..]), row(&m[6..])],
            translation: Vec3::zero(),
        }),
        m if m.len() == 16 => {
            if m[12..] != [0.0, 0.0, 0.0, 1.0] {
                return Err(Problem::unsupported(
                    attribute.value_span,
                    "the last row of the matrix is not 0 0 0 1",
                )
                .help("only affine transforms are read; give 16 numbers row by row"));
            }
            Ok(Affine {
                rows: [row(m), row(&m[4..]), row(&m[8..])],
                translation: Vec3::new(m[3], m[7], m[11]),
            })
        }
        m => Err(Problem::invalid(
            attribute.value_span,
            format!("the matrix has {} numbers", m.len()),
        )
        .help("expected 9 or 16, row by row")),
    }
}
