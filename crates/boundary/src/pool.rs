//! The threads that work is done on.
//!
//! Inside a rayon pool of the caller's, work stays there. Elsewhere it goes to one pool
//! of the process, started by the first call and kept. After `fork`, a child process has
//! none of its parent's threads: it starts a pool of its own and does not wait for theirs.

use std::sync::Arc;

use arc_swap::ArcSwapOption;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// A pool, and the process whose threads are in it.
struct ProcessPool {
    process: u32,
    pool: ThreadPool,
}

/// The pool of this process, or that of the one it was forked from. No lock: one that
/// another thread held during the fork would stay locked in the child.
static POOL: ArcSwapOption<ProcessPool> = ArcSwapOption::const_empty();

/// Does work that may use several threads. Results do not depend on how many there are.
pub fn install<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    match rayon::current_thread_index() {
        Some(_) => work(),
        None => pool_of_this_process().pool.install(work),
    }
}

fn pool_of_this_process() -> Arc<ProcessPool> {
    let process = std::process::id();
    let is_own = |pool: &Arc<ProcessPool>| pool.process == process;
    let found = POOL.load_full();
    if let Some(own) = found.as_ref().filter(|pool| is_own(pool)) {
        return Arc::clone(own);
    }
    let pool = ThreadPoolBuilder::new().build();
    let own = Arc::new(ProcessPool {
        process,
        pool: pool.expect("the system starts threads"),
    });
    let before = POOL.compare_and_swap(&found, Some(Arc::clone(&own)));
    match before.as_ref().filter(|pool| is_own(pool)) {
        // Another thread was faster.
        Some(other) => Arc::clone(other),
        None => {
            // The parent's pool is never ended: its threads would be waited for.
            std::mem::forget(found);
            own
        }
    }
}

/// Does work on so many threads of its own instead of the process's.
pub fn with_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    pool.expect("the system starts threads").install(work)
}
