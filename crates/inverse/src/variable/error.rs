//! What can be wrong with variables and their values.

use std::fmt;

use capwalk_scene::SceneError;
use capwalk_scene::params::ParameterError;

/// Why a wish cannot be granted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VariableError {
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: Option<String>,
}

impl VariableError {
    pub(super) fn new(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            help: Some(help.into()),
        }
    }
}

impl fmt::Display for VariableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        match &self.help {
            Some(help) => write!(f, "; {help}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for VariableError {}

/// Why values make no scene.
#[derive(Clone, Debug, PartialEq)]
pub enum ApplyError {
    /// An array does not take them.
    Array(ParameterError),
    /// A shape would have no size, or be inside out.
    Scale {
        /// What the user called the scale.
        name: String,
        /// What it would be.
        value: f64,
    },
    /// The scene that they make cannot be rendered.
    Scene(SceneError),
}

impl fmt::Display for ApplyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Array(error) => error.fmt(f),
            Self::Scale { name, value } => write!(
                f,
                "\"{name}\" would be {value}; expected a scale above 0, which `reparam = \
                 \"log\"` keeps it"
            ),
            Self::Scene(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for ApplyError {}
