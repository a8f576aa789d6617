//! Devices by name, what comes from them, and why nothing does.

use capwalk_diff::{Device, Statistics};

use crate::method::Choice;

impl Choice for Device {
    const NAMES: &'static [(&'static str, Self)] =
        &[("auto", Self::Auto), ("cpu", Self::Cpu), ("gpu", Self::Gpu)];

    fn help(self) -> &'static str {
        match self {
            Self::Auto => "The GPU if there is one that supports the scene, else the CPU",
            Self::Cpu => "The CPU",
            Self::Gpu => {
                "The GPU, or software Vulkan; refused if it does not support the scene (a build with \
                 --features gpu)"
            }
        }
    }
}

/// What a GPU computed, or that the CPU has to, and why.
pub enum Found<T> {
    #[cfg_attr(
        not(feature = "gpu"),
        allow(dead_code, reason = "there is no GPU to find it on")
    )]
    OnGpu(T),
    OnCpu {
        remark: Option<String>,
    },
}

impl<T> Found<T> {
    /// What the GPU computed, or else the CPU; its statistics say why.
    pub fn or_on_cpu<E>(
        self,
        compute: impl FnOnce() -> Result<T, E>,
        statistics: fn(&mut T) -> &mut Statistics,
    ) -> Result<T, E> {
        match self {
            Self::OnGpu(result) => Ok(result),
            Self::OnCpu { remark } => {
                let mut result = compute()?;
                statistics(&mut result).device.remark = remark;
                Ok(result)
            }
        }
    }
}

/// Why there is nothing from a GPU.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DeviceFailure {
    /// The feature `gpu` was not built.
    #[error(
        "this program was built without the GPU: build it with `cargo build --release -p \
         capwalk-cli --features gpu`, or use the CPU (--device cpu)"
    )]
    NotBuilt,
    /// The scene needs what the GPU does not have, or the GPU fails.
    #[cfg(feature = "gpu")]
    #[error(transparent)]
    Failed(#[from] capwalk_gpu_render::DeviceError),
}

impl DeviceFailure {
    /// What it is that the GPU does not have, such as `the material of shape "ball" is a dielectric`;
    /// `None` if the scene could be rendered there.
    pub fn unsupported(&self) -> Option<&str> {
        match self {
            #[cfg(feature = "gpu")]
            Self::Failed(capwalk_gpu_render::DeviceError::Unsupported(missing)) => {
                Some(&missing.what)
            }
            _ => None,
        }
    }
}
