//! Scene texts around the part that a test is about.

use std::path::{Path, PathBuf};

use capwalk_scene::Scene;
use capwalk_scene_io::{LoadError, load_scene_str};

pub const HEAD: &str = "<scene version=\"3.0.0\">\n";

/// Files for tests.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data")
}

pub fn try_load(text: &str, defines: &[(&str, &str)]) -> Result<Scene, LoadError> {
    let defines: Vec<(String, String)> = defines
        .iter()
        .map(|(name, value)| (name.to_string(), value.to_string()))
        .collect();
    load_scene_str(text, &folder(), "scene.xml", &defines).map(|loaded| loaded.scene)
}

pub fn load(text: &str) -> Scene {
    try_load(text, &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// A scene, and the warnings about it.
pub fn load_with_warnings(text: &str) -> (Scene, Vec<String>) {
    let loaded = load_scene_str(text, &folder(), "scene.xml", &[]);
    let loaded = loaded.unwrap_or_else(|error| panic!("{error}"));
    let warnings = loaded.warnings.iter().map(ToString::to_string).collect();
    (loaded.scene, warnings)
}

/// A scene with one more object, which stands in line 5 from column 3 on.
pub fn scene(object: &str) -> String {
    format!(
        "{HEAD}  <integrator type=\"path\"/>\n  <sensor type=\"perspective\"/>\n  \
         <emitter type=\"constant\"/>\n  {object}\n</scene>"
    )
}

/// A scene whose sensor has these properties, in line 3 from column 30 on.
pub fn sensor(properties: &str) -> String {
    format!(
        "{HEAD}  <integrator type=\"path\"/>\n  <sensor type=\"perspective\">{properties}\
         </sensor>\n</scene>"
    )
}

/// A scene whose film has these properties, in line 3 from column 51 on.
pub fn film(properties: &str) -> String {
    sensor(&format!("<film type=\"hdrfilm\">{properties}</film>"))
}

/// The whole message that a bad scene gets.
pub fn message(text: &str, defines: &[(&str, &str)]) -> String {
    let error = try_load(text, defines).expect_err("a bad scene");
    // Messages show where files were looked for; machines differ in it.
    let folder = format!("{}/", folder().display());
    error.to_string().replace(&folder, "FOLDER/")
}

/// Compares the lines of the message.
pub fn check(text: &str, expected: &[&str]) {
    assert_eq!(message(text, &[]), expected.join("\n"));
}
