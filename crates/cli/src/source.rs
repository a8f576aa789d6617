//! The scene that the command line names, with its changes, and how to sample it.

use std::path::Path;

use anyhow::{Result, anyhow};
use capwalk::{Error, FilesRead, Loader, Prepared, RenderOptions, Scene, Setting};
use serde_json::{Value, json};

use crate::args::{SamplingArgs, SceneArgs};

/// The scene, from a file or built in, ready to be rendered, and the files that it was read from.
pub fn load(args: &SceneArgs) -> Result<(Prepared, FilesRead)> {
    let mut loader = Loader::new(&args.scene);
    for (name, value) in &args.defines {
        loader = loader.define(name, value);
    }
    if let Some(sensor) = &args.sensor {
        loader = loader.sensor(sensor.clone());
    }
    for setting in &args.settings {
        loader = loader.set(setting.clone());
    }
    if let Some(size) = args.size {
        loader = loader.size(size);
    }
    if let Some(filter) = args.filter {
        loader = loader.filter(filter);
    }
    let loaded = loader.load().map_err(|error| match error {
        Error::NothingToDefine { scene } => anyhow!(
            "the built-in scene \"{scene}\" has nothing to define with -D; export it with \
             `capwalk scenes --export FOLDER {scene}` and edit the file"
        ),
        error => error.into(),
    })?;
    for warning in &loaded.warnings {
        log::warn!("{warning}");
    }
    let prepared = Prepared::new(loaded.scene)?;
    if log::log_enabled!(log::Level::Info) {
        let scene = prepared.scene();
        let triangles: usize = scene.shapes.iter().map(|s| s.mesh.faces.len()).sum();
        log::info!(
            "{}: {} shapes, {triangles} triangles, {} parameters",
            args.scene,
            scene.shapes.len(),
            prepared.registry().scalars(scene).len()
        );
    }
    Ok((prepared, loaded.files))
}

/// What was set in the scene, for JSON.
pub fn settings_json(args: &SceneArgs) -> Value {
    let settings = args.settings.iter();
    let pair = |s: &Setting| json!({"name": s.name, "values": s.values});
    settings.map(pair).collect()
}

/// A short name for default outputs: the file's name without its ending.
pub fn stem(args: &SceneArgs) -> String {
    let stem = Path::new(&args.scene).file_stem();
    stem.map_or_else(|| "scene".into(), |stem| stem.to_string_lossy().into())
}

/// How much to sample.
pub fn options(args: &SamplingArgs, scene: &Scene) -> RenderOptions {
    let of_scene = RenderOptions::of(scene);
    RenderOptions::new(
        args.spp.unwrap_or(of_scene.spp),
        args.seed.unwrap_or(of_scene.seed),
    )
}
