//! Where images and derivatives are computed, and why not there.

use capwalk_diff::Chosen;

use crate::method::Choice;

/// Where an image or a derivative is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Device {
    /// On the CPU.
    #[default]
    Cpu,
    /// On a GPU if there is one with double precision that has all that the scene needs, else on
    /// the CPU. Software Vulkan is none.
    Auto,
    /// On a GPU, or on software Vulkan; an error if there is neither, or if the scene needs what it
    /// does not have.
    Gpu,
}

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

/// An image or a derivative, and where it was computed.
#[derive(Clone, Debug)]
pub struct OnDevice<T> {
    /// What was asked for.
    pub result: T,
    /// The name of the GPU; `None` for the CPU.
    pub adapter: Option<String>,
    /// Why it was the CPU, where a GPU was there and could have been meant.
    pub remark: Option<String>,
    /// The method of a derivative. A GPU has edges alone, and where nothing moves all methods are one.
    pub chosen: Option<Chosen>,
}

/// What a GPU computed, or that the CPU has to.
pub enum Found<T> {
    #[cfg_attr(
        not(feature = "gpu"),
        allow(dead_code, reason = "there is no GPU to find it on")
    )]
    There {
        result: T,
        adapter: String,
    },
    Cpu {
        remark: Option<String>,
    },
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
