//! The parsed scene: objects with typed properties, each with its place.

use capwalk_math::{Affine, Rgb, Vec3};

use crate::spectrum::Samples;
use crate::texts::Span;

/// Index into [`Graph::nodes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct NodeId(pub usize);

/// All objects of a scene; references are resolved and free of cycles.
#[derive(Debug)]
pub(crate) struct Graph {
    pub nodes: Vec<Node>,
    pub root: NodeId,
    /// What is odd about properties, and where.
    pub warnings: Vec<(Span, String)>,
}

impl Graph {
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0]
    }
}

/// An object: `<shape type="sphere" id="ball"> ... </shape>`.
#[derive(Debug)]
pub(crate) struct Node {
    pub kind: Kind,
    /// Its `type`.
    pub plugin: String,
    pub plugin_span: Span,
    pub id: Option<String>,
    pub span: Span,
    pub properties: Vec<Property>,
}

/// Something that an object is given.
#[derive(Debug)]
pub(crate) struct Property {
    /// Empty for objects without a name.
    pub name: String,
    pub name_span: Span,
    pub value: PropertyValue,
    pub value_span: Span,
}

/// What a property holds.
#[derive(Debug)]
pub(crate) enum PropertyValue {
    Float(f64),
    Integer(i64),
    Boolean(bool),
    String(String),
    Vector(Vec3),
    Rgb(Rgb),
    Spectrum(Spectrum),
    Transform(Affine),
    Object {
        node: NodeId,
        /// True if it stands elsewhere and is named by a `<ref>`.
        by_reference: bool,
    },
}

/// A `<spectrum>`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Spectrum {
    /// One value at all wavelengths.
    Uniform(f64),
    /// Values at wavelengths.
    Sampled(Samples),
    /// The name of a file with values at wavelengths.
    File(String),
}

impl PropertyValue {
    /// The tag that gives such a value.
    pub fn tag(&self) -> &'static str {
        match self {
            Self::Float(_) => "float",
            Self::Integer(_) => "integer",
            Self::Boolean(_) => "boolean",
            Self::String(_) => "string",
            Self::Vector(_) => "vector",
            Self::Rgb(_) => "rgb",
            Self::Spectrum(_) => "spectrum",
            Self::Transform(_) => "transform",
            Self::Object { .. } => "object",
        }
    }
}

/// What an object is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Scene,
    Shape,
    Bsdf,
    Emitter,
    Sensor,
    Film,
    Filter,
    Sampler,
    Integrator,
    Texture,
    Volume,
    Medium,
    Phase,
}

impl Kind {
    pub const ALL: [Self; 13] = [
        Self::Scene,
        Self::Shape,
        Self::Bsdf,
        Self::Emitter,
        Self::Sensor,
        Self::Film,
        Self::Filter,
        Self::Sampler,
        Self::Integrator,
        Self::Texture,
        Self::Volume,
        Self::Medium,
        Self::Phase,
    ];

    /// Its XML tag.
    pub fn tag(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Shape => "shape",
            Self::Bsdf => "bsdf",
            Self::Emitter => "emitter",
            Self::Sensor => "sensor",
            Self::Film => "film",
            Self::Filter => "rfilter",
            Self::Sampler => "sampler",
            Self::Integrator => "integrator",
            Self::Texture => "texture",
            Self::Volume => "volume",
            Self::Medium => "medium",
            Self::Phase => "phase",
        }
    }
}
