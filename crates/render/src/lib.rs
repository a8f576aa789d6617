//! The path tracer, written once and generic over the scalar. Over `f64` it renders images with a
//! standard error per pixel ([`render`]); over numbers that carry derivatives, the same code
//! follows moving paths, for the crate `capwalk-diff`.
//!
//! A [`Tracer`] takes samples and asks a [`SceneEval`] for the numbers of the scene. Results are
//! the same to the bit for the same scene, seed and options, whatever the number of threads. The
//! crate opens no file, prints nothing, and does not read the clock.

pub mod adaptive;
mod aov;
mod average_on_device;
mod beside_silhouettes;
mod camera;
mod chain;
mod chain_field;
mod chain_survey;
mod chains;
pub mod constants;
mod device;
mod direct_edge_term;
mod emitter_choice;
mod emitter_edge_term;
mod emitter_sampler;
mod estimate;
mod far_rectangle;
mod film;
mod filter_table;
mod gathered_term;
mod grid;
mod half_vector;
mod highlight;
mod image;
mod indirect_edge_term;
mod lanes;
mod light;
mod motion_facts;
mod options;
mod ordered_sum;
mod part_error;
mod partial;
mod path_adjoint;
mod pixel;
mod pixel_silhouette_term;
mod pixel_silhouettes;
mod plan;
mod prepared;
mod radiance;
mod receiver;
mod rectangle_sampler;
mod sample_range;
mod sampled_edge_term;
mod sampled_edges;
mod scene_eval;
mod seed;
mod shading;
mod still;
mod surface;
mod surroundings;
pub mod tiles;
mod tracer;
mod triangle_sampler;
mod vertex;

pub use average_on_device::average_on_device;
pub use capwalk_geometry::Halted;
pub use device::{Device, UsedDevice};
pub use emitter_sampler::{DirectionSampler, EmitterSampler};
pub use estimate::{Dips, Estimate, Rendering, Statistics};
pub use grid::{Cell, Grid, Part};
pub use image::{RenderWork, render, take_light};
pub use lanes::{Differentiator, LaneTracer, RayPrecision};
pub use motion_facts::MotionFacts;
pub use options::{RenderOptions, Silent, Unwatched, Watch};
pub use ordered_sum::{Accumulate, CannotMerge, OrderedSum};
pub use part_error::PartError;
pub use partial::{Along, Partial};
pub use path_adjoint::PathAdjoint;
pub use pixel::Supports;
pub use pixel_silhouette_term::{CameraEdge, TooManyImages};
pub use plan::{FIRST_VERTEX, LightSampling, Plan};
pub use prepared::PreparedScene;
pub use radiance::{Arrival, Emitted, SpecularChain};
pub use receiver::Receiver;
pub use rectangle_sampler::RectangleSampler;
pub use sample_range::{SamplePlace, SampleRange};
pub use scene_eval::{Primal, SceneEval, Warped, vertex_normal};
pub use seed::{Purpose, Seed};
pub use surroundings::Surroundings;
pub use tiles::PixelSums;
pub use tracer::{Moving, SurfaceWalks, Tracer, Walks};
pub use triangle_sampler::TriangleSampler;
pub use vertex::Vertex;
