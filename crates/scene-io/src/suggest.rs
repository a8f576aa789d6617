//! Names that resemble a name that does not exist.

use strsim::levenshtein;

/// At most this many names are suggested.
const MOST_SUGGESTIONS: usize = 3;

/// Longer names are not compared: they are not typed by hand, and the comparison
/// takes time proportional to the product of the lengths.
const LONGEST_NAME: usize = 64;

/// The candidates that differ from `name` by a typing error: at most one edit
/// in every three characters, nearest first.
pub(crate) fn nearest<'a>(
    name: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Vec<String> {
    if name.len() > LONGEST_NAME {
        return Vec::new();
    }
    let mut scored: Vec<(usize, &str)> = candidates
        .into_iter()
        .filter(|candidate| candidate.len() <= LONGEST_NAME)
        .map(|candidate| {
            (
                levenshtein(&name.to_lowercase(), &candidate.to_lowercase()),
                candidate,
            )
        })
        .filter(|(distance, candidate)| 3 * distance <= name.len().max(candidate.len()))
        .collect();
    scored.sort();
    scored.dedup();
    scored.truncate(MOST_SUGGESTIONS);
    scored.into_iter().map(|(_, name)| name.into()).collect()
}

/// `toWorld` as Mitsuba 2 and 3 write it: `to_world`.
pub(crate) fn snake_case(name: &str) -> String {
    let mut snake = String::with_capacity(name.len() + 4);
    let mut after_lower = false;
    for c in name.chars() {
        if c.is_uppercase() && after_lower {
            snake.push('_');
        }
        after_lower = c.is_lowercase() || c.is_ascii_digit();
        snake.extend(c.to_lowercase());
    }
    snake
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn typing_errors_are_found_and_other_words_are_not() {
        let known = ["radius", "center", "to_world", "flip_normals"];
        assert_eq!(nearest("raduis", known), ["radius"]);
        assert_eq!(nearest("Centre", known), ["center"]);
        assert!(nearest("frobnicate", known).is_empty());
    }

    #[test]
    fn camel_case_becomes_snake_case() {
        assert_eq!(snake_case("toWorld"), "to_world");
        assert_eq!(snake_case("cropOffsetX"), "crop_offset_x");
        assert_eq!(snake_case("fov"), "fov");
    }
}
