//! Images and derivatives on a GPU: a path tracer in Slang that takes the samples of the CPU's,
//! with the same random numbers and weights, for scenes of a subset of the materials and emitters
//! (see [`unsupported()`]).
//!
//! ```no_run
//! use std::sync::Arc;
//! use capwalk_gpu::{Gpu, GpuOptions};
//! use capwalk_gpu_render::DeviceScene;
//! use capwalk_render::{PreparedScene, RenderOptions, Unwatched};
//!
//! # fn example(scene: capwalk_scene::Scene) -> Result<(), capwalk_gpu_render::DeviceError> {
//! let gpu = Arc::new(Gpu::new(&GpuOptions::default())?);
//! let prepared = PreparedScene::new(scene);
//! let image = DeviceScene::new(&gpu, &prepared)?.render(&RenderOptions::default(), &Unwatched)?;
//! # Ok(()) }
//! ```
//!
//! The samples are divided into parts, one of which is on the device at a time. One kernel generates
//! camera rays and traces them; another extends paths by a segment, and runs until no path is left.
//! The CPU keeps the list of active paths and adds the samples up like its own: in a fixed order, in
//! double precision, with standard errors. So the same scene, options and device give the same bits.
//!
//! [`DeviceScene::gradient`] is the derivative of the image along a direction, whose kernels compute
//! a derivative beside each number. [`DeviceScene::backward`] is the gradient of a loss with respect
//! to all numbers of the scene at once, whose kernels store the vertices of paths and go back along
//! them. Both include boundary terms: edges are sampled on the device at each vertex, and on the CPU
//! for the camera.

mod averages;
mod camera_back;
mod camera_edges;
mod camera_records;
mod derivative_image;
mod device_edges;
mod device_error;
mod device_scene;
mod edge_paths;
mod edge_records;
mod emitter_records;
mod environment_records;
mod fixed_point;
mod images;
mod kept_edges;
mod layout;
mod lobe_records;
mod loss_gradient;
mod motion_records;
mod part_size;
mod paths;
mod render_kernels;
mod scene_records;
mod texture_records;
mod unsupported;
mod upload;

pub use device_error::DeviceError;
pub use device_scene::DeviceScene;
pub use layout::slang as layout_slang;
pub use unsupported::{Unsupported, unsupported, unsupported_derivative};
