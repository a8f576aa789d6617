//! Textures: one colour or number, `bitmap`, `checkerboard`, `mesh_attribute`; `gltf_texture` has
//! a file of its own.

use capwalk_math::{Affine, Rgb};
use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
use capwalk_scene::{Pattern, Quantity, Texture, TextureId};

use super::colour::is_light;
use super::lowering::Lowering;
use super::spectrum_plugin::{SPECTRA, depends_on_use};
use crate::bitmap::{self, BitmapFile, BitmapUse, Channels};
use crate::fields::Fields;
use crate::node::{Kind, NodeId, Property, PropertyValue, Spectrum};
use crate::problem::Problem;
use crate::texts::Span;

/// Values of `type` that are read, besides those of spectra.
const TEXTURES: [&str; 4] = ["bitmap", "checkerboard", "mesh_attribute", "gltf_texture"];

/// Textures that are not read, and what to do instead.
const REFUSED: [(&str, &str); 1] = [(
    "volume",
    "colours are not looked up in space; write <texture type=\"mesh_attribute\"> or \
     <texture type=\"bitmap\">",
)];

/// How deep spectra and textures may stand in spectra.
const MAX_DEPTH: usize = 8;

/// A checkerboard that is used for a number is another one in Mitsuba.
const SWAPPED: &str = "is a checkerboard of numbers, whose squares Mitsuba 3.9 exchanges: its image is \
                       that of \"color0\" and \"color1\" in each other's place";

impl Lowering<'_> {
    /// What stands in a slot of an object called `holder`: a texture, or one
    /// colour, which is grey by default.
    pub(super) fn slot(
        &mut self,
        fields: &Fields,
        holder: &str,
        slot: &'static str,
        quantity: Quantity,
        default: f64,
    ) -> Result<TextureId, Problem> {
        self.colour_slot(fields, holder, slot, quantity, Rgb::splat(default))
    }

    /// The same with a colour as its default.
    pub(super) fn colour_slot(
        &mut self,
        fields: &Fields,
        holder: &str,
        slot: &'static str,
        quantity: Quantity,
        default: Rgb,
    ) -> Result<TextureId, Problem> {
        let id = format!("{holder}.{slot}");
        if let Some(property) = fields.get(slot)
            && let PropertyValue::Object { node, .. } = property.value
            && self.context.graph.node(node).kind == Kind::Texture
        {
            return self.texture(node, &id, quantity);
        }
        let colour = self.colour(fields, slot, quantity, default)?;
        Ok(self.add_texture(Texture::colour(id, colour), fields.span_of(slot)))
    }

    /// What stands in a slot for a number: a texture, or one number. A colour
    /// counts as its luminance.
    pub(super) fn number(
        &mut self,
        fields: &Fields,
        holder: &str,
        slot: &'static str,
        quantity: Quantity,
        default: f64,
    ) -> Result<TextureId, Problem> {
        let id = format!("{holder}.{slot}");
        let span = fields.span_of(slot);
        let texture = match fields.get(slot).map(|property| &property.value) {
            None => Texture::number(id, default),
            Some(&PropertyValue::Float(x)) => Texture::number(id, x),
            Some(&PropertyValue::Integer(i)) => Texture::number(id, i as f64),
            Some(&PropertyValue::Spectrum(Spectrum::Uniform(x))) => Texture::number(id, x),
            Some(PropertyValue::Rgb(_) | PropertyValue::Spectrum(_)) => {
                let colour = self.colour(fields, slot, quantity, Rgb::splat(default))?;
                Texture::colour(id, colour)
            }
            Some(&PropertyValue::Object { node, .. }) => {
                if self.context.graph.node(node).plugin == "checkerboard" {
                    fields.warn_at(slot, SWAPPED);
                }
                return self.slot(fields, holder, slot, quantity, default);
            }
            Some(other) => {
                let message = format!("\"{slot}\" is a <{}>", other.tag());
                let help = format!("expected <float name=\"{slot}\" .../> or a <texture>");
                return Err(Problem::invalid(span, message).help(help));
            }
        };
        // Out of its range it is an error of the finished scene.
        Ok(self.add_texture(texture, span))
    }

    /// The texture of a node, made when it is first met. `otherwise` names it
    /// if it has no id; `quantity` is what its colours are.
    pub(super) fn texture(
        &mut self,
        node: NodeId,
        otherwise: &str,
        quantity: Quantity,
    ) -> Result<TextureId, Problem> {
        let fields = Fields::new(self.context, node);
        if let Some(&(known, before)) = self.texture_of_node.get(&node) {
            if is_light(before) != is_light(quantity) && depends_on_use(&fields.node.plugin) {
                let message = "the spectrum is both light and what a surface does to light";
                return Err(Problem::invalid(fields.node.span, message)
                    .help("write it twice: its color under daylight is another"));
            }
            return Ok(known);
        }
        if self.texture_depth > MAX_DEPTH {
            let message = "textures stand inside each other too deep";
            return Err(Problem::unsupported(fields.node.span, message)
                .help(format!("expected at most {MAX_DEPTH} inside each other")));
        }
        let id = fields.node.id.clone().unwrap_or_else(|| otherwise.into());
        let (texture, span) = match fields.node.plugin.as_str() {
            plugin if SPECTRA.contains(&plugin) => {
                self.texture_depth += 1;
                let texture = self.spectrum_plugin(&fields, &id, quantity)?;
                self.texture_depth -= 1;
                fields.finish()?;
                self.texture_of_node.insert(node, (texture, quantity));
                return Ok(texture);
            }
            "bitmap" => self.bitmap(&fields, id)?,
            "gltf_texture" => self.gltf_texture(&fields, id)?,
            "checkerboard" => (self.checkerboard(&fields, id, quantity)?, fields.node.span),
            "mesh_attribute" => (mesh_attribute(&fields, id)?, fields.span_of("name")),
            _ => return Err(fields.refused_plugin(&[&TEXTURES[..], &SPECTRA].concat(), &REFUSED)),
        };
        fields.finish()?;
        let texture = self.add_texture(texture, span);
        self.texture_of_node.insert(node, (texture, quantity));
        Ok(texture)
    }

    fn bitmap(&mut self, fields: &Fields, id: String) -> Result<(Texture, Span), Problem> {
        let filter = match choice(fields, "filter_type", &["bilinear", "nearest"])? {
            "nearest" => TexelFilter::Nearest,
            _ => TexelFilter::Bilinear,
        };
        let wrap = match choice(fields, "wrap_mode", &["repeat", "mirror", "clamp"])? {
            "mirror" => Wrap::Mirror,
            "clamp" => Wrap::Clamp,
            _ => Wrap::Repeat,
        };
        fields.refuse(
            &["gamma"],
            "write raw = true for texels as they are (gamma 1), and raw = false for sRGB (-1); \
             convert images with other curves",
        )?;
        let raw = fields.boolean("raw", false)?;
        let to_uv = uv_transform(fields)?;
        let reason = "texels are kept in double precision";
        fields.cosmetic(&["format", "accel"], reason);
        let example = "add <string name=\"filename\" value=\"texture.png\"/>";
        let (file, span) = self.image(fields, raw, BitmapUse::Texture, example)?;
        let texture = Texture {
            id,
            channels: file.channels,
            data: file.data,
            pattern: Pattern::Bitmap(Bitmap {
                width: file.width,
                height: file.height,
                filter,
                wrap,
                to_uv,
            }),
        };
        Ok((texture, span))
    }

    /// The image that `filename` names, and where it is named.
    pub(super) fn image(
        &self,
        fields: &Fields,
        raw: bool,
        becomes: BitmapUse,
        example: &str,
    ) -> Result<(BitmapFile, Span), Problem> {
        let (bytes, path, span) = self.file(fields, example)?;
        let ending = path.extension().and_then(|ending| ending.to_str());
        let ending = ending.unwrap_or("").to_ascii_lowercase();
        let file =
            bitmap::read(&bytes, &ending, raw, Channels::Colour, becomes).map_err(|error| {
                let shown = path.display();
                Problem::image(span, format!("cannot read \"{shown}\": {error}")).help(format!(
                    "give an image file that ends in {}",
                    bitmap::ENDINGS.join(", ")
                ))
            })?;
        Ok((file, span))
    }

    fn checkerboard(
        &mut self,
        fields: &Fields,
        id: String,
        quantity: Quantity,
    ) -> Result<Texture, Problem> {
        let mut data = Vec::with_capacity(6);
        for (slot, default) in [("color0", 0.4), ("color1", 0.2)] {
            if let Some(property) = fields.get(slot)
                && matches!(property.value, PropertyValue::Object { .. })
            {
                return Err(Problem::invalid(
                    property.value_span,
                    format!("\"{slot}\" of a checkerboard is a texture"),
                )
                .help(format!("expected one colour, <rgb name=\"{slot}\" .../>")));
            }
            let quantity = quantity_in_texture(fields.get(slot), quantity);
            let colour = self.colour(fields, slot, quantity, Rgb::splat(default))?;
            data.extend(colour.to_array());
        }
        Ok(Texture {
            id,
            channels: 3,
            data,
            pattern: Pattern::Checkerboard {
                to_uv: uv_transform(fields)?,
            },
        })
    }
}

/// What a colour is that stands in a texture for this quantity: spectra are reflectances, as in
/// Mitsuba, also where the texture is light. Other colours of light may be above 1.
fn quantity_in_texture(property: Option<&Property>, quantity: Quantity) -> Quantity {
    match property.map(|property| &property.value) {
        Some(PropertyValue::Spectrum(Spectrum::Sampled(_) | Spectrum::File(_))) => {
            Quantity::Reflectance
        }
        _ if is_light(quantity) => Quantity::Factor,
        _ => quantity,
    }
}

fn mesh_attribute(fields: &Fields, id: String) -> Result<Texture, Problem> {
    let name = fields.string("name")?.unwrap_or("");
    if !name.starts_with("vertex_") && !name.starts_with("face_") {
        let span = fields.span_of("name");
        return Err(
            Problem::invalid(span, format!("\"{name}\" is not the name of an attribute")).help(
                "expected <string name=\"name\" value=\"vertex_color\"/>, or another name that \
                 begins with vertex_ or face_",
            ),
        );
    }
    Ok(Texture {
        id,
        channels: 3,
        data: Vec::new(),
        pattern: Pattern::MeshAttribute {
            name: name.into(),
            scale: fields.float("scale", 1.0)?,
        },
    })
}

/// One of several words; the first if none is given.
pub(super) fn choice<'a>(
    fields: &Fields<'a>,
    name: &'static str,
    words: &[&'a str],
) -> Result<&'a str, Problem> {
    match fields.string(name)? {
        None => Ok(words[0]),
        Some(given) if words.contains(&given) => Ok(given),
        Some(given) => Err(Problem::invalid(
            fields.span_of(name),
            format!("\"{name}\" is \"{given}\""),
        )
        .help(format!("expected {}", words.join(", ")))
        .near(crate::suggest::nearest(given, words.iter().copied()))),
    }
}

pub(super) fn uv_transform(fields: &Fields) -> Result<UvTransform, Problem> {
    let affine = match fields.get("to_uv") {
        None => Affine::IDENTITY,
        Some(_) => fields.transform("to_uv")?,
    };
    Ok(UvTransform::from_affine(&affine))
}
