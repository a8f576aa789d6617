//! Filters for polarized light, as they are to unpolarized light.

use capwalk_scene::lobe::ThinDielectric;
use capwalk_scene::number::Indices;
use capwalk_scene::{Bsdf, Quantity, Texture, TextureId};

use super::lowering::Lowering;
use crate::fields::Fields;
use crate::problem::Problem;

impl Lowering<'_> {
    /// A filter for polarized light, to unpolarized light: a pane that reflects nothing and lets
    /// `fraction` of its transmittance pass.
    pub(super) fn polarization_filter(
        &mut self,
        fields: &Fields,
        name: &str,
        fraction: f64,
    ) -> Result<Bsdf, Problem> {
        let reason = "polarization is not computed";
        fields.cosmetic(&["theta", "delta", "polarizing", "left_handed"], reason);
        fields.warn(&format!(
            "{reason}: as in Mitsuba's unpolarized variants, {fraction} of the light passes; it \
             is read as a thindielectric"
        ));
        let quantity = Quantity::Transmittance;
        let given = self.slot(fields, name, "transmittance", quantity, 1.0)?;
        let transmittance = self.scaled(fields, name, given, fraction)?;
        let span = fields.span_of("transmittance");
        let mut one = |slot| {
            let texture = Texture::number(format!("{name}.{slot}"), 1.0);
            self.add_texture(texture, span)
        };
        let pane = ThinDielectric {
            eta: Indices {
                int_ior: one("int_ior"),
                ext_ior: one("ext_ior"),
            },
            specular_reflectance: one("specular_reflectance"),
            specular_transmittance: transmittance,
        };
        Ok(pane.into())
    }

    /// The texture that was read for the transmittance of a filter, times `fraction`. That of
    /// others would have to be copied, and its own numbers would have no effect on the filter.
    fn scaled(
        &mut self,
        fields: &Fields,
        name: &str,
        given: TextureId,
        fraction: f64,
    ) -> Result<TextureId, Problem> {
        let span = fields.span_of("transmittance");
        let texture = &self.textures[given.0 as usize];
        let is_last = given.0 as usize + 1 == self.textures.len();
        let is_own = is_last && texture.id == format!("{name}.transmittance");
        if fraction == 1.0 && !is_own {
            return Ok(given);
        }
        if texture.data.is_empty() {
            let message = "\"transmittance\" is an attribute of meshes";
            return Err(Problem::unsupported(span, message).help("expected a color or a bitmap"));
        }
        if !is_own {
            let message = format!(
                "\"transmittance\" is the texture \"{}\", which others may use",
                texture.id
            );
            return Err(Problem::unsupported(span, message).help(format!(
                "give it a texture of its own without an id: {fraction} of the texels is what passes"
            )));
        }
        let mut own = self.textures.pop().expect("it is the last");
        own.id = format!("{name}.specular_transmittance");
        own.data.iter_mut().for_each(|x| *x *= fraction);
        Ok(self.add_texture(own, span))
    }
}
