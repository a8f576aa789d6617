//! The XML of a scene whose meshes are in files.

use std::fmt::Write;

use capwalk_math::{Affine, Vec3};
use capwalk_scene::BsdfId;
use capwalk_scene::fields::FieldChoice;
use capwalk_scene::texture::{TexelFilter, UvTransform, Wrap};
use capwalk_scene::{
    Bsdf, Emitter, Film, Filter, Integrator, Optic, Pattern, SamplerKind, Scene, Sensor,
    SensorModel, Settings, ShadingNormals, Shape, TextureId,
};

use super::beside::Files;

/// The text of the XML file.
pub(super) fn text(scene: &Scene, files: &Files) -> String {
    let mut xml = Xml::default();
    xml.open("scene", &[("version", "3.0.0")]);
    integrator(&scene.settings.integrator, &mut xml);
    sensor(&scene.sensor, &scene.film, &scene.settings, &mut xml);
    let out = &mut Writer { scene, files, xml };
    for i in 0..scene.textures.len() {
        let id = TextureId(i as u32);
        if out.stands_alone(id) {
            out.texture(None, id);
        }
    }
    for i in 0..scene.materials.len() {
        let id = BsdfId(i as u32);
        if home(scene, id).is_none() {
            out.bsdf(id, true);
        }
    }
    for (shape, file) in scene.shapes.iter().zip(&files.meshes) {
        out.shape(shape, file);
    }
    for emitter in &scene.emitters {
        out.emitter(emitter);
    }
    out.xml.close();
    std::mem::take(&mut out.xml.text)
}

fn integrator(integrator: &Integrator, xml: &mut Xml) {
    match *integrator {
        Integrator::Direct {
            emitter_samples,
            bsdf_samples,
            hide_emitters,
        } => {
            xml.open("integrator", &[("type", "direct")]);
            xml.property("integer", "emitter_samples", emitter_samples);
            xml.property("integer", "bsdf_samples", bsdf_samples);
            xml.property("boolean", "hide_emitters", hide_emitters);
        }
        Integrator::Path {
            max_depth,
            rr_depth,
            hide_emitters,
        } => {
            xml.open("integrator", &[("type", "path")]);
            let max_depth = max_depth.map_or(-1, i64::from);
            xml.property("integer", "max_depth", max_depth);
            xml.property("integer", "rr_depth", rr_depth);
            xml.property("boolean", "hide_emitters", hide_emitters);
        }
        Integrator::Aov(aov) => {
            let name = aov.name();
            xml.open("integrator", &[("type", "aov")]);
            xml.property("string", "aovs", format!("{name}:{name}"));
        }
    }
    xml.close();
}

fn sensor(sensor: &Sensor, film: &Film, settings: &Settings, xml: &mut Xml) {
    let plugin = sensor.model.plugin();
    xml.open("sensor", &[("type", plugin), ("id", &sensor.id)]);
    xml.transform("to_world", &sensor.world_from_camera);
    if let Some(fov_x) = sensor.model.optic(Optic::FovX) {
        xml.property("string", "fov_axis", "x");
        xml.property("float", "fov", degrees(fov_x));
    }
    match sensor.model {
        SensorModel::Perspective {
            principal_point_offset: [x, y],
            ..
        } => {
            xml.property("float", "principal_point_offset_x", x);
            xml.property("float", "principal_point_offset_y", y);
        }
        SensorModel::ThinLens {
            aperture_radius,
            focus_distance,
            ..
        } => {
            xml.property("float", "aperture_radius", aperture_radius);
            xml.property("float", "focus_distance", focus_distance);
        }
        SensorModel::Orthographic => {}
    }
    xml.property("float", "near_clip", sensor.near_clip);
    xml.property("float", "far_clip", sensor.far_clip);

    let plugin = match settings.sampler {
        SamplerKind::Independent => "independent",
        SamplerKind::Sobol => "ldsampler",
    };
    xml.open("sampler", &[("type", plugin)]);
    xml.property("integer", "sample_count", settings.spp);
    xml.property("integer", "seed", settings.seed);
    xml.close();

    xml.open("film", &[("type", "hdrfilm")]);
    for (name, [x, y]) in [
        (["width", "height"], film.size),
        (["crop_offset_x", "crop_offset_y"], film.crop_offset),
        (["crop_width", "crop_height"], film.crop_size),
    ] {
        xml.property("integer", name[0], x);
        xml.property("integer", name[1], y);
    }
    xml.property("boolean", "sample_border", film.sample_border);
    xml.property("string", "pixel_format", "rgb");
    xml.property("string", "component_format", "float32");
    match film.filter {
        Filter::Box => xml.open("rfilter", &[("type", "box")]),
        Filter::Tent { radius } => {
            xml.open("rfilter", &[("type", "tent")]);
            xml.property("float", "radius", radius);
        }
        Filter::Gaussian { stddev } => {
            xml.open("rfilter", &[("type", "gaussian")]);
            xml.property("float", "stddev", stddev);
        }
        Filter::Mitchell { b, c } => {
            xml.open("rfilter", &[("type", "mitchell")]);
            xml.property("float", "B", b);
            xml.property("float", "C", c);
        }
        Filter::Lanczos { lobes } => {
            xml.open("rfilter", &[("type", "lanczos")]);
            xml.property("integer", "lobes", lobes);
        }
    }
    xml.close();
    xml.close();
    xml.close();
}

/// The shortest number of degrees that is the given number of radians.
fn degrees(radians: f64) -> String {
    let degrees = radians.to_degrees();
    (0..17)
        .map(|digits| format!("{degrees:.digits$}"))
        .find(|text| text.parse().is_ok_and(|d: f64| d.to_radians() == radians))
        .unwrap_or_else(|| degrees.to_string())
}

/// The scene, the files beside the XML, and the XML so far.
struct Writer<'a> {
    scene: &'a Scene,
    files: &'a Files,
    xml: Xml,
}

impl Writer<'_> {
    fn shape(&mut self, shape: &Shape, file: &str) {
        self.xml
            .open("shape", &[("type", "ply"), ("id", &shape.id)]);
        self.xml.property("string", "filename", file);
        let flat = matches!(shape.normals, ShadingNormals::Face);
        self.xml.property("boolean", "face_normals", flat);
        self.bsdf(shape.bsdf, false);
        if let Some(emitter) = shape.emitter {
            self.xml.open("emitter", &[("type", "area")]);
            self.slot("radiance", self.scene.emitter(emitter).radiance());
            self.xml.close();
        }
        self.xml.close();
    }

    /// An emitter that does not stand in a shape.
    fn emitter(&mut self, emitter: &Emitter) {
        if let Emitter::Area { .. } = emitter {
            return;
        }
        let id = emitter.name(self.scene);
        let attributes = [("type", emitter.plugin()), ("id", &id)];
        self.xml.open("emitter", &attributes);
        for slot in emitter.slots().iter().filter(|slot| !slot.name.is_empty()) {
            self.slot(slot.name, slot.texture);
        }
        let xml = &mut self.xml;
        match emitter {
            Emitter::Area { .. } | Emitter::Constant { .. } => {}
            Emitter::EnvironmentMap { map, data, .. } => {
                let file = &self.files.bitmaps[&(data.0 as usize)];
                xml.property("string", "filename", file);
                xml.transform("to_world", &map.world_from_map);
            }
            Emitter::Point { position, .. } => xml.vector("point", "position", *position),
            Emitter::Spot {
                world_from_emitter, ..
            } => xml.transform("to_world", world_from_emitter),
            Emitter::Projector {
                world_from_emitter,
                half_size,
                ..
            } => {
                let fov = 2.0 * half_size[0].atan().to_degrees();
                xml.property("float", "fov", fov);
                xml.transform("to_world", world_from_emitter);
            }
            Emitter::Directional { direction, .. } => {
                xml.vector("vector", "direction", *direction);
            }
        }
        self.xml.close();
    }

    /// A material: itself at its home, a reference elsewhere.
    fn bsdf(&mut self, id: BsdfId, at_top: bool) {
        let material = self.scene.material(id);
        if !at_top && home(self.scene, id).is_none() {
            self.xml.line("ref", &[("id", &material.id)]);
            return;
        }
        let plugin = material.bsdf.plugin();
        match at_top {
            true => {
                let attributes = [("type", plugin), ("id", &material.id)];
                self.xml.open("bsdf", &attributes);
            }
            false => self.xml.open("bsdf", &[("type", plugin)]),
        }
        let list = material.bsdf.list();
        for slot in list.slots {
            self.slot(slot.name, slot.texture);
        }
        for (name, choice) in list.choices {
            match choice {
                FieldChoice::Flag(is_so) => self.xml.property("boolean", name, is_so),
                FieldChoice::Word(word) => self.xml.property("string", name, word),
            }
        }
        for (_, part) in different_parts(&material.bsdf) {
            self.bsdf(part, false);
        }
        self.xml.close();
    }

    /// What stands in a slot: itself, or a reference if it stands alone.
    fn slot(&mut self, name: &'static str, id: TextureId) {
        match self.stands_alone(id) {
            true => {
                let texture = &self.scene.texture(id).id;
                self.xml.line("ref", &[("name", name), ("id", texture)]);
            }
            false => self.texture(Some(name), id),
        }
    }

    /// A texture in a slot, or alone under its own id.
    fn texture(&mut self, slot: Option<&'static str>, id: TextureId) {
        let texture = self.scene.texture(id);
        let xml = &mut self.xml;
        let mut open = |plugin: &str| {
            let name = match slot {
                Some(name) => ("name", name),
                None => ("id", texture.id.as_str()),
            };
            xml.open("texture", &[("type", plugin), name]);
        };
        match &texture.pattern {
            Pattern::Constant => return xml.constant(slot.unwrap_or_default(), &texture.data),
            // They are in the file of their mesh.
            Pattern::PerVertex | Pattern::PerFace => return,
            // It is in the file of its emitter.
            Pattern::Environment => return,
            Pattern::Bitmap(bitmap) => {
                open("bitmap");
                let file = &self.files.bitmaps[&(id.0 as usize)];
                xml.property("string", "filename", file);
                let filter = match bitmap.filter {
                    TexelFilter::Nearest => "nearest",
                    TexelFilter::Bilinear => "bilinear",
                };
                xml.property("string", "filter_type", filter);
                let wrap = match bitmap.wrap {
                    Wrap::Repeat => "repeat",
                    Wrap::Mirror => "mirror",
                    Wrap::Clamp => "clamp",
                };
                xml.property("string", "wrap_mode", wrap);
                xml.property("boolean", "raw", true);
                xml.uv_transform(&bitmap.to_uv);
            }
            Pattern::Checkerboard { to_uv } => {
                open("checkerboard");
                let (color0, color1) = texture.data.split_at(texture.channels);
                xml.constant("color0", color0);
                xml.constant("color1", color1);
                xml.uv_transform(to_uv);
            }
            Pattern::MeshAttribute { name, scale } => {
                open("mesh_attribute");
                xml.property("string", "name", name);
                xml.property("float", "scale", scale);
            }
        }
        self.xml.close();
    }

    /// True if a texture stands at the top under its own id: if several slots
    /// refer to it, or the id is not the one that a nameless texture gets in
    /// the one that does. Constants always stand in their slots.
    fn stands_alone(&self, id: TextureId) -> bool {
        let texture = self.scene.texture(id);
        let attribute = matches!(
            texture.pattern,
            Pattern::PerVertex | Pattern::PerFace | Pattern::Environment
        );
        if texture.is_constant() || attribute {
            return false;
        }
        let mut slots: Vec<String> = Vec::new();
        for emitter in self.scene.emitters.iter().filter(|e| e.radiance() == id) {
            slots.push(format!("{}.radiance", emitter.name(self.scene)));
        }
        for material in &self.scene.materials {
            let own = material.bsdf.slots();
            let own = own.iter().filter(|slot| slot.texture == id);
            slots.extend(own.map(|slot| format!("{}.{}", material.id, slot.name)));
        }
        slots.len() != 1 || slots[0] != texture.id
    }
}

/// The materials that a material is written with: one for two sides that are
/// the same.
fn different_parts(bsdf: &Bsdf) -> Vec<(&'static str, BsdfId)> {
    let mut parts = bsdf.named_parts();
    if let Bsdf::TwoSided { front, back } = bsdf
        && front == back
    {
        parts.truncate(1);
    }
    parts
}

/// The one shape or material that a material is written into, or
/// `None` if it stands at the top under its own id. It has a home if only one
/// place uses it and its id is the one that a nameless material gets there.
fn home(scene: &Scene, id: BsdfId) -> Option<String> {
    let mut homes: Vec<String> = Vec::new();
    for shape in scene.shapes.iter().filter(|shape| shape.bsdf == id) {
        homes.push(format!("{}.bsdf", shape.id));
    }
    for material in &scene.materials {
        for (name, part) in different_parts(&material.bsdf) {
            if part == id {
                homes.push(format!("{}.{name}", material.id));
            }
        }
    }
    let [home] = <[String; 1]>::try_from(homes).ok()?;
    (home == scene.material(id).id).then_some(home)
}

/// XML text that grows line by line.
#[derive(Default)]
struct Xml {
    text: String,
    open: Vec<&'static str>,
}

impl Xml {
    fn open(&mut self, tag: &'static str, attributes: &[(&str, &str)]) {
        self.tag(tag, attributes, ">");
        self.open.push(tag);
    }

    fn close(&mut self) {
        let tag = self.open.pop().expect("every close has its open");
        self.indent();
        self.text.push_str(&format!("</{tag}>\n"));
    }

    fn line(&mut self, tag: &str, attributes: &[(&str, &str)]) {
        self.tag(tag, attributes, "/>");
    }

    fn property(&mut self, tag: &str, name: &str, value: impl std::fmt::Display) {
        self.line(tag, &[("name", name), ("value", &value.to_string())]);
    }

    fn vector(&mut self, tag: &str, name: &str, Vec3 { x, y, z }: Vec3) {
        self.property(tag, name, format!("{x}, {y}, {z}"));
    }

    /// One number, or one colour.
    fn constant(&mut self, name: &str, data: &[f64]) {
        match data {
            [number] => self.property("float", name, number),
            data => {
                let [r, g, b] = [data[0], data[1], data[2]];
                self.property("rgb", name, format!("{r}, {g}, {b}"));
            }
        }
    }

    fn uv_transform(&mut self, to_uv: &UvTransform) {
        if *to_uv == UvTransform::IDENTITY {
            return;
        }
        let [[a, b, c], [d, e, f]] = to_uv.rows;
        let matrix = format!("{a} {b} 0 {c} {d} {e} 0 {f} 0 0 1 0 0 0 0 1");
        self.open("transform", &[("name", "to_uv")]);
        self.line("matrix", &[("value", &matrix)]);
        self.close();
    }

    fn transform(&mut self, name: &str, affine: &Affine) {
        let mut matrix = String::new();
        for (i, row) in affine.rows.iter().enumerate() {
            let [a, b, c] = row.to_array();
            let d = affine.translation[i];
            write!(matrix, "{a} {b} {c} {d} ").expect("strings grow");
        }
        matrix.push_str("0 0 0 1");
        self.open("transform", &[("name", name)]);
        self.line("matrix", &[("value", &matrix)]);
        self.close();
    }

    fn tag(&mut self, tag: &str, attributes: &[(&str, &str)], end: &str) {
        self.indent();
        self.text.push('<');
        self.text.push_str(tag);
        for (name, value) in attributes {
            self.text
                .push_str(&format!(" {name}=\"{}\"", escaped(value)));
        }
        self.text.push_str(end);
        self.text.push('\n');
    }

    fn indent(&mut self) {
        self.text.push_str(&"    ".repeat(self.open.len()));
    }
}

/// An attribute's value with XML's special characters replaced.
fn escaped(value: &str) -> String {
    let mut text = String::with_capacity(value.len());
    for c in value.chars() {
        match c {
            '&' => text.push_str("&amp;"),
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            '"' => text.push_str("&quot;"),
            '\n' | '\r' | '\t' => text.push_str(&format!("&#{};", c as u32)),
            _ => text.push(c),
        }
    }
    text
}
