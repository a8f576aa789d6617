//! Unbiased derivatives of rendered images.

mod backward;
mod check;
mod direction;
mod engine;
mod error;
mod folder_error;
mod images;
mod load;
mod loss;
mod method;
pub mod optimize;
mod options;
mod prepared;
mod step;

pub use capwalk_math::{Rgb, Vec3};
pub use capwalk_render::check::{Comparison, Verdict, compare};
pub use capwalk_render::{
    Estimate, Estimator, GradientImage, Method, Refusal, Rendering, Statistics, Unwatched,
    WalkSettings, WasBoundary, WasSettings, Watch,
};
pub use capwalk_scene::params::{ParameterError, vertex_motion};
pub use capwalk_scene::{Filter, Image, Motion, Scene, SceneError};
pub use capwalk_scene_io::{LoadError, VelocityFileError, read_velocities};

pub use backward::{GradientNames, Gradients, ParameterGradient};
pub use check::{Check, CheckOptions, Reference};
pub use direction::Direction;
pub use error::{Error, UnusableImage};
pub use images::{read_layer, read_mask};
pub use load::{Loaded, Loader, load};
pub use loss::{Distance, ImageLoss, Loss, Measured};
pub use method::{
    Caveat, Choice, DomainName, MethodChoice, MethodName, OptionError, WalkChoice, WasChoice,
    caveat,
};
pub use options::{DifferenceOptions, GradientOptions, RenderOptions};
pub use prepared::{Prepared, Values};
pub use capwalk_scene::params;
pub use step::{bounds, difference_step};
