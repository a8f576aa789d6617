//! Frames of the lobes of lanes.

use capwalk_geometry::simd::{Computation, Simd};
use capwalk_math::{Frame, Vec3};

use crate::lanes::step::Vertices;
use crate::lanes::vectors::{LANES, Vectors};

/// The frames in which the lobes of surfaces are, and there the directions to the viewer.
#[derive(Debug)]
pub struct LaneFrames {
    s: Vectors,
    t: Vectors,
    /// The normal on the side of the front.
    n: Vectors,
    pub wi: Vectors,
}

impl LaneFrames {
    /// None yet.
    pub const NONE: Self = Self {
        s: Vectors::ZERO,
        t: Vectors::ZERO,
        n: Vectors::ZERO,
        wi: Vectors::ZERO,
    };

    /// That of a lane.
    #[inline(always)]
    pub fn get(&self, lane: usize) -> Frame {
        Frame {
            s: self.s.get(lane),
            t: self.t.get(lane),
            n: self.n.get(lane),
        }
    }

    /// Sets that of a lane, from one around the outward normal.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, mut frame: Frame, side: f64, direction: Vec3) {
        frame.n = frame.n * side;
        self.s.set(lane, frame.s);
        self.t.set(lane, frame.t);
        self.n.set(lane, frame.n);
        self.wi.set(lane, frame.to_local(-direction));
    }
}

/// Finds those of lobes that do not turn with texture coordinates.
pub struct FindFrames<'a> {
    pub vertices: &'a Vertices,
    pub frames: &'a mut LaneFrames,
}

impl Computation for FindFrames<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        find_frames(self.vertices, self.frames);
    }
}

#[inline(always)]
fn find_frames(vertices: &Vertices, frames: &mut LaneFrames) {
    for lane in 0..LANES {
        let frame = Frame::from_normal(vertices.outward.get(lane));
        let direction = vertices.direction.get(lane);
        frames.set(lane, frame, vertices.side[lane], direction);
    }
}

/// Brings directions of the world into the frames.
pub struct ToLocal<'a> {
    pub frames: &'a LaneFrames,
    pub directions: &'a mut Vectors,
}

impl Computation for ToLocal<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        to_local(self.frames, self.directions);
    }
}

#[inline(always)]
fn to_local(frames: &LaneFrames, directions: &mut Vectors) {
    for lane in 0..LANES {
        let local = frames.get(lane).to_local(directions.get(lane));
        directions.set(lane, local);
    }
}

/// Brings directions from the frames of some lanes into the world.
pub struct ToWorld<'a> {
    pub frames: &'a LaneFrames,
    pub directions: &'a Vectors,
    pub lanes: u32,
    pub world: &'a mut Vectors,
}

impl Computation for ToWorld<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        to_world(self.frames, self.directions, self.lanes, self.world);
    }
}

#[inline(always)]
fn to_world(frames: &LaneFrames, directions: &Vectors, lanes: u32, world: &mut Vectors) {
    for lane in 0..LANES {
        let found = frames.get(lane).to_world(directions.get(lane)).normalized();
        let kept = world.get(lane);
        let is_asked = lanes >> lane & 1 == 1;
        world.set(lane, if is_asked { found } else { kept });
    }
}
