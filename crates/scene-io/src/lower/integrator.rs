//! Integrators: `direct`, `path`, and `aov` for one AOV. Others of Mitsuba are read as the one
//! that makes the same image.

use capwalk_scene::settings::{MOST_SAMPLES, MOST_SEGMENTS};
use capwalk_scene::{Aov, Integrator};

use crate::fields::{Context, Fields};
use crate::node::{Kind, NodeId};
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

/// Integrators that estimate the image of `path` in other ways, and what is to be said of it.
const OTHER_PATHS: [(&str, &str); 8] = [
    ("bdpt", LIGHT_PATHS),
    ("erpt", LIGHT_PATHS),
    ("mlt", LIGHT_PATHS),
    ("prbvolpath", WITHOUT_MEDIA),
    ("pssmlt", LIGHT_PATHS),
    ("ptracer", FROM_LIGHTS),
    ("volpath", WITHOUT_MEDIA),
    ("volpathmis", WITHOUT_MEDIA),
];

const LIGHT_PATHS: &str = "which estimates the same image";
const FROM_LIGHTS: &str = "which estimates the same image, and also what is seen in smooth mirrors \
                           and through smooth glass, which paths from the emitters cannot find";
const WITHOUT_MEDIA: &str = "which makes the same image without participating media; steps \
                             straight through masks and null surfaces count for max_depth";

/// Properties that only they have.
const SETTINGS_OF_OTHER_PATHS: [&str; 18] = [
    "bidirectional",
    "bidirectional_mutation",
    "caustic_perturbation",
    "chain_length",
    "direct_samples",
    "lens_perturbation",
    "light_image",
    "luminance_samples",
    "manifold_perturbation",
    "max_chains",
    "multi_chain_perturbation",
    "num_chains",
    "p_large",
    "sample_direct",
    "separate_direct",
    "two_stage",
    "use_mis",
    "lambda",
];

/// Integrators that are not read, and what to do instead.
const REFUSED: [(&str, &str); 8] = [
    (
        "adaptive",
        "write its nested integrator without it, and choose sample_count",
    ),
    (
        "irrcache",
        "it interpolates; write <integrator type=\"path\"/>",
    ),
    (
        "photonmapper",
        "its image is blurred; write <integrator type=\"path\"/>",
    ),
    (
        "ppm",
        "its image is blurred; write <integrator type=\"path\"/>",
    ),
    (
        "sppm",
        "its image is blurred; write <integrator type=\"path\"/>",
    ),
    (
        "stokes",
        "light has no polarization here; write its nested integrator without it",
    ),
    (
        "volprim_rf_basic",
        "volumes are not rendered; write <integrator type=\"path\"/>",
    ),
    (
        "vpl",
        "its image is clamped; write <integrator type=\"path\"/>",
    ),
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

/// More segments than this are a slip of the pen.
const MOST: i64 = i32::MAX as i64;

/// Integrators inside each other, at most.
const DEEPEST: usize = 8;

pub(super) fn lower(context: &Context, node: NodeId) -> Result<Integrator, Problem> {
    nested(context, node, DEEPEST)
}

/// The integrator of a node, in which others may stand so deep.
fn nested(context: &Context, node: NodeId, deepest: usize) -> Result<Integrator, Problem> {
    let fields = &Fields::new(context, node);
    if deepest == 0 {
        let message = "integrators stand inside each other too deep";
        return Err(Problem::unsupported(fields.node.span, message)
            .help(format!("expected at most {DEEPEST} inside each other")));
    }
    let plugin = fields.node.plugin.as_str();
    let read_as = |table: &[(&'static str, &'static str)]| {
        let found = table.iter().find(|(name, _)| *name == plugin);
        found.map(|&(_, meaning)| meaning)
    };
    let integrator = match (plugin, read_as(&OF_DERIVATIVES), read_as(&OTHER_PATHS)) {
        ("aov" | "moment", ..) => match wrapped(context, fields, deepest)? {
            Some(integrator) => integrator,
            None => aov(fields)?,
        },
        ("depth", ..) => {
            fields.warn("the integrator \"depth\" is read as \"aov\" with the AOV depth");
            Integrator::Aov(Aov::Depth)
        }
        ("direct", ..) => direct(fields)?,
        ("path", ..) => path(fields, -1)?,
        (_, Some(meaning), _) => of_derivatives(fields, meaning)?,
        (_, _, Some(why)) => {
            fields.warn(&format!(
                "the integrator \"{plugin}\" is read as \"path\", {why}"
            ));
            let reason = "it concerns how paths are sampled";
            fields.cosmetic(&SETTINGS_OF_OTHER_PATHS, reason);
            // Mitsuba's default for integrators of derivatives is 6.
            path(fields, if plugin == "prbvolpath" { 6 } else { -1 })?
        }
        _ => return Err(fields.refused_plugin(&INTEGRATORS, &REFUSED)),
    };
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

/// The image of the integrator in a `moment` or an `aov`, which add channels to it.
fn wrapped(
    context: &Context,
    fields: &Fields,
    deepest: usize,
) -> Result<Option<Integrator>, Problem> {
    let plugin = fields.node.plugin.as_str();
    let children = fields.children(Kind::Integrator);
    let Some((first, others)) = children.split_first() else {
        return match plugin {
            "aov" => Ok(None),
            _ => Err(Problem::missing(
                fields.node.span,
                format!("the integrator \"{plugin}\" has no integrator"),
            )
            .help("put the integrator into it that makes the image")),
        };
    };
    if let Some(other) = others.first() {
        let message = "only the image of the first integrator here is rendered";
        context.warn(other.span, message);
    }
    match plugin {
        "aov" => {
            fields.string("aovs")?;
            fields.warn(
                "the image of the nested integrator is rendered, and no AOV: leave the nested \
                 integrator out for them",
            );
        }
        _ => fields.warn(
            "the integrator \"moment\" is read as the one inside it: there are no channels of \
             second moments, errors of images are estimated without them",
        ),
    }
    nested(context, first.node, deepest - 1).map(Some)
}

/// An integrator of derivatives, which makes the image of `meaning`.
fn of_derivatives(fields: &Fields, meaning: &str) -> Result<Integrator, Problem> {
    let integrator = match meaning {
        "direct" => direct_of_derivatives(fields)?,
        _ => path(fields, 6)?, // Mitsuba's default for them
    };
    fields.warn(&format!(
        "the integrator \"{}\" is read as \"{meaning}\", which makes the same image; \
         derivatives are always those of the whole image, by the method that is asked for",
        fields.node.plugin
    ));
    let reason = "it concerns how Mitsuba samples derivatives";
    fields.cosmetic(&SETTINGS_OF_DERIVATIVES, reason);
    Ok(integrator)
}

fn direct(fields: &Fields) -> Result<Integrator, Problem> {
    let most = i64::from(MOST_SAMPLES);
    let shading = fields.integer("shading_samples", 0..=most)?;
    let emitter = fields.integer("emitter_samples", 0..=most)?;
    let bsdf = fields.integer("bsdf_samples", 0..=most)?;
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
    let is_long = |depth: i64| depth < 0 || depth > MOST_SEGMENTS.into();
    if is_long(max_depth) && is_long(rr_depth) {
        let message = format!("\"rr_depth\" is {rr_depth}: paths need not end before");
        return Err(
            Problem::invalid(fields.span_of("rr_depth"), message).help(format!(
                "expected at most {MOST_SEGMENTS}, or a max_depth of at most that"
            )),
        );
    }
    Ok(Integrator::Path {
        max_depth: u32::try_from(max_depth).ok(),
        rr_depth: rr_depth as u32,
        hide_emitters: fields.boolean("hide_emitters", false)?,
    })
}

/// The one AOV of `aovs`, a list of `name:kind`.
fn aov(fields: &Fields) -> Result<Integrator, Problem> {
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
