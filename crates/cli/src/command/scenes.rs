//! `capwalk scenes`: what is built in, and how to get it as files.

use anyhow::{Context, Result, bail};
use capwalk::scene::builtin::{self, Builtin};
use serde_json::json;

use crate::args::Scenes;
use crate::diagnostics::Outcome;
use crate::{console, report};

pub fn run(args: &Scenes) -> Result<Outcome> {
    let chosen = chosen(&args.names)?;
    let Some(folder) = &args.export else {
        list(&chosen, args.json)?;
        return Ok(Outcome::Done);
    };
    let mut written = Vec::new();
    for scene in chosen {
        let file = folder.join(format!("{}.xml", scene.name));
        let made = builtin::scene(scene.name).expect("it is listed");
        let file = capwalk::scene_io::export::write_new_scene(&made, &file)
            .with_context(|| format!("cannot export the scene \"{}\"", scene.name))?;
        written.push(file.display().to_string());
    }
    if args.json {
        console::print_json(&json!({ "files": written }))?;
    } else {
        console::print(&report::written(&written))?;
    }
    Ok(Outcome::Done)
}

/// The scenes of these names, or all.
fn chosen(names: &[String]) -> Result<Vec<&'static Builtin>> {
    if let Some(unknown) = names.iter().find(|n| builtin::scene(n).is_none()) {
        let known: Vec<&str> = builtin::names().collect();
        bail!(
            "there is no built-in scene \"{unknown}\"; they are {}",
            known.join(", ")
        );
    }
    let wanted = |scene: &&Builtin| names.is_empty() || names.iter().any(|n| n == scene.name);
    Ok(builtin::ALL.iter().filter(wanted).collect())
}

fn list(scenes: &[&Builtin], as_json: bool) -> Result<()> {
    if as_json {
        let scenes = scenes.iter().map(|scene| {
            json!({
                "name": scene.name,
                "description": scene.description,
                "default_parameter": scene.default_parameter,
            })
        });
        return console::print_json(&json!({ "scenes": scenes.collect::<Vec<_>>() }));
    }
    let lines: Vec<(&str, String)> = scenes
        .iter()
        .map(|s| {
            let text = format!(
                "{}\n{:17}made for {}",
                s.description, "", s.default_parameter
            );
            (s.name, text)
        })
        .collect();
    console::print(&report::list(&lines))
}
