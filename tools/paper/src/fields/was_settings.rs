//! Settings of the baselines.

use capwalk_boundary::Refusal;

/// How warped-area sampling makes its field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WasSettings {
    /// `κ`, concentration of the auxiliary rays: they are about `1/√κ` radians
    /// away, and so is the field's reach.
    pub kappa: f64,
    /// Auxiliary rays per direction.
    pub rays: u32,
    /// Which places count as near silhouettes.
    pub boundary: WasBoundary,
    /// Every second auxiliary ray is opposite to the one before it.
    pub antithetic: bool,
    /// Random numbers of auxiliary rays, without bias: about three times as many,
    /// and noisier.
    pub debias: bool,
}

impl Default for WasSettings {
    fn default() -> Self {
        Self {
            kappa: 1e5,
            rays: 8,
            boundary: WasBoundary::Edges,
            antithetic: true,
            debias: false,
        }
    }
}

impl WasSettings {
    /// A refusal without auxiliary rays, or if their concentration is not a positive number.
    pub(super) fn check(&self) -> Result<(), Refusal> {
        let Self { rays, kappa, .. } = *self;
        match rays > 0 && kappa > 0.0 && kappa.is_finite() {
            true => Ok(()),
            false => Err(Refusal::Custom {
                reason: format!(
                    "warped-area sampling with {rays} auxiliary rays of concentration {kappa}; \
                     expected at least one ray and a finite concentration above 0"
                ),
                instead: None,
            }),
        }
    }
}

/// Boundary tests of warped-area sampling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WasBoundary {
    /// Normals across the view: for smooth surfaces. Flat faces end without it,
    /// and their silhouettes are missed.
    Normals,
    /// The nearest edge of the triangle: right for all meshes, noisy at every
    /// edge.
    Edges,
}
