//! Work in parts, for other processes and machines. Each has the same scene; the parts are
//! merged to the bits of the whole.

use capwalk::{
    Error, GradientImage, GradientOptions, Gradients, Image, Part, Partial, Prepared,
    RenderOptions, Rendering, Views,
};
use numpy::PyReadonlyArrayDyn;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;

use crate::direction::{Along, Motion};
use crate::results::{OfMethod, of_backward, of_gradient, of_method, of_render};
use crate::scene::Scene;
use crate::watched::detached;
use crate::work::{Options, run};
use crate::{arrays, errors};

/// What is asked for besides an image: the adjoint and the names of [`backward`], or the
/// direction of [`gradient`].
///
/// [`backward`]: crate::work::backward
/// [`gradient`]: crate::work::gradient
#[derive(FromPyObject)]
pub enum Asked<'py> {
    Backward(PyReadonlyArrayDyn<'py, f64>, Vec<String>),
    Gradient(Along<'py>),
}

/// The work without Python objects.
enum Task {
    Render(RenderOptions),
    Gradient(Motion, GradientOptions),
    Backward(Image, Vec<String>, GradientOptions),
}

/// What a task gives.
enum Whole {
    Render(Rendering),
    Gradient(Box<GradientImage>),
    Backward(Gradients),
}

impl Task {
    fn new(py: Python<'_>, asked: Option<Asked>, options: &Options) -> PyResult<Self> {
        Ok(match asked {
            None => Self::Render(options.sampling(py)?),
            Some(Asked::Gradient(along)) => Self::Gradient(along.into(), options.gradient(py)?),
            Some(Asked::Backward(adjoint, names)) => {
                let adjoint = arrays::to_image("the adjoint", &adjoint)?;
                Self::Backward(adjoint, names, options.gradient(py)?)
            }
        })
    }

    /// The names of what is differentiated with respect to.
    fn names(&self) -> Vec<&str> {
        match self {
            Self::Render(_) => Vec::new(),
            Self::Gradient(motion, _) => motion.names(),
            Self::Backward(_, names, _) => names.iter().map(String::as_str).collect(),
        }
    }

    /// What all parts give.
    fn whole(&self, prepared: &Prepared, parts: &[PyBackedBytes]) -> Result<Whole, Error> {
        Ok(match self {
            Self::Render(options) => {
                let work = prepared.render_work(options)?;
                Whole::Render(work.finish(merged(parts)?)?)
            }
            Self::Gradient(motion, options) => {
                let direction = motion.direction(prepared)?;
                let work = prepared.gradient_work(&direction, options)?;
                Whole::Gradient(Box::new(work.finish(merged(parts)?)?))
            }
            Self::Backward(adjoint, names, options) => {
                let work = prepared.backward_work(adjoint, names, options)?;
                Whole::Backward(work.finish(merged(parts)?)?)
            }
        })
    }
}

/// The method that is used for all parts, its name and bytes for `options.chosen`; `None` for
/// images. Refuses what the whole refuses.
#[pyfunction]
pub fn choose<'py>(
    py: Python<'py>,
    scene: &Scene,
    asked: Option<Asked<'py>>,
    options: Options<'py>,
) -> PyResult<Option<OfMethod<'py>>> {
    let task = Task::new(py, asked, &options)?;
    let chosen = run(py, scene, &options, &task.names(), |prepared, watch| {
        let chosen = match &task {
            Task::Render(_) => return Ok(None),
            Task::Gradient(motion, options) => {
                let direction = motion.direction(prepared)?;
                let work = prepared.gradient_work(&direction, options)?;
                work.chosen(watch)?
            }
            Task::Backward(adjoint, names, options) => {
                let work = prepared.backward_work(adjoint, names, options)?;
                work.chosen(watch)?
            }
        };
        Ok(Some(chosen.options))
    })?;
    chosen.map(|options| of_method(py, &options)).transpose()
}

/// The bytes of part `index` of `count`.
#[pyfunction]
pub fn part<'py>(
    py: Python<'py>,
    scene: &Scene,
    asked: Option<Asked<'py>>,
    options: Options<'py>,
    index: u32,
    count: u32,
) -> PyResult<Bound<'py, PyBytes>> {
    let task = Task::new(py, asked, &options)?;
    let bytes = run(py, scene, &options, &task.names(), |prepared, watch| {
        let part = |grid| Part::nth(grid, index, count);
        Ok(match &task {
            Task::Render(options) => {
                let work = prepared.render_work(options)?;
                work.part(&part(work.grid())?, watch)?.to_bytes()?
            }
            Task::Gradient(motion, options) => {
                let direction = motion.direction(prepared)?;
                let work = prepared.gradient_work(&direction, options)?;
                work.part(&part(work.grid())?, watch)?.to_bytes()?
            }
            Task::Backward(adjoint, names, options) => {
                let work = prepared.backward_work(adjoint, names, options)?;
                work.part(&part(work.grid())?, watch)?.to_bytes()?
            }
        })
    })?;
    Ok(PyBytes::new(py, &bytes))
}

/// What the whole gives, from the bytes of all parts.
#[pyfunction]
pub fn merge<'py>(
    py: Python<'py>,
    scene: &Scene,
    asked: Option<Asked<'py>>,
    options: Options<'py>,
    parts: Vec<PyBackedBytes>,
) -> PyResult<Bound<'py, PyAny>> {
    let task = Task::new(py, asked, &options)?;
    let view = options.view(py)?;
    let views = scene.read(py)?;
    let views: &Views = &views;
    let whole = detached(py, || task.whole(views.prepared(view)?, &parts))?;
    match whole.map_err(|error| errors::exception(py, error))? {
        Whole::Render(image) => Ok(of_render(py, &image)?.into_pyobject(py)?.into_any()),
        Whole::Gradient(image) => Ok(of_gradient(py, &image)?.into_pyobject(py)?.into_any()),
        Whole::Backward(found) => Ok(of_backward(py, &found)?.into_pyobject(py)?.into_any()),
    }
}

/// All parts as one.
fn merged<T>(parts: &[PyBackedBytes]) -> Result<Partial<T>, Error>
where
    T: capwalk::Accumulate + serde::Serialize + serde::de::DeserializeOwned,
{
    let parts: Result<Vec<_>, _> = parts.iter().map(|part| Partial::from_bytes(part)).collect();
    Ok(Partial::merge(parts?)?)
}
