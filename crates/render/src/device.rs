//! Where images and derivatives are computed.

/// Where an image or a derivative is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Device {
    /// On the CPU.
    #[default]
    Cpu,
    /// On a GPU if there is one with double precision that has all that the scene needs, else on
    /// the CPU. Software Vulkan is none.
    Auto,
    /// On a GPU, or on software Vulkan; an error if there is neither, if the scene needs what it does
    /// not have, or for what has no GPU yet: work in parts, checks, the choice of a method.
    Gpu,
}

/// Where an image or a derivative was computed: by default on the CPU.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct UsedDevice {
    /// The name of the GPU; `None` for the CPU.
    pub gpu: Option<String>,
    /// Why it was the CPU, where a GPU was there and could have been meant.
    pub remark: Option<String>,
}

impl UsedDevice {
    /// The GPU of this name.
    pub fn gpu(name: &str) -> Self {
        Self {
            gpu: Some(name.to_owned()),
            remark: None,
        }
    }

    /// The name of the GPU, or `cpu`.
    pub fn name(&self) -> &str {
        self.gpu.as_deref().unwrap_or("cpu")
    }
}
