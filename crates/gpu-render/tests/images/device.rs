//! The devices that the tests run on.

use std::io::Write;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock};

use capwalk_gpu::{Gpu, GpuError, GpuOptions, Precision};

/// One test at a time: drivers of software share the processor's cores anyway.
static TURN: Mutex<()> = Mutex::new(());

/// The device in a precision, for as long as nobody else uses one; `None`, after a note, where
/// there is none, or none that has it. Opened once: kernels take long to compile.
pub fn open(precision: Precision) -> Option<(&'static Arc<Gpu>, MutexGuard<'static, ()>)> {
    static DEVICES: [OnceLock<Option<Arc<Gpu>>>; 2] = [const { OnceLock::new() }; 2];
    let turn = TURN.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
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
    device.as_ref().map(|gpu| (gpu, turn))
}

/// Says past the capture of output why tests are skipped.
fn skip(reason: &str) {
    let is_required = std::env::var("CAPWALK_GPU_TESTS").is_ok_and(|value| value == "require");
    assert!(!is_required, "CAPWALK_GPU_TESTS=require, but {reason}");
    let line = format!("\nnote: tests of images on the GPU are SKIPPED: {reason}\n");
    let _ = std::io::stderr().write_all(line.as_bytes());
}
