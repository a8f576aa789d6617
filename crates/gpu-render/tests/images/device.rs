//! The devices that the tests run on.

use std::io::Write;
use std::sync::{Arc, OnceLock};

use capwalk_gpu::{Gpu, GpuError, GpuOptions, Precision};

/// The device in a precision; `None`, after a note, where there is none, or none that has it.
/// Opened once: kernels take long to compile.
pub fn open(precision: Precision) -> Option<&'static Arc<Gpu>> {
    static DEVICES: [OnceLock<Option<Arc<Gpu>>>; 2] = [const { OnceLock::new() }; 2];
    let device = DEVICES[precision as usize].get_or_init(|| {
        let mut options = GpuOptions::default();
        options.precision = Some(precision);
        match Gpu::new(&options) {
            Ok(gpu) => Some(Arc::new(gpu)),
            Err(GpuError::NoAdapter { reason } | GpuError::Unusable { reason, .. }) => {
                skip(&reason);
                None
            }
            Err(error) => panic!("{error}"),
        }
    });
    device.as_ref()
}

/// Says past the capture of output why tests are skipped.
fn skip(reason: &str) {
    let is_required = std::env::var("CAPWALK_GPU_TESTS").is_ok_and(|value| value == "require");
    assert!(!is_required, "CAPWALK_GPU_TESTS=require, but {reason}");
    let line = format!("\nnote: tests of images on the GPU are SKIPPED: {reason}\n");
    let _ = std::io::stderr().write_all(line.as_bytes());
}
