//! What was typed for `capwalk figures`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::parse;

#[derive(Args, Debug)]
pub struct Figures {
    /// Which figures: their names, or "all"
    #[arg(value_name = "FIGURE", default_value = "all", value_parser = parse_figure)]
    pub names: Vec<String>,
    /// Folder for the report
    #[arg(short, long, value_name = "FOLDER", default_value = "figures")]
    pub out: PathBuf,
    /// How much work each figure is worth
    #[arg(long, default_value = "draft")]
    pub quality: QualityName,
    /// Mesh (.ply, .obj) that takes the place of the Voronoi bunny
    #[arg(long, value_name = "FILE")]
    pub mesh: Option<PathBuf>,
    /// Seed of all random numbers
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Worker threads; changes times only [default: all cores]
    #[arg(short = 't', long, value_name = "N", value_parser = parse::threads)]
    pub threads: Option<usize>,
    /// Print one JSON object instead of text
    #[arg(long)]
    pub json: bool,
}

/// Qualities by name.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum QualityName {
    /// Seconds: everything runs, little is decided
    Smoke,
    /// Minutes: most claims are decided
    Draft,
    /// Hours: the paper's sizes
    Full,
}

fn parse_figure(text: &str) -> Result<String, String> {
    let mut names: Vec<&str> = capwalk_figures::ALL.iter().map(|f| f.name).collect();
    names.push("all");
    match names.contains(&text) {
        true => Ok(text.into()),
        false => Err(format!("there are {}", names.join(", "))),
    }
}
