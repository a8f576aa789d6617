use super::*;
use capwalk_scene::builtin;

struct Directory(PathBuf);

impl Directory {
    fn new(name: &str) -> Self {
        let name = format!("capwalk-export-{name}-{}", std::process::id());
        Self(std::env::temp_dir().join(name))
    }
}

impl Drop for Directory {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn mesh_files_have_plain_and_different_names() {
    let mut scene = builtin::scene("box-room").expect("built in");
    for (shape, id) in scene
        .shapes
        .iter_mut()
        .zip(["a/b", "A b", "a_b", "../x", "é.1"])
    {
        shape.id = id.into();
    }
    let names = mesh_names(&scene);
    assert_eq!(
        names[..5],
        ["a_b.ply", "A_b_2.ply", "a_b_3.ply", "_._x.ply", "é.1.ply"]
    );
}

#[test]
fn unwritable_places_are_named() {
    let directory = Directory::new("unwritable");
    fs::create_dir_all(&directory.0).expect("writable");
    let file = directory.0.join("file");
    fs::write(&file, "in the way").expect("writable");
    let scene = builtin::scene("leaf").expect("built in");
    let error = write_scene(&scene, &file).expect_err("a file is no directory");
    assert!(error.to_string().contains("file"), "{error}");
}
