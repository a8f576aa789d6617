//! Integrators: `direct`, `path`, and `aov` for one AOV. Mitsuba's integrators
//! of derivatives are read as the one that makes the same image.

use capwalk_scene::{Aov, Integrator};

use crate::fields::Fields;
use crate::node::Kind;
use crate::problem::Problem;

/// Values of `type` that are read as they are.
const INTEGRATORS: [&str; 3] = ["aov", "direct", "path"];

/// Mitsuba's integrators of derivatives, and whose image each of them makes.
const OF_DERIVATIVES: [(&str, &str); 6] = [
    ("direct_projective", "direct"),
    ("direct_reparam", "direct"),
    ("prb", "path"),
    ("prb_basic", "path"),
    ("prb_projective", "path"),
    ("prb_reparam", "path"),
];

/// Properties that only they have.
const SETTINGS_OF_DERIVATIVES: [&str; 13] = [
    "guiding",
    "guiding_proj",
    "guiding_rounds",
    "project_seed",
    "reparam_antithetic",
    "reparam_exp",
    "reparam_kappa",
    "reparam_max_depth",
    "reparam_rays",
    "reparam_unroll",
    "sppc",
    "sppi",
    "sppp",
];

/// More samples or segments than this are a slip of the pen.
const MOST: i64 = i32::MAX as i64;

pub(super) fn lower(fields: &Fields) -> Result<Integrator, Problem> {
    let plugin = fields.node.plugin.as_str();
    let of_derivatives = OF_DERIVATIVES.iter().find(|(name, _)| *name == plugin);
    let integrator = match (plugin, of_derivatives) {
        ("aov", _) => aov(fields)?,
        ("direct", _) => direct(fields)?,
        ("path", _) => path(fields, -1)?,
        (_, Some((_, "direct"))) => direct_of_derivatives(fields)?,
        (_, Some(_)) => path(fields, 6)?, // Mitsuba's default for them
        (_, None) => return Err(fields.unknown_plugin(&INTEGRATORS)),
    };
    if let Some((name, read_as)) = of_derivatives {
        fields.warn(&format!(
            "the integrator \"{name}\" is read as \"{read_as}\", which makes the same image; \
             derivatives are always those of the whole image, by the method that is asked for"
        ));
        let reason = "it concerns how Mitsuba samples derivatives";
        fields.cosmetic(&SETTINGS_OF_DERIVATIVES, reason);
    }
    strict_normals(fields)?;
    fields.cosmetic(
        &["block_size", "samples_per_pass"],
        "it divides the work, which is done in our own way",
    );
    if let Some(timeout) = fields.optional_float("timeout")?
        && timeout > 0.0
    {
        let span = fields.span_of("timeout");
        return Err(
            Problem::unsupported(span, format!("\"timeout\" is {timeout}"))
                .help("rendering until a time has passed is not reproducible; choose sample_count"),
        );
    }
    fields.finish()?;
    Ok(integrator)
}

fn direct(fields: &Fields) -> Result<Integrator, Problem> {
    let shading = fields.integer("shading_samples", 0..=MOST)?;
    let emitter = fields.integer("emitter_samples", 0..=MOST)?;
    let bsdf = fields.integer("bsdf_samples", 0..=MOST)?;
    if shading.is_some() && (emitter.is_some() || bsdf.is_some()) {
        return Err(Problem::invalid(
            fields.span_of("shading_samples"),
            "\"shading_samples\" is given together with \"emitter_samples\" or \"bsdf_samples\"",
        )
        .help("it stands for both of them; keep either it or them"));
    }
    let shading = shading.unwrap_or(1);
    let (emitter, bsdf) = (emitter.unwrap_or(shading), bsdf.unwrap_or(shading));
    if emitter + bsdf == 0 {
        return Err(Problem::invalid(
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

/// One sample of an emitter and one of the material, as Mitsuba takes.
fn direct_of_derivatives(fields: &Fields) -> Result<Integrator, Problem> {
    let reason = "direct light ends at the first surface";
    fields.cosmetic(&["max_depth", "rr_depth"], reason);
    Ok(Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters: fields.boolean("hide_emitters", false)?,
    })
}

/// Mitsuba 0.6 could leave out light where the shading normal and the surface
/// disagree about the side.
fn strict_normals(fields: &Fields) -> Result<(), Problem> {
    if fields.boolean("strict_normals", false)? {
        fields.warn_at(
            "strict_normals",
            "is read as false: light on the wrong side of a smooth surface is not left out",
        );
    }
    Ok(())
}

fn path(fields: &Fields, default_depth: i64) -> Result<Integrator, Problem> {
    let max_depth = fields.integer("max_depth", -1..=MOST)?;
    let max_depth = max_depth.unwrap_or(default_depth);
    let rr_depth = fields.integer("rr_depth", 1..=MOST)?.unwrap_or(5);
    Ok(Integrator::Path {
        max_depth: u32::try_from(max_depth).ok(),
        rr_depth: rr_depth as u32,
        hide_emitters: fields.boolean("hide_emitters", false)?,
    })
}

/// The one AOV of `aovs`, a list of `name:kind`.
fn aov(fields: &Fields) -> Result<Integrator, Problem> {
    fields.refuse_object(
        Kind::Integrator,
        "keep the nested integrator for the image, without the \"aov\" around it, and make a \
         second file with \"aov\" alone",
    )?;
    let known = || Aov::ALL.map(Aov::name).join(", ");
    let Some(text) = fields.string("aovs")? else {
        return Err(
            Problem::missing(fields.node.span, "the integrator \"aov\" has no \"aovs\"").help(
                format!(
                    "add for example <string name=\"aovs\" value=\"depth:depth\"/>; known AOVs: {}",
                    known()
                ),
            ),
        );
    };
    let wrong =
        |what: String, help: String| Err(Problem::invalid(fields.span_of("aovs"), what).help(help));
    let entries: Vec<&str> = text.split(',').map(str::trim).collect();
    let &[entry] = entries.as_slice() else {
        return wrong(
            format!("\"aovs\" lists {} AOVs", entries.len()),
            "one AOV at a time is rendered; keep one".into(),
        );
    };
    let kind = entry.rsplit_once(':').map_or(entry, |(_, kind)| kind);
    match Aov::ALL.into_iter().find(|aov| aov.name() == kind) {
        Some(aov) => Ok(Integrator::Aov(aov)),
        None => wrong(
            format!("unknown AOV \"{kind}\""),
            format!("known AOVs: {}", known()),
        ),
    }
}
