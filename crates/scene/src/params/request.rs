//! What a text asks for: an array, or a motion.

use super::array::ArrayParameter;
use super::element::ElementSum;
use super::error::ParameterError;
use super::expression::{self, Named};
use super::missing;
use super::near::near;
use super::registry::Registry;
use super::velocity;
use crate::scene::Scene;
use crate::scene_vector::Tangent;

/// What a gradient can be asked for by one text.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// An array, by its name.
    Array(ArrayParameter),
    /// One number, by an expression.
    Tangent(Tangent),
}

/// An error if something would move or change infinitely fast: numbers that are finite can add up
/// to that. `what` moves so.
fn check_finite(tangent: &Tangent, what: impl FnOnce() -> String) -> Result<(), ParameterError> {
    match tangent.numbers().all(f64::is_finite) {
        true => Ok(()),
        false => Err(ParameterError::NotFinite { what: what() }),
    }
}

impl Registry {
    /// The motion of `scene` that an expression means: a parameter's name, or several
    /// with factors. See [the table](crate::params).
    pub fn tangent(&self, scene: &Scene, expression: &str) -> Result<Tangent, ParameterError> {
        let mut tangent = Tangent::zero(scene);
        let terms = expression::parse(self, expression).map_err(|error| match error {
            ParameterError::Unknown { name, .. } => self.unknown(scene, name),
            error => error,
        })?;
        let mut elements = ElementSum::default();
        for term in terms {
            match term.named {
                Named::Target(target) => {
                    velocity::accumulate(scene, target, term.factor, &mut tangent);
                }
                Named::Element(element) => {
                    elements.add(scene, element, term.factor, &mut tangent);
                }
            }
        }
        elements.add_to(scene, &mut tangent);
        check_finite(&tangent, || format!("the parameters in \"{expression}\""))?;
        Ok(tangent)
    }

    /// What a text asks for. A name that is both means the array: `<id>.value` is
    /// three numbers, `1*<id>.value` all of them together.
    pub fn request(&self, scene: &Scene, text: &str) -> Result<Request, ParameterError> {
        if let Some(array) = self.array(text.trim())? {
            return Ok(Request::Array(array.clone()));
        }
        self.tangent(scene, text).map(Request::Tangent)
    }

    /// What is wrong with a name that is no scalar's.
    fn unknown(&self, scene: &Scene, name: String) -> ParameterError {
        if self.has_array(&name) {
            return ParameterError::Array { name };
        }
        if let Some(reason) = missing::reason(scene, &name) {
            return ParameterError::NoParameter { name, reason };
        }
        let near = near(&name, self.all_names());
        ParameterError::Unknown { name, near }
    }
}
