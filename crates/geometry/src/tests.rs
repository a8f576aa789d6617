//! The trees against brute force.

mod buffers;
mod bundles;
mod meshes;
mod packets;
mod rays;
mod shadows;
mod silhouettes;
mod spheres;
mod wedges;
