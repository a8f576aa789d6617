//! What the command line can do, one file each. Every `run` says how it ended;
//! an error is bad input or a refusal.

pub mod backward;
pub mod check;
pub mod compare;
pub mod demo;
pub mod gradient;
pub mod info;
pub mod optimize;
pub mod render;
pub mod scenes;
