//! Sample counts that follow the noise of steps.

use capwalk::optimize::{ByNoise, Descent, StepNoise};
use pyo3::prelude::*;

/// The rule of a job's `[samples]`, with what it remembers of steps along a direction that is not zero:
/// counts of images and of gradients, and their variances.
#[pyclass(module = "capwalk._capwalk")]
pub struct SampleCounts {
    rule: ByNoise,
    least: [u32; 2],
    noise: StepNoise,
}

#[pymethods]
impl SampleCounts {
    #[new]
    fn new(counts: [f64; 2], theta: f64, least: [u32; 2], most: u32, cost: f64) -> Self {
        let noise = StepNoise::new([0; 2], 1);
        Self {
            rule: ByNoise { theta, most, cost },
            least,
            noise: StepNoise {
                counts,
                direction: vec![1.0],
                ..noise
            },
        }
    }

    fn spp(&self) -> [u32; 2] {
        self.noise.spp()
    }

    fn learn(&mut self, descent: f64, variances: [f64; 2]) {
        let descent = Descent {
            value: descent,
            by: variances,
        };
        self.noise.learn(&self.rule, self.least, &descent);
    }

    fn no_descent(&self) -> Option<NoDescent> {
        self.noise.no_descent.map(NoDescent)
    }
}

/// A descent that cannot be told from zero.
#[pyclass(frozen, module = "capwalk._capwalk")]
pub struct NoDescent(capwalk::optimize::NoDescent);

#[pymethods]
impl NoDescent {
    #[getter]
    fn mean(&self) -> f64 {
        self.0.mean
    }

    #[getter]
    fn error(&self) -> f64 {
        self.0.error
    }

    #[getter]
    fn steps(&self) -> u32 {
        self.0.steps
    }

    fn __repr__(&self) -> String {
        let capwalk::optimize::NoDescent { mean, error, steps } = self.0;
        format!("NoDescent(mean={mean}, error={error}, steps={steps})")
    }
}
