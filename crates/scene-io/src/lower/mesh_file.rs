//! Shapes from mesh files: `obj` and `ply`.

use std::path::{Path, PathBuf};

use super::Lowering;
use crate::fields::Fields;
use crate::mesh::{MeshFile, read_obj, read_ply};
use crate::resolve::find_file;
use crate::source::{Problem, Span};

/// Endings of mesh formats; a file with another one's is not read as this one.
const MESH_ENDINGS: [&str; 8] = [
    "obj",
    "ply",
    "stl",
    "off",
    "gltf",
    "glb",
    "fbx",
    "serialized",
];

impl Lowering<'_> {
    /// The mesh that the shape names and the path of its file.
    pub(super) fn mesh_file(
        &self,
        fields: &Fields,
        want_normals: bool,
    ) -> Result<(MeshFile, PathBuf), Problem> {
        let plugin = fields.node.plugin.as_str();
        let example = format!("add <string name=\"filename\" value=\"mesh.{plugin}\"/>");
        let filename = named_file(fields, &example)?;
        let span = fields.span_of("filename");
        let ending = Path::new(filename).extension().and_then(|e| e.to_str());
        let ending = ending.unwrap_or("").to_ascii_lowercase();
        if ending != plugin && MESH_ENDINGS.contains(&ending.as_str()) {
            let problem = Problem::new(
                span,
                format!("{} cannot read \"{filename}\"", fields.title()),
            );
            return Err(match ending.as_str() {
                "obj" | "ply" => problem.help(format!("write <shape type=\"{ending}\">")),
                _ => problem.help("convert the mesh to .ply or .obj"),
            });
        }
        let (bytes, path, _) = self.file(fields, &example)?;
        let shown = path.display();
        let mesh = match plugin {
            "obj" => read_obj(&bytes, want_normals),
            _ => read_ply(&bytes, want_normals),
        };
        let mesh = mesh.map_err(|error| {
            let place = match error.place.is_empty() {
                true => String::new(),
                false => format!(", {}", error.place),
            };
            Problem::new(span, format!("\"{shown}\"{place}: {}", error.message)).help(error.help)
        })?;
        for skipped in &mesh.skipped {
            let message = format!("\"{shown}\" has {skipped}, which are not read");
            self.context.warn(span, &message);
        }
        Ok((mesh, path))
    }

    /// The bytes of the file that `filename` names, its path, and where it is
    /// named. `example` says how to name one.
    pub(super) fn file(
        &self,
        fields: &Fields,
        example: &str,
    ) -> Result<(Vec<u8>, PathBuf, Span), Problem> {
        let filename = named_file(fields, example)?;
        let span = fields.span_of("filename");
        let mut directories = self.directories.clone();
        let own = &self.context.sources.get(span.file).directory;
        if !directories.contains(own) {
            directories.push(own.clone());
        }
        let path = find_file(filename, &directories).map_err(|error| {
            Problem::new(span, error).help("give the file relative to the scene file")
        })?;
        let bytes = match path.is_dir() {
            true => Err("it is a folder; expected a file".to_owned()),
            false => std::fs::read(&path).map_err(|error| error.to_string()),
        };
        let bytes = bytes.map_err(|error| {
            let shown = path.display();
            Problem::new(span, format!("cannot read \"{shown}\": {error}"))
                .help("give a file that can be read")
        })?;
        Ok((bytes, path, span))
    }
}

fn named_file<'a>(fields: &Fields<'a>, example: &str) -> Result<&'a str, Problem> {
    fields.string("filename")?.ok_or_else(|| {
        let message = format!("{} names no file", fields.title());
        Problem::new(fields.node.span, message).help(example)
    })
}
