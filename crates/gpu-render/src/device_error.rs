//! Why there is no image.

use capwalk_diff::Refusal;
use capwalk_gpu::GpuError;

use crate::unsupported::Unsupported;

/// Why there is no image from a device.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DeviceError {
    /// The scene or the options have something that the device's renderer has not.
    #[error(transparent)]
    Unsupported(#[from] Unsupported),
    /// The derivative would not be right, on no device.
    #[error(transparent)]
    Refused(#[from] Refusal),
    /// The device fails.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}
