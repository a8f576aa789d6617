//! Elements to elements: parameters and included files are put in, so that
//! `<default>`, `$name`, `<include>` and `<path>` are gone.
//!
//! As in Mitsuba, everything happens in the order of the text: a parameter is
//! known from its `<default>` on, and a definition from outside wins over it.

use std::collections::BTreeMap;
use std::ops::Bound;
use std::path::PathBuf;

use crate::files::{LARGEST_TEXT, find_file, read_text};
use crate::problem::Problem;
use crate::suggest::nearest;
use crate::texts::{FileId, Span, Texts};
use crate::upgrade::{Upgraded, upgrade};
use crate::xml::{self, Attribute, Element};

/// Files that include files, at most (Mitsuba's limit).
const DEEPEST_INCLUDE: usize = 15;

/// Files of one scene, at most: a bound on memory when files include others
/// several times at every level.
const MOST_FILES: usize = 1024;

/// The longest value of an attribute with parameters in it, bytes: numbers of a long
/// spectrum have a few thousand. A bound on memory when parameters stand for others.
const LONGEST_VALUE: usize = 1 << 20;

/// Bytes that parameters put into a scene, at most.
const MOST_SUBSTITUTED: usize = 1 << 26;

/// Parameters of a file that a message names, at most.
const MOST_NAMES: usize = 50;

/// A scene file without includes and parameters.
#[derive(Debug)]
pub(crate) struct Expanded {
    pub root: Element,
    /// Directories of `<path>`, the latest first.
    pub search_directories: Vec<PathBuf>,
    /// Texts outside of elements, which mean nothing.
    pub stray: Vec<Span>,
    /// Files of old versions that were brought to the names of today.
    pub upgraded: Vec<Upgraded>,
}

/// What `$name` stands for.
struct Parameter {
    value: String,
    used: bool,
    /// True for a definition from outside, which must be used.
    defined: bool,
}

struct Expander<'a> {
    texts: &'a mut Texts,
    /// By name.
    parameters: BTreeMap<String, Parameter>,
    /// Bytes that parameters have put in so far.
    substituted: usize,
    search_directories: Vec<PathBuf>,
    stray: Vec<Span>,
    upgraded: Vec<Upgraded>,
    /// Files that are being included, outermost first.
    open_files: Vec<PathBuf>,
}

/// Carries out everything that is not a description of the scene.
pub(crate) fn expand(
    texts: &mut Texts,
    main: FileId,
    defines: &[(String, String)],
) -> Result<Expanded, Problem> {
    check_definitions(main, defines)?;
    let parameters = defines.iter().map(|(name, value)| {
        let parameter = Parameter {
            value: value.clone(),
            used: false,
            defined: true,
        };
        (name.clone(), parameter)
    });
    let parameters = parameters.collect();
    let mut expander = Expander {
        texts,
        parameters,
        substituted: 0,
        search_directories: Vec::new(),
        stray: Vec::new(),
        upgraded: Vec::new(),
        open_files: Vec::new(),
    };
    if let Some(path) = &expander.texts.get(main).path
        && let Ok(path) = path.canonicalize()
    {
        expander.open_files.push(path);
    }
    let root = expander.file(main)?;
    let unused = defines
        .iter()
        .find(|(name, _)| !expander.parameters[name].used);
    if let Some((name, value)) = unused {
        return Err(expander.unused_definition(main, name, value));
    }
    Ok(Expanded {
        root,
        search_directories: expander.search_directories,
        stray: expander.stray,
        upgraded: expander.upgraded,
    })
}

/// Refuses definitions without a name and contradictory ones.
fn check_definitions(main: FileId, defines: &[(String, String)]) -> Result<(), Problem> {
    let mut values = BTreeMap::new();
    for (name, value) in defines {
        if name.is_empty() || !name.chars().all(|c| c.is_alphanumeric() || c == '_') {
            let message =
                format!("\"{name}\", defined as \"{value}\", cannot be the name of a parameter");
            return Err(Problem::definition_for(main, message)
                .help("expected letters, digits and underscores"));
        }
        if let Some(other) = values.insert(name, value) {
            let message =
                format!("the parameter {name} is defined twice, as \"{other}\" and as \"{value}\"");
            return Err(Problem::definition_for(main, message).help("define it once"));
        }
    }
    Ok(())
}

impl Expander<'_> {
    fn unused_definition(&self, main: FileId, unused: &str, value: &str) -> Problem {
        let others = self.parameters.iter().filter(|(_, p)| !p.defined || p.used);
        let names: Vec<&str> = others.map(|(name, _)| name.as_str()).collect();
        let help = match names.len() {
            0 => "the file has no parameters".to_owned(),
            1..=MOST_NAMES => format!("the file's parameters are {}", names.join(", ")),
            n => format!("the file has {n} other parameters"),
        };
        let message =
            format!("nothing in the scene uses ${unused}, which is defined as \"{value}\"");
        Problem::definition_for(main, message)
            .help(help)
            .near(nearest(unused, names))
    }

    /// The root of one file, resolved.
    fn file(&mut self, file: FileId) -> Result<Element, Problem> {
        let (mut root, stray) = xml::parse(self.texts, file)?;
        self.stray.extend(stray);
        if let Some(old) = check_version(&root)? {
            let upgraded = upgrade(&mut root, &old);
            self.upgraded.push(upgraded);
        }
        self.substitute(&mut root)?;
        root.attributes.retain(|a| a.name != "version");
        root.children = self.children(root.children, true)?;
        Ok(root)
    }

    fn children(&mut self, children: Vec<Element>, of_root: bool) -> Result<Vec<Element>, Problem> {
        let mut resolved = Vec::with_capacity(children.len());
        for mut child in children {
            self.substitute(&mut child)?;
            match child.tag.as_str() {
                "default" => self.default(&child)?,
                "include" => resolved.extend(self.include(&child)?),
                "path" => self.path(&child, of_root)?,
                _ => {
                    child.children = self.children(child.children, false)?;
                    resolved.push(child);
                }
            }
        }
        Ok(resolved)
    }

    /// `<default name="spp" value="16"/>`
    fn default(&mut self, element: &Element) -> Result<(), Problem> {
        element.only_attributes(&["name", "value"])?;
        no_children(element)?;
        let name = element.required("name")?;
        let value = element.required("value")?;
        if name.value.is_empty() {
            return Err(
                Problem::missing(name.value_span, "the parameter has no name")
                    .help("write <default name=\"spp\" value=\"16\"/> and use it as $spp"),
            );
        }
        let parameter = || Parameter {
            value: value.value.clone(),
            used: false,
            defined: false,
        };
        self.parameters
            .entry(name.value.clone())
            .or_insert_with(parameter);
        Ok(())
    }

    /// `<path value="meshes"/>`
    fn path(&mut self, element: &Element, of_root: bool) -> Result<(), Problem> {
        element.only_attributes(&["value"])?;
        no_children(element)?;
        if !of_root {
            return Err(
                Problem::invalid(element.span, "<path> stands inside an object")
                    .help("move it directly into <scene>"),
            );
        }
        let value = element.required("value")?;
        let places = self.directories(element.span.file);
        let mut paths = places.iter().map(|place| place.join(&value.value));
        let Some(path) = paths.find(|path| path.is_dir()) else {
            let path = places[0].join(&value.value);
            return Err(Problem::unreadable(
                value.value_span,
                format!("there is no folder \"{}\"", path.display()),
            )
            .help("give a folder, relative to this file or one that includes it"));
        };
        self.search_directories.insert(0, path);
        Ok(())
    }

    /// Where the names of folders and included files in a file are looked for, as in Mitsuba:
    /// beside it, in the folders of `<path>`, and beside the files that include it.
    fn directories(&self, file: FileId) -> Vec<PathBuf> {
        let mut text = self.texts.get(file);
        let mut directories = vec![text.directory.clone()];
        directories.extend(self.search_directories.iter().cloned());
        while let Some(place) = text.included_at {
            text = self.texts.get(place.file);
            directories.push(text.directory.clone());
        }
        directories
    }

    /// `<include filename="materials.xml"/>`: the children of its scene, or its
    /// one object.
    fn include(&mut self, element: &Element) -> Result<Vec<Element>, Problem> {
        element.only_attributes(&["filename", "name"])?;
        no_children(element)?;
        let filename = element.required("filename")?;
        let span = filename.value_span;
        let directories = self.directories(element.span.file);
        let path = find_file(&filename.value, &directories).map_err(|error| {
            Problem::unreadable(span, error).help("give a scene file to include")
        })?;
        let canonical = path.canonicalize().unwrap_or_else(|_| path.clone());
        if self.open_files.contains(&canonical) {
            return Err(
                Problem::invalid(span, format!("\"{}\" includes itself", path.display()))
                    .help("remove this <include>"),
            );
        }
        if self.open_files.len() > DEEPEST_INCLUDE || self.texts.count() >= MOST_FILES {
            return Err(
                Problem::unsupported(span, "too many files are included").help(format!(
                    "at most {DEEPEST_INCLUDE} within each other and {MOST_FILES} in all are read"
                )),
            );
        }
        let mut text = read_text(&path).map_err(|error| {
            Problem::unreadable(span, error).help("give a scene file to include")
        })?;
        if self.texts.bytes() + text.content.len() > LARGEST_TEXT as usize {
            let most = LARGEST_TEXT >> 20;
            return Err(Problem::unsupported(span, "too much text is included")
                .help(format!("at most {most} MiB in all are read")));
        }
        text.included_at = Some(span);
        let file = self.texts.add(text);
        self.open_files.push(canonical);
        let mut root = self.file(file)?;
        self.open_files.pop();
        if root.tag == "scene" {
            return Ok(root.children);
        }
        if let Some(name) = element.attribute("name") {
            root.attributes.retain(|a| a.name != "name");
            root.attributes.push(name.clone());
        }
        Ok(vec![root])
    }

    /// Replaces `$name` in all attributes by the parameter with the longest name
    /// that fits, and `\$` by a dollar sign.
    fn substitute(&mut self, element: &mut Element) -> Result<(), Problem> {
        for attribute in &mut element.attributes {
            if attribute.value.contains('$') {
                attribute.value = self.substituted(attribute)?;
            }
        }
        Ok(())
    }

    fn substituted(&mut self, attribute: &Attribute) -> Result<String, Problem> {
        let span = attribute.value_span;
        let mut result = String::new();
        let mut rest = attribute.value.as_str();
        while let Some(dollar) = rest.find('$') {
            if let Some(before) = rest[..dollar].strip_suffix('\\') {
                result.push_str(before);
                result.push('$');
                rest = &rest[dollar + 1..];
                continue;
            }
            result.push_str(&rest[..dollar]);
            rest = &rest[dollar + 1..];
            let Some(length) = self.longest_name(rest) else {
                let length = rest
                    .find(|c: char| !c.is_alphanumeric() && c != '_')
                    .unwrap_or(rest.len());
                return Err(self.undefined(&rest[..length], span));
            };
            let (name, behind) = rest.split_at(length);
            let parameter = self.parameters.get_mut(name);
            let parameter = parameter.expect("the longest name is one of a parameter");
            parameter.used = true;
            self.substituted += parameter.value.len();
            if result.len() + parameter.value.len() > LONGEST_VALUE
                || self.substituted > MOST_SUBSTITUTED
            {
                return Err(too_long(name, span));
            }
            result.push_str(&parameter.value);
            rest = behind;
        }
        result.push_str(rest);
        Ok(result)
    }

    /// The length of the longest name of a parameter that the text begins with.
    fn longest_name(&self, text: &str) -> Option<usize> {
        // No name between the longest that fits and the text in alphabetical order is
        // longer than what it shares with the text.
        let mut upper = text;
        loop {
            let up_to = (Bound::Unbounded, Bound::Included(upper));
            let mut before = self.parameters.range::<str, _>(up_to);
            let (name, _) = before.next_back()?;
            let bytes = name.bytes().zip(upper.bytes());
            let shared = bytes.take_while(|(a, b)| a == b).count();
            if shared == name.len() {
                return Some(shared);
            }
            upper = &upper[..upper.floor_char_boundary(shared)];
        }
    }

    fn undefined(&self, name: &str, span: Span) -> Problem {
        let names = self.parameters.keys().map(String::as_str);
        Problem::definition(span, format!("the parameter ${name} is not defined"))
            .help(format!(
                "define {name}, or give it a value before this place with \
                 <default name=\"{name}\" value=\"...\"/>; a dollar sign itself is written \\$"
            ))
            .near(nearest(name, names))
    }
}

fn too_long(name: &str, span: Span) -> Problem {
    let (value, all) = (LONGEST_VALUE >> 20, MOST_SUBSTITUTED >> 20);
    Problem::unsupported(
        span,
        format!("with ${name}, parameters put in too much text"),
    )
    .help(format!(
        "at most {value} MiB into one attribute and {all} MiB into all are read; \
                 are there parameters that stand for each other many times?"
    ))
}

fn no_children(element: &Element) -> Result<(), Problem> {
    match element.children.first() {
        None => Ok(()),
        Some(child) => Err(Problem::invalid(
            child.span,
            format!("<{}> cannot stand inside <{}>", child.tag, element.tag),
        )
        .help(format!("move it behind the <{}/>", element.tag))),
    }
}

/// Demands a version up to 3.x of the root element, and gives it back if it is
/// below 2.0.
fn check_version(root: &Element) -> Result<Option<Attribute>, Problem> {
    let Some(version) = root.attribute("version") else {
        return Err(Problem::missing(
            root.span,
            format!("<{}> has no attribute \"version\"", root.tag),
        )
        .help("write <scene version=\"3.0.0\">, the version of Mitsuba the file is for"));
    };
    let parts: Vec<Option<u32>> = version.value.split('.').map(|n| n.parse().ok()).collect();
    match parts[..] {
        [Some(2 | 3)] | [Some(2 | 3), Some(_)] | [Some(2 | 3), Some(_), Some(_)] => Ok(None),
        [Some(0 | 1)] | [Some(0 | 1), Some(_)] | [Some(0 | 1), Some(_), Some(_)] => {
            Ok(Some(version.clone()))
        }
        _ => Err(Problem::unsupported(
            version.value_span,
            format!(
                "\"{}\" is not a version of Mitsuba that is read",
                version.value
            ),
        )
        .help("expected up to 3.x, for example version=\"3.0.0\"")),
    }
}
