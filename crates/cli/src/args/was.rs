//! The arguments of warped-area sampling.

use clap::{Args, ValueEnum};

/// The options of `--method was` and `psdr-was`.
#[derive(Args, Debug, Default)]
pub struct WasArgs {
    /// was, psdr-was: concentration of auxiliary rays, which spread over about K^(-1/2)
    /// radians [default: 100000]
    #[arg(long, value_name = "K", value_parser = parse_concentration)]
    pub was_kappa: Option<f64>,
    /// was, psdr-was: auxiliary rays per direction; more rays, less bias [default: 8]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=65536))]
    pub was_rays: Option<u32>,
    /// was, psdr-was: how nearby silhouettes are detected [default: edges]
    #[arg(long)]
    pub was_boundary: Option<WasBoundaryName>,
    /// was, psdr-was: opposite pairs of auxiliary rays [default: true]
    #[arg(long, value_name = "BOOL", num_args = 0..=1, default_missing_value = "true")]
    pub was_antithetic: Option<bool>,
    /// was, psdr-was: remove this bias by random numbers of auxiliary rays (Russian
    /// roulette); slower and noisier
    #[arg(long)]
    pub was_debias: bool,
}

/// Boundary tests of warped-area sampling by name.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum WasBoundaryName {
    /// By interpolated normals: misses the silhouettes of flat faces
    Normals,
    /// By edges of triangles: correct for all meshes, noisier
    Edges,
}

fn parse_concentration(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(kappa) if kappa > 0.0 && kappa.is_finite() => Ok(kappa),
        _ => Err("expected a number above 0".into()),
    }
}
