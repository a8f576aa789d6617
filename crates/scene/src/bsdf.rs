//! Materials. To add one: write its struct with `eval`, `sample` and `pdf` in
//! a file of its own under `bsdf/`, add a variant here, and follow the
//! compiler.

mod diffuse;

pub use diffuse::{BsdfSample, Diffuse};

use crate::scene::{BsdfId, Scene, SceneError};

/// A material and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name; parameters are `<id>.reflectance.value` and so on.
    pub id: String,
    /// What it does to light.
    pub bsdf: Bsdf,
}

/// What a surface does to light.
#[derive(Clone, Debug, PartialEq)]
pub enum Bsdf {
    /// Reflects equally to all directions, from its front side only.
    Diffuse(Diffuse),
    /// Has a front and a back.
    TwoSided {
        /// Material of the side that the normal points to.
        front: BsdfId,
        /// Material of the other side.
        back: BsdfId,
    },
}

impl Material {
    pub(crate) fn check(&self) -> Result<(), SceneError> {
        let Bsdf::Diffuse(diffuse) = &self.bsdf else {
            return Ok(());
        };
        let r = diffuse.reflectance;
        if !r.is_finite() || r.min(capwalk_math::Vec3::zero()) != capwalk_math::Vec3::zero() {
            return Err(SceneError::BadNumber {
                name: format!("{}.reflectance.value", self.id),
                value: format!("({}, {}, {})", r.x, r.y, r.z),
                expected: "finite numbers of at least 0",
            });
        }
        Ok(())
    }
}

/// The one-sided material that a surface shows, and on which side.
#[derive(Clone, Copy, Debug)]
pub struct Facing<'a> {
    /// Its id, for derivatives.
    pub id: BsdfId,
    /// The material; never two-sided.
    pub diffuse: &'a Diffuse,
    /// True if it is seen from the back: flip the normal.
    pub flipped: bool,
}

impl Scene {
    /// The material shown to a viewer on the side `cos_i` (positive: the side
    /// the shading normal points to), or `None` if that side is black.
    pub fn facing_bsdf(&self, id: BsdfId, cos_i: f64) -> Option<Facing<'_>> {
        let one_sided = |id: BsdfId, flipped: bool| match &self.material(id).bsdf {
            Bsdf::Diffuse(diffuse) => Some(Facing {
                id,
                diffuse,
                flipped,
            }),
            Bsdf::TwoSided { .. } => None,
        };
        match &self.material(id).bsdf {
            Bsdf::TwoSided { front, .. } if cos_i > 0.0 => one_sided(*front, false),
            Bsdf::TwoSided { back, .. } if cos_i < 0.0 => one_sided(*back, true),
            Bsdf::Diffuse(_) if cos_i > 0.0 => one_sided(id, false),
            _ => None,
        }
    }
}
