//! Which file of a crate needs which other one: names are followed through
//! re-exports to the file that defines them.

use std::collections::{BTreeMap, BTreeSet};

use super::source::{Crate, Sharing};

/// For each file, the files of the same crate that it needs, and which of their
/// names.
pub type Imports = Vec<BTreeMap<usize, BTreeSet<String>>>;

/// What a path means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meaning<'a> {
    Module(usize),
    /// Something that the module defines, and its name there.
    Item(usize, &'a str),
}

/// Re-exports of re-exports are followed this far: longer chains are circles of
/// `use` declarations.
const LONGEST_CHAIN: usize = 16;

/// Who imports what. A declaration (`mod x;`) is no import, nor is a re-export
/// of what the file itself does not mention, nor the import of a module: those
/// count of whose items something is used.
pub fn imports(krate: &Crate) -> Imports {
    let mut imports = vec![BTreeMap::new(); krate.files.len()];
    for (at, module) in krate.modules.iter().enumerate() {
        let names = module
            .imports
            .iter()
            .filter(|import| import.sharing == Sharing::Nobody);
        let named = names.filter(|import| import.name.is_some());
        let paths = named.map(|import| &import.path);
        for path in paths.chain(&module.mentions) {
            if let Some(Meaning::Item(definer, name)) = krate.meaning(at, path) {
                let file = krate.modules[definer].file;
                if file != module.file {
                    let needed: &mut BTreeMap<_, BTreeSet<_>> = &mut imports[module.file];
                    needed.entry(file).or_default().insert(name.to_owned());
                }
            }
        }
    }
    imports
}

impl Crate {
    /// What a path means in a module; nothing for other crates' and for local names.
    pub fn meaning(&self, at: usize, path: &[String]) -> Option<Meaning<'_>> {
        self.follow(at, path, 0)
    }

    /// The meaning of a path behind a chain of so many re-exports.
    fn follow(&self, at: usize, path: &[String], chain: usize) -> Option<Meaning<'_>> {
        let mut module = match path.first()?.as_str() {
            "crate" => 0,
            "self" => at,
            "super" => self.modules[at].parent,
            _ => return self.below(at, path, chain),
        };
        let mut rest = &path[1..];
        while rest.first().is_some_and(|word| word == "super") {
            module = self.modules[module].parent;
            rest = &rest[1..];
        }
        self.below(module, rest, chain)
    }

    /// Follows a path down from a module, as if all imports were public: the
    /// compiler has looked after that.
    fn below(&self, at: usize, path: &[String], chain: usize) -> Option<Meaning<'_>> {
        let module = &self.modules[at];
        let Some((word, rest)) = path.split_first() else {
            return Some(Meaning::Module(at));
        };
        // A module and a function may share a name, but a function ends the path.
        let child = module.children.get(word);
        if let Some(&child) = child.filter(|_| !rest.is_empty()) {
            return self.below(child, rest, chain);
        }
        if let Some(item) = module.items.iter().find(|item| *item == word) {
            return Some(Meaning::Item(at, item));
        }
        if chain == LONGEST_CHAIN {
            return None;
        }
        let mut named = module.imports.iter();
        if let Some(import) = named.find(|import| import.name.as_ref() == Some(word)) {
            // `use log::log` means a crate, not the name that it brings in.
            if import.path.first() == Some(word) && child.is_none() {
                return None;
            }
            return match self.follow(at, &import.path, chain + 1) {
                Some(Meaning::Module(module)) => self.below(module, rest, chain + 1),
                meaning => meaning,
            };
        }
        if let Some(&child) = child {
            return Some(Meaning::Module(child));
        }
        let globs = module.imports.iter().filter(|import| import.name.is_none());
        globs
            .filter_map(|import| self.follow(at, &import.path, chain + 1))
            .find_map(|meaning| match meaning {
                Meaning::Module(inside) => self.below(inside, path, chain + 1),
                Meaning::Item(..) => None,
            })
    }
}

#[cfg(test)]
mod tests {
    use super::super::source::tests::krate;
    use super::*;

    /// `a.rs needs X from b.rs` for all imports, sorted.
    fn shown(files: &[(&str, &str)]) -> Vec<String> {
        let krate = krate(files);
        let name = |file: usize| krate.files[file].file_name().unwrap().to_string_lossy();
        let mut shown = Vec::new();
        for (file, needed) in imports(&krate).iter().enumerate() {
            for (&other, names) in needed {
                let names = names.iter().cloned().collect::<Vec<_>>().join(" ");
                shown.push(format!("{} needs {names} from {}", name(file), name(other)));
            }
        }
        shown.sort();
        shown
    }

    #[test]
    fn imports_lead_to_the_file_that_defines_the_name() {
        let found = shown(&[
            ("lib.rs", "mod a; pub mod b; pub use b::deep::Deep;"),
            (
                "a.rs",
                "use crate::{Deep, b::{self, Shallow as S}}; fn f() { b::deep::g(b::C) }",
            ),
            (
                "b.rs",
                "pub mod deep; pub struct Shallow; pub const C: u8 = 0;",
            ),
            ("b/deep.rs", "pub struct Deep; pub fn g() {}"),
        ]);
        assert_eq!(
            found,
            [
                "a.rs needs C Shallow from b.rs",
                "a.rs needs Deep g from deep.rs"
            ]
        );
    }

    /// Declaring and re-exporting is not importing, unless the name is used too.
    #[test]
    fn a_parent_that_only_re_exports_needs_nothing() {
        let child = ("b.rs", "pub struct X; pub struct Y; pub fn y() {}");
        let found = shown(&[("lib.rs", "mod b; pub use b::{X, Y};"), child]);
        assert!(found.is_empty(), "{found:?}");
        let parent = (
            "lib.rs",
            "mod b; pub use b::{X, y}; fn f(x: X) { x.y(); <X as T>::y(); }",
        );
        assert_eq!(shown(&[parent, child]), ["lib.rs needs X from b.rs"]);
    }

    #[test]
    fn paths_in_code_count_as_imports() {
        let b = (
            "b.rs",
            "pub struct X; pub mod c { pub fn f() {} pub fn g() {} }",
        );
        for code in [
            "fn f() -> crate::b::X { loop {} }",
            "fn f() { use super::b::{X}; }",
            "fn f() { print!(\"{:?}\", vec![crate::b::X]); }",
            "use super::b::*; fn f(x: &[X]) {}",
            "mod inner { use super::super::b; type Y = Vec<b::X>; }",
            "fn f() -> S { S { ..crate::b::X::default() } }",
        ] {
            let found = shown(&[("lib.rs", "mod a; mod b;"), ("a.rs", code), b]);
            assert_eq!(found, ["a.rs needs X from b.rs"], "{code}");
        }
    }

    #[test]
    fn other_crates_tests_and_documentation_do_not_count() {
        let a = "//! [`X`](crate::b::X)\nuse log::log; use b2::X; #[cfg(test)] use crate::b::X;\n\
                 /// [`X`](crate::b::X)\nfn f() { log::log(X) } #[cfg(test)] mod t { use crate::b::X; }";
        let found = shown(&[
            ("lib.rs", "mod a; mod b;"),
            ("a.rs", a),
            ("b.rs", "pub struct X;"),
        ]);
        assert!(found.is_empty(), "{found:?}");
    }

    /// Re-exports in a circle end.
    #[test]
    fn circular_re_exports_end() {
        let found = shown(&[
            ("lib.rs", "mod a; mod b; fn f(x: a::X) {}"),
            ("a.rs", "pub use crate::b::*;"),
            ("b.rs", "pub use crate::a::*;"),
        ]);
        assert!(found.is_empty(), "{found:?}");
    }
}
