//! Gradients of a loss with respect to parameters by their names.

use std::collections::HashSet;
use std::ops::Index;

use capwalk_diff::{
    Backward, BackwardWork, BatchSums, Chosen, GradientOptions, Grid, KeptChoice, Part, Partial,
    PreparedScene, Refusal, Statistics, Wanted, Watch,
};
use capwalk_scene::params::{ArrayParameter, ParameterError, Registry, Request};
use capwalk_scene::{Image, Scene, Tangent};

use crate::direction;
use crate::error::Error;

/// The gradients of a loss, in the order in which they were asked for.
#[derive(Clone, Debug)]
pub struct Gradients {
    gradients: Vec<ParameterGradient>,
    /// The method that samples were differentiated by, or the one that was asked for if others chose
    /// it and computed all parts.
    pub chosen: Chosen,
    /// What was done.
    pub statistics: Statistics,
}

/// The derivative of a loss with respect to the numbers of one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterGradient {
    /// What was asked for.
    pub name: String,
    /// Dimensions of the array; none for a single number.
    pub shape: Vec<usize>,
    /// Derivatives with respect to each number, row by row, per unit of the parameter.
    pub numbers: Vec<f64>,
    /// The standard error of each; NaN where there were too few samples for one.
    pub standard_errors: Vec<f64>,
    /// Euclidean norm of the numbers, or the one number with its sign.
    pub size: f64,
    /// Standard error of that, to first order.
    pub size_error: f64,
}

impl ParameterGradient {
    /// True if it is a single number.
    pub fn is_scalar(&self) -> bool {
        self.shape.is_empty()
    }

    /// The norm that an array of only noise would have about.
    pub fn noise(&self) -> f64 {
        norm(&self.standard_errors)
    }
}

impl Gradients {
    /// All of them, in the order in which they were asked for.
    pub fn iter(&self) -> std::slice::Iter<'_, ParameterGradient> {
        self.gradients.iter()
    }

    /// The one with this name.
    pub fn get(&self, name: &str) -> Option<&ParameterGradient> {
        self.iter().find(|gradient| gradient.name == name)
    }
}

impl Index<&str> for Gradients {
    type Output = ParameterGradient;

    /// The gradient with this name.
    ///
    /// # Panics
    /// If it was not asked for.
    fn index(&self, name: &str) -> &ParameterGradient {
        let found = self.get(name);
        found.unwrap_or_else(|| panic!("no gradient with respect to \"{name}\" was asked for"))
    }
}

impl<'a> IntoIterator for &'a Gradients {
    type Item = &'a ParameterGradient;
    type IntoIter = std::slice::Iter<'a, ParameterGradient>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// The arrays of a scene with respect to which a loss can be differentiated.
#[derive(Clone, Debug, PartialEq)]
pub struct GradientNames {
    /// Those that can be asked for, each under its first name.
    pub allowed: Vec<String>,
    /// Those that would be refused.
    pub refused: Vec<String>,
    /// Why they would be.
    pub refusal: Option<Refusal>,
}

/// The names of all arrays, by whether their gradient would be refused.
pub(crate) fn names(prepared: &PreparedScene, registry: &Registry) -> GradientNames {
    let refusal = capwalk_diff::refusal(prepared);
    let arrays = registry.arrays().iter();
    let first_names = arrays.filter(|array| array.alias_of.is_none()).cloned();
    let (refused, allowed): (Vec<_>, Vec<_>) =
        first_names.partition(|array| refusal.is_some() && array.moves_discontinuities);
    let names = |arrays: Vec<ArrayParameter>| arrays.into_iter().map(|array| array.name).collect();
    GradientNames {
        allowed: names(allowed),
        refused: names(refused),
        refusal,
    }
}

/// A gradient with respect to all that is named, to be computed at once or in parts.
#[derive(Debug)]
pub struct GradientsWork<'a> {
    scene: &'a Scene,
    requests: Vec<(String, Request)>,
    /// What changes with any of them.
    wanted: Wanted,
    work: BackwardWork<'a>,
}

impl<'a> GradientsWork<'a> {
    pub(crate) fn new<N: AsRef<str>>(
        prepared: &'a PreparedScene,
        registry: &Registry,
        adjoint: &'a Image,
        names: &[N],
        options: GradientOptions,
        kept: impl FnOnce(Wanted) -> KeptChoice,
    ) -> Result<Self, Error> {
        let scene = prepared.scene();
        let requests = requests(scene, registry, names)?;
        // One pass over the samples gives a covector on everything that any of them moves.
        let mut wanted = Wanted::by(&Tangent::zero(scene));
        for (_, request) in &requests {
            wanted.add(&Wanted::by(&match request {
                Request::Tangent(tangent) => tangent.clone(),
                Request::Array(array) => array.tangent(scene, &vec![1.0; array.count()]),
            }));
        }
        let work = BackwardWork::new(prepared, adjoint, wanted.clone(), options);
        Ok(Self {
            scene,
            requests,
            work: work.keeping(kept(wanted.clone())),
            wanted,
        })
    }

    /// The cells that the work can be cut into.
    pub fn grid(&self) -> Grid {
        self.work.grid()
    }

    /// The method that the work is done by, see [`Method::Auto`](crate::Method::Auto). Refused like the
    /// work.
    pub fn chosen(&self, watch: &dyn Watch) -> Result<Chosen, Error> {
        Ok(self.work.chosen(watch)?)
    }

    /// Refuses what cannot be differentiated rightly. That needs no sample.
    pub fn check(&self, watch: &dyn Watch) -> Result<(), Error> {
        Ok(self.work.check(watch)?)
    }

    /// What a part of the work gives; refused like the whole.
    pub fn part(&self, part: &Part, watch: &dyn Watch) -> Result<Partial<BatchSums>, Error> {
        Ok(self.work.part(part, watch)?)
    }

    /// The gradients, from all parts. The bits are those of [`Prepared::backward`](crate::Prepared::backward).
    pub fn finish(&self, parts: Partial<BatchSums>) -> Result<Gradients, Error> {
        Ok(self.by_name(self.work.finish(parts)?))
    }

    /// All of it at once, see [`Prepared::backward`](crate::Prepared::backward).
    pub fn whole(&self, watch: &dyn Watch) -> Result<Gradients, Error> {
        Ok(self.by_name(self.unnamed(watch)?))
    }

    /// What all parameters change, before it is sorted by their names.
    pub(crate) fn unnamed(&self, watch: &dyn Watch) -> Result<Backward, Error> {
        Ok(self.work.whole(watch)?)
    }

    pub(crate) fn wanted(&self) -> &Wanted {
        &self.wanted
    }

    /// Each parameter's gradient is a linear map of the covector on the scene.
    pub(crate) fn by_name(&self, result: Backward) -> Gradients {
        let scene = self.scene;
        let gradients = self.requests.iter().map(|(name, request)| match request {
            Request::Tangent(tangent) => of_number(name.clone(), tangent, &result),
            Request::Array(array) => of_array(scene, name.clone(), array, &result),
        });
        Gradients {
            gradients: gradients.collect(),
            chosen: result.chosen,
            statistics: result.statistics,
        }
    }
}

/// What each name means in the scene.
fn requests<N: AsRef<str>>(
    scene: &Scene,
    registry: &Registry,
    names: &[N],
) -> Result<Vec<(String, Request)>, Error> {
    let mut seen = HashSet::new();
    let mut requests = Vec::new();
    for name in names {
        let name = name.as_ref();
        let request = registry.request(scene, name)?;
        if let Request::Tangent(tangent) = &request {
            direction::check(tangent, || direction::parameters(name))?;
        }
        if !seen.insert(name) {
            return Err(Error::AskedTwice { name: name.into() });
        }
        requests.push((name.to_owned(), request));
    }
    Ok(requests)
}

/// The array of this name.
pub(crate) fn array(
    registry: &Registry,
    scene: &Scene,
    name: &str,
) -> Result<ArrayParameter, ParameterError> {
    match registry.request(scene, name)? {
        Request::Array(array) => Ok(array),
        Request::Tangent(_) => Err(ParameterError::NoParameter {
            name: name.into(),
            reason: "it is a direction and has no values of its own; name an array".into(),
        }),
    }
}

fn of_number(name: String, tangent: &Tangent, result: &Backward) -> ParameterGradient {
    let (value, error) = result.along(tangent);
    ParameterGradient {
        name,
        shape: Vec::new(),
        numbers: vec![value],
        standard_errors: vec![error],
        size: value,
        size_error: error,
    }
}

fn of_array(
    scene: &Scene,
    name: String,
    array: &ArrayParameter,
    result: &Backward,
) -> ParameterGradient {
    let (numbers, standard_errors) = result.numbers(array.pull_back(scene));
    let size = norm(&numbers);
    // The derivative of the norm is the unit vector along the gradient.
    let unit: Vec<f64> = match size {
        0.0 => vec![0.0; numbers.len()],
        size => numbers.iter().map(|x| x / size).collect(),
    };
    let (_, size_error) = result.along(&array.tangent(scene, &unit));
    ParameterGradient {
        name,
        shape: array.shape.clone(),
        numbers,
        standard_errors,
        size,
        size_error,
    }
}

fn norm(numbers: &[f64]) -> f64 {
    numbers.iter().map(|x| x * x).sum::<f64>().sqrt()
}
