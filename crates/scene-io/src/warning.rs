//! Warnings: properties of a scene file that have no effect, or that are read differently.

use std::fmt;

use crate::location::Location;

/// Something in a file that was read and should be known: it has no effect, or
/// the image may not be what the file seems to ask for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// The file and the place in it.
    pub location: Location,
    /// The warning, in one sentence.
    pub message: String,
    /// True if it is about light, and not about what is seen of surfaces without it.
    pub is_about_light: bool,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.location, self.message)
    }
}
