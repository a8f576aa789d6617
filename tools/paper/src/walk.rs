//! The walks and fields that the paper compares its fixed-step walk with, the domain of its toy, and
//! its own domains beside the sphere, which the renderer walks on: the triangle that is met, and the
//! plane. The renderer uses none of them.

pub mod interval;
pub mod plane;
pub mod random_step;
pub mod triangle;
pub mod weighted_average;
