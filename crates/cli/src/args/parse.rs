//! From one typed value to its type, with a message that says what was expected.

use std::num::NonZeroU32;
use std::path::PathBuf;

use capwalk::{Choice, MethodName};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use super::typed_method::TypedMethod;

/// What the library calls by a name.
pub fn choice<T: Choice + Send + Sync>() -> impl TypedValueParser<Value = T> {
    let known = |name: String| T::named(&name).expect("one of the possible values");
    PossibleValuesParser::new(values::<T>()).map(known)
}

/// A method of the library, or finite differences.
pub fn method() -> impl TypedValueParser<Value = TypedMethod> {
    let fd = PossibleValue::new(TypedMethod::Fd.name());
    let fd = fd.help("Central finite differences, for `gradient`");
    let values = values::<MethodName>().chain([fd]);
    let typed = |name: String| MethodName::named(&name).map_or(TypedMethod::Fd, TypedMethod::Of);
    PossibleValuesParser::new(values).map(typed)
}

fn values<T: Choice>() -> impl Iterator<Item = PossibleValue> {
    let values = T::NAMES.iter();
    values.map(|&(name, choice)| PossibleValue::new(name).help(choice.help()))
}

/// A name and its value, from `NAME=VALUE`.
pub fn define(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.is_empty() => Ok((name.into(), value.into())),
        _ => Err("expected NAME=VALUE, for example spp=64".into()),
    }
}

/// A shape and its file of velocities, from `SHAPE=FILE`.
pub fn motion(text: &str) -> Result<(String, PathBuf), String> {
    match text.split_once('=') {
        Some((shape, file)) if !shape.is_empty() && !file.is_empty() => {
            Ok((shape.into(), file.into()))
        }
        _ => Err("expected SHAPE=FILE, for example bunny=velocities.npy".into()),
    }
}

/// Width and height in pixels, from `WIDTHxHEIGHT`.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once(['x', 'X', '×']);
    let parse = |(w, h): (&str, &str)| Some([w.trim().parse().ok()?, h.trim().parse().ok()?]);
    sides
        .and_then(parse)
        .ok_or_else(|| "expected WIDTHxHEIGHT in pixels, for example 640x480".into())
}

/// A number of threads.
pub fn threads(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(threads) if (1..=4096).contains(&threads) => Ok(threads),
        _ => Err("expected a number from 1 to 4096".into()),
    }
}

/// A seed of random numbers.
pub fn seed(text: &str) -> Result<u64, String> {
    let expected = |_| format!("expected a whole number from 0 to {}", u64::MAX);
    text.parse().map_err(expected)
}

/// A number of iterations.
pub fn iterations(text: &str) -> Result<NonZeroU32, String> {
    let expected = |_| "expected a whole number from 1 on".into();
    text.parse().map_err(expected)
}

/// An angle in degrees, above 0 and up to 180.
pub fn angle(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(degrees) if degrees > 0.0 && degrees <= 180.0 => Ok(degrees),
        _ => Err("expected an angle above 0 and up to 180 degrees".into()),
    }
}

/// A difference step above 0, in units of the parameter.
pub fn step(text: &str) -> Result<f64, String> {
    limit(text).map_err(|why| format!("{why}, in units of the parameter"))
}

/// Where colours end.
pub fn limit(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(limit) if limit > 0.0 && limit.is_finite() => Ok(limit),
        _ => Err("expected a number above 0".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!(size("64x48"), Ok([64, 48]));
        assert!(size("64").is_err());
        assert!(size("-1x3").is_err());
    }
}
