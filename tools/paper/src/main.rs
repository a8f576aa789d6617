//! The command `capwalk-paper`: draws the figures, tests the claims, and writes the paper's scene.

mod args;
mod progress;

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::Path;
use std::process::ExitCode;

use anyhow::{Context, Result, anyhow, bail};
use capwalk_diff::with_threads;
use capwalk_geometry::Mesh;
use capwalk_paper::{ALL, Failure, Figure, Settings, bunny_shadow, write};
use capwalk_scene_io::export::write_scene;
use capwalk_scene_io::mesh::{read_obj, read_ply};
use clap::Parser;
use serde_json::{Value, json};

use args::{Command, Figures, Typed};
use progress::Stage;

/// Exit statuses, as those of `capwalk`.
const BAD_INPUT: u8 = 3;
const INTERRUPTED: u8 = 5;

fn main() -> ExitCode {
    let typed = match Typed::try_parse() {
        Ok(typed) => typed,
        Err(asked) => {
            // Nobody is left to tell if it cannot be written.
            let _ = asked.print();
            return match asked.use_stderr() {
                true => BAD_INPUT.into(),
                false => ExitCode::SUCCESS,
            };
        }
    };
    let result = match &typed.command {
        Command::Figures(figures) => progress::catch_interrupts().and_then(|()| {
            let draw = || draw(figures);
            figures
                .threads
                .map_or_else(draw, |n| with_threads(n.get(), draw))
        }),
        Command::Bunny { path } => bunny(path),
    };
    result.unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        BAD_INPUT.into()
    })
}

/// Draws figures and writes them; after Ctrl-C those that were done.
fn draw(typed: &Figures) -> Result<ExitCode> {
    let settings = Settings {
        quality: typed.quality,
        seed: typed.seed,
        mesh: typed.mesh.as_deref().map(mesh).transpose()?,
        stages: &|name| Box::new(Stage::new(name)),
    };
    // A folder that cannot be written to is an error before the work.
    let mut written = write(&[], &typed.out)?;
    let mut figures = Vec::new();
    let mut status = ExitCode::SUCCESS;
    let is_wanted = |name: &str| {
        typed
            .names
            .iter()
            .any(|typed| typed == name || typed == "all")
    };
    let wanted: Vec<_> = ALL.iter().filter(|entry| is_wanted(entry.name)).collect();
    for (done, entry) in wanted.iter().enumerate() {
        let left: Vec<_> = wanted[done + 1..].iter().map(|entry| entry.name).collect();
        if !left.is_empty() {
            eprintln!("drawing {}; then {}", entry.name, left.join(", "));
        }
        match entry.draw(&settings) {
            Ok(figure) => {
                if !typed.json {
                    print(&describe(&figure))?;
                }
                figures.push(figure);
                // What is done is not lost if the rest is killed.
                written = write(&figures, &typed.out)?;
            }
            Err(Failure::Stopped) => {
                status = INTERRUPTED.into();
                break;
            }
            Err(failure) => return Err(failure).context(entry.name),
        }
    }
    match typed.json {
        true => {
            let document = json!({
                "quality": settings.quality.name(),
                "seed": settings.seed,
                "figures": figures.iter().map(figure_json).collect::<Vec<_>>(),
                "files": written,
            });
            print(&format!("{document:#}\n"))?;
        }
        false => print(&format!(
            "{} files, for all of it open {}\n",
            written.len(),
            typed.out.join("report.html").display()
        ))?,
    }
    Ok(status)
}

/// A figure's claims as text.
fn describe(figure: &Figure) -> String {
    let [time, cpu] = [figure.seconds, figure.cpu_seconds].map(duration);
    let mut text = format!("{}, {time}, {cpu} of the CPU\n", figure.title);
    for claim in &figure.claims {
        text += &format!(
            "  {}\n    paper: {}\n    here:  {}\n    {}\n",
            claim.statement, claim.paper, claim.ours, claim.verdict
        );
    }
    text
}

/// A time in its usual unit.
fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 0.1 => format!("{:.1} ms", 1e3 * s),
        s if s < 120.0 => format!("{s:.1} s"),
        s if s < 7200.0 => format!("{:.1} min", s / 60.0),
        s => format!("{:.1} h", s / 3600.0),
    }
}

fn figure_json(figure: &Figure) -> Value {
    let claims = figure.claims.iter().map(|claim| {
        json!({
            "claim": claim.statement,
            "paper": claim.paper,
            "here": claim.ours,
            "verdict": claim.verdict.name(),
            "because": claim.verdict.reason(),
        })
    });
    json!({
        "figure": figure.name,
        "title": figure.title,
        "seconds": figure.seconds,
        "cpu_seconds": figure.cpu_seconds,
        "claims": claims.collect::<Vec<_>>(),
    })
}

/// The mesh in a file.
fn mesh(path: &Path) -> Result<Mesh> {
    let shown = path.display();
    let ending = path.extension().and_then(|ending| ending.to_str());
    let read = match ending.map(str::to_ascii_lowercase).as_deref() {
        Some("ply") => read_ply,
        Some("obj") => read_obj,
        _ => bail!("{shown}: expected a mesh file that ends in .ply or .obj"),
    };
    let bytes = fs::read(path)
        .map_err(|error| anyhow!("cannot read {shown}: {error}; expected a mesh (.ply or .obj)"))?;
    let file = read(&bytes, false).with_context(|| format!("cannot read {shown}"))?;
    Ok(file.mesh)
}

/// Writes the scene of figures 1, 10 and 11.
fn bunny(path: &Path) -> Result<ExitCode> {
    let written = write_scene(&bunny_shadow::scene(), path)?;
    print(&format!("wrote {}\n", written.display()))?;
    Ok(ExitCode::SUCCESS)
}

/// Writes to the standard output, all of it or with an error. A reader who has seen
/// enough (`| head`) is none.
fn print(text: &str) -> Result<()> {
    let mut to = io::stdout().lock();
    match to.write_all(text.as_bytes()).and_then(|()| to.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => written.context("cannot write to the standard output"),
    }
}
