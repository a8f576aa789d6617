//! The trees against brute force.

mod buffers;
mod meshes;
mod rays;
mod silhouettes;
mod wedges;
