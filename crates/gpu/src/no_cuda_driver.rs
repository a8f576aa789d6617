//! `cuda_driver.rs` where NVIDIA makes no drivers: there is no device, so nothing is ever
//! asked of one.

use std::time::Duration;

use crate::compiled_kernel::CompiledKernel;
use crate::error::GpuError;
use crate::launch::{ARRAYS, Fault, Launch};
use crate::precision::Precision;

/// None there is.
#[derive(Debug)]
pub enum CudaDriver {}

/// None there is.
#[derive(Debug)]
pub enum CudaMemory {}

impl CudaDriver {
    pub fn open(_: Option<&str>) -> Result<Self, GpuError> {
        Err(GpuError::NoAdapter {
            reason: "NVIDIA makes no drivers for this system".to_owned(),
        })
    }

    pub fn name(&self) -> &str {
        match *self {}
    }

    pub fn version(&self) -> String {
        match *self {}
    }

    pub fn largest(&self) -> u64 {
        match *self {}
    }

    pub fn destroy(&self) {
        match *self {}
    }

    pub fn check(&self) -> Result<(), Fault> {
        match *self {}
    }

    pub fn allocate(&self, _: u64) -> Result<CudaMemory, Fault> {
        match *self {}
    }

    pub fn upload(&self, _: &CudaMemory, _: &[u8], _: Duration) -> Result<(), Fault> {
        match *self {}
    }

    pub fn launch(
        &self,
        _: &CompiledKernel,
        _: Precision,
        _: [&CudaMemory; ARRAYS],
        _: Launch,
        _: Duration,
    ) -> Result<Duration, Fault> {
        match *self {}
    }

    pub fn download(&self, _: &CudaMemory, _: &mut [u8], _: Duration) -> Result<(), Fault> {
        match *self {}
    }
}
