//! A process that was forked from one that has rendered computes the same bits, and never
//! hangs: PyTorch's data loaders fork.
#![cfg(unix)]
#![allow(unsafe_code, reason = "fork, wait and _exit have no safe form")]

use std::time::{Duration, Instant};

use capwalk::{Loader, Prepared, RenderOptions, Unwatched};

/// Ends the child whatever happens: nothing of the test harness may run in it.
struct ExitAtEnd(i32);

impl Drop for ExitAtEnd {
    fn drop(&mut self) {
        // SAFETY: ends the process without running anything else of it.
        unsafe { libc::_exit(self.0) }
    }
}

#[test]
fn a_forked_child_computes() {
    let scene = Loader::new("leaf").size([16, 12]).load().expect("built in");
    let prepared = Prepared::new(scene.scene).expect("a valid scene");
    let options = RenderOptions::new(8, 3);
    // The parent's pool has started.
    let expected = prepared.render(&options, &Unwatched).value;
    // SAFETY: the child only computes, and ends by `_exit`.
    let child = unsafe { libc::fork() };
    assert!(child >= 0, "fork failed");
    if child == 0 {
        let mut exit = ExitAtEnd(2);
        let found = prepared.render(&options, &Unwatched).value;
        exit.0 = i32::from(found != expected);
        return;
    }
    let start = Instant::now();
    let mut status = 0;
    // SAFETY: `status` lives, and the child is this process's.
    while unsafe { libc::waitpid(child, &mut status, libc::WNOHANG) } == 0 {
        if start.elapsed() > Duration::from_secs(60) {
            // SAFETY: the child is this process's.
            unsafe { libc::kill(child, libc::SIGKILL) };
            panic!("the child hangs");
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    assert!(libc::WIFEXITED(status), "the child was killed");
    assert_eq!(libc::WEXITSTATUS(status), 0, "1: other bits, 2: a panic");
    // The parent goes on.
    assert!(prepared.render(&options, &Unwatched).value == expected);
}
