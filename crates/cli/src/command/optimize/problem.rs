//! From a job to a problem: scenes are loaded, targets read or rendered.

use std::fmt::Write;

use anyhow::{Context, Result, ensure};
use capwalk_diff::{Options, Prepared, render};
use capwalk_inverse::seed::{Purpose, seed};
use capwalk_inverse::variable::{Variables, select::Wish, variable};
use capwalk_inverse::{Problem, View};
use capwalk_scene::params::Registry;
use capwalk_scene::{Film, Image, Scene, Sensor, builtin};
use capwalk_scene_io::toml::{Document, Place};
use capwalk_scene_io::{LoadError, LoadOptions, image, load_scene_with};

use super::job::{Define, Job, Named, TargetKeys, ViewKeys};
use super::live::Clock;
use crate::method::method_and_walk;
use crate::output;
use crate::progress::Progress;
use crate::source::warned;

/// A problem, and what it was made of.
pub struct Made {
    pub problem: Problem,
    /// What must be the same when a run is resumed: names, and what they are.
    pub fingerprint: Vec<(String, String)>,
}

/// The problem of a job; `None` if it was stopped before all targets were there.
pub fn problem(document: &Document, job: &Job, clock: &Clock) -> Result<Option<Made>> {
    refuse_unused_defines(document, job)?;
    let scene = load(document, job, &job.scene, &[], 0)?;
    let variables = variables(document, &scene, &job.parameters)?;
    let spp = job.spp.unwrap_or(scene.settings.spp.max(2));
    let mut views = Vec::new();
    for (number, keys) in job.views.iter().enumerate() {
        let sensor = sensor(document, job, &scene, keys)?;
        if let Some(place) = moved_sensor(&scene, job, &variables).filter(|_| sensor.is_some()) {
            return Err(document
                .error_with_help(
                    place,
                    "it moves the sensor of the scene, but a [[view]] has its own",
                    "leave out the views, or what moves the sensor",
                )
                .into());
        }
        let mut view = View {
            sensor,
            target: Image::new(0, 0),
            mask: None,
            weight: keys.weight,
        };
        let size = view.scene(&scene).film.crop_size;
        if let Some(mask) = &keys.mask {
            view.mask = Some(read_mask(document, mask, size)?);
        }
        view.target = match &keys.target {
            TargetKeys::Picture { file, layer } => {
                read_target(document, file, layer.as_deref(), size)?
            }
            TargetKeys::Rendered {
                scene: other,
                defines,
                set,
                spp,
            } => {
                let is_other = other.is_some() || !defines.is_empty();
                let named = other.as_ref().unwrap_or(&job.scene);
                let which = keys.sensor.map_or(0, |(which, _)| which);
                let other = is_other.then(|| load(document, job, named, defines, which));
                let other = other.transpose()?;
                let set = changed(document, other.as_ref().unwrap_or(&scene), set)?;
                let options = Options {
                    spp: *spp,
                    seed: seed(job.seed, 0, number as u64, Purpose::Target),
                };
                // With another scene's own film, unless the view has one.
                let seen = match (&view.sensor, other.is_some()) {
                    (None, true) => set,
                    _ => view.scene(&set),
                };
                ensure!(
                    seen.film.crop_size == size,
                    document.error(keys.place, "the target has another size than the picture")
                );
                match rendered(&seen, &options, clock) {
                    Some(target) => target,
                    None => return Ok(None),
                }
            }
        };
        views.push(view);
    }
    let (method, walk) = method_and_walk(&job.method)?;
    let problem = Problem {
        variables,
        views,
        loss: job.loss,
        adam: job.adam,
        lr: job.lr,
        schedule: job.schedule,
        guards: job.guards,
        limits: job.limits,
        seed: job.seed,
        spp,
        spp_grad: job.spp_grad.unwrap_or(spp),
        method,
        walk,
        scene,
    };
    let fingerprint = fingerprint(job, &problem);
    Ok(Some(Made {
        problem,
        fingerprint,
    }))
}

/// A scene of the job, with these values of `$name` before those of the job, and
/// the sensor that is asked for.
fn load(
    document: &Document,
    job: &Job,
    named: &Named,
    defines: &[Define],
    sensor: usize,
) -> Result<Scene> {
    let path = document.path(&named.text);
    let mut scene = match (path.exists(), builtin::scene(&named.text)) {
        (true, _) => {
            let own = |define: &&Define| defines.iter().any(|own| own.name == define.name);
            let of_job = job.defines.iter().filter(|define| !own(define));
            let all = of_job.chain(defines);
            let options = LoadOptions {
                defines: all.map(|d| (d.name.clone(), d.value.clone())).collect(),
                sensor,
            };
            warned(load_scene_with(&path, &options)?)
        }
        (false, Some(_)) if !defines.is_empty() => {
            return Err(built_in(document, defines[0].place, &named.text, "no `$name`").into());
        }
        (false, Some(scene)) => scene,
        (false, None) => {
            let names: Vec<&str> = builtin::names().collect();
            let message = format!("there is no file {}", path.display());
            let help = format!(
                "expected a scene file, relative to the job, or a built-in scene: {}",
                names.join(", ")
            );
            return Err(document.error_with_help(named.place, message, help).into());
        }
    };
    if let Some(size) = job.size {
        scene.film.size = size;
        scene.film.crop_offset = [0, 0];
        scene.film.crop_size = size;
    }
    let checked = scene.check();
    checked
        .map_err(|error| document.error(named.place, format!("it cannot be rendered: {error}")))?;
    Ok(scene)
}

/// An error about something that a built-in scene does not have.
fn built_in(document: &Document, place: Place, scene: &str, has: &str) -> LoadError {
    let message = format!("the scene \"{scene}\" is built in and has {has}");
    let help = "leave it out, or make a file of the scene with `capwalk scenes --export`";
    document.error_with_help(place, message, help)
}

/// An error if there are values of `$name`, but no scene file.
fn refuse_unused_defines(document: &Document, job: &Job) -> Result<(), LoadError> {
    let is_file = |named: &Named| {
        let path = document.path(&named.text);
        path.exists() || builtin::scene(&named.text).is_none()
    };
    match job.defines.first().filter(|_| !job.scenes().any(is_file)) {
        None => Ok(()),
        Some(define) => Err(built_in(
            document,
            define.place,
            &job.scene.text,
            "no `$name`",
        )),
    }
}

fn variables(
    document: &Document,
    scene: &Scene,
    wishes: &[(Wish, Place)],
) -> Result<Variables, LoadError> {
    let registry = Registry::new(scene);
    let mut made = Vec::new();
    for (wish, place) in wishes {
        let made_of = variable(scene, &registry, wish);
        made.push(made_of.map_err(|error| document.error(*place, error.to_string()))?);
    }
    // Two of them get in each other's way: the last one is where it is seen.
    let last = wishes
        .last()
        .map_or(document.root().place(), |(_, place)| *place);
    Variables::new(scene, made).map_err(|error| document.error(last, error.to_string()))
}

/// The scene with numbers that are set.
fn changed(document: &Document, scene: &Scene, set: &[(Wish, Place)]) -> Result<Scene, LoadError> {
    let variables = variables(document, scene, set)?;
    let changed = variables.apply(scene, &variables.values(&variables.initial()));
    changed.map_err(|error| {
        let place = set
            .first()
            .map_or(document.root().place(), |(_, place)| *place);
        document.error(place, error.to_string())
    })
}

/// The sensor of a view and its film, if it is not the scene's.
fn sensor(
    document: &Document,
    job: &Job,
    scene: &Scene,
    keys: &ViewKeys,
) -> Result<Option<(Sensor, Film)>> {
    let mut own = match (&keys.scene, keys.sensor) {
        (None, None | Some((0, _))) => scene.clone(),
        (named, sensor) => {
            let named = named.as_ref().unwrap_or(&job.scene);
            let number = sensor.map_or(0, |(number, _)| number);
            let own = load(document, job, named, &[], number)?;
            if let Some((_, place)) = sensor.filter(|_| number > 0)
                && !document.path(&named.text).exists()
            {
                let has = "one sensor, number 0";
                return Err(built_in(document, place, &named.text, has).into());
            }
            own
        }
    };
    let set = |own: &mut Scene, name: &str, numbers: &[f64], place: Place| {
        let name = format!("{}.{name}", own.sensor.id);
        let registry = Registry::new(own);
        let array = registry.array(&name).ok().flatten();
        let array = array.ok_or_else(|| document.error(place, "the sensor has no such number"))?;
        let changed = array.set(own, numbers);
        changed.map_err(|error| document.error(place, error.to_string()))?;
        let checked = own.check();
        checked.map_err(|error| document.error(place, error.to_string()))
    };
    if let Some((matrix, place)) = &keys.to_world {
        set(&mut own, "to_world", matrix, *place)?;
    }
    if let Some((degrees, place)) = keys.x_fov {
        set(&mut own, "x_fov", &[degrees], place)?;
    }
    let is_the_same = own.sensor == scene.sensor && own.film == scene.film;
    Ok((!is_the_same).then_some((own.sensor, own.film)))
}

/// Where the first parameter is that moves the sensor.
fn moved_sensor(scene: &Scene, job: &Job, variables: &Variables) -> Option<Place> {
    let registry = Registry::new(scene);
    let alone = |(wish, place): &(Wish, Place)| {
        let variables = Variables::new(scene, vec![variable(scene, &registry, wish).ok()?]).ok()?;
        variables.moves_sensor(scene).then_some(*place)
    };
    variables
        .moves_sensor(scene)
        .then(|| job.parameters.iter().find_map(alone))?
}

fn read_target(
    document: &Document,
    file: &Named,
    layer: Option<&str>,
    size: [u32; 2],
) -> Result<Image, LoadError> {
    let read = output::read_layer(&document.path(&file.text), layer, &["value"], size);
    read.map_err(|error| document.error(file.place, format!("{error:#}")))
}

/// Weights: finite, at least 0, and not all 0.
fn read_mask(document: &Document, file: &Named, size: [u32; 2]) -> Result<Image, LoadError> {
    let path = document.path(&file.text);
    let mask = image::read(&path)
        .map_err(anyhow::Error::from)
        .and_then(|picture| {
            let first = picture
                .layers
                .first()
                .context("the picture has no layers")?;
            let name = picture
                .layer("value")
                .map_or(first.name.as_str(), |_| "value");
            output::read_layer(&path, Some(name), &[], size)
        })
        .map_err(|error| document.error(file.place, format!("{error:#}")))?;
    let weights = || mask.pixels.iter().flat_map(|pixel| pixel.to_array());
    let problem = match (weights().any(|w| w < 0.0), weights().all(|w| w == 0.0)) {
        (true, _) => "some pixels are below 0",
        (_, true) => "all pixels are 0: nothing would count",
        _ => return Ok(mask),
    };
    let message = format!("the mask {}: {problem}", path.display());
    Err(document.error_with_help(file.place, message, "expected how much each pixel counts"))
}

/// The picture of a target; `None` if it was stopped.
fn rendered(scene: &Scene, options: &Options, clock: &Clock) -> Option<Image> {
    let progress = Progress::new("target", clock.remaining());
    let picture = render(&Prepared::new(scene.clone()), options, &progress);
    progress.finish();
    picture.statistics.complete.then_some(picture.value.mean)
}

/// What decides which numbers come out, by names that a message can show. Guards do
/// not: they only stop.
fn fingerprint(job: &Job, problem: &Problem) -> Vec<(String, String)> {
    let mut parts = vec![(
        "version of capwalk".to_owned(),
        env!("CARGO_PKG_VERSION").into(),
    )];
    let mut note = |name: String, what: String| parts.push((name, what));
    note("scene".into(), digest(&problem.scene));
    note("seed".into(), problem.seed.to_string());
    note("spp".into(), problem.spp.to_string());
    note("spp_grad".into(), problem.spp_grad.to_string());
    let optimizer = format!("lr {}, {:?}", problem.lr, problem.adam);
    note("[optimizer]".into(), optimizer);
    note("[schedule]".into(), format!("{:?}", problem.schedule));
    if problem.schedule.needs_the_end() {
        let iterations = problem.limits.iterations.to_string();
        note("iterations (the schedule needs them)".into(), iterations);
    }
    note("[loss]".into(), format!("{:?}", problem.loss));
    let method = format!("{:?}, {:?}", problem.method, problem.walk);
    note("[method]".into(), method);
    let names = job.parameters.iter().map(|(wish, _)| wish.name.clone());
    note(
        "names of parameters".into(),
        names.collect::<Vec<_>>().join(", "),
    );
    for (wish, _) in &job.parameters {
        note(format!("parameter {}", wish.name), format!("{wish:?}"));
    }
    note("number of views".into(), problem.views.len().to_string());
    for (i, view) in problem.views.iter().enumerate() {
        note(format!("view {}", i + 1), digest(view));
    }
    parts
}

/// A number that stands for a thing: FNV-1a of all that `Debug` says of it, which
/// is every digit of every number.
fn digest(thing: &impl std::fmt::Debug) -> String {
    struct Hash(u64);
    impl Write for Hash {
        fn write_str(&mut self, text: &str) -> std::fmt::Result {
            for byte in text.bytes() {
                self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
            }
            Ok(())
        }
    }
    let mut hash = Hash(0xcbf2_9ce4_8422_2325);
    write!(hash, "{thing:?}").expect("hashing cannot fail");
    format!("{:016x}", hash.0)
}
