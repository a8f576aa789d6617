//! What can be wrong with a parameter, and the names that were perhaps meant.

use std::fmt;

use capwalk_math::Vec3;

use capwalk_geometry::shown;

/// Why an expression or a list of velocities means no motion.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ParameterError {
    /// Nothing has this name.
    Unknown {
        /// What was asked for.
        name: String,
        /// Names like it, the likeliest first.
        near: Vec<String>,
    },
    /// Something that could be expected to be a parameter, and is none.
    NoParameter {
        /// What was asked for.
        name: String,
        /// Why, and what to do instead.
        reason: String,
    },
    /// A name was expected, but the expression is empty or ends.
    Missing,
    /// What stands before `*` is not a finite number.
    BadFactor {
        /// What stands there.
        text: String,
    },
    /// Coefficients or velocities add up to what is no number.
    NotFinite {
        /// What was asked for.
        what: String,
    },
    /// Two things of the scene have the same name.
    Ambiguous {
        /// The name.
        name: String,
    },
    /// The material has two different sides.
    TwoSides {
        /// What was asked for.
        name: String,
    },
    /// No shape has this id.
    UnknownShape {
        /// What was asked for.
        shape: String,
        /// Ids like it, the likeliest first.
        near: Vec<String>,
    },
    /// An array where a scalar is needed.
    Array {
        /// What was asked for.
        name: String,
    },
    /// Indices that an array has not.
    BadIndex {
        /// The array.
        name: String,
        /// What stands there, from the bracket on.
        indices: String,
        /// Its shape, as NumPy writes it.
        shape: String,
    },
    /// An array would get more or fewer numbers than it has.
    ArrayLength {
        /// The array.
        name: String,
        /// Its shape, as NumPy writes it.
        shape: String,
        /// Numbers it has.
        numbers: usize,
        /// Numbers given.
        given: usize,
    },
    /// An array would get a number that it cannot have.
    BadNumber {
        /// The array.
        name: String,
        /// Which of its numbers, row by row, counted from 0.
        index: usize,
        /// What it would be.
        value: f64,
        /// What it should be.
        expected: &'static str,
    },
    /// Two vertices at the same place would get different ones.
    Parted {
        /// The shape.
        shape: String,
        /// The vertices, counted from 0.
        vertices: [usize; 2],
        /// Where they would be.
        positions: [Vec3; 2],
    },
    /// There are more or fewer velocities than vertices.
    VertexCount {
        /// The shape.
        shape: String,
        /// Vertices it has.
        vertices: usize,
        /// Velocities given.
        velocities: usize,
    },
    /// A velocity is infinite or NaN.
    BadVelocity {
        /// The shape.
        shape: String,
        /// The vertex, counted from 0.
        vertex: usize,
        /// Its velocity.
        velocity: Vec3,
    },
    /// Two vertices at the same place would part.
    Torn {
        /// The shape.
        shape: String,
        /// The vertices, counted from 0.
        vertices: [usize; 2],
        /// Their velocities.
        velocities: [Vec3; 2],
    },
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let vector = |v: &Vec3| format!("({}, {}, {})", shown(v.x), shown(v.y), shown(v.z));
        match self {
            Self::Unknown { name, near } => {
                write!(f, "the scene has no parameter \"{name}\"")?;
                did_you_mean(f, near)
            }
            Self::NoParameter { name, reason } => {
                write!(f, "\"{name}\" is not a parameter: {reason}")
            }
            Self::Missing => write!(
                f,
                "expected a parameter's name, such as `ball.translate.x`, but the expression \
                 ends"
            ),
            Self::BadFactor { text } => write!(
                f,
                "\"{text}\" stands before `*`; expected a finite number, as in \
                 `0.5*ball.translate.x`"
            ),
            Self::NotFinite { what } => write!(
                f,
                "{what} add up to an infinite velocity; expected numbers whose sums and products \
                 are finite"
            ),
            Self::Ambiguous { name } => write!(
                f,
                "\"{name}\" names two different things in this scene; give one of them another id"
            ),
            Self::TwoSides { name } => write!(
                f,
                "\"{name}\" belongs to a material that is made of different ones; name one of \
                 them instead"
            ),
            Self::UnknownShape { shape, near } => {
                write!(f, "the scene has no shape \"{shape}\"")?;
                did_you_mean(f, near)
            }
            Self::Array { name } => write!(
                f,
                "\"{name}\" is an array, not one number that could stand in a sum or have \
                 a derivative; reverse mode gives the gradient with respect to all of it, and \
                 `{name}[0]` is a part of it"
            ),
            Self::BadIndex {
                name,
                indices,
                shape,
            } => write!(
                f,
                "the array \"{name}\" has the shape {shape}, and nothing in it is called \
                 \"{indices}\"; expected whole numbers from 0, one for each side or for the \
                 first of them, and `]`"
            ),
            Self::ArrayLength {
                name,
                shape,
                numbers,
                given,
            } => write!(
                f,
                "{given} numbers were given for \"{name}\"; expected {numbers}, in the shape \
                 {shape}"
            ),
            Self::BadNumber {
                name,
                index,
                value,
                expected,
            } => write!(
                f,
                "number {index} of \"{name}\" would be {}; expected {expected}",
                shown(*value)
            ),
            Self::Parted {
                shape,
                vertices: [a, b],
                positions: [u, v],
            } => write!(
                f,
                "vertices {a} and {b} of the shape \"{shape}\" are at the same place but would \
                 go to {} and {}; the surface would tear: keep them together",
                vector(u),
                vector(v)
            ),
            Self::VertexCount {
                shape,
                vertices,
                velocities,
            } => write!(
                f,
                "{velocities} velocities were given for the shape \"{shape}\", which has \
                 {vertices} vertices; expected one for each vertex"
            ),
            Self::BadVelocity {
                shape,
                vertex,
                velocity,
            } => write!(
                f,
                "vertex {vertex} of the shape \"{shape}\" has the velocity {}; expected finite \
                 numbers",
                vector(velocity)
            ),
            Self::Torn {
                shape,
                vertices: [a, b],
                velocities: [u, v],
            } => write!(
                f,
                "vertices {a} and {b} of the shape \"{shape}\" are at the same place but have \
                 the velocities {} and {}; the surface would tear: give them the same",
                vector(u),
                vector(v)
            ),
        }
    }
}

impl std::error::Error for ParameterError {}

fn did_you_mean(f: &mut fmt::Formatter<'_>, near: &[String]) -> fmt::Result {
    match near {
        [] => Ok(()),
        [one] => write!(f, "; did you mean `{one}`?"),
        [first @ .., last] => write!(f, "; did you mean `{}` or `{last}`?", first.join("`, `")),
    }
}
