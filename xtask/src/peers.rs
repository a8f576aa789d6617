//! `cargo xtask peers`: how much noise capwalk and Mitsuba 3 leave after a second on one thread.
//!
//! There are three kinds of scenes. Where a shape moves, derivative images and gradients of a
//! loss are compared; where a texture, a roughness or a sky has texels, gradients of a loss with
//! respect to them, beside `prb`; in all of them, and in scenes for that alone, images. The
//! measuring is done by `peers.py`; here is what is run.
//!
//! Public scenes are no part of this repository. They are measured where their folder is given,
//! `--public FOLDER`, and left out otherwise; `subjects.rs` says which it should have.

mod subjects;
mod tables;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use serde_json::{Value, json};

use crate::mitsuba::{LLVM_VARIABLE, MITSUBA, WITHOUT_LLVM, environment, llvm};
use crate::shell::{capwalk, root, step};

use subjects::{Differentiated, Origin};
pub use subjects::{SUBJECTS, Subject};

/// capwalk's methods, as they are typed after `--method`: a column for each.
const METHODS: [&str; 3] = ["auto", "walk", "edges"];
/// The method of the long derivative image that all others are compared with. It has
/// its own seed.
const REFERENCE: &str = "edges";

/// What is measured, by the arguments of the task.
#[derive(Default)]
struct Request {
    /// So few samples that the numbers mean nothing, to see that everything works.
    quick: bool,
    only_images: bool,
    only_texels: bool,
    /// Nothing is measured, and the tables are those of earlier runs.
    only_tables: bool,
    /// The folder of public scenes.
    public: Option<PathBuf>,
    /// All scenes if empty.
    names: Vec<String>,
}

impl Request {
    fn new(arguments: &[String]) -> Result<Self> {
        let mut request = Self::default();
        let mut arguments = arguments.iter();
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--quick" => request.quick = true,
                "--images" => request.only_images = true,
                "--texels" => request.only_texels = true,
                "--tables" => request.only_tables = true,
                "--public" => {
                    let folder = arguments.next();
                    let folder = folder.context("expected a folder after --public")?;
                    request.public = Some(std::path::absolute(folder)?);
                }
                option if option.starts_with("--") => bail!(
                    "expected --quick, --images, --texels, --tables, --public FOLDER or names of \
                     scenes instead of {option}"
                ),
                _ => request.names.push(argument.clone()),
            }
        }
        ensure!(
            !(request.only_images && request.only_texels),
            "expected --images or --texels, not both"
        );
        Ok(request)
    }

    /// The folder of results. What means nothing must not replace what does, nor a part
    /// everything.
    fn folder(&self) -> PathBuf {
        let work = root().join("target/peers");
        match (self.quick, self.only_images, self.only_texels) {
            (true, ..) => work.join("quick"),
            (_, true, _) => work.join("images"),
            (.., true) => work.join("texels"),
            _ => work,
        }
    }

    /// The scenes that are named, or all; public ones only if there are any.
    fn subjects(&self) -> Result<Vec<&'static Subject>> {
        let known = |name: &String| SUBJECTS.iter().any(|subject| subject.name == name);
        if let Some(unknown) = self.names.iter().find(|name| !known(name)) {
            let all: Vec<&str> = SUBJECTS.iter().map(|subject| subject.name).collect();
            bail!(
                "there is no scene \"{unknown}\" to compare; they are {}",
                all.join(", ")
            );
        }
        let wanted = |subject: &&Subject| {
            let named = self.names.iter().any(|name| *name == subject.name);
            let of_kind =
                !self.only_texels || matches!(subject.differentiated, Differentiated::Texels(_));
            of_kind && (named || self.names.is_empty())
        };
        let (public, own): (Vec<_>, Vec<_>) = SUBJECTS
            .iter()
            .filter(wanted)
            .partition(|subject| matches!(subject.from, Origin::Public(..)));
        if self.public.is_some() || self.only_tables || public.is_empty() {
            return Ok(own.into_iter().chain(public).collect());
        }
        let left_out: Vec<&str> = public.iter().map(|subject| subject.name).collect();
        println!(
            "note: {} left out; their folder is given by --public",
            left_out.join(", ")
        );
        Ok(own)
    }

    /// The parts of a scene's measurement.
    fn parts(&self, subject: &Subject, has_llvm: bool) -> Vec<&'static str> {
        let derivatives = match subject.differentiated {
            Differentiated::Motion { .. } => Some("motion"),
            Differentiated::Texels(_) => Some("texels"),
            Differentiated::Nothing => None,
        };
        let derivatives = derivatives.filter(|_| has_llvm && !self.only_images);
        let image = (!self.only_texels).then_some("image");
        derivatives.into_iter().chain(image).collect()
    }
}

/// Measures scenes, and prints the tables.
pub fn run(arguments: &[String]) -> Result<()> {
    let request = Request::new(arguments)?;
    let subjects = request.subjects()?;
    let work = request.folder();
    if request.only_tables {
        return print_earlier(&subjects, &work);
    }
    fs::create_dir_all(&work)?;
    let python = environment()?;
    let llvm = llvm();
    match &llvm {
        Some(file) => println!("--- LLVM: {}", file.display()),
        None if request.only_texels => bail!("{WITHOUT_LLVM}"),
        None => println!("note: {WITHOUT_LLVM}"),
    }
    let measure = Measure {
        capwalk: capwalk()?,
        python,
        llvm,
        work,
        request,
    };

    println!("--- capwalk and {MITSUBA}, one thread each");
    let mut results = Vec::new();
    let mut failed = Vec::new();
    for subject in subjects {
        // LLVM ends the program where it fails; other scenes may work.
        match measure.scene(subject) {
            Ok(result) => results.push(result),
            Err(error) => {
                eprintln!("error: {}: {error:#}", subject.name);
                failed.push(subject.name);
            }
        }
    }
    print!("{}", tables::all(&results, &METHODS));
    println!("\nAll numbers are in {}", measure.work.display());
    ensure!(
        failed.is_empty(),
        "{} could not be measured",
        failed.join(", ")
    );
    Ok(())
}

/// The tables of scenes that were measured before.
fn print_earlier(subjects: &[&Subject], work: &Path) -> Result<()> {
    let files = subjects
        .iter()
        .map(|subject| work.join(format!("{}.json", subject.name)));
    let results: Vec<Value> = files
        .filter(|file| file.exists())
        .map(|file| read(&file))
        .collect::<Result<_>>()?;
    ensure!(
        !results.is_empty(),
        "no results in {}; measure first, without --tables",
        work.display()
    );
    print!("{}", tables::all(&results, &METHODS));
    Ok(())
}

/// What `peers.py` wrote.
fn read(file: &Path) -> Result<Value> {
    let text =
        fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))?;
    serde_json::from_str(&text).with_context(|| format!("{} is no JSON", file.display()))
}

/// How scenes are measured.
struct Measure {
    capwalk: PathBuf,
    python: PathBuf,
    llvm: Option<PathBuf>,
    work: PathBuf,
    request: Request,
}

impl Measure {
    /// What `peers.py` found, which it also leaves in `NAME.json`.
    fn scene(&self, subject: &Subject) -> Result<Value> {
        let name = subject.name;
        let folder = self.work.join("scenes").join(name);
        let public = self.request.public.as_deref();
        let file = subject.copy_to(&folder, &self.capwalk, public)?;
        let source = match (&subject.from, public) {
            (Origin::Public(path, _), Some(public)) => {
                public.join(path).parent().map(Path::to_owned)
            }
            _ => None,
        };
        let (shape, axis, array) = match subject.differentiated {
            Differentiated::Motion { shape, axis } => (Some(shape), Some(axis), None),
            Differentiated::Texels(array) => (None, None, Some(array)),
            Differentiated::Nothing => (None, None, None),
        };
        let size = subject.size();
        let plan = json!({
            "name": name,
            "file": file,
            "source": source,
            "size": size.map(|[width, height]| json!({ "width": width, "height": height })),
            "shape": shape,
            "axis": axis,
            "array": array,
            "folder": folder,
            "capwalk": self.capwalk,
            "methods": METHODS,
            "reference_method": REFERENCE,
            "llvm": self.llvm,
            "quick": self.request.quick,
            "parts": self.request.parts(subject, self.llvm.is_some()),
        });
        let plan_file = folder.join("plan.json");
        fs::write(&plan_file, format!("{plan:#}"))?;
        let result_file = self.work.join(format!("{name}.json"));
        let mut command = Command::new(&self.python);
        command
            .arg(root().join("xtask/peers.py"))
            .args([&plan_file, &result_file]);
        if let Some(llvm) = &self.llvm {
            command.env(LLVM_VARIABLE, llvm);
        }
        // Kernels of other runs would hide what compiling takes.
        let kernels = folder.join("kernels");
        fs::create_dir_all(&kernels)?;
        command.env("DRJIT_CACHE_DIR", &kernels);
        step(name, command)?;
        read(&result_file)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(arguments: &[&str]) -> Request {
        let arguments: Vec<String> = arguments.iter().map(|text| (*text).to_owned()).collect();
        Request::new(&arguments).unwrap()
    }

    fn names(arguments: &[&str]) -> Vec<&'static str> {
        let subjects = request(arguments).subjects().unwrap();
        subjects.iter().map(|subject| subject.name).collect()
    }

    #[test]
    fn names_choose_scenes() {
        assert_eq!(names(&["--public", "x"]).len(), SUBJECTS.len());
        assert_eq!(names(&["ball"]), ["ball"]);
        let Err(error) = request(&["bal"]).subjects() else {
            panic!("there is no such scene");
        };
        assert!(error.to_string().contains("leaf, ball"), "{error}");
    }

    /// Public scenes are not measured without their folder, but their earlier results are
    /// printed.
    #[test]
    fn public_scenes_need_a_folder() {
        assert_eq!(names(&["many", "cbox"]), ["many"]);
        assert_eq!(names(&["many", "cbox", "--public", "x"]), ["many", "cbox"]);
        assert_eq!(names(&["many", "cbox", "--tables"]), ["many", "cbox"]);
        assert!(Request::new(&["--public".to_owned()]).is_err());
    }

    #[test]
    fn options_choose_parts() {
        let parts = |options: &[&str], name: &str| {
            let subject = SUBJECTS.iter().find(|subject| subject.name == name);
            request(options).parts(subject.expect("a scene"), true)
        };
        assert_eq!(parts(&[], "leaf"), ["motion", "image"]);
        assert_eq!(parts(&[], "sky-texels"), ["texels", "image"]);
        assert_eq!(parts(&[], "many"), ["image"]);
        assert_eq!(parts(&["--images"], "leaf"), ["image"]);
        assert_eq!(parts(&["--texels"], "sky-texels"), ["texels"]);
        assert_eq!(names(&["--texels"]).len(), 5);
    }
}
