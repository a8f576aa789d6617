//! The walks and fields that the paper compares its fixed-step walk with, and the
//! domain of its toy. The renderer uses none of them.

pub mod interval;
pub mod random_step;
pub mod weighted_average;
