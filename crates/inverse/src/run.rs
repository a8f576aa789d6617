//! The loop of an optimisation: one iteration at a time.

use std::fmt;

use capwalk_diff::{
    GradientOptions, Method, Options, Prepared, Refusal, Statistics, Unwatched, WalkSettings,
    Watch, backward, render,
};
use capwalk_scene::{Film, Image, Scene, Sensor};

use crate::adam::{Adam, Moments};
use crate::guard::{Guards, Violation};
use crate::loss::{Loss, Measured};
use crate::record::{Row, Step};
use crate::schedule::Schedule;
use crate::seed::{Purpose, seed};
use crate::state::State;
use crate::variable::{ApplyError, Variables};

/// What is looked for, and how.
#[derive(Clone, Debug)]
pub struct Problem {
    /// The scene before the first step. It has passed [`Scene::check`].
    pub scene: Scene,
    /// Which of its numbers are looked for.
    pub variables: Variables,
    /// From where it is seen, and what should be seen; at least one.
    pub views: Vec<View>,
    /// How pictures are compared.
    pub loss: Loss,
    /// How steps are made of gradients.
    pub adam: Adam,
    /// The learning rate, for variables without their own.
    pub lr: f64,
    /// What is made of learning rates.
    pub schedule: Schedule,
    /// What a step must not do.
    pub guards: Guards,
    /// When to stop.
    pub limits: Limits,
    /// The seed that all others are derived from.
    pub seed: u64,
    /// Samples per pixel of pictures, at least 2: their spread is the error.
    pub spp: u32,
    /// Samples per pixel of gradients.
    pub spp_grad: u32,
    /// How gradients are estimated, and the walk of methods that walk.
    pub method: Method,
    /// The walk that builds the velocity field.
    pub walk: WalkSettings,
}

/// A picture that is compared with a target.
#[derive(Clone, Debug)]
pub struct View {
    /// Another sensor than the scene's, with its film.
    pub sensor: Option<(Sensor, Film)>,
    /// What should be seen.
    pub target: Image,
    /// How much each pixel and channel counts, at least 0; all the same without.
    pub mask: Option<Image>,
    /// How much the view counts, above 0.
    pub weight: f64,
}

/// When to stop.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// After so many steps.
    pub iterations: u32,
    /// When the loss is at most this.
    pub loss_below: Option<f64>,
    /// When the smallest loss is so many iterations old.
    pub patience: Option<u32>,
}

/// Why it went no further.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// All iterations are done.
    Done,
    /// The loss is small enough.
    LossBelow {
        /// The loss that was asked for.
        limit: f64,
    },
    /// The loss did not get smaller for long.
    NoProgress {
        /// For so many iterations.
        patience: u32,
        /// Where it was smallest.
        best_iteration: u32,
        /// What it was there.
        best_loss: f64,
    },
    /// The step would have spoiled a mesh.
    Guard(Violation),
    /// The step would have left what can be rendered.
    Outside(ApplyError),
    /// Something became infinite or NaN.
    NotFinite {
        /// What.
        what: String,
    },
    /// The derivative is refused.
    Refused(Refusal),
    /// The watch said so.
    Interrupted,
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Done => f.write_str("all iterations are done"),
            Self::LossBelow { limit } => write!(f, "the loss is at most {limit}"),
            Self::NoProgress {
                patience,
                best_iteration,
                best_loss,
            } => write!(
                f,
                "the loss has not become smaller for {patience} iterations; it was smallest in \
                 iteration {best_iteration}: {best_loss:.6e}"
            ),
            Self::Guard(violation) => write!(
                f,
                "in the next step {violation}. Take a smaller `lr`, a larger `lambda`, more \
                 samples, or turn the guard off"
            ),
            Self::Outside(error) => write!(
                f,
                "the next step leaves what can be rendered: {error}. Give the parameter \
                 `bounds`, or a `reparam`"
            ),
            Self::NotFinite { what } => write!(f, "{what}"),
            Self::Refused(refusal) => refusal.fmt(f),
            Self::Interrupted => f.write_str("interrupted"),
        }
    }
}

/// What an iteration gave.
#[derive(Clone, Debug)]
pub struct Iteration {
    /// In numbers.
    pub row: Row,
    /// The picture of each view, before the step.
    pub pictures: Vec<Image>,
    /// The next state, or why there is none.
    pub next: Result<State, Stop>,
}

/// The pictures of a scene and what they are worth.
struct Seen {
    pictures: Vec<Image>,
    /// Of each view.
    measured: Vec<Measured>,
}

impl Problem {
    /// The values of a state.
    pub fn values(&self, state: &State) -> Vec<f64> {
        self.variables.values(&state.unknowns)
    }

    /// The scene of a state.
    pub fn scene(&self, state: &State) -> Result<Scene, ApplyError> {
        self.variables.apply(&self.scene, &self.values(state))
    }

    /// What is wrong before the first step: a start that cannot be rendered, or a
    /// mesh that its guard would object to at once.
    pub fn check_start(&self) -> Result<(), Stop> {
        let scene = self.scene(&State::new(self)).map_err(Stop::Outside)?;
        let deformed = self.variables.deformed(&self.scene);
        match self.guards.start(&scene, &deformed) {
            Some(violation) => Err(Stop::Guard(violation)),
            None => Ok(()),
        }
    }

    /// Looks at the scene of a state and takes a step from it. After the last
    /// iteration only looks. An error if there is nothing to write down: the
    /// watch stopped it, or something is not finite or refused.
    pub fn iterate(&self, state: &State, watch: &dyn Watch) -> Result<Iteration, Stop> {
        let values = self.values(state);
        let scene = self
            .variables
            .apply(&self.scene, &values)
            .map_err(Stop::Outside)?;
        let seen = self.look(&scene, state.iteration, watch)?;
        let mut row = self.row(state, values, &seen.measured);
        if !row.loss.is_finite() {
            let (iteration, loss) = (state.iteration, row.loss);
            return Err(Stop::NotFinite {
                what: format!("the loss of iteration {iteration} is {loss}"),
            });
        }
        let next = match self.limit(state, row.loss) {
            Some(stop) => Err(stop),
            None => self.step(state, &scene, &seen, &mut row, watch),
        };
        match next {
            Err(stop @ (Stop::Interrupted | Stop::Refused(_) | Stop::NotFinite { .. })) => {
                Err(stop)
            }
            next => Ok(Iteration {
                row,
                pictures: seen.pictures,
                next,
            }),
        }
    }

    /// Whether there is to be no step.
    fn limit(&self, state: &State, loss: f64) -> Option<Stop> {
        let Limits {
            iterations,
            loss_below,
            patience,
        } = self.limits;
        if let Some(limit) = loss_below.filter(|&limit| loss <= limit) {
            return Some(Stop::LossBelow { limit });
        }
        if state.iteration >= iterations {
            return Some(Stop::Done);
        }
        let waited = state.iteration - state.best_iteration;
        let patience = patience.filter(|&patience| waited >= patience && loss >= state.best_loss);
        patience.map(|patience| Stop::NoProgress {
            patience,
            best_iteration: state.best_iteration,
            best_loss: state.best_loss,
        })
    }

    fn options(&self, spp: u32, seed: u64) -> Options {
        Options { spp, seed }
    }

    fn gradient_options(&self, options: Options) -> GradientOptions {
        GradientOptions {
            options,
            method: self.method,
            walk: self.walk,
        }
    }

    /// Renders all views and compares them with their targets.
    fn look(&self, scene: &Scene, iteration: u32, watch: &dyn Watch) -> Result<Seen, Stop> {
        let (mut pictures, mut measured) = (Vec::new(), Vec::new());
        for (i, view) in self.views.iter().enumerate() {
            let seed = seed(self.seed, u64::from(iteration), i as u64, Purpose::Picture);
            let options = self.options(self.spp, seed);
            let picture = render(&Prepared::new(view.scene(scene)), &options, watch);
            check("picture", iteration, &picture.statistics)?;
            let (target, mask) = (&view.target, view.mask.as_ref());
            measured.push(self.loss.measure(&picture.value, target, mask));
            pictures.push(picture.value.mean);
        }
        Ok(Seen { pictures, measured })
    }

    /// The share of each view in the loss.
    fn shares(&self) -> Vec<f64> {
        let sum: f64 = self.views.iter().map(|view| view.weight).sum();
        self.views.iter().map(|view| view.weight / sum).collect()
    }

    /// The weighted mean over views.
    fn row(&self, state: &State, values: Vec<f64>, measured: &[Measured]) -> Row {
        let shares = self.shares();
        let mean = |of: fn(&Measured) -> f64| {
            let pairs = shares.iter().zip(measured);
            pairs.map(|(share, measured)| share * of(measured)).sum()
        };
        let squares = shares.iter().zip(measured);
        let squares = squares.map(|(share, m)| (share * m.standard_error).powi(2));
        let known = measured.iter().all(|measured| measured.noise.is_some());
        Row {
            iteration: state.iteration,
            loss: mean(|measured| measured.value),
            loss_error: squares.sum::<f64>().sqrt(),
            loss_noise: known.then(|| mean(|measured| measured.noise.unwrap_or(0.0))),
            by_view: measured.iter().map(|measured| measured.value).collect(),
            values,
            step: None,
        }
    }

    /// The gradient by the unknowns, and its standard errors.
    fn gradient(
        &self,
        state: &State,
        scene: &Scene,
        seen: &Seen,
        row: &Row,
        watch: &dyn Watch,
    ) -> Result<(Vec<f64>, Vec<f64>), Stop> {
        let count = self.variables.count();
        let (mut sums, mut squares) = (vec![0.0; count], vec![0.0; count]);
        let wanted = self.variables.wanted(&self.scene);
        let shares = self.shares();
        for (i, view) in self.views.iter().enumerate() {
            let adjoint = &seen.measured[i].adjoint;
            let adjoint = Image {
                pixels: adjoint.pixels.iter().map(|&a| a * shares[i]).collect(),
                ..*adjoint
            };
            let iteration = u64::from(row.iteration);
            let seed = seed(self.seed, iteration, i as u64, Purpose::Gradient);
            let options = self.gradient_options(self.options(self.spp_grad, seed));
            let seen_scene = view.scene(scene);
            let prepared = Prepared::new(seen_scene.clone());
            let result =
                backward(&prepared, &adjoint, &wanted, &options, watch).map_err(Stop::Refused)?;
            check("gradient", row.iteration, &result.statistics)?;
            let pull = |gradient: &_| {
                let variables = &self.variables;
                let by_values = variables.pull(&self.scene, &seen_scene, &row.values, gradient);
                variables.pull_changes(&state.unknowns, &by_values)
            };
            let (numbers, errors) = result.numbers(pull);
            for k in 0..count {
                sums[k] += numbers[k];
                squares[k] += errors[k] * errors[k];
            }
        }
        let errors = squares.into_iter().map(f64::sqrt);
        Ok((sums, errors.collect()))
    }

    /// The first variable by which the derivative is refused in a state, each
    /// tried alone.
    pub fn refused_variable(&self, state: &State) -> Option<usize> {
        let scene = self.scene(state).ok()?;
        let options = self.gradient_options(self.options(1, self.seed));
        let is_refused = |variable: &usize| {
            let wanted = self.variables.wanted_by(&self.scene, *variable);
            let mut seen = self.views.iter().map(|view| view.scene(&scene));
            seen.any(|seen| {
                let [width, height] = seen.film.crop_size.map(|side| side as usize);
                let nothing = Image::new(width, height);
                backward(
                    &Prepared::new(seen),
                    &nothing,
                    &wanted,
                    &options,
                    &Unwatched,
                )
                .is_err()
            })
        };
        (0..self.variables.iter().count()).find(is_refused)
    }

    fn step(
        &self,
        state: &State,
        scene: &Scene,
        seen: &Seen,
        row: &mut Row,
        watch: &dyn Watch,
    ) -> Result<State, Stop> {
        let (gradient, errors) = self.gradient(state, scene, seen, row, watch)?;
        self.refuse_non_finite(&gradient, row.iteration)?;
        let mut next = state.clone();
        next.iteration += 1;
        if row.loss < state.best_loss {
            (next.best_loss, next.best_iteration) = (row.loss, row.iteration);
        }
        let Limits { iterations, .. } = self.limits;
        let factor = self.schedule.factor(row.iteration, iterations);
        for (variable, range) in self.variables.iter() {
            let moments = Moments {
                first: &mut next.first[range.clone()],
                second: &mut next.second[range.clone()],
            };
            let lr = factor * variable.lr.unwrap_or(self.lr);
            let unknowns = &mut next.unknowns[range.clone()];
            let gradient = &gradient[range];
            let uniform = variable.uniform;
            self.adam
                .step(next.iteration, lr, uniform, gradient, moments, unknowns);
        }
        self.variables.clamp(&mut next.unknowns);
        let differences = next.unknowns.iter().zip(&state.unknowns);
        row.step = Some(Step {
            gradient: norm(gradient.iter().copied()),
            gradient_noise: norm(errors.into_iter()),
            length: norm(differences.map(|(a, b)| a - b)),
            lr: factor * self.lr,
        });
        let after = self.scene(&next).map_err(Stop::Outside)?;
        let deformed = self.variables.deformed(&self.scene);
        match self.guards.step(scene, &after, &deformed) {
            Some(violation) => Err(Stop::Guard(violation)),
            None => Ok(next),
        }
    }

    fn refuse_non_finite(&self, gradient: &[f64], iteration: u32) -> Result<(), Stop> {
        for (variable, range) in self.variables.iter() {
            let numbers = &gradient[range];
            if let Some(index) = numbers.iter().position(|g| !g.is_finite()) {
                let (name, number) = (&variable.name, numbers[index]);
                return Err(Stop::NotFinite {
                    what: format!(
                        "in iteration {iteration} the gradient by unknown {index} of \"{name}\" \
                         is {number}"
                    ),
                });
            }
        }
        Ok(())
    }
}

impl View {
    /// The scene, as it is seen from here.
    pub fn scene(&self, scene: &Scene) -> Scene {
        let mut seen = scene.clone();
        if let Some((sensor, film)) = &self.sensor {
            (seen.sensor, seen.film) = (sensor.clone(), film.clone());
        }
        seen
    }
}

/// Whether a piece of work can be used.
fn check(what: &str, iteration: u32, statistics: &Statistics) -> Result<(), Stop> {
    if !statistics.complete {
        return Err(Stop::Interrupted);
    }
    if statistics.too_many_non_finite() {
        return Err(Stop::NotFinite {
            what: format!(
                "{} of {} samples of the {what} of iteration {iteration} were infinite or NaN",
                statistics.non_finite, statistics.samples
            ),
        });
    }
    Ok(())
}

fn norm(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.map(|x| x * x).sum::<f64>().sqrt()
}
