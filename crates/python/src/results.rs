//! What work gives, as Python has it.

use capwalk::{
    Check, CheckOptions, Error, Estimate, GradientImage, GradientOptions, Gradients, Rendering,
    Statistics, Verdict,
};
use capwalk::{comparison_text, coplanar_text, edge_on_text, touching_text};
use numpy::PyArray3;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::{arrays, errors};

/// An image and its standard errors, (height, width, 3) each.
type Arrays<'py> = (Bound<'py, PyArray3<f64>>, Bound<'py, PyArray3<f64>>);

/// The GPU's name, or `cpu`, and why it was the CPU if a GPU could have been meant.
type OfDevice = (String, Option<String>);

/// An image, what was done, and where.
pub type OfRender<'py> = (Arrays<'py>, Bound<'py, PyDict>, OfDevice);

/// The name of a method, and what a pilot found for it, as bytes.
pub type OfMethod<'py> = (&'static str, Bound<'py, PyBytes>);

/// An image, its derivative, the method, what was done, and where.
pub type OfGradient<'py> = (
    Arrays<'py>,
    Arrays<'py>,
    OfMethod<'py>,
    Bound<'py, PyDict>,
    OfDevice,
);

/// The gradient of a loss and its standard errors by names, the method, what was done, and where.
pub type OfBackward<'py> = (
    Bound<'py, PyDict>,
    Bound<'py, PyDict>,
    OfMethod<'py>,
    Bound<'py, PyDict>,
    OfDevice,
);

/// A gradient, its reference, and all numbers of their comparison.
pub type OfCheck<'py> = (Arrays<'py>, Arrays<'py>, Bound<'py, PyDict>);

pub fn of_render<'py>(py: Python<'py>, image: &Rendering) -> PyResult<OfRender<'py>> {
    Ok((
        of_estimate(py, &image.value)?,
        of_statistics(py, &image.statistics)?,
        of_device(&image.statistics),
    ))
}

/// A derivative image by samples that were differentiated.
pub fn of_gradient<'py>(py: Python<'py>, image: &GradientImage) -> PyResult<OfGradient<'py>> {
    let chosen = image.chosen.as_ref();
    let chosen = chosen.expect("finite differences alone have no method");
    Ok((
        of_estimate(py, &image.value)?,
        of_estimate(py, &image.gradient)?,
        of_method(py, &chosen.options)?,
        of_statistics(py, &image.statistics)?,
        of_device(&image.statistics),
    ))
}

pub fn of_backward<'py>(py: Python<'py>, gradients: &Gradients) -> PyResult<OfBackward<'py>> {
    let [values, errors] = [PyDict::new(py), PyDict::new(py)];
    for gradient in gradients {
        let array = |numbers: &[f64]| arrays::from_numbers(py, &gradient.shape, numbers.to_vec());
        values.set_item(&gradient.name, array(&gradient.numbers)?)?;
        errors.set_item(&gradient.name, array(&gradient.standard_errors)?)?;
    }
    let method = of_method(py, &gradients.chosen.options)?;
    let statistics = of_statistics(py, &gradients.statistics)?;
    let device = of_device(&gradients.statistics);
    Ok((values, errors, method, statistics, device))
}

/// The method of these options, for `options.chosen`.
pub fn of_method<'py>(py: Python<'py>, options: &GradientOptions) -> PyResult<OfMethod<'py>> {
    let settings = capwalk::scene::pack(&(options.method, options.walk));
    let settings = settings.map_err(|error| errors::exception(py, Error::from(error)))?;
    Ok((options.method.name(), PyBytes::new(py, &settings)))
}

pub fn of_check<'py>(
    py: Python<'py>,
    check: &Check,
    asked: &CheckOptions,
) -> PyResult<OfCheck<'py>> {
    let comparison = &check.comparison;
    let numbers = PyDict::new(py);
    let (name, reason, samples_factor) = match &comparison.verdict {
        Verdict::Right => ("right", None, None),
        Verdict::Wrong { reason } => ("wrong", Some(reason), None),
        Verdict::Inconclusive {
            samples_factor,
            doubt,
        } => ("inconclusive", doubt.as_ref(), Some(samples_factor)),
    };
    numbers.set_item("verdict", name)?;
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
    for (name, pairs) in [("coplanar", &check.coplanar), ("touching", &check.touching)] {
        let pairs: Vec<(&String, &String)> = pairs.iter().map(|[a, b]| (a, b)).collect();
        numbers.set_item(name, pairs)?;
    }
    let faces: Vec<(&String, usize)> = check
        .edge_on
        .iter()
        .map(|at| (&at.shape, at.face))
        .collect();
    numbers.set_item("edge_on", faces)?;
    numbers.set_item("step", check.made.step)?;
    numbers.set_item("sides", check.made.sides.name())?;
    numbers.set_item("spp", asked.gradient.spp)?;
    numbers.set_item("reference_spp", check.made.spp)?;
    numbers.set_item("references", check.references)?;
    let option = |name: &str, value: Option<u64>| {
        let name = name.replace('-', "_");
        value.map_or(name.clone(), |value| format!("{name}={value}"))
    };
    let note = coplanar_text(&check.coplanar)
        + &touching_text(&check.touching)
        + &edge_on_text(&check.edge_on);
    let text = note + &comparison_text(comparison) + &check.verdict(option);
    numbers.set_item("text", text)?;
    let statistics = [&check.gradient, &check.reference].map(|image| &image.statistics);
    for (name, statistics) in ["statistics", "reference_statistics"]
        .iter()
        .zip(statistics)
    {
        numbers.set_item(name, of_statistics(py, statistics)?)?;
    }
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

fn of_statistics<'py>(py: Python<'py>, statistics: &Statistics) -> PyResult<Bound<'py, PyDict>> {
    let numbers = PyDict::new(py);
    numbers.set_item("samples", statistics.samples)?;
    numbers.set_item("complete", statistics.complete)?;
    numbers.set_item("non_finite", statistics.non_finite)?;
    numbers.set_item("too_many_non_finite", statistics.too_many_non_finite())?;
    numbers.set_item("cone_queries", statistics.cone_queries)?;
    numbers.set_item("dips", statistics.dips.dip)?;
    numbers.set_item("missing", statistics.dips.remark())?;
    Ok(numbers)
}

fn of_device(statistics: &Statistics) -> OfDevice {
    let device = &statistics.device;
    (device.name().to_owned(), device.remark.clone())
}
