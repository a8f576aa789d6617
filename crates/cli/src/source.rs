//! The scene that the command line names, with its changes, and how to sample it.

use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use capwalk_diff::Options;
use capwalk_scene::{Filter, Scene, builtin};
use capwalk_scene_io::{Loaded, load_scene};

use crate::args::{FilterName, SamplingArgs, SceneArgs};

/// The scene, from a file or built in, checked.
pub fn load(args: &SceneArgs) -> Result<Scene> {
    let mut scene = match builtin::scene(&args.scene) {
        Some(scene) => {
            ensure!(
                args.defines.is_empty(),
                "the built-in scene \"{}\" has nothing to define with -D; export it with \
                 `capwalk scenes --export FOLDER {}` and edit the file",
                args.scene,
                args.scene
            );
            scene
        }
        None => from_file(args)?,
    };
    if let Some(size) = args.size {
        scene.film.size = size;
        scene.film.crop_offset = [0, 0];
        scene.film.crop_size = size;
    }
    if let Some(filter) = args.filter {
        scene.film.filter = match filter {
            FilterName::Box => Filter::Box,
            FilterName::Tent => Filter::Tent { radius: 1.0 },
            FilterName::Gaussian => Filter::Gaussian { stddev: 0.5 },
        };
    }
    scene
        .check()
        .with_context(|| format!("the scene {} cannot be rendered", args.scene))?;
    let triangles: usize = scene.shapes.iter().map(|s| s.mesh.faces.len()).sum();
    log::info!(
        "{}: {} shapes, {triangles} triangles, {} parameters",
        args.scene,
        scene.shapes.len(),
        capwalk_scene::params::Registry::new(&scene)
            .scalars(&scene)
            .len()
    );
    Ok(scene)
}

fn from_file(args: &SceneArgs) -> Result<Scene> {
    let path = Path::new(&args.scene);
    if !path.exists() {
        let names: Vec<&str> = builtin::names().collect();
        bail!(
            "there is no file {}, and no built-in scene of that name (they are {})",
            args.scene,
            names.join(", ")
        );
    }
    Ok(warned(load_scene(path, &args.defines)?))
}

/// The scene; its warnings are printed.
pub fn warned(loaded: Loaded) -> Scene {
    for warning in &loaded.warnings {
        log::warn!("{warning}");
    }
    loaded.scene
}

/// A short name for default outputs: the file's name without its ending.
pub fn stem(args: &SceneArgs) -> String {
    let stem = Path::new(&args.scene).file_stem();
    stem.map_or_else(|| "scene".into(), |stem| stem.to_string_lossy().into())
}

/// How much to sample.
pub fn options(args: &SamplingArgs, scene: &Scene) -> Options {
    Options {
        spp: args.spp.unwrap_or(scene.settings.spp),
        seed: args.seed.unwrap_or(scene.settings.seed),
    }
}
