//! Files that need each other.

use super::imports::Imports;

/// The largest sets of files each of which needs every other, directly or
/// through others; files in order. Empty where there is no circle.
pub fn circles(imports: &Imports) -> Vec<Vec<usize>> {
    let reached: Vec<Vec<bool>> = (0..imports.len())
        .map(|file| reach(imports, file))
        .collect();
    let mut seen = vec![false; imports.len()];
    let mut circles = Vec::new();
    for file in 0..imports.len() {
        let mutual = |&other: &usize| reached[file][other] && reached[other][file];
        let circle: Vec<usize> = (0..imports.len()).filter(mutual).collect();
        if !seen[file] && !circle.is_empty() {
            circle.iter().for_each(|&file| seen[file] = true);
            circles.push(circle);
        }
    }
    circles
}

/// Which files one needs, directly or through others. Itself only on a circle.
fn reach(imports: &Imports, file: usize) -> Vec<bool> {
    let mut reached = vec![false; imports.len()];
    let mut open = vec![file];
    while let Some(file) = open.pop() {
        for &next in imports[file].keys() {
            if !std::mem::replace(&mut reached[next], true) {
                open.push(next);
            }
        }
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::super::imports::imports;
    use super::super::source::tests::krate;
    use super::*;

    #[test]
    fn a_circle_through_three_files_is_found() {
        let lib = ("lib.rs", "mod a; mod b; mod c; mod d; pub use a::A;");
        let a = ("a.rs", "use crate::b::B; pub struct A;");
        let b = ("b.rs", "pub struct B; fn f() { crate::c::c() }");
        let d = ("d.rs", "use crate::{A, b::B};");
        let circular = krate(&[lib, a, b, ("c.rs", "use super::A; pub fn c() {}"), d]);
        let found = circles(&imports(&circular));
        let names = found[0]
            .iter()
            .map(|&file| circular.files[file].file_name().unwrap());
        assert_eq!(names.collect::<Vec<_>>(), ["a.rs", "b.rs", "c.rs"]);
        assert_eq!(found.len(), 1);
        let straight = krate(&[lib, a, b, ("c.rs", "pub fn c() {}"), d]);
        assert!(circles(&imports(&straight)).is_empty());
    }

    /// Two circles, and a parent with something that its child needs.
    #[test]
    fn circles_are_kept_apart() {
        let two = krate(&[
            ("lib.rs", "mod a; mod b;"),
            ("a.rs", "mod x; use x::X; pub struct A;"),
            ("a/x.rs", "use super::A; use crate::b::B; pub struct X;"),
            ("b.rs", "mod y; pub struct B; fn f() { y::Y }"),
            ("b/y.rs", "use super::B; pub struct Y;"),
        ]);
        assert_eq!(circles(&imports(&two)), [[1, 2], [3, 4]]);
    }
}
