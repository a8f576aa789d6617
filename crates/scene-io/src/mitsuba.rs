//! Elements to nodes: Mitsuba's tags, property types, ids and references.

use std::collections::{BTreeMap, BTreeSet};

use crate::node::{Graph, Kind, Node, NodeId, Property, PropertyValue};
use crate::problem::Problem;
use crate::suggest::nearest;
use crate::texts::{Span, Texts};
use crate::value;
use crate::xml::{Attribute, Element};

/// Tags of properties that are not objects.
const PROPERTY_TAGS: [&str; 11] = [
    "float",
    "integer",
    "boolean",
    "string",
    "vector",
    "point",
    "rgb",
    "spectrum",
    "transform",
    "ref",
    "alias",
];

/// The objects of a resolved file.
pub(crate) fn parse(texts: &Texts, root: &Element) -> Result<Graph, Problem> {
    if root.tag != "scene" {
        return Err(
            Problem::invalid(root.span, format!("the file describes a <{}>", root.tag))
                .help("expected <scene version=\"3.0.0\"> around everything"),
        );
    }
    let mut parser = Parser {
        texts,
        nodes: Vec::new(),
        ids: BTreeMap::new(),
        aliases: Vec::new(),
        references: Vec::new(),
        warnings: Vec::new(),
    };
    let root = parser.object(root, Kind::Scene)?;
    parser.names_become_ids(root);
    parser.resolve_references()?;
    for node in &parser.nodes {
        refuse_duplicates(&node.properties)?;
    }
    let graph = Graph {
        nodes: parser.nodes,
        root,
        warnings: parser.warnings,
    };
    refuse_cycles(&graph)?;
    Ok(graph)
}

struct Parser<'a> {
    texts: &'a Texts,
    nodes: Vec<Node>,
    /// Named objects and where their names stand.
    ids: BTreeMap<String, (NodeId, Span)>,
    /// New name, old name.
    aliases: Vec<(Attribute, Attribute)>,
    references: Vec<Reference>,
    /// What is odd about properties, and where.
    warnings: Vec<(Span, String)>,
}

/// A `<ref>`, resolved when all objects are known.
struct Reference {
    from: NodeId,
    /// Where among the properties of `from` it belongs.
    slot: usize,
    id: Attribute,
    name: Option<Attribute>,
    span: Span,
}

/// The longest name of an object, characters: names of files and of their parts are made of it.
const LONGEST_ID: usize = 1000;

impl Parser<'_> {
    fn object(&mut self, element: &Element, kind: Kind) -> Result<NodeId, Problem> {
        element.only_attributes(match kind {
            Kind::Scene => &["version", "id", "type"],
            _ => &["type", "id", "name"],
        })?;
        let (plugin, plugin_span) = match (kind, element.attribute("type")) {
            (Kind::Scene, None) => ("scene".into(), element.span),
            _ => {
                let plugin = element.required("type")?;
                (plugin.value.clone(), plugin.value_span)
            }
        };
        let node = NodeId(self.nodes.len());
        let id = element.attribute("id").filter(|id| !id.value.is_empty());
        for named in id.into_iter().chain(element.attribute("name")) {
            let length = named.value.chars().count();
            if length > LONGEST_ID {
                let message = format!("the name has {length} characters");
                let help = format!("expected at most {LONGEST_ID}: files and tables show it");
                return Err(Problem::invalid(named.value_span, message).help(help));
            }
        }
        if let Some(id) = id {
            let place = (node, id.value_span);
            if let Some((_, first)) = self.ids.insert(id.value.clone(), place) {
                return Err(self.duplicate(id, first));
            }
        }
        self.nodes.push(Node {
            kind,
            plugin,
            plugin_span,
            id: id.map(|id| id.value.clone()),
            span: element.span,
            properties: Vec::new(),
        });
        let mut properties = Vec::with_capacity(element.children.len());
        for child in &element.children {
            let slot = properties.len();
            if let Some(property) = self.property(child, node, slot)? {
                properties.push(property);
            }
        }
        self.nodes[node.0].properties = properties;
        Ok(node)
    }

    /// The property that a child element gives; `None` for references, which
    /// are resolved later.
    fn property(
        &mut self,
        element: &Element,
        parent: NodeId,
        slot: usize,
    ) -> Result<Option<Property>, Problem> {
        let is_plugin = element.tag == "spectrum" && element.attribute("type").is_some();
        let kind = match is_plugin {
            true => Some(Kind::Texture),
            false => Kind::ALL.into_iter().find(|k| k.tag() == element.tag),
        };
        if let Some(kind) = kind {
            if kind == Kind::Scene {
                return Err(
                    Problem::invalid(element.span, "a <scene> stands inside another")
                        .help("remove it, or <include> it as a file"),
                );
            }
            let node = self.object(element, kind)?;
            let value = PropertyValue::Object {
                node,
                by_reference: false,
            };
            let name = element.attribute("name");
            return Ok(Some(Property {
                name: name.map_or(String::new(), |n| n.value.clone()),
                name_span: name.map_or(element.span, |n| n.value_span),
                value,
                value_span: element.span,
            }));
        }
        if element.tag != "transform"
            && PROPERTY_TAGS.contains(&element.tag.as_str())
            && let Some(child) = element.children.first()
        {
            return Err(Problem::invalid(
                child.span,
                format!("<{}> cannot stand inside <{}>", child.tag, element.tag),
            )
            .help(format!("close the <{}/> before it", element.tag)));
        }
        match element.tag.as_str() {
            "ref" => {
                element.only_attributes(&["id", "name"])?;
                self.references.push(Reference {
                    from: parent,
                    slot,
                    id: element.required("id")?.clone(),
                    name: element.attribute("name").cloned(),
                    span: element.span,
                });
                Ok(None)
            }
            "alias" => {
                element.only_attributes(&["id", "as"])?;
                let (old, new) = (element.required("id")?, element.required("as")?);
                self.aliases.push((new.clone(), old.clone()));
                Ok(None)
            }
            _ => typed_property(element, &mut self.warnings).map(Some),
        }
    }

    /// Objects directly in the scene that have a name and no id are called by their name, as
    /// the entries of Mitsuba's dictionaries are by their key; ids come first.
    fn names_become_ids(&mut self, root: NodeId) {
        let children = std::mem::take(&mut self.nodes[root.0].properties);
        for child in &children {
            let PropertyValue::Object { node, .. } = child.value else {
                continue;
            };
            let is_free = !child.name.is_empty() && !self.ids.contains_key(&child.name);
            let object = &mut self.nodes[node.0];
            // The sensor's own name is refused as the id of a shape.
            let is_sensors = child.name == "sensor" && object.kind == Kind::Shape;
            if is_free && object.id.is_none() && !is_sensors {
                object.id = Some(child.name.clone());
                self.ids.insert(child.name.clone(), (node, child.name_span));
            }
        }
        self.nodes[root.0].properties = children;
    }

    fn duplicate(&self, id: &Attribute, first: Span) -> Problem {
        Problem::invalid(
            id.value_span,
            format!(
                "the id \"{}\" is taken: an object at {} has it",
                id.value,
                self.texts.location(first)
            ),
        )
        .help("give each object its own id")
    }

    fn target(&self, id: &Attribute) -> Result<NodeId, Problem> {
        let found = self.ids.get(&id.value).map(|(node, _)| *node);
        found.ok_or_else(|| {
            Problem::unknown(
                id.value_span,
                format!("there is no object with the id \"{}\"", id.value),
            )
            .help("give the id=\"...\" of an object in this file or an included one")
            .near(nearest(&id.value, self.ids.keys().map(String::as_str)))
        })
    }

    fn resolve_references(&mut self) -> Result<(), Problem> {
        for (new, old) in std::mem::take(&mut self.aliases) {
            let place = (self.target(&old)?, new.value_span);
            if let Some((_, first)) = self.ids.insert(new.value.clone(), place) {
                return Err(self.duplicate(&new, first));
            }
        }
        let mut by_object: BTreeMap<NodeId, Vec<(usize, Property)>> = BTreeMap::new();
        for reference in std::mem::take(&mut self.references) {
            let node = self.target(&reference.id)?;
            let name = reference.name;
            let property = Property {
                name: name.as_ref().map_or(String::new(), |n| n.value.clone()),
                name_span: name.map_or(reference.span, |n| n.value_span),
                value: PropertyValue::Object {
                    node,
                    by_reference: true,
                },
                value_span: reference.id.value_span,
            };
            let of_object = by_object.entry(reference.from).or_default();
            of_object.push((reference.slot, property));
        }
        for (node, references) in by_object {
            insert(&mut self.nodes[node.0].properties, references);
        }
        Ok(())
    }
}

/// Puts references between the other properties, in the order of the text: a slot counts
/// the properties before it that are no references.
fn insert(properties: &mut Vec<Property>, references: Vec<(usize, Property)>) {
    let mut others = std::mem::take(properties)
        .into_iter()
        .enumerate()
        .peekable();
    for (slot, reference) in references {
        while let Some((_, other)) = others.next_if(|&(i, _)| i < slot) {
            properties.push(other);
        }
        properties.push(reference);
    }
    properties.extend(others.map(|(_, other)| other));
}

fn typed_property(
    element: &Element,
    warnings: &mut Vec<(Span, String)>,
) -> Result<Property, Problem> {
    let tag = element.tag.as_str();
    let (value, value_span) = match tag {
        "float" | "integer" | "boolean" | "string" | "rgb" => {
            element.only_attributes(&["name", "value"])?;
            let attribute = element.required("value")?;
            let (text, span) = (&attribute.value, attribute.value_span);
            let value = match tag {
                "float" => PropertyValue::Float(value::float(text, span)?),
                "integer" => PropertyValue::Integer(value::integer(text, span)?),
                "boolean" => PropertyValue::Boolean(value::boolean(text, span)?),
                "rgb" => PropertyValue::Rgb(value::rgb(attribute)?),
                _ => PropertyValue::String(text.clone()),
            };
            (value, span)
        }
        "vector" | "point" => {
            element.only_attributes(&["name", "value", "x", "y", "z"])?;
            let span = element.attribute("value").map(|a| a.value_span);
            let vector = value::vector(element, None)?;
            (PropertyValue::Vector(vector), span.unwrap_or(element.span))
        }
        "spectrum" => {
            element.only_attributes(&["name", "value", "filename"])?;
            let given = element.attribute("value").or(element.attribute("filename"));
            let span = given.map_or(element.span, |a| a.value_span);
            (PropertyValue::Spectrum(value::spectrum(element)?), span)
        }
        "transform" => {
            element.only_attributes(&["name"])?;
            (
                PropertyValue::Transform(value::transform(element, warnings)?),
                element.span,
            )
        }
        "translate" | "rotate" | "scale" | "lookat" | "matrix" => {
            return Err(Problem::invalid(
                element.span,
                format!("<{tag}> stands outside a transform"),
            )
            .help("write <transform name=\"to_world\"> around it"));
        }
        _ => {
            let tags = Kind::ALL.iter().map(|k| k.tag()).chain(PROPERTY_TAGS);
            let others = ["default", "include", "path"];
            return Err(
                Problem::unknown(element.span, format!("unknown tag <{tag}>"))
                    .help("expected an object such as <shape> or a property such as <float>")
                    .near(nearest(tag, tags.chain(others))),
            );
        }
    };
    let name = element.required("name")?;
    Ok(Property {
        name: name.value.clone(),
        name_span: name.value_span,
        value,
        value_span,
    })
}

fn refuse_duplicates(properties: &[Property]) -> Result<(), Problem> {
    let mut seen = BTreeSet::new();
    for property in properties.iter().filter(|p| !p.name.is_empty()) {
        if !seen.insert(&property.name) {
            return Err(Problem::invalid(
                property.name_span,
                format!("the property \"{}\" is given twice", property.name),
            )
            .help("keep one of them"));
        }
    }
    Ok(())
}

/// Refuses an object that contains itself, at any depth.
fn refuse_cycles(graph: &Graph) -> Result<(), Problem> {
    // Depth-first, with an explicit stack of (object, next property): long
    // chains of references must not exhaust the call stack.
    let mut finished = vec![false; graph.nodes.len()];
    for start in 0..graph.nodes.len() {
        let mut path = vec![(NodeId(start), 0)];
        let mut on_path = BTreeSet::from([NodeId(start)]);
        while let Some((node, next)) = path.last_mut() {
            if finished[node.0] {
                on_path.remove(node);
                path.pop();
                continue;
            }
            let properties = &graph.node(*node).properties;
            let Some(property) = properties.get(*next) else {
                finished[node.0] = true;
                continue;
            };
            *next += 1;
            let PropertyValue::Object { node: child, .. } = property.value else {
                continue;
            };
            if !on_path.insert(child) {
                return Err(
                    Problem::invalid(property.value_span, "this object contains itself")
                        .help("remove this reference"),
                );
            }
            path.push((child, 0));
        }
    }
    Ok(())
}
