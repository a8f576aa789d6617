//! What a job file says, before anything that it names is opened.

mod method;
mod parameter;

use std::path::{Path, PathBuf};
use std::time::Duration;

use capwalk_inverse::adam::Adam;
use capwalk_inverse::guard::Guards;
use capwalk_inverse::loss::{Distance, Loss};
use capwalk_inverse::run::Limits;
use capwalk_inverse::schedule::{Decay, Schedule};
use capwalk_inverse::variable::select::Wish;
use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::{Document, Place, Table, Value};

use crate::args::{MethodArgs, parse_duration};

/// A job, as it is written.
pub struct Job {
    pub scene: Named,
    pub defines: Vec<Define>,
    pub size: Option<[u32; 2]>,
    pub output: PathBuf,
    pub seed: u64,
    pub spp: Option<u32>,
    pub spp_grad: Option<u32>,
    pub time_limit: Option<Duration>,
    /// A picture in every so many iterations; 0 for none.
    pub pictures: u32,
    pub lr: f64,
    pub adam: Adam,
    pub schedule: Schedule,
    pub loss: Loss,
    pub guards: Guards,
    pub limits: Limits,
    pub method: MethodArgs,
    pub views: Vec<ViewKeys>,
    pub parameters: Vec<(Wish, Place)>,
}

/// A text and where it stands.
#[derive(Clone)]
pub struct Named {
    pub text: String,
    pub place: Place,
}

/// A value of `$name` in scene files, and where it stands.
#[derive(Clone)]
pub struct Define {
    pub name: String,
    pub value: String,
    pub place: Place,
}

/// From where to look, and at what.
pub struct ViewKeys {
    pub place: Place,
    pub weight: f64,
    /// Another scene file, for its sensor.
    pub scene: Option<Named>,
    /// Which of a scene's sensors, if the view says so, and where it does.
    pub sensor: Option<(usize, Place)>,
    pub to_world: Option<([f64; 16], Place)>,
    pub x_fov: Option<(f64, Place)>,
    pub mask: Option<Named>,
    pub target: TargetKeys,
}

/// What should be seen.
#[derive(Clone)]
pub enum TargetKeys {
    /// A picture in a file.
    Picture { file: Named, layer: Option<String> },
    /// A scene that is rendered: another one, or the job's with other numbers.
    Rendered {
        scene: Option<Named>,
        /// Values of `$name` in its file, before those of the job.
        defines: Vec<Define>,
        set: Vec<(Wish, Place)>,
        spp: u32,
    },
}

/// Samples per pixel of targets that are rendered, unless the job says otherwise.
const TARGET_SPP: u32 = 512;

/// Largest number of samples, iterations and the like.
const MOST: i64 = u32::MAX as i64;

/// What a job file at `path` says.
pub fn read(document: &Document, path: &Path) -> Result<Job, LoadError> {
    let root = document.root();
    let scene = named(&root.require("scene", "the path of a scene file, or a built-in scene")?)?;
    let defines = defines(&root)?;
    let size = match root.get("size") {
        Some(value) => Some(picture_size(&value)?),
        None => None,
    };
    let output = match root.get("output") {
        Some(value) => document.path(value.text()?),
        None => path.with_extension("out"),
    };
    let iterations = root.require("iterations", "how many steps to take")?;
    let iterations = iterations.integer(0..=MOST)? as u32;
    let seed = integer(&root, "seed", 0..=i64::MAX)?.unwrap_or(0) as u64;
    // The error of a picture is the spread of its samples.
    let spp = integer(&root, "spp", 2..=MOST)?.map(|n| n as u32);
    let spp_grad = integer(&root, "spp_grad", 1..=MOST)?.map(|n| n as u32);
    let pictures = integer(&root, "pictures", 0..=MOST)?.map_or(10, |n| n as u32);
    let time_limit = match root.get("time_limit") {
        Some(value) => Some(parse_duration(value.text()?).map_err(|why| value.wrong(&why))?),
        None => None,
    };
    let (lr, adam, uniform) = optimizer(&root)?;
    let job = Job {
        scene,
        defines,
        size,
        output,
        seed,
        spp,
        spp_grad,
        time_limit,
        pictures,
        lr,
        adam,
        schedule: schedule(&root)?,
        loss: loss(&root)?,
        guards: guards(&root)?,
        limits: limits(&root, iterations)?,
        method: method::read(&root)?,
        views: views(document, &root)?,
        parameters: parameters(&root, uniform)?,
    };
    root.finish()?;
    Ok(job)
}

impl Job {
    /// The scenes that it names.
    pub fn scenes(&self) -> impl Iterator<Item = &Named> {
        let of_views = self.views.iter().flat_map(|view| match &view.target {
            TargetKeys::Picture { .. } => [view.scene.as_ref(), None],
            TargetKeys::Rendered { scene, .. } => [view.scene.as_ref(), scene.as_ref()],
        });
        std::iter::once(&self.scene).chain(of_views.flatten())
    }

    /// The pictures that it names: targets and masks.
    pub fn input_pictures(&self) -> impl Iterator<Item = &Named> {
        let of_views = self.views.iter().flat_map(|view| match &view.target {
            TargetKeys::Picture { file, .. } => [view.mask.as_ref(), Some(file)],
            TargetKeys::Rendered { .. } => [view.mask.as_ref(), None],
        });
        of_views.flatten()
    }
}

fn named(value: &Value) -> Result<Named, LoadError> {
    Ok(Named {
        text: value.text()?.into(),
        place: value.place(),
    })
}

fn maybe_named(table: &Table, key: &'static str) -> Result<Option<Named>, LoadError> {
    table.get(key).map(|value| named(&value)).transpose()
}

fn integer(
    table: &Table,
    key: &'static str,
    allowed: std::ops::RangeInclusive<i64>,
) -> Result<Option<i64>, LoadError> {
    table
        .get(key)
        .map(|value| value.integer(allowed))
        .transpose()
}

fn number(
    table: &Table,
    key: &'static str,
    expected: &str,
    allowed: impl Fn(f64) -> bool,
) -> Result<Option<f64>, LoadError> {
    let value = table.get(key);
    value
        .map(|value| value.number(expected, allowed))
        .transpose()
}

fn truth(table: &Table, key: &'static str) -> Result<Option<bool>, LoadError> {
    table.get(key).map(|value| value.truth()).transpose()
}

fn defines(table: &Table) -> Result<Vec<Define>, LoadError> {
    let Some(table) = table.table("defines")? else {
        return Ok(Vec::new());
    };
    let entries = table.entries();
    entries
        .map(|(name, place, value)| {
            Ok(Define {
                name: name.to_owned(),
                value: value.written()?,
                place,
            })
        })
        .collect()
}

fn picture_size(value: &Value) -> Result<[u32; 2], LoadError> {
    let expected = "[width, height] in pixels";
    let sides = value.array::<2>(expected)?;
    let whole = |side: f64| side >= 1.0 && side.fract() == 0.0 && side <= 65536.0;
    match sides.into_iter().all(whole) {
        true => Ok(sides.map(|side| side as u32)),
        false => Err(value.wrong(expected)),
    }
}

fn positive(table: &Table, key: &'static str) -> Result<Option<f64>, LoadError> {
    number(table, key, "a number above 0", |x| x > 0.0)
}

fn fraction(table: &Table, key: &'static str) -> Result<Option<f64>, LoadError> {
    number(table, key, "a number from 0 to 1", |x| {
        (0.0..=1.0).contains(&x)
    })
}

/// The learning rate, the rest of Adam, and whether all parameters are uniform.
fn optimizer(root: &Table) -> Result<(f64, Adam, bool), LoadError> {
    let missing = "an [optimizer] with its learning rate `lr`";
    let table = root.require("optimizer", missing)?.table("[optimizer]")?;
    if let Some(kind) = table.get("type") {
        kind.choice(&[("adam", ())])?;
    }
    table.require("lr", "the learning rate, a number above 0")?;
    let lr = positive(&table, "lr")?.unwrap_or_default();
    let mut adam = Adam::default();
    if let Some(betas) = table.get("betas") {
        let expected = "two numbers from 0 to below 1, such as [0.9, 0.999]";
        adam.betas = betas.array::<2>(expected)?;
        if !adam.betas.iter().all(|beta| (0.0..1.0).contains(beta)) {
            return Err(betas.wrong(expected));
        }
    }
    // Adam divides by it where there is no gradient.
    if let Some(eps) = positive(&table, "eps")? {
        adam.eps = eps;
    }
    let uniform = truth(&table, "uniform")?.unwrap_or(false);
    table.finish()?;
    Ok((lr, adam, uniform))
}

fn schedule(root: &Table) -> Result<Schedule, LoadError> {
    let mut schedule = Schedule {
        warmup: 0,
        decay: Decay::Constant,
    };
    let Some(table) = root.table("schedule")? else {
        return Ok(schedule);
    };
    #[derive(Clone, Copy)]
    enum Kind {
        Constant,
        Exponential,
        Step,
        Linear,
        Cosine,
    }
    let kinds = [
        ("constant", Kind::Constant),
        ("exponential", Kind::Exponential),
        ("step", Kind::Step),
        ("linear", Kind::Linear),
        ("cosine", Kind::Cosine),
    ];
    let kind = match table.get("type") {
        Some(value) => value.choice(&kinds)?,
        None => Kind::Constant,
    };
    let gamma = |default: f64| Ok(fraction(&table, "gamma")?.unwrap_or(default));
    let end = || Ok(fraction(&table, "end")?.unwrap_or(0.0));
    schedule.decay = match kind {
        Kind::Constant => Decay::Constant,
        Kind::Exponential => Decay::Exponential {
            gamma: gamma(0.99)?,
        },
        Kind::Step => Decay::Step {
            gamma: gamma(0.1)?,
            step_size: table
                .require("step_size", "after how many iterations the rate falls")?
                .integer(1..=MOST)? as u32,
        },
        Kind::Linear => Decay::Linear { end: end()? },
        Kind::Cosine => Decay::Cosine { end: end()? },
    };
    schedule.warmup = integer(&table, "warmup", 0..=MOST)?.unwrap_or(0) as u32;
    table.finish()?;
    Ok(schedule)
}

fn loss(root: &Table) -> Result<Loss, LoadError> {
    let mut loss = Loss {
        distance: Distance::L2,
        levels: 1,
    };
    let Some(table) = root.table("loss")? else {
        return Ok(loss);
    };
    let epsilon = 0.01;
    let kinds = [
        ("l1", Distance::L1),
        ("l2", Distance::L2),
        ("relative", Distance::Relative { epsilon }),
        ("log", Distance::Log { epsilon }),
    ];
    if let Some(kind) = table.get("type") {
        loss.distance = kind.choice(&kinds)?;
    }
    match &mut loss.distance {
        Distance::Relative { epsilon } | Distance::Log { epsilon } => {
            *epsilon = positive(&table, "epsilon")?.unwrap_or(*epsilon);
        }
        Distance::L1 | Distance::L2 => {}
    }
    loss.levels = integer(&table, "pyramid", 1..=32)?.unwrap_or(1) as u32;
    table.finish()?;
    Ok(loss)
}

fn guards(root: &Table) -> Result<Guards, LoadError> {
    let mut guards = Guards::default();
    if let Some(table) = root.table("guards")? {
        guards.inversion = truth(&table, "inversion")?.unwrap_or(true);
        guards.self_intersection = truth(&table, "self_intersection")?.unwrap_or(true);
        table.finish()?;
    }
    Ok(guards)
}

fn limits(root: &Table, iterations: u32) -> Result<Limits, LoadError> {
    let mut limits = Limits {
        iterations,
        ..Limits::default()
    };
    if let Some(table) = root.table("stop")? {
        limits.loss_below = number(&table, "loss_below", "a finite number", |_| true)?;
        limits.patience = integer(&table, "patience", 1..=MOST)?.map(|n| n as u32);
        table.finish()?;
    }
    Ok(limits)
}

/// The views, or one from where the scene's sensor is.
fn views(document: &Document, root: &Table) -> Result<Vec<ViewKeys>, LoadError> {
    let common = root.table("target")?;
    let mask = maybe_named(root, "mask")?;
    let tables = root.tables("view")?;
    let target = |own: Option<Table>, place: Place| match own.as_ref().or(common.as_ref()) {
        Some(table) => target(table),
        None => Err(document.error_with_help(
            place,
            "there is no target",
            "expected a [target]: a `picture`, a `scene` to render, or numbers to `set` in it",
        )),
    };
    if tables.is_empty() {
        return Ok(vec![ViewKeys {
            place: root.place(),
            weight: 1.0,
            scene: None,
            sensor: None,
            to_world: None,
            x_fov: None,
            mask,
            target: target(None, root.place())?,
        }]);
    }
    let mut views = Vec::new();
    for table in tables {
        let place = table.place();
        let view = ViewKeys {
            place,
            weight: positive(&table, "weight")?.unwrap_or(1.0),
            scene: maybe_named(&table, "scene")?,
            sensor: match table.get("sensor") {
                Some(value) => {
                    let number = value.integer(0..=1_000_000)? as usize;
                    Some((number, value.place()))
                }
                None => None,
            },
            to_world: match table.get("to_world") {
                Some(value) => {
                    let matrix = value.array("a matrix of 4 rows of 4 numbers")?;
                    Some((matrix, value.place()))
                }
                None => None,
            },
            x_fov: match table.get("x_fov") {
                Some(value) => {
                    let fov = value.number("degrees from 0 to 180", |x| x > 0.0 && x < 180.0)?;
                    Some((fov, value.place()))
                }
                None => None,
            },
            mask: maybe_named(&table, "mask")?.or_else(|| mask.clone()),
            target: target(table.table("target")?, place)?,
        };
        table.finish()?;
        views.push(view);
    }
    Ok(views)
}

fn target(table: &Table) -> Result<TargetKeys, LoadError> {
    let target = match table.get("picture") {
        Some(file) => TargetKeys::Picture {
            file: named(&file)?,
            layer: maybe_named(table, "layer")?.map(|layer| layer.text),
        },
        None => TargetKeys::Rendered {
            scene: maybe_named(table, "scene")?,
            defines: defines(table)?,
            set: match table.table("set")? {
                Some(set) => set
                    .entries()
                    .map(|(name, place, value)| {
                        let wish = Wish {
                            name: name.into(),
                            start: Some(value.numbers()?),
                            ..Wish::default()
                        };
                        Ok((wish, place))
                    })
                    .collect::<Result<_, LoadError>>()?,
                None => Vec::new(),
            },
            spp: integer(table, "spp", 1..=MOST)?.map_or(TARGET_SPP, |n| n as u32),
        },
    };
    table.finish()?;
    Ok(target)
}

fn parameters(root: &Table, uniform: bool) -> Result<Vec<(Wish, Place)>, LoadError> {
    let expected = "one or more [[parameter]] tables with a `name`";
    let value = root.require("parameter", expected)?;
    let tables = root.tables("parameter")?;
    if tables.is_empty() {
        return Err(value.wrong(expected));
    }
    let parameters = tables.iter().map(|table| parameter::read(table, uniform));
    parameters.collect()
}
