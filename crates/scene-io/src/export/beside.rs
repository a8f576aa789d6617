//! The files beside the XML file of a scene.

use std::collections::BTreeMap;

/// Paths of files, relative to the XML file.
#[derive(Default)]
pub(super) struct Files {
    /// Of each shape.
    pub meshes: Vec<String>,
    /// Of textures that are bitmaps, by their index.
    pub bitmaps: BTreeMap<usize, String>,
}
