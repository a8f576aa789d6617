//! AOVs, by name.

use capwalk::scene::Aov;
use pyo3::prelude::*;

use crate::errors;

/// The AOV of this name.
pub fn named(py: Python<'_>, name: &str) -> PyResult<Aov> {
    let found = Aov::ALL.into_iter().find(|aov| aov.name() == name);
    found.ok_or_else(|| {
        let names = Aov::ALL.map(Aov::name).join(", ");
        errors::argument(py, format!("there is no aov \"{name}\"; there are {names}"))
    })
}
