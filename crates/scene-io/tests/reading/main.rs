//! Reading scenes and meshes: what the files mean, and what is said about bad
//! ones. The texts of messages are part of the program: they must name the
//! place, what is wrong, and what to do.

mod archives;
mod attacks;
mod camera;
mod common;
mod curves;
mod damage;
mod documented;
mod emitters;
mod gltf;
mod gltf_bad;
mod gltf_file;
mod gltf_room;
mod gltf_scenes;
mod gltf_scenes_bad;
mod materials;
mod meaning;
mod mesh_files;
mod meshes;
mod names;
mod objects;
mod parameters;
mod parity;
mod readers;
mod robustness;
mod serialized;
mod spectra;
mod syntax;
mod textures;
mod upgrade;
