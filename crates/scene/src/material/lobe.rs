//! Materials that are not made of others, and lobes: the ways in which a surface
//! scatters light, as pure arithmetic, are the same with numbers in them. Each is
//! a file, of which `list.rs` has the list; `tests/lobes/table.rs` tests them.
//!
//! Formulas are those of Mitsuba 3's plugins of the same names. They differ in
//! five places: shadowing of Beckmann's facets is the integral and not a fit
//! to it (up to 0.35 % for each direction); refraction by facets that stand
//! upright fades out continuously (0.05 % of what a GGX surface of
//! roughness 0.3 transmits); the transmittance of rough coats is integrated
//! more exactly (0.1 %, for `eta` below 1 0.3 %); sheen is also on a
//! [`Principled`] of nothing but glass, as in Mitsuba's vectorised variants;
//! transmission by the facets of a [`PrincipledThin`] fades out continuously.
//!
//! A lobe has its numbers in it; its arithmetic knows nothing of textures, frames or faces.
//! All directions are unit vectors in the shading frame, normal `+z`, and point
//! away from the surface: `wi` to where the path comes from (the viewer), `wo`
//! to where it goes on (the light).
//!
//! ```
//! use capwalk_math::{Rgb, Vec3};
//! use capwalk_scene::lobe::{Diffuse, LocalBsdf, Lobe};
//! let mut bsdf = LocalBsdf::default();
//! bsdf.push(1.0, Lobe::Diffuse(Diffuse { reflectance: Rgb::splat(0.5) }));
//! let wi = Vec3::new(0.0, 0.6, 0.8);
//! let sample = bsdf.sample(wi, 0.3, [0.1, 0.7]).expect("a diffuse surface reflects everywhere");
//! let throughput = bsdf.eval(wi, sample.wo) / sample.pdf;
//! assert!((throughput.r - 0.5).abs() < 1e-12);
//! ```
//!
//! # Sides
//!
//! One-sided lobes, all that are not [two-sided](Lobe::is_two_sided), are seen
//! from the front: whether the face shows its front is for the caller to
//! decide, by [`LocalBsdf::seen_from`] or by not asking. Interpolated normals can
//! turn away from a face that is seen. Then `wi.z <= 0`, and one-sided lobes
//! answer for the direction mirrored at the surface, `(wi.x, wi.y, |wi.z|)`,
//! which is continuous where a black back would be a discontinuity that is on no edge.
//! [`Diffuse`] does not look at `wi`. They reflect to `wo.z > 0` only.
//!
//! Two-sided lobes take `wi.z < 0` for the inside, unless [`LocalBsdf::seen_from`]
//! says otherwise.
//!
//! # Derivatives
//!
//! `eval` and `specular` are continuous in directions and numbers, and smooth
//! but for these:
//!
//! * where total reflection begins, Fresnel's equations have an infinite derivative,
//!   seen from the denser side. It can be integrated; its square, the variance,
//!   only just not;
//! * [`RoughPlastic`] interpolates a table linearly in the cosine: kinks;
//! * a lobe of weight zero is only sampled with [`LocalBsdf::explored`], and parts of a
//!   [`Principled`] or [`PrincipledThin`] that it has none of only if they are
//!   [explored](Principled::explored).

pub mod branchless;
mod burley;
mod coat;
mod conductor;
mod dielectric;
mod diffuse;
mod diffuse_transmitter;
pub(super) mod event;
mod fresnel;
pub(super) mod list;
mod local;
mod local_bsdf;
pub(super) mod microfacets;
mod null;
mod plastic;
mod polarized_plastic;
mod principled;
mod principled_thin;
mod refraction;
mod rough_conductor;
mod rough_dielectric;
mod rough_plastic;
pub(super) mod rough_surface;
pub(super) mod rough_transmittance;
mod thin_dielectric;
mod tilt;
mod visible_facets;

pub use coat::LEAST_WEIGHT;
pub use event::{Event, Side, Specular};
pub use fresnel::{fresnel_conductor, fresnel_dielectric, fresnel_diffuse};
pub use list::*;
pub use local::{cosine_pdf, sample_cosine};
pub use local_bsdf::{BsdfDirection, BsdfSample, LocalBsdf};
pub use microfacets::{Distribution, MIN_ALPHA, Microfacets, Mirrored, SHADOWLESS};
pub use principled::Explored;
pub use principled_thin::ExploredThin;
pub use rough_surface::RoughSurface;
pub use rough_transmittance::{NODES, RoughTransmittance};
pub use tilt::Tilt;
