//! Kernels of other crates on the device: memory for them, and launches.

use crate::compiled_kernel::CompiledKernel;
use crate::driver::Memory;
use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::launch::{ARRAYS, Launch};

/// A piece of a device's memory, to be used with that device alone.
#[derive(Debug)]
pub struct DeviceArray {
    memory: Memory,
    bytes: u64,
}

/// Kernels read and copies move so many bytes at a time.
const UNIT: u64 = 16;

impl Gpu {
    /// Memory for so many bytes, with undefined content.
    pub fn array(&self, bytes: u64) -> Result<DeviceArray, GpuError> {
        // An array of no bytes cannot be given to a kernel.
        let bytes = bytes.next_multiple_of(UNIT).max(UNIT);
        let memory = self.allocate(bytes)?;
        Ok(DeviceArray { memory, bytes })
    }

    /// Writes the first bytes of an array, a multiple of four.
    ///
    /// # Panics
    ///
    /// If the array is shorter, or of another device.
    pub fn write(&self, to: &DeviceArray, bytes: &[u8]) -> Result<(), GpuError> {
        assert!(bytes.len() as u64 <= to.bytes, "more than an array has");
        match bytes.is_empty() {
            true => Ok(()),
            false => self.upload(&to.memory, bytes),
        }
    }

    /// Reads the first bytes of an array, a multiple of four.
    ///
    /// # Panics
    ///
    /// If the array is shorter, or of another device.
    pub fn read(&self, from: &DeviceArray, bytes: &mut [u8]) -> Result<(), GpuError> {
        assert!(bytes.len() as u64 <= from.bytes, "more than an array has");
        match bytes.is_empty() {
            true => Ok(()),
            false => self.download(&from.memory, bytes),
        }
    }

    /// Runs a kernel for the numbers from 0 to `count`, cut into launches that each take about as
    /// long as the options say, and waits for them. The kernel has eight arrays at the bindings of
    /// their places here, of which it may write the last two and only read the others, and at the
    /// next binding four words: the first number of a launch, the one after its last, and the two
    /// that are given.
    ///
    /// # Safety
    ///
    /// The kernel must stay within the arrays for all these numbers: NVIDIA's driver checks no
    /// bounds.
    #[allow(unsafe_code)] // Only the caller knows what a kernel reads and writes.
    pub unsafe fn launch(
        &self,
        kernel: &CompiledKernel,
        arrays: [&DeviceArray; ARRAYS],
        count: u32,
        [capacity, primitives]: [u32; 2],
    ) -> Result<(), GpuError> {
        let whole = Launch {
            first: 0,
            end: count,
            capacity,
            primitives,
        };
        self.run(kernel, arrays.map(|array| &array.memory), whole)
    }
}
