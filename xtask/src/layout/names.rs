//! Names that mean two things.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use super::imports::Meaning;
use super::source::{Crate, Sharing};

/// A name, and the files that define it or bear it.
pub type Places = BTreeMap<String, BTreeSet<PathBuf>>;

/// File names that every folder may have.
const COMMON_FILES: [&str; 3] = ["mod.rs", "tests.rs", "error.rs"];

/// Types and traits that two modules of the crate share with others under one name.
pub fn types(krate: &Crate) -> Places {
    let mut places = Places::new();
    for module in &krate.modules {
        for (name, _) in &module.types {
            let files = places.entry(name.clone()).or_default();
            files.insert(krate.files[module.file].clone());
        }
    }
    repeated(places)
}

/// Types and traits of one name that two of the crates offer to other crates.
pub fn exported_types<'a>(crates: impl Iterator<Item = &'a Crate>) -> Places {
    let mut places = Places::new();
    for krate in crates {
        for (module, name) in exports(krate) {
            let files = places.entry(name).or_default();
            files.insert(krate.files[krate.modules[module].file].clone());
        }
    }
    repeated(places)
}

/// Source files of one name in a crate.
pub fn files(krate: &Crate) -> Places {
    let mut places = Places::new();
    for file in &krate.files {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        if !COMMON_FILES.contains(&name.as_ref()) {
            let files = places.entry(name.into_owned()).or_default();
            files.insert(file.clone());
        }
    }
    repeated(places)
}

fn repeated(mut places: Places) -> Places {
    places.retain(|_, files| files.len() > 1);
    places
}

/// The types and traits that other crates can name: the modules that define
/// them, and their names there.
fn exports(krate: &Crate) -> BTreeSet<(usize, String)> {
    let mut exported = BTreeSet::new();
    let mut open = vec![0];
    let mut seen = BTreeSet::new();
    while let Some(at) = open.pop() {
        if !seen.insert(at) {
            continue;
        }
        let module = &krate.modules[at];
        let public = module.types.iter().filter(|(_, to)| *to == Sharing::All);
        exported.extend(public.map(|(name, _)| (at, name.clone())));
        let children = module.children.values().copied();
        open.extend(children.filter(|&child| krate.modules[child].sharing == Sharing::All));
        for import in &module.imports {
            if import.sharing != Sharing::All {
                continue;
            }
            match krate.meaning(at, &import.path) {
                Some(Meaning::Module(inside)) => open.push(inside),
                Some(Meaning::Item(definer, name)) => {
                    let mut types = krate.modules[definer].types.iter();
                    if types.any(|(other, _)| other == name) {
                        exported.insert((definer, name.to_owned()));
                    }
                }
                None => {}
            }
        }
    }
    exported
}

#[cfg(test)]
mod tests {
    use super::super::source::tests::krate;
    use super::*;

    fn names(places: Places) -> Vec<String> {
        places.into_keys().collect()
    }

    #[test]
    fn a_type_defined_twice_in_a_crate_is_found() {
        let twice = krate(&[
            ("lib.rs", "mod a; mod b;"),
            (
                "a.rs",
                "pub(crate) struct Twin; struct Own; pub fn twin() {}",
            ),
            ("b.rs", "pub enum Twin {} pub struct Own; pub fn twin() {}"),
        ]);
        assert_eq!(names(types(&twice)), ["Twin"]);
    }

    /// What a crate keeps to itself may have a name that another has too.
    #[test]
    fn a_type_that_two_crates_export_is_found() {
        let one = krate(&[
            (
                "lib.rs",
                "mod a; pub mod b; pub use a::{Plane, Source as From};",
            ),
            (
                "a.rs",
                "pub struct Plane; pub struct Source; pub struct Hidden;",
            ),
            ("b.rs", "pub struct Curve; pub(crate) struct Kept;"),
        ]);
        let other = krate(&[
            (
                "lib.rs",
                "mod a; pub use a::*; pub trait Curve {} pub struct Kept;",
            ),
            (
                "a.rs",
                "pub type Plane = f64; pub struct Source; pub struct Hidden;",
            ),
        ]);
        let found = exported_types([&one, &other].into_iter());
        assert_eq!(names(found), ["Curve", "Plane", "Source"]);
    }

    #[test]
    fn files_of_one_name_are_found() {
        let twice = krate(&[
            ("lib.rs", "mod a; mod b; mod c;"),
            ("a.rs", "mod c;"),
            ("a/c.rs", ""),
            ("b/mod.rs", ""),
            ("c/mod.rs", ""),
        ]);
        assert!(files(&twice).is_empty());
        let twice = krate(&[
            ("lib.rs", "mod a; mod c;"),
            ("a.rs", "mod c;"),
            ("a/c.rs", ""),
            ("c.rs", ""),
        ]);
        assert_eq!(names(files(&twice)), ["c.rs"]);
    }
}
