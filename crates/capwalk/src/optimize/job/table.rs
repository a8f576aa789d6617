//! Keys that may be left out.

use std::ops::RangeInclusive;

use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::Table;

/// Largest number of samples, iterations and the like.
pub const MOST: i64 = u32::MAX as i64;

/// A whole number in this range.
pub fn integer(
    table: &Table,
    key: &'static str,
    allowed: RangeInclusive<i64>,
) -> Result<Option<i64>, LoadError> {
    table
        .get(key)
        .map(|value| value.integer(allowed))
        .transpose()
}

/// A finite number that is allowed, in words `expected`.
pub fn number(
    table: &Table,
    key: &'static str,
    expected: &str,
    allowed: impl Fn(f64) -> bool,
) -> Result<Option<f64>, LoadError> {
    let value = table.get(key);
    value
        .map(|value| value.number(expected, allowed))
        .transpose()
}

/// True or false.
pub fn truth(table: &Table, key: &'static str) -> Result<Option<bool>, LoadError> {
    table.get(key).map(|value| value.truth()).transpose()
}

/// A number above 0.
pub fn positive(table: &Table, key: &'static str) -> Result<Option<f64>, LoadError> {
    number(table, key, "a number above 0", |x| x > 0.0)
}

/// A number from 0 to 1.
pub fn fraction(table: &Table, key: &'static str) -> Result<Option<f64>, LoadError> {
    number(table, key, "a number from 0 to 1", |x| {
        (0.0..=1.0).contains(&x)
    })
}
