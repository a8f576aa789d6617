//! `capwalk figures`: the paper's figures and claims, measured.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use capwalk::Watch;
use capwalk_figures::{Failure, Figure, Quality, Settings, Verdict, draw, write};
use capwalk_geometry::Mesh;
use capwalk_scene_io::mesh::{read_obj, read_ply};
use serde_json::json;

use crate::args::{Figures, QualityName};
use crate::console;
use crate::diagnostics::Outcome;
use crate::progress::Progress;
use crate::report;

pub fn run(args: &Figures) -> Result<Outcome> {
    let settings = Settings {
        quality: match args.quality {
            QualityName::Smoke => Quality::Smoke,
            QualityName::Draft => Quality::Draft,
            QualityName::Full => Quality::Full,
        },
        seed: args.seed,
        mesh: args.mesh.as_deref().map(mesh).transpose()?,
        stages: &|name| Box::new(Stage(Some(Progress::new(name, None)))),
    };
    // A folder that cannot be written to is an error before the work.
    write(&[], &args.out)?;
    let mut figures = Vec::new();
    let mut stopped = false;
    for entry in &capwalk_figures::ALL {
        if !args
            .names
            .iter()
            .any(|name| name == entry.name || name == "all")
        {
            continue;
        }
        match draw(entry.name, &settings) {
            Ok(figure) => {
                if !args.json {
                    console::print(&describe(&figure))?;
                }
                figures.push(figure);
            }
            Err(Failure::Stopped) => {
                stopped = true;
                break;
            }
            Err(failure) => {
                // What is done is not lost.
                write(&figures, &args.out)?;
                return Err(failure).context(entry.name);
            }
        }
    }
    let written = write(&figures, &args.out)?;
    let names: Vec<String> = written.iter().map(|p| p.display().to_string()).collect();
    match args.json {
        true => console::print_json(&json!({
            "quality": settings.quality.name(),
            "seed": args.seed,
            "figures": figures.iter().map(figure_json).collect::<Vec<_>>(),
            "files": names,
        }))?,
        false => console::print(&format!(
            "{} files, for all of it open {}\n",
            written.len(),
            args.out.join("report.html").display()
        ))?,
    }
    Ok(match stopped {
        true => Outcome::Interrupted,
        false => Outcome::Done,
    })
}

/// A figure's claims as text.
fn describe(figure: &Figure) -> String {
    let mut text = format!("{}, {}\n", figure.title, report::seconds(figure.seconds));
    for claim in &figure.claims {
        text += &format!(
            "  {}\n    paper: {}\n    here:  {}\n    {}\n",
            claim.statement, claim.paper, claim.ours, claim.verdict
        );
    }
    text
}

fn figure_json(figure: &Figure) -> serde_json::Value {
    let claims = figure.claims.iter().map(|claim| {
        json!({
            "claim": claim.statement,
            "paper": claim.paper,
            "here": claim.ours,
            "verdict": match &claim.verdict {
                Verdict::Holds => "holds",
                Verdict::DoesNotHold(_) => "does not hold",
                Verdict::CouldNotTell(_) => "could not tell",
                Verdict::NotComparable(_) => "not comparable",
            },
            "because": match &claim.verdict {
                Verdict::Holds => None,
                Verdict::DoesNotHold(reason)
                | Verdict::CouldNotTell(reason)
                | Verdict::NotComparable(reason) => Some(reason),
            },
        })
    });
    json!({
        "figure": figure.name,
        "title": figure.title,
        "seconds": figure.seconds,
        "claims": claims.collect::<Vec<_>>(),
    })
}

/// A bar that goes away with its stage.
struct Stage(Option<Progress>);

impl Drop for Stage {
    fn drop(&mut self) {
        if let Some(progress) = self.0.take() {
            progress.finish();
        }
    }
}

impl Watch for Stage {
    fn progress(&self, done: u64, total: u64) {
        if let Some(progress) = &self.0 {
            progress.progress(done, total);
        }
    }

    fn should_stop(&self) -> bool {
        self.0.as_ref().is_some_and(Watch::should_stop)
    }
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
