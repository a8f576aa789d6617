//! What moves: a direction in the space of all parameters of a scene.

use std::borrow::Cow;

use capwalk_math::Vec3;
use capwalk_scene::params::Registry;
use capwalk_scene::{EmitterVectors, Scene, SensorVectors, Tangent};

use crate::error::Error;

/// What an image can be differentiated along: an expression such as
/// `"ball.translate.x"` or `"lamp.translate.x - 0.5*floor.rotate.z"`, or a [`Tangent`]
/// that was made by hand.
pub trait Direction {
    /// The velocities that are meant in this scene, whose names are in the registry; not
    /// all of them are zero.
    fn tangent(&self, scene: &Scene, registry: &Registry) -> Result<Cow<'_, Tangent>, Error>;

    /// The expression, if it is one. The method that is chosen for it is kept by this name, see
    /// [`Prepared::choose`](crate::Prepared::choose); for other directions each call chooses.
    fn name(&self) -> Option<&str> {
        None
    }
}

impl Direction for str {
    fn tangent(&self, scene: &Scene, registry: &Registry) -> Result<Cow<'_, Tangent>, Error> {
        let tangent = registry.tangent(scene, self)?;
        match is_zero(&tangent) {
            false => Ok(Cow::Owned(tangent)),
            true => Err(Error::NothingMoves {
                what: format!("the parameters in \"{self}\""),
            }),
        }
    }

    fn name(&self) -> Option<&str> {
        Some(self)
    }
}

impl Direction for String {
    fn tangent(&self, scene: &Scene, registry: &Registry) -> Result<Cow<'_, Tangent>, Error> {
        self.as_str().tangent(scene, registry)
    }

    fn name(&self) -> Option<&str> {
        Some(self)
    }
}

impl Direction for Tangent {
    fn tangent(&self, _: &Scene, _: &Registry) -> Result<Cow<'_, Tangent>, Error> {
        match is_zero(self) {
            false => Ok(Cow::Borrowed(self)),
            true => Err(Error::NothingMoves {
                what: "the parameters and velocities".into(),
            }),
        }
    }
}

/// True if nothing moves or changes.
pub(crate) fn is_zero(tangent: &Tangent) -> bool {
    let mut shapes = tangent.shapes.iter().flatten();
    let mut numbers = tangent.textures.iter().flatten().flatten();
    let mut lights = tangent.emitters.iter();
    tangent.sensor == SensorVectors::default()
        && lights.all(|light| *light == EmitterVectors::default())
        && numbers.all(|&v| v == 0.0)
        && shapes.all(|shape| {
            let mut velocities = shape.vertices.iter().chain(shape.normals.iter().flatten());
            velocities.all(|&velocity| velocity == Vec3::zero())
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Also normals that turn where nothing moves.
    #[test]
    fn sums_that_cancel_are_refused() {
        let scene = capwalk_scene::builtin::scene("ball").expect("built in");
        let registry = Registry::new(&scene);
        assert!("ball.normals[7,2]".tangent(&scene, &registry).is_ok());
        for nothing in ["0*ball.normals[7,2]", "ball.scale - ball.scale"] {
            let error = nothing
                .tangent(&scene, &registry)
                .expect_err("zero")
                .to_string();
            assert!(error.contains("nothing changes"), "{error}");
        }
    }
}
