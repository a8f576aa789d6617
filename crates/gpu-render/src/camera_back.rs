//! What the camera has to do with a gradient in reverse mode: the edges that it sees, and how its rays
//! move. The CPU takes derivatives back through both, in double precision.

use capwalk_boundary::Field;
use capwalk_diff::{Reverse, Target, Wanted};
use capwalk_geometry::LocalFrame;
use capwalk_math::tape::Adjoints;
use capwalk_math::{Real, Rgb, Tape, Var, Vec3};
use capwalk_render::SamplePlace;
use capwalk_render::{SampleRange, Tracer, Watch};
use rayon::prelude::*;

use crate::camera_edges::{CameraEdges, DrawnEdge};
use crate::device_error::DeviceError;
use crate::device_scene::DeviceScene;
use crate::fixed_point::{PartSums, Sums};

/// Derivatives with respect to vectors of the scene.
pub type Covectors = Vec<(Target, Vec3)>;

/// The way back through the camera.
pub struct CameraBack<'a> {
    pub tracer: &'a Tracer<'a>,
    field: Field<'a>,
    wanted: &'a Wanted,
    /// Which points of the boundaries depend on what is wanted.
    points: Vec<bool>,
    has_edges: bool,
}

impl<'a> CameraBack<'a> {
    /// The way back through the camera of a tracer, with the edges that it sees or without.
    pub fn new(
        tracer: &'a Tracer<'a>,
        field: Field<'a>,
        wanted: &'a Wanted,
        has_edges: bool,
    ) -> Self {
        Self {
            tracer,
            field,
            wanted,
            points: wanted.points(field.accel, field.boundaries),
            has_edges: has_edges && wanted.geometry(),
        }
    }

    /// True if derivatives with respect to the rays lead to anything that is wanted.
    pub fn rays_are_wanted(&self) -> bool {
        self.wanted.sensor()
    }

    /// Adds what follows from the derivatives with respect to the rays of some samples: how each moves
    /// where it ends, and its direction, both twice, and how far away that is (`reverse.slang`).
    pub fn rays_back(
        &self,
        frame: &LocalFrame,
        samples: &SampleRange,
        back: &[[f32; 13]],
        sums: &Sums,
        part: &mut PartSums,
    ) {
        let each = samples.places().zip(back);
        let covectors = each.map(|(place, back)| {
            let vector = |at: usize| Vec3::from([0, 1, 2].map(|axis| f64::from(back[at + axis])));
            let distance = f64::from(back[12]);
            let (covectors, ()) = self.recorded(|eval| {
                let (moving, _) = self.tracer.camera_ray(eval, place.pixel, &place.stream);
                // Where it ends moves with where it starts and with its direction; in the tree's units.
                let by_start = vector(0) + vector(6);
                let by_direction = vector(3) + vector(9) + vector(0) * distance;
                let by_origin = Vec3::constant(by_start * frame.inverse_scale);
                let end = moving.origin.dot(by_origin)
                    + moving.direction.dot(Vec3::constant(by_direction));
                (end, ())
            });
            covectors
        });
        let covectors: Vec<Covectors> = covectors.collect();
        for (target, covector) in covectors.into_iter().flatten() {
            sums.add(part, target, covector);
        }
    }

    /// The edges that the camera sees in some samples, and the derivatives of the flow across each;
    /// `None` if the watch stopped the work.
    pub fn edges(
        &self,
        scene: &DeviceScene,
        samples: &SampleRange,
        capacity: usize,
        watch: &dyn Watch,
    ) -> Result<Option<Vec<DrawnEdge<Covectors>>>, DeviceError> {
        if !self.has_edges {
            return Ok(Some(Vec::new()));
        }
        let draw = |place: &SamplePlace| {
            let (covectors, edge) = self.recorded(|eval| {
                match self.tracer.camera_edge(eval, place.pixel, &place.stream) {
                    Ok(Some(edge)) => (edge.flow, Ok(Some(edge.map_flow(|_| ())))),
                    Ok(None) => (Var::constant(0.0), Ok(None)),
                    Err(error) => (Var::constant(0.0), Err(error)),
                }
            });
            Ok(edge?.map(|edge| edge.map_flow(|()| covectors)))
        };
        CameraEdges::new(self.tracer).of(scene, samples, draw, capacity, watch)
    }

    /// The derivatives of a number that is computed from the scene, with respect to what is wanted, and
    /// what else comes with it.
    fn recorded<T>(
        &self,
        compute: impl for<'t> FnOnce(&Reverse<'_, 't>) -> (Var<'t>, T),
    ) -> (Covectors, T) {
        let tape = Tape::default();
        let (mut adjoints, mut covectors) = (Adjoints::default(), Vec::new());
        let eval = Reverse::new(self.field, self.wanted, &self.points, &tape);
        let (number, other) = compute(&eval);
        let zero = Var::constant(0.0);
        let one = Rgb::new(1.0, 0.0, 0.0);
        let results = [(Rgb::new(number, zero, zero), one)];
        eval.pull_back(&results, &mut adjoints, &mut covectors);
        (covectors, other)
    }
}
