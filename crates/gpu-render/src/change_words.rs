//! The words that tell what changes, by their places: `changes.slang` says what each of them is.

/// Where the motion of the triangles is, or in reverse mode what is asked for of the shapes' vertices.
pub const MOTION_AT: usize = 0;
/// Whether boundaries move.
pub const BOUNDARIES_MOVE: usize = 1;
/// In reverse mode, how many units of a sum are one.
pub const UNITS: usize = 2;
/// Where the edges are.
pub const EDGES_AT: usize = 3;
/// Whether sampling may not know how fast these move.
pub const IS_BLIND: usize = 4;
/// In forward mode, where the changes of the camera's vectors are.
pub const CAMERA_CHANGE_AT: usize = 5;
/// In reverse mode, where the derivatives of the loss with respect to the pixels are.
pub const ADJOINT_AT: usize = 5;
/// Whether directions to surfaces move along a field.
pub const WALKS: usize = 6;
/// Of each texture, where its own numbers are.
pub const TEXTURE_CHANGES: usize = 7;
