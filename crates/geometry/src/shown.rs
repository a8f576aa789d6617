//! Numbers in messages.

/// A number as it would be typed, exact: very large and very small ones in powers of ten.
pub fn shown(value: f64) -> String {
    match value == 0.0 || !value.is_finite() || (1e-6..1e15).contains(&value.abs()) {
        true => value.to_string(),
        false => format!("{value:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_exact() {
        for (value, text) in [
            (0.0, "0"),
            (-0.25, "-0.25"),
            (1e14, "100000000000000"),
            (1e300, "1e300"),
            (-1.5e-300, "-1.5e-300"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(shown(value), text);
        }
    }
}
