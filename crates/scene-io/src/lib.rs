//! Files to scenes, pictures and arrays to files.
//!
//! Scenes are read from Mitsuba 3's XML format; `docs/scene-files.md` says which
//! part of it. [`toml`] reads jobs strictly, with the place of every mistake.
//! [`export`] writes scenes, [`image`] writes and reads pictures,
//! [`arrays`] numbers. The stages of reading, each in its file:
//!
//! ```text
//! text -> elements  -> elements without $name, <include> -> nodes     -> Scene
//!         xml          resolve                              mitsuba      lower
//! ```
//!
//! ```
//! let text = r#"<scene version="3.0.0">
//!     <integrator type="path"/>
//!     <sensor type="perspective"/>
//!     <emitter type="constant"/>
//!     <shape type="cube" id="box"/>
//! </scene>"#;
//! let scene = capwalk_scene_io::load_scene_str(text, "".as_ref(), "example", &[])?;
//! assert_eq!(scene.shapes[0].id, "box");
//! # Ok::<(), capwalk_scene_io::LoadError>(())
//! ```

// Reading scenes, meshes and textures.
mod bitmap;
mod error;
mod fields;
mod load;
mod lower;
pub mod mesh;
mod mitsuba;
mod node;
mod resolve;
mod source;
mod suggest;
pub mod toml;
mod upgrade;
mod value;
mod velocities;
mod xml;

// Writing scenes, pictures and arrays.
pub mod arrays;
mod atomic;
pub mod export;
pub mod image;
mod npz;

pub use atomic::append;
#[cfg(feature = "faults")]
pub use atomic::faults;
pub use error::{LoadError, Position};
pub use load::{LoadOptions, load_scene, load_scene_str, load_scene_with};
pub use velocities::{NotVelocities, VelocityFileError, read_velocities};
