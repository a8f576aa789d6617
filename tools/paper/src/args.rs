//! What was typed.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use capwalk_paper::{ALL, Quality};
use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand};

/// The paper's figures and claims, and its scene.
#[derive(Parser, Debug)]
#[command(name = "capwalk-paper", version, max_term_width = 100)]
pub struct Typed {
    /// What to do
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand, Debug)]
pub enum Command {
    /// Make the figures of the paper and test its claims, from measured data
    ///
    /// Writes images, CSV files and report.html, one page with everything.
    Figures(Figures),
    /// Write the shadow of the Voronoi bunny as Mitsuba XML, with its mesh
    Bunny {
        /// The file (.xml), or a folder for it
        #[arg(value_name = "FILE")]
        path: PathBuf,
    },
}

#[derive(Args, Debug)]
pub struct Figures {
    /// Which figures: their names, or "all"
    #[arg(value_name = "FIGURE", default_value = "all", value_parser = names())]
    pub names: Vec<String>,
    /// Folder for the report
    #[arg(short, long, value_name = "FOLDER", default_value = "figures")]
    pub out: PathBuf,
    /// How much work each figure is worth
    #[arg(long, default_value = "draft")]
    pub quality: Quality,
    /// Mesh (.ply, .obj) that takes the place of the Voronoi bunny
    #[arg(long, value_name = "FILE")]
    pub mesh: Option<PathBuf>,
    /// Seed of all random numbers
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Worker threads; changes times only [default: all cores]
    #[arg(short = 't', long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
    /// Print one JSON object instead of text
    #[arg(long)]
    pub json: bool,
}

fn names() -> PossibleValuesParser {
    let figures = ALL.iter().map(|figure| figure.name);
    figures.chain(["all"]).collect::<Vec<_>>().into()
}
