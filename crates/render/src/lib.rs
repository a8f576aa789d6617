//! How radiance is estimated: one path tracer, generic over the scalar.
//!
//! Over `f64` a sample of a [`Tracer`] is one of the image ([`render`]); over numbers
//! that carry derivatives, the same code follows the moving path and gives the
//! derivative (the crate `capwalk-diff`). What it asks of a scene is a [`SceneEval`].
//! Every estimate comes with a standard error per pixel, and is the same to the bit for
//! the same scene, seed and options, whatever the number of threads.
//!
//! Nothing here opens a file, prints, or reads the clock.

pub mod adaptive;
mod aov;
mod average_elsewhere;
mod camera;
mod direct_edge_term;
mod emitter_choice;
mod emitter_edge_term;
mod emitter_sampler;
mod estimate;
mod film;
mod gathered_term;
mod grid;
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
mod pixel;
mod pixel_silhouette_term;
mod pixel_silhouettes;
mod plan;
mod prepared;
mod radiance;
mod rectangle_sampler;
mod sample_range;
mod sampled_edge_term;
mod sampled_edges;
mod scene_eval;
mod seed;
mod shading;
mod specular_probe;
mod specular_search;
mod surface;
mod surroundings;
pub mod tiles;
mod tracer;
mod triangle_sampler;
mod uncovered_events;
mod vertex;
mod visible_motion;

pub use average_elsewhere::average_elsewhere;
pub use capwalk_geometry::Halted;
pub use emitter_sampler::{DirectionSampler, EmitterSampler};
pub use estimate::{Estimate, GradientImage, Missing, Rendering, Statistics};
pub use grid::{Cell, Grid, Part};
pub use image::{RenderWork, render};
pub use motion_facts::MotionFacts;
pub use options::{RenderOptions, Silent, Unwatched, Watch};
pub use ordered_sum::{Accumulate, CannotMerge, OrderedSum};
pub use part_error::PartError;
pub use partial::{Along, Partial};
pub use pixel::Supports;
pub use pixel_silhouette_term::{CameraEdge, TooManyImages};
pub use plan::{FIRST_VERTEX, LightSampling, Plan};
pub use prepared::PreparedScene;
pub use radiance::{Emitted, SpecularChain};
pub use rectangle_sampler::RectangleSampler;
pub use sample_range::SampleRange;
pub use scene_eval::{Primal, SceneEval, Warped, vertex_normal};
pub use seed::{Purpose, Seed};
pub use specular_probe::{ProbedMotion, SpecularProbe};
pub use surroundings::Surroundings;
pub use tiles::PixelSums;
pub use tracer::{LeavesOut, Moving, SurfaceWalks, Tracer, Walks};
pub use triangle_sampler::TriangleSampler;
pub use uncovered_events::UncoveredEvents;
pub use vertex::Vertex;
