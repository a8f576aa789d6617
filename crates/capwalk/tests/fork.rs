//! A process that was forked from one that has rendered computes the same bits, and never
//! hangs: PyTorch's data loaders fork.
#![cfg(unix)]
#![allow(unsafe_code, reason = "fork, wait and _exit have no safe form")]

use std::time::{Duration, Instant};

use capwalk::{
    Estimate, GradientOptions, Loader, ParameterGradient, Prepared, RenderOptions, Rgb, Unwatched,
};

/// Ends the child whatever happens: nothing of the test harness may run in it.
struct ExitAtEnd(i32);

impl Drop for ExitAtEnd {
    fn drop(&mut self) {
        // SAFETY: ends the process without running anything else of it.
        unsafe { libc::_exit(self.0) }
    }
}

/// An image, a gradient with respect to vertices, and a change of them.
fn answers(prepared: &mut Prepared) -> (Estimate, ParameterGradient) {
    let name = "lattice.positions";
    let vertices = prepared.values(name).expect("a mesh").numbers;
    prepared.update(name, &vertices).expect("the same");
    let image = prepared.render(&RenderOptions::new(2, 3), &Unwatched);
    let image = image.expect("it has samples").value;
    let mut adjoint = image.mean.clone();
    adjoint.pixels.fill(Rgb::splat(1.0));
    let options = GradientOptions::new(RenderOptions::new(2, 3));
    let gradients = prepared.backward(&adjoint, &[name], &options, &Unwatched);
    (image, gradients.expect("covered")[name].clone())
}

#[test]
fn a_forked_child_computes() {
    // So many vertices that whatever can be done in parallel is.
    let scene = Loader::new("lattice-shadow").size([16, 12]).load();
    let scene = scene.expect("built in").scene;
    let mut prepared = Prepared::new(scene).expect("a valid scene");
    // The parent's pool has started.
    let expected = answers(&mut prepared);
    // SAFETY: the child only computes, and ends by `_exit`.
    let child = unsafe { libc::fork() };
    assert!(child >= 0, "fork failed");
    if child == 0 {
        let mut exit = ExitAtEnd(2);
        let found = answers(&mut prepared);
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
    assert!(answers(&mut prepared) == expected);
}
