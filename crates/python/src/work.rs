//! Images and gradients of scenes.

use std::collections::BTreeMap;

use capwalk::{
    CheckOptions, Choice, Chosen, Direction, Error, Estimate, GradientOptions, MethodChoice,
    MethodName, Prepared, RenderOptions, Statistics, Tangent, Verdict, WalkChoice, Watch,
};
use numpy::{PyArray3, PyReadonlyArrayDyn};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::scene::Scene;
use crate::watched::{How, watched};
use crate::{arrays, errors};

/// An image and its standard errors, (height, width, 3) each.
type Arrays<'py> = (Bound<'py, PyArray3<f64>>, Bound<'py, PyArray3<f64>>);

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
    method: String,
    #[pyo3(attribute)]
    steps: Option<u32>,
    #[pyo3(attribute)]
    max_angle: Option<f64>,
    #[pyo3(attribute)]
    antithetic: Option<bool>,
}

impl<'py> Options<'py> {
    fn sampling(&self) -> RenderOptions {
        RenderOptions::new(self.spp, self.seed)
    }

    fn gradient(&self, py: Python<'_>) -> PyResult<GradientOptions> {
        let Some(method) = MethodName::named(&self.method) else {
            let names: Vec<&str> = MethodName::NAMES.iter().map(|(name, _)| *name).collect();
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
        // There is more with the feature `paper`, which is not for Python.
        #[allow(clippy::needless_update)]
        let choice = MethodChoice {
            method,
            walk,
            ..MethodChoice::default()
        };
        let options = choice.apply(self.sampling().into());
        options.map_err(|error| errors::exception(py, error))
    }

    fn how(&self) -> How<'py> {
        How {
            threads: self.threads,
            progress: self.progress.clone(),
        }
    }
}

/// What the image changes along: an expression, or velocities of arrays by their names.
#[derive(FromPyObject)]
pub enum Along<'py> {
    Expression(String),
    Velocities(BTreeMap<String, PyReadonlyArrayDyn<'py, f64>>),
}

impl Along<'_> {
    fn tangent(&self, prepared: &Prepared) -> Result<Tangent, Error> {
        let (scene, registry) = (prepared.scene(), prepared.registry());
        match self {
            Self::Expression(text) => Ok(text.tangent(scene, registry)?.into_owned()),
            Self::Velocities(velocities) => {
                let mut sum = Tangent::zero(scene);
                for (name, array) in velocities {
                    sum.add(&prepared.tangent(name, &arrays::to_numbers(array))?);
                }
                Ok(sum)
            }
        }
    }
}

/// Work on a scene, followed by Python.
fn run<T: Send>(
    py: Python<'_>,
    scene: &Scene,
    options: &Options<'_>,
    work: impl FnOnce(&Prepared, &dyn Watch) -> Result<T, Error> + Send,
) -> PyResult<T> {
    let guard = scene.read(py)?;
    let prepared = &*guard;
    let result = watched(py, &options.how(), |watch| work(prepared, watch))?;
    result.map_err(|error| errors::exception(py, error))
}

/// The image and what was done.
#[pyfunction]
pub fn render<'py>(
    py: Python<'py>,
    scene: &Scene,
    options: Options<'py>,
) -> PyResult<(Arrays<'py>, Bound<'py, PyDict>)> {
    let sampling = options.sampling();
    let image = run(py, scene, &options, |prepared, watch| {
        Ok(prepared.render(&sampling, watch)?)
    })?;
    Ok((
        of_estimate(py, &image.value)?,
        of_statistics(py, &image.statistics)?,
    ))
}

/// The image, its derivative, what was chosen and what was done.
#[pyfunction]
pub fn gradient<'py>(
    py: Python<'py>,
    scene: &Scene,
    along: Along<'py>,
    options: Options<'py>,
) -> PyResult<(
    Arrays<'py>,
    Arrays<'py>,
    Bound<'py, PyDict>,
    Bound<'py, PyDict>,
)> {
    let asked = options.gradient(py)?;
    let tangent = along.tangent(&*scene.read(py)?);
    let tangent = tangent.map_err(|error| errors::exception(py, error))?;
    let (image, chosen) = run(py, scene, &options, |prepared, watch| {
        let chosen = prepared.choose(&tangent, &asked, watch)?;
        let image = prepared.gradient(&tangent, &chosen.options, watch)?;
        Ok((image, chosen))
    })?;
    Ok((
        of_estimate(py, &image.value)?,
        of_estimate(py, &image.gradient)?,
        of_chosen(py, &chosen)?,
        of_statistics(py, &image.statistics)?,
    ))
}

/// The gradient of a loss and its standard errors by names, and what was done.
#[pyfunction]
pub fn backward<'py>(
    py: Python<'py>,
    scene: &Scene,
    adjoint: PyReadonlyArrayDyn<'py, f64>,
    names: Vec<String>,
    options: Options<'py>,
) -> PyResult<[Bound<'py, PyDict>; 3]> {
    let asked = options.gradient(py)?;
    let adjoint = arrays::to_image("the adjoint", &adjoint)?;
    let gradients = run(py, scene, &options, |prepared, watch| {
        prepared.backward(&adjoint, &names, &asked, watch)
    })?;
    let [values, errors] = [PyDict::new(py), PyDict::new(py)];
    for gradient in &gradients {
        let array = |numbers: &[f64]| arrays::from_numbers(py, &gradient.shape, numbers.to_vec());
        values.set_item(&gradient.name, array(&gradient.numbers)?)?;
        errors.set_item(&gradient.name, array(&gradient.standard_errors)?)?;
    }
    Ok([values, errors, of_statistics(py, &gradients.statistics)?])
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
) -> PyResult<(Arrays<'py>, Arrays<'py>, Bound<'py, PyDict>)> {
    let asked = CheckOptions {
        gradient: options.gradient(py)?,
        reference_spp,
        step,
    };
    let tangent = along.tangent(&*scene.read(py)?);
    let tangent = tangent.map_err(|error| errors::exception(py, error))?;
    let check = run(py, scene, &options, |prepared, watch| {
        prepared.check(&tangent, &asked, watch)
    })?;
    let comparison = &check.comparison;
    let numbers = PyDict::new(py);
    let (verdict, reason, samples_factor) = match &comparison.verdict {
        Verdict::Right => ("right", None, None),
        Verdict::Wrong { reason } => ("wrong", Some(reason), None),
        Verdict::Inconclusive { samples_factor } => ("inconclusive", None, Some(samples_factor)),
    };
    numbers.set_item("verdict", verdict)?;
    numbers.set_item("reason", reason)?;
    numbers.set_item("samples_factor", samples_factor)?;
    numbers.set_item("scale_factor", comparison.scale_factor)?;
    numbers.set_item("scale_factor_error", comparison.scale_factor_error)?;
    numbers.set_item("mean_z2", comparison.mean_z_squared)?;
    numbers.set_item("mean_z2_error", comparison.mean_z_squared_error)?;
    numbers.set_item("sign", comparison.sign)?;
    numbers.set_item("relative_l1", comparison.relative_l1)?;
    numbers.set_item("relative_l1_of_noise", comparison.relative_l1_of_noise)?;
    numbers.set_item("correlation", comparison.correlation)?;
    numbers.set_item("pixels", comparison.pixels)?;
    numbers.set_item("worst", comparison.worst.clone())?;
    numbers.set_item("step", check.made.step)?;
    numbers.set_item("spp", asked.gradient.spp)?;
    numbers.set_item("reference_spp", check.made.spp)?;
    Ok((
        of_estimate(py, &check.gradient.gradient)?,
        of_estimate(py, &check.reference.gradient)?,
        numbers,
    ))
}

fn of_estimate<'py>(py: Python<'py>, estimate: &Estimate) -> PyResult<Arrays<'py>> {
    Ok((
        arrays::from_image(py, &estimate.mean)?,
        arrays::from_image(py, &estimate.standard_error)?,
    ))
}

fn of_chosen<'py>(py: Python<'py>, chosen: &Chosen) -> PyResult<Bound<'py, PyDict>> {
    let numbers = PyDict::new(py);
    numbers.set_item("method", chosen.options.method.name())?;
    numbers.set_item("trials", chosen.trials.len())?;
    Ok(numbers)
}

fn of_statistics<'py>(py: Python<'py>, statistics: &Statistics) -> PyResult<Bound<'py, PyDict>> {
    let numbers = PyDict::new(py);
    numbers.set_item("samples", statistics.samples)?;
    numbers.set_item("complete", statistics.complete)?;
    numbers.set_item("non_finite", statistics.non_finite)?;
    numbers.set_item("too_many_non_finite", statistics.too_many_non_finite())?;
    numbers.set_item("cone_queries", statistics.cone_queries)?;
    Ok(numbers)
}
