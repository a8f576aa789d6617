//! What the queries need of a device, whichever interface it is reached through: memory,
//! and launches of kernels over it.

use std::time::Duration;

use crate::compiled_kernel::CompiledKernel;
use crate::cuda_driver::{CudaDriver, CudaMemory};
use crate::launch::{ARRAYS, Fault, Launch};
use crate::precision::Precision;
use crate::wgpu_driver::WgpuDriver;

/// A piece of the device's memory.
#[derive(Debug)]
pub enum Memory {
    Wgpu(wgpu::Buffer),
    Cuda(CudaMemory),
}

/// An open device.
#[derive(Debug)]
pub enum Driver {
    Wgpu(Box<WgpuDriver>),
    Cuda(Box<CudaDriver>),
}

impl Driver {
    pub fn name(&self) -> &str {
        match self {
            Self::Wgpu(driver) => driver.name(),
            Self::Cuda(driver) => driver.name(),
        }
    }

    /// The driver and its version, as it calls itself.
    pub fn version(&self) -> String {
        match self {
            Self::Wgpu(driver) => driver.version(),
            Self::Cuda(driver) => driver.version(),
        }
    }

    pub fn is_software(&self) -> bool {
        match self {
            Self::Wgpu(driver) => driver.is_software(),
            Self::Cuda(_) => false,
        }
    }

    /// The largest piece of memory, bytes.
    pub fn largest(&self) -> u64 {
        match self {
            Self::Wgpu(driver) => driver.largest(),
            Self::Cuda(driver) => driver.largest(),
        }
    }

    /// Gives the device up.
    pub fn destroy(&self) {
        match self {
            Self::Wgpu(driver) => driver.destroy(),
            Self::Cuda(driver) => driver.destroy(),
        }
    }

    /// An error if the device is lost.
    pub fn check(&self) -> Result<(), Fault> {
        match self {
            Self::Wgpu(driver) => driver.check(),
            Self::Cuda(driver) => driver.check(),
        }
    }

    /// A new piece of memory with undefined content.
    pub fn allocate(&self, bytes: u64) -> Result<Memory, Fault> {
        match self {
            Self::Wgpu(driver) => driver.allocate(bytes).map(Memory::Wgpu),
            Self::Cuda(driver) => driver.allocate(bytes).map(Memory::Cuda),
        }
    }

    /// Fills the first bytes of a piece.
    pub fn upload(&self, to: &Memory, bytes: &[u8], timeout: Duration) -> Result<(), Fault> {
        match self {
            Self::Wgpu(driver) => driver.upload(of_wgpu(to), bytes),
            Self::Cuda(driver) => driver.upload(of_cuda(to), bytes, timeout),
        }
    }

    /// Runs a kernel, waits until it is done, and tells how long that took.
    pub fn launch(
        &self,
        kernel: &CompiledKernel,
        precision: Precision,
        arrays: [&Memory; ARRAYS],
        launch: Launch,
        timeout: Duration,
    ) -> Result<Duration, Fault> {
        match self {
            Self::Wgpu(driver) => {
                driver.launch(kernel, precision, arrays.map(of_wgpu), launch, timeout)
            }
            Self::Cuda(driver) => {
                driver.launch(kernel, precision, arrays.map(of_cuda), launch, timeout)
            }
        }
    }

    /// Reads the first bytes of a piece.
    pub fn download(&self, from: &Memory, to: &mut [u8], timeout: Duration) -> Result<(), Fault> {
        match self {
            Self::Wgpu(driver) => driver.download(of_wgpu(from), to, timeout),
            Self::Cuda(driver) => driver.download(of_cuda(from), to, timeout),
        }
    }
}

/// Memory stays with the device that it was taken from: trees and batches hold both.
fn of_wgpu(memory: &Memory) -> &wgpu::Buffer {
    match memory {
        Memory::Wgpu(buffer) => buffer,
        Memory::Cuda(_) => unreachable!("memory of another device"),
    }
}

fn of_cuda(memory: &Memory) -> &CudaMemory {
    match memory {
        Memory::Cuda(memory) => memory,
        Memory::Wgpu(_) => unreachable!("memory of another device"),
    }
}
