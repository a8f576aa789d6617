//! What was typed for `capwalk demo`.

use std::path::PathBuf;

use clap::Args;

use super::{SamplingArgs, parse_size};

#[derive(Args, Debug)]
#[command(
    mut_arg("spp", |arg| arg.help("Samples per pixel [default: 96]")),
    mut_arg("seed", |arg| arg.help("Seed of all random numbers [default: 1]")),
    mut_arg("time_limit", |arg| arg.help(
        "Stop after this time (30, 30s, 5m, 1h), shared among picture, gradients and reference, \
         and keep what is done"
    )),
)]
pub struct Demo {
    /// Folder for the pictures
    #[arg(short, long, value_name = "FOLDER", default_value = "demo")]
    pub output: PathBuf,
    /// Width and height of the pictures [default: 128x96]
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub size: Option<[u32; 2]>,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    /// Print one JSON object instead of text
    #[arg(long)]
    pub json: bool,
}
