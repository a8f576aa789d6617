//! `--method walk` and `--method edges` against the finite differences of `check`, which
//! has `auto`, wherever something moves.

use std::path::Path;

use capwalk_diff::Method;
use capwalk_scene::{SensorVectors, params};

use crate::folder::{Edges, Folder};
use crate::methods::{by, meets};

/// Enough samples to see that two methods are not the same.
const FEW: u32 = 4;

/// Demands that walks agree with the differences in a file, and that gathered edges do or
/// are walks again.
pub fn agree(folder: &Folder, parameter: &str, edges: Edges, check: &Path) {
    let name = format!("{}, {parameter}", folder.name);
    let scene = folder.scene();
    let tangent = params::Registry::new(&scene)
        .tangent(&scene, parameter)
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    let is_at_rest = tangent.shapes.iter().all(Option::is_none);
    if is_at_rest && tangent.sensor == SensorVectors::default() {
        return;
    }
    let [few, walked] =
        [Method::EDGES, Method::Walk].map(|method| by(method, &scene, &tangent, FEW));
    assert_eq!(
        few.mean == walked.mean,
        edges == Edges::Walked,
        "{name}: are they the same as walks, as check.json says?"
    );
    for method in [Method::Walk, Method::EDGES] {
        if method == Method::Walk || edges == Edges::Gathered {
            let name = format!("{name}, {}", method.name());
            meets(
                &name,
                &by(method, &scene, &tangent, scene.settings.spp),
                check,
            );
        }
    }
}
