//! Which of the sensors of a file is meant.

use std::convert::Infallible;
use std::str::FromStr;

/// One of a scene's sensors.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SensorChoice {
    /// By its place in the file, counted from 0.
    Number(usize),
    /// By its name: the id that the file gives it, else `sensor`, and of several `sensor_0`,
    /// `sensor_1` ...
    Name(String),
}

impl SensorChoice {
    /// Its place among the sensors of these names, if it is one of them.
    pub fn place(&self, names: &[String]) -> Option<usize> {
        match self {
            Self::Number(number) => (*number < names.len()).then_some(*number),
            Self::Name(name) => names.iter().position(|own| own == name),
        }
    }
}

impl From<usize> for SensorChoice {
    fn from(number: usize) -> Self {
        Self::Number(number)
    }
}

impl From<&str> for SensorChoice {
    fn from(name: &str) -> Self {
        Self::Name(name.into())
    }
}

/// As it is typed: a whole number is a place.
impl FromStr for SensorChoice {
    type Err = Infallible;

    fn from_str(text: &str) -> Result<Self, Infallible> {
        Ok(match text.parse() {
            Ok(number) => Self::Number(number),
            Err(_) => Self::from(text),
        })
    }
}
