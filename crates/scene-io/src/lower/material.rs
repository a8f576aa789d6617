//! Materials. Those that are not made of others are read by the declarations of their fields
//! (`material_fields.rs`).

use capwalk_math::Rgb;
use capwalk_scene::BsdfId;
use capwalk_scene::bsdf::NormalLimits;
use capwalk_scene::lobe::{Diffuse, Lobe};
use capwalk_scene::{Bsdf, Material, Quantity, Texture};

use super::lowering::Lowering;
use super::material_fields::Reading;
use crate::fields::{Child, Fields};
use crate::node::{Kind, NodeId};
use crate::problem::Problem;
use crate::texts::Span;

/// Values of `type` that are read, besides those of [`Lobe::PLUGINS`].
const OTHERS: [&str; 8] = [
    "polarizer",
    "circular",
    "retarder",
    "twosided",
    "mask",
    "blendbsdf",
    "normalmap",
    "bumpmap",
];

/// Materials that are not read, and what to do instead: those of Mitsuba 3, then those of 0.6.
const REFUSED: [(&str, &str); 9] = [
    (
        "hair",
        "fibres are not rendered as such; write <bsdf type=\"principled\"> with anisotropic, on \
         curves",
    ),
    (
        "measured",
        "tables of measurements are not evaluated; fit a <bsdf type=\"principled\"> or a \
         <bsdf type=\"roughconductor\"> to them",
    ),
    (
        "measured_polarized",
        "tables of measurements are not evaluated; write <bsdf type=\"roughconductor\"> with the \
         metal's name as its material",
    ),
    (
        "phong",
        "powers of cosines are not evaluated; write <bsdf type=\"roughplastic\"> or \
         <bsdf type=\"principled\">; about as wide as the power n is alpha = 1 / sqrt(2 n)",
    ),
    (
        "ward",
        "write <bsdf type=\"roughplastic\">, or a <bsdf type=\"blendbsdf\"> of \
         <bsdf type=\"diffuse\"> and <bsdf type=\"roughconductor\"> with alpha_u and alpha_v",
    ),
    (
        "roughdiffuse",
        "rough diffuse surfaces are not evaluated; write <bsdf type=\"diffuse\">",
    ),
    (
        "coating",
        "layers are not evaluated; write <bsdf type=\"plastic\">, or \
         <bsdf type=\"principled\"> with clearcoat",
    ),
    (
        "roughcoating",
        "layers are not evaluated; write <bsdf type=\"roughplastic\">, or \
         <bsdf type=\"principled\"> with clearcoat",
    ),
    (
        "mixturebsdf",
        "write a <bsdf type=\"blendbsdf\"> of two materials, one inside the other for more",
    ),
];

/// How deep materials may stand in materials.
const MAX_DEPTH: usize = 8;

/// What scene files call materials: those that are read, then those that are refused by name.
pub fn bsdf_plugins() -> impl Iterator<Item = &'static str> {
    let refused = REFUSED.iter().map(|&(name, _)| name);
    Lobe::PLUGINS.iter().copied().chain(OTHERS).chain(refused)
}

impl Lowering<'_> {
    /// The material of a node, made when it is first met. `otherwise` names it
    /// if it has no id.
    pub(super) fn bsdf(&mut self, node: NodeId, otherwise: &str) -> Result<BsdfId, Problem> {
        if let Some(&known) = self.material_of_node.get(&node) {
            return Ok(known);
        }
        let fields = Fields::new(self.context, node);
        if self.bsdf_depth > MAX_DEPTH {
            return Err(Problem::unsupported(
                fields.node.span,
                "materials stand inside each other too deep",
            )
            .help(format!("expected at most {MAX_DEPTH} inside each other")));
        }
        let name = self.material_name(fields.node.id.as_deref(), otherwise);
        self.bsdf_depth += 1;
        let bsdf = self.bsdf_of_plugin(&fields, &name)?;
        self.bsdf_depth -= 1;
        fields.finish()?;
        let id = self.add_material(name, bsdf);
        self.places.materials.push(fields.node.span);
        self.material_of_node.insert(node, id);
        Ok(id)
    }

    fn bsdf_of_plugin(&mut self, fields: &Fields, name: &str) -> Result<Bsdf, Problem> {
        let plugin = fields.node.plugin.as_str();
        let reading = &mut Reading {
            lowering: self,
            fields,
            name,
        };
        if let Some(lobe) = Lobe::read(plugin, reading) {
            let lobe = lobe?;
            if let Some(warning) = lobe.warning(&|id| &self.textures[id.0 as usize]) {
                fields.warn(warning);
            }
            return Ok(Bsdf::Plain(lobe));
        }
        Ok(match plugin {
            "polarizer" | "circular" => self.polarization_filter(fields, name, 0.5)?,
            "retarder" => self.polarization_filter(fields, name, 1.0)?,
            "twosided" => self.two_sided(fields, name)?,
            "mask" => Bsdf::Mask {
                opacity: self.number(fields, name, "opacity", Quantity::Fraction, 0.5)?,
                nested: self.nested(fields, name)?,
            },
            "blendbsdf" => self.blend(fields, name)?,
            "normalmap" => {
                if fields.get("normalmap").is_none() {
                    return Err(Problem::missing(
                        fields.node.span,
                        "the bsdf \"normalmap\" has no map",
                    )
                    .help("add <texture name=\"normalmap\" type=\"bitmap\"> with raw = true"));
                }
                Bsdf::NormalMap {
                    normals: self.number(fields, name, "normalmap", Quantity::Normal, 0.5)?,
                    nested: self.nested(fields, name)?,
                    limits: normal_limits(fields)?,
                }
            }
            "bumpmap" => self.bump(fields, name)?,
            _ => return Err(fields.refused_plugin(&[Lobe::PLUGINS, &OTHERS].concat(), &REFUSED)),
        })
    }

    /// The material of a shape without one: grey, or black if it emits.
    pub(super) fn default_bsdf(&mut self, name: &str, emits: bool, shape: Span) -> BsdfId {
        let name = self.material_name(None, name);
        let reflectance = Rgb::splat(if emits { 0.0 } else { 0.5 });
        let texture = Texture::colour(format!("{name}.reflectance"), reflectance);
        let reflectance = self.add_texture(texture, shape);
        self.places.materials.push(shape);
        self.add_material(name, Diffuse { reflectance }.into())
    }

    fn add_material(&mut self, id: String, bsdf: Bsdf) -> BsdfId {
        self.materials.push(Material { id, bsdf });
        BsdfId(self.materials.len() as u32 - 1)
    }

    fn two_sided(&mut self, fields: &Fields, name: &str) -> Result<Bsdf, Problem> {
        let nested = fields.children(Kind::Bsdf);
        // Only materials that let light through would need it.
        fields.boolean("allow_transmission", false)?;
        if let Some(third) = nested.get(2) {
            return Err(Problem::invalid(
                third.span,
                "the bsdf \"twosided\" has more than two materials",
            )
            .help("give one for both sides, or one for the front and one for the back"));
        }
        let mut sides = Vec::with_capacity(2);
        for (i, child) in nested.iter().enumerate() {
            if self.context.graph.node(child.node).plugin == "twosided" {
                return Err(Problem::invalid(
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
                Problem::missing(fields.node.span, "the bsdf \"twosided\" has no material")
                    .help("put a one-sided material into it, such as <bsdf type=\"diffuse\"/>"),
            ),
        }
    }

    /// The one material that stands in another.
    fn nested(&mut self, fields: &Fields, name: &str) -> Result<BsdfId, Problem> {
        let Some(Child { node, .. }) = fields.child(Kind::Bsdf)? else {
            let message = format!("{} has no material", fields.title());
            return Err(Problem::missing(fields.node.span, message)
                .help("put a material into it, such as <bsdf type=\"diffuse\"/>"));
        };
        self.bsdf(node, &format!("{name}.nested_bsdf"))
    }

    fn blend(&mut self, fields: &Fields, name: &str) -> Result<Bsdf, Problem> {
        if fields.get("weight").is_none() {
            let message = "the bsdf \"blendbsdf\" has no weight";
            return Err(Problem::missing(fields.node.span, message)
                .help("add <float name=\"weight\" value=\"0.5\"/>: the part of the second"));
        }
        let weight = self.number(fields, name, "weight", Quantity::Fraction, 0.5)?;
        let children = fields.children(Kind::Bsdf);
        let [first, second] = children[..] else {
            let message = format!("the bsdf \"blendbsdf\" has {} materials", children.len());
            return Err(Problem::missing(fields.node.span, message).help("put two into it"));
        };
        let first = self.bsdf(first.node, &format!("{name}.bsdf_0"))?;
        let second = self.bsdf(second.node, &format!("{name}.bsdf_1"))?;
        Ok(Bsdf::Blend {
            weight,
            nested: [first, second],
        })
    }

    fn bump(&mut self, fields: &Fields, name: &str) -> Result<Bsdf, Problem> {
        // Whatever it is called.
        let Some(Child { node, .. }) = fields.child(Kind::Texture)? else {
            let message = "the bsdf \"bumpmap\" has no texture";
            return Err(Problem::missing(fields.node.span, message)
                .help("put a <texture> with heights into it"));
        };
        let id = format!("{name}.nested_texture");
        Ok(Bsdf::BumpMap {
            heights: self.texture(node, &id, Quantity::Height)?,
            scale: self.number(fields, name, "scale", Quantity::SignedFactor, 1.0)?,
            nested: self.nested(fields, name)?,
            limits: normal_limits(fields)?,
        })
    }
}

fn normal_limits(fields: &Fields) -> Result<NormalLimits, Problem> {
    Ok(NormalLimits {
        flip_invalid: fields.boolean("flip_invalid_normals", true)?,
        shadowing: fields.boolean("use_shadowing_function", true)?,
    })
}
