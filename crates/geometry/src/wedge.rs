//! Wedges: the parts of planes that light reaches past a segment, and where triangles cross
//! them.
//!
//! The light of a point, or parallel light, that reaches a segment fills a plane sector, or a
//! strip. What it reaches there, before the segment and behind it, decides where the segment's
//! hard shadow falls.

use capwalk_math::Vec3;

/// Where the light of a wedge comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Apex {
    /// A point.
    Point(Vec3),
    /// From infinity: where the light goes, of any length.
    Direction(Vec3),
}

/// The points `γ apex + α a + β b` with `α, β ≥ 0`, where `α + β + γ = 1` for light from a
/// point, and `α + β = 1` for parallel light.
#[derive(Clone, Copy, Debug)]
pub struct Wedge {
    apex: Apex,
    /// The segment `a b`.
    ends: [Vec3; 2],
    /// The plane's normal, of any length.
    cross: Vec3,
    /// 1, or -1 if what touches the plane on the side of the normal crosses it, and not what
    /// touches it on the other side.
    side: f64,
    /// `α` and `β` of a point of the plane are the products of these with its offsets from
    /// `b` and from `a`.
    sides: [Vec3; 2],
}

/// Sine of the angle to the light below which a segment is a point as the light sees it: far
/// above rounding, which would decide about the plane of its wedge.
const END_ON: f64 = 1e-11;

/// Distances from the plane of a wedge up to which points lie in it: as parts of their distance
/// from the segment, and of all coordinates.
const IN_PLANE: [f64; 2] = [1e-11, 1e-15];

/// The sum of the sizes of the coordinates: no less than the length.
fn sum(v: Vec3) -> f64 {
    v.x.abs() + v.y.abs() + v.z.abs()
}

/// So many times nearer than the segment is at the apex, up to rounding.
const AT_APEX: f64 = 1e9;

/// A place on a wedge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WedgePoint {
    /// Where the light that comes here passes the segment: 0 at `a`, 1 at `b`.
    pub along: f64,
    /// Grows with the distance from the light, linearly with `along` on any straight line:
    /// for light from a point minus the segment's distance over this one's; for parallel
    /// light, the distance behind the segment in lengths of the direction.
    pub depth: f64,
}

impl Wedge {
    /// The wedge of a segment; `None` if the segment is a point as the light sees it.
    pub fn new(apex: Apex, [a, b]: [Vec3; 2]) -> Option<Self> {
        let light = |p: Vec3| match apex {
            Apex::Point(origin) => p - origin,
            Apex::Direction(direction) => direction,
        };
        let (first, along) = (light(a), b - a);
        let cross = first.cross(along);
        let square = cross.length_squared();
        let least = END_ON * END_ON * first.length_squared() * along.length_squared();
        if square <= least || !square.is_finite() {
            return None;
        }
        // Each vanishes along the light through one end, and is 1 at the other.
        let sides = [light(b).cross(cross), cross.cross(light(a))].map(|side| side / square);
        Some(Self {
            apex,
            ends: [a, b],
            cross,
            side: 1.0,
            sides,
        })
    }

    /// The same wedge, crossed by nothing that touches its plane on the side of a point: as if
    /// it were hardly any farther on the other side.
    pub fn beside(self, point: Vec3) -> Self {
        let [a, _] = self.ends;
        let side = self.cross.dot(point - a).signum();
        Self { side, ..self }
    }

    /// The same wedge, crossed by what does not cross this one although it touches its plane.
    pub fn turned(self) -> Self {
        Self {
            side: -self.side,
            ..self
        }
    }

    /// The normal of its plane, of any length.
    pub fn normal(&self) -> Vec3 {
        self.cross
    }

    /// What the depth is at the segment.
    pub fn depth_of_segment(&self) -> f64 {
        match self.apex {
            Apex::Point(_) => -1.0,
            Apex::Direction(_) => 0.0,
        }
    }

    /// `α` and `β` of a point of its plane.
    fn shares(&self, p: Vec3) -> [f64; 2] {
        let [a, b] = self.ends;
        [self.sides[0].dot(p - b), self.sides[1].dot(p - a)]
    }

    /// The place with these `α` and `β`, not both zero, of a point of its plane.
    fn place(&self, p: Vec3, [alpha, beta]: [f64; 2]) -> WedgePoint {
        let sum = alpha + beta;
        let depth = match self.apex {
            Apex::Point(_) => -1.0 / sum,
            Apex::Direction(direction) => {
                let [a, b] = self.ends;
                let offset = p - (a * alpha + b * beta) / sum;
                offset.dot(direction) / direction.length_squared()
            }
        };
        WedgePoint {
            along: beta / sum,
            depth,
        }
    }

    /// The weights of `a`, `b` and the apex in a place, and where it is.
    pub fn point(&self, place: WedgePoint) -> ([f64; 3], Vec3) {
        let [a, b] = self.ends;
        let WedgePoint { along, depth } = place;
        let (weights, apex) = match self.apex {
            Apex::Point(origin) => {
                let far = -1.0 / depth;
                ([(1.0 - along) * far, along * far, 1.0 - far], origin)
            }
            Apex::Direction(direction) => ([1.0 - along, along, depth], direction),
        };
        (weights, a * weights[0] + b * weights[1] + apex * weights[2])
    }

    /// Where a triangle crosses the wedge, from lower `along` to higher: `None` if it does
    /// not. Triangles with a common edge cross it where the other does.
    pub fn section(&self, corners: [Vec3; 3]) -> Option<[WedgePoint; 2]> {
        let [a, _] = self.ends;
        // Corners in the plane are above it, whatever rounding makes of them.
        let heights = corners.map(|p| {
            let height = self.side * self.cross.dot(p - a);
            match height.abs() <= self.tolerance(p, Vec3::zero()) {
                true => 0.0,
                false => height,
            }
        });
        let is_below = heights.map(|height| height < 0.0);
        let mut crossed = (0..3).filter_map(|i| {
            let k = (i + 1) % 3;
            if is_below[i] == is_below[k] {
                return None;
            }
            let t = heights[i] / (heights[i] - heights[k]);
            Some(corners[i] + (corners[k] - corners[i]) * t)
        });
        let points = [crossed.next()?, crossed.next()?];
        // Clip the segment between them to where both shares are positive.
        let shares = points.map(|p| self.shares(p));
        let mut range = [0.0_f64, 1.0_f64];
        for side in 0..2 {
            let [from, to] = shares.map(|shares| shares[side]);
            let crossing = from / (from - to);
            match (from > 0.0, to > 0.0) {
                (true, true) => {}
                (false, true) => range[0] = range[0].max(crossing),
                (true, false) => range[1] = range[1].min(crossing),
                (false, false) => return None,
            }
        }
        if range[0] >= range[1] {
            return None;
        }
        let at = |t: f64| {
            let [from, to] = shares;
            let share = |side: usize| (from[side] + (to[side] - from[side]) * t).max(0.0);
            let p = points[0] + (points[1] - points[0]) * t;
            self.place(p, [share(0), share(1)])
        };
        let [first, second] = range.map(at);
        let section = match first.along <= second.along {
            true => [first, second],
            false => [second, first],
        };
        // What the light sees edge-on has no length, and what it touches no direction.
        let is_off_apex = section.iter().all(|place| match self.apex {
            Apex::Point(_) => place.depth > -AT_APEX,
            Apex::Direction(_) => place.depth.is_finite(),
        });
        (is_off_apex && section[0].along < section[1].along).then_some(section)
    }

    /// How far from its plane points lie in it, as a product of their distance and the
    /// length of the normal: points this far from a middle, at most.
    fn tolerance(&self, middle: Vec3, half: Vec3) -> f64 {
        let [a, _] = self.ends;
        let [from_segment, from_origin] = [middle - a, middle].map(|p| sum(p) + sum(half));
        let distance = IN_PLANE[0] * from_segment + IN_PLANE[1] * (from_origin + sum(a));
        distance * self.cross.length()
    }

    /// False if no triangle in a box can cross it: the box with this middle, and half of
    /// its extents. `margin` is how far the box may be off, world units.
    pub fn meets_box(&self, middle: Vec3, half: Vec3, margin: f64) -> bool {
        let reach = |normal: Vec3| {
            normal.x.abs() * half.x
                + normal.y.abs() * half.y
                + normal.z.abs() * half.z
                + margin * sum(normal)
        };
        let [a, b] = self.ends;
        let half_and_margin = half + Vec3::splat(margin);
        let in_plane = self.tolerance(middle, half_and_margin);
        self.cross.dot(middle - a).abs() <= reach(self.cross) + in_plane
            && self.sides[0].dot(middle - b) >= -reach(self.sides[0])
            && self.sides[1].dot(middle - a) >= -reach(self.sides[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ENDS: [Vec3; 2] = [Vec3::new(-0.4, 1.0, 0.3), Vec3::new(0.7, 1.2, -0.2)];
    const APEXES: [Apex; 2] = [
        Apex::Point(Vec3::new(0.3, 3.0, 0.1)),
        Apex::Direction(Vec3::new(0.2, -2.0, 0.4)),
    ];

    fn wedge(apex: Apex) -> Wedge {
        Wedge::new(apex, ENDS).expect("seen from the side")
    }

    /// A place is where light past the segment arrives, and lies in the plane.
    #[test]
    fn places_are_on_rays_past_the_segment() {
        for apex in APEXES {
            let wedge = wedge(apex);
            for (along, depth) in [(0.0, -0.5), (0.3, -0.2), (1.0, -0.9)] {
                let place = WedgePoint { along, depth };
                let (weights, p) = wedge.point(place);
                let on_segment = ENDS[0] + (ENDS[1] - ENDS[0]) * along;
                let light = match apex {
                    Apex::Point(origin) => p - origin,
                    Apex::Direction(direction) => direction,
                };
                let offset = p - on_segment;
                assert!(light.cross(offset).length() < 1e-14 * light.length());
                assert!(wedge.normal().dot(p - ENDS[0]).abs() < 1e-14);
                let again = wedge.place(p, wedge.shares(p));
                assert!((again.along - along).abs() < 1e-14, "{again:?}");
                assert!((again.depth - depth).abs() < 1e-14, "{again:?}");
                let sum = weights[0] + weights[1] + weights[2];
                match apex {
                    Apex::Point(_) => assert!((sum - 1.0).abs() < 1e-15),
                    Apex::Direction(_) => assert!((weights[0] + weights[1] - 1.0).abs() < 1e-15),
                }
            }
        }
    }

    /// The section of a floor is the shadow of the segment: depths are linear in between.
    #[test]
    fn sections_are_straight() {
        let corners = [(-9.0, -9.0), (9.0, -9.0), (0.0, 12.0)];
        let floor = corners.map(|(x, z)| Vec3::new(x, 0.1 * x - 0.2 * z - 1.0, z));
        for apex in APEXES {
            let wedge = wedge(apex);
            let [from, to] = wedge.section(floor).expect("below the segment");
            assert!(from.along < 1e-15 && (to.along - 1.0).abs() < 1e-15);
            for t in [0.0, 0.25, 0.8, 1.0] {
                let place = WedgePoint {
                    along: t,
                    depth: from.depth + (to.depth - from.depth) * t,
                };
                let (_, p) = wedge.point(place);
                assert!((0.1 * p.x - 0.2 * p.z - 1.0 - p.y).abs() < 1e-13, "{p:?}");
            }
            // Nearer than the segment, beside the light, and behind it.
            let before = floor.map(|p| p + Vec3::new(0.0, 3.2, 0.0));
            let section = wedge.section(before).expect("between light and segment");
            assert!(section[0].depth < wedge.depth_of_segment());
            let beside = floor.map(|p| p + Vec3::new(40.0, 0.0, 0.0));
            assert!(wedge.section(beside).is_none());
            if let Apex::Point(_) = apex {
                let behind = floor.map(|p| p + Vec3::new(0.0, 9.0, 0.0));
                assert!(wedge.section(behind).is_none());
            }
        }
    }

    /// What touches the plane crosses it from one side, and not from the other, whatever
    /// rounding says; what lies in it crosses it from none.
    #[test]
    fn what_touches_crosses_from_one_side() {
        for apex in APEXES {
            let wedge = wedge(apex);
            let normal = wedge.normal().normalized();
            let [from, to] = [(0.2, 2.5), (0.7, 1.8)].map(|(along, far)| {
                let depth = match apex {
                    Apex::Point(_) => -1.0 / far,
                    Apex::Direction(_) => far,
                };
                wedge.point(WedgePoint { along, depth }).1
            });
            let tip = (from + to) * 0.5 + normal;
            for off in [0.0, 3e-16, -3e-16] {
                let corners = [from + normal * off, to - normal * off, tip];
                assert!(wedge.beside(tip).section(corners).is_none());
                let other_side = [wedge.beside(tip).turned(), wedge.beside(from - normal)];
                for wedge in other_side {
                    let [first, last] = wedge.section(corners).expect("touches");
                    assert!((first.along - 0.2).abs() < 1e-9);
                    assert!((last.along - 0.7).abs() < 1e-9);
                }
                let flat = [corners[0], corners[1], tip - normal * (1.0 + off)];
                let sides = [wedge, wedge.turned()];
                assert!(sides.iter().all(|wedge| wedge.section(flat).is_none()));
            }
        }
    }

    /// A segment that points to the light has no wedge.
    #[test]
    fn segments_seen_end_on_have_none() {
        let [a, b] = ENDS;
        assert!(Wedge::new(Apex::Point(a + (b - a) * 2.0), ENDS).is_none());
        assert!(Wedge::new(Apex::Direction(a - b), [a, b]).is_none());
        assert!(Wedge::new(Apex::Direction(a), [b, b]).is_none());
        // Rounding leaves something of a plane.
        let off = Vec3::new(0.0, 1e-16, 2e-16);
        assert!(Wedge::new(Apex::Direction(a - b + off), [a, b]).is_none());
        assert!(Wedge::new(Apex::Direction(a - b + off * 1e6), [a, b]).is_some());
    }
}
