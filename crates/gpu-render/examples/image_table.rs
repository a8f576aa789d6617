//! Images and gradients per second on the adapter that is found, through each interface that
//! reaches it, beside those of the CPU's threads, and how far both agree.
//!
//! `image_table [--adapter PART] SCENE PARAMETER [SCENE PARAMETER ...]`, where a scene is a
//! Mitsuba 3 XML file or a built-in one, and the parameter moves a shape, as
//! `leaf leaf.translate.x`; part of an adapter's name chooses it. `cargo xtask gpu` names the
//! scenes. Each has four tasks: the image, its derivative along the parameter (forward mode), and
//! the gradient of a loss with respect to all vertices of what moves, and with respect to the
//! colours of all surfaces (reverse mode). The loss is a weighted mean of the pixels, with the
//! weights of `xtask/peers.py`.
//!
//! Each side takes as many samples as fill some time, with random numbers of its own, after a run
//! in which kernels are compiled; of some more runs the fastest counts. Derivatives are by
//! [`Method::EDGES`] on both sides, which is what the device takes where none is asked for.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::{Duration, Instant};

use capwalk_boundary::pool;
use capwalk_diff::{
    Backward, Estimate, GradientImage, GradientOptions, Method, PreparedScene, RenderOptions,
    Rendering, Statistics, Unwatched, Wanted, backward, gradient, render,
};
use capwalk_gpu::{Gpu, GpuOptions, Interface};
use capwalk_gpu_render::{DeviceError, DeviceScene};
use capwalk_math::Rgb;
use capwalk_scene::params::Registry;
use capwalk_scene::{Image, Scene, Tangent, builtin};
use capwalk_scene_io::load_scene;

const USAGE: &str = "usage: image_table [--adapter PART] SCENE PARAMETER [SCENE PARAMETER ...]";

/// Samples of a pixel at least: one for each batch, whose spread gives the errors of a gradient.
const FEWEST: u32 = 16;
/// Parts of an image in each direction, whose means are compared.
const PARTS: usize = 3;
/// Motions of a shape along which gradients are compared.
const MOTIONS: [&str; 7] = [
    "translate.x",
    "translate.y",
    "translate.z",
    "rotate.x",
    "rotate.y",
    "rotate.z",
    "scale",
];
/// Where the textures stand that the gradient of colours is of.
const COLOURS: [&str; 2] = ["reflectance", "diffuse_reflectance"];
/// Numbers that differ by more standard errors do not agree. By accident one normal number in 500
/// million does, and one in 700,000 of those whose errors come from 16 batches on each side.
const TOO_FAR: f64 = 6.0;

/// How much is measured.
struct Effort {
    /// The width of all images, which keep their form; the scenes' own if `None`.
    width: Option<u32>,
    /// How long a run takes at least.
    least: Duration,
    /// Runs after the first one, in which kernels are compiled. The fastest counts; the first one if
    /// there is no other.
    rounds: usize,
}

const ON_HARDWARE: Effort = Effort {
    width: None,
    least: Duration::from_millis(500),
    rounds: 3,
};

const IN_SOFTWARE: Effort = Effort {
    width: Some(16),
    least: Duration::ZERO,
    rounds: 0,
};

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (adapter, scenes) = match &arguments[..] {
        [option, adapter, scenes @ ..] if option == "--adapter" => (Some(adapter.clone()), scenes),
        scenes => (None, scenes),
    };
    if scenes.is_empty() || !scenes.len().is_multiple_of(2) {
        return Err(USAGE.into());
    }
    let gpus = open(adapter)?;
    let threads = pool::install(rayon::current_num_threads);
    println!("The CPU has {threads} threads.");
    let is_software = gpus.iter().all(|gpu| gpu.is_software());
    let effort = match is_software {
        true => IN_SOFTWARE,
        false => ON_HARDWARE,
    };
    if is_software {
        println!("This adapter is software: no figure is from hardware");
    }
    println!(
        "\n| scene | task | through | kernels, million samples per second | whole call | \
         CPU | x CPU | loss, or its derivative | its error after a second | \
         CPU's | off by at most |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    let mut faults = 0;
    for pair in scenes.chunks_exact(2) {
        faults += measure(&pair[0], &pair[1], &gpus, &effort)?;
    }
    match faults {
        0 => Ok(()),
        _ => Err(format!("{faults} rows have no figures, or do not agree").into()),
    }
}

/// The adapter through each interface; no software where there is anything else.
fn open(adapter: Option<String>) -> Result<Vec<Arc<Gpu>>, Box<dyn Error>> {
    let mut options = GpuOptions::default();
    options.adapter = adapter;
    let mut gpus = Vec::new();
    for interface in [Interface::Wgpu, Interface::Cuda] {
        options.interface = Some(interface);
        match Gpu::new(&options) {
            Ok(gpu) => gpus.push(Arc::new(gpu)),
            Err(error) => println!("{interface:?}: left out, {error}"),
        }
    }
    if gpus.iter().any(|gpu| !gpu.is_software()) {
        gpus.retain(|gpu| !gpu.is_software());
    }
    for gpu in &gpus {
        let (interface, precision) = (gpu.interface(), gpu.precision());
        let (name, driver) = (gpu.name(), gpu.driver());
        println!(
            "{interface:?}: {name} ({}), {precision:?} precision",
            driver.trim()
        );
    }
    match gpus.is_empty() {
        true => Err("there is no adapter; docs/gpu.md says what to install".into()),
        false => Ok(gpus),
    }
}

/// Prints the rows of a scene. Returns how many do not agree, or have no figures although the
/// device has all that is needed.
fn measure(
    name: &str,
    parameter: &str,
    gpus: &[Arc<Gpu>],
    effort: &Effort,
) -> Result<usize, Box<dyn Error>> {
    let mut scene = match builtin::scene(name) {
        Some(scene) => scene,
        None => load_scene(Path::new(name), &[])?.scene,
    };
    if let Some(width) = effort.width {
        let [own, height] = scene.film.crop_size;
        scene.film.resize([width, (height * width / own).max(1)]);
    }
    let tasks = tasks(&scene, parameter)?;
    let weights = smooth_weights(scene.film.crop_size);
    let prepared = PreparedScene::new(scene);
    let short = Path::new(name).file_stem().unwrap_or_default().display();
    let mut faults = 0;
    for task in tasks {
        let own = fastest(&Place::Cpu(&prepared), &task, &weights, effort)?;
        for gpu in gpus {
            print!("| {short} | {} | {:?} | ", task.name(), gpu.interface());
            let found = DeviceScene::new(gpu, &prepared)
                .and_then(|scene| fastest(&Place::Device(gpu, &scene), &task, &weights, effort));
            match found {
                Ok(found) => faults += usize::from(!row(&found, &own)),
                Err(error) => {
                    println!("left out: {error} |");
                    faults += usize::from(!matches!(error, DeviceError::Unsupported(_)));
                }
            }
        }
    }
    Ok(faults)
}

/// Prints figures of a device beside the CPU's. Returns whether both agree.
fn row(found: &Run, own: &Run) -> bool {
    let pairs = || found.numbers.iter().zip(&own.numbers);
    let most = pairs().map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
    // What is no number is no agreement.
    let agrees = most <= TOO_FAR && pairs().all(|(a, b)| a.is_finite() && b.is_finite());
    let loss = found.numbers[0];
    println!(
        "{:.4} | {:.4} | {:.4} | {:.3} | {:.4e} ± {:.1e} | {:.1e} | {:.1e} | {most:.1} of {}{} |",
        found.rate(found.kernels),
        found.rate(found.whole),
        own.rate(own.whole),
        found.rate(found.whole) / own.rate(own.whole),
        loss.value,
        loss.error,
        found.error_after_a_second(),
        own.error_after_a_second(),
        found.numbers.len(),
        match agrees {
            true => "",
            false => ", DIFFERENT",
        },
    );
    agrees
}

/// What is asked of a scene.
enum Task {
    Image,
    /// Along a motion.
    DerivativeImage(Tangent),
    /// Its name, what is wanted, and along what the gradient is compared: of the first, the table
    /// has the derivative.
    Gradient(&'static str, Wanted, Vec<Tangent>),
}

fn tasks(scene: &Scene, parameter: &str) -> Result<[Task; 4], Box<dyn Error>> {
    let registry = Registry::new(scene);
    let motion = registry.tangent(scene, parameter)?;
    let vertices = Wanted::by(&motion);
    let shape = parameter.split('.').next().unwrap_or_default();
    let mut motions = vec![motion.clone()];
    for name in MOTIONS {
        motions.push(registry.tangent(scene, &format!("{shape}.{name}"))?);
    }
    let colours = colours(scene);
    let wanted = Wanted::by(&colours[0]);
    Ok([
        Task::Image,
        Task::DerivativeImage(motion),
        Task::Gradient("gradient, all vertices", vertices, motions),
        Task::Gradient("gradient, all colours", wanted, colours),
    ])
}

/// All colours grow alike, and each of them alone.
fn colours(scene: &Scene) -> Vec<Tangent> {
    let mut all = vec![Tangent::zero(scene)];
    for shape in &scene.shapes {
        let slots = scene.slots_below(shape.bsdf).into_iter();
        for slot in slots.filter(|slot| COLOURS.contains(&slot.name)) {
            let id = scene.numbers_of(slot.texture, shape).0 as usize;
            if all[0].textures[id].is_none() {
                let mut alone = Tangent::zero(scene);
                alone.textures[id] = Some(vec![1.0; scene.textures[id].data.len()]);
                all[0].add(&alone);
                all.push(alone);
            }
        }
    }
    all
}

/// The derivative of the loss with respect to each pixel.
fn smooth_weights([width, height]: [u32; 2]) -> Image {
    let weight = |i: u32, channel: f64| {
        let x = f64::from(i % width) / f64::from(width);
        let y = f64::from(i / width) / f64::from(height);
        1.0 + 0.5 * (7.0 * x + 2.0 * channel).sin() * (5.0 * y + 1.0).cos()
    };
    let count = f64::from(3 * width * height);
    let pixel = |i: u32| Rgb::from([0.0, 1.0, 2.0].map(|channel| weight(i, channel) / count));
    Image {
        width: width as usize,
        height: height as usize,
        pixels: (0..width * height).map(pixel).collect(),
    }
}

impl Task {
    fn name(&self) -> &'static str {
        match self {
            Self::Image => "image",
            Self::DerivativeImage(_) => "derivative image",
            Self::Gradient(name, ..) => name,
        }
    }

    /// The loss or its derivative, other numbers that are compared, and what was done.
    fn numbers(
        &self,
        place: &Place,
        weights: &Image,
        spp: u32,
    ) -> Result<(Vec<Number>, Statistics), DeviceError> {
        Ok(match self {
            Self::Image => {
                let image = place.render(spp)?;
                (means(&image.value, weights), image.statistics)
            }
            Self::DerivativeImage(tangent) => {
                let image = place.gradient(tangent, spp)?;
                (means(&image.gradient, weights), image.statistics)
            }
            Self::Gradient(_, wanted, tangents) => {
                let gradient = place.backward(weights, wanted, spp)?;
                let along = tangents.iter().map(|tangent| gradient.along(tangent));
                let numbers = along.map(|(value, error)| Number { value, error });
                (numbers.collect(), gradient.statistics)
            }
        })
    }
}

/// A number and its standard error.
#[derive(Clone, Copy)]
struct Number {
    value: f64,
    error: f64,
}

impl Number {
    /// How many standard errors two independent numbers are apart.
    fn distance(&self, other: &Self) -> f64 {
        match (self.value - other.value).abs() {
            0.0 => 0.0,
            difference => difference / self.error.hypot(other.error),
        }
    }

    fn is_finite(&self) -> bool {
        self.value.is_finite() && self.error.is_finite()
    }
}

/// The weighted sum of all pixels, and the mean of each part and channel.
fn means(estimate: &Estimate, weights: &Image) -> Vec<Number> {
    let Estimate {
        mean,
        standard_error: errors,
    } = estimate;
    let (mut loss, mut square) = (0.0, 0.0);
    let mut parts = [[[0.0; 2]; 3]; PARTS * PARTS];
    let mut counts = [0.0; PARTS * PARTS];
    for (i, &weight) in weights.pixels.iter().enumerate() {
        let (pixel, error) = (mean.pixels[i], errors.pixels[i]);
        loss += weight.dot(pixel);
        // As if the errors of the channels always added up: they come from the same paths.
        square += weight.dot(error).powi(2);
        let [x, y] = [
            i % mean.width * PARTS / mean.width,
            i / mean.width * PARTS / mean.height,
        ];
        counts[y * PARTS + x] += 1.0;
        for (channel, [sum, square]) in parts[y * PARTS + x].iter_mut().enumerate() {
            *sum += pixel[channel];
            *square += error[channel] * error[channel];
        }
    }
    let loss = Number {
        value: loss,
        error: square.sqrt(),
    };
    let parts = parts.iter().zip(counts);
    let parts = parts.flat_map(|(channels, count)| channels.map(|sums| (sums, count)));
    let parts = parts.map(|([sum, square], count)| Number {
        value: sum / count,
        error: square.sqrt() / count,
    });
    [loss].into_iter().chain(parts).collect()
}

/// Who computes.
enum Place<'a> {
    Cpu(&'a PreparedScene),
    Device(&'a Gpu, &'a DeviceScene<'a>),
}

impl Place<'_> {
    fn render(&self, spp: u32) -> Result<Rendering, DeviceError> {
        let options = self.options(spp).sampling();
        match self {
            Self::Cpu(scene) => Ok(render(scene, &options, &Unwatched)),
            Self::Device(_, scene) => scene.render(&options, &Unwatched),
        }
    }

    fn gradient(&self, tangent: &Tangent, spp: u32) -> Result<GradientImage, DeviceError> {
        let options = self.options(spp);
        match self {
            Self::Cpu(scene) => Ok(gradient(scene, tangent, &options, &Unwatched)?),
            Self::Device(_, scene) => scene.gradient(tangent, &options, &Unwatched),
        }
    }

    fn backward(
        &self,
        weights: &Image,
        wanted: &Wanted,
        spp: u32,
    ) -> Result<Backward, DeviceError> {
        let options = self.options(spp);
        match self {
            Self::Cpu(scene) => Ok(backward(scene, weights, wanted, &options, &Unwatched)?),
            Self::Device(_, scene) => scene.backward(weights, wanted, &options, &Unwatched),
        }
    }

    /// Each has random numbers of its own.
    fn options(&self, spp: u32) -> GradientOptions {
        let seed = match self {
            Self::Cpu(_) => 1,
            Self::Device(..) => 2,
        };
        GradientOptions {
            method: Method::EDGES,
            ..RenderOptions::new(spp, seed).into()
        }
    }

    /// How long kernels have run so far.
    fn busy(&self) -> Duration {
        match self {
            Self::Cpu(_) => Duration::ZERO,
            Self::Device(gpu, _) => gpu.busy(),
        }
    }
}

/// A task that was done, and the least times that it took: of the kernels alone, and in all.
struct Run {
    numbers: Vec<Number>,
    samples: u64,
    kernels: Duration,
    whole: Duration,
}

impl Run {
    fn new(place: &Place, task: &Task, weights: &Image, spp: u32) -> Result<Self, DeviceError> {
        let (started, busy) = (Instant::now(), place.busy());
        let (numbers, statistics) = task.numbers(place, weights, spp)?;
        Ok(Self {
            numbers,
            samples: statistics.samples,
            kernels: place.busy() - busy,
            whole: started.elapsed(),
        })
    }

    /// Million samples per second in this time.
    fn rate(&self, time: Duration) -> f64 {
        self.samples as f64 / time.as_secs_f64() * 1e-6
    }

    /// What the loss or its derivative is off by if the samples fill a second: as errors fall with
    /// the root of the time, a twice as large one takes four times as long to make small.
    fn error_after_a_second(&self) -> f64 {
        self.numbers[0].error * self.whole.as_secs_f64().sqrt()
    }
}

/// With as many samples as fill the time.
fn fastest(
    place: &Place,
    task: &Task,
    weights: &Image,
    effort: &Effort,
) -> Result<Run, DeviceError> {
    let run = |spp: u32| Run::new(place, task, weights, spp);
    let first = run(FEWEST)?;
    if effort.rounds == 0 {
        return Ok(first);
    }
    let mut spp = FEWEST;
    let mut fastest = run(spp)?;
    while fastest.whole < effort.least {
        spp *= 2;
        fastest = run(spp)?;
    }
    for _ in 1..effort.rounds {
        let next = run(spp)?;
        fastest.kernels = fastest.kernels.min(next.kernels);
        fastest.whole = fastest.whole.min(next.whole);
    }
    Ok(fastest)
}
