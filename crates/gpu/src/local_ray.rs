//! A ray as the kernels read it: in the tree's coordinates for boxes, in those of the
//! test's precision for triangles.

use capwalk_geometry::ray::{EDGE_ON, ORIGIN_MARGIN, PLANE_MARGIN, RayShear, SLOWEST};
use capwalk_geometry::{LocalFrame, Ray};

use crate::layout::ray::*;
use crate::precision::Precision;

/// How far triangles tested in single precision may lie from where they are, and the ray
/// as well, local units: their margin of boxes.
const SINGLE_MARGIN: f64 = 1.0 / (1 << 20) as f64;

/// [`EDGE_ON`] in single precision.
const EDGE_ON_SINGLE: f64 = 1.0 / (1 << 21) as f64;

/// Where a ray enters a tree, and how distances there are those along the ray.
#[derive(Clone, Copy, Debug)]
pub struct LocalRay {
    shear: RayShear,
    /// Position of the start, local units.
    start: [f64; 3],
    direction: [f64; 3],
    /// Local distance, along the fastest axis, at which it enters the tree and leaves it.
    enter: f64,
    exit: f64,
    /// Local distance per distance along the ray.
    local_per_t: f64,
    margin: f64,
}

impl LocalRay {
    /// The ray in the tree's coordinates; `None` if it misses the tree.
    pub fn new(frame: &LocalFrame, ray: &Ray, precision: Precision) -> Option<Self> {
        let shear = RayShear::new(ray.direction)?;
        let speed = shear.inverse_z.abs();
        let direction = (ray.direction * speed).to_array();
        let local_per_t = frame.inverse_scale / speed;
        let origin = frame.local_from_world(ray.origin);
        let margin = PLANE_MARGIN
            + ORIGIN_MARGIN * origin.map(f64::abs).max_component()
            + match precision {
                Precision::Single => SINGLE_MARGIN,
                Precision::Double => 0.0,
            };
        let origin = origin.to_array();
        let mut enter = ray.t_min * local_per_t;
        let mut exit = ray.t_max * local_per_t;
        for axis in 0..3 {
            let (from, d) = (origin[axis], direction[axis]);
            let reach = 1.0 + margin;
            if d == 0.0 {
                if from.abs() > reach {
                    return None;
                }
            } else {
                let side = reach.copysign(d);
                enter = enter.max((-side - from) / d);
                exit = exit.min((side - from) / d);
            }
        }
        let is_in_reach = enter <= exit; // false for NaN
        is_in_reach.then(|| Self {
            shear,
            start: [0, 1, 2].map(|axis| origin[axis] + direction[axis] * enter),
            direction,
            enter,
            exit,
            local_per_t,
            margin,
        })
    }

    /// Writes what the kernels read.
    pub fn write(&self, ray: &Ray, precision: Precision, view: &mut [u32], numbers: &mut [f64]) {
        for axis in 0..3 {
            let d = self.direction[axis];
            let d = match d.abs() < SLOWEST {
                true => SLOWEST.copysign(d),
                false => d,
            };
            let inverse = d.recip();
            let (offset, margin) = (self.start[axis] * inverse, self.margin * inverse.abs());
            view[axis] = (inverse as f32).to_bits();
            view[4 + axis] = ((offset + margin) as f32).to_bits();
            view[8 + axis] = ((offset - margin) as f32).to_bits();
        }
        let [x, y, z] = self.shear.axes;
        let end = (ray.t_max * self.local_per_t).min(self.exit);
        view[3] = round_up(end - self.enter + self.margin).to_bits();
        view[7] = round_up(self.margin).to_bits();
        view[11] = (x | y << 2 | z << 4) as u32;
        let ([from, to], origin, inverse_z, local_per_t, enter, edge_on, largest) = match precision
        {
            Precision::Double => (
                [ray.t_min, ray.t_max],
                ray.origin.to_array(),
                self.shear.inverse_z,
                self.local_per_t,
                self.enter,
                EDGE_ON,
                f64::MAX,
            ),
            // From where it enters the tree, so that all numbers are about 1.
            Precision::Single => (
                [ray.t_min, ray.t_max].map(|t| t * self.local_per_t - self.enter),
                self.start,
                self.shear.inverse_z.signum(),
                1.0,
                0.0,
                EDGE_ON_SINGLE,
                f64::from(f32::MAX),
            ),
        };
        numbers[RAY_ORIGIN..RAY_SHEAR].copy_from_slice(&origin);
        numbers[RAY_SHEAR..RAY_INVERSE_Z].copy_from_slice(&self.shear.shear);
        numbers[RAY_INVERSE_Z] = inverse_z;
        let bounds = [from, to].map(|t| t.clamp(-largest, largest));
        numbers[RAY_RANGE..RAY_LOCAL_PER_T].copy_from_slice(&bounds);
        numbers[RAY_LOCAL_PER_T] = local_per_t;
        numbers[RAY_ENTER] = enter;
        numbers[RAY_EDGE_ON] = edge_on;
        numbers[RAY_LARGEST] = largest;
    }

    /// The distance along the ray of what a kernel calls a distance.
    pub fn distance(&self, t: f64, precision: Precision) -> f64 {
        match precision {
            Precision::Double => t,
            Precision::Single => (t + self.enter) / self.local_per_t,
        }
    }
}

/// Writes a ray that hits nothing.
pub fn write_miss(view: &mut [u32]) {
    view[3] = (-1.0_f32).to_bits();
}

/// The nearest number in single precision that is not below `v`.
pub fn round_up(v: f64) -> f32 {
    let nearest = v as f32;
    match f64::from(nearest) < v {
        true => nearest.next_up(),
        false => nearest,
    }
}
