//! The arguments of the command line.

mod parse;
mod typed_method;

use std::num::NonZeroU32;
use std::path::PathBuf;
use std::time::Duration;

use capwalk::optimize::parse_duration;
use capwalk::{Device, Distance, Estimator, Filter, SensorChoice, Setting};
use clap::{ArgAction, Args, Parser, Subcommand};

pub use typed_method::TypedMethod;

/// Unbiased derivatives of rendered images.
#[derive(Parser, Debug)]
#[command(name = "capwalk", version, after_help = EXIT_CODES, max_term_width = 100)]
pub struct Cli {
    /// Say more: once for what is being done, twice for details
    #[arg(short, long, global = true, action = ArgAction::Count)]
    pub verbose: u8,
    /// What to do
    #[command(subcommand)]
    pub command: Command,
}

/// The meaning of each exit status, shown under `--help`.
const EXIT_CODES: &str = "\
A SCENE is a Mitsuba XML file, a glTF file or the name of a built-in scene (see `capwalk scenes`).

Exit status:
  0  done, also within a --time-limit; for check: the gradient is right
  1  check: the gradient is wrong; compare: the images differ beyond their errors;
     optimize: a guard stopped it (what was found before is written)
  2  check, compare: inconclusive, the noise is too large
  3  bad input, a derivative that is refused, results that cannot be written, or a
     --time-limit that ended before the first sample
  4  more than 1 in 10^6 samples was infinite or NaN (the images are written);
     optimize: the loss or its gradient was
  5  stopped by Ctrl-C or SIGTERM (what was done is written, if anything was, marked
     as partial)";

#[derive(Subcommand, Debug)]
pub enum Command {
    /// Render an image
    ///
    /// Writes SCENE.exr and SCENE.png unless -o says otherwise.
    Render(Render),
    /// Differentiate the image with respect to one parameter
    ///
    /// Writes SCENE-gradient.exr (value, gradient and their standard errors)
    /// and SCENE-gradient.png (blue negative, white zero, red positive)
    /// unless -o says otherwise.
    Gradient(GradientOn),
    /// Differentiate a loss with respect to many parameters at once
    ///
    /// The loss is given by its derivative with respect to every pixel
    /// (--adjoint), or is the distance of the image to a target (--loss). Writes
    /// SCENE-backward.npz, one array per parameter, unless -o says otherwise.
    Backward(Backward),
    /// Check a gradient against central finite differences
    ///
    /// Writes SCENE-check.png (value | gradient | reference | z) unless -o
    /// says otherwise. Exit status 0: right, 1: wrong, 2: inconclusive.
    Check(Check),
    /// Show what is in a scene, and which of its parameters can be differentiated
    Info(Info),
    /// Compare two images, with their standard errors if they have them
    Compare(Compare),
    /// List the built-in scenes, or export them as files
    Scenes(Scenes),
    /// Find the parameters for which the images of a scene match given ones
    ///
    /// A JOB is a TOML file, see docs/optimize.md. Every iteration is saved: a
    /// run that was stopped continues with --resume, and ends in the same bits.
    Optimize(Optimize),
    /// Render, differentiate and check the scene lattice-shadow
    ///
    /// Takes a quarter of a minute on two cores. Exit status as for check.
    Demo(Demo),
    /// Say which program makes the figures of the paper
    #[command(hide = true, disable_help_flag = true)]
    Figures {
        /// What that program would take
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<String>,
    },
}

impl Command {
    /// How many threads are to work, if that was said.
    pub fn threads(&self) -> Option<usize> {
        match self {
            Self::Render(args) => args.sampling.threads,
            Self::Gradient(args) => args.gradient.sampling.threads,
            Self::Backward(args) => args.sampling.threads,
            Self::Check(args) => args.gradient.sampling.threads,
            Self::Optimize(args) => args.threads,
            Self::Demo(args) => args.sampling.threads,
            Self::Info(_) | Self::Compare(_) | Self::Scenes(_) | Self::Figures { .. } => None,
        }
    }

    /// How long it may take, if that was said: from its start, reading and preparation included.
    pub fn time_limit(&self) -> Option<Duration> {
        match self {
            Self::Render(args) => args.sampling.time_limit,
            Self::Gradient(args) => args.gradient.sampling.time_limit,
            Self::Backward(args) => args.sampling.time_limit,
            Self::Check(args) => args.gradient.sampling.time_limit,
            Self::Demo(args) => args.sampling.time_limit,
            Self::Optimize(args) => args.time_limit,
            Self::Info(_) | Self::Compare(_) | Self::Scenes(_) | Self::Figures { .. } => None,
        }
    }
}

/// Which scene, and changes to it.
#[derive(Args, Debug, Default)]
pub struct SceneArgs {
    /// Mitsuba XML file, glTF file, or name of a built-in scene
    pub scene: String,
    /// Replace the default of a $name in the scene file
    #[arg(short = 'D', long = "define", value_name = "NAME=VALUE", value_parser = parse::define)]
    pub defines: Vec<(String, String)>,
    /// Which of the scene's sensors: its number, counted from 0, or its name [default: the
    /// first]
    #[arg(short = 's', long, value_name = "NUMBER|NAME", value_parser = str::parse::<SensorChoice>)]
    pub sensor: Option<SensorChoice>,
    /// Set a parameter before anything is done: `lamp.emitter.radiance.value=10`,
    /// `floor.bsdf.reflectance.value=0.2,0.4,0.6`. Places are relative:
    /// `ball.translate.x=0.1` moves the ball. `capwalk info SCENE` lists names; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE[,VALUE...]")]
    pub settings: Vec<Setting>,
    /// Width and height of the image, without crop
    #[arg(long, value_name = "WxH", value_parser = parse::size, allow_hyphen_values = true)]
    pub size: Option<[u32; 2]>,
    /// Reconstruction filter, with the widths that are Mitsuba's defaults
    #[arg(long, value_parser = parse::choice::<Filter>())]
    pub filter: Option<Filter>,
}

/// How much to sample.
#[derive(Args, Debug)]
pub struct SamplingArgs {
    /// Samples per pixel [default: the scene's]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub spp: Option<u32>,
    /// Seed of all random numbers [default: the scene's]
    #[arg(long, value_name = "N", value_parser = parse::seed)]
    pub seed: Option<u64>,
    /// Worker threads; changes no bit of the result [default: all cores]
    #[arg(short = 't', long, value_name = "N", value_parser = parse::threads)]
    pub threads: Option<usize>,
    /// Stop this long (30, 30s, 5m, 1h) after the start of the command, which reads and
    /// prepares the scene first, and keep what is done, if anything is
    #[arg(long, value_name = "TIME", value_parser = parse_duration, allow_hyphen_values = true)]
    pub time_limit: Option<Duration>,
}

/// Where results go.
#[derive(Args, Debug)]
pub struct OutputArgs {
    /// Output file: .exr and .npz hold all layers in floating point, .png and .svg a
    /// preview; may be repeated or separated by commas
    #[arg(short, long, value_name = "FILE", value_delimiter = ',')]
    pub output: Vec<PathBuf>,
    /// Print one JSON object instead of text
    #[arg(long)]
    pub json: bool,
}

/// How numbers of either sign become colours.
#[derive(Args, Debug)]
pub struct ColourArgs {
    /// In pictures, the number at which the colours of derivatives and differences end on both sides,
    /// spread evenly: the same for images that are to be compared [default: chosen from the image,
    /// logarithmic where silhouettes are far above the rest]
    #[arg(long, value_name = "X", value_parser = parse::limit)]
    pub limit: Option<f64>,
}

/// What moves.
#[derive(Args, Debug)]
#[group(required = true, multiple = true)]
pub struct MotionArgs {
    /// Parameter, or several that move together: 'lamp.translate.x -
    /// 0.5*floor.rotate.z'; numbers of arrays by their indices:
    /// `ball.positions[12,0]` (`capwalk info SCENE` lists them)
    #[arg(short, long, value_name = "EXPRESSION", allow_hyphen_values = true)]
    pub param: Option<String>,
    /// Velocity of each vertex of a shape: .npy array (V, 3), or a text file
    /// with one "x y z" per line; adds to --param
    #[arg(long, value_name = "SHAPE=FILE", value_parser = parse::motion)]
    pub motion: Vec<(String, PathBuf)>,
}

/// How derivatives are estimated.
#[derive(Args, Debug)]
pub struct MethodArgs {
    /// How discontinuities at edges are accounted for [default: auto; walk if one of its options
    /// is given]
    #[arg(long, value_parser = parse::method())]
    pub method: Option<TypedMethod>,
    #[command(flatten)]
    pub walk: WalkArgs,
}

/// How the velocity field is estimated with `--method walk`, and where `edges` walks.
#[derive(Args, Debug, Default)]
pub struct WalkArgs {
    /// Steps of the walk on spherical caps [default: 1]
    #[arg(long, value_name = "M", value_parser = clap::value_parser!(u32).range(1..=64))]
    pub walk_steps: Option<u32>,
    /// Estimator of the field's divergence [default: anchored]
    #[arg(long, value_parser = parse::choice::<Estimator>())]
    pub estimator: Option<Estimator>,
    /// Angular cutoff: ignore silhouettes farther than this, degrees; unbiased for
    /// every value, smaller is faster, larger gives a smoother field [default for walk: found by a
    /// pilot, at most 11.5]
    #[arg(long, value_name = "DEGREES", value_parser = parse::angle)]
    pub max_angle: Option<f64>,
    /// Average each rim sample with the one on the other side of the cap
    #[arg(long)]
    pub antithetic: bool,
}

#[derive(Args, Debug)]
#[command(allow_negative_numbers = true)]
pub struct Render {
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    /// Give pixels more or fewer samples by how noisy they are, in the time that --spp of each
    /// take, from 16 on
    #[arg(long)]
    pub adaptive: bool,
    /// Where to render: equal seeds give equal bits on one device
    #[arg(long, value_name = "DEVICE", default_value = "cpu", value_parser = parse::choice::<Device>())]
    pub device: Device,
    #[command(flatten)]
    pub output: OutputArgs,
}

#[derive(Args, Debug)]
pub struct Gradient {
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub tangent: MotionArgs,
    #[command(flatten)]
    pub method: MethodArgs,
    /// Step of the finite differences, in units of the parameter [default:
    /// moves the fastest vertex by 1/100 of the size of the shape it belongs
    /// to (of the scene, where the sensor moves), and nothing by more than a
    /// part of a pixel; for colours, 0.01; a quarter of these with --method fd]
    #[arg(long, value_name = "H", value_parser = parse::step)]
    pub step: Option<f64>,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    /// Give pixels more or fewer samples by how noisy they are, in the time that --spp of each
    /// take, from 16 on (`check` always does)
    #[arg(long)]
    pub adaptive: bool,
    #[command(flatten)]
    pub colours: ColourArgs,
    #[command(flatten)]
    pub output: OutputArgs,
}

/// A gradient, and where it is computed.
#[derive(Args, Debug)]
#[command(allow_negative_numbers = true)]
pub struct GradientOn {
    #[command(flatten)]
    pub gradient: Gradient,
    /// Where to compute: equal seeds give equal bits on one device
    #[arg(long, value_name = "DEVICE", default_value = "cpu", value_parser = parse::choice::<Device>())]
    pub device: Device,
}

/// What is differentiated.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub struct ObjectiveArgs {
    /// Image (.exr, .npz) of the derivative of a loss with respect to every pixel
    /// and channel, computed from a rendering with another seed
    #[arg(long, value_name = "FILE")]
    pub adjoint: Option<PathBuf>,
    /// Distance of the image to the --target, a mean over pixels and
    /// channels. The image is rendered first, with the seed's complement; a
    /// quarter of a --time-limit is for it
    #[arg(long, requires = "target", value_parser = parse::choice::<Distance>())]
    pub loss: Option<Distance>,
}

#[derive(Args, Debug)]
#[command(allow_negative_numbers = true)]
pub struct Backward {
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub objective: ObjectiveArgs,
    /// Target image (.exr, .npz), for --loss
    #[arg(long, value_name = "FILE", requires = "loss")]
    pub target: Option<PathBuf>,
    /// Layer of the --adjoint [default: adjoint, else value] or of the --target
    /// [default: value]
    #[arg(long, value_name = "NAME")]
    pub layer: Option<String>,
    /// What to differentiate with respect to: arrays such as ball.positions, parameters such
    /// as ball.translate.x, or sums of parameters as for `gradient` [default:
    /// all arrays that can be] (`capwalk info SCENE` lists them)
    #[arg(short, long, value_name = "NAMES", num_args = 1..)]
    pub param: Vec<String>,
    /// Also write the standard error of every number, as NAME.stderr
    #[arg(long)]
    pub errors: bool,
    #[command(flatten)]
    pub method: MethodArgs,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    /// Where to compute: equal seeds give equal bits on one device. The image that a --loss is of is
    /// rendered by the CPU
    #[arg(long, value_name = "DEVICE", default_value = "cpu", value_parser = parse::choice::<Device>())]
    pub device: Device,
    /// Output file (.npz)
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Print one JSON object instead of text
    #[arg(long)]
    pub json: bool,
}

#[derive(Args, Debug)]
#[command(allow_negative_numbers = true)]
pub struct Check {
    #[command(flatten)]
    pub gradient: Gradient,
    /// Samples per pixel of the first reference, taken on each side of the difference; others have
    /// four times as many [default: as many as suit the noise of both]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub reference_spp: Option<u32>,
}

#[derive(Args, Debug)]
#[command(allow_negative_numbers = true)]
pub struct Info {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// List each parameter on a line of its own, and other names of the same
    #[arg(long)]
    pub all: bool,
    /// Print one JSON object instead of text
    #[arg(long)]
    pub json: bool,
}

#[derive(Args, Debug)]
#[command(allow_negative_numbers = true)]
pub struct Compare {
    /// Image to be compared (.exr, .npz)
    pub image: PathBuf,
    /// Reference image (.exr, .npz)
    pub reference: PathBuf,
    /// Compare these layers, for example "gradient" [default: gradient if both
    /// have it, else value]
    #[arg(long, value_name = "NAME")]
    pub layer: Option<String>,
    #[command(flatten)]
    pub colours: ColourArgs,
    #[command(flatten)]
    pub output: OutputArgs,
}

#[derive(Args, Debug)]
#[command(allow_negative_numbers = true)]
pub struct Scenes {
    /// Write scenes as Mitsuba XML, with their meshes, into this folder
    #[arg(long, value_name = "FOLDER")]
    pub export: Option<PathBuf>,
    /// Only these scenes
    pub names: Vec<String>,
    /// Print one JSON object instead of text
    #[arg(long)]
    pub json: bool,
}

#[derive(Args, Debug)]
#[command(allow_negative_numbers = true)]
pub struct Optimize {
    /// TOML file with parameters, targets and options
    pub job: PathBuf,
    /// Continue the run in the output folder, if there is one
    #[arg(long)]
    pub resume: bool,
    /// Stop after N more iterations; --resume continues from there
    #[arg(long, value_name = "N", value_parser = parse::iterations)]
    pub pause_after: Option<NonZeroU32>,
    /// Show the run in the viewer of Rerun; needs the Python package with its extra `rerun`
    #[arg(long)]
    pub view: bool,
    /// Output folder [default: the job's `output`, or its path with the ending
    /// .out]
    #[arg(short, long, value_name = "FOLDER")]
    pub output: Option<PathBuf>,
    /// Worker threads; changes no bit of the result [default: all cores]
    #[arg(short = 't', long, value_name = "N", value_parser = parse::threads)]
    pub threads: Option<usize>,
    /// Stop this long (30, 30s, 5m, 1h) after the start of the command and keep what
    /// is done [default: the job's]
    #[arg(long, value_name = "TIME", value_parser = parse_duration, allow_hyphen_values = true)]
    pub time_limit: Option<Duration>,
    /// Print one JSON object instead of text
    #[arg(long)]
    pub json: bool,
}

#[derive(Args, Debug)]
#[command(
    allow_negative_numbers = true,
    mut_arg("spp", |arg| arg.help("Samples per pixel [default: 96]")),
    mut_arg("seed", |arg| arg.help("Seed of all random numbers [default: 1]")),
    mut_arg("time_limit", |arg| arg.help(
        "Stop after this time (30, 30s, 5m, 1h), shared among image, gradients and reference, \
         and keep what is done"
    )),
)]
pub struct Demo {
    /// Folder for the images
    #[arg(short, long, value_name = "FOLDER", default_value = "demo")]
    pub output: PathBuf,
    /// Width and height of the images [default: 128x96]
    #[arg(long, value_name = "WxH", value_parser = parse::size, allow_hyphen_values = true)]
    pub size: Option<[u32; 2]>,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    /// Print one JSON object instead of text
    #[arg(long)]
    pub json: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        use clap::CommandFactory;
        Cli::command().debug_assert();
    }

    /// A negative number is the value of the option before it, and no unknown option: the message
    /// says what was expected instead.
    #[test]
    fn negative_numbers_are_values() {
        use clap::CommandFactory;
        const NUMBERS: [&str; 6] = ["N", "WxH", "TIME", "H", "DEGREES", "M"];
        let mut tried = 0;
        for command in Cli::command().get_subcommands() {
            for option in command.get_arguments() {
                let name = option.get_value_names().unwrap_or_default();
                let Some(long) = option.get_long() else {
                    continue;
                };
                if !name
                    .first()
                    .is_some_and(|name| NUMBERS.contains(&name.as_str()))
                {
                    continue;
                }
                for value in ["-1", "-1x3", "-0.5"] {
                    let typed = format!("--{long}");
                    let typed = ["capwalk", command.get_name(), &typed, value];
                    let is_number = value.parse::<f64>().is_ok();
                    if !is_number && name[0] != "WxH" {
                        continue;
                    }
                    let error = Cli::try_parse_from(typed).expect_err("it is negative");
                    let text = error.to_string();
                    assert!(text.contains(&format!("invalid value '{value}'")), "{text}");
                    assert!(!text.contains("-- -"), "{text}");
                    let says = |words: &str| text.contains(words);
                    assert!(
                        says("expected") || says("not in") || says("invalid digit"),
                        "{text}"
                    );
                    tried += 1;
                }
            }
        }
        assert!(tried > 50, "{tried}");
    }
}
