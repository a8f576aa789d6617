//! The scenes that the tests render.

use std::path::{Path, PathBuf};

use capwalk_scene::Scene;

/// A scene file below `tests`.
pub fn scene(name: &str) -> Scene {
    load(&root().join(name))
}

/// All scene files below `tests`, with their names there, in order.
pub fn all() -> Vec<(String, Scene)> {
    let inside = |folder: &str| {
        let entries = std::fs::read_dir(root().join(folder)).expect("a folder");
        entries.map(|entry| entry.expect("an entry").path())
    };
    let of_folder = |folder: PathBuf| folder.join("scene.xml");
    let is_scene =
        |path: &PathBuf| path.extension().is_some_and(|ending| ending == "xml") && path.exists();
    let files = inside("parity").chain(inside("scenes").map(of_folder));
    let mut files: Vec<PathBuf> = files.filter(is_scene).collect();
    files.sort();
    let named = |file: &PathBuf| {
        let name = file
            .strip_prefix(root())
            .expect("below it")
            .display()
            .to_string();
        (name, load(file))
    };
    files.iter().map(named).collect()
}

/// The folder of the scenes.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests")
}

fn load(path: &Path) -> Scene {
    let loaded = capwalk_scene_io::load_scene(path, &[]);
    loaded.unwrap_or_else(|error| panic!("{error}")).scene
}
