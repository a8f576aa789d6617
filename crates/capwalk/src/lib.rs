//! capwalk computes unbiased derivatives of rendered images with respect to anything in a
//! scene, geometry above all. This crate is its public library: it loads scenes, renders,
//! differentiates, checks derivatives and runs inverse rendering; the command line and the
//! Python package are built on it.
//!
//! The light of a scene is discontinuous at shadows, silhouettes and their reflections. When
//! these move, the derivative of the image has a part that differentiated samples miss.
//! capwalk estimates it with walks on spherical caps or with points sampled on edges, without
//! bias and with standard errors.
//!
//! # The first gradient
//!
//! A scene is a Mitsuba 3 file or built in. These lines render the derivative of the
//! image of a floating leaf and its shadow with respect to a motion of the leaf, and
//! write it as an image in which red gets brighter and blue darker:
//!
//! ```
//! use capwalk::{GradientOptions, Prepared, Unwatched, write_image};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let folder = std::env::temp_dir();
//! let scene = capwalk::Loader::new("leaf").size([64, 48]).load()?.scene;
//! let prepared = Prepared::new(scene)?;
//! let options = GradientOptions { spp: 16, ..GradientOptions::default() };
//! let result = prepared.gradient("leaf.translate.x", &options, &Unwatched)?;
//! write_image(folder.join("gradient.png"), "gradient", &result.gradient.mean)?;
//! # Ok(())
//! # }
//! ```
//!
//! # Overview
//!
//! | | |
//! |---|---|
//! | [`load()`], [`Loader`] | a scene from a file, with warnings; another image size, values of `$name`s |
//! | [`Prepared`] | a scene prepared for any number of images and gradients |
//! | [`Views`] | the same for all sensors of a scene, and for AOVs |
//! | [`Prepared::render`] | an image with its standard errors |
//! | [`Device`] | where it is computed, a field of the options; on a GPU with the feature `gpu` |
//! | [`Prepared::gradient`] | the derivative of the image along one direction (forward mode) |
//! | [`Prepared::backward`] | the gradient of a loss with respect to all named parameters (reverse mode) |
//! | [`Prepared::loss`] | the loss between an image and a target, and the adjoint for `backward` |
//! | [`Prepared::check`] | a gradient against central differences, with a verdict |
//! | [`Prepared::update`], [`Prepared::update_scene`] | changes numbers of the scene, or the whole scene |
//! | [`Prepared::render_work`] and its like | the same in parts, for other processes or machines, merged to the same bits |
//! | [`optimize`] | inverse rendering from a TOML job, with checkpoints |
//! | [`scene`], [`scene::builtin`] | the scene description, and the built-in scenes |
//! | [`scene_io`] | scenes, images and arrays as files |
//!
//! Parameters have names: `"ball.translate.x"`, `"ball.positions"`,
//! `"floor.bsdf.reflectance.value"`; [`params`] lists those of a scene.
//!
//! # Guarantees
//!
//! * Every estimate has a standard error. A derivative that could only be estimated with
//!   a bias is refused: [`Error::Refused`].
//! * The same scene, options and seed give the same bits, whatever the number of threads. A
//!   chosen method is kept while the numbers of a scene change, see [`Prepared::choose`].
//!   Work runs on the caller's rayon pool, otherwise on one of the process; a forked child
//!   has its own.
//! * Long work takes a [`Watch`], which sees its progress and can stop it; [`Unwatched`] does
//!   neither.

/// The code of the project's front page.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct FrontPage;

mod backward;
mod check;
mod choices;
mod coplanar;
mod device;
mod direction;
mod edge_on;
mod error;
mod folder_error;
#[cfg_attr(not(feature = "gpu"), path = "no_gpu_work.rs")]
mod gpu_work;
mod images;
mod load;
mod loss;
mod method;
// Tests of a build with the GPU compile and try what one without it has.
#[cfg(all(test, feature = "gpu"))]
mod no_gpu_work;
pub mod optimize;
mod options;
mod prepared;
mod setting;
#[cfg(feature = "gpu")]
mod shared_gpu;
mod step;
pub mod text;
mod views;

pub use capwalk_diff::check::{Comparison, Verdict, compare};
pub use capwalk_diff::{
    Accumulate, BatchSums, Cell, Chosen, Device, Dips, Estimate, Estimator, Gathers, GradientImage,
    GradientOptions, GradientWork, Grid, KeptChoice, Method, Part, PartError, Partial, PixelSums,
    Refusal, RenderOptions, RenderWork, Rendering, Seed, Statistics, Stencil, Trial, Unwatched,
    UsedDevice, WalkSettings, Watch, with_threads,
};
pub use capwalk_math::{Rgb, Vec3};
pub use capwalk_scene::params::{self, ParameterError, vertex_tangent};
pub use capwalk_scene::{
    Film, Filter, Gradient, Image, Integrator, Mesh, MeshError, Scene, SceneError, Sensor,
    SensorVectors, Shape, ShapeVectors, Tangent, Texture,
};
pub use capwalk_scene_io::export::ExportError;
pub use capwalk_scene_io::image::ImageError;
pub use capwalk_scene_io::{
    Diagnostic, FilesRead, InputInTheWay, LoadError, Loaded, NotVelocities, SensorChoice,
    SensorSettings, VelocityFileError, Warning, read_velocities,
};

// What a command line or another face needs besides.
pub use capwalk_scene as scene;
pub use capwalk_scene_io as scene_io;

pub use backward::{GradientNames, Gradients, GradientsWork, ParameterGradient};
pub use check::{
    Check, CheckOptions, Reference, comparison_text, coplanar_text, edge_on_text, touching_text,
};
pub use device::DeviceFailure;
pub use direction::Direction;
pub use edge_on::EdgeOnFace;
pub use error::{Error, UnusableImage};
pub use folder_error::FolderError;
pub use images::{read_layer, read_mask, write_image};
pub use load::{Loader, load};
pub use loss::{Distance, ImageLoss, Loss, Measured};
pub use method::{Caveat, Choice, MethodChoice, MethodName, OptionError, WalkChoice, caveat};
pub use options::DifferenceOptions;
pub use prepared::{Prepared, Values};
pub use setting::{NotASetting, Setting};
pub use step::bounds;
pub use views::{ViewId, Views};
