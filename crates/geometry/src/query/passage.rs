//! How lines pass a sphere.

use capwalk_math::Vec3;

/// Where a line passes a sphere, as distances along it.
#[derive(Clone, Copy)]
pub struct Passage {
    /// The line in the coordinates of the sphere, and how far off it may be there.
    pub origin: Vec3,
    pub direction: Vec3,
    pub margin: f64,
    /// Where it is nearest to the centre, half its chord in the outer sphere, and half that in the inner
    /// one, negative if it does not meet that.
    pub middle: f64,
    pub outer: f64,
    pub inner: f64,
    /// Hits may be found so much before or after where the line meets the face.
    pub slack: f64,
    /// If not, double precision does not tell, and nothing here means anything.
    pub is_known: bool,
    /// If not, it hits no face.
    pub meets: bool,
}

impl Passage {
    /// True if no face is hit between two distances.
    #[inline(always)]
    pub fn misses(&self, [t_min, t_max]: [f64; 2]) -> bool {
        let reach = self.outer + self.slack;
        !self.meets | (t_min > self.middle + reach) | (t_max < self.middle - reach)
    }

    /// Between which distances the line is between the outer and the inner sphere: on one way or
    /// two, the nearer first.
    #[inline(always)]
    pub fn ways(&self) -> [Option<[f64; 2]>; 2] {
        let Self {
            middle,
            outer,
            inner,
            ..
        } = *self;
        match inner < 0.0 {
            true => [Some([middle - outer, middle + outer]), None],
            false => [
                Some([middle - outer, middle - inner]),
                Some([middle + inner, middle + outer]),
            ],
        }
    }

    /// True if the line goes in from outside, or out from inside, between two distances: then it
    /// hits a face there, the mesh being closed.
    #[inline(always)]
    pub fn surely_hits(&self, [t_min, t_max]: [f64; 2]) -> bool {
        let Self {
            middle,
            outer,
            inner,
            slack,
            ..
        } = *self;
        let is_within = |start: f64, end: f64| (t_min < start - slack) & (end + slack < t_max);
        let goes_in = is_within(middle - outer, middle - inner);
        let goes_out = is_within(middle + inner, middle + outer);
        (inner >= 0.0) & (goes_in | goes_out)
    }
}
