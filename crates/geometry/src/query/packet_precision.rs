//! What single precision resolves of packets: lengths in the tree's coordinates.

/// Distance from a plane, in units of the tree's half size, up to which a point lies in it: several
/// times what heights of points are typically off by.
pub const IN_PLANE: f32 = 1.0 / (1 << 20) as f32;

/// By how much boxes are larger: corners of triangles that are larger by [`IN_PLANE`] at their
/// sides are farther out, the sharper they are.
pub const BOX_MARGIN: f32 = 64.0 * IN_PLANE;

/// How far corners are moved out at most, over [`IN_PLANE`]: triangles with sharper ones are larger
/// by less.
pub const MOST_OUT: f64 = 60.0;
