//! The names that were perhaps meant.

/// How many names a message suggests at most.
const SUGGESTIONS: usize = 4;

/// The names most like `wanted`. If `wanted` starts with the name of something
/// that has parameters, only those: others would be of another object.
pub(super) fn near<'a>(wanted: &str, names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let names: Vec<&str> = names.collect();
    let mut owner_is_known = false;
    // From the innermost part to the object.
    for (dot, _) in wanted.rmatch_indices('.') {
        let owner = &wanted[..=dot];
        let own: Vec<&str> = names
            .iter()
            .copied()
            .filter(|name| name.starts_with(owner))
            .collect();
        owner_is_known |= !own.is_empty();
        let found = likest(wanted, &own);
        if !found.is_empty() {
            return found;
        }
    }
    match owner_is_known {
        true => Vec::new(),
        false => likest(wanted, &names),
    }
}

/// The names within a third of the length of `wanted` in edits, or with only
/// some parts between dots left out or shortened, each counted as one edit.
fn likest(wanted: &str, names: &[&str]) -> Vec<String> {
    let length = wanted.chars().count();
    let farthest = length.div_ceil(3);
    let mut scored: Vec<(usize, &str)> = names
        .iter()
        .filter_map(|&name| {
            let at_least = name.chars().count().abs_diff(length);
            let edits = (at_least <= farthest).then(|| edit_distance(wanted, name));
            let edits = edits.filter(|&edits| edits <= farthest);
            let distance = edits.into_iter().chain(missing_parts(wanted, name)).min()?;
            Some((distance, name))
        })
        .collect();
    scored.sort_by_key(|&(distance, _)| distance); // stable
    // A suggestion much worse than the best one only distracts.
    let best = scored.first().map_or(0, |&(distance, _)| distance);
    let close = scored.iter().filter(|&&(distance, _)| distance <= best + 1);
    close
        .map(|&(_, name)| name.to_owned())
        .take(SUGGESTIONS)
        .collect()
}

/// How many parts of `name` are left out in `wanted`, or stand there with more
/// or fewer words (`vertex_positions` for `positions`); `None` if `wanted` has
/// others or another order.
fn missing_parts(wanted: &str, name: &str) -> Option<usize> {
    let with_more_words = |long: &str, short: &str| {
        let before = long.strip_suffix(short);
        before.is_some_and(|before| before.ends_with('_'))
    };
    let alike = |a: &str, b: &str| a == b || with_more_words(a, b) || with_more_words(b, a);
    let mut parts = name.split('.');
    let mut changed = 0;
    for part in wanted.split('.') {
        let found = parts.find(|other| alike(part, other))?;
        changed += usize::from(found != part);
    }
    let count = |text: &str| text.split('.').count();
    Some(count(name) - count(wanted) + changed)
}

/// Insertions, deletions, replacements and swaps of neighbours that turn one
/// text into the other (optimal string alignment).
fn edit_distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut before_last: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replaced = last[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replaced.min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(before_last[j - 2] + 1);
            }
            row.push(best);
        }
        before_last = std::mem::replace(&mut last, row);
    }
    last[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_are_counted() {
        for (a, b, distance) in [
            ("", "abc", 3),
            ("ball", "ball", 0),
            ("ball", "blal", 1),
            ("kitten", "sitting", 3),
            ("rotate", "translate", 5),
        ] {
            assert_eq!(edit_distance(a, b), distance, "{a} {b}");
            assert_eq!(edit_distance(b, a), distance, "{b} {a}");
        }
    }
}
