//! The scenes that are compared with Mitsuba must load.

use std::path::Path;

#[test]
fn parity_scenes_load() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/parity");
    let mut scenes = 0;
    for entry in std::fs::read_dir(folder).expect("the parity scenes") {
        let path = entry.expect("readable").path();
        if path.extension().is_some_and(|ending| ending == "xml") {
            let defines = [("spp".to_owned(), "9".to_owned())];
            let scene = capwalk_scene_io::load_scene(&path, &defines);
            let scene = scene.unwrap_or_else(|error| panic!("{error}")).scene;
            assert_eq!(scene.settings.spp, 9, "{}", path.display());
            assert!(scene.film.pixel_count() <= 48 * 48, "{}", path.display());
            scenes += 1;
        }
    }
    assert!(scenes >= 18, "{scenes}");
}
