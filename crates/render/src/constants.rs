//! Numbers that make the estimators what they are, for renderers that take the same samples on other devices.

pub use crate::emitter_choice::{MANY as MANY_EMITTERS, UNIFORM as UNIFORM_EMITTERS};
pub use crate::far_rectangle::{FAR, LEAST_COSINE2, MOST_TILT};
pub use crate::film::FILM;
pub use crate::filter_table::BINS;
pub use crate::gathered_term::ROOTS;
pub use crate::light::{NARROW, UNIFORM_SKY};
pub use crate::plan::{BSDF_NUMBERS, EMITTER_NUMBERS, LENS};
pub use crate::radiance::{RR_MAX, RR_MIN};
pub use crate::sampled_edge_term::{SPREAD, subtree_count};
pub use crate::sampled_edges::{DIFFUSE_PIECE, IN_PLANE, LEAST_WEIGHT, MOST_PIECES, PIECE};
pub use crate::tracer::EDGE_NUMBERS;
