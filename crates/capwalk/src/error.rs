//! What can go wrong.

use std::path::PathBuf;

use capwalk_diff::{PartError, Refusal};
use capwalk_inverse::variable::{ApplyError, VariableError};
use capwalk_scene::params::ParameterError;
use capwalk_scene::{BytesError, SceneError, builtin};
use capwalk_scene_io::image::ImageError;
use capwalk_scene_io::{InputInTheWay, LoadError, VelocityFileError};

use crate::device::DeviceFailure;
use crate::folder_error::FolderError;
use crate::method::OptionError;
use crate::text::listed;

/// Why there is no result.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The file is no scene; with line and column.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// There is neither a file nor a built-in scene of this name.
    #[error(
        "there is no file {name}, and no built-in scene of that name (they are {})",
        known()
    )]
    UnknownScene {
        /// What was asked for.
        name: String,
    },
    /// Values of `$name` were given for a built-in scene, which has none.
    #[error("the built-in scene \"{scene}\" has no `$name` to define")]
    NothingToDefine {
        /// The scene.
        scene: String,
    },
    /// There are not so many sensors.
    #[error("the scene has no sensor {number}; they are counted from 0, and it has {sensors}")]
    NoSuchSensor {
        /// How many there are.
        sensors: usize,
        /// What was asked for.
        number: usize,
    },
    /// There is no sensor of this name.
    #[error("there is no sensor \"{name}\"; there are {}", sensors.join(", "))]
    NoSensorNamed {
        /// What was asked for.
        name: String,
        /// The sensors there are.
        sensors: Vec<String>,
    },
    /// All vertices of a shape were to be set to a few numbers.
    #[error(
        "\"{name}\" are all vertices of a shape, which are not set by a few numbers; move the \
         shape (`translate`, `rotate`, `scale`), or set one number: `{name}[0,2]`"
    )]
    ManyPositions {
        /// The array.
        name: String,
    },
    /// A name that means the sensor of a scene with several.
    #[error("\"{name}\" could be of several sensors; name one of them: {}", sensors.join(", "))]
    SeveralSensors {
        /// What was asked for.
        name: String,
        /// The sensors there are.
        sensors: Vec<String>,
    },
    /// A parameter of a sensor that does not render.
    #[error(
        "\"{name}\" is of another sensor; the image of {sensor} does not change with it: its \
         derivative is zero"
    )]
    OfAnotherSensor {
        /// What was asked for.
        name: String,
        /// The sensor that renders.
        sensor: String,
    },
    /// The scene was read and cannot be rendered.
    #[error("the scene {scene} cannot be rendered")]
    InvalidScene {
        /// The scene, as it was named.
        scene: String,
        /// Why.
        #[source]
        error: SceneError,
    },
    /// A scene that was made by hand cannot be rendered.
    #[error("the scene cannot be rendered")]
    Scene(#[from] SceneError),
    /// The change to the scene would make one that cannot be rendered.
    #[error("the changed scene cannot be rendered")]
    InvalidUpdate(#[source] SceneError),
    /// There is no unknown of an optimisation like this.
    #[error(transparent)]
    Variable(#[from] VariableError),
    /// Values for which an unknown of an optimisation makes no scene.
    #[error(transparent)]
    Apply(#[from] ApplyError),
    /// A name or an expression means no parameter.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A file holds no velocities.
    #[error(transparent)]
    Velocities(#[from] VelocityFileError),
    /// Numbers for an array in another shape than it has.
    #[error("{name} has the shape {expected}; found {found}")]
    Shape {
        /// The array.
        name: String,
        /// Its shape.
        expected: String,
        /// The shape of the given numbers.
        found: String,
    },
    /// Nothing moves or changes, so the derivative is zero everywhere.
    #[error("nothing changes: {what} add up to zero")]
    NothingMoves {
        /// What was asked for, such as `the parameters in "a - a"`.
        what: String,
    },
    /// Something changes so little or so much that squares of its derivative are no numbers.
    #[error(
        "{what} change numbers of the scene by at most {rate:e} for one unit, where 1e-70 to 1e70 \
         have derivatives with finite errors: use another factor"
    )]
    Unscaled {
        /// What was asked for, such as `the parameters in "1e-300*a"`.
        what: String,
        /// The largest velocity of a number of the scene.
        rate: f64,
    },
    /// A name was asked for twice.
    #[error("the gradient with respect to \"{name}\" was asked for twice")]
    AskedTwice {
        /// The name.
        name: String,
    },
    /// The derivative cannot be estimated without bias.
    #[error(transparent)]
    Refused(Refusal),
    /// There is no image from a GPU.
    #[error(transparent)]
    Device(#[from] DeviceFailure),
    /// Parts of a work that make no whole.
    #[error("{0}")]
    Part(PartError),
    /// Bytes that are no scene.
    #[error(transparent)]
    Bytes(#[from] BytesError),
    /// Options that contradict each other.
    #[error(transparent)]
    Option(#[from] OptionError),
    /// The image that was given has another size than the scene's.
    #[error(
        "the {what} has {} x {} pixels; expected {} x {}, as the image of the scene has",
        found[0], found[1], expected[0], expected[1]
    )]
    Size {
        /// Which image: the target, the mask.
        what: &'static str,
        /// Its width and height.
        found: [usize; 2],
        /// Width and height of the scene's film.
        expected: [usize; 2],
    },
    /// The image of a target would be black where it should be bright.
    #[error(
        "{non_finite} of {samples} samples of the target of view {view} were infinite or NaN, and \
         would count as zero. Set smaller numbers in the target's scene"
    )]
    NonFiniteTarget {
        /// Which view, counted from 1.
        view: usize,
        /// The number of samples that are infinite or NaN.
        non_finite: u64,
        /// The number of all samples.
        samples: u64,
    },
    /// The work was stopped before there was anything to return.
    #[error("stopped before {before}")]
    Stopped {
        /// What would have been needed.
        before: &'static str,
    },
    /// What is to be written is read.
    #[error(transparent)]
    InputInTheWay(#[from] InputInTheWay),
    /// The folder of a run cannot be used.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// An image could not be read or written.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// A file was read and cannot be used as an image of the scene.
    #[error("cannot use {}", path.display())]
    UnusableImage {
        /// The file.
        path: PathBuf,
        /// Why.
        #[source]
        error: UnusableImage,
    },
}

/// A refusal is one, unless it says that the work was stopped.
impl From<Refusal> for Error {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Stopped => Self::Stopped {
                before: "a sample was taken",
            },
            refusal => Self::Refused(refusal),
        }
    }
}

/// A refusal is one, whether the work was done at once or in parts.
impl From<PartError> for Error {
    fn from(error: PartError) -> Self {
        match error {
            PartError::Refused(refusal) => refusal.into(),
            error => Self::Part(error),
        }
    }
}

/// What is wrong with an image that was read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum UnusableImage {
    /// It has no layer of any of these names.
    #[error("there is no layer \"{}\"; there are {}", asked.join("\" or \""), listed(known))]
    NoLayer {
        /// What was asked for.
        asked: Vec<String>,
        /// What there is.
        known: Vec<String>,
    },
    /// It has another size than the image of the scene.
    #[error(
        "it has {} x {} pixels; expected {} x {}, as the image of the scene has",
        found[0], found[1], expected[0], expected[1]
    )]
    Size {
        /// Its width and height.
        found: [usize; 2],
        /// Width and height of the scene's film.
        expected: [usize; 2],
    },
    /// A pixel is infinite or NaN.
    #[error(
        "it is ({}, {}, {}) in column {column}, row {row}, counted from 0 at the upper left; \
         expected finite numbers",
        pixel[0], pixel[1], pixel[2]
    )]
    NotFinite {
        /// Column, counted from 0.
        column: usize,
        /// Row, counted from 0.
        row: usize,
        /// The three channels.
        pixel: [f64; 3],
    },
    /// Pixels of a mask are below 0, or all of them are 0.
    #[error("{problem}; expected the weight of each pixel")]
    NotWeights {
        /// What is wrong.
        problem: &'static str,
    },
}

/// The names of the built-in scenes.
fn known() -> String {
    builtin::names().collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `?` works on every error that a function of this crate returns.
    #[test]
    fn errors_of_all_functions_are_taken() {
        fn all() -> Result<(), Error> {
            crate::Prepared::new(crate::load("leaf")?.scene)?;
            crate::read_velocities("no such file".as_ref())?;
            Ok(())
        }
        assert!(matches!(all(), Err(Error::Velocities(_))));
        fn takes<E: Into<Error>>() {}
        takes::<SceneError>();
        takes::<VariableError>();
        takes::<ParameterError>();
        takes::<OptionError>();
    }

    #[test]
    fn refused_parts_are_refusals() {
        let refusal = || Refusal::ParallelRays { method: "was" };
        let error = Error::from(PartError::Refused(refusal()));
        assert!(matches!(error, Error::Refused(found) if found == refusal()));
        let error = Error::from(PartError::DifferentWork);
        assert!(matches!(error, Error::Part(PartError::DifferentWork)));
    }
}
