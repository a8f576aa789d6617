//! Scene files to scenes: the stages one after the other.

use std::path::{Path, PathBuf};
use std::rc::Rc;

use capwalk_scene::Scene;

use crate::error::LoadError;
use crate::expand::expand;
use crate::fields::Context;
use crate::files::{read_file, read_text};
use crate::files_read::FilesRead;
use crate::gltf_scene;
use crate::lower::lower;
use crate::mesh::GltfFile;
use crate::mitsuba;
use crate::problem::Problem;
use crate::sensor_choice::SensorChoice;
use crate::sensor_settings::SensorSettings;
use crate::texts::{FileId, Text, Texts};
use crate::warning::Warning;

/// What a scene is loaded with besides its file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LoadOptions {
    /// Names and values: what `$name` in the file stands for.
    pub defines: Vec<(String, String)>,
    /// Which of the scene's sensors to take; without, the first, with a warning if there are
    /// others.
    pub sensor: Option<SensorChoice>,
}

/// A scene, and warnings about its file.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// All of its sensors, in the order of the file.
    pub sensors: Vec<SensorSettings>,
    /// What Mitsuba allows and does not change the image, and what makes the
    /// image other than the file seems to ask for. Everything else that is not
    /// understood is an error.
    pub warnings: Vec<Warning>,
    /// The files that it was read from.
    pub files: FilesRead,
}

/// Reads a Mitsuba 3 XML file, or a glTF 2.0 file (`.gltf`, `.glb`). `defines` gives values to `$name` in it and wins
/// over `<default>`.
pub fn load_scene(path: &Path, defines: &[(String, String)]) -> Result<Loaded, LoadError> {
    let options = LoadOptions {
        defines: defines.to_vec(),
        sensor: None,
    };
    load_scene_with(path, &options)
}

/// [`load_scene`] with a choice of the sensor.
pub fn load_scene_with(path: &Path, options: &LoadOptions) -> Result<Loaded, LoadError> {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    if ending == "gltf" || ending == "glb" {
        return load_gltf(path, options);
    }
    let help = "expected a Mitsuba scene in XML, or glTF that ends in .gltf or .glb";
    let text = read_text(path);
    let text = text.map_err(|message| LoadError::unreadable(path, message, help))?;
    load(text, options)
}

/// Reads a scene from a text in memory. Files in it are relative to `base_dir`,
/// and messages call the text `name`.
pub fn load_scene_str(
    text: &str,
    base_dir: &Path,
    name: &str,
    defines: &[(String, String)],
) -> Result<Loaded, LoadError> {
    let options = LoadOptions {
        defines: defines.to_vec(),
        sensor: None,
    };
    load_scene_str_with(text, base_dir, name, &options)
}

/// [`load_scene_str`] with a choice of the sensor.
pub fn load_scene_str_with(
    text: &str,
    base_dir: &Path,
    name: &str,
    options: &LoadOptions,
) -> Result<Loaded, LoadError> {
    load(Text::in_memory(name, base_dir.into(), text.into()), options)
}

/// [`load_scene_str`] of a text that was made from something else: messages name the line
/// of it that they are about by what it was made from, `lines[i]` for the line `i` from 0.
pub fn load_scene_lines(
    text: &str,
    base_dir: &Path,
    lines: Vec<String>,
    options: &LoadOptions,
) -> Result<Loaded, LoadError> {
    let name = lines.first().map_or("", String::as_str).to_owned();
    let text = Text {
        lines,
        ..Text::in_memory(&name, base_dir.into(), text.into())
    };
    load(text, options)
}

fn load(text: Text, options: &LoadOptions) -> Result<Loaded, LoadError> {
    let mut texts = Texts::default();
    stages(&mut texts, text, options).map_err(|problem| problem.locate(&texts))
}

/// A glTF file as a scene.
fn load_gltf(path: &Path, options: &LoadOptions) -> Result<Loaded, LoadError> {
    let name = path.display().to_string();
    let bytes = read_file(path).map_err(|error| {
        let message = format!("cannot read \"{name}\": {error}");
        LoadError::unreadable(path, message, "expected a glTF 2.0 file")
    })?;
    let file = GltfFile::parse(&bytes);
    let lines = file
        .as_ref()
        .map_or(Vec::new(), |file| gltf_scene::lines(file, &name));
    let content = "\n".repeat(lines.len());
    let mut texts = Texts::default();
    let main = texts.add(Text {
        lines,
        ..Text::of_file(path, content)
    });
    let loaded = file.map_err(|error| Problem::gltf(main, error));
    let loaded = loaded.and_then(|file| gltf_stages(&texts, main, path, file, options));
    loaded.map_err(|problem| problem.locate(&texts))
}

/// What follows after a glTF file is read, whose objects stand in `main`.
fn gltf_stages(
    texts: &Texts,
    main: FileId,
    path: &Path,
    file: GltfFile,
    options: &LoadOptions,
) -> Result<Loaded, Problem> {
    if let Some((name, _)) = options.defines.first() {
        let message = format!("\"{name}\" is defined, but glTF has no parameters");
        return Err(Problem::definition_for(main, message).help("leave the definition out"));
    }
    let filename = path.file_name().unwrap_or_default().to_string_lossy();
    let graph = gltf_scene::translate(&file, main, &filename);
    let graph = graph.map_err(|error| Problem::gltf(main, error))?;
    let context = Context::new(texts, &graph);
    let directory = texts.main().directory.clone();
    let own = directory.join(&*filename);
    context.gltf_files.borrow_mut().insert(own, Rc::new(file));
    let mut loaded = finish(context, vec![directory], options)?;
    let mirrored = gltf_scene::mirrored_maps(&loaded.scene);
    loaded.warnings.extend(mirrored.map(|message| Warning {
        location: texts.file(main),
        message,
        is_about_light: false,
    }));
    Ok(loaded)
}

/// All stages; problems refer to `texts`.
fn stages(texts: &mut Texts, text: Text, options: &LoadOptions) -> Result<Loaded, Problem> {
    let main = texts.add(text);
    let expanded = expand(texts, main, &options.defines)?;
    let texts = &*texts;
    let graph = mitsuba::parse(texts, &expanded.root)?;
    let context = Context::new(texts, &graph);
    for upgraded in &expanded.upgraded {
        context.warn(upgraded.span, &upgraded.message);
    }
    for &stray in &expanded.stray {
        context.warn(stray, "text outside of attributes has no effect");
    }
    let mut directories = expanded.search_directories;
    directories.push(texts.main().directory.clone());
    // As Mitsuba does, last of all in the working directory.
    directories.push(PathBuf::new());
    finish(context, directories, options)
}

/// The last stage; files are looked for in these directories.
fn finish(
    context: Context,
    directories: Vec<PathBuf>,
    options: &LoadOptions,
) -> Result<Loaded, Problem> {
    for (span, message) in &context.graph.warnings {
        context.warn(*span, message);
    }
    let (scene, sensors) = lower(&context, directories, options.sensor.as_ref())?;
    let files = context.files.take();
    Ok(Loaded {
        scene,
        sensors,
        files,
        warnings: context.into_warnings(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn warnings(text: &str) -> Vec<String> {
        let loaded = load_scene_str(text, "".as_ref(), "scene.xml", &[]);
        let loaded = loaded.unwrap_or_else(|error| panic!("{error}"));
        loaded.warnings.iter().map(Warning::to_string).collect()
    }

    /// A file for an old version says what was renamed, once.
    #[test]
    fn old_versions_warn() {
        let text = r#"<scene version="0.5.0">
<integrator type="path"><integer name="maxDepth" value="3"/></integrator>
<sensor type="perspective"><film type="ldrfilm"><float name="gamma" value="2"/>
<boolean name="highQualityEdges" value="true"/></film></sensor>
<emitter type="constant"/></scene>"#;
        assert_eq!(
            warnings(text),
            [
                "scene.xml:1:17: the file is for Mitsuba 0.5.0; it is read as one for version 3 \
                 (gamma left out, highQualityEdges is now high_quality_edges, high_quality_edges \
                 is now sample_border, ldrfilm is now hdrfilm, maxDepth is now max_depth)"
            ]
        );
    }

    /// What does not change the image is accepted, each with its place.
    #[test]
    fn cosmetic_properties_warn() {
        let text = r#"<scene version="3.0.0">
<integer name="kd_max_depth" value="3"/>
<integrator type="path"><integer name="block_size" value="32"/></integrator>
<sensor type="perspective"><float name="focus_distance" value="3"/>
<film type="hdrfilm"><boolean name="banner" value="false"/>
<string name="pixel_format" value="rgba"/><string name="component_format" value="float16"/>
<boolean name="compensate" value="true"/>
<string name="file_format" value="pfm"/></film></sensor>
<shape type="cube"><float name="silhouette_sampling_weight" value="2"/>
<emitter type="area"><float name="sampling_weight" value="2"/></emitter></shape>
stray text
</scene>"#;
        let places: Vec<String> = warnings(text)
            .iter()
            .map(|w| w.split(": ").take(2).collect::<Vec<_>>().join(": "))
            .collect();
        let expected = [
            "scene.xml:11:1: text outside of attributes has no effect",
            "scene.xml:2:16: \"kd_max_depth\" has no effect here",
            "scene.xml:3:40: \"block_size\" has no effect here",
            "scene.xml:8:15: \"file_format\" has no effect here",
            "scene.xml:6:15: \"pixel_format\" has no effect here",
            "scene.xml:6:57: \"component_format\" has no effect here",
            "scene.xml:5:37: \"banner\" has no effect here",
            "scene.xml:7:16: \"compensate\" has no effect here",
            "scene.xml:4:41: \"focus_distance\" has no effect here",
            "scene.xml:10:35: \"sampling_weight\" has no effect here",
            "scene.xml:9:33: \"silhouette_sampling_weight\" has no effect here",
        ];
        assert_eq!(places, expected);
    }

    #[test]
    fn doubtful_scenes_warn() {
        let text = r#"<scene version="3.0.0"><integrator type="path"/>
<sensor type="perspective"/><sensor type="perspective"/>
<bsdf type="diffuse" id="m"><float name="reflectance" value="2"/></bsdf></scene>"#;
        let expected = [
            "scene.xml:2:29: the scene has 2 sensors; rendering with the first",
            "scene.xml:3:62: \"reflectance\" is above 1: the surface reflects more than it receives",
            "scene.xml:1:1: the scene has no emitter; the image will be black",
        ];
        assert_eq!(warnings(text), expected);
    }

    /// Colours that sRGB lacks say what they are read as.
    #[test]
    fn clamped_spectra_warn() {
        let text = r#"<scene version="3.0.0"><integrator type="path"/><sensor type="perspective"/>
<bsdf type="diffuse" id="m"><spectrum name="reflectance" value="600:0.9 650:1"/></bsdf>
<emitter type="constant"/></scene>"#;
        let expected = "scene.xml:2:65: \"reflectance\" has a colour that sRGB lacks: \
                        (0.7040, -0.0271, -0.0108) is read as (0.7040, 0.0000, 0.0000)";
        assert_eq!(warnings(text), [expected]);
    }

    /// Integrators of derivatives and samplers that are read as others say so;
    /// old names are shown as they are written.
    #[test]
    fn what_is_read_as_something_else_warns() {
        let text = r#"<scene version="0.6.0">
<integrator type="prb_projective"><integer name="sppc" value="3"/>
<boolean name="strictNormals" value="true"/></integrator>
<sensor type="perspective"><sampler type="multijitter"><boolean name="jitter" value="true"/>
</sampler></sensor><emitter type="constant"><float name="samplingWeight" value="2"/></emitter></scene>"#;
        let starts = [
            "scene.xml:1:17: the file is for Mitsuba 0.6.0; ",
            "scene.xml:2:19: the integrator \"prb_projective\" is read as \"path\", ",
            "scene.xml:2:50: \"sppc\" has no effect here: ",
            "scene.xml:3:16: \"strictNormals\" (now \"strict_normals\") is read as false: ",
            "scene.xml:4:43: the sampler \"multijitter\" is read as \"sobol\": ",
            "scene.xml:4:71: \"jitter\" has no effect here: ",
            "scene.xml:5:58: \"samplingWeight\" (now \"sampling_weight\") has no effect here: ",
        ];
        let found = warnings(text);
        assert_eq!(found.len(), starts.len(), "{found:#?}");
        for (warning, start) in found.iter().zip(starts) {
            assert!(warning.starts_with(start), "{warning}");
        }
    }

    /// A scene that is cut away as a whole says where it is.
    #[test]
    fn scenes_outside_of_the_clip_planes_warn() {
        let with = |properties: &str, z: f64| {
            warnings(&format!(
                r#"<scene version="3.0.0"><integrator type="path"/>
<sensor type="perspective">{properties}</sensor><emitter type="constant"/>
<shape type="cube"><transform name="to_world"><translate z="{z}"/></transform></shape></scene>"#
            ))
        };
        assert!(with("", 5.0).is_empty());
        let near = with(r#"<float name="near_clip" value="7"/>"#, 5.0);
        assert!(
            near[0].starts_with("scene.xml:2:59: no surface is seen: "),
            "{near:?}"
        );
        let numbers = "depths from 4.0000 to 6.0000, outside of near_clip 7 to far_clip 10000";
        assert!(near[0].contains(numbers), "{near:?}");
        assert!(with(r#"<float name="near_clip" value="5"/>"#, 5.0).is_empty());
        assert_eq!(with(r#"<float name="far_clip" value="3"/>"#, 5.0).len(), 1);
        assert!(with("", -5.0)[0].contains("from -6.0000 to -4.0000"));
    }

    /// An AOV needs no emitter.
    #[test]
    fn aovs_without_emitters_are_silent() {
        let text = r#"<scene version="3.0.0"><integrator type="aov">
<string name="aovs" value="d:depth"/></integrator><sensor type="perspective"/></scene>"#;
        assert!(warnings(text).is_empty());
    }

    /// What Mitsuba writes itself needs no warnings.
    #[test]
    fn ordinary_scenes_are_silent() {
        let text = r#"<scene version="3.0.0"><integrator type="path"/>
<sensor type="perspective"><film type="hdrfilm"><string name="pixel_format" value="rgb"/>
<string name="component_format" value="float32"/></film></sensor>
<emitter type="constant"><float name="sampling_weight" value="1"/></emitter></scene>"#;
        assert!(warnings(text).is_empty());
    }
}
