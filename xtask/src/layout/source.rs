//! The modules of a crate as its files say: what each declares, imports and
//! mentions. Tests are left out.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Attribute, Ident, Item, Meta, UseTree, Visibility};

/// The modules and files of one crate. The first module is its root.
#[derive(Default)]
pub struct Crate {
    pub modules: Vec<Module>,
    /// Source files, in the order of their declaration.
    pub files: Vec<PathBuf>,
}

/// A module, in a file of its own or in braces.
#[derive(Default)]
pub struct Module {
    /// Which of the crate's files holds it.
    pub file: usize,
    /// Which of the crate's modules declares it; the root declares itself.
    pub parent: usize,
    /// Who may name it.
    pub sharing: Sharing,
    /// Modules declared here, by name.
    pub children: BTreeMap<String, usize>,
    /// Names of the items defined here, modules apart.
    pub items: Vec<String>,
    /// Types and traits among them that others than this module may see.
    pub types: Vec<(String, Sharing)>,
    /// What the `use` declarations bring in.
    pub imports: Vec<Import>,
    /// Every path that the items' code mentions, `a::b` as `[a, b]`; also single
    /// words.
    pub mentions: Vec<Vec<String>>,
}

/// One leaf of a `use` declaration.
pub struct Import {
    /// The path as written.
    pub path: Vec<String>,
    /// The name that it has here; absent for `*`.
    pub name: Option<String>,
    /// Who may use that name.
    pub sharing: Sharing,
}

/// Who may use a name besides its own module.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Sharing {
    #[default]
    Nobody,
    /// Others in the crate: `pub(crate)`, `pub(super)`.
    Crate,
    /// Code that may name the module: `pub`.
    All,
}

impl From<&Visibility> for Sharing {
    fn from(visibility: &Visibility) -> Self {
        match visibility {
            Visibility::Inherited => Self::Nobody,
            Visibility::Restricted(_) => Self::Crate,
            Visibility::Public(_) => Self::All,
        }
    }
}

impl Crate {
    /// Reads the crate that starts in this file.
    pub fn read(root: &Path) -> Result<Self> {
        let mut read = Self::default();
        read.file(root, 0)?;
        read.modules[0].sharing = Sharing::All;
        Ok(read)
    }

    /// Adds the module that is a whole file; returns which it is.
    fn file(&mut self, file: &Path, parent: usize) -> Result<usize> {
        let text =
            fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))?;
        let parsed =
            syn::parse_file(&text).with_context(|| format!("cannot parse {}", file.display()))?;
        self.files.push(file.to_owned());
        // Modules declared in `a/b.rs` lie in `a/b/`, those of `a/mod.rs` in `a/`.
        let stem = file.file_stem().unwrap_or_default();
        let folder = match stem.to_string_lossy().as_ref() {
            "lib" | "main" | "mod" => file.with_file_name(""),
            _ => file.with_extension(""),
        };
        self.module(parsed.items, self.files.len() - 1, parent, &folder)
    }

    /// Adds a module with these items, whose own modules lie in the folder.
    fn module(
        &mut self,
        items: Vec<Item>,
        file: usize,
        parent: usize,
        folder: &Path,
    ) -> Result<usize> {
        let this = self.modules.len();
        self.modules.push(Module {
            file,
            parent,
            ..Module::default()
        });
        for item in items {
            if is_test(attributes(&item)) {
                continue;
            }
            if let Item::Mod(item) = item {
                let name = item.ident.to_string();
                let sharing = Sharing::from(&item.vis);
                let child = match item.content {
                    Some((_, items)) => self.module(items, file, this, &folder.join(&name))?,
                    None => self.file(&module_file(folder, &name)?, this)?,
                };
                self.modules[child].sharing = sharing;
                self.modules[this].children.insert(name, child);
            } else {
                self.modules[this].add(item);
            }
        }
        Ok(this)
    }
}

impl Module {
    /// Notes what an item, no module, defines or imports, and what it mentions.
    fn add(&mut self, item: Item) {
        if let Item::Use(item) = item {
            let sharing = Sharing::from(&item.vis);
            return leaves(&item.tree, &mut Vec::new(), &mut |path, name| {
                self.imports.push(Import {
                    path,
                    name,
                    sharing,
                });
            });
        }
        if let Some((name, sharing)) = defined_type(&item) {
            self.items.push(name.to_string());
            if sharing != Sharing::Nobody {
                self.types.push((name.to_string(), sharing));
            }
        }
        let other = match &item {
            Item::Fn(item) => Some(&item.sig.ident),
            Item::Const(item) => Some(&item.ident),
            Item::Static(item) => Some(&item.ident),
            Item::Macro(item) => item.ident.as_ref(),
            _ => None,
        };
        self.items.extend(other.map(|name| name.to_string()));
        mentions(item.to_token_stream(), &[], &mut self.mentions);
    }
}

/// The file of the module with this name, declared by one whose modules lie in
/// the folder.
fn module_file(folder: &Path, name: &str) -> Result<PathBuf> {
    let places = [
        folder.join(format!("{name}.rs")),
        folder.join(name).join("mod.rs"),
    ];
    match places.iter().find(|place| place.exists()) {
        Some(place) => Ok(place.clone()),
        None => bail!("there is no {} for `mod {name};`", places[0].display()),
    }
}

/// True if an item is compiled for tests only.
fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        Meta::List(list) => {
            let condition = list.tokens.to_string();
            list.path.is_ident("cfg") && (condition == "test" || condition.starts_with("all (test"))
        }
        _ => false,
    })
}

/// The name of a type or trait that the item defines, and its visibility.
fn defined_type(item: &Item) -> Option<(&Ident, Sharing)> {
    let (name, visibility) = match item {
        Item::Struct(item) => (&item.ident, &item.vis),
        Item::Enum(item) => (&item.ident, &item.vis),
        Item::Union(item) => (&item.ident, &item.vis),
        Item::Trait(item) => (&item.ident, &item.vis),
        Item::Type(item) => (&item.ident, &item.vis),
        _ => return None,
    };
    Some((name, visibility.into()))
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Union(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// Calls for every leaf of a `use` tree: its path, and its name unless it is `*`.
fn leaves(
    tree: &UseTree,
    prefix: &mut Vec<String>,
    found: &mut impl FnMut(Vec<String>, Option<String>),
) {
    let mut leaf = |last: &str, name: Option<String>| {
        let mut path = prefix.clone();
        // `use a::{self}` is `use a`.
        if last != "self" || path.is_empty() {
            path.push(last.to_owned());
        }
        let name = name.map(|name| match name.as_str() {
            "self" => path[path.len() - 1].clone(),
            _ => name,
        });
        found(path, name);
    };
    match tree {
        UseTree::Path(tree) => {
            prefix.push(tree.ident.to_string());
            leaves(&tree.tree, prefix, found);
            prefix.pop();
        }
        UseTree::Name(tree) => {
            let name = tree.ident.to_string();
            leaf(&name, Some(name.clone()));
        }
        UseTree::Rename(tree) => leaf(&tree.ident.to_string(), Some(tree.rename.to_string())),
        UseTree::Glob(_) => found(prefix.clone(), None),
        UseTree::Group(tree) => {
            for tree in &tree.items {
                leaves(tree, prefix, found);
            }
        }
    }
}

/// Collects the paths in code, macros' arguments included. A word behind a dot
/// is a field or a method, one behind `>::` or `]::` belongs to a type. A group
/// behind `a::` is a `use` inside a function.
fn mentions(code: TokenStream, prefix: &[String], found: &mut Vec<Vec<String>>) {
    let mut path: Vec<String> = prefix.to_vec();
    let (mut colons, mut dots) = (0, 0);
    let mut end = |path: &mut Vec<String>| {
        if path.len() > prefix.len() {
            found.push(path.clone());
        }
        path.truncate(prefix.len());
    };
    let mut groups = Vec::new();
    for token in code {
        let sign = match &token {
            TokenTree::Punct(sign) => Some(sign.as_char()),
            _ => None,
        };
        if sign == Some(':') {
            (colons, dots) = (colons + 1, 0);
            continue;
        }
        match token {
            TokenTree::Ident(word) => {
                let belongs = dots == 1 || (colons == 2 && path.len() == prefix.len());
                if colons != 2 {
                    end(&mut path);
                }
                if !belongs {
                    path.push(word.to_string());
                }
            }
            TokenTree::Group(group) => {
                let is_tree = colons == 2 && group.delimiter() == Delimiter::Brace;
                let inner = if is_tree { path.clone() } else { Vec::new() };
                end(&mut path);
                groups.push((group.stream(), inner));
            }
            _ => end(&mut path),
        }
        colons = 0;
        dots = if sign == Some('.') { dots + 1 } else { 0 };
    }
    end(&mut path);
    for (code, prefix) in groups {
        mentions(code, &prefix, found);
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// A crate of these files, the first of which is its root, with their texts.
    pub fn krate(files: &[(&str, &str)]) -> Crate {
        use std::sync::atomic::{AtomicU32, Ordering};
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let folder = format!("capwalk-layout-{}-{number}", std::process::id());
        let folder = std::env::temp_dir().join(folder);
        for (name, text) in files {
            let file = folder.join(name);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, text).unwrap();
        }
        let krate = Crate::read(&folder.join(files[0].0));
        fs::remove_dir_all(folder).unwrap();
        krate.unwrap()
    }

    #[test]
    fn a_missing_file_is_named() {
        let error = Crate::read(Path::new("/no/such/lib.rs")).err().unwrap();
        assert!(
            format!("{error:#}").contains("/no/such/lib.rs"),
            "{error:#}"
        );
    }
}
