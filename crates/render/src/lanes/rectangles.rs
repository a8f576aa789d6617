//! Points that lanes draw on rectangles, as [`RectangleSampler`](crate::RectangleSampler) does.

use capwalk_boundary::Streams;
use capwalk_geometry::simd::{Computation, Simd};
use capwalk_math::Vec3;

use crate::lanes::lit::Lit;
use crate::lanes::step::Vertices;
use crate::lanes::vectors::{LANES, Numbers, Vectors};
use crate::rectangle_sampler::Rectangle;

/// A rectangle for each lane.
pub struct Rectangles {
    corner: Vectors,
    sides: [Vectors; 2],
    normal: Vectors,
    lengths: [Numbers; 2],
}

impl Rectangles {
    /// None yet.
    pub const NONE: Self = Self {
        corner: Vectors::ZERO,
        sides: [Vectors::ZERO; 2],
        normal: Vectors::UP,
        lengths: [[1.0; LANES]; 2],
    };

    /// The same in all lanes.
    pub fn fill(&mut self, rectangle: &Rectangle) {
        self.corner = Vectors::splat(rectangle.corner.to_array());
        self.normal = Vectors::splat(rectangle.normal.to_array());
        self.sides = rectangle.sides.map(|side| Vectors::splat(side.to_array()));
        self.lengths = rectangle.lengths.map(|length| [length; LANES]);
    }

    /// Sets that of a lane.
    #[inline]
    pub fn set(&mut self, lane: usize, rectangle: &Rectangle) {
        self.corner.set(lane, rectangle.corner);
        self.normal.set(lane, rectangle.normal);
        for i in 0..2 {
            self.sides[i].set(lane, rectangle.sides[i]);
            self.lengths[i][lane] = rectangle.lengths[i];
        }
    }

    #[inline(always)]
    fn get(&self, lane: usize) -> Rectangle {
        Rectangle {
            corner: self.corner.get(lane),
            sides: [self.sides[0].get(lane), self.sides[1].get(lane)],
            normal: self.normal.get(lane),
            lengths: [self.lengths[0][lane], self.lengths[1][lane]],
        }
    }
}

/// Draws points on the rectangles of some lanes.
pub struct SampleRectangles<'a> {
    pub rectangles: &'a Rectangles,
    pub vertices: &'a Vertices,
    pub streams: &'a Streams<LANES>,
    /// The first of two random numbers.
    pub first: u32,
    /// One bit for each that needs a point.
    pub lanes: u32,
    pub lit: &'a mut Lit,
}

impl Computation for SampleRectangles<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            rectangles,
            vertices,
            streams,
            first,
            lanes,
            lit,
        } = self;
        let u = streams.pairs(first, lanes);
        // Most are far away.
        let mut points = Points::NONE;
        let far = draw_from_afar(rectangles, vertices, &u, &mut points);
        let behind = points.behind();
        points.put(lanes & far & !behind, lit);
        let near = lanes & !far & !behind;
        if near != 0 {
            draw_from_near_by(rectangles, vertices, &u, &mut points);
            points.put(near & !points.behind(), lit);
        }
    }
}

/// Points on rectangles.
struct Points {
    direction: Vectors,
    distance: Numbers,
    /// Positive where the front is seen.
    inverse_density: Numbers,
}

impl Points {
    /// None yet.
    const NONE: Self = Self {
        direction: Vectors::ZERO,
        distance: [0.0; LANES],
        inverse_density: [0.0; LANES],
    };

    /// One bit for each of which the front is not seen. What is not a number is not dark: the pixel
    /// counts it.
    #[inline(always)]
    fn behind(&self) -> u32 {
        let mut behind = 0;
        for (lane, &inverse) in self.inverse_density.iter().enumerate() {
            behind |= u32::from(inverse <= 0.0) << lane;
        }
        behind
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, offset: Vec3, distance: f64) {
        self.direction.set(lane, offset * (1.0 / distance));
        self.distance[lane] = distance;
    }

    /// Lets some lanes be lit from there.
    #[inline(always)]
    fn put(&self, lanes: u32, lit: &mut Lit) {
        put(self, lanes, lit);
        lit.mask |= lanes;
    }
}

#[inline(always)]
fn put(points: &Points, lanes: u32, lit: &mut Lit) {
    for lane in 0..LANES {
        let is_asked = lanes >> lane & 1 == 1;
        let (kept, direction) = (lit.direction.get(lane), points.direction.get(lane));
        lit.direction
            .set(lane, if is_asked { direction } else { kept });
        lit.range[1][lane] = if is_asked {
            points.distance[lane]
        } else {
            lit.range[1][lane]
        };
        lit.inverse_density[lane] *= if is_asked {
            points.inverse_density[lane]
        } else {
            1.0
        };
    }
}

/// Draws them as from far away; one bit for each lane where they are.
#[inline(always)]
fn draw_from_afar(
    rectangles: &Rectangles,
    vertices: &Vertices,
    u: &[Numbers; 2],
    points: &mut Points,
) -> u32 {
    let mut is_far = [0.0; LANES];
    for lane in 0..LANES {
        let rectangle = rectangles.get(lane);
        let (position, n) = (vertices.position.get(lane), vertices.normal(lane));
        let (seen, far) = rectangle.seen_from_afar(position, n);
        let point = seen.sample([u[0][lane], u[1][lane]]);
        let offset = rectangle.offset_to(seen.place(point), seen.rise);
        let distance = offset.length();
        points.set(lane, offset, distance);
        points.inverse_density[lane] = seen.inverse_density(point, distance);
        is_far[lane] = if far { 1.0 } else { 0.0 };
    }
    let mut far = 0;
    for (lane, &is_far) in is_far.iter().enumerate() {
        far |= u32::from(is_far > 0.0) << lane;
    }
    far
}

/// Draws them as from near by.
#[inline(always)]
fn draw_from_near_by(
    rectangles: &Rectangles,
    vertices: &Vertices,
    [first, second]: &[Numbers; 2],
    points: &mut Points,
) {
    for (lane, (&first, &second)) in first.iter().zip(second).enumerate() {
        let rectangle = rectangles.get(lane);
        let (seen, _) = rectangle.seen(vertices.position.get(lane));
        let place = seen.sample([first, second]);
        let offset = rectangle.offset_to(place, seen.z);
        points.set(lane, offset, offset.length());
        points.inverse_density[lane] = seen.solid_angle;
    }
}
