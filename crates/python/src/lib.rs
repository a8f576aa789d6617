//! What of the Python package `capwalk` is Rust: scenes, and work on them over NumPy
//! arrays. Users see the package around it, `python/capwalk`, which has the words.

mod arrays;
mod errors;
mod image;
mod scene;
mod watched;
mod work;

/// The module `capwalk._capwalk`.
#[pyo3::pymodule]
mod _capwalk {
    #[pymodule_export]
    use crate::image::{png, write_images};
    #[pymodule_export]
    use crate::scene::{Scene, load_file, load_string};
    #[pymodule_export]
    use crate::work::{backward, check, gradient, render};
}
