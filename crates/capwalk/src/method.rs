//! How gradients are estimated, chosen by names: what files, command lines and other
//! faces share. Every option belongs to some methods and is an error beside others.

use capwalk_diff::{Estimator, GradientOptions, Method, WalkSettings};
use capwalk_scene::shown;

/// A method and its options, as they were asked for. `None` is the default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MethodChoice {
    /// The method.
    pub method: MethodName,
    /// How it walks; for methods that walk.
    pub walk: WalkChoice,
}

/// Options of the walk that builds the velocity field.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WalkChoice {
    /// Steps on spherical caps, at least 1.
    pub steps: Option<u32>,
    /// Estimator of the field's divergence.
    pub estimator: Option<Estimator>,
    /// Largest angle at which silhouettes are looked for, degrees, above 0 and up to
    /// 180. By default a pilot may narrow that of [`WalkSettings`].
    pub max_angle: Option<f64>,
    /// Whether each rim sample is averaged with the opposite one.
    pub antithetic: Option<bool>,
}

/// Methods by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum MethodName {
    /// `auto`: what of `walk` and `edges` has the least variance × time, found by a short
    /// pilot. Unbiased.
    #[default]
    Auto,
    /// `walk`: walks on spherical caps. Unbiased.
    Walk,
    /// `edges`: points on all edges before emitters and the camera, walks elsewhere.
    /// Unbiased.
    Edges,
}

/// What is chosen by its name.
pub trait Choice: Copy + PartialEq + 'static {
    /// The choices and their names.
    const NAMES: &'static [(&'static str, Self)];

    /// What it is, in a line.
    fn help(self) -> &'static str;

    /// The choice of this name.
    fn named(name: &str) -> Option<Self> {
        let mut names = Self::NAMES.iter();
        names
            .find(|(own, _)| *own == name)
            .map(|&(_, choice)| choice)
    }

    /// Its name.
    fn name(self) -> &'static str {
        let mut names = Self::NAMES.iter();
        let found = names.find(|(_, choice)| *choice == self);
        found.map_or("", |(name, _)| name)
    }
}

impl Choice for MethodName {
    const NAMES: &'static [(&'static str, Self)] = &[
        ("auto", Self::Auto),
        ("walk", Self::Walk),
        ("edges", Self::Edges),
    ];

    fn help(self) -> &'static str {
        match self {
            Self::Auto => {
                "Whichever of walk and edges a short pilot finds to have less noise: unbiased"
            }
            Self::Walk => "Walks on spherical caps: unbiased",
            Self::Edges => {
                "Points on edges in front of light and the camera, walks where that cannot be: \
                 unbiased"
            }
        }
    }
}

impl Choice for Estimator {
    const NAMES: &'static [(&'static str, Self)] =
        &[("anchored", Self::Anchored), ("literal", Self::Literal)];

    fn help(self) -> &'static str {
        match self {
            Self::Anchored => "Relative to the closest silhouette's velocity: finite variance",
            Self::Literal => "The paper's equation as printed: infinite variance",
        }
    }
}

/// Why options do not go together.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OptionError {
    /// The method has no use for the option.
    #[error(
        "`{option}` belongs to the method {}, and the method is {}",
        owner.name(), method.name()
    )]
    OfAnotherMethod {
        /// The option: `kappa`.
        option: &'static str,
        /// The method that was chosen.
        method: MethodName,
        /// The first method that has the option.
        owner: MethodName,
    },
    /// A walk takes a step at least, and gains nothing from so many.
    #[error("`steps` is {steps}; expected 1 to {MOST_STEPS}")]
    Steps {
        /// What was asked for.
        steps: u32,
    },
    /// Nothing would be sampled.
    #[error("`{option}` is 0; expected at least one sample per pixel")]
    NoSamples {
        /// The option: `spp`.
        option: &'static str,
    },
    /// A GPU is asked for where none computes yet.
    #[error("{what} has no GPU yet: use the device cpu, or auto, which is the CPU there")]
    NoGpu {
        /// What would be computed: `work in parts`.
        what: &'static str,
    },
    /// Reverse mode has no image whose pixels could be noisy.
    #[error(
        "`adaptive` is for images and their derivatives in forward mode; in reverse mode all pixels \
         get the same number of samples"
    )]
    AdaptiveBackward,
    /// No distance is right for the differences of this scene.
    #[error(
        "no step of finite differences fits the parameter (it would be {} of its units): nothing \
         moves with it by a part of its size; give `step` in these units",
        shown(*step)
    )]
    NoFittingStep {
        /// What came out.
        step: f64,
    },
    /// Differences need a distance to divide by.
    #[error("`step` is {}; expected a finite number above 0", shown(*step))]
    NoStep {
        /// What was asked for.
        step: f64,
    },
}

/// Steps of a walk, at most: far more than it takes to be where it goes.
const MOST_STEPS: u32 = 1000;

/// An option: its name, the methods that have it, and whether it was given.
type MethodOption = (
    &'static str,
    &'static [MethodName],
    fn(&MethodChoice) -> bool,
);

/// Every option. `edges` walks where no edges are gathered.
const OPTIONS: &[MethodOption] = {
    use MethodName::{Edges, Walk};
    const WALKS: &[MethodName] = &[Walk, Edges];
    &[
        ("steps", WALKS, |c| c.walk.steps.is_some()),
        ("estimator", WALKS, |c| c.walk.estimator.is_some()),
        ("max_angle", WALKS, |c| c.walk.max_angle.is_some()),
        ("antithetic", WALKS, |c| c.walk.antithetic.is_some()),
    ]
};

impl MethodName {
    /// The names of the method's options.
    pub fn options(self) -> impl Iterator<Item = &'static str> {
        let options = OPTIONS
            .iter()
            .filter(move |(_, methods, _)| methods.contains(&self));
        options.map(|(name, ..)| *name)
    }
}

impl MethodChoice {
    /// The first option that was given, and the first method that has it.
    pub fn given(&self) -> Option<(&'static str, MethodName)> {
        let mut options = OPTIONS.iter();
        let given = options.find(|(_, _, is_given)| is_given(self));
        given.map(|(option, methods, _)| (*option, methods[0]))
    }

    /// True if an option of its method was given.
    pub fn has_own(&self) -> bool {
        let mut options = OPTIONS.iter();
        options.any(|(_, methods, is_given)| is_given(self) && methods.contains(&self.method))
    }

    /// The options of a gradient with this method instead of theirs.
    pub fn apply(&self, options: GradientOptions) -> Result<GradientOptions, OptionError> {
        let (method, walk) = self.resolve()?;
        Ok(GradientOptions {
            method,
            walk,
            ..options
        })
    }

    /// The method and its walk, or the first option that does not belong to it.
    pub fn resolve(&self) -> Result<(Method, WalkSettings), OptionError> {
        for (option, methods, is_given) in OPTIONS {
            if is_given(self) && !methods.contains(&self.method) {
                return Err(OptionError::OfAnotherMethod {
                    option,
                    method: self.method,
                    owner: methods[0],
                });
            }
        }
        if let Some(steps) = self
            .walk
            .steps
            .filter(|steps| !(1..=MOST_STEPS).contains(steps))
        {
            return Err(OptionError::Steps { steps });
        }
        let method = match self.method {
            MethodName::Auto => Method::Auto,
            MethodName::Walk => match self.walk.max_angle {
                Some(_) => Method::Walk,
                None => Method::FittedWalk,
            },
            MethodName::Edges => Method::EDGES,
        };
        Ok((method, self.walk.settings()))
    }
}

impl WalkChoice {
    fn settings(&self) -> WalkSettings {
        let default = WalkSettings::default();
        WalkSettings {
            steps: self.steps.unwrap_or(default.steps),
            max_radius: self.max_angle.map_or(default.max_radius, f64::to_radians),
            estimator: self.estimator.unwrap_or(default.estimator),
            antithetic: self.antithetic.unwrap_or(default.antithetic),
        }
    }
}

/// What the standard errors of a method do not say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Caveat {
    /// The estimator has infinite variance: standard errors are too small.
    InfiniteVariance,
    /// The method is biased: standard errors do not bound its errors.
    Biased,
}

/// What to know of the standard errors of a gradient with these options; `None` if they
/// can be relied on.
pub fn caveat(method: Method, walk: &WalkSettings) -> Option<Caveat> {
    let traits = method.traits();
    if !traits.is_unbiased {
        return Some(Caveat::Biased);
    }
    // In pairs of opposite azimuths what is infinite cancels (METHOD 2).
    let is_infinite = walk.estimator == Estimator::Literal && !walk.antithetic;
    (traits.walks && is_infinite).then_some(Caveat::InfiniteVariance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_the_choices() {
        fn round_trip<T: Choice + std::fmt::Debug>() {
            for &(name, choice) in T::NAMES {
                assert_eq!(T::named(name), Some(choice));
                assert_eq!(choice.name(), name);
            }
            assert_eq!(T::named("nothing"), None);
        }
        round_trip::<MethodName>();
        round_trip::<Estimator>();
        round_trip::<capwalk_diff::Device>();
        round_trip::<capwalk_scene::Filter>();
        round_trip::<crate::Distance>();
    }

    #[test]
    fn options_of_other_methods_are_refused() {
        let mut choice = MethodChoice {
            method: MethodName::Edges,
            ..MethodChoice::default()
        };
        choice.walk.steps = Some(3);
        let (method, walk) = choice.resolve().expect("it walks elsewhere");
        assert_eq!((method, walk.steps), (Method::EDGES, 3));
        choice.method = MethodName::Auto;
        let error = choice.resolve().expect_err("a pilot chooses its walks");
        assert_eq!(
            error.to_string(),
            "`steps` belongs to the method walk, and the method is auto"
        );
    }
}
