//! The scene under construction.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::rc::Rc;

use capwalk_scene::BsdfId;
use capwalk_scene::{Emitter, Material, Quantity, Shape, Texture, TextureId};

use super::places::Places;
use super::sphere_division::SphereDivision;
use crate::fields::Context;
use crate::names::Names;
use crate::node::{Kind, NodeId};
use crate::texts::Span;

/// The parts of the scene that grow while nodes are lowered.
pub(super) struct Lowering<'a> {
    pub context: &'a Context<'a>,
    /// Where files are looked for, the nearest first.
    pub directories: Vec<PathBuf>,
    pub shapes: Vec<Shape>,
    pub materials: Vec<Material>,
    pub emitters: Vec<Emitter>,
    pub textures: Vec<Texture>,
    pub material_of_node: BTreeMap<NodeId, BsdfId>,
    /// And what their colours are.
    pub texture_of_node: BTreeMap<NodeId, (TextureId, Quantity)>,
    /// The shapes of groups, and where they stand.
    pub groups: BTreeMap<NodeId, Rc<[(Shape, Span)]>>,
    /// How finely spheres are divided.
    pub spheres: SphereDivision,
    /// How many triangles the instances so far have.
    pub triangles_of_instances: usize,
    /// Area emitters that have their shape.
    pub attached: BTreeSet<NodeId>,
    /// How many materials the one being read stands in.
    pub bsdf_depth: usize,
    /// How many textures the one being read stands in.
    pub texture_depth: usize,
    /// Names of shapes and sensors, which share one namespace of parameters.
    pub shape_ids: Names,
    pub material_ids: Names,
    pub emitter_ids: Names,
    pub places: Places,
}

impl<'a> Lowering<'a> {
    /// Nothing but the names that the file gives, so that made up ones differ.
    pub fn new(context: &'a Context<'a>, directories: Vec<PathBuf>) -> Self {
        let mut lowering = Self {
            context,
            directories,
            shapes: Vec::new(),
            materials: Vec::new(),
            emitters: Vec::new(),
            textures: Vec::new(),
            material_of_node: BTreeMap::new(),
            texture_of_node: BTreeMap::new(),
            groups: BTreeMap::new(),
            spheres: SphereDivision::FINEST,
            triangles_of_instances: 0,
            attached: BTreeSet::new(),
            bsdf_depth: 0,
            texture_depth: 0,
            shape_ids: Names::default(),
            material_ids: Names::default(),
            emitter_ids: Names::default(),
            places: Places::default(),
        };
        for node in &context.graph.nodes {
            let taken = match node.kind {
                Kind::Shape | Kind::Sensor => &mut lowering.shape_ids,
                Kind::Bsdf => &mut lowering.material_ids,
                Kind::Emitter => &mut lowering.emitter_ids,
                _ => continue,
            };
            node.id.iter().for_each(|id| taken.reserve(id));
        }
        lowering
    }

    /// Adds a texture whose numbers stand at `span`.
    pub fn add_texture(&mut self, texture: Texture, span: Span) -> TextureId {
        for part in texture.parts() {
            self.places.numbers.insert(texture.part_name(part), span);
        }
        self.textures.push(texture);
        TextureId(self.textures.len() as u32 - 1)
    }

    /// The name of an object: its id, or a made up one that is free.
    pub fn shape_name(&mut self, id: Option<&str>, otherwise: &str) -> String {
        match id {
            Some(id) => id.to_owned(),
            None => self.shape_ids.make_unique(otherwise),
        }
    }

    pub fn material_name(&mut self, id: Option<&str>, otherwise: &str) -> String {
        match id {
            Some(id) => id.to_owned(),
            None => self.material_ids.make_unique(otherwise),
        }
    }
}
