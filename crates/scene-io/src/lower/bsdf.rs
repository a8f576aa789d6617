//! Materials: `diffuse` and `twosided`.

use capwalk_math::Rgb;
use capwalk_scene::scene::BsdfId;
use capwalk_scene::{Bsdf, Material, Quantity, Texture};

use super::Lowering;
use crate::fields::Fields;
use crate::node::{Kind, NodeId};
use crate::source::{Problem, Span};

/// The plugins.
const BSDFS: [&str; 2] = ["diffuse", "twosided"];

impl Lowering<'_> {
    /// The material of a node, made when it is first met. `otherwise` names it
    /// if it has no id.
    pub(super) fn bsdf(&mut self, node: NodeId, otherwise: &str) -> Result<BsdfId, Problem> {
        if let Some(&known) = self.material_of_node.get(&node) {
            return Ok(known);
        }
        let fields = Fields::new(self.context, node);
        let name = self.material_name(fields.node.id.as_deref(), otherwise);
        let bsdf = match fields.node.plugin.as_str() {
            "diffuse" => self.diffuse(&fields, &name)?,
            "twosided" => self.two_sided(&fields, &name)?,
            _ => return Err(fields.unknown_plugin(&BSDFS)),
        };
        fields.finish()?;
        let id = self.add_material(name, bsdf);
        self.material_of_node.insert(node, id);
        Ok(id)
    }

    /// The material of a shape without one: grey, or black for a lamp.
    pub(super) fn default_bsdf(&mut self, name: &str, is_lamp: bool, shape: Span) -> BsdfId {
        let name = self.material_name(None, name);
        let reflectance = Rgb::splat(if is_lamp { 0.0 } else { 0.5 });
        let texture = Texture::colour(format!("{name}.reflectance"), reflectance);
        let reflectance = self.add_texture(texture, shape);
        self.add_material(name, Bsdf::Diffuse { reflectance })
    }

    fn add_material(&mut self, id: String, bsdf: Bsdf) -> BsdfId {
        self.materials.push(Material { id, bsdf });
        BsdfId(self.materials.len() as u32 - 1)
    }

    fn diffuse(&mut self, fields: &Fields, name: &str) -> Result<Bsdf, Problem> {
        let reflectance = self.slot(fields, name, "reflectance", Quantity::Reflectance, 0.5)?;
        Ok(Bsdf::Diffuse { reflectance })
    }

    fn two_sided(&mut self, fields: &Fields, name: &str) -> Result<Bsdf, Problem> {
        let nested = fields.children(Kind::Bsdf);
        // Only materials that let light through would need it.
        fields.boolean("allow_transmission", false)?;
        if let Some(third) = nested.get(2) {
            return Err(Problem::new(
                third.span,
                "the bsdf \"twosided\" has more than two materials",
            )
            .help("give one for both sides, or one for the front and one for the back"));
        }
        let mut sides = Vec::with_capacity(2);
        for (i, child) in nested.iter().enumerate() {
            if self.context.graph.node(child.node).plugin == "twosided" {
                return Err(Problem::new(
                    child.span,
                    "a twosided material stands inside a twosided material",
                )
                .help("put one-sided materials into it, such as <bsdf type=\"diffuse\"/>"));
            }
            sides.push(self.bsdf(child.node, &format!("{name}.brdf_{i}"))?);
        }
        match sides[..] {
            [both] => Ok(Bsdf::TwoSided {
                front: both,
                back: both,
            }),
            [front, back] => Ok(Bsdf::TwoSided { front, back }),
            _ => Err(
                Problem::new(fields.node.span, "the bsdf \"twosided\" has no material")
                    .help("put a one-sided material into it, such as <bsdf type=\"diffuse\"/>"),
            ),
        }
    }
}
