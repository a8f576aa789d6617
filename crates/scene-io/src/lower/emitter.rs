//! Emitters: `area` inside shapes, all others in the scene.

use capwalk_math::{Affine, Vec3};
use capwalk_scene::emitter::EnvironmentMap;
use capwalk_scene::{Emitter, Pattern, Quantity, Texture, TextureId};
use capwalk_scene::{EmitterId, ShapeId};

use super::lowering::Lowering;
use super::sensor::{RIGID, fov_x};
use crate::bitmap::BitmapUse;
use crate::fields::{Child, Fields};
use crate::problem::Problem;
use crate::texts::Span;

/// Values of `type` that are read.
const EMITTERS: [&str; 7] = [
    "area",
    "constant",
    "envmap",
    "point",
    "spot",
    "projector",
    "directional",
];

/// Emitters of Mitsuba's that are not read, and what to do instead.
const REFUSED: [(&str, &str); 3] = [("sunsky", SKY), ("sky", SKY), ("sun", SKY)];

const SKY: &str = "bake it into an image with Mitsuba and show that by an <emitter type=\"envmap\">; \
                   docs/scene-files.md has the lines of Python, under \"Skies\"";

impl Lowering<'_> {
    /// The area emitter that stands in the shape that is added next.
    pub(super) fn area_emitter(
        &mut self,
        child: Child,
        shape_name: &str,
    ) -> Result<EmitterId, Problem> {
        let fields = Fields::new(self.context, child.node);
        match fields.node.plugin.as_str() {
            "area" => {}
            plugin if EMITTERS.contains(&plugin) => {
                let message = format!("a {plugin} emitter stands inside a shape");
                return Err(Problem::invalid(child.span, message)
                    .help("move it into <scene>, or write <emitter type=\"area\">"));
            }
            _ => return Err(fields.refused_plugin(&EMITTERS, &REFUSED)),
        }
        if !self.attached.insert(child.node) {
            return Err(Problem::invalid(
                child.span,
                "this emitter belongs to another shape already",
            )
            .help("give each shape an emitter of its own"));
        }
        if let Some(transform) = fields.get("to_world") {
            return Err(Problem::invalid(
                transform.value_span,
                "an area emitter has no \"to_world\"",
            )
            .help("it stands where its shape stands; move the shape"));
        }
        let holder = format!("{shape_name}.emitter");
        let radiance = self.slot(&fields, &holder, "radiance", Quantity::Radiance, 1.0)?;
        sampling_weight(&fields)?;
        fields.finish()?;
        let shape = ShapeId(self.shapes.len() as u32);
        Ok(self.add_emitter(Emitter::Area { shape, radiance }, child.span))
    }

    /// An emitter that stands in the scene.
    pub(super) fn scene_emitter(&mut self, child: Child) -> Result<(), Problem> {
        let fields = Fields::new(self.context, child.node);
        match fields.node.plugin.as_str() {
            "constant" | "envmap" | "point" | "spot" | "projector" | "directional" => {}
            // Defined here, used in a shape by a <ref>.
            "area" if self.attached.contains(&child.node) => return Ok(()),
            "area" => {
                return Err(Problem::invalid(
                    child.span,
                    "an area emitter stands outside of any shape",
                )
                .help("move it into the <shape> that emits"));
            }
            _ => return Err(fields.refused_plugin(&EMITTERS, &REFUSED)),
        }
        let emitter = match fields.node.plugin.as_str() {
            "constant" => self.constant(&fields)?,
            "envmap" => self.environment_map(&fields)?,
            "point" => self.point(&fields)?,
            "spot" => self.spot(&fields)?,
            "projector" => self.projector(&fields)?,
            _ => self.directional(&fields)?,
        };
        sampling_weight(&fields)?;
        fields.finish()?;
        self.add_emitter(emitter, child.span);
        Ok(())
    }

    /// The name of an emitter in the scene: its id, or a made up one.
    fn emitter_name(&mut self, fields: &Fields, otherwise: &str) -> String {
        match &fields.node.id {
            Some(id) => id.clone(),
            None => self.emitter_ids.make_unique(otherwise),
        }
    }

    fn constant(&mut self, fields: &Fields) -> Result<Emitter, Problem> {
        let id = self.emitter_name(fields, "environment");
        let radiance = self.slot(fields, &id, "radiance", Quantity::Radiance, 1.0)?;
        self.refuse_texture(fields, radiance, "radiance")?;
        Ok(Emitter::Constant { id, radiance })
    }

    /// Refuses a texture where there is no surface that it could be on.
    fn refuse_texture(
        &self,
        fields: &Fields,
        texture: TextureId,
        slot: &'static str,
    ) -> Result<(), Problem> {
        if self.textures[texture.0 as usize].is_constant() {
            return Ok(());
        }
        let message = format!("the {slot} of {} is a texture", fields.title());
        let help = "give one colour; an image of all directions is <emitter type=\"envmap\">";
        Err(Problem::unsupported(fields.span_of(slot), message).help(help))
    }

    fn environment_map(&mut self, fields: &Fields) -> Result<Emitter, Problem> {
        let id = self.emitter_name(fields, "environment");
        let world_from_map = rotation(fields)?;
        fields.cosmetic(
            &["mis_compensation"],
            "directions are chosen by our own rule; the mean is the same",
        );
        let example = "add <string name=\"filename\" value=\"sky.exr\"/>";
        let (file, span) = self.image(fields, false, BitmapUse::Environment, example)?;
        if file.width < 2 || file.height < 3 {
            let message = format!(
                "the environment has {} x {} texels",
                file.width, file.height
            );
            return Err(Problem::invalid(span, message).help("expected at least 2 x 3"));
        }
        let data = match file.channels {
            1 => file.data.iter().flat_map(|&grey| [grey; 3]).collect(),
            _ => file.data,
        };
        let texture = Texture {
            id: id.clone(),
            channels: 3,
            data,
            pattern: Pattern::Environment,
        };
        let data = self.add_texture(texture, span);
        Ok(Emitter::EnvironmentMap {
            map: EnvironmentMap {
                width: file.width,
                height: file.height,
                world_from_map,
            },
            data,
            scale: self.number(fields, &id, "scale", Quantity::Factor, 1.0)?,
            id,
        })
    }

    fn point(&mut self, fields: &Fields) -> Result<Emitter, Problem> {
        let id = self.emitter_name(fields, "point");
        let to_world = fields.transform("to_world")?;
        let position = match (fields.get("to_world"), fields.point("position")?) {
            (Some(_), Some(_)) => {
                let message = "both \"to_world\" and \"position\" are given";
                let span = fields.span_of("position");
                return Err(Problem::invalid(span, message).help("keep one of them"));
            }
            (_, Some(position)) => position,
            (_, None) => to_world.translation,
        };
        let intensity = self.slot(fields, &id, "intensity", Quantity::Intensity, 1.0)?;
        self.refuse_texture(fields, intensity, "intensity")?;
        Ok(Emitter::Point {
            id,
            position,
            intensity,
        })
    }

    fn spot(&mut self, fields: &Fields) -> Result<Emitter, Problem> {
        let id = self.emitter_name(fields, "spot");
        let translation = fields.transform("to_world")?.translation;
        let world_from_emitter = Affine {
            translation,
            ..rotation(fields)?
        };
        let cutoff = fields.float("cutoff_angle", 20.0)?;
        let beam = fields.float("beam_width", 0.75 * cutoff)?;
        if !(cutoff > 0.0 && cutoff <= 180.0 && beam >= 0.0 && beam < cutoff) {
            let span = match fields.get("beam_width") {
                Some(_) => fields.span_of("beam_width"),
                None => fields.span_of("cutoff_angle"),
            };
            let message = format!("\"beam_width\" is {beam} and \"cutoff_angle\" is {cutoff}");
            return Err(Problem::invalid(span, message)
                .help("expected degrees, 0 <= beam_width < cutoff_angle <= 180"));
        }
        let intensity = self.slot(fields, &id, "intensity", Quantity::Intensity, 1.0)?;
        self.refuse_texture(fields, intensity, "intensity")?;
        let texture = match fields.get("texture") {
            None => None,
            Some(given) => {
                let texture = self.slot(fields, &id, "texture", Quantity::Factor, 1.0)?;
                self.note_projected_image(fields, &id, "texture");
                if self.textures[texture.0 as usize].is_constant() {
                    let message = "the \"texture\" of a spot light is the same everywhere";
                    return Err(Problem::invalid(given.value_span, message).help(
                        "expected a bitmap or a checkerboard; a colour is its \"intensity\"",
                    ));
                }
                Some(texture)
            }
        };
        let mut number = |name: &'static str, value| {
            let texture = Texture::number(format!("{id}.{name}"), value);
            self.add_texture(texture, fields.span_of(name))
        };
        Ok(Emitter::Spot {
            world_from_emitter,
            intensity,
            cutoff_angle: number("cutoff_angle", cutoff),
            beam_width: number("beam_width", beam),
            texture,
            id,
        })
    }

    fn projector(&mut self, fields: &Fields) -> Result<Emitter, Problem> {
        let id = self.emitter_name(fields, "projector");
        let translation = fields.transform("to_world")?.translation;
        let world_from_emitter = Affine {
            translation,
            ..rotation(fields)?
        };
        let irradiance = self.slot(fields, &id, "irradiance", Quantity::Irradiance, 1.0)?;
        self.note_projected_image(fields, &id, "irradiance");
        let size = match &self.textures[irradiance.0 as usize].pattern {
            Pattern::Bitmap(bitmap) => [bitmap.width, bitmap.height],
            // A square, as in Mitsuba.
            _ => [1, 1],
        };
        let half_width = (0.5 * fov_x(fields, size)?).tan();
        Ok(Emitter::Projector {
            world_from_emitter,
            half_size: [
                half_width,
                half_width * f64::from(size[1]) / f64::from(size[0]),
            ],
            irradiance,
            scale: self.number(fields, &id, "scale", Quantity::Factor, 1.0)?,
            id,
        })
    }

    /// Notes where the image is that an emitter projects.
    fn note_projected_image(&mut self, fields: &Fields, emitter: &str, slot: &str) {
        let name = format!("{emitter}.{slot}");
        self.places.numbers.insert(name, fields.span_of(slot));
    }

    fn directional(&mut self, fields: &Fields) -> Result<Emitter, Problem> {
        let id = self.emitter_name(fields, "directional");
        let to_world = fields.transform("to_world")?;
        let (direction, span) = match (fields.get("to_world"), fields.point("direction")?) {
            (Some(_), Some(_)) => {
                let message = "both \"to_world\" and \"direction\" are given";
                let span = fields.span_of("direction");
                return Err(Problem::invalid(span, message).help("keep one of them"));
            }
            (_, Some(direction)) => (direction, fields.span_of("direction")),
            (_, None) => {
                let direction = to_world.vector(Vec3::new(0.0, 0.0, 1.0));
                (direction, fields.span_of("to_world"))
            }
        };
        if direction.length() == 0.0 {
            return Err(Problem::invalid(span, "the light has no direction")
                .help("expected a vector that is not zero: where the light goes"));
        }
        let irradiance = self.slot(fields, &id, "irradiance", Quantity::Irradiance, 1.0)?;
        self.refuse_texture(fields, irradiance, "irradiance")?;
        Ok(Emitter::Directional {
            id,
            direction: direction.normalized(),
            irradiance,
        })
    }

    fn add_emitter(&mut self, emitter: Emitter, span: Span) -> EmitterId {
        self.emitters.push(emitter);
        self.places.emitters.push(span);
        EmitterId(self.emitters.len() as u32 - 1)
    }
}

/// The rotation of `to_world`, freed from the rounding of its digits.
fn rotation(fields: &Fields) -> Result<Affine, Problem> {
    let given = fields.transform("to_world")?;
    if !given.is_rigid(RIGID) || given.determinant() < 0.0 {
        let message = format!(
            "the \"to_world\" of {} scales, shears or mirrors",
            fields.title()
        );
        return Err(Problem::invalid(fields.span_of("to_world"), message)
            .help("expected a rotation and a translation"));
    }
    let [a, b, _] = given.rows;
    let first = a.normalized();
    let second = b.reject_from(first).normalized();
    Ok(Affine {
        rows: [first, second, first.cross(second)],
        translation: Vec3::zero(),
    })
}

/// How often Mitsuba samples this emitter; the mean of the image does not
/// depend on it unless it is zero.
fn sampling_weight(fields: &Fields) -> Result<(), Problem> {
    match fields.optional_float("sampling_weight")? {
        None => Ok(()),
        Some(weight) if weight > 0.0 => {
            if weight != 1.0 {
                let reason = "emitters are chosen by our own rule; the mean is the same";
                fields.cosmetic(&["sampling_weight"], reason);
            }
            Ok(())
        }
        Some(weight) => Err(Problem::invalid(
            fields.span_of("sampling_weight"),
            format!("\"sampling_weight\" is {weight}"),
        )
        .help("expected a number above 0; remove the emitter to switch it off")),
    }
}
