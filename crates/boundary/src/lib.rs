//! The discontinuities of the integrand of light transport, seen from a point, and velocity fields
//! that follow them (METHOD 1 to 3): silhouettes, open edges, creases, crossings of faces, lines of
//! textures, hard shadows, and their mirror images.
//!
//! [`Accel`] is a scene prepared for rays, [`Boundaries`] are all its edges that may be
//! discontinuities. A [`Viewpoint`] says which of them count around a point, and a [`Field`]
//! samples how a direction from there moves with them, by one of the [`Method`]s or by a
//! [`CustomField`] of your own.
//!
//! The crate uses neither velocities nor light: a sample is a [`Warp`], a linear map from the
//! velocities of a few points that serves forward and, transposed, reverse mode (METHOD 5). What
//! cannot be differentiated without bias is refused by [`refuse`].

mod accel;
mod beside;
mod boundaries;
mod boundary_sample;
mod clip;
mod coincident;
mod crossing;
mod custom_field;
mod draw;
mod edge_sampler;
mod edge_visibility;
mod emitter_edge;
mod field;
mod flow;
mod flush_emitter;
mod image_space;
mod infinite_derivative;
mod material;
mod method;
mod mirror;
mod mirror_image;
mod mirror_planes;
mod motion;
mod passing;
pub mod pool;
mod random;
mod reach;
mod reflected;
mod refusal;
pub mod refuse;
mod sampled_edge;
mod shading;
mod shadow_line;
mod silhouette_pieces;
mod texture_line;
mod touching;
mod viewpoint;
mod walk;
mod warp;
mod window;

pub use accel::{Accel, MeshChange, bounded_ray};
pub use beside::{BESIDE, beside};
pub use boundaries::{Boundaries, same_edges};
pub use boundary_sample::BoundarySample;
pub use crossing::{Crossing, CrossingEnd};
pub use custom_field::CustomField;
pub use draw::{Counts, Draw, Numbers};
pub use edge_sampler::{Counted, EdgeBounds, EdgeSampler, Subtree};
pub use emitter_edge::EmitterEdge;
pub use field::Field;
pub use flow::{Flow, FlowSource};
pub use material::{
    FlatEvents, bends_images, flat_events, may_be_specular, needs_place, needs_tangent,
    tangents_of_face,
};
pub use method::{Gathers, Method, MethodTraits};
pub use mirror::{MAX_EVENTS, Mirrors};
pub use mirror_image::{DrawnImage, MirrorImage, moving_apex, moving_image};
pub use mirror_planes::MirrorPlanes;
pub use motion::Motion;
pub use passing::Leaving;
pub use random::{GOLDEN, MIXERS, PixelStreams, Sampler, Stream, Streams};
pub use reach::MovingBoundaries;
pub use reflected::SAME_MIRROR;
pub use refusal::Refusal;
pub use silhouette_pieces::{EdgePoint, PARALLEL, SilhouettePieces, clip, place};
pub use touching::touching;
pub use viewpoint::{CREASED, EMITTED, ROUND, SEEN, SMOOTH, Viewpoint, Visibility};
pub use walk::{direct_sphere, seen_by_chains};
pub use warp::{Dependence, Warp};
pub use window::{AreaEmitter, Extent, MANY_CORNERS, Window};
