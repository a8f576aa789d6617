//! Seeds that are independent of others, for Python.

use capwalk::Seed;
use pyo3::prelude::*;

/// [`Seed::independent`].
#[pyfunction]
pub fn independent_seed(seed: u64) -> u64 {
    Seed(seed).independent().0
}

/// [`Seed::of_view`].
#[pyfunction]
pub fn view_seed(seed: u64, view: u64) -> u64 {
    Seed(seed).of_view(view).0
}
