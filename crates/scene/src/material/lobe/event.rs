//! What a surface can do to a path, and the side of it that is seen.

use capwalk_math::{Real, Vec3};

/// The side of a surface that is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The normal of the face points to the viewer.
    Front,
    /// It points away.
    Back,
}

impl Side {
    /// The direction, or its mirror image, that is on this side of the surface.
    #[inline]
    pub(super) fn put<R: Real>(self, w: Vec3<R>) -> Vec3<R> {
        // What is seen along the surface is on no side: put on the right one.
        const MIN_COS: f64 = 1e-12;
        let mut height = w.z.abs();
        if height.value() < MIN_COS {
            height = R::constant(MIN_COS);
        }
        let z = match self {
            Side::Front => height,
            Side::Back => -height,
        };
        Vec3::new(w.x, w.y, z)
    }
}

/// What a perfectly specular surface can do to a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// It goes back to its side, as from a mirror.
    Reflect,
    /// It is refracted to the other side.
    Transmit,
    /// It goes straight on.
    Pass,
}

/// A perfectly specular event at a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Specular {
    /// The place of the lobe, in the order of [`push`](super::LocalBsdf::push).
    pub lobe: usize,
    /// What it does.
    pub event: Event,
}

/// What a lobe drew.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Drawn {
    /// A direction with a density.
    Smooth(Vec3),
    /// A perfectly specular event and its probability.
    Specular(Event, f64),
}
