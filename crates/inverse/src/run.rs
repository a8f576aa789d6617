//! One iteration of an optimisation: from a state to the next.

use std::fmt;
use std::sync::Arc;

use capwalk_diff::{
    BackwardWork, Chosen, Dips, Estimate, GradientOptions, PreparedScene, Purpose, Refusal,
    RenderOptions, Seed, Statistics, Unwatched, Watch, render,
};
use capwalk_math::Rgb;
use capwalk_scene::{Image, Scene};

use crate::adam::MomentEstimates;
use crate::guard::Violation;
use crate::loss::Measured;
use crate::problem::{Limits, Problem};
use crate::record::{Row, Step};
use crate::samples::{Descent, LEAST, NoDescent};
use crate::state::State;
use crate::variable::ApplyError;
use crate::views::PreparedViews;

/// Why an optimisation goes no further.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
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
    /// The gradient cannot be told from its noise, with as many samples as there may be.
    NoDescent(NoDescent),
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
    /// The watch stopped it.
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
            Self::NoDescent(NoDescent { mean, error, steps }) => {
                let what = match *mean < -2.0 * error {
                    true => "the loss rises along its own steps: its descent",
                    false => "the descent cannot be told from zero: it",
                };
                write!(
                    f,
                    "{what} was {mean:.2e} ± {error:.2e} on average over the last {steps} steps, \
                     with the most samples. This is the optimum as far as so many samples and this \
                     learning rate can tell; go on with a smaller `lr`, or a larger `most`"
                )
            }
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

impl std::error::Error for Stop {}

impl From<Refusal> for Stop {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Stopped => Self::Interrupted,
            refusal => Self::Refused(refusal),
        }
    }
}

/// What an iteration gave.
#[derive(Clone, Debug)]
pub struct Iteration {
    /// In numbers.
    pub row: Row,
    /// The image of each view, before the step.
    pub images: Vec<Image>,
    /// The next state, or why there is none.
    pub next: Result<State, Stop>,
}

/// The images of a scene and their losses, one of each per view.
struct Seen {
    images: Vec<Estimate>,
    measured: Vec<Measured>,
}

/// The derivative of the loss with respect to each unknown.
struct Gradient {
    numbers: Vec<f64>,
    /// Standard error of each, for the images as they were.
    errors: Vec<f64>,
    /// Along the last step.
    descent: Descent,
    /// Rays whose motion is missing in it.
    dips: Dips,
}

impl Problem {
    /// The values of a state: what its unknowns mean.
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

    /// Renders the scene of a state and takes a step from it; after the last iteration
    /// only renders. An error if there is nothing to write down: the watch stopped it,
    /// or something is not finite or refused.
    ///
    /// With the unknowns `u`, their values `x(u)`, the image `I_v` of each view, its
    /// target and its share `s_v`, an iteration is
    ///
    /// ```text
    /// L  = Σ_v s_v loss(I_v(x(u)))                       the loss
    /// g  = (∂x/∂u)ᵀ Σ_v s_v (∂I_v/∂x)ᵀ ∂loss/∂I_v        its gradient, in reverse mode
    /// u' = clamp(u - Adam(g))                            the step
    /// ```
    ///
    /// with independent random numbers for `I_v` and its derivative. `views` are those of
    /// the iteration before, or new ones.
    pub fn iterate(
        &self,
        state: &State,
        views: &mut PreparedViews,
        watch: &dyn Watch,
    ) -> Result<Iteration, Stop> {
        // Put the values of the unknowns into the scene.
        let values = self.values(state);
        let scene = self
            .variables
            .apply(&self.scene, &values)
            .map_err(Stop::Outside)?;
        // Render every view and compare it with its target.
        let views = views.of(self, &scene, watch).ok_or(Stop::Interrupted)?;
        let seen = self.render_views(views, state, watch)?;
        let mut row = self.row(state, values, &seen.measured);
        if !row.loss.is_finite() {
            let (iteration, loss) = (state.iteration, row.loss);
            return Err(Stop::NotFinite {
                what: format!("the loss of iteration {iteration} is {loss}"),
            });
        }
        // Stop here if enough was done, otherwise take a step.
        let next = match self.limit(state, self.surely(&row)) {
            Some(stop) => Err(stop),
            None => self.step(state, &scene, views, &seen, &mut row, watch),
        };
        match next {
            // An unfinished step leaves no trace: a resumed run does it again.
            Err(stop @ (Stop::Interrupted | Stop::Refused(_) | Stop::NotFinite { .. })) => {
                Err(stop)
            }
            next => Ok(Iteration {
                row,
                images: seen.images.into_iter().map(|image| image.mean).collect(),
                next,
            }),
        }
    }

    /// What the loss is at most, where losses have different noise: two standard errors more. Few samples would
    /// make it small by accident.
    fn surely(&self, row: &Row) -> f64 {
        row.loss + self.by_noise.map_or(0.0, |_| 2.0 * row.loss_error)
    }

    /// Why there is to be no step, if there is a reason.
    fn limit(&self, state: &State, surely: f64) -> Option<Stop> {
        let Limits {
            iterations,
            loss_below,
            patience,
        } = self.limits;
        if let Some(limit) = loss_below.filter(|&limit| surely <= limit) {
            return Some(Stop::LossBelow { limit });
        }
        if state.iteration >= iterations {
            return Some(Stop::Done);
        }
        let waited = state.iteration - state.best_iteration;
        if let Some(found) = state.noise.no_descent {
            return Some(Stop::NoDescent(found));
        }
        let patience = patience.filter(|&patience| waited >= patience && surely >= state.best_loss);
        patience.map(|patience| Stop::NoProgress {
            patience,
            best_iteration: state.best_iteration,
            best_loss: state.best_loss,
        })
    }

    /// Renders all views and compares them with their targets.
    fn render_views(
        &self,
        views: &[PreparedScene],
        state: &State,
        watch: &dyn Watch,
    ) -> Result<Seen, Stop> {
        let (iteration, [spp, _]) = (state.iteration, state.noise.spp());
        let (mut images, mut measured) = (Vec::new(), Vec::new());
        for (i, view) in self.views.iter().enumerate() {
            let seed = Seed(self.seed).of_iteration(u64::from(iteration), i as u64, Purpose::Image);
            let options = RenderOptions::new(spp, seed.0);
            let rendering = render(&views[i], &options, watch);
            refuse_unusable("image", iteration, &rendering.statistics)?;
            let (target, mask) = (&view.target, view.mask.as_ref());
            measured.push(self.loss.measure(&rendering.value, target, mask));
            images.push(rendering.value);
        }
        Ok(Seen { images, measured })
    }

    /// The weighted mean over views.
    fn row(&self, state: &State, values: Vec<f64>, measured: &[Measured]) -> Row {
        let shares = self.shares();
        let mean = |of: fn(&Measured) -> f64| {
            let pairs = shares.iter().zip(measured);
            pairs.map(|(share, measured)| share * of(measured)).sum()
        };
        // Views are independent: their variances add up.
        let squares = shares.iter().zip(measured);
        let squares = squares.map(|(share, m)| (share * m.standard_error).powi(2));
        let known = measured.iter().all(|measured| measured.noise.is_some());
        Row {
            iteration: state.iteration,
            loss: mean(|measured| measured.value),
            loss_error: squares.sum::<f64>().sqrt(),
            loss_noise: known.then(|| mean(|measured| measured.noise.unwrap_or(0.0))),
            spp: state.noise.spp(),
            by_view: measured.iter().map(|measured| measured.value).collect(),
            values,
            step: None,
        }
    }

    /// Takes a step of Adam along the gradient, and notes it in the row. An error if the
    /// next state could not be rendered or spoils a mesh.
    fn step(
        &self,
        state: &State,
        scene: &Scene,
        views: &[PreparedScene],
        seen: &Seen,
        row: &mut Row,
        watch: &dyn Watch,
    ) -> Result<State, Stop> {
        // The gradient with respect to the unknowns, summed over views.
        let gradient = self.gradient(state, views, seen, row, watch)?;
        self.refuse_non_finite(&gradient.numbers, row.iteration)?;
        // Remember the smallest loss, for `patience`.
        let mut next = state.clone();
        next.iteration += 1;
        let surely = self.surely(row);
        if surely < state.best_loss {
            (next.best_loss, next.best_iteration) = (surely, row.iteration);
        }
        if let Some(rule) = &self.by_noise {
            // Where noise biases the gradient, images keep what they were given.
            let of_images = match self.loss.distance.is_biased_by_noise() {
                true => self.spp,
                false => LEAST[0],
            };
            next.noise
                .learn(rule, [of_images, LEAST[1]], &gradient.descent);
        }
        // Each variable takes a step of its own rate, times the factor of the schedule.
        let factor = self.schedule.factor(row.iteration, self.limits.iterations);
        for (variable, range) in self.variables.iter() {
            let moments = MomentEstimates {
                first: &mut next.first[range.clone()],
                second: &mut next.second[range.clone()],
            };
            self.adam.step(
                next.iteration,
                factor * variable.lr.unwrap_or(self.lr),
                variable.uniform,
                &gradient.numbers[range.clone()],
                moments,
                &mut next.unknowns[range],
            );
        }
        // Unknowns with bounds end between them.
        self.variables.clamp(&mut next.unknowns);
        let differences = || {
            next.unknowns
                .iter()
                .zip(&state.unknowns)
                .map(|(a, b)| a - b)
        };
        // A rate of 0 takes no step, and says nothing of the next one.
        let per_rate = if factor.is_normal() {
            1.0 / factor
        } else {
            0.0
        };
        next.noise.direction = differences().map(|by| by * per_rate).collect();
        row.step = Some(Step {
            gradient: norm(gradient.numbers.iter().copied()),
            gradient_noise: norm(gradient.errors.into_iter()),
            length: norm(differences()),
            lr: factor * self.lr,
            descent: gradient.descent,
            dips: gradient.dips,
        });
        // The step counts only if the scene can be rendered and its meshes are whole.
        let after = self.scene(&next).map_err(Stop::Outside)?;
        let deformed = self.variables.deformed(&self.scene);
        match self.guards.step(scene, &after, &deformed) {
            Some(violation) => Err(Stop::Guard(violation)),
            None => Ok(next),
        }
    }

    /// `g` of [`Problem::iterate`], and its standard errors.
    fn gradient(
        &self,
        state: &State,
        views: &[PreparedScene],
        seen: &Seen,
        row: &Row,
        watch: &dyn Watch,
    ) -> Result<Gradient, Stop> {
        // The last of these numbers is the derivative along the last step.
        let count = self.variables.count() + 1;
        let (mut sums, mut squares) = (vec![0.0; count], vec![0.0; count]);
        // Of the descent, by the differences of halves; not known without.
        let mut variance = self.by_noise.map_or(f64::NAN, |_| 0.0);
        let mut dips = Dips::default();
        let wanted = self.variables.wanted(&self.scene);
        let shares = self.shares();
        for (i, prepared) in views.iter().enumerate() {
            // The adjoint image of the view: s_v ∂loss/∂I_v. If sample counts follow the noise,
            // each half of the samples has another one.
            let spp = row.spp[1];
            let parts = match self.by_noise {
                None => vec![(seen.measured[i].adjoint.clone(), spp)],
                Some(_) => {
                    let [more, less] = self.perturbed(seen, i, row.iteration);
                    vec![(more, spp / 2), (less, spp.div_ceil(2))]
                }
            };
            let (mut halves, mut facts) = (Vec::new(), None);
            for (half, (adjoint, own_spp)) in parts.iter().enumerate() {
                let adjoint = Image {
                    pixels: adjoint.pixels.iter().map(|&a| a * shares[i]).collect(),
                    ..*adjoint
                };
                // A covector on the scene, with other random numbers than the image has:
                // the mean of the product is the product of the means.
                let iteration = u64::from(row.iteration);
                let number = (i + half * views.len()) as u64;
                let seed = Seed(self.seed).of_iteration(iteration, number, Purpose::Gradient);
                let options = self.gradient_options(RenderOptions::new(*own_spp, seed.0));
                // What is known of the motion is the same for all halves.
                let work = BackwardWork::new(prepared, &adjoint, wanted.clone(), options);
                let work = match &facts {
                    None => work,
                    Some(facts) => work.knowing(Arc::clone(facts)),
                };
                facts = Some(work.facts());
                let result = work.whole(watch).map_err(Stop::from)?;
                refuse_unusable("gradient", row.iteration, &result.statistics)?;
                if half == 0 {
                    dips += result.statistics.dips;
                }
                // From the scene to its values to the unknowns: two transposed linear maps.
                let pull = |gradient: &_| {
                    let variables = &self.variables;
                    let by_values =
                        variables.pull(&self.scene, prepared.scene(), &row.values, gradient);
                    let mut numbers =
                        variables.pull_reparameterization(&state.unknowns, &by_values);
                    let along = numbers.iter().zip(&state.noise.direction);
                    numbers.push(along.map(|(g, d)| g * d).sum());
                    numbers
                };
                // Views and halves are independent: their variances add up.
                let share = f64::from(*own_spp) / f64::from(spp);
                let (numbers, errors) = result.numbers(pull);
                for k in 0..count {
                    sums[k] += share * numbers[k];
                    squares[k] += (share * errors[k]).powi(2);
                }
                halves.push((share, numbers[count - 1]));
            }
            if let [(s, a), (t, b)] = halves[..] {
                variance += s * t * (a - b).powi(2);
            }
        }
        let [along, by_gradient] = [&mut sums, &mut squares].map(|numbers| numbers[count - 1]);
        sums.pop();
        squares.pop();
        Ok(Gradient {
            numbers: sums,
            errors: squares.into_iter().map(f64::sqrt).collect(),
            descent: Descent {
                value: 0.0 - along,
                by: [variance - by_gradient, by_gradient],
            },
            dips,
        })
    }

    /// The adjoint of a view's image as it would be with as much noise more, and with as much less:
    /// each pixel is moved by its standard error, up or down at random. The difference of what they
    /// give is twice what the noise of the image adds, and the mean is that of the image.
    fn perturbed(&self, seen: &Seen, view: usize, iteration: u32) -> [Image; 2] {
        let (target, mask) = (&self.views[view].target, self.views[view].mask.as_ref());
        let Estimate {
            mean,
            standard_error,
        } = &seen.images[view];
        let (iteration, view_number) = (u64::from(iteration), view as u64);
        let seed = Seed(self.seed).of_iteration(iteration, view_number, Purpose::Image);
        let is_up = |pixel: usize| seed.of_iteration(pixel as u64, 0, Purpose::Image).0 >> 63 == 1;
        let moved = |by: f64| {
            let pixels = mean.pixels.iter().zip(&standard_error.pixels).enumerate();
            let moved =
                pixels.map(|(pixel, (&x, &error))| x + error * if is_up(pixel) { by } else { -by });
            let image = Estimate {
                mean: Image {
                    pixels: moved.collect(),
                    ..*mean
                },
                standard_error: standard_error.clone(),
            };
            self.loss.measure(&image, target, mask).adjoint
        };
        let [more, less] = [1.0, -1.0].map(moved);
        let adjoint = &seen.measured[view].adjoint;
        [0.5, -0.5].map(|by| {
            let pixels = adjoint
                .pixels
                .iter()
                .zip(more.pixels.iter().zip(&less.pixels));
            Image {
                // Less light than none has no logarithm.
                pixels: pixels
                    .map(|(&a, (&b, &c))| {
                        a + (b - c).map(|d| if d.is_finite() { by * d } else { 0.0 })
                    })
                    .collect(),
                ..*adjoint
            }
        })
    }

    /// Settles the method of all gradients, if it is one that chooses: what is best for the sum
    /// of all pixels of the first view before the first step, in a pilot as for a hundred steps. All
    /// iterations keep it. `None` if another method is given; what is refused stays as it is, to
    /// be refused by the first iteration.
    pub fn choose_method(&mut self, watch: &dyn Watch) -> Option<Chosen> {
        if !self.method.is_open() {
            return None;
        }
        let scene = self.scene(&State::new(self)).ok()?;
        let seen = self.views.first()?.scene(&scene);
        let prepared = PreparedScene::try_new(seen, watch).ok()?;
        let [width, height] = prepared.scene().film.crop_size.map(|side| side as usize);
        let mut ones = Image::new(width, height);
        ones.pixels.fill(Rgb::splat(1.0));
        let wanted = self.variables.wanted(&self.scene);
        let options = self.gradient_options(RenderOptions::new(self.spp_grad, self.seed));
        let gradients = STEPS_OF_PILOT * self.views.len() as u64;
        let work = BackwardWork::new(&prepared, &ones, wanted, options).repeated(gradients);
        let chosen = work.chosen(watch).ok().filter(|_| !watch.should_stop())?;
        (self.method, self.walk) = (chosen.options.method, chosen.options.walk);
        Some(chosen)
    }

    /// The first variable whose derivative is refused in a state, each tried alone.
    pub fn refused_variable(&self, state: &State) -> Option<usize> {
        let scene = self.scene(state).ok()?;
        let options = self.gradient_options(RenderOptions::new(1, self.seed));
        let mut views = PreparedViews::new();
        let views = views.of(self, &scene, &Unwatched)?;
        let is_refused = |variable: &usize| {
            let wanted = self.variables.wanted_by(&self.scene, *variable);
            views.iter().any(|view| {
                let [width, height] = view.scene().film.crop_size.map(|side| side as usize);
                let nothing = Image::new(width, height);
                BackwardWork::new(view, &nothing, wanted.clone(), options)
                    .check(&Unwatched)
                    .is_err()
            })
        };
        (0..self.variables.iter().count()).find(is_refused)
    }

    fn gradient_options(&self, options: RenderOptions) -> GradientOptions {
        GradientOptions {
            method: self.method,
            walk: self.walk,
            ..options.into()
        }
    }

    /// An error that names the first unknown whose gradient is not finite, or too large to be squared.
    fn refuse_non_finite(&self, gradient: &[f64], iteration: u32) -> Result<(), Stop> {
        for (variable, range) in self.variables.iter() {
            let numbers = &gradient[range];
            let is_usable = |g: &f64| g.abs() < LARGEST_GRADIENT;
            if let Some(index) = numbers.iter().position(|g| !is_usable(g)) {
                let (name, number) = (&variable.name, numbers[index]);
                return Err(Stop::NotFinite {
                    what: format!(
                        "in iteration {iteration} the gradient with respect to unknown {index} of \
                         \"{name}\" is {number:e}"
                    ),
                });
            }
        }
        Ok(())
    }
}

/// Squares of smaller gradients can be added up.
const LARGEST_GRADIENT: f64 = 1e150;

/// The pilot is as large as for so many steps, about what optimisations take. The number that is
/// asked for must not decide: a run that goes on for more must have the same method.
const STEPS_OF_PILOT: u64 = 100;

/// An error if a piece of work was stopped, or too many of its samples are not finite.
fn refuse_unusable(what: &str, iteration: u32, statistics: &Statistics) -> Result<(), Stop> {
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

/// Euclidean norm.
fn norm(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.map(|x| x * x).sum::<f64>().sqrt()
}
