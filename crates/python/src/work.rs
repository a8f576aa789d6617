//! Images and gradients of scenes.

use capwalk::scene::unpack;
use capwalk::{
    CheckOptions, Choice, Device, Error, GradientOptions, MethodChoice, MethodName, Prepared,
    RenderOptions, ViewId, Views, WalkChoice, Watch,
};
use numpy::PyReadonlyArrayDyn;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;

use crate::direction::{Along, Motion};
use crate::results::{
    OfBackward, OfCheck, OfGradient, OfRender, of_backward, of_check, of_gradient, of_render,
};
use crate::scene::Scene;
use crate::watched::{How, watched};
use crate::{aov, arrays, errors};

/// What is asked for besides the scene and the direction.
#[derive(FromPyObject)]
pub struct Options<'py> {
    #[pyo3(attribute)]
    spp: u32,
    #[pyo3(attribute)]
    seed: u64,
    #[pyo3(attribute)]
    threads: Option<usize>,
    #[pyo3(attribute)]
    progress: Option<Bound<'py, PyAny>>,
    #[pyo3(attribute)]
    sensor: usize,
    #[pyo3(attribute)]
    aov: Option<String>,
    #[pyo3(attribute)]
    device: String,
    #[pyo3(attribute)]
    method: String,
    #[pyo3(attribute)]
    steps: Option<u32>,
    #[pyo3(attribute)]
    max_angle: Option<f64>,
    #[pyo3(attribute)]
    antithetic: Option<bool>,
    /// What a pilot has chosen, instead of the last four, see [`crate::results::of_method`].
    #[pyo3(attribute)]
    chosen: Option<PyBackedBytes>,
}

impl<'py> Options<'py> {
    pub fn sampling(&self, py: Python<'_>) -> PyResult<RenderOptions> {
        Ok(RenderOptions {
            device: self.device(py)?,
            ..RenderOptions::new(self.spp, self.seed)
        })
    }

    pub fn view(&self, py: Python<'_>) -> PyResult<ViewId> {
        let aov = match &self.aov {
            None => None,
            Some(name) => Some(aov::named(py, name)?),
        };
        Ok(ViewId {
            sensor: self.sensor,
            aov,
        })
    }

    pub fn gradient(&self, py: Python<'_>) -> PyResult<GradientOptions> {
        let sampled: GradientOptions = self.sampling(py)?.into();
        if let Some(chosen) = &self.chosen {
            let (method, walk) =
                unpack(chosen).map_err(|error| errors::exception(py, Error::from(error)))?;
            return Ok(GradientOptions {
                method,
                walk,
                ..sampled
            });
        }
        let Some(method) = MethodName::named(&self.method) else {
            let names: Vec<_> = MethodName::NAMES.iter().map(|(name, _)| *name).collect();
            let (method, names) = (&self.method, names.join(", "));
            let text = format!("there is no method \"{method}\"; there are {names}");
            return Err(errors::argument(py, text));
        };
        let walk = WalkChoice {
            steps: self.steps,
            max_angle: self.max_angle,
            antithetic: self.antithetic,
            ..WalkChoice::default()
        };
        let options = MethodChoice { method, walk }.apply(sampled);
        options.map_err(|error| errors::exception(py, error))
    }

    fn device(&self, py: Python<'_>) -> PyResult<Device> {
        Device::named(&self.device).ok_or_else(|| {
            let names: Vec<_> = Device::NAMES.iter().map(|(name, _)| *name).collect();
            let (device, names) = (&self.device, names.join(", "));
            let text = format!("there is no device \"{device}\"; there are {names}");
            errors::argument(py, text)
        })
    }

    fn how(&self) -> How<'py> {
        How {
            threads: self.threads,
            progress: self.progress.clone(),
        }
    }
}

/// Work on a scene, followed by Python; with respect to what has these names.
pub fn run<T: Send>(
    py: Python<'_>,
    scene: &Scene,
    options: &Options<'_>,
    names: &[&str],
    work: impl FnOnce(&Prepared, &dyn Watch) -> Result<T, Error> + Send,
) -> PyResult<T> {
    let view = options.view(py)?;
    let views = scene.read(py)?;
    let views: &Views = &views;
    let result = watched(py, &options.how(), |watch| {
        views.check_names(view, names)?;
        let result = work(views.prepared_watched(view, watch)?, watch);
        result.map_err(|error| views.explain(view, error))
    })?;
    result.map_err(|error| errors::exception(py, error))
}

/// An error if the options name a method, a view or a device that there is not, or do not belong
/// together.
#[pyfunction]
pub fn check_options(py: Python<'_>, options: Options<'_>) -> PyResult<()> {
    options.view(py)?;
    options.gradient(py)?;
    Ok(())
}

/// The image and what was done, and where.
#[pyfunction]
pub fn render<'py>(
    py: Python<'py>,
    scene: &Scene,
    options: Options<'py>,
) -> PyResult<OfRender<'py>> {
    let sampling = options.sampling(py)?;
    let image = run(py, scene, &options, &[], |prepared, watch| {
        prepared.render(&sampling, watch)
    })?;
    of_render(py, &image)
}

/// The image, its derivative, the method and what was done, and where.
#[pyfunction]
pub fn gradient<'py>(
    py: Python<'py>,
    scene: &Scene,
    along: Along<'py>,
    options: Options<'py>,
) -> PyResult<OfGradient<'py>> {
    let asked = options.gradient(py)?;
    let motion = Motion::from(along);
    let image = run(py, scene, &options, &motion.names(), |prepared, watch| {
        let direction = motion.direction(prepared)?;
        prepared.gradient(&direction, &asked, watch)
    })?;
    of_gradient(py, &image)
}

/// The gradient of a loss and its standard errors by names, and what was done, and where.
#[pyfunction]
pub fn backward<'py>(
    py: Python<'py>,
    scene: &Scene,
    adjoint: PyReadonlyArrayDyn<'py, f64>,
    names: Vec<String>,
    options: Options<'py>,
) -> PyResult<OfBackward<'py>> {
    let asked = options.gradient(py)?;
    let adjoint = arrays::to_image("the adjoint", &adjoint)?;
    let texts: Vec<&str> = names.iter().map(String::as_str).collect();
    let gradients = run(py, scene, &options, &texts, |prepared, watch| {
        prepared.backward(&adjoint, &names, &asked, watch)
    })?;
    of_backward(py, &gradients)
}

/// The gradient, its reference, and all numbers of their comparison.
#[pyfunction]
pub fn check<'py>(
    py: Python<'py>,
    scene: &Scene,
    along: Along<'py>,
    options: Options<'py>,
    reference_spp: Option<u32>,
    step: Option<f64>,
) -> PyResult<OfCheck<'py>> {
    let asked = CheckOptions {
        // What decides are the noisiest pixels.
        gradient: GradientOptions {
            adaptive: true,
            ..options.gradient(py)?
        },
        reference_spp,
        step,
    };
    let motion = Motion::from(along);
    let check = run(py, scene, &options, &motion.names(), |prepared, watch| {
        prepared.check(&motion.direction(prepared)?, &asked, watch)
    })?;
    of_check(py, &check, &asked)
}
