//! `--domain triangle`, the paper's field, against the finite differences of `check`,
//! where it is quiet enough to be compared.

use std::path::Path;

use capwalk_diff::Method;
use capwalk_scene::params;

use crate::folder::Folder;
use crate::methods::{agrees, chosen};

/// Demands that fields on triangles agree with the differences in a file.
pub fn agree(folder: &Folder, parameter: &str, check: &Path) {
    let name = format!("{}, {parameter}, triangles", folder.name);
    let scene = folder.scene();
    let tangent = params::Registry::new(&scene)
        .tangent(&scene, parameter)
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    let options = chosen(Method::TriangleWalk, &scene, &tangent);
    agrees(&name, options, &scene, &tangent, check);
}
