//! What can be wrong with variables and their values.

use capwalk_scene::params::ParameterError;
use capwalk_scene::{SceneError, shown};

use super::pose::PoseLimit;

/// Why there is no variable with this specification, or no set of them.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VariableError {
    /// The name means no parameter.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// The choice of vertices or of their directions is wrong.
    #[error(transparent)]
    Vertices(#[from] VerticesError),
    /// An option was given that is for vertices only.
    #[error("`{option}` has no meaning for \"{name}\"; it is for vertices, `<shape>.positions`")]
    OnlyForVertices {
        /// What was asked for.
        name: String,
        /// The option.
        option: &'static str,
    },
    /// It would be, or start, where it cannot.
    #[error("\"{name}\" cannot be {}; expected {expected}", shown(*value))]
    Start {
        /// What was asked for.
        name: String,
        /// A number that it would have.
        value: f64,
        /// What would be possible.
        expected: String,
    },
    /// There are more or fewer numbers to start at than it has.
    #[error(
        "{given} numbers were given for \"{name}\"; expected {numbers}, or one for all of them"
    )]
    StartLength {
        /// What was asked for.
        name: String,
        /// How many were given.
        given: usize,
        /// How many it has.
        numbers: usize,
    },
    /// A rotation in a sum would not stay a rotation.
    #[error(
        "\"{name}\" is a sum with a rotation, and linear motion does not stay a rotation; make it \
         a parameter of its own, such as `<shape>.rotate.x`"
    )]
    RotationInSum {
        /// What was asked for.
        name: String,
    },
    /// One number of a rotation would not stay one.
    #[error(
        "\"{name}\" is one number of a rotation, and does not change alone; name the array \
         \"{array}\" with all of its numbers"
    )]
    PartOfRotation {
        /// What was asked for.
        name: String,
        /// All of it.
        array: String,
    },
    /// Values were asked for of what only has a distance from where it is.
    #[error(
        "\"{name}\" is no single number of the scene: {what} would be a distance from the \
         scene's values and no value; name an array such as `<material>.reflectance.value`, or \
         one number of it, without a factor"
    )]
    NoValue {
        /// What was asked for.
        name: String,
        /// What needs a value: its start, its bounds, its reparameterization.
        what: &'static str,
    },
    /// The bounds are not two finite numbers in order.
    #[error(
        "the bounds of \"{name}\" are {} and {}; expected two finite numbers, the lower one first",
        shown(bounds[0]), shown(bounds[1])
    )]
    Bounds {
        /// What was asked for.
        name: String,
        /// Its bounds.
        bounds: [f64; 2],
    },
    /// Smoothed unknowns have no bounds.
    #[error(
        "\"{name}\" has both `lambda` and bounds or a `reparam`; a smoothed unknown has no bounds \
         of its own; leave one of them out"
    )]
    SmoothedWithBounds {
        /// What was asked for.
        name: String,
    },
    /// The strength of the smoothing is out of range.
    #[error(
        "the `lambda` of \"{name}\" is {lambda}; expected a number from 0 to {largest:e}, above \
         which rounding dominates; 10 to 50 is usual"
    )]
    Lambda {
        /// What was asked for.
        name: String,
        /// Its `lambda`.
        lambda: f64,
        /// The largest that is allowed.
        largest: f64,
    },
    /// Memory ran out while the smoothing was prepared.
    #[error(
        "the matrix that smooths \"{name}\" cannot be factored; leave out `lambda`, or select fewer \
         vertices"
    )]
    Factorization {
        /// What was asked for.
        name: String,
    },
    /// A logarithm has no bounds.
    #[error(
        "\"{name}\" has both bounds and `reparam = \"log\"`; leave one of them out, or use \
         `reparam = \"sigmoid\"`"
    )]
    LogWithBounds {
        /// What was asked for.
        name: String,
    },
    /// Two variables have the same name.
    #[error("\"{name}\" is listed twice; keep one of them")]
    Twice {
        /// The name.
        name: String,
    },
    /// Two variables change the same numbers, and the changes cannot be added.
    #[error(
        "\"{}\" and \"{}\" change the same numbers of the scene; keep one of them",
        names[0], names[1]
    )]
    Overlap {
        /// Their names.
        names: [String; 2],
    },
}

/// What is wrong with a choice of vertices and directions.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum VerticesError {
    /// There is no vertex of this index.
    #[error("there is no vertex {index}; there are {count}, from 0")]
    Index {
        /// What was asked for.
        index: usize,
        /// Vertices of the shape.
        count: usize,
    },
    /// The choice is empty.
    #[error("no vertex is selected")]
    Empty,
    /// A vertex has no normal, or lies at the centre.
    #[error("vertex {vertex} has no such direction; leave it out")]
    NoDirection {
        /// The vertex, counted from 0.
        vertex: usize,
    },
}

/// Why values make no scene.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ApplyError {
    /// An array does not take them.
    #[error(transparent)]
    Array(#[from] ParameterError),
    /// A shape would have no size, be inside out or out of reach, or turn without meaning.
    #[error("\"{name}\" would be {}; expected {limit}{}", shown(*value), match limit {
        PoseLimit::Scale => ", which `reparam = \"log\"` keeps above 0",
        PoseLimit::Angle | PoseLimit::Distance => "",
    })]
    Pose {
        /// What the user called the number.
        name: String,
        /// What it would be.
        value: f64,
        /// What it is beyond.
        limit: PoseLimit,
    },
    /// The scene that they make cannot be rendered.
    #[error(transparent)]
    Scene(#[from] SceneError),
}
