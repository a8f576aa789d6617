//! The XML of a scene whose meshes are in files.

use std::fmt::Write;

use capwalk_math::Affine;
use capwalk_scene::scene::BsdfId;
use capwalk_scene::{
    Bsdf, Emitter, Film, Filter, Integrator, Pattern, Perspective, SamplerKind, Scene, Settings,
    ShadingNormals, Shape, Texture,
};

/// The text of the XML file. `files` holds each shape's mesh, relative to it.
pub(super) fn text(scene: &Scene, files: &[String]) -> String {
    let mut xml = Xml::default();
    xml.open("scene", &[("version", "3.0.0")]);
    integrator(&scene.settings.integrator, &mut xml);
    sensor(&scene.sensor, &scene.film, &scene.settings, &mut xml);
    for i in 0..scene.materials.len() {
        let id = BsdfId(i as u32);
        if home(scene, id).is_none() {
            bsdf(scene, id, true, &mut xml);
        }
    }
    for (shape, file) in scene.shapes.iter().zip(files) {
        write_shape(scene, shape, file, &mut xml);
    }
    for emitter in &scene.emitters {
        if let Emitter::Constant { id, radiance } = emitter {
            xml.open("emitter", &[("type", "constant"), ("id", id)]);
            xml.texture("radiance", scene.texture(*radiance));
            xml.close();
        }
    }
    xml.close();
    xml.text
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
    }
    xml.close();
}

fn sensor(sensor: &Perspective, film: &Film, settings: &Settings, xml: &mut Xml) {
    xml.open("sensor", &[("type", "perspective"), ("id", &sensor.id)]);
    xml.transform("to_world", &sensor.world_from_camera);
    xml.property("string", "fov_axis", "x");
    xml.property("float", "fov", degrees(sensor.fov_x));
    let [x, y] = sensor.principal_point_offset;
    xml.property("float", "principal_point_offset_x", x);
    xml.property("float", "principal_point_offset_y", y);
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

fn write_shape(scene: &Scene, shape: &Shape, file: &str, xml: &mut Xml) {
    xml.open("shape", &[("type", "ply"), ("id", &shape.id)]);
    xml.property("string", "filename", file);
    let flat = matches!(shape.normals, ShadingNormals::Face);
    xml.property("boolean", "face_normals", flat);
    bsdf(scene, shape.bsdf, false, xml);
    if let Some(emitter) = shape.emitter {
        xml.open("emitter", &[("type", "area")]);
        let radiance = scene.emitter(emitter).radiance();
        xml.texture("radiance", scene.texture(radiance));
        xml.close();
    }
    xml.close();
}

/// A material: itself at its home, a reference elsewhere.
fn bsdf(scene: &Scene, id: BsdfId, at_top: bool, xml: &mut Xml) {
    let material = scene.material(id);
    if !at_top && home(scene, id).is_none() {
        xml.line("ref", &[("id", &material.id)]);
        return;
    }
    let plugin = match material.bsdf {
        Bsdf::Diffuse { .. } => "diffuse",
        Bsdf::TwoSided { .. } => "twosided",
    };
    match at_top {
        true => xml.open("bsdf", &[("type", plugin), ("id", &material.id)]),
        false => xml.open("bsdf", &[("type", plugin)]),
    }
    match &material.bsdf {
        Bsdf::Diffuse { reflectance } => xml.texture("reflectance", scene.texture(*reflectance)),
        Bsdf::TwoSided { front, back } => {
            bsdf(scene, *front, false, xml);
            if front != back {
                bsdf(scene, *back, false, xml);
            }
        }
    }
    xml.close();
}

/// The one shape or two-sided material that a material is written into, or
/// `None` if it stands at the top under its own id. It has a home if only one
/// place uses it and its id is the one that a nameless material gets there.
fn home(scene: &Scene, id: BsdfId) -> Option<String> {
    let mut homes: Vec<String> = Vec::new();
    for shape in scene.shapes.iter().filter(|shape| shape.bsdf == id) {
        homes.push(format!("{}.bsdf", shape.id));
    }
    for material in &scene.materials {
        if let Bsdf::TwoSided { front, back } = material.bsdf {
            if front == id {
                homes.push(format!("{}.brdf_0", material.id));
            }
            if back == id && back != front {
                homes.push(format!("{}.brdf_1", material.id));
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

    fn texture(&mut self, name: &str, texture: &Texture) {
        match (&texture.pattern, &texture.data[..]) {
            (Pattern::Constant, [number]) => self.property("float", name, number),
            (Pattern::Constant, data) => {
                let [r, g, b] = [data[0], data[1], data[2]];
                self.property("rgb", name, format!("{r}, {g}, {b}"));
            }
        }
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
