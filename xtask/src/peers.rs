//! `cargo xtask peers`: how much noise capwalk and Mitsuba 3 leave after a second
//! on one thread, in derivative images, gradients of a loss, and images. The
//! measuring is done by `peers.py`; here are the scenes and what is run on them.

mod tables;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use serde_json::{Value, json};

use crate::mitsuba::{LLVM_VARIABLE, MITSUBA, WITHOUT_LLVM, environment, llvm};
use crate::shell::{capwalk, root, step};

/// capwalk's methods, as they are typed after `--method`: a column for each.
const METHODS: [&str; 3] = ["auto", "walk", "edges"];
/// The method of the long derivative image that all others are compared with. It has
/// its own seed.
const REFERENCE: &str = "edges";

/// A scene, and the shape that moves in it.
pub struct Subject {
    pub name: &'static str,
    from: Origin,
    shape: &'static str,
    /// The axis of the translation that derivative images are of.
    axis: char,
}

/// Where a scene file comes from.
enum Origin {
    /// Exported by `capwalk scenes`.
    BuiltIn,
    /// A folder of `tests/scenes`.
    Folder,
    /// A file of `xtask/peers`.
    Peers,
}

/// Width and height of the images of built-in scenes, as `capwalk demo` has them;
/// those of the folders are small already.
const SIZE: [u32; 2] = [128, 96];

/// All scenes. Mitsuba must be able to load them and to move the vertices of the shape;
/// whether its derivative is right is measured.
pub const SUBJECTS: [Subject; 13] = [
    Subject::new("leaf", Origin::BuiltIn, "leaf", 'x'),
    Subject::new("ball", Origin::BuiltIn, "ball", 'x'),
    Subject::new("box-room", Origin::BuiltIn, "box", 'x'),
    Subject::new("lattice-shadow", Origin::BuiltIn, "lattice", 'y'),
    Subject::new("sphere-shadow", Origin::Peers, "thing", 'z'),
    Subject::new("cube-shadow", Origin::Peers, "thing", 'z'),
    Subject::new("shadow_of_a_moving_occluder", Origin::Folder, "thing", 'x'),
    Subject::new("emitter_moves", Origin::Folder, "lamp", 'y'),
    Subject::new("interreflection", Origin::Folder, "thing", 'x'),
    Subject::new("indirect_shadow", Origin::Folder, "sheet", 'x'),
    Subject::new("cornell-box", Origin::Peers, "block", 'y'),
    Subject::new("painted-box", Origin::Peers, "block", 'y'),
    Subject::new("glossy-box", Origin::Peers, "block", 'y'),
];

impl Subject {
    const fn new(name: &'static str, from: Origin, shape: &'static str, axis: char) -> Self {
        Self {
            name,
            from,
            shape,
            axis,
        }
    }

    /// The parameter that derivative images are of.
    pub fn parameter(&self) -> String {
        format!("{}.translate.{}", self.shape, self.axis)
    }

    /// The scene's file, or its name if it is built in.
    pub fn scene(&self) -> PathBuf {
        match self.from {
            Origin::BuiltIn => self.name.into(),
            Origin::Folder => self.folder().join("scene.xml"),
            Origin::Peers => root()
                .join("xtask/peers")
                .join(format!("{}.xml", self.name)),
        }
    }

    /// The folder of a scene that has one.
    fn folder(&self) -> PathBuf {
        root().join("tests/scenes").join(self.name)
    }

    /// Puts the scene file, with what it refers to, into a folder.
    pub fn copy_to(&self, folder: &Path, capwalk: &Path) -> Result<PathBuf> {
        fs::create_dir_all(folder)?;
        match self.from {
            Origin::BuiltIn => {
                let mut export = Command::new(capwalk);
                export.args(["scenes", "--export"]).arg(folder);
                let output = export.arg(self.name).output()?;
                if !output.status.success() {
                    bail!("capwalk: {}", String::from_utf8_lossy(&output.stderr));
                }
                Ok(folder.join(format!("{}.xml", self.name)))
            }
            Origin::Peers => {
                let file = folder.join(format!("{}.xml", self.name));
                fs::copy(self.scene(), &file)?;
                Ok(file)
            }
            Origin::Folder => {
                let source = self.folder();
                let entries = fs::read_dir(&source)
                    .with_context(|| format!("cannot list {}", source.display()))?;
                for entry in entries {
                    let file = entry?;
                    fs::copy(file.path(), folder.join(file.file_name()))?;
                }
                Ok(folder.join("scene.xml"))
            }
        }
    }
}

/// Measures all scenes, or those named, and prints the tables; with `--quick` with so
/// few samples that the numbers mean nothing, to see that everything works; with
/// `--images` images alone; with `--tables` nothing is measured, and the tables are
/// those of earlier runs.
pub fn run(arguments: &[String]) -> Result<()> {
    let (options, names): (Vec<&String>, Vec<&String>) = arguments
        .iter()
        .partition(|argument| argument.starts_with("--"));
    let (mut quick, mut only_images, mut only_tables) = (false, false, false);
    for option in options {
        match option.as_str() {
            "--quick" => quick = true,
            "--images" => only_images = true,
            "--tables" => only_tables = true,
            unknown => bail!(
                "expected --quick, --images, --tables or names of scenes instead of {unknown}"
            ),
        }
    }
    let subjects = chosen(&names)?;
    let work = root().join("target/peers");
    // What means nothing must not replace what does, nor images alone everything.
    let work = match (quick, only_images) {
        (true, _) => work.join("quick"),
        (false, true) => work.join("images"),
        (false, false) => work,
    };
    if only_tables {
        return print_earlier(&subjects, &work);
    }
    fs::create_dir_all(&work)?;
    let python = environment()?;
    let llvm = llvm();
    match &llvm {
        Some(file) => println!("--- LLVM: {}", file.display()),
        None => println!("note: {WITHOUT_LLVM}"),
    }
    let derivatives = llvm.is_some() && !only_images;
    let measure = Measure {
        capwalk: capwalk()?,
        python,
        llvm,
        work,
        quick,
        derivatives,
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

/// The scenes of these names, or all.
fn chosen(names: &[&String]) -> Result<Vec<&'static Subject>> {
    let known = |name: &str| SUBJECTS.iter().any(|subject| subject.name == name);
    if let Some(unknown) = names.iter().find(|name| !known(name)) {
        let all: Vec<&str> = SUBJECTS.iter().map(|subject| subject.name).collect();
        bail!(
            "there is no scene \"{unknown}\" to compare; they are {}",
            all.join(", ")
        );
    }
    let wanted =
        |subject: &&Subject| names.is_empty() || names.iter().any(|name| *name == subject.name);
    Ok(SUBJECTS.iter().filter(wanted).collect())
}

/// How scenes are measured.
struct Measure {
    capwalk: PathBuf,
    python: PathBuf,
    llvm: Option<PathBuf>,
    work: PathBuf,
    quick: bool,
    derivatives: bool,
}

impl Measure {
    /// What `peers.py` found, which it also leaves in `NAME.json`.
    fn scene(&self, subject: &Subject) -> Result<Value> {
        let name = subject.name;
        let folder = self.work.join("scenes").join(name);
        let file = subject.copy_to(&folder, &self.capwalk)?;
        let size = match subject.from {
            Origin::BuiltIn => json!({ "width": SIZE[0], "height": SIZE[1] }),
            Origin::Folder | Origin::Peers => Value::Null,
        };
        let plan = json!({
            "name": name,
            "file": file,
            "size": size,
            "shape": subject.shape,
            "axis": subject.axis,
            "folder": folder,
            "capwalk": self.capwalk,
            "methods": METHODS,
            "reference_method": REFERENCE,
            "llvm": self.llvm,
            "quick": self.quick,
            "derivatives": self.derivatives,
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
        // Kernels of earlier runs would hide what compiling takes.
        let kernels = folder.join("kernels");
        if kernels.exists() {
            fs::remove_dir_all(&kernels)?;
        }
        fs::create_dir_all(&kernels)?;
        command.env("DRJIT_CACHE_DIR", &kernels);
        step(name, command)?;
        read(&result_file)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_choose_scenes() {
        assert_eq!(chosen(&[]).unwrap().len(), SUBJECTS.len());
        let ball = chosen(&[&"ball".to_owned()]).unwrap();
        assert_eq!(ball.len(), 1);
        assert_eq!(ball[0].shape, "ball");
        let Err(error) = chosen(&[&"bal".to_owned()]) else {
            panic!("there is no such scene");
        };
        assert!(error.to_string().contains("leaf, ball"), "{error}");
    }

    #[test]
    fn folders_exist() {
        for subject in SUBJECTS {
            let expected = matches!(subject.from, Origin::Folder);
            assert_eq!(subject.folder().exists(), expected, "{}", subject.name);
        }
    }
}
