//! What was typed for warped-area sampling.

use clap::{Args, ValueEnum};

/// How it is with `--method was` and `psdr-was`.
#[derive(Args, Debug, Default)]
pub struct WasArgs {
    /// was, psdr-was: concentration of auxiliary rays; they reach about K^(-1/2) radians
    /// far [default: 100000]
    #[arg(long, value_name = "K", value_parser = parse_concentration)]
    pub was_kappa: Option<f64>,
    /// was, psdr-was: auxiliary rays per direction; more of them, less bias [default: 8]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=65536))]
    pub was_rays: Option<u32>,
    /// was, psdr-was: how to tell that a silhouette is near [default: edges]
    #[arg(long)]
    pub was_boundary: Option<WasBoundaryName>,
    /// was, psdr-was: opposite pairs of auxiliary rays [default: true]
    #[arg(long, value_name = "BOOL", num_args = 0..=1, default_missing_value = "true")]
    pub was_antithetic: Option<bool>,
    /// was, psdr-was: random numbers of auxiliary rays (Russian roulette) without that bias,
    /// slower and noisier
    #[arg(long)]
    pub was_debias: bool,
}

/// Boundary tests of warped-area sampling by name.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum WasBoundaryName {
    /// Normals across the view: misses the silhouettes of flat faces
    Normals,
    /// Edges of triangles: right for all meshes, noisier
    Edges,
}

fn parse_concentration(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(kappa) if kappa > 0.0 && kappa.is_finite() => Ok(kappa),
        _ => Err("expected a number above 0".into()),
    }
}
