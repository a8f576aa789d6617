//! glTF files that shapes and textures name: each is read once for a scene.

use std::path::{Path, PathBuf};
use std::rc::Rc;

use super::lowering::Lowering;
use super::mesh_file::named_file;
use crate::fields::{Context, Fields};
use crate::mesh::{GltfFile, MeshFileError};
use crate::problem::Problem;

/// A glTF file that an object names.
pub(super) struct GltfSource<'a> {
    pub file: Rc<GltfFile>,
    pub path: PathBuf,
    context: &'a Context<'a>,
}

impl GltfSource<'_> {
    /// The bytes of a file beside it.
    pub fn open(&self, name: &str) -> Result<Vec<u8>, String> {
        let path = self.path.parent().unwrap_or(Path::new("")).join(name);
        self.context.read(&path).map_err(|error| error.to_string())
    }

    /// An error in it, for an object.
    pub fn problem(&self, fields: &Fields, error: MeshFileError) -> Problem {
        Problem::mesh(
            fields.span_of("filename"),
            &self.path.display().to_string(),
            error,
        )
    }
}

impl<'a> Lowering<'a> {
    /// The glTF file that `filename` names. `example` says how to name one.
    pub(super) fn gltf(&self, fields: &Fields, example: &str) -> Result<GltfSource<'a>, Problem> {
        let span = fields.span_of("filename");
        let path = self.find(named_file(fields, example)?, span)?;
        let known = self.context.gltf_files.borrow().get(&path).cloned();
        let file = match known {
            Some(file) => file,
            None => {
                let bytes = self.read(&path, span)?;
                let file = GltfFile::parse(&bytes);
                let file =
                    file.map_err(|error| Problem::mesh(span, &path.display().to_string(), error))?;
                let file = Rc::new(file);
                let mut known = self.context.gltf_files.borrow_mut();
                known.insert(path.clone(), file.clone());
                file
            }
        };
        Ok(GltfSource {
            file,
            path,
            context: self.context,
        })
    }
}
