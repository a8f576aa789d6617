//! What is asked of a driver: launches, and why they fail.

use std::sync::{Mutex, MutexGuard};

/// Arrays that a kernel is given: its binding's number is its place in the list.
pub const ARRAYS: usize = 8;

/// Why a call failed.
#[derive(Debug)]
pub enum Fault {
    OutOfMemory,
    /// The device answers nothing any more.
    Lost(String),
    /// A launch did not end in time.
    Timeout,
    /// Anything else that the driver says.
    Refused(String),
}

/// What one launch does: `Launch` in the kernels as well.
#[derive(Clone, Copy, Debug)]
pub struct Launch {
    /// The first query, and the one after the last.
    pub first: u32,
    pub end: u32,
    /// Room for so many edges of each query.
    pub capacity: u32,
    /// How many primitives the tree has.
    pub primitives: u32,
}

impl Launch {
    pub fn words(self) -> [u32; 4] {
        [self.first, self.end, self.capacity, self.primitives]
    }

    pub fn queries(self) -> usize {
        (self.end - self.first) as usize
    }
}

/// What a mutex holds. Nothing is left half done under a lock, so what a panic left is as good
/// as any.
pub fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner())
}
