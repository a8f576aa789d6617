//! Images and derivatives on a device: a path tracer that samples what the processor's does, with the
//! same random numbers and weights.
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
//! A part of the image's samples at a time is on the device. One kernel draws the camera's rays and
//! follows them, one takes paths further by a segment, and is run until none goes on. The processor
//! keeps the list of the paths that go on, and adds the samples up, as it does its own: in a fixed
//! order, in double precision, with standard errors. So the same scene, options and device give the
//! same bits.
//!
//! Derivatives are that of the image along a direction ([`DeviceScene::gradient`]), whose kernels
//! carry a derivative beside each number, and that of a loss with respect to all numbers of the scene
//! at once ([`DeviceScene::backward`]), whose kernels keep the vertices of paths and go back along
//! them. Both have the boundary terms of what moves: edges are sampled at each vertex, and before the
//! camera, where the processor draws them.
//!
//! What a scene may have is not all yet: see [`unsupported()`].

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
