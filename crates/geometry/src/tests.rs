//! The trees against brute force.

mod buffers;
mod meshes;
mod packets;
mod rays;
mod silhouettes;
mod wedges;
