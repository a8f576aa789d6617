//! The GPU of the process: opened once, since that takes tenths of a second and the kernels of a
//! device that is opened anew are compiled anew.

use std::mem::forget;
use std::sync::Arc;

use arc_swap::ArcSwapOption;
use capwalk_gpu::{Gpu, GpuError, GpuOptions};

/// An open device, and the process that opened it.
struct OpenGpu {
    process: u32,
    gpu: Arc<Gpu>,
}

impl OpenGpu {
    /// True if it answers this process: drivers do not know what was forked from theirs.
    fn is_usable(&self, process: u32) -> bool {
        self.process == process && self.gpu.check().is_ok()
    }
}

/// The device of this process, or of the one it was forked from. No lock: one that another thread
/// held during the fork would stay locked in the child.
static OPEN: ArcSwapOption<OpenGpu> = ArcSwapOption::const_empty();

/// The device that all threads of this process share: the fastest kind there is, opened by the
/// first call, and again by the first after it was lost or [given up](give_up). Errors are not
/// kept: the next call looks again.
pub fn shared_gpu() -> Result<Arc<Gpu>, GpuError> {
    let process = std::process::id();
    let found = OPEN.load_full();
    if let Some(usable) = found.as_ref().filter(|open| open.is_usable(process)) {
        return Ok(Arc::clone(&usable.gpu));
    }
    let gpu = Arc::new(Gpu::new(&GpuOptions::default())?);
    let own = Arc::new(OpenGpu { process, gpu });
    let before = OPEN.compare_and_swap(&found, Some(Arc::clone(&own)));
    if let Some(other) = before.as_ref().filter(|open| open.is_usable(process)) {
        // Another thread was faster.
        return Ok(Arc::clone(&other.gpu));
    }
    if found.as_ref().is_some_and(|open| open.process != process) {
        // The parent's is never closed: its driver's threads would be waited for.
        forget(found);
    }
    Ok(Arc::clone(&own.gpu))
}

/// Has the next image open the device anew if `error` may leave it unable to go on: it is lost, or
/// still at work after a time-out, or refuses what it should not.
pub fn give_up(gpu: &Arc<Gpu>, error: &GpuError) {
    match error {
        GpuError::DeviceLost { .. } | GpuError::Refused { .. } => {}
        // Never closed: that would wait for the work.
        GpuError::Timeout { .. } => forget(Arc::clone(gpu)),
        _ => return,
    }
    let found = OPEN.load_full();
    if found
        .as_ref()
        .is_some_and(|open| Arc::ptr_eq(&open.gpu, gpu))
    {
        OPEN.compare_and_swap(&found, None);
    }
}

#[cfg(test)]
pub mod tests {
    use std::sync::{Mutex, MutexGuard, PoisonError};
    use std::time::Duration;

    use super::*;

    /// Tests share the device of the process: one at a time.
    static ALONE: Mutex<()> = Mutex::new(());

    /// The device, for one test at a time; `None`, where it is allowed, without any adapter.
    pub fn device_alone() -> Option<(MutexGuard<'static, ()>, Arc<Gpu>)> {
        let alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        match shared_gpu() {
            Ok(gpu) => Some((alone, gpu)),
            Err(error @ GpuError::NoAdapter { .. }) => {
                let required = std::env::var("CAPWALK_GPU_TESTS");
                assert!(required != Ok("require".into()), "{error}");
                println!("skipped: {error}");
                None
            }
            Err(error) => panic!("{error}"),
        }
    }

    #[test]
    fn a_device_is_shared_until_it_is_lost() {
        let Some((_alone, first)) = device_alone() else {
            return;
        };
        let others = [(); 3].map(|()| std::thread::spawn(|| shared_gpu().expect("it is open")));
        for other in others {
            assert!(Arc::ptr_eq(&first, &other.join().expect("no panic")));
        }
        first.destroy();
        let second = shared_gpu().expect("it is opened again");
        assert!(!Arc::ptr_eq(&first, &second));
        second.check().expect("it is there");
        assert!(Arc::ptr_eq(&second, &shared_gpu().expect("it is open")));
    }

    #[test]
    fn a_device_that_may_not_go_on_is_given_up() {
        let Some((_alone, first)) = device_alone() else {
            return;
        };
        let adapter = first.name().to_owned();
        let harmless = GpuError::OutOfMemory {
            adapter: adapter.clone(),
            bytes: 1,
        };
        give_up(&first, &harmless);
        assert!(Arc::ptr_eq(&first, &shared_gpu().expect("it is open")));
        let timeout = GpuError::Timeout {
            adapter,
            queries: 1,
            allowed: Duration::ZERO,
        };
        give_up(&first, &timeout);
        let second = shared_gpu().expect("it is opened again");
        assert!(!Arc::ptr_eq(&first, &second));
        // Of the one before, nobody cares any more.
        give_up(&first, &timeout);
        assert!(Arc::ptr_eq(&second, &shared_gpu().expect("it is open")));
    }
}
