//! Geometry queries in batches on a GPU of any vendor, or on software Vulkan: first hits,
//! occlusion, closest silhouettes, and all silhouettes in a cone, over the trees of `capwalk-geometry`.
//!
//! ```no_run
//! use std::sync::Arc;
//! use capwalk_geometry::{Mesh, Ray, RayTree};
//! use capwalk_gpu::{DeviceRayTree, Gpu, GpuOptions};
//!
//! # fn example(mesh: &Mesh, rays: &[Ray]) -> Result<(), capwalk_gpu::GpuError> {
//! let gpu = Arc::new(Gpu::new(&GpuOptions::default())?);
//! let tree = DeviceRayTree::new(&gpu, &RayTree::build(mesh))?;
//! let hits = tree.first_hits(rays)?;
//! # Ok(()) }
//! ```
//!
//! Kernels run through wgpu on Vulkan, Metal and DX12, also on software Vulkan if there is no GPU
//! ([`Gpu::is_software`]), or through NVIDIA's driver if there is no Vulkan ([`Interface`]). Equal
//! batches on one device give equal bits, however they are divided into launches.
//!
//! # Precision
//!
//! Bounds are tested in single precision with margins for all rounding, so no result is skipped.
//! Triangles and edges are tested in double precision if the device has it ([`Precision::Double`]).
//! Then answers equal brute force up to the rounding of divisions and square roots, which devices
//! need not do as exactly as CPUs. With [`Precision::Single`] they are tested in single precision, in
//! the coordinates of the tree. Then answers are exact for primitives and viewpoints that are moved
//! by about [`SINGLE_ERROR`] times their distance; its documentation has the details.

mod batch;
mod compiled_kernel;
mod copies;
// NVIDIA makes no drivers for other systems.
#[cfg_attr(
    not(any(target_os = "linux", target_os = "windows")),
    path = "no_cuda_driver.rs"
)]
mod cuda_driver;
mod driver;
mod error;
mod foreign_kernels;
mod gpu;
mod kernels;
mod launch;
mod layout;
mod local_cone;
mod local_ray;
mod precision;
mod ray_queries;
mod refit;
mod resident;
mod silhouette_queries;
mod wgpu_driver;

pub use compiled_kernel::{CompiledKernel, GROUP, KernelPack};
pub use error::GpuError;
pub use foreign_kernels::DeviceArray;
pub use gpu::{Gpu, GpuOptions, Interface};
pub use layout::slang as arrays_slang;
pub use local_cone::SINGLE_ERROR;
pub use precision::Precision;
pub use ray_queries::DeviceRayTree;
pub use silhouette_queries::{DeviceSilhouetteTree, Gathered};
