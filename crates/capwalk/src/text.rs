//! Numbers for people: sensible digits, standard errors.

/// A number with three significant digits.
pub fn number(x: f64) -> String {
    significant(x, 3)
}

/// A number with so many significant digits, in powers of ten where plain
/// digits would be long.
pub fn significant(x: f64, digits: i32) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    let magnitude = x.abs().log10().floor() as i32;
    if (-4..7).contains(&magnitude) {
        let decimals = (digits - 1 - magnitude).max(0) as usize;
        format!("{x:.decimals$}")
    } else {
        let decimals = (digits - 1).max(0) as usize;
        format!("{x:.decimals$e}")
    }
}

/// A number and its standard error, both to the second digit of the error.
pub fn plus_minus(x: f64, error: f64) -> String {
    if !error.is_finite() || error <= 0.0 || !x.is_finite() {
        return format!("{} ± {}", number(x), number(error));
    }
    let decimals = (1 - error.log10().floor() as i32).max(0) as usize;
    if decimals > 8 {
        return format!("{x:.6e} ± {error:.1e}");
    }
    format!("{x:.decimals$} ± {error:.decimals$}")
}

/// A whole number with its thousands apart.
pub fn count(n: u64) -> String {
    let digits = n.to_string();
    let groups: Vec<&str> = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .map(|group| std::str::from_utf8(group).expect("digits are ASCII"))
        .collect();
    groups.join(",")
}

/// Lines of a name and what belongs to it, aligned.
pub fn list(lines: &[(&str, String)]) -> String {
    let width = lines.iter().map(|(name, _)| name.chars().count()).max();
    let width = width.unwrap_or(0);
    lines
        .iter()
        .map(|(name, what)| format!("{name:width$}   {what}\n"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_follow_the_error() {
        assert_eq!(plus_minus(0.98731, 0.00213), "0.9873 ± 0.0021");
        assert_eq!(plus_minus(1234.5, 21.0), "1234 ± 21");
        assert_eq!(plus_minus(1.0, f64::INFINITY), "1.00 ± inf");
        assert_eq!(plus_minus(1.0, 0.0), "1.00 ± 0");
        assert_eq!(plus_minus(1e-12, 2e-13), "1.000000e-12 ± 2.0e-13");
    }

    #[test]
    fn numbers_keep_three_digits() {
        for (x, text) in [
            (0.0, "0"),
            (1.0, "1.00"),
            (0.012345, "0.0123"),
            (123456.0, "123456"),
            (1.5e-9, "1.50e-9"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(number(x), text);
        }
        assert_eq!(count(1234567), "1,234,567");
        assert_eq!(count(12), "12");
    }
}
