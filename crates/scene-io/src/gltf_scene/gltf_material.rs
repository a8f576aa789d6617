//! Materials: metallic-roughness as `principled`, what lies around it, and what emits.

use capwalk_math::{Affine, Rgb, Vec3};
use gltf::Semantic;
use gltf::json::material::{AlphaMode, Material};
use gltf::json::validation::Checked;

use super::gltf_extension::not_read;
use super::graph_builder::{GraphBuilder, PrimitiveSurface, Radiance};
use crate::mesh::{MeshFileError, shown_name, unsupported};
use crate::node::{Kind, NodeId, PropertyValue};

/// Extensions of materials that are read.
const READ: [&str; 5] = [
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_volume",
];

/// Extensions of materials that change nothing while a number is 0, which it is by default.
const WITHOUT_EFFECT_AT_ZERO: [(&str, &str); 6] = [
    ("KHR_materials_anisotropy", "anisotropyStrength"),
    ("KHR_materials_clearcoat", "clearcoatFactor"),
    (
        "KHR_materials_diffuse_transmission",
        "diffuseTransmissionFactor",
    ),
    ("KHR_materials_dispersion", "dispersion"),
    ("KHR_materials_iridescence", "iridescenceFactor"),
    ("KHR_materials_sheen", "sheenColorFactor"),
];

/// What to do about a material that cannot be read.
const BY_HAND: &str = "show the mesh in a scene of Mitsuba's XML, by <shape type=\"gltf\">, with a \
                       material written there";

/// A texture as a material names it.
struct TextureUse {
    index: usize,
    /// Which texture coordinates, without those that a transform chooses.
    coordinates: u32,
    /// Where the material names it.
    place: String,
}

/// What is taken of the texels, and what becomes of it.
#[derive(Clone, Copy)]
enum Texels {
    /// Colours encoded as sRGB, times a factor.
    Colour([f64; 3]),
    /// A channel from 0 on, times a factor.
    Number(&'static str, f64),
    /// Normals whose first two numbers are scaled.
    Normal(f64),
    /// Opacities times a factor; below a limit 0 and above it 1, if there is one.
    Opacity(f64, Option<f64>),
}

impl GraphBuilder<'_> {
    /// What a primitive is made of.
    pub(super) fn surface(
        &mut self,
        primitive: &gltf::Primitive,
    ) -> Result<PrimitiveSurface, MeshFileError> {
        let material = primitive.material();
        let colours = primitive.get(&Semantic::Colors(0));
        let key = (material.index(), colours.is_some());
        if let Some(&known) = self.surfaces.get(&key) {
            return Ok(known);
        }
        let json = self.file.document.as_json();
        let default = Material::default();
        let given = material
            .index()
            .map_or(&default, |index| &json.materials[index]);
        let place = material.index().map(|index| format!("materials[{index}]."));
        let reader = MaterialReader {
            line: self.line_of_material(material.index()),
            name: shown_name(given.name.as_deref()).map(str::to_owned),
            // Nothing stands there: everything is the default.
            place: place.unwrap_or("materials.".to_owned()),
            given,
            has_colours: colours.is_some(),
            builder: self,
        };
        let surface = reader.read()?;
        self.surfaces.insert(key, surface);
        Ok(surface)
    }
}

/// Makes one material.
struct MaterialReader<'b, 'a> {
    builder: &'b mut GraphBuilder<'a>,
    given: &'b Material,
    name: Option<String>,
    line: usize,
    /// Where it stands, with a point behind it.
    place: String,
    /// True if vertices have colours.
    has_colours: bool,
}

impl MaterialReader<'_, '_> {
    fn read(mut self) -> Result<PrimitiveSurface, MeshFileError> {
        self.refuse_extensions()?;
        let is_clear = self.is_clear()?;
        let mut bsdf = self.principled(is_clear)?;
        if self.given.double_sided && !is_clear {
            let outer = self.add("twosided", "twosided");
            self.builder.put(outer, bsdf);
            bsdf = outer;
        } else if !is_clear {
            self.builder.one_sided.push(self.line);
        }
        // Around both sides: a hill of the front is a valley of the back.
        if let Some(normal) = &self.given.normal_texture {
            let texture = TextureUse {
                index: normal.index.value(),
                coordinates: normal.tex_coord,
                place: self.at("normalTexture"),
            };
            let scale = self.number("normalTexture.scale", 1.0)?;
            let normals = self.texture(texture, Texels::Normal(scale))?;
            bsdf = self.around(bsdf, "normalmap", "normalmap", normals);
        }
        let radiance = self.radiance()?;
        if let Some(opacity) = self.opacity()? {
            if radiance.is_some() {
                let message = "what is not opaque and emits light has no equal: an emitter has no \
                               opacity";
                return self.unsupported("alphaMode", message);
            }
            bsdf = self.around(bsdf, "mask", "opacity", opacity);
        }
        Ok(PrimitiveSurface { bsdf, radiance })
    }

    fn at(&self, key: &str) -> String {
        format!("{}{key}", self.place)
    }

    fn number(&self, key: &str, default: f64) -> Result<f64, MeshFileError> {
        self.builder.file.number(&self.at(key), default)
    }

    fn numbers<const N: usize>(&self, key: &str, default: f64) -> Result<[f64; N], MeshFileError> {
        self.builder.file.numbers(&self.at(key), [default; N])
    }

    /// An error at a property that it cannot be read.
    fn unsupported<T>(&self, key: &str, message: &str) -> Result<T, MeshFileError> {
        Err(unsupported(&self.at(key), message, BY_HAND))
    }

    /// A material of a type, which is called as the file's, with an ending.
    fn add(&mut self, plugin: &str, ending: &str) -> NodeId {
        let name = self.name.as_ref().map(|name| match ending {
            "" => name.clone(),
            _ => format!("{name}.{ending}"),
        });
        self.builder
            .add(Kind::Bsdf, plugin, name.as_deref(), self.line)
    }

    /// A material around another one.
    fn around(&mut self, inner: NodeId, plugin: &str, slot: &str, value: PropertyValue) -> NodeId {
        let outer = self.add(plugin, plugin);
        self.builder.set(outer, slot, value);
        self.builder.put(outer, inner);
        outer
    }

    fn refuse_extensions(&self) -> Result<(), MeshFileError> {
        let extensions = self.at("extensions");
        for name in self.builder.file.keys(&extensions) {
            let place = format!("{extensions}.{name}");
            let silent = WITHOUT_EFFECT_AT_ZERO
                .iter()
                .find(|(known, _)| *known == name);
            if let Some((_, number)) = silent {
                let value = self.builder.file.value(&format!("{place}.{number}"));
                let numbers = value.map(|value| match value.as_array() {
                    Some(list) => list.iter().all(|x| x.as_f64() == Some(0.0)),
                    None => value.as_f64() == Some(0.0),
                });
                if numbers.unwrap_or(true) {
                    continue;
                }
            } else if READ.contains(&name) {
                continue;
            }
            return Err(match name {
                "KHR_materials_unlit" => unsupported(
                    &place,
                    "an unlit material shows its colour whatever the light is",
                    "export it with emission, and black, in its place",
                ),
                _ if name.starts_with("KHR_materials_") => {
                    let message = "\"principled\" has nothing that is the same";
                    unsupported(&place, message, BY_HAND)
                }
                _ => not_read(&place, name),
            });
        }
        Ok(())
    }

    /// True if it is a solid that lets light through.
    fn is_clear(&self) -> Result<bool, MeshFileError> {
        let transmission = "extensions.KHR_materials_transmission";
        let volume = "extensions.KHR_materials_volume";
        let factor = self.number(&format!("{transmission}.transmissionFactor"), 0.0)?;
        if factor == 0.0 {
            return Ok(false);
        }
        let has = |key: String| self.builder.file.value(&self.at(&key)).is_some();
        if factor != 1.0 || has(format!("{transmission}.transmissionTexture")) {
            let message = "a surface that transmits light in part has no equal in \"principled\"";
            return self.unsupported(transmission, message);
        }
        if self.number(&format!("{volume}.thicknessFactor"), 0.0)? == 0.0 {
            let message = "a surface that transmits light and is thin has no equal in \
                           \"principled\"; a solid has KHR_materials_volume with a thickness";
            return self.unsupported(transmission, message);
        }
        let attenuation: [f64; 3] = self.numbers(&format!("{volume}.attenuationColor"), 1.0)?;
        if attenuation != [1.0; 3] && has(format!("{volume}.attenuationDistance")) {
            return self.unsupported(volume, "light is not absorbed on its way through solids");
        }
        if self.number("pbrMetallicRoughness.metallicFactor", 1.0)? != 0.0 {
            return self.unsupported(transmission, "a metal does not transmit light");
        }
        Ok(true)
    }

    /// The innermost material.
    fn principled(&mut self, is_clear: bool) -> Result<NodeId, MeshFileError> {
        let bsdf = self.add("principled", "");
        let base_color = self.base_color(is_clear)?;
        self.builder.set(bsdf, "base_color", base_color);
        let metallic = self.channel("metallic", "blue")?;
        self.builder.set(bsdf, "metallic", metallic);
        let roughness = self.channel("roughness", "green")?;
        self.builder.set(bsdf, "roughness", roughness);
        let (name, index) = self.index()?;
        self.builder.set(bsdf, name, PropertyValue::Float(index));
        if is_clear {
            self.builder
                .set(bsdf, "spec_trans", PropertyValue::Float(1.0));
        }
        Ok(bsdf)
    }

    fn base_color(&mut self, is_clear: bool) -> Result<PropertyValue, MeshFileError> {
        const KEY: &str = "pbrMetallicRoughness.baseColorTexture";
        let [r, g, b, _]: [f64; 4] = self.numbers("pbrMetallicRoughness.baseColorFactor", 1.0)?;
        let texture = self
            .given
            .pbr_metallic_roughness
            .base_color_texture
            .as_ref();
        let texture = texture.map(|info| self.use_of(info, KEY));
        match (texture, self.has_colours) {
            (None, false) => {
                // `principled` takes the root of it at each of two borders, glTF itself.
                let power = if is_clear { 2 } else { 1 };
                let colour = Rgb::new(r, g, b).map(|channel: f64| channel.powi(power));
                Ok(PropertyValue::Rgb(colour))
            }
            (Some(_), _) if is_clear => {
                self.unsupported(KEY, "what transmits light has one colour everywhere")
            }
            (Some(texture), false) => self.texture(texture, Texels::Colour([r, g, b])),
            (None, true) if r == g && g == b && !is_clear => {
                let line = self.line;
                let colours = self
                    .builder
                    .add(Kind::Texture, "mesh_attribute", None, line);
                let name = PropertyValue::String("vertex_color".into());
                self.builder.set(colours, "name", name);
                self.builder.set(colours, "scale", PropertyValue::Float(r));
                Ok(object(colours))
            }
            (_, true) => {
                let message = "the product of colours of vertices (COLOR_0) and another colour is \
                               not read; export one of them";
                self.unsupported("pbrMetallicRoughness", message)
            }
        }
    }

    /// A number that is the product of a factor and a channel of a texture.
    fn channel(
        &mut self,
        name: &str,
        channel: &'static str,
    ) -> Result<PropertyValue, MeshFileError> {
        let factor = self.number(&format!("pbrMetallicRoughness.{name}Factor"), 1.0)?;
        let texture = &self.given.pbr_metallic_roughness.metallic_roughness_texture;
        match texture.as_ref().filter(|_| factor != 0.0) {
            None => Ok(PropertyValue::Float(factor)),
            Some(info) => {
                let texture = self.use_of(info, "pbrMetallicRoughness.metallicRoughnessTexture");
                self.texture(texture, Texels::Number(channel, factor))
            }
        }
    }

    /// The refractive index, or the reflection at a right angle in its place.
    fn index(&self) -> Result<(&'static str, f64), MeshFileError> {
        let index = self.number("extensions.KHR_materials_ior.ior", 1.5)?;
        let specular = "extensions.KHR_materials_specular";
        let factor = self.number(&format!("{specular}.specularFactor"), 1.0)?;
        let [r, g, b] = self.numbers(&format!("{specular}.specularColorFactor"), 1.0)?;
        let textures = ["specularTexture", "specularColorTexture"];
        let has = |key| {
            self.builder
                .file
                .value(&self.at(&format!("{specular}.{key}")))
        };
        let has_textures = textures.into_iter().any(|key| has(key).is_some());
        if index < 1.0 {
            let message = "an index below 1 is not the surface of a solid in air";
            return self.unsupported("extensions.KHR_materials_ior.ior", message);
        }
        // Grey, and white at grazing angles: that of another index.
        let reflected = ((index - 1.0) / (index + 1.0)).powi(2) * r;
        if factor == 0.0 || reflected == 0.0 && r == g && g == b && !has_textures {
            // It is of what is no metal, and of no index: `principled` has no metals without one.
            return match self.number("pbrMetallicRoughness.metallicFactor", 1.0)? {
                0.0 => Ok(("specular", 0.0)),
                1.0 if self.is_all_metal() => Ok(("eta", 1.5)),
                _ => self.unsupported(
                    specular,
                    "a mixture of a metal and a surface that reflects nothing has no equal in \
                     \"principled\"",
                ),
            };
        }
        if factor != 1.0 || r != g || g != b || has_textures || reflected >= 1.0 {
            let message = "reflection that is coloured, or weakened by specularFactor, has no equal \
                           in \"principled\"";
            return self.unsupported(specular, message);
        }
        match r == 1.0 {
            true => Ok(("eta", index)),
            false => Ok(("eta", (1.0 + reflected.sqrt()) / (1.0 - reflected.sqrt()))),
        }
    }

    /// True if no texture says where it is metal.
    fn is_all_metal(&self) -> bool {
        let textures = &self.given.pbr_metallic_roughness;
        textures.metallic_roughness_texture.is_none()
    }

    /// What is covered, if not everything is.
    fn opacity(&mut self) -> Result<Option<PropertyValue>, MeshFileError> {
        let limit = match self.given.alpha_mode {
            Checked::Valid(AlphaMode::Mask) => Some(self.number("alphaCutoff", 0.5)?),
            Checked::Valid(AlphaMode::Blend) => None,
            Checked::Valid(AlphaMode::Opaque) | Checked::Invalid => return Ok(None),
        };
        if self.has_colours {
            let message = "the opacity of colours of vertices (COLOR_0) is not read";
            return self.unsupported("alphaMode", message);
        }
        let [.., factor]: [f64; 4] = self.numbers("pbrMetallicRoughness.baseColorFactor", 1.0)?;
        let Some(info) = &self.given.pbr_metallic_roughness.base_color_texture else {
            let opacity = match limit {
                Some(limit) if factor >= limit => 1.0,
                Some(_) => 0.0,
                None => factor,
            };
            return Ok((opacity != 1.0).then_some(PropertyValue::Float(opacity)));
        };
        if limit.is_some() {
            let message = "alphaCutoff is compared with texels, not between them: cut edges have \
                           steps of a texel";
            self.builder.warn(self.line, message);
        }
        let texture = self.use_of(info, "pbrMetallicRoughness.baseColorTexture");
        self.texture(texture, Texels::Opacity(factor, limit))
            .map(Some)
    }

    fn radiance(&mut self) -> Result<Option<Radiance>, MeshFileError> {
        let strength = "extensions.KHR_materials_emissive_strength.emissiveStrength";
        let strength = self.number(strength, 1.0)?;
        let factor = self.numbers("emissiveFactor", 0.0)?;
        let factor = factor.map(|channel: f64| channel * strength);
        if factor == [0.0; 3] {
            return Ok(None);
        }
        if self.given.double_sided {
            let message = "it is doubleSided and emits light: light leaves its front only";
            self.builder.warn(self.line, message);
        }
        let Some(info) = &self.given.emissive_texture else {
            return Ok(Some(Radiance::Colour(Rgb::from(factor))));
        };
        let texture = self.use_of(info, "emissiveTexture");
        let texture = self.texture_node(texture, Texels::Colour(factor))?;
        Ok(Some(Radiance::Texture(texture)))
    }

    fn use_of(&self, info: &gltf::json::texture::Info, key: &str) -> TextureUse {
        TextureUse {
            index: info.index.value(),
            coordinates: info.tex_coord,
            place: self.at(key),
        }
    }

    fn texture(
        &mut self,
        texture: TextureUse,
        texels: Texels,
    ) -> Result<PropertyValue, MeshFileError> {
        self.texture_node(texture, texels).map(object)
    }

    fn texture_node(
        &mut self,
        texture: TextureUse,
        texels: Texels,
    ) -> Result<NodeId, MeshFileError> {
        let (file, line) = (self.builder.file, self.line);
        let place = |key: &str| format!("{}.extensions.KHR_texture_transform.{key}", texture.place);
        let set = file.number(&place("texCoord"), texture.coordinates.into())?;
        if set != 0.0 {
            let message = format!("it has the texture coordinates TEXCOORD_{set}");
            let help = "export it with those of TEXCOORD_0, the only ones that are read";
            return Err(unsupported(&texture.place, message, help));
        }
        let extensions = format!("{}.extensions", texture.place);
        let mut names = file.keys(&extensions);
        if let Some(name) = names.find(|&name| name != "KHR_texture_transform") {
            return Err(not_read(&extensions, name));
        }
        let node = self.builder.add(Kind::Texture, "gltf_texture", None, line);
        let filename = self.builder.filename();
        let mut set = |name: &str, value| self.builder.set(node, name, value);
        set("filename", filename);
        set("texture", PropertyValue::Integer(texture.index as i64));
        let (channel, factor) = match texels {
            Texels::Colour(factor) => ("color", PropertyValue::Rgb(factor.into())),
            Texels::Number(channel, factor) => (channel, PropertyValue::Float(factor)),
            Texels::Normal(scale) => ("normal", PropertyValue::Float(scale)),
            Texels::Opacity(factor, _) => ("alpha", PropertyValue::Float(factor)),
        };
        set("channel", PropertyValue::String(channel.into()));
        set("factor", factor);
        if let Texels::Opacity(_, Some(limit)) = texels {
            set("cutoff", PropertyValue::Float(limit));
        }
        // The other way around than about an axis that points at the viewer: v points down.
        let [x, y] = file.numbers(&place("offset"), [0.0; 2])?;
        let [u, v] = file.numbers(&place("scale"), [1.0; 2])?;
        let angle = file.number(&place("rotation"), 0.0)?;
        if [x, y, u, v, angle] != [0.0, 0.0, 1.0, 1.0, 0.0] {
            let turn = Affine::rotate(Vec3::new(0.0, 0.0, 1.0), -angle);
            let to_uv = Affine::translate(Vec3::new(x, y, 0.0))
                * turn
                * Affine::scale(Vec3::new(u, v, 1.0));
            self.builder
                .set(node, "to_uv", PropertyValue::Transform(to_uv));
        }
        Ok(node)
    }
}

/// An object in a slot of another.
fn object(node: NodeId) -> PropertyValue {
    PropertyValue::Object {
        node,
        by_reference: true,
    }
}
