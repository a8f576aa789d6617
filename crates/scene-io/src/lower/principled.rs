//! The principled materials.

use capwalk_scene::Quantity;
use capwalk_scene::bsdf::{PrincipledIndex, PrincipledTextures, ThinTextures};

use super::lowering::Lowering;
use crate::fields::Fields;
use crate::problem::Problem;

/// Why sampling rates have no effect.
const SAMPLING_RATES: &str = "directions are chosen by our own rule; the mean is the same";

impl Lowering<'_> {
    pub(super) fn principled(
        &mut self,
        fields: &Fields,
        name: &str,
    ) -> Result<PrincipledTextures, Problem> {
        let rates = [
            "main_specular_sampling_rate",
            "clearcoat_sampling_rate",
            "diffuse_reflectance_sampling_rate",
        ];
        fields.cosmetic(&rates, SAMPLING_RATES);
        let base_color = self.slot(fields, name, "base_color", Quantity::Reflectance, 0.5)?;
        let index = match (fields.get("eta"), fields.get("specular")) {
            (Some(_), Some(specular)) => {
                let message = "both \"eta\" and \"specular\" are given";
                return Err(Problem::invalid(specular.name_span, message).help("keep one of them"));
            }
            (Some(_), None) => {
                let quantity = Quantity::RefractiveIndex { bends: false };
                PrincipledIndex::Eta(self.number(fields, name, "eta", quantity, 1.5)?)
            }
            (None, _) => {
                let quantity = Quantity::Fraction;
                PrincipledIndex::Specular(self.number(fields, name, "specular", quantity, 0.5)?)
            }
        };
        let mut fraction =
            |slot, default| self.number(fields, name, slot, Quantity::Fraction, default);
        Ok(PrincipledTextures {
            base_color,
            index,
            roughness: fraction("roughness", 0.5)?,
            anisotropic: fraction("anisotropic", 0.0)?,
            metallic: fraction("metallic", 0.0)?,
            spec_trans: fraction("spec_trans", 0.0)?,
            spec_tint: fraction("spec_tint", 0.0)?,
            sheen: fraction("sheen", 0.0)?,
            sheen_tint: fraction("sheen_tint", 0.0)?,
            flatness: fraction("flatness", 0.0)?,
            clearcoat: fraction("clearcoat", 0.0)?,
            clearcoat_gloss: fraction("clearcoat_gloss", 0.0)?,
        })
    }

    pub(super) fn principled_thin(
        &mut self,
        fields: &Fields,
        name: &str,
    ) -> Result<ThinTextures, Problem> {
        let rates = [
            "specular_reflectance_sampling_rate",
            "specular_transmittance_sampling_rate",
            "diffuse_transmittance_sampling_rate",
            "diffuse_reflectance_sampling_rate",
        ];
        fields.cosmetic(&rates, SAMPLING_RATES);
        let base_color = self.slot(fields, name, "base_color", Quantity::Reflectance, 0.5)?;
        let index = Quantity::RefractiveIndex { bends: false };
        let eta = self.number(fields, name, "eta", index, 1.5)?;
        let twice = Quantity::TwiceFraction;
        let diff_trans = self.number(fields, name, "diff_trans", twice, 0.0)?;
        let mut fraction =
            |slot, default| self.number(fields, name, slot, Quantity::Fraction, default);
        Ok(ThinTextures {
            base_color,
            roughness: fraction("roughness", 0.5)?,
            anisotropic: fraction("anisotropic", 0.0)?,
            spec_trans: fraction("spec_trans", 0.0)?,
            eta,
            spec_tint: fraction("spec_tint", 0.0)?,
            sheen: fraction("sheen", 0.0)?,
            sheen_tint: fraction("sheen_tint", 0.0)?,
            flatness: fraction("flatness", 0.0)?,
            diff_trans,
        })
    }
}
