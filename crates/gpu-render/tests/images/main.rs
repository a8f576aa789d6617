//! Images of the device beside the CPU's. On a machine without an adapter the tests say so
//! and pass; with `CAPWALK_GPU_TESTS=require` they fail there.

mod agreement;
mod beside;
mod camera;
mod camera_edges;
mod derivatives;
mod device;
mod edges;
mod faults;
mod folders;
mod materials;
mod motion;
mod parts;
mod scenes;
mod unsupported;
mod walks;
