//! The extension module `capwalk._capwalk` of the Python package (PyO3): scenes, and renderings and
//! derivatives over NumPy arrays, on top of the crate `capwalk`. Users see the package around it,
//! `python/capwalk`, which checks arguments and has the documentation.

mod aov;
mod arrays;
mod direction;
mod errors;
mod image;
mod jobs;
mod mesh;
mod parts;
mod results;
mod samples;
mod scene;
mod seed;
mod steps;
mod watched;
mod work;

/// The module `capwalk._capwalk`.
#[pyo3::pymodule]
mod _capwalk {
    #[pymodule_export]
    use crate::image::{limit, png, preview, read_image, write_images};
    #[pymodule_export]
    const LEAST_WIDTH: usize = capwalk::scene_io::image::LEAST_WIDTH;
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    use crate::jobs::optimize;
    #[pymodule_export]
    use crate::mesh::{read_mesh, write_mesh};
    #[pymodule_export]
    use crate::parts::{choose, merge, part};
    #[pymodule_export]
    use crate::samples::{NoDescent, SampleCounts};
    #[pymodule_export]
    use crate::scene::{Scene, bsdf_plugins, load_file, load_lines, load_string};
    #[pymodule_export]
    use crate::seed::{independent_seed, view_seed};
    #[pymodule_export]
    use crate::steps::{Smooth, adam};
    #[pymodule_export]
    use crate::work::{backward, check, check_options, gradient, render};
}
