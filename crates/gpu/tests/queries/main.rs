//! Every query on the device against brute force on the CPU, and what happens where
//! the device cannot. On a machine without an adapter the tests say so and pass; with
//! `CAPWALK_GPU_TESTS=require` they fail there.

mod adapter;
mod faults;
mod meshes;
mod rays;
mod refit;
mod silhouettes;
