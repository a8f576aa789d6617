//! The fields of materials, read by their declarations.

use capwalk_math::Rgb;
use capwalk_scene::fields::{FieldReader, WithoutEffect};
use capwalk_scene::lobe::{Distribution, Microfacets};
use capwalk_scene::number::{Indices, PrincipledIndex};
use capwalk_scene::{Quantity, Texture, TextureId};

use super::lowering::Lowering;
use super::metals;
use super::texture::choice;
use crate::fields::Fields;
use crate::node::PropertyValue;
use crate::problem::Problem;
use crate::suggest::nearest;

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

/// The fields of the material `name`.
pub(super) struct Reading<'l, 'a, 'f> {
    pub lowering: &'l mut Lowering<'a>,
    pub fields: &'f Fields<'f>,
    pub name: &'f str,
}

impl FieldReader for Reading<'_, '_, '_> {
    type Error = Problem;

    fn without_effect(&mut self, properties: WithoutEffect) {
        self.fields.cosmetic(properties.names, properties.reason);
    }

    fn colour(
        &mut self,
        name: &'static str,
        quantity: Quantity,
        default: f64,
    ) -> Result<TextureId, Problem> {
        let default = match quantity {
            Quantity::MetalIndex => self.metal()?.map(|(eta, _)| eta),
            Quantity::Extinction => self.metal()?.map(|(_, k)| k),
            _ => None,
        }
        .unwrap_or(Rgb::splat(default));
        self.lowering
            .colour_slot(self.fields, self.name, name, quantity, default)
    }

    fn number(
        &mut self,
        name: &'static str,
        quantity: Quantity,
        default: f64,
    ) -> Result<TextureId, Problem> {
        self.lowering
            .number(self.fields, self.name, name, quantity, default)
    }

    fn indices(
        &mut self,
        _: &'static str,
        quantity: Quantity,
        inside: &'static str,
        outside: &'static str,
    ) -> Result<Indices, Problem> {
        Ok(Indices {
            int_ior: self.index_of("int_ior", quantity, inside)?,
            ext_ior: self.index_of("ext_ior", quantity, outside)?,
        })
    }

    fn index(&mut self, name: &'static str, specular: f64) -> Result<PrincipledIndex, Problem> {
        match (self.fields.get(name), self.fields.get("specular")) {
            (Some(_), Some(specular)) => {
                let message = format!("both \"{name}\" and \"specular\" are given");
                Err(Problem::invalid(specular.name_span, message).help("keep one of them"))
            }
            (Some(_), None) => {
                let quantity = Quantity::RefractiveIndex { bends: false };
                self.number(name, quantity, 1.5).map(PrincipledIndex::Eta)
            }
            (None, _) => self
                .number("specular", Quantity::Fraction, specular)
                .map(PrincipledIndex::Specular),
        }
    }

    fn facets(&mut self, _: &'static str, alpha: f64) -> Result<Microfacets<TextureId>, Problem> {
        let distribution = self.distribution("distribution")?;
        let given = |slot| self.fields.get(slot).is_some();
        let (u, v) = (given("alpha_u"), given("alpha_v"));
        if u != v || u && given("alpha") {
            let span = self.fields.span_of(if u { "alpha_u" } else { "alpha_v" });
            let message = "the roughness is given in part, or twice";
            let help = "give alpha, or both alpha_u and alpha_v";
            return Err(Problem::invalid(span, message).help(help));
        }
        let mut roughness = |slot| self.number(slot, Quantity::Roughness, alpha);
        Ok(if u {
            Microfacets {
                distribution,
                alpha_u: roughness("alpha_u")?,
                alpha_v: roughness("alpha_v")?,
            }
        } else {
            Microfacets::isotropic(distribution, roughness("alpha")?)
        })
    }

    fn distribution(&mut self, name: &'static str) -> Result<Distribution, Problem> {
        let names = Distribution::ALL.map(Distribution::name);
        let wanted = choice(self.fields, name, &names)?;
        let mut all = Distribution::ALL.into_iter();
        let found = all.find(|distribution| distribution.name() == wanted);
        Ok(found.expect("one of the names"))
    }

    fn flag(&mut self, name: &'static str, default: bool) -> Result<bool, Problem> {
        self.fields.boolean(name, default)
    }
}

impl Reading<'_, '_, '_> {
    /// A refractive index that is the same everywhere, as a number or by name.
    fn index_of(
        &mut self,
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
        let span = self.fields.span_of(slot);
        if let Some(property) = self.fields.get(slot)
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
            let texture = Texture::number(format!("{}.{slot}", self.name), index);
            return Ok(self.lowering.add_texture(texture, span));
        }
        let texture = self.number(slot, quantity, default)?;
        match self.lowering.textures[texture.0 as usize].is_constant() {
            true => Ok(texture),
            false => Err(
                Problem::unsupported(span, format!("\"{slot}\" is a texture"))
                    .help("a refractive index is the same everywhere; expected a number or a name"),
            ),
        }
    }

    /// Refractive index and extinction of the metal that is named, if one is.
    fn metal(&self) -> Result<Option<(Rgb, Rgb)>, Problem> {
        let fields = self.fields;
        let named = fields.string("material")?;
        let found = named.and_then(metals::metal);
        fields.refuse(&["ext_eta"], &instead_of_surroundings(found))?;
        let Some(material) = named.filter(|&name| name != "none") else {
            return Ok(None);
        };
        let span = fields.span_of("material");
        if fields.get("eta").or(fields.get("k")).is_some() {
            let message = "both a material and its eta or k are given";
            return Err(Problem::invalid(span, message).help("keep one of them"));
        }
        if found.is_none() {
            let message = format!("there is no material \"{material}\"");
            return Err(Problem::unknown(span, message)
                .help("expected a symbol such as Au, Ag, Al, Cu or Cr, or none")
                .near(nearest(material, metals::names())));
        }
        Ok(found)
    }
}

/// What to do about what is around a metal and is not air.
fn instead_of_surroundings(metal: Option<(Rgb, Rgb)>) -> String {
    let shown = |c: Rgb| format!("{:.5}, {:.5}, {:.5}", c.r, c.g, c.b);
    match metal {
        None => "around metals is air; divide eta and k by it, and remove it".into(),
        Some((eta, k)) => format!(
            "around metals is air; remove it and the material, and write <rgb name=\"eta\" \
             value=\"{}\"/> and <rgb name=\"k\" value=\"{}\"/>, with all six numbers divided \
             by it",
            shown(eta),
            shown(k)
        ),
    }
}
