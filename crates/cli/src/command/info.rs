//! `capwalk info`: what is in a scene, and what can be differentiated.

use std::borrow::Cow;
use std::fmt::Write;
use std::thread;

use anyhow::Result;
use capwalk::scene::lobe::{Diffuse, Lobe};
use capwalk::scene::params::{ArrayParameter, Parameter, ParameterKind};
use capwalk::scene::{
    Bsdf, Emitter, EmitterId, Filter, Integrator, Pattern, SamplerKind, Scene, SensorModel,
    ShadingNormals, TextureId,
};
use capwalk::text::cut;
use capwalk::{Refusal, bounds};
use serde_json::{Value, json};

use crate::args::Info;
use crate::diagnostics::Outcome;
use crate::{console, report, source};

pub fn run(args: &Info) -> Result<Outcome> {
    let (prepared, _) = source::load(&args.scene)?;
    let scene = prepared.scene();
    let registry = prepared.registry();
    let (parameters, arrays) = (registry.scalars(scene), registry.arrays());
    let refusal = prepared.refusal();
    if args.json {
        let mut document = to_json(scene, &parameters, arrays, refusal.as_ref());
        document["set"] = source::settings_json(&args.scene);
        console::print_json(&document)?;
    } else {
        // Before the tables, which are long.
        let refused = refusal.as_ref().map(|refusal| {
            format!("- : derivatives with respect to what moves edges (D) are refused: {refusal}\n")
        });
        // Side by side: of 20,000 shapes the tables have 300,000 lines.
        let (shapes, arrays, parameters) = thread::scope(|scope| {
            let others = scope.spawn(|| {
                let lines = arrays.iter().filter(|a| args.all || a.alias_of.is_none());
                let lines = lines.map(|a| array_line(a, refusal.as_ref()));
                (shapes(scene), table(lines))
            });
            let parameters = match args.all {
                true => table(
                    parameters
                        .iter()
                        .map(|p| parameter_line(p, refusal.as_ref())),
                ),
                false => table(groups(&parameters).map(|g| group_line(g, refusal.as_ref()))),
            };
            let (shapes, arrays) = others.join().expect("tables do not panic");
            (shapes, arrays, parameters)
        });
        let more = match args.all {
            true => "",
            false => "; each name, and other names of the same: --all",
        };
        let text = format!(
            "{}\nshapes\n{shapes}\nparameters (∂: differentiable, D: edges move{more})\n{}\
             {parameters}\narrays, for `capwalk backward`\n{arrays}",
            summary(&args.scene.scene, scene),
            refused.unwrap_or_default(),
        );
        console::print(&text)?;
    }
    // The process ends: to free a large scene piece by piece takes a quarter of the time.
    std::mem::forget((parameters, prepared));
    Ok(Outcome::Done)
}

fn summary(name: &str, scene: &Scene) -> String {
    let film = &scene.film;
    let [w, h] = film.crop_size;
    let crop = if film.crop_size == film.size {
        String::new()
    } else {
        let ([x, y], [whole_w, whole_h]) = (film.crop_offset, film.size);
        format!(" (from ({x}, {y}) of {whole_w} x {whole_h})")
    };
    let (low, high) = bounds(scene);
    let triangles: usize = scene.shapes.iter().map(|s| s.mesh.faces.len()).sum();
    let settings = &scene.settings;
    let sampler = match settings.sampler {
        SamplerKind::Independent => "independent",
        SamplerKind::Sobol => "Sobol",
    };
    report::list(&[
        ("scene", name.into()),
        (
            "image",
            format!("{w} x {h} pixels{crop}, {} filter", filter(&film.filter)),
        ),
        ("integrator", integrator(&settings.integrator)),
        (
            "sampling",
            format!(
                "{} samples per pixel, {sampler}, seed {}",
                settings.spp, settings.seed
            ),
        ),
        (
            "camera",
            format!(
                "{} at {}",
                sensor(&scene.sensor.model),
                triple(scene.sensor.origin().to_array())
            ),
        ),
        (
            "contents",
            format!(
                "{}, {}, {}, {}",
                report::counted(scene.shapes.len(), "shape"),
                report::counted(triangles, "triangle"),
                report::counted(scene.materials.len(), "material"),
                report::counted(scene.emitters.len(), "emitter")
            ),
        ),
        (
            "extent",
            format!("{} to {}", triple(low.to_array()), triple(high.to_array())),
        ),
    ])
}

fn sensor(model: &SensorModel) -> String {
    let plugin = model.plugin();
    match *model {
        SensorModel::Perspective { fov_x, .. } => {
            format!("{plugin}, {:.1}° wide,", fov_x.to_degrees())
        }
        SensorModel::ThinLens {
            fov_x,
            aperture_radius,
            focus_distance,
        } => format!(
            "{plugin}, {:.1}° wide, aperture radius {aperture_radius}, focus at {focus_distance},",
            fov_x.to_degrees()
        ),
        SensorModel::Orthographic => plugin.into(),
    }
}

fn filter(filter: &Filter) -> String {
    match filter {
        Filter::Box => "box".into(),
        Filter::Tent { radius } => format!("tent (radius {radius})"),
        Filter::Gaussian { stddev } => format!("Gaussian (σ {stddev})"),
        Filter::Mitchell { b, c } => format!("Mitchell-Netravali (B {b:.3}, C {c:.3})"),
        Filter::Lanczos { lobes } => format!("Lanczos ({lobes} lobes)"),
    }
}

fn integrator(integrator: &Integrator) -> String {
    match integrator {
        Integrator::Direct {
            emitter_samples,
            bsdf_samples,
            ..
        } => format!("direct light ({emitter_samples} emitter, {bsdf_samples} material samples)"),
        Integrator::Path { max_depth, .. } => match max_depth {
            Some(depth) => format!("paths of up to {depth} segments"),
            None => "paths of any length".into(),
        },
        Integrator::Aov(aov) => format!("no light: {}", aov.name()),
    }
}

fn triple(numbers: [f64; 3]) -> String {
    let [x, y, z] = numbers.map(report::number);
    format!("({x}, {y}, {z})")
}

fn shapes(scene: &Scene) -> String {
    let mut rows = vec![
        ["", "triangles", "vertices", "normals", "material", "emits"]
            .map(String::from)
            .to_vec(),
    ];
    for shape in &scene.shapes {
        let normals = match &shape.normals {
            ShadingNormals::Face => "flat",
            ShadingNormals::Given(_) => "given",
            ShadingNormals::Computed(_) => "smooth",
        };
        let emits = shape
            .emitter
            .map(|id| texture(scene, scene.emitter(id).radiance()));
        rows.push(vec![
            shape.id.clone(),
            report::count(shape.mesh.faces.len() as u64),
            report::count(shape.mesh.positions.len() as u64),
            normals.into(),
            material(scene, shape.bsdf),
            emits.unwrap_or_else(|| "-".into()),
        ]);
    }
    let mut text = report::table(&rows);
    for emitter in &scene.emitters {
        let what = match emitter {
            Emitter::Area { .. } => continue,
            Emitter::Constant { .. } | Emitter::EnvironmentMap { .. } => "surrounds the scene with",
            Emitter::Point { .. } | Emitter::Spot { .. } => "is a point of intensity",
            Emitter::Projector { .. } => "projects an image of irradiance",
            Emitter::Directional { .. } => "sends parallel light of irradiance",
        };
        let emitted = texture(scene, emitter.radiance());
        text += &format!("{}: {what} {emitted}\n", emitter.name(scene));
    }
    text
}

fn texture(scene: &Scene, id: TextureId) -> String {
    let texture = scene.texture(id);
    match &texture.pattern {
        Pattern::Constant => triple(texture.texel(0).to_array()),
        Pattern::Bitmap(bitmap) => format!("bitmap of {} x {}", bitmap.width, bitmap.height),
        Pattern::Checkerboard { .. } => {
            let [first, second] = [0, 1].map(|i| triple(texture.texel(i).to_array()));
            format!("checkerboard of {first}, {second}")
        }
        Pattern::MeshAttribute { name, .. } => format!("attribute {name}"),
        Pattern::PerVertex | Pattern::PerFace => texture.id.clone(),
        Pattern::Environment => format!("{} texels", texture.texels()),
    }
}

fn material(scene: &Scene, id: capwalk::scene::BsdfId) -> String {
    let material = scene.material(id);
    match &material.bsdf {
        Bsdf::Plain(Lobe::Diffuse(Diffuse { reflectance })) => {
            format!("diffuse {}", texture(scene, *reflectance))
        }
        Bsdf::TwoSided { front, back } if front == back => {
            format!("two-sided {}", self::material(scene, *front))
        }
        Bsdf::TwoSided { front, back } => format!(
            "{} | {}",
            self::material(scene, *front),
            self::material(scene, *back)
        ),
        bsdf => {
            let parts = bsdf.parts().into_iter();
            let mut text = bsdf.plugin().to_owned();
            for (i, part) in parts.enumerate() {
                text += if i == 0 { " of " } else { ", " };
                text += &self::material(scene, part);
            }
            text
        }
    }
}

/// A refusal is about curves that move.
fn differentiable(moves_discontinuities: bool, refusal: Option<&Refusal>) -> bool {
    refusal.is_none() || !moves_discontinuities
}

/// Cells of a line of a table of parameters.
type Line<'a> = [Cow<'a, str>; 4];

fn parameter_line<'a>(parameter: &'a Parameter, refusal: Option<&Refusal>) -> Line<'a> {
    let moves = parameter.moves_discontinuities;
    match &parameter.alias_of {
        Some(other) => alias(&parameter.name, differentiable(moves, refusal), other),
        None => [
            parameter.name.as_str().into(),
            flags(differentiable(moves, refusal), moves).into(),
            values(&parameter.value).into(),
            format!("{} ({})", parameter.description, parameter.unit).into(),
        ],
    }
}

/// Parameters that belong together, without other names of the same: the motions of one shape or
/// of the sensor, and a colour with its channels.
fn groups(parameters: &[Parameter]) -> impl Iterator<Item = Vec<&Parameter>> {
    let mut own = parameters
        .iter()
        .filter(|p| p.alias_of.is_none())
        .peekable();
    std::iter::from_fn(move || {
        let mut group = vec![own.next()?];
        while let Some(next) = own.next_if(|next| stem(next) == stem(group[0])) {
            group.push(next);
        }
        Some(group)
    })
}

/// What the names of a group begin with.
fn stem(parameter: &Parameter) -> &str {
    use ParameterKind::{Rotation, Scale, SensorRotation, SensorTranslation, Translation};
    let without = |suffixes: &[&str]| {
        let name = parameter.name.as_str();
        let found = suffixes.iter().find_map(|suffix| name.strip_suffix(suffix));
        found.unwrap_or(name)
    };
    let without_axis = || {
        let name = without(&[".x", ".y", ".z", ".scale"]);
        let found = name.strip_suffix(".translate");
        found.or(name.strip_suffix(".rotate")).unwrap_or(name)
    };
    match parameter.kind {
        Translation | Rotation | Scale | SensorTranslation | SensorRotation => without_axis(),
        _ => without(&[".r", ".g", ".b"]),
    }
}

fn group_line<'a>(group: Vec<&'a Parameter>, refusal: Option<&Refusal>) -> Line<'a> {
    let first = group[0];
    let [name, flags, value, what] = parameter_line(first, refusal);
    let stem = stem(first);
    let motions = format!("{stem}.translate.x|y|z rotate.x|y|z");
    match (group.len(), first.kind) {
        (1, _) => [name, flags, value, what],
        (_, ParameterKind::Translation) => [
            format!("{motions} scale").into(),
            flags,
            "".into(),
            format!("moves, turns and scales {stem} (world units, radians, times its size)").into(),
        ],
        (_, ParameterKind::SensorTranslation) => [
            motions.into(),
            flags,
            "".into(),
            "moves and turns the sensor (world units, radians)".into(),
        ],
        _ => [
            format!("{name}[.r|g|b]").into(),
            flags,
            value,
            what.replace(", all channels together", "").into(),
        ],
    }
}

fn array_line<'a>(array: &'a ArrayParameter, refusal: Option<&Refusal>) -> Line<'a> {
    let moves = array.moves_discontinuities;
    match &array.alias_of {
        Some(other) => alias(&array.name, differentiable(moves, refusal), other),
        None => [
            array.name.as_str().into(),
            flags(differentiable(moves, refusal), moves).into(),
            array.shape_text().into(),
            format!("{} ({})", array.description, array.unit).into(),
        ],
    }
}

/// Another name for what is listed before.
fn alias<'a>(name: &'a str, differentiable: bool, other: &str) -> Line<'a> {
    [
        name.into(),
        flags(differentiable, false).into(),
        "".into(),
        format!("= {other}").into(),
    ]
}

fn flags(differentiable: bool, moves_discontinuities: bool) -> &'static str {
    match (differentiable, moves_discontinuities) {
        (true, true) => "∂ D",
        (true, false) => "∂",
        (false, true) => "- D",
        (false, false) => "-",
    }
}

/// Indented lines with their columns aligned to the left. Cells that are too long are cut.
fn table<'a>(lines: impl Iterator<Item = Line<'a>>) -> String {
    let short = |cell: Cow<'a, str>| match cut(&cell) {
        Cow::Owned(beginning) => beginning.into(),
        Cow::Borrowed(_) => cell,
    };
    let rows: Vec<Line> = lines
        .map(|[name, flags, value, what]| [short(name), flags, short(value), what])
        .collect();
    let width = |c: usize| rows.iter().map(|r| r[c].chars().count()).max().unwrap_or(0);
    let [a, b, c] = [width(0), width(1), width(2)];
    let mut text = String::new();
    for [name, flags, value, what] in &rows {
        write!(text, "  {name:a$}   {flags:b$}   {value:c$}   {what}").expect("strings take all");
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}

fn values(values: &[f64]) -> String {
    let numbers: Vec<String> = values.iter().map(|&x| report::number(x)).collect();
    numbers.join(" ")
}

fn to_json(
    scene: &Scene,
    parameters: &[Parameter],
    arrays: &[ArrayParameter],
    refusal: Option<&Refusal>,
) -> Value {
    let (low, high) = bounds(scene);
    let shapes = scene.shapes.iter().map(|shape| {
        json!({
            "id": shape.id,
            "triangles": shape.mesh.faces.len(),
            "vertices": shape.mesh.positions.len(),
            "material": scene.material(shape.bsdf).id,
            "emits": shape.emitter.map(|id| emits(scene, id)),
        })
    });
    let parameters = parameters.iter().map(|p| {
        json!({
            "name": p.name,
            "kind": format!("{:?}", p.kind),
            "value": p.value,
            "unit": p.unit,
            "description": p.description,
            "differentiable": differentiable(p.moves_discontinuities, refusal),
            "moves_discontinuities": p.moves_discontinuities,
            "alias_of": p.alias_of,
        })
    });
    let arrays = arrays.iter().map(|a| {
        json!({
            "name": a.name,
            "kind": format!("{:?}", a.kind),
            "shape": a.shape,
            "unit": a.unit,
            "description": a.description,
            "differentiable": differentiable(a.moves_discontinuities, refusal),
            "moves_discontinuities": a.moves_discontinuities,
            "alias_of": a.alias_of,
        })
    });
    json!({
        "size": scene.film.crop_size,
        "spp": scene.settings.spp,
        "seed": scene.settings.seed,
        "integrator": integrator(&scene.settings.integrator),
        "bounds": [low.to_array(), high.to_array()],
        "triangles": scene.shapes.iter().map(|s| s.mesh.faces.len()).sum::<usize>(),
        "shapes": shapes.collect::<Vec<_>>(),
        "parameters": parameters.collect::<Vec<_>>(),
        "arrays": arrays.collect::<Vec<_>>(),
        "refused": refusal.map(ToString::to_string),
    })
}

/// The radiance of an emitter: a colour, or what sort of texture it is.
fn emits(scene: &Scene, id: EmitterId) -> Value {
    let radiance = scene.emitter(id).radiance();
    match scene.texture(radiance).is_constant() {
        true => json!(scene.texture(radiance).texel(0).to_array()),
        false => json!(texture(scene, radiance)),
    }
}
