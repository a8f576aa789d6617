//! What a job file says, before anything that it names is opened.

mod method_keys;
mod optimizer;
mod parameter;
mod table;
mod view;

use std::path::{Path, PathBuf};
use std::time::Duration;

use capwalk_diff::{Method, WalkSettings};
use capwalk_inverse::Limits;
use capwalk_inverse::adam::Adam;
use capwalk_inverse::guard::Guards;
use capwalk_inverse::loss::Loss;
use capwalk_inverse::schedule::Schedule;
use capwalk_inverse::variable::VariableSpec;
use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::{Document, Place, Table, Value};

use super::duration::parse_duration;
pub(super) use method_keys::MethodKeys;
use optimizer::SamplesKeys;
pub(super) use optimizer::least_of_gradients;
use table::{MOST, integer};
pub(super) use view::{Define, Located, TargetKeys, ViewKeys};

/// An optimisation as a TOML file describes it, see `docs/optimize.md`.
///
/// ```
/// use capwalk::optimize::Job;
///
/// let job = Job::parse("example", r#"
///     scene = "leaf"
///     iterations = 3
///     target = { set = { "leaf.translate.x" = 0.2 } }
///     parameter = [{ name = "leaf.translate.x" }]
///     optimizer = { lr = 0.1 }
/// "#)?;
/// assert_eq!(job.limits().iterations, 3);
///
/// // Mistakes are errors with their place.
/// let error = Job::parse("example", "scene = 3").unwrap_err();
/// assert_eq!(error.position().map(|place| place.column), Some(9));
/// # Ok::<(), capwalk::LoadError>(())
/// ```
#[derive(Debug)]
pub struct Job {
    /// The file; a text has none.
    pub(super) path: Option<PathBuf>,
    pub(super) document: Document,
    pub(super) keys: Keys,
}

/// The values of all keys, with the places that errors may be about.
#[derive(Debug)]
pub(super) struct Keys {
    pub scene: Located,
    pub defines: Vec<Define>,
    pub size: Option<[u32; 2]>,
    pub output: PathBuf,
    pub seed: u64,
    pub spp: Option<u32>,
    pub spp_grad: Option<u32>,
    pub samples: Option<SamplesKeys>,
    pub time_limit: Option<Duration>,
    /// An image in every so many iterations; 0 for none.
    pub images: u32,
    pub lr: f64,
    pub adam: Adam,
    pub schedule: Schedule,
    pub loss: Loss,
    pub guards: Guards,
    pub limits: Limits,
    pub method: MethodKeys,
    pub views: Vec<ViewKeys>,
    pub parameters: Vec<(VariableSpec, Place)>,
}

impl Job {
    /// The job in a file. Paths in it are relative to where it is.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, LoadError> {
        let path = path.as_ref();
        let document = Document::read(path)?;
        Ok(Self {
            keys: keys(&document, path)?,
            path: Some(path.to_owned()),
            document,
        })
    }

    /// The job in a text that messages call `name`. Paths in it are relative to the
    /// working directory.
    pub fn parse(name: &str, text: &str) -> Result<Self, LoadError> {
        let document = Document::parse(name, PathBuf::new(), text.into())?;
        Ok(Self {
            keys: keys(&document, name.as_ref())?,
            path: None,
            document,
        })
    }

    /// The folder that results go to unless another one is chosen: the job's `output`, or
    /// its own path with the ending `.out`.
    pub fn output(&self) -> &Path {
        &self.keys.output
    }

    /// After how long the job wants to be stopped.
    pub fn time_limit(&self) -> Option<Duration> {
        self.keys.time_limit
    }

    /// When the optimisation ends by itself.
    pub fn limits(&self) -> Limits {
        self.keys.limits
    }

    /// How gradients are estimated.
    pub fn method(&self) -> (Method, WalkSettings) {
        (self.keys.method.method, self.keys.method.walk)
    }
}

/// What a job file at `path` says.
fn keys(document: &Document, path: &Path) -> Result<Keys, LoadError> {
    let root = document.root();
    let expected = "the path of a scene file, or a built-in scene";
    let scene = view::located(&root.require("scene", expected)?)?;
    let output = match root.get("output") {
        Some(value) => document.path(value.text()?),
        None => path.with_extension("out"),
    };
    let iterations = root.require("iterations", "how many steps to take")?;
    let iterations = iterations.integer(0..=MOST)? as u32;
    let time_limit = match root.get("time_limit") {
        Some(value) => Some(
            parse_duration(value.text()?)
                .map_err(|why| value.wrong(why.strip_prefix("expected ").unwrap_or(&why)))?,
        ),
        None => None,
    };
    let (lr, adam, uniform) = optimizer::optimizer(&root)?;
    // The error of an image is the spread of its samples.
    let spp = integer(&root, "spp", 2..=MOST)?.map(|n| n as u32);
    let least = optimizer::least_of_gradients(root.get("samples").is_some());
    let spp_grad = integer(&root, "spp_grad", 1..=MOST)?.map(|n| n as u32);
    if let Some(value) = root.get("spp_grad").filter(|_| spp_grad < Some(least)) {
        return Err(value.wrong(&format!(
            "at least {least} beside `[samples]`, whose halves of a gradient need an error each"
        )));
    }
    let keys = Keys {
        scene,
        defines: view::defines(&root)?,
        size: root.get("size").map(|value| size(&value)).transpose()?,
        output,
        seed: integer(&root, "seed", 0..=i64::MAX)?.unwrap_or(0) as u64,
        spp,
        spp_grad,
        samples: optimizer::samples(&root, spp_grad.unwrap_or(least))?,
        time_limit,
        images: integer(&root, "images", 0..=MOST)?.map_or(10, |n| n as u32),
        lr,
        adam,
        schedule: optimizer::schedule(&root)?,
        loss: optimizer::loss(&root)?,
        guards: optimizer::guards(&root)?,
        limits: optimizer::limits(&root, iterations)?,
        method: method_keys::read(&root)?,
        views: view::views(document, &root)?,
        parameters: parameters(&root, uniform)?,
    };
    root.finish()?;
    Ok(keys)
}

fn size(value: &Value) -> Result<[u32; 2], LoadError> {
    let expected = "[width, height] in pixels";
    let sides = value.array::<2>(expected)?;
    let whole = |side: f64| side >= 1.0 && side.fract() == 0.0 && side <= 65536.0;
    match sides.into_iter().all(whole) {
        true => Ok(sides.map(|side| side as u32)),
        false => Err(value.wrong(expected)),
    }
}

fn parameters(root: &Table, uniform: bool) -> Result<Vec<(VariableSpec, Place)>, LoadError> {
    let expected = "one or more [[parameter]] tables with a `name`";
    let value = root.require("parameter", expected)?;
    let tables = root.tables("parameter")?;
    if tables.is_empty() {
        return Err(value.wrong(expected));
    }
    let parameters = tables.iter().map(|table| parameter::read(table, uniform));
    parameters.collect()
}
