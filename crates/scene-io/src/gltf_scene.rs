//! A glTF file as a scene: the objects that Mitsuba's XML would have for it. What they
//! mean, and what is said about them, is the same from here on.
//!
//! What changes the image and has no such object is an error with its place.

mod gltf_extension;
mod gltf_light;
mod gltf_material;
mod gltf_sensor;
mod graph_builder;
mod mirrored_maps;

pub(crate) use graph_builder::lines;
pub(crate) use mirrored_maps::mirrored_maps;

use crate::mesh::{GltfFile, MeshFileError, unsupported};
use crate::node::{Graph, Kind, NodeId, PropertyValue};
use crate::texts::FileId;
use gltf_extension::refuse_extensions;
use graph_builder::{FILE, GraphBuilder, PrimitiveSurface, Radiance};

/// The objects of a file which is called `filename` beside the scene. Their places are in the text
/// of [`lines`].
pub(crate) fn translate(
    file: &GltfFile,
    text: FileId,
    filename: &str,
) -> Result<Graph, MeshFileError> {
    file.check_rest()?;
    refuse_extensions(file)?;
    let mut builder = GraphBuilder::new(file, text, filename);
    let root = builder.add(Kind::Scene, "scene", None, FILE);
    let integrator = builder.add(Kind::Integrator, "path", None, FILE);
    builder.put(root, integrator);
    for &(node, to_scene) in file.nodes()? {
        let content = file.document.nodes().nth(node).expect("nodes are counted");
        if let Some(camera) = content.camera() {
            let sensor = builder.sensor(node, camera.index(), to_scene)?;
            builder.put(root, sensor);
        }
        if let Some(light) = content.light() {
            let emitter = builder.light(node, &light, to_scene)?;
            builder.put(root, emitter);
        }
        for primitive in content.mesh().iter().flat_map(gltf::Mesh::primitives) {
            let shape = builder.shape(node, &primitive)?;
            builder.put(root, shape);
        }
    }
    if !builder.has_sensor() {
        let help = "export it with a camera (Blender: Include, Cameras), or show its meshes in a \
                    scene of Mitsuba's XML, by <shape type=\"gltf\">";
        return Err(unsupported(
            "",
            "its scene has no camera to render with",
            help,
        ));
    }
    if file.animations > 0 {
        let message = "the file has animations: nodes stand where they are without";
        builder.warn(FILE, message);
    }
    Ok(builder.finish(root))
}

impl GraphBuilder<'_> {
    /// One primitive of the mesh of a node.
    fn shape(&mut self, node: usize, primitive: &gltf::Primitive) -> Result<NodeId, MeshFileError> {
        let line = self.line_of_node(node);
        // Without an id it is called as its node.
        let shape = self.add(Kind::Shape, "gltf", None, line);
        let filename = self.filename();
        self.set(shape, "filename", filename);
        self.set(shape, "node", PropertyValue::Integer(node as i64));
        let index = PropertyValue::Integer(primitive.index() as i64);
        self.set(shape, "primitive", index);
        let PrimitiveSurface { bsdf, radiance } = self.surface(primitive)?;
        self.refer(shape, "", bsdf);
        if let Some(radiance) = radiance {
            let emitter = self.add(Kind::Emitter, "area", None, line);
            match radiance {
                Radiance::Colour(colour) => {
                    self.set(emitter, "radiance", PropertyValue::Rgb(colour))
                }
                Radiance::Texture(texture) => self.refer(emitter, "radiance", texture),
            }
            self.put(shape, emitter);
        }
        Ok(shape)
    }
}
