//! Extensions that are not read, of a glTF scene and its nodes.

use crate::mesh::{GltfFile, MeshFileError, unsupported};

/// Refuses extensions that change the image and are not read, of the file, its scene and nodes.
pub(super) fn refuse_extensions(file: &GltfFile) -> Result<(), MeshFileError> {
    file.refuse_required_extensions()?;
    let root = file.document.as_json();
    let scene = root.scene.map_or(0, |scene| scene.value());
    let scene = format!("scenes[{scene}].extensions");
    if let Some(name) = file.keys(&scene).next() {
        return Err(not_read(&scene, name));
    }
    for (node, _) in file.nodes()? {
        let place = format!("nodes[{node}].extensions");
        if let Some(name) = file
            .keys(&place)
            .find(|&name| name != "KHR_lights_punctual")
        {
            return Err(not_read(&place, name));
        }
    }
    Ok(())
}

/// The error that an extension is not read.
pub(super) fn not_read(place: &str, extension: &str) -> MeshFileError {
    let help = match extension {
        "KHR_draco_mesh_compression" | "EXT_meshopt_compression" | "KHR_meshopt_compression" => {
            "export the file without compression of meshes"
        }
        "EXT_mesh_gpu_instancing" => "export each copy as a node",
        _ => {
            "export the file without it, or show its meshes in a scene of Mitsuba's XML, by <shape \
             type=\"gltf\">"
        }
    };
    unsupported(
        place,
        format!("the extension \"{extension}\" is not read"),
        help,
    )
}
