//! Numbers and names for people: sensible digits, standard errors, names that fit a line.

use std::borrow::Cow;

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

/// Names in a message, at most; the others are counted.
const MOST_NAMES: usize = 20;

/// The longest name in a message or a table, characters. Longer ones are cut: they are nobody's
/// to read, and make lines that nobody can.
const LONGEST_NAME: usize = 200;

/// Names, separated by commas, the first of them if there are many.
pub fn listed(names: &[impl AsRef<str>]) -> String {
    let shown: Vec<_> = names.iter().take(MOST_NAMES).map(cut).collect();
    let more = match names.len().saturating_sub(MOST_NAMES) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    shown.join(", ") + &more
}

/// A name, or its beginning with an ellipsis if it is too long.
pub fn cut<'a>(name: &'a (impl AsRef<str> + ?Sized)) -> Cow<'a, str> {
    let name: &'a str = name.as_ref();
    match name.char_indices().nth(LONGEST_NAME) {
        None => name.into(),
        Some((end, _)) => format!("{}…", &name[..end]).into(),
    }
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

    /// Names of any length and number fit a message and a table.
    #[test]
    fn long_names_are_cut() {
        let long = "ä".repeat(70_000);
        assert_eq!(cut(&long).chars().count(), LONGEST_NAME + 1);
        assert_eq!(cut("leaf"), "leaf");
        assert_eq!(listed(&["a", "b"]), "a, b");
        let many = listed(&vec![long; 3_000]);
        assert!(many.ends_with("… and 2980 more"), "{many}");
        assert!(many.chars().count() < 21 * LONGEST_NAME);
    }

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
