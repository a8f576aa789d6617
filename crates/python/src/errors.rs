//! Errors as the exceptions of `capwalk.errors`, which are written in Python.

use capwalk::optimize::FolderError;
use capwalk::scene_io::mesh::NamedMeshError;
use capwalk::{DeviceFailure, Error, LoadError, Refusal};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// The exception for an error of the library.
pub fn exception(py: Python<'_>, error: impl Into<Error>) -> PyErr {
    let error = error.into();
    let text = message(&error);
    match &error {
        Error::Load(error) => load_error(py, error),
        Error::UnknownScene { .. }
        | Error::NothingToDefine { .. }
        | Error::NoSuchSensor { .. }
        | Error::InvalidScene { .. }
        | Error::Scene(_) => instance(py, "LoadError", (text, None::<()>, None::<()>, None::<()>)),
        Error::Parameter(_) | Error::OfAnotherSensor { .. } => {
            instance(py, "ParameterError", (text,))
        }
        // Arguments, not the method, are wrong.
        Error::Refused(Refusal::AdjointSize { .. } | Refusal::AdjointNotFinite { .. }) => {
            instance(py, "ArgumentError", (text,))
        }
        Error::Refused(refusal) => {
            let parts = (text, refusal.reason(), refusal.instead());
            instance(py, "Refused", parts)
        }
        Error::Folder(FolderError::Taken { .. }) => {
            let instead = "go on with it (resume=True), or give another output";
            instance(py, "ArgumentError", (format!("{text}; {instead}"),))
        }
        Error::Device(failure) => device_error(py, failure, text),
        Error::Image(_) | Error::UnusableImage { .. } => instance(py, "ImageError", (text,)),
        _ => instance(py, "ArgumentError", (text,)),
    }
}

/// The exception for a file that cannot be read or written as a mesh.
pub fn mesh(py: Python<'_>, error: &NamedMeshError) -> PyErr {
    instance(py, "MeshError", (error.to_string(),))
}

/// The exception for an argument of the wrong shape or out of its range.
pub fn argument(py: Python<'_>, text: impl Into<String>) -> PyErr {
    instance(py, "ArgumentError", (text.into(),))
}

/// The exception for work that ended in a panic.
pub fn internal(py: Python<'_>, what: &str) -> PyErr {
    let text = format!("internal error, please report it with the scene: {what}");
    instance(py, "Error", (text,))
}

/// The exception for a scene that something else is being done with.
pub fn busy(py: Python<'_>, text: &str) -> PyErr {
    instance(py, "BusyError", (text,))
}

/// A scene that the GPU cannot render is a wrong argument; all else is a fault of the device.
fn device_error(py: Python<'_>, failure: &DeviceFailure, text: String) -> PyErr {
    if let Some(what) = failure.unsupported() {
        let instead = "use device=\"cpu\", or \"auto\", which takes it where it has to";
        return argument(py, format!("{what}: not on the GPU yet; {instead}"));
    }
    let text = match failure {
        DeviceFailure::NotBuilt => "this build of capwalk has no GPU support; build it with the \
                                    feature `gpu`, as `pip install .` does, or use device=\"cpu\""
            .into(),
        _ => text,
    };
    instance(py, "DeviceError", (text,))
}

fn load_error(py: Python<'_>, error: &LoadError) -> PyErr {
    let file = error.file().map(|file| file.display().to_string());
    let parts = (error.to_string(), file, error.line(), error.column());
    instance(py, "LoadError", parts)
}

/// An exception of `capwalk.errors`, made from these arguments.
fn instance<'py>(
    py: Python<'py>,
    class: &str,
    arguments: impl IntoPyObject<'py, Target = PyTuple, Output = Bound<'py, PyTuple>, Error = PyErr>,
) -> PyErr {
    let made = arguments.into_pyobject(py).and_then(|arguments| {
        let module = py.import("capwalk.errors")?;
        module.getattr(class)?.call1(arguments)
    });
    made.map_or_else(|error| error, PyErr::from_value)
}

/// What an error says, and what the errors behind it say.
fn message(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut next = error.source();
    while let Some(error) = next {
        text = format!("{text}: {error}");
        next = error.source();
    }
    text
}
