//! Derivatives of images against references that share nothing with them, and
//! what the calls that compute them promise. One program: its tests share two
//! cores to the end, and generic code is compiled once.

mod adaptive;
mod auto;
mod closed_forms;
mod common;
mod custom_fields;
mod furnaces;
mod nearly_touching;
mod parts;
mod phenomena_aovs;
mod phenomena_chains;
mod phenomena_edges;
mod phenomena_emitters;
mod phenomena_images;
mod phenomena_indirect;
mod phenomena_maps;
mod phenomena_materials;
mod phenomena_mirrors;
mod phenomena_parallel;
mod phenomena_sensors;
mod phenomena_shadows;
mod phenomena_sky_edges;
mod phenomena_visible;
mod prepared;
mod random_scenes;
mod reference_setup;
mod refusals;
mod reverse;
mod wide_scenes;
