//! Light sources.

use capwalk_math::Rgb;

use crate::scene::{EmitterId, Scene, SceneError, ShapeId};

/// A light source.
#[derive(Clone, Debug, PartialEq)]
pub enum Emitter {
    /// A shape that emits the same radiance from every point of its front,
    /// in every direction.
    Area {
        /// The shape.
        shape: ShapeId,
        /// What it emits.
        radiance: Rgb,
    },
    /// The same radiance from every direction that meets no shape.
    Constant {
        /// Name of the emitter, for parameters.
        id: String,
        /// What it emits.
        radiance: Rgb,
    },
}

impl Emitter {
    /// What it emits.
    #[inline]
    pub fn radiance(&self) -> Rgb {
        match self {
            Self::Area { radiance, .. } | Self::Constant { radiance, .. } => *radiance,
        }
    }

    /// What it emits, to be changed.
    pub fn radiance_mut(&mut self) -> &mut Rgb {
        match self {
            Self::Area { radiance, .. } | Self::Constant { radiance, .. } => radiance,
        }
    }

    /// True if it surrounds the scene.
    pub fn is_environment(&self) -> bool {
        matches!(self, Self::Constant { .. })
    }

    /// The name of its radiance parameter: `<shape>.emitter.radiance.value`
    /// or `<id>.radiance.value`.
    pub fn parameter_name(&self, scene: &Scene) -> String {
        match self {
            Self::Area { shape, .. } => {
                format!("{}.emitter.radiance.value", scene.shape(*shape).id)
            }
            Self::Constant { id, .. } => format!("{id}.radiance.value"),
        }
    }

    pub(crate) fn check(&self, scene: &Scene, id: EmitterId) -> Result<(), SceneError> {
        if let Self::Area { shape, .. } = self {
            debug_assert_eq!(scene.shape(*shape).emitter, Some(id));
        }
        let r = self.radiance();
        if !r.is_finite() || r.min(Rgb::zero()) != Rgb::zero() {
            return Err(SceneError::BadNumber {
                name: self.parameter_name(scene),
                value: format!("({}, {}, {})", r.x, r.y, r.z),
                expected: "finite numbers of at least 0",
            });
        }
        Ok(())
    }
}
