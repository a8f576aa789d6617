//! The files beside the XML file of a scene.

use std::collections::BTreeMap;

/// Paths of files, relative to the XML file.
#[derive(Default)]
pub(super) struct Files {
    /// Files of the shapes' meshes, in the order of the shapes.
    pub meshes: Vec<String>,
    /// Files of textures that are bitmaps, by the index of the texture.
    pub bitmaps: BTreeMap<usize, String>,
}
