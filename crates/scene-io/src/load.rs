//! Scene files to scenes: the stages one after the other.

use std::path::{Path, PathBuf};

use capwalk_scene::Scene;

use crate::error::LoadError;
use crate::fields::Context;
use crate::lower;
use crate::mitsuba;
use crate::resolve::{read_source, resolve};
use crate::source::{Source, Sources};

/// What a scene is loaded with besides its file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LoadOptions {
    /// Values of `$name`, as `-D name=value` gives them.
    pub defines: Vec<(String, String)>,
    /// Which of the scene's sensors to take, counted from 0.
    pub sensor: usize,
}

/// The scene in a Mitsuba 3 XML file. `defines` gives values to `$name` in it
/// and wins over `<default>`.
///
/// What Mitsuba allows and does not change the picture is warned of through
/// `log`; everything else that is not understood is an error.
pub fn load_scene(path: &Path, defines: &[(String, String)]) -> Result<Scene, LoadError> {
    let options = LoadOptions {
        defines: defines.to_vec(),
        sensor: 0,
    };
    load_scene_with(path, &options)
}

/// [`load_scene`] with a choice of the sensor.
pub fn load_scene_with(path: &Path, options: &LoadOptions) -> Result<Scene, LoadError> {
    let source = read_source(path, None).map_err(|message| {
        LoadError::whole_file(path.display().to_string(), message)
            .with_help("expected a Mitsuba scene in XML")
    })?;
    load(source, options)
}

/// The scene in a text. Files in it are relative to `base_dir`, and messages
/// call the text `name`.
pub fn load_scene_str(
    text: &str,
    base_dir: &Path,
    name: &str,
    defines: &[(String, String)],
) -> Result<Scene, LoadError> {
    let source = Source {
        name: name.into(),
        directory: base_dir.into(),
        text: text.into(),
        included_at: None,
    };
    let options = LoadOptions {
        defines: defines.to_vec(),
        sensor: 0,
    };
    load(source, &options)
}

fn load(source: Source, options: &LoadOptions) -> Result<Scene, LoadError> {
    let (scene, warnings) = load_and_collect(source, options)?;
    for warning in warnings {
        log::warn!("{warning}");
    }
    Ok(scene)
}

/// The scene and everything there is to warn of.
fn load_and_collect(
    source: Source,
    options: &LoadOptions,
) -> Result<(Scene, Vec<String>), LoadError> {
    let mut sources = Sources::default();
    let main = sources.add(source);
    let resolved = resolve(&mut sources, main, &options.defines)?;
    let located = |problem| sources.error(problem);
    let graph = mitsuba::parse(&sources, &resolved.root).map_err(located)?;
    let context = Context {
        sources: &sources,
        graph: &graph,
        warnings: Default::default(),
    };
    for &stray in &resolved.stray {
        context.warn(stray, "text outside of an attribute means nothing");
    }
    let mut directories = resolved.search_directories;
    directories.push(sources.main().directory.clone());
    // As Mitsuba does, last of all in the working directory.
    directories.push(PathBuf::new());
    let scene = lower::lower(&context, directories, options.sensor).map_err(located)?;
    Ok((scene, context.warnings.into_inner()))
}
