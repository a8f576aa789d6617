//! Materials, one function per plugin or two that are alike.

use capwalk_math::Rgb;
use capwalk_scene::BsdfId;
use capwalk_scene::bsdf::{Coat, Facets, Glass, Metal, NormalLimits};
use capwalk_scene::lobe::Distribution;
use capwalk_scene::{Bsdf, Material, Quantity, Texture, TextureId};

use super::lowering::Lowering;
use super::metals;
use super::texture::choice;
use crate::fields::{Child, Fields};
use crate::node::{Kind, NodeId, PropertyValue};
use crate::problem::Problem;
use crate::suggest::nearest;
use crate::texts::Span;

/// Values of `type` that are read.
const BSDFS: [&str; 20] = [
    "diffuse",
    "conductor",
    "roughconductor",
    "dielectric",
    "roughdielectric",
    "thindielectric",
    "plastic",
    "roughplastic",
    "pplastic",
    "principled",
    "principledthin",
    "null",
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
const REFUSED: [(&str, &str); 10] = [
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
        "difftrans",
        "write <bsdf type=\"principledthin\"> with diff_trans",
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

/// Refractive indices by name (Mitsuba's `ior.h`, after Hecht's "Optics").
const INDICES: [(&str, f64); 23] = [
    ("vacuum", 1.0),
    ("helium", 1.000036),
    ("hydrogen", 1.000132),
    ("air", 1.000277),
    ("carbon dioxide", 1.00045),
    ("water", 1.333),
    ("acetone", 1.36),
    ("ethanol", 1.361),
    ("carbon tetrachloride", 1.461),
    ("glycerol", 1.4729),
    ("benzene", 1.501),
    ("silicone oil", 1.52045),
    ("bromine", 1.661),
    ("water ice", 1.31),
    ("fused quartz", 1.458),
    ("pyrex", 1.47),
    ("acrylic glass", 1.49),
    ("polypropylene", 1.49),
    ("bk7", 1.5046),
    ("sodium chloride", 1.544),
    ("amber", 1.55),
    ("pet", 1.575),
    ("diamond", 2.419),
];

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
        Ok(match fields.node.plugin.as_str() {
            "diffuse" => Bsdf::Diffuse {
                reflectance: self.slot(fields, name, "reflectance", Quantity::Reflectance, 0.5)?,
            },
            "conductor" => Bsdf::Conductor(self.metal(fields, name)?),
            "roughconductor" => {
                let facets = self.facets(fields, name)?;
                Bsdf::RoughConductor(self.metal(fields, name)?, facets)
            }
            "dielectric" => Bsdf::Dielectric(self.glass(fields, name, true)?),
            "thindielectric" => Bsdf::ThinDielectric(self.glass(fields, name, false)?),
            "roughdielectric" => {
                let facets = self.facets(fields, name)?;
                Bsdf::RoughDielectric(self.glass(fields, name, false)?, facets)
            }
            "plastic" => Bsdf::Plastic(self.coat(fields, name)?),
            "roughplastic" => {
                let distribution = distribution(fields)?;
                let alpha = self.number(fields, name, "alpha", Quantity::Roughness, 0.1)?;
                Bsdf::RoughPlastic {
                    coat: self.coat(fields, name)?,
                    distribution,
                    alpha,
                }
            }
            "pplastic" => self.polarized_plastic(fields, name)?,
            "principled" => Bsdf::Principled(self.principled(fields, name)?),
            "principledthin" => Bsdf::PrincipledThin(self.principled_thin(fields, name)?),
            "null" => Bsdf::Null,
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
            _ => return Err(fields.refused_plugin(&BSDFS, &REFUSED)),
        })
    }

    /// The material of a shape without one: grey, or black if it emits.
    pub(super) fn default_bsdf(&mut self, name: &str, emits: bool, shape: Span) -> BsdfId {
        let name = self.material_name(None, name);
        let reflectance = Rgb::splat(if emits { 0.0 } else { 0.5 });
        let texture = Texture::colour(format!("{name}.reflectance"), reflectance);
        let reflectance = self.add_texture(texture, shape);
        self.places.materials.push(shape);
        self.add_material(name, Bsdf::Diffuse { reflectance })
    }

    fn add_material(&mut self, id: String, bsdf: Bsdf) -> BsdfId {
        self.materials.push(Material { id, bsdf });
        BsdfId(self.materials.len() as u32 - 1)
    }

    fn metal(&mut self, fields: &Fields, name: &str) -> Result<Metal, Problem> {
        fields.refuse(&["ext_eta"], &instead_of_surroundings(fields)?)?;
        let (mut eta, mut k) = (Rgb::zero(), Rgb::splat(1.0));
        match fields.string("material")? {
            None | Some("none") => {}
            Some(material) => {
                let span = fields.span_of("material");
                if fields.get("eta").or(fields.get("k")).is_some() {
                    let message = "both a material and its eta or k are given";
                    return Err(Problem::invalid(span, message).help("keep one of them"));
                }
                (eta, k) = metals::metal(material).ok_or_else(|| {
                    Problem::unknown(span, format!("there is no material \"{material}\""))
                        .help("expected a symbol such as Au, Ag, Al, Cu or Cr, or none")
                        .near(nearest(material, metals::names()))
                })?;
            }
        }
        Ok(Metal {
            eta: self.colour_slot(fields, name, "eta", Quantity::MetalIndex, eta)?,
            k: self.colour_slot(fields, name, "k", Quantity::Extinction, k)?,
            specular_reflectance: self.factor(fields, name, "specular_reflectance")?,
        })
    }

    pub(super) fn factor(
        &mut self,
        fields: &Fields,
        name: &str,
        slot: &'static str,
    ) -> Result<TextureId, Problem> {
        self.slot(fields, name, slot, Quantity::Reflectance, 1.0)
    }

    pub(super) fn facets(&mut self, fields: &Fields, name: &str) -> Result<Facets, Problem> {
        let distribution = distribution(fields)?;
        fields.cosmetic(&["sample_visible"], "visible facets are always sampled");
        let roughness = Quantity::Roughness;
        let given = |slot| fields.get(slot).is_some();
        let alpha = match (given("alpha_u"), given("alpha_v")) {
            (false, false) => [self.number(fields, name, "alpha", roughness, 0.1)?; 2],
            (true, true) if !given("alpha") => [
                self.number(fields, name, "alpha_u", roughness, 0.1)?,
                self.number(fields, name, "alpha_v", roughness, 0.1)?,
            ],
            _ => {
                let span = match given("alpha_u") {
                    true => fields.span_of("alpha_u"),
                    false => fields.span_of("alpha_v"),
                };
                let message = "the roughness is given in part, or twice";
                return Err(
                    Problem::invalid(span, message).help("give alpha, or both alpha_u and alpha_v")
                );
            }
        };
        Ok(Facets {
            distribution,
            alpha,
        })
    }

    fn glass(&mut self, fields: &Fields, name: &str, bends: bool) -> Result<Glass, Problem> {
        let quantity = Quantity::RefractiveIndex { bends };
        Ok(Glass {
            int_ior: self.index(fields, name, "int_ior", quantity, "bk7")?,
            ext_ior: self.index(fields, name, "ext_ior", quantity, "air")?,
            specular_reflectance: self.factor(fields, name, "specular_reflectance")?,
            specular_transmittance: self.factor(fields, name, "specular_transmittance")?,
        })
    }

    fn coat(&mut self, fields: &Fields, name: &str) -> Result<Coat, Problem> {
        let quantity = Quantity::RefractiveIndex { bends: false };
        fields.cosmetic(&["sample_visible"], "visible facets are always sampled");
        let diffuse = Quantity::Reflectance;
        Ok(Coat {
            int_ior: self.index(fields, name, "int_ior", quantity, "polypropylene")?,
            ext_ior: self.index(fields, name, "ext_ior", quantity, "air")?,
            diffuse_reflectance: self.slot(fields, name, "diffuse_reflectance", diffuse, 0.5)?,
            specular_reflectance: self.factor(fields, name, "specular_reflectance")?,
            nonlinear: fields.boolean("nonlinear", false)?,
        })
    }

    /// A refractive index, as a number or by name.
    pub(super) fn index(
        &mut self,
        fields: &Fields,
        name: &str,
        slot: &'static str,
        quantity: Quantity,
        default: &str,
    ) -> Result<TextureId, Problem> {
        let by_name = |wanted: &str| {
            let mut known = INDICES.iter();
            let found = known.find(|(name, _)| *name == wanted.to_lowercase());
            found.map(|&(_, index)| index)
        };
        let default = by_name(default).expect("defaults are in the table");
        let span = fields.span_of(slot);
        if let Some(property) = fields.get(slot)
            && let PropertyValue::String(wanted) = &property.value
        {
            let names = INDICES.iter().map(|(name, _)| *name);
            let index = by_name(wanted).ok_or_else(|| {
                Problem::unknown(
                    span,
                    format!("there is no refractive index of \"{wanted}\""),
                )
                .help("expected a number, or a name such as bk7, water or diamond")
                .near(nearest(wanted, names))
            })?;
            let texture = Texture::number(format!("{name}.{slot}"), index);
            return Ok(self.add_texture(texture, span));
        }
        let texture = self.number(fields, name, slot, quantity, default)?;
        match self.textures[texture.0 as usize].is_constant() {
            true => Ok(texture),
            false => Err(
                Problem::unsupported(span, format!("\"{slot}\" is a texture"))
                    .help("a refractive index is the same everywhere; expected a number or a name"),
            ),
        }
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

/// What to do about what is around a metal and is not air.
fn instead_of_surroundings(fields: &Fields) -> Result<String, Problem> {
    let shown = |c: Rgb| format!("{:.5}, {:.5}, {:.5}", c.r, c.g, c.b);
    Ok(match fields.string("material")?.and_then(metals::metal) {
        None => "around metals is air; divide eta and k by it, and remove it".into(),
        Some((eta, k)) => format!(
            "around metals is air; remove it and the material, and write <rgb name=\"eta\" \
             value=\"{}\"/> and <rgb name=\"k\" value=\"{}\"/>, with all six numbers divided \
             by it",
            shown(eta),
            shown(k)
        ),
    })
}

fn distribution(fields: &Fields) -> Result<Distribution, Problem> {
    Ok(
        match choice(fields, "distribution", &["beckmann", "ggx"])? {
            "ggx" => Distribution::Ggx,
            _ => Distribution::Beckmann,
        },
    )
}

fn normal_limits(fields: &Fields) -> Result<NormalLimits, Problem> {
    Ok(NormalLimits {
        flip_invalid: fields.boolean("flip_invalid_normals", true)?,
        shadowing: fields.boolean("use_shadowing_function", true)?,
    })
}
