//! Integrators: `direct`, `path`, and `aov` for one layer.

use capwalk_scene::{Integrator, Layer};

use crate::fields::Fields;
use crate::source::Problem;

/// The plugins.
const INTEGRATORS: [&str; 3] = ["aov", "direct", "path"];

/// More samples or segments than this are a slip of the pen.
const MOST: i64 = i32::MAX as i64;

pub(super) fn lower(fields: &Fields) -> Result<Integrator, Problem> {
    let integrator = match fields.node.plugin.as_str() {
        "aov" => aov(fields)?,
        "direct" => direct(fields)?,
        "path" => path(fields)?,
        _ => return Err(fields.unknown_plugin(&INTEGRATORS)),
    };
    fields.cosmetic(
        &["block_size", "samples_per_pass"],
        "it divides the work, which is done in our own way",
    );
    if let Some(timeout) = fields.optional_float("timeout")?
        && timeout > 0.0
    {
        let span = fields.span_of("timeout");
        return Err(Problem::new(span, format!("\"timeout\" is {timeout}"))
            .help("rendering until a time has passed is not reproducible; choose sample_count"));
    }
    fields.finish()?;
    Ok(integrator)
}

fn direct(fields: &Fields) -> Result<Integrator, Problem> {
    let shading = fields.integer("shading_samples", 0..=MOST)?;
    let emitter = fields.integer("emitter_samples", 0..=MOST)?;
    let bsdf = fields.integer("bsdf_samples", 0..=MOST)?;
    if shading.is_some() && (emitter.is_some() || bsdf.is_some()) {
        return Err(Problem::new(
            fields.span_of("shading_samples"),
            "\"shading_samples\" is given together with \"emitter_samples\" or \"bsdf_samples\"",
        )
        .help("it stands for both of them; keep either it or them"));
    }
    let shading = shading.unwrap_or(1);
    let (emitter, bsdf) = (emitter.unwrap_or(shading), bsdf.unwrap_or(shading));
    if emitter + bsdf == 0 {
        return Err(Problem::new(
            fields.node.span,
            "the integrator \"direct\" takes neither emitter nor material samples",
        )
        .help("give at least one of emitter_samples and bsdf_samples"));
    }
    Ok(Integrator::Direct {
        emitter_samples: emitter as u32,
        bsdf_samples: bsdf as u32,
        hide_emitters: fields.boolean("hide_emitters", false)?,
    })
}

fn path(fields: &Fields) -> Result<Integrator, Problem> {
    let max_depth = fields.integer("max_depth", -1..=MOST)?.unwrap_or(-1);
    let rr_depth = fields.integer("rr_depth", 1..=MOST)?.unwrap_or(5);
    Ok(Integrator::Path {
        max_depth: u32::try_from(max_depth).ok(),
        rr_depth: rr_depth as u32,
        hide_emitters: fields.boolean("hide_emitters", false)?,
    })
}

/// `aovs` is a list of `name:layer`, of which we render one.
fn aov(fields: &Fields) -> Result<Integrator, Problem> {
    let known = || Layer::ALL.map(Layer::name).join(", ");
    let Some(text) = fields.string("aovs")? else {
        return Err(
            Problem::new(fields.node.span, "the integrator \"aov\" has no \"aovs\"").help(format!(
                "add for example <string name=\"aovs\" value=\"depth:depth\"/>; known layers: {}",
                known()
            )),
        );
    };
    let wrong =
        |what: String, help: String| Err(Problem::new(fields.span_of("aovs"), what).help(help));
    let entries: Vec<&str> = text.split(',').map(str::trim).collect();
    let &[entry] = entries.as_slice() else {
        return wrong(
            format!("\"aovs\" lists {} layers", entries.len()),
            "one layer at a time is rendered; keep one".into(),
        );
    };
    let kind = entry.rsplit_once(':').map_or(entry, |(_, kind)| kind);
    match Layer::ALL.into_iter().find(|layer| layer.name() == kind) {
        Some(layer) => Ok(Integrator::Aov(layer)),
        None => wrong(
            format!("unknown layer \"{kind}\""),
            format!("known layers: {}", known()),
        ),
    }
}
