//! Reading and writing files: scenes in Mitsuba's XML and glTF, meshes in OBJ, PLY, glTF and
//! `.serialized`, images, and arrays for NumPy. Reading is strict: a property that is not supported
//! is an error with its place.
//!
//! `docs/scene-files.md` describes the supported parts of XML and glTF. [`toml`] reads jobs,
//! [`export`] writes scenes, [`image`] and [`arrays`] read and write images and numbers. The stages
//! of reading, one file each:
//!
//! ```text
//! text  -> elements -> elements without $name, <include> -> nodes      -> Scene
//!          xml         expand                               mitsuba       lower
//! bytes -> GltfFile                                      -> nodes      -> Scene
//!          mesh/gltf_file                                   gltf_scene    lower
//! ```
//!
//! ```
//! let text = r#"<scene version="3.0.0">
//!     <integrator type="path"/>
//!     <sensor type="perspective"/>
//!     <emitter type="constant"/>
//!     <shape type="cube" id="box"/>
//! </scene>"#;
//! let loaded = capwalk_scene_io::load_scene_str(text, "".as_ref(), "example", &[])?;
//! assert_eq!(loaded.scene.shapes[0].id, "box");
//! # Ok::<(), capwalk_scene_io::LoadError>(())
//! ```

// Reading scenes, meshes and textures.
mod any_image;
mod bitmap;
mod cie;
mod error;
mod expand;
mod fields;
mod files;
mod files_read;
mod gltf_scene;
mod load;
mod location;
mod lower;
pub mod mesh;
mod mitsuba;
mod names;
mod node;
mod npy;
mod problem;
mod sensor_choice;
mod sensor_settings;
mod spectrum;
mod suggest;
mod texts;
pub mod toml;
mod upgrade;
mod value;
mod warning;
mod xml;

// Writing scenes, images and arrays.
mod archive;
pub mod arrays;
mod atomic;
pub mod export;
pub mod image;
mod velocities;

pub use any_image::read_image;
#[cfg(feature = "faults")]
pub use atomic::faults;
pub use atomic::{append, is_temporary};
pub use error::{Diagnostic, LoadError};
pub use files::{read_file, read_text_file};
pub use files_read::{FilesRead, InputInTheWay};
pub use load::{
    LoadOptions, Loaded, load_scene, load_scene_lines, load_scene_str, load_scene_str_with,
    load_scene_with,
};
pub use location::{Location, Position};
pub use lower::bsdf_plugins;
pub use sensor_choice::SensorChoice;
pub use sensor_settings::SensorSettings;
pub use velocities::{NotVelocities, VelocityFileError, read_velocities};
pub use warning::Warning;
