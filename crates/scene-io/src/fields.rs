//! The properties of one object, read strictly: an unused one is an
//! error that lists what could have been asked for.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use capwalk_math::{Affine, Vec3};

use crate::files::read_file;
use crate::files_read::FilesRead;
use crate::mesh::GltfFile;
use crate::node::{Graph, Kind, Node, NodeId, Property, PropertyValue};
use crate::problem::Problem;
use crate::suggest::{nearest, snake_case};
use crate::texts::{Span, Texts};
use crate::upgrade::upgraded_name;
use crate::warning::Warning;

/// What every stage of lowering reads.
pub(crate) struct Context<'a> {
    pub texts: &'a Texts,
    pub graph: &'a Graph,
    /// Warnings so far, in the order in which they were found.
    pub warnings: RefCell<Vec<Warning>>,
    /// How many more there were than are kept.
    pub more_warnings: Cell<usize>,
    /// The files that were read so far, besides the texts.
    pub files: RefCell<FilesRead>,
    /// The glTF files that were read so far, by their paths.
    pub gltf_files: RefCell<BTreeMap<PathBuf, Rc<GltfFile>>>,
}

/// Warnings of one scene that are kept; the others are counted. Finding the line of each
/// takes time proportional to the length of the file.
const MOST_WARNINGS: usize = 1000;

impl<'a> Context<'a> {
    /// Before anything is lowered.
    pub fn new(texts: &'a Texts, graph: &'a Graph) -> Self {
        Self {
            texts,
            graph,
            warnings: Default::default(),
            more_warnings: Default::default(),
            files: texts.paths().collect::<FilesRead>().into(),
            gltf_files: Default::default(),
        }
    }

    /// The bytes of a file, which is remembered.
    pub fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let bytes = read_file(path)?;
        self.files.borrow_mut().add(path);
        Ok(bytes)
    }

    pub fn warn(&self, span: Span, message: &str) {
        self.add_warning(span, message, false);
    }

    /// Warns of what is seen only in light.
    pub fn warn_about_light(&self, span: Span, message: &str) {
        self.add_warning(span, message, true);
    }

    fn add_warning(&self, span: Span, message: &str, is_about_light: bool) {
        let mut warnings = self.warnings.borrow_mut();
        if warnings.len() == MOST_WARNINGS {
            self.more_warnings.set(self.more_warnings.get() + 1);
            return;
        }
        warnings.push(Warning {
            location: self.texts.location(span),
            message: message.into(),
            is_about_light,
        });
    }

    /// All warnings; the last one says how many more there are.
    pub fn into_warnings(self) -> Vec<Warning> {
        let mut warnings = self.warnings.into_inner();
        let more = self.more_warnings.get();
        if let (Some(last), 1..) = (warnings.last(), more) {
            let location = last.location.clone();
            let message =
                format!("there are {more} more warnings from here on, which are not shown");
            warnings.push(Warning {
                location,
                message,
                is_about_light: false,
            });
        }
        warnings
    }
}

/// The properties of one object and which of them were asked for.
pub(crate) struct Fields<'a> {
    context: &'a Context<'a>,
    pub node: &'a Node,
    used: Vec<Cell<bool>>,
    /// Names that were asked for, whether given or not.
    known: RefCell<Vec<&'static str>>,
    /// Kinds of objects that were asked for.
    known_kinds: RefCell<Vec<Kind>>,
}

/// An object inside another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Child {
    pub node: NodeId,
    /// Where it stands or is referred to.
    pub span: Span,
    pub by_reference: bool,
}

impl<'a> Fields<'a> {
    pub fn new(context: &'a Context<'a>, node: NodeId) -> Self {
        let node = context.graph.node(node);
        Self {
            context,
            node,
            used: vec![Cell::new(false); node.properties.len()],
            known: RefCell::new(Vec::new()),
            known_kinds: RefCell::new(Vec::new()),
        }
    }

    /// The property with this name, which from now on counts as used.
    pub fn get(&self, name: &'static str) -> Option<&'a Property> {
        self.known.borrow_mut().push(name);
        let index = self.node.properties.iter().position(|p| p.name == name)?;
        self.used[index].set(true);
        Some(&self.node.properties[index])
    }

    /// Where the value of a property stands, or else the object.
    pub fn span_of(&self, name: &str) -> Span {
        let mut properties = self.node.properties.iter();
        let property = properties.find(|p| p.name == name);
        property.map_or(self.node.span, |p| p.value_span)
    }

    pub fn float(&self, name: &'static str, default: f64) -> Result<f64, Problem> {
        Ok(self.optional_float(name)?.unwrap_or(default))
    }

    pub fn optional_float(&self, name: &'static str) -> Result<Option<f64>, Problem> {
        self.typed(name, "float", |value| match *value {
            PropertyValue::Float(x) => Some(x),
            PropertyValue::Integer(i) => Some(i as f64),
            _ => None,
        })
    }

    /// A whole number within `range`.
    pub fn integer(
        &self,
        name: &'static str,
        range: std::ops::RangeInclusive<i64>,
    ) -> Result<Option<i64>, Problem> {
        let number = self.typed(name, "integer", |value| match *value {
            PropertyValue::Integer(i) => Some(i),
            PropertyValue::Float(x) if x.fract() == 0.0 && x.abs() < 9e15 => Some(x as i64),
            _ => None,
        })?;
        match number {
            Some(i) if !range.contains(&i) => Err(Problem::invalid(
                self.span_of(name),
                format!("\"{name}\" is {i}"),
            )
            .help(format!(
                "expected a whole number from {} to {}",
                range.start(),
                range.end()
            ))),
            _ => Ok(number),
        }
    }

    /// A whole number from `least` that fits 32 bits.
    pub fn count(&self, name: &'static str, least: u32, default: u32) -> Result<u32, Problem> {
        Ok(self.optional_count(name, least)?.unwrap_or(default))
    }

    pub fn optional_count(&self, name: &'static str, least: u32) -> Result<Option<u32>, Problem> {
        let number = self.integer(name, i64::from(least)..=i64::from(u32::MAX))?;
        Ok(number.map(|i| i as u32))
    }

    pub fn boolean(&self, name: &'static str, default: bool) -> Result<bool, Problem> {
        let value = self.typed(name, "boolean", |value| match *value {
            PropertyValue::Boolean(b) => Some(b),
            _ => None,
        })?;
        Ok(value.unwrap_or(default))
    }

    pub fn string(&self, name: &'static str) -> Result<Option<&'a str>, Problem> {
        self.typed(name, "string", |value| match value {
            PropertyValue::String(text) => Some(text.as_str()),
            _ => None,
        })
    }

    pub fn point(&self, name: &'static str) -> Result<Option<Vec3>, Problem> {
        self.typed(name, "point", |value| match *value {
            PropertyValue::Vector(v) => Some(v),
            _ => None,
        })
    }

    pub fn transform(&self, name: &'static str) -> Result<Affine, Problem> {
        let value = self.typed(name, "transform", |value| match *value {
            PropertyValue::Transform(t) => Some(t),
            _ => None,
        })?;
        Ok(value.unwrap_or(Affine::IDENTITY))
    }

    fn typed<T>(
        &self,
        name: &'static str,
        tag: &str,
        read: impl Fn(&'a PropertyValue) -> Option<T>,
    ) -> Result<Option<T>, Problem> {
        let Some(property) = self.get(name) else {
            return Ok(None);
        };
        read(&property.value).map(Some).ok_or_else(|| {
            let given = property.value.tag();
            let written = self.as_written(property);
            Problem::invalid(property.value_span, format!("{written} is a <{given}>"))
                .help(format!("expected <{tag} name=\"{name}\" .../>"))
        })
    }

    /// The objects of one kind inside this one, in the order of the text.
    pub fn children(&self, kind: Kind) -> Vec<Child> {
        self.known_kinds.borrow_mut().push(kind);
        let properties = self.node.properties.iter().zip(&self.used);
        let of_kind = properties.filter_map(|(property, used)| match property.value {
            PropertyValue::Object { node, by_reference }
                if self.context.graph.node(node).kind == kind =>
            {
                used.set(true);
                Some(Child {
                    node,
                    span: property.value_span,
                    by_reference,
                })
            }
            _ => None,
        });
        of_kind.collect()
    }

    /// The one object of a kind inside this one, if there is one.
    pub fn child(&self, kind: Kind) -> Result<Option<Child>, Problem> {
        let children = self.children(kind);
        match children[..] {
            [] => Ok(None),
            [child] => Ok(Some(child)),
            [_, second, ..] => Err(Problem::invalid(
                second.span,
                format!("{} has more than one {}", self.title(), kind.tag()),
            )
            .help("keep one of them")),
        }
    }

    /// Accepts properties that do not change the image, with a warning.
    pub fn cosmetic(&self, names: &[&'static str], reason: &str) {
        for name in names {
            if self.get(name).is_some() {
                self.warn_at(name, &format!("has no effect here: {reason}"));
            }
        }
    }

    /// Warns of the object's plugin.
    pub fn warn(&self, message: &str) {
        self.context.warn(self.node.plugin_span, message);
    }

    /// Warns of a property, if it is given; the message starts with its name.
    pub fn warn_at(&self, name: &str, message: &str) {
        let mut properties = self.node.properties.iter();
        if let Some(property) = properties.find(|p| p.name == name) {
            let message = format!("{} {message}", self.as_written(property));
            self.context.warn(property.name_span, &message);
        }
    }

    /// The name of a property in quotes, as the file has it: files for old
    /// versions have old names.
    fn as_written(&self, property: &Property) -> String {
        let written = self.context.texts.slice(property.name_span);
        match written != property.name && upgraded_name(written) == property.name {
            true => format!("\"{written}\" (now \"{}\")", property.name),
            false => format!("\"{}\"", property.name),
        }
    }

    fn misplaced(&self, property: &Property, kind: Kind) -> Problem {
        let tag = kind.tag();
        let article = match tag.starts_with(['a', 'e', 'i', 'o', 'u']) {
            true => "an",
            false => "a",
        };
        Problem::invalid(
            property.value_span,
            format!("{} cannot have {article} {tag}", self.title()),
        )
    }

    /// Refuses properties of Mitsuba's that change the image and are not
    /// supported.
    pub fn refuse(&self, names: &[&str], reason: &str) -> Result<(), Problem> {
        let mut properties = self.node.properties.iter();
        match properties.find(|p| names.contains(&p.name.as_str())) {
            None => Ok(()),
            Some(property) => Err(Problem::unsupported(
                property.name_span,
                format!("{} is not supported", self.as_written(property)),
            )
            .help(reason)),
        }
    }

    /// Refuses properties that were not used.
    pub fn finish(&self) -> Result<(), Problem> {
        let properties = self.node.properties.iter().zip(&self.used);
        match properties.into_iter().find(|(_, used)| !used.get()) {
            None => Ok(()),
            Some((property, _)) => Err(self.unused(property)),
        }
    }

    fn unused(&self, property: &Property) -> Problem {
        if let PropertyValue::Object { node, .. } = property.value {
            let object = self.context.graph.node(node);
            let kinds = self.known_kinds.borrow();
            let tags: Vec<String> = kinds.iter().map(|k| format!("<{}>", k.tag())).collect();
            let problem = self.misplaced(property, object.kind);
            return problem.help(match tags.is_empty() {
                true => "no objects are read here".into(),
                false => format!("expected {}", tags.join(", ")),
            });
        }
        let known = self.known.borrow();
        let name = &property.name;
        let problem = Problem::unknown(
            property.name_span,
            format!(
                "unknown property {} of {}",
                self.as_written(property),
                self.title()
            ),
        );
        let snake = snake_case(name);
        if snake != *name && known.contains(&snake.as_str()) {
            return problem
                .help("Mitsuba 2 and 3 write names in small letters with underscores")
                .near(vec![snake]);
        }
        let mut names = known.clone();
        names.sort_unstable();
        names.dedup();
        problem
            .help(match names.is_empty() {
                true => "it has no properties".into(),
                false => format!("its properties are {}", names.join(", ")),
            })
            .near(nearest(name, names))
    }

    /// How messages call the object.
    pub fn title(&self) -> String {
        match self.node.kind {
            Kind::Scene => "the scene".into(),
            kind => format!("the {} \"{}\"", kind.tag(), self.node.plugin),
        }
    }

    /// [`Self::unknown_plugin`], or what to do instead of one that `refused` lists.
    pub fn refused_plugin(&self, known: &[&str], refused: &[(&str, &str)]) -> Problem {
        let (kind, plugin) = (self.node.kind.tag(), self.node.plugin.as_str());
        match refused.iter().find(|(name, _)| *name == plugin) {
            None => self.unknown_plugin(known),
            Some((_, instead)) => Problem::unsupported(
                self.node.plugin_span,
                format!("the {kind} \"{plugin}\" is not supported"),
            )
            .help(*instead),
        }
    }

    /// The error for a plugin that does not exist here.
    pub fn unknown_plugin(&self, known: &[&str]) -> Problem {
        let kind = self.node.kind.tag();
        let plugin = &self.node.plugin;
        Problem::unknown(
            self.node.plugin_span,
            format!("unknown {kind} plugin \"{plugin}\""),
        )
        .help(format!("known {kind} plugins: {}", known.join(", ")))
        .near(nearest(plugin, known.iter().copied()))
    }
}
