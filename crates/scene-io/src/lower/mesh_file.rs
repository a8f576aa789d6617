//! Shapes from mesh files.

use std::path::{Path, PathBuf};

use super::lowering::Lowering;
use crate::fields::Fields;
use crate::files::find_file;
use crate::mesh::{GltfChoice, GltfName, MeshFile, read_obj, read_ply, read_serialized};
use crate::node::PropertyValue;
use crate::problem::Problem;
use crate::texts::Span;

/// The plugins that read files.
pub(super) const MESH_PLUGINS: [&str; 4] = ["obj", "ply", "serialized", "gltf"];

/// Endings of mesh formats that no plugin reads.
const OTHER_ENDINGS: [&str; 3] = ["stl", "off", "fbx"];

/// The plugin for files that end so.
fn plugin_for(ending: &str) -> Option<&'static str> {
    let format = if ending == "glb" { "gltf" } else { ending };
    MESH_PLUGINS.into_iter().find(|&plugin| plugin == format)
}

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
        let right = plugin_for(&ending);
        // Other endings say nothing about the format.
        let is_known = right.is_some() || OTHER_ENDINGS.contains(&ending.as_str());
        if is_known && right != Some(plugin) {
            let problem = Problem::unsupported(
                span,
                format!("{} cannot read \"{filename}\"", fields.title()),
            );
            return Err(match right {
                Some(right) => problem.help(format!("write <shape type=\"{right}\">")),
                None => problem.help("convert the mesh to .ply or .obj"),
            });
        }
        let (mesh, path) = match plugin {
            "gltf" => {
                let choice = GltfChoice {
                    node: gltf_name(fields, "node")?,
                    mesh: gltf_name(fields, "mesh")?,
                    primitive: fields.optional_count("primitive", 0)?,
                };
                let source = self.gltf(fields, &example)?;
                let open = |name: &str| source.open(name);
                let mesh = source.file.primitive(&choice, want_normals, &open);
                (mesh, source.path)
            }
            _ => {
                let (bytes, path, _) = self.file(fields, &example)?;
                let mesh = match plugin {
                    "obj" => read_obj(&bytes, want_normals),
                    "serialized" => {
                        let index = fields.count("shape_index", 0, 0)?;
                        read_serialized(&bytes, index, want_normals)
                    }
                    _ => read_ply(&bytes, want_normals),
                };
                (mesh, path)
            }
        };
        let shown = path.display().to_string();
        let mesh = mesh.map_err(|error| Problem::mesh(span, &shown, error))?;
        for warning in &mesh.warnings {
            let message = format!("\"{shown}\" {warning}");
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
        let (bytes, path) = self.read_file(filename, span)?;
        Ok((bytes, path, span))
    }

    /// The bytes of the file with this name, which stands at `span`, and its path.
    pub(super) fn read_file(
        &self,
        filename: &str,
        span: Span,
    ) -> Result<(Vec<u8>, PathBuf), Problem> {
        let path = self.find(filename, span)?;
        Ok((self.read(&path, span)?, path))
    }

    /// The path of the file with this name, which stands at `span`.
    pub(super) fn find(&self, filename: &str, span: Span) -> Result<PathBuf, Problem> {
        let mut directories = self.directories.clone();
        let own = &self.context.texts.get(span.file).directory;
        if !directories.contains(own) {
            directories.push(own.clone());
        }
        find_file(filename, &directories).map_err(|error| {
            Problem::unreadable(span, error).help("give the file relative to the scene file")
        })
    }

    /// The bytes of a file that is named at `span`.
    pub(super) fn read(&self, path: &Path, span: Span) -> Result<Vec<u8>, Problem> {
        self.context.read(path).map_err(|error| {
            let shown = path.display();
            Problem::unreadable(span, format!("cannot read \"{shown}\": {error}"))
                .help("give a file that can be read")
        })
    }
}

/// An object of a glTF file, by its name or its index.
fn gltf_name(fields: &Fields, property: &'static str) -> Result<Option<GltfName>, Problem> {
    if let Some(PropertyValue::String(name)) = fields.get(property).map(|p| &p.value) {
        return Ok(Some(GltfName::Name(name.clone())));
    }
    Ok(fields.optional_count(property, 0)?.map(GltfName::Index))
}

pub(super) fn named_file<'a>(fields: &Fields<'a>, example: &str) -> Result<&'a str, Problem> {
    fields.string("filename")?.ok_or_else(|| {
        let message = format!("{} names no file", fields.title());
        Problem::missing(fields.node.span, message).help(example)
    })
}
