//! The adapter that the tests run on.

use std::io::Write;
use std::sync::{Arc, Mutex, MutexGuard, Once};

use capwalk_gpu::{Gpu, GpuError, GpuOptions, Precision};

/// One test at a time: drivers of software share the processor's cores anyway.
static TURN: Mutex<()> = Mutex::new(());

/// Says once why the tests are skipped.
static NOTE: Once = Once::new();

/// The device opened with these options, for as long as nobody else uses one; `None`,
/// after a note, on a machine without an adapter, and where it has not this precision.
pub fn open(options: &GpuOptions) -> Option<(Arc<Gpu>, MutexGuard<'static, ()>)> {
    let turn = TURN.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let is_required = std::env::var("CAPWALK_GPU_TESTS").is_ok_and(|value| value == "require");
    match Gpu::new(options) {
        Ok(gpu) => return Some((Arc::new(gpu), turn)),
        Err(GpuError::NoAdapter { reason }) => {
            assert!(!is_required, "CAPWALK_GPU_TESTS=require, but {reason}");
            NOTE.call_once(|| note(&format!("no adapter ({reason})")));
        }
        Err(GpuError::Unusable { adapter, reason })
            if options.precision == Some(Precision::Double) =>
        {
            NOTE.call_once(|| note(&format!("no double precision on {adapter} ({reason})")));
        }
        Err(error) => panic!("{error}"),
    }
    None
}

/// Both precisions that the tests are done in.
pub fn each(test: impl Fn(&Arc<Gpu>)) {
    for precision in [Precision::Double, Precision::Single] {
        if let Some((gpu, _turn)) = open(&with(|options| options.precision = Some(precision))) {
            test(&gpu);
        }
    }
}

/// Options changed.
pub fn with(change: impl FnOnce(&mut GpuOptions)) -> GpuOptions {
    let mut options = GpuOptions::default();
    change(&mut options);
    options
}

/// Past the capture of output, which hides what tests that pass print.
fn note(reason: &str) {
    let line = format!("\nnote: tests on the GPU are SKIPPED: {reason}\n");
    let _ = std::io::stderr().write_all(line.as_bytes());
}
