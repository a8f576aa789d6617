//! What moves: a direction in the space of all parameters of a scene.

use std::borrow::Cow;

use capwalk_scene::params::{Registry, check_finite};
use capwalk_scene::{Scene, Tangent};

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
        let what = || "the parameters and velocities".into();
        if is_zero(self) {
            return Err(Error::NothingMoves { what: what() });
        }
        check_finite(self, what)?;
        Ok(Cow::Borrowed(self))
    }
}

/// True if nothing moves or changes.
pub(crate) fn is_zero(tangent: &Tangent) -> bool {
    tangent.numbers().all(|velocity| velocity == 0.0)
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

    /// An infinite velocity makes no sample that could be counted as such.
    #[test]
    fn infinite_directions_are_refused() {
        let scene = capwalk_scene::builtin::scene("ball").expect("built in");
        let registry = Registry::new(&scene);
        let fast = registry.tangent(&scene, "1e308*ball.translate.x");
        let mut sum = fast.expect("a number");
        sum.add(&sum.clone());
        let error = sum.tangent(&scene, &registry).expect_err("infinite");
        assert!(error.to_string().contains("infinite velocity"), "{error}");
    }
}
