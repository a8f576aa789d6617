//! The trees against brute force.

mod meshes;
mod rays;
mod silhouettes;
mod wedges;
