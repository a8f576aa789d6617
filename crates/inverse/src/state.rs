//! All that an optimisation remembers, as plain numbers.

use crate::problem::Problem;
use crate::samples::{NoDescent, StepNoise};

/// Where an optimisation is. The next state is a function of it and of the
/// problem: there are no random numbers in it, these have addresses.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Steps taken.
    pub iteration: u32,
    /// What is looked for.
    pub unknowns: Vec<f64>,
    /// Running means of the gradient.
    pub first: Vec<f64>,
    /// Running means of its square.
    pub second: Vec<f64>,
    /// The smallest loss so far; infinite before the first.
    pub best_loss: f64,
    /// The iteration in which it was.
    pub best_iteration: u32,
    /// What is remembered of the noise of steps.
    pub noise: StepNoise,
}

/// An array of a checkpoint: its name and its numbers.
pub type NamedArray = (&'static str, Vec<f64>);

impl State {
    /// Before the first step.
    pub fn new(problem: &Problem) -> Self {
        let unknowns = problem.variables.initial();
        Self {
            iteration: 0,
            first: vec![0.0; unknowns.len()],
            second: vec![0.0; unknowns.len()],
            noise: StepNoise::new([problem.spp, problem.spp_grad], unknowns.len()),
            unknowns,
            best_loss: f64::INFINITY,
            best_iteration: 0,
        }
    }

    /// The state as named arrays, to the bit.
    pub fn to_numbers(&self) -> Vec<NamedArray> {
        let counts = [self.iteration, self.best_iteration].map(f64::from);
        let StepNoise {
            counts: spp,
            direction,
            block,
            no_descent,
        } = &self.noise;
        let found = no_descent.map_or([0.0; 3], |found| {
            [found.mean, found.error, f64::from(found.steps)]
        });
        vec![
            ("unknowns", self.unknowns.clone()),
            ("adam.first", self.first.clone()),
            ("adam.second", self.second.clone()),
            ("iterations", counts.to_vec()),
            ("best_loss", vec![self.best_loss]),
            ("samples", spp.to_vec()),
            ("direction", direction.clone()),
            ("noise", [&block[..], &found].concat()),
        ]
    }

    /// The names of such arrays, and how many numbers each has for so many unknowns.
    pub fn counts(unknowns: usize) -> [(&'static str, usize); 8] {
        [
            ("unknowns", unknowns),
            ("adam.first", unknowns),
            ("adam.second", unknowns),
            ("iterations", 2),
            ("best_loss", 1),
            ("samples", 2),
            ("direction", unknowns),
            ("noise", 8),
        ]
    }

    /// The state in such arrays, for as many unknowns; an error says which array
    /// is not as it should be.
    pub fn from_numbers<'a>(
        unknowns: usize,
        find: impl Fn(&str) -> Option<&'a [f64]>,
    ) -> Result<Self, String> {
        let array = |name: &str, count: usize| match find(name) {
            None => Err(format!("there is no array \"{name}\"")),
            Some(found) if found.len() != count => {
                let found = found.len();
                Err(format!("\"{name}\" has {found} numbers; expected {count}"))
            }
            Some(found) => Ok(found.to_vec()),
        };
        let counts = array("iterations", 2)?;
        let count = |x: f64| match x.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&x) {
            true => Ok(x as u32),
            false => Err(format!("\"iterations\" has {x}; expected whole numbers")),
        };
        let noise = array("noise", 8)?;
        let spp = array("samples", 2)?;
        let values = array("unknowns", unknowns)?;
        let direction = array("direction", unknowns)?;
        if let Some(wrong) = noise.iter().chain(&direction).find(|x| !x.is_finite()) {
            return Err(format!(
                "what is known of noise has {wrong}; expected finite numbers"
            ));
        }
        let is_count = |x: &f64| (1.0..=f64::from(u32::MAX)).contains(x);
        if let Some(wrong) = spp.iter().find(|x| !is_count(x)) {
            return Err(format!(
                "\"samples\" has {wrong}; expected numbers of at least 1"
            ));
        }
        Ok(Self {
            iteration: count(counts[0])?,
            unknowns: values,
            first: array("adam.first", unknowns)?,
            second: array("adam.second", unknowns)?,
            best_loss: array("best_loss", 1)?[0],
            best_iteration: count(counts[1])?,
            noise: StepNoise {
                counts: [spp[0], spp[1]],
                direction,
                block: [0, 1, 2, 3, 4].map(|i| noise[i]),
                no_descent: (noise[7] > 0.0).then_some(NoDescent {
                    mean: noise[5],
                    error: noise[6],
                    steps: noise[7] as u32,
                }),
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_the_state() {
        let state = State {
            iteration: 17,
            unknowns: vec![0.1, -3e-300],
            first: vec![1.0 / 3.0, 0.0],
            second: vec![2.0, 5e-324],
            best_loss: f64::INFINITY,
            best_iteration: 4_000_000_000,
            noise: StepNoise {
                counts: [16.5, 4.0],
                direction: vec![-0.0, 1e300],
                block: [1.0, 2.0, 3.0, 3.5, 4.0],
                no_descent: Some(NoDescent {
                    mean: -1.0,
                    error: 2.0,
                    steps: 40,
                }),
            },
        };
        let numbers = state.to_numbers();
        let counts = numbers.iter().map(|(name, numbers)| (*name, numbers.len()));
        assert_eq!(counts.collect::<Vec<_>>(), State::counts(2));
        let find = |name: &str| {
            let found = numbers.iter().find(|(own, _)| *own == name);
            found.map(|(_, numbers)| &numbers[..])
        };
        assert_eq!(State::from_numbers(2, find), Ok(state));
        let error = State::from_numbers(3, find).expect_err("too few");
        assert!(
            error.contains("\"unknowns\" has 2 numbers; expected 3"),
            "{error}"
        );
        let none = State::from_numbers(2, |_| None).expect_err("nothing");
        assert!(none.contains("no array \"iterations\""));
    }
}
