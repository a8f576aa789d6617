//! The adapter that the tests run on.

use std::io::Write;
use std::sync::{Arc, Mutex, MutexGuard, Once};

use capwalk_gpu::{Gpu, GpuError, GpuOptions, Interface, Precision};

/// One test at a time: drivers of software share the CPU's cores anyway.
static TURN: Mutex<()> = Mutex::new(());

/// Says once why the tests are skipped.
static NOTE: Once = Once::new();

/// The device opened with these options, for as long as nobody else uses one; `None`,
/// after a note, on a machine without an adapter.
pub fn open(options: &GpuOptions) -> Option<(Arc<Gpu>, MutexGuard<'static, ()>)> {
    let turn = TURN.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    match Gpu::new(options) {
        Ok(gpu) => Some((Arc::new(gpu), turn)),
        Err(GpuError::NoAdapter { reason }) => {
            skip(&reason);
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// Every interface that is there, in both precisions.
pub fn each(test: impl Fn(&Arc<Gpu>)) {
    let _turn = TURN.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let mut missing = Vec::new();
    for interface in [Interface::Wgpu, Interface::Cuda] {
        for precision in [Precision::Double, Precision::Single] {
            let gpu = Gpu::new(&with(|options| {
                options.interface = Some(interface);
                options.precision = Some(precision);
            }));
            match gpu {
                Ok(gpu) => test(&Arc::new(gpu)),
                Err(GpuError::NoAdapter { reason }) => missing.push(reason),
                // A driver or a device that is too old.
                Err(GpuError::Unusable { reason, .. }) if interface == Interface::Cuda => {
                    missing.push(reason);
                }
                Err(GpuError::Unusable { adapter, reason }) if precision == Precision::Double => {
                    NOTE.call_once(|| {
                        note(&format!("no double precision on {adapter} ({reason})"))
                    });
                }
                Err(error) => panic!("{error}"),
            }
        }
    }
    if missing.len() == 4 {
        skip(&missing[0]);
    }
}

/// True if the device divides and takes roots as exactly as the CPU, and fuses nothing:
/// in double precision its answers are the same to the last bit.
pub fn is_exact(gpu: &Gpu) -> bool {
    gpu.is_software() || gpu.interface() == Interface::Cuda
}

/// Where tests are skipped for want of a device that can do them, a note says so once.
pub fn skip(reason: &str) {
    let is_required = std::env::var("CAPWALK_GPU_TESTS").is_ok_and(|value| value == "require");
    assert!(!is_required, "CAPWALK_GPU_TESTS=require, but {reason}");
    NOTE.call_once(|| note(reason));
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
