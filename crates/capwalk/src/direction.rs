//! What moves: a direction in the space of all parameters of a scene.

use std::borrow::Cow;

use capwalk_scene::params::Registry;
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
        check(&tangent, || parameters(self))?;
        Ok(Cow::Owned(tangent))
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
        check(self, || VELOCITIES.into())?;
        Ok(Cow::Borrowed(self))
    }
}

/// The velocities of numbers of a scene, per unit of the parameter, whose derivatives can be computed.
/// Variances are their squares, and standard errors of variances the squares of these: the root of the
/// root of the largest number is 1e77, and a margin is left for what is not 1 in a scene.
const RATES: std::ops::RangeInclusive<f64> = 1e-70..=1e70;

/// What a tangent without a name is about, in words.
pub(crate) const VELOCITIES: &str = "the parameters and velocities";

/// What an expression is about, in words.
pub(crate) fn parameters(expression: &str) -> String {
    format!("the parameters in \"{expression}\"")
}

/// An error if nothing moves or changes, or so slowly or fast that its derivative is no number; with
/// what moves.
pub(crate) fn check(tangent: &Tangent, what: impl FnOnce() -> String) -> Result<(), Error> {
    match largest(tangent) {
        0.0 => Err(Error::NothingMoves { what: what() }),
        rate if RATES.contains(&rate) => Ok(()),
        rate => Err(Error::Unscaled { what: what(), rate }),
    }
}

/// The largest velocity of a number; NaN if one is.
fn largest(tangent: &Tangent) -> f64 {
    tangent.numbers().fold(0.0, |largest: f64, x| {
        match largest.is_nan() || x.is_nan() {
            true => f64::NAN,
            false => largest.max(x.abs()),
        }
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

    /// Variances of derivatives that small or large are no numbers: they were called exact.
    #[test]
    fn factors_without_measure_are_refused() {
        let scene = capwalk_scene::builtin::scene("ball").expect("built in");
        let registry = Registry::new(&scene);
        for factor in ["1e-300", "1e-90", "1e90", "1e300"] {
            for name in [
                "ball.translate.x",
                "sensor.rotate.y",
                "floor.bsdf.reflectance.value",
            ] {
                let expression = format!("{factor}*{name}");
                let error = expression.tangent(&scene, &registry);
                let error = error.expect_err("out of range").to_string();
                assert!(
                    error.contains(&expression) && error.contains("another factor"),
                    "{error}"
                );
            }
        }
        for good in [
            "1e-60*ball.scale",
            "1e60*ball.scale",
            "ball.scale + 1e-300*ball.translate.x",
        ] {
            assert!(good.tangent(&scene, &registry).is_ok(), "{good}");
        }
    }
}
