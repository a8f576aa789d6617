//! Samplers: `independent`, and Sobol points as `sobol` or `ldsampler`. Other
//! stratified points of Mitsuba's are read as Sobol's.

use capwalk_scene::SamplerKind;

use crate::fields::Fields;
use crate::problem::Problem;

/// Values of `type` that are read as they are.
const SAMPLERS: [&str; 3] = ["independent", "ldsampler", "sobol"];

/// Samplers of Mitsuba whose points are stratified in another way.
const STRATIFIED: [&str; 3] = ["multijitter", "orthogonal", "stratified"];

/// What a sampler sets.
pub(super) struct Sampler {
    pub kind: SamplerKind,
    /// Samples per pixel.
    pub spp: u32,
    pub seed: u64,
}

impl Default for Sampler {
    fn default() -> Self {
        Self {
            kind: SamplerKind::Independent,
            spp: 4,
            seed: 0,
        }
    }
}

pub(super) fn lower(fields: &Fields) -> Result<Sampler, Problem> {
    let kind = match fields.node.plugin.as_str() {
        "independent" => SamplerKind::Independent,
        "ldsampler" | "sobol" => SamplerKind::Sobol,
        plugin if STRATIFIED.contains(&plugin) => {
            fields.warn(&format!(
                "the sampler \"{plugin}\" is read as \"sobol\": its points are stratified, too, \
                 and the image is the same but for noise"
            ));
            let reason = "Sobol points have no such setting";
            fields.cosmetic(&["jitter", "strength"], reason);
            SamplerKind::Sobol
        }
        _ => return Err(fields.unknown_plugin(&SAMPLERS)),
    };
    let sampler = Sampler {
        kind,
        spp: fields.count("sample_count", 1, Sampler::default().spp)?,
        seed: fields.integer("seed", 0..=i64::MAX)?.unwrap_or(0) as u64,
    };
    fields.finish()?;
    Ok(sampler)
}
