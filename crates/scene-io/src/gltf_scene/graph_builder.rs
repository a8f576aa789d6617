//! The objects of a glTF scene while they are made.

use std::collections::BTreeMap;

use capwalk_math::Rgb;

use crate::mesh::{GltfFile, shown_name};
use crate::names::Names;
use crate::node::{Graph, Kind, Node, NodeId, Property, PropertyValue};
use crate::texts::{FileId, Span};

/// The line of the text for the file as a whole.
pub(super) const FILE: usize = 0;

/// What messages call the file as a whole, its nodes and its materials, a line each: objects stand
/// there. The text itself is empty.
pub(crate) fn lines(file: &GltfFile, name: &str) -> Vec<String> {
    let json = file.document.as_json();
    let nodes = json.nodes.iter().map(|node| ("nodes", &node.name));
    let materials = json
        .materials
        .iter()
        .map(|material| ("materials", &material.name));
    let titles = nodes.enumerate().chain(materials.enumerate());
    let titles = titles.map(
        |(index, (list, title))| match shown_name(title.as_deref()) {
            Some(title) => format!("{name}: {list}[{index}] \"{title}\""),
            None => format!("{name}: {list}[{index}]"),
        },
    );
    std::iter::once(name.to_owned()).chain(titles).collect()
}

/// What a primitive is made of.
#[derive(Clone, Copy)]
pub(super) struct PrimitiveSurface {
    pub bsdf: NodeId,
    /// What it emits, if it does.
    pub radiance: Option<Radiance>,
}

/// What a surface emits.
#[derive(Clone, Copy)]
pub(super) enum Radiance {
    Colour(Rgb),
    Texture(NodeId),
}

/// The objects so far.
pub(super) struct GraphBuilder<'a> {
    pub file: &'a GltfFile,
    text: FileId,
    filename: &'a str,
    nodes: Vec<Node>,
    warnings: Vec<(Span, String)>,
    /// Of sensors, materials and emitters.
    names: [Names; 3],
    /// What was made of materials, with and without colours of vertices.
    pub surfaces: BTreeMap<(Option<usize>, bool), PrimitiveSurface>,
    /// Lines of materials that have one side.
    pub one_sided: Vec<usize>,
}

impl<'a> GraphBuilder<'a> {
    pub fn new(file: &'a GltfFile, text: FileId, filename: &'a str) -> Self {
        Self {
            file,
            text,
            filename,
            nodes: Vec::new(),
            warnings: Vec::new(),
            names: Default::default(),
            surfaces: BTreeMap::new(),
            one_sided: Vec::new(),
        }
    }

    pub fn line_of_node(&self, node: usize) -> usize {
        1 + node
    }

    pub fn line_of_material(&self, material: Option<usize>) -> usize {
        let nodes = self.file.document.as_json().nodes.len();
        material.map_or(FILE, |material| 1 + nodes + material)
    }

    /// A line's place in the text, which has nothing but ends of lines.
    fn span(&self, line: usize) -> Span {
        Span {
            file: self.text,
            start: line,
            end: line,
        }
    }

    /// A new object, which stands in a line. A name that another one has is numbered.
    pub fn add(&mut self, kind: Kind, plugin: &str, name: Option<&str>, line: usize) -> NodeId {
        let span = self.span(line);
        let names = match kind {
            Kind::Sensor => &mut self.names[0],
            Kind::Bsdf => &mut self.names[1],
            _ => &mut self.names[2],
        };
        self.nodes.push(Node {
            kind,
            plugin: plugin.to_owned(),
            plugin_span: span,
            id: name.map(|name| names.make_unique(name)),
            span,
            properties: Vec::new(),
        });
        NodeId(self.nodes.len() - 1)
    }

    /// Gives an object a property.
    pub fn set(&mut self, object: NodeId, name: &str, value: PropertyValue) {
        let span = self.nodes[object.0].span;
        self.nodes[object.0].properties.push(Property {
            name: name.to_owned(),
            name_span: span,
            value,
            value_span: span,
        });
    }

    /// Puts an object into another.
    pub fn put(&mut self, parent: NodeId, node: NodeId) {
        let by_reference = false;
        self.set(parent, "", PropertyValue::Object { node, by_reference });
    }

    /// Gives an object another one that others may have, too.
    pub fn refer(&mut self, parent: NodeId, name: &str, node: NodeId) {
        let by_reference = true;
        self.set(parent, name, PropertyValue::Object { node, by_reference });
    }

    /// The file, as its own shapes and textures name it.
    pub fn filename(&self) -> PropertyValue {
        PropertyValue::String(self.filename.to_owned())
    }

    pub fn warn(&mut self, line: usize, message: impl Into<String>) {
        self.warnings.push((self.span(line), message.into()));
    }

    pub fn has_sensor(&self) -> bool {
        self.nodes.iter().any(|node| node.kind == Kind::Sensor)
    }

    /// The objects of the scene `root`.
    pub fn finish(mut self, root: NodeId) -> Graph {
        if let [first, others @ ..] = &self.one_sided[..] {
            let others = match others.len() {
                0 => String::new(),
                count => format!(" (nor are {count} more)"),
            };
            let message = format!(
                "not doubleSided{others}: black from behind, where glTF shows what is \
                 behind it"
            );
            self.warn(*first, message);
        }
        Graph {
            nodes: self.nodes,
            root,
            warnings: self.warnings,
        }
    }
}
