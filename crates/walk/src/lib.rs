//! Fixed-step walks (Algorithms 6 and 7) that estimate a velocity field and its divergence. The
//! field is continuous on the whole domain and equals the velocity of its boundary, such as the
//! silhouettes on a sphere of directions.
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
//! (Algorithms 6 and 7).
//!
//! Nothing here knows about light.

pub mod domain;
pub mod field;
pub mod fixed_step;
pub mod sphere;

pub use domain::{Domain, Nearest, Vector};
pub use field::{FieldSample, Term};
pub use fixed_step::{Estimator, WalkSettings, sample_field, sample_value};
pub use sphere::Sphere;
