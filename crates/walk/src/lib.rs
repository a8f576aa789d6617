//! Fixed-step walks that build continuous velocity fields.
//!
//! A boundary (silhouettes on the sphere of directions, edges of a polygon,
//! the ends of an interval) moves with a known velocity. The walk extends that
//! velocity to a field over the whole domain that is continuous and agrees
//! with the boundary, and differentiates it. The result does not contain the
//! velocities: it is linear in them, so it names boundary points and the
//! weights and covectors on them ([`FieldSample`]). Whoever knows the motion
//! sums them up; whoever wants the adjoint scatters them.
//!
//! The algorithm is written once over a [`Domain`]: [`Sphere`] walks on caps
//! (Algorithms 6 and 7), [`Triangle`] on the part of it that shows a triangle,
//! [`Plane`] on disks (Algorithms 2 to 4), [`Interval`] is the toy of Section
//! 3.3. Beside the fixed-step walk stand what it replaces: the walk of random
//! length ([`random_step`]) and, for the toy, the weighted average of earlier
//! work ([`weighted_average`]).
//!
//! Nothing here knows about light.

pub mod domain;
pub mod field;
pub mod fixed_step;
pub mod interval;
pub mod plane;
pub mod random_step;
pub mod sphere;
pub mod triangle;
pub mod weighted_average;

pub use domain::{Domain, Nearest, Vector};
pub use field::{FieldSample, Term};
pub use fixed_step::{Estimator, WalkSettings, sample_field, sample_value};
pub use interval::Interval;
pub use plane::Plane;
pub use random_step::{Arrival, ShellSettings, sample_harmonic};
pub use sphere::Sphere;
pub use triangle::{Triangle, TriangleBoundary};
pub use weighted_average::WeightedAverage;
