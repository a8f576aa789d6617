//! Arrays of numbers in a device's memory.

use capwalk_gpu::{DeviceArray, Gpu, GpuError, Precision};

/// Uploads bytes; an error if a buffer cannot be so large.
pub fn upload(gpu: &Gpu, bytes: &[u8]) -> Result<DeviceArray, GpuError> {
    let (bytes_needed, limit) = (bytes.len() as u64, gpu.largest_buffer());
    if bytes_needed > limit {
        return Err(GpuError::TreeTooLarge {
            adapter: gpu.name().to_owned(),
            bytes: bytes_needed,
            limit,
        });
    }
    let array = gpu.array(bytes_needed)?;
    gpu.write(&array, bytes)?;
    Ok(array)
}

/// Uploads words.
pub fn upload_words(gpu: &Gpu, words: &[u32]) -> Result<DeviceArray, GpuError> {
    upload(gpu, bytemuck::cast_slice(words))
}

/// Uploads numbers in the precision of exact tests.
pub fn upload_numbers(gpu: &Gpu, numbers: &[f64]) -> Result<DeviceArray, GpuError> {
    match gpu.precision() {
        Precision::Double => upload(gpu, bytemuck::cast_slice(numbers)),
        Precision::Single => {
            let single: Vec<f32> = numbers.iter().map(|&x| x as f32).collect();
            upload(gpu, bytemuck::cast_slice(&single))
        }
    }
}
