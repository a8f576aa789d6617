//! What a caller can choose, and how it can follow and stop the work.

use capwalk_walk::WalkSettings;

/// How much to sample, and with which random numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Samples per pixel, at least 1 (at least 2 for a standard error).
    pub spp: u32,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Worker threads; `None` takes all cores. Changes no bit of the result.
    pub threads: Option<usize>,
}

/// How to estimate a gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GradientOptions {
    /// How much to sample.
    pub options: Options,
    /// What makes up for the jumps of the integrand.
    pub method: Method,
    /// The walk that builds the velocity field, for methods that walk.
    pub walk: WalkSettings,
}

impl GradientOptions {
    /// The default method and walk.
    pub fn new(options: Options) -> Self {
        Self {
            options,
            method: Method::default(),
            walk: WalkSettings::default(),
        }
    }
}

/// How the derivative of an integrand that jumps is estimated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Method {
    /// A velocity field by walks on spherical caps, around every point that
    /// light arrives at. Unbiased.
    #[default]
    Walk,
    /// The same on the triangle that each direction meets, where the field is
    /// relative to the material: the paper to the letter. Borders of triangles
    /// limit its walks, in the place of `max_radius`, which is left for directions
    /// that meet nothing. Unbiased; images in mirrors are not covered.
    TriangleWalk,
    /// The same with a walk on disks in the triangle's plane, among all silhouettes
    /// projected on it: unbiased, and so slow that scenes of many edges are refused.
    ExplicitWalk,
    /// Directions towards lamps, and those of a camera that sees through no flat
    /// mirror or pane and whose rays are not parallel, stay at rest, and points are
    /// drawn on all edges that move across them; elsewhere like [`Method::Walk`].
    /// Unbiased.
    Edges,
    /// Warped-area sampling (Bangaru et al. 2020), a baseline. Biased, less with
    /// more auxiliary rays; what is seen in mirrors is not covered.
    Was(WasSettings),
    /// The same on the triangle that each direction meets, relative to its material
    /// (Xu et al. 2023).
    PsdrWas(WasSettings),
}

impl Method {
    /// Its name in files and on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Walk => "walk",
            Self::TriangleWalk => "walk, domain triangle",
            Self::ExplicitWalk => "walk, domain explicit",
            Self::Edges => "edges",
            Self::Was(_) => "was",
            Self::PsdrWas(_) => "psdr-was",
        }
    }

    /// True if the method promises the truth: what it does not cover is refused.
    pub fn is_unbiased(&self) -> bool {
        match self {
            Self::Walk | Self::Edges | Self::TriangleWalk | Self::ExplicitWalk => true,
            Self::Was(_) | Self::PsdrWas(_) => false,
        }
    }
}

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

/// Boundary tests of warped-area sampling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WasBoundary {
    /// Normals across the view: for smooth surfaces. Flat faces end without it,
    /// and their outlines are missed.
    Normals,
    /// The nearest edge of the triangle: right for all meshes, noisy at every
    /// edge.
    Edges,
}

/// Follows the work and may stop it. Called from worker threads.
pub trait Watch: Sync {
    /// `done` of `total` units of work are finished.
    fn progress(&self, done: u64, total: u64);
    /// True if the work should stop soon; what is done is returned, with its
    /// real sample counts.
    fn should_stop(&self) -> bool;
}

/// Nobody watches.
pub struct Unwatched;

impl Watch for Unwatched {
    fn progress(&self, _done: u64, _total: u64) {}
    fn should_stop(&self) -> bool {
        false
    }
}

/// Why a derivative is refused, and what to do instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// A full sentence or two for the user.
    pub reason: String,
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.reason)
    }
}

impl std::error::Error for Refusal {}
