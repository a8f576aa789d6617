//! Derivative images from a device, in forward mode.

use std::borrow::Cow;
use std::sync::Arc;

use capwalk_boundary::{Boundaries, Field, Viewpoint};
use capwalk_diff::{Forward, GradientImage, GradientOptions, GradientWork, Wanted};
use capwalk_geometry::buffers::NONE;
use capwalk_math::Vec3;
use capwalk_render::SamplePlace;
use capwalk_render::{MotionFacts, SceneEval, Tracer, Watch};
use capwalk_scene::Tangent;

use crate::averages::{MOST_PATHS, Task};
use crate::camera_edges::CameraEdges;
use crate::camera_records::camera_changes;
use crate::device_error::DeviceError;
use crate::device_scene::DeviceScene;
use crate::edge_records::{EdgeMotion, OfPoints};
use crate::layout::change::{
    BOUNDARIES_MOVE, CAMERA_CHANGE_AT, IS_BLIND, MOTION_AT, TEXTURE_CHANGES, WALKS,
};
use crate::render_kernels::FORWARD;
use crate::texture_records::float;
use crate::unsupported::{by_edges, settled, unsupported_derivative};

impl DeviceScene<'_> {
    /// The derivative of the image for a unit change along `tangent`, with the image, as
    /// [`capwalk_diff::gradient`] has them, with its refusals: where anything moves by
    /// [`Method::EDGES`], or by edges of fewer segments if these are asked for. If `watch` stops the
    /// work, what was done is returned.
    ///
    /// [`Method::EDGES`]: capwalk_diff::Method::EDGES
    pub fn gradient(
        &self,
        tangent: &Tangent,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, DeviceError> {
        self.gradient_in_parts(tangent, options, MOST_PATHS, watch)
    }

    /// [`Self::gradient`] with so many samples on the device at a time at most, which changes no bit.
    pub fn gradient_in_parts(
        &self,
        tangent: &Tangent,
        options: &GradientOptions,
        most: usize,
        watch: &dyn Watch,
    ) -> Result<GradientImage, DeviceError> {
        GradientWork::new(self.prepared, Cow::Borrowed(tangent), *options).check(watch)?;
        let wanted = Wanted::by(tangent);
        if let Some(unsupported) = unsupported_derivative(self.prepared, &wanted, options) {
            return Err(unsupported.into());
        }
        self.check_precision(&wanted)?;
        let boundaries = self.prepared.boundaries_if(wanted.moves());
        self.interior_and(Some(boundaries), tangent, options, most, watch)
    }

    /// The interior term of the derivative alone (METHOD 8): how the light along sampled directions
    /// changes, which stay or turn with the surface. What moves across them is left out, so that this
    /// is the derivative of the image only where nothing does. For tests: nothing is checked or
    /// refused.
    #[doc(hidden)]
    pub fn interior_term(
        &self,
        tangent: &Tangent,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, DeviceError> {
        self.interior_and(None, tangent, options, MOST_PATHS, watch)
    }

    /// The derivative of the image where these are the boundaries. For tests: nothing is checked or
    /// refused.
    #[doc(hidden)]
    pub fn gradient_among(
        &self,
        boundaries: &Boundaries,
        tangent: &Tangent,
        options: &GradientOptions,
        watch: &dyn Watch,
    ) -> Result<GradientImage, DeviceError> {
        self.interior_and(Some(boundaries), tangent, options, MOST_PATHS, watch)
    }

    /// The interior term and those of boundaries, if any are to be seen.
    fn interior_and(
        &self,
        boundaries: Option<&Boundaries>,
        tangent: &Tangent,
        options: &GradientOptions,
        most: usize,
        watch: &dyn Watch,
    ) -> Result<GradientImage, DeviceError> {
        let scene = self.prepared.scene();
        let none = self.prepared.boundaries_if(false);
        let accel = self.prepared.accel();
        let field = Field::new(
            accel,
            boundaries.unwrap_or(none),
            by_edges(&options.method, accel),
        );
        let eval = Forward::new(field, tangent);
        let eval = match options.blind {
            true => eval.blind(),
            false => eval,
        };
        let velocity = |point| eval.boundary_point(point).tangent(0);
        let motion = EdgeMotion {
            is_blind: options.blind,
            of_points: OfPoints::Velocities(&velocity),
        };
        let has_edges = boundaries.is_some() && eval.moves();
        let crossed = boundaries.filter(|_| has_edges);
        let facts = Arc::new(MotionFacts::of(scene, true));
        let tracer = Tracer::moving(self.prepared, field, options.walk, &facts);
        let crossed = crossed.map(|boundaries| self.edges(&eval, &tracer, boundaries, &motion));
        let crossed = crossed.transpose()?;
        let mut changes = self.changes(&eval, tangent);
        changes[IS_BLIND] = options.blind.into();
        if let Some(edges) = &crossed {
            edges.append(&mut changes);
        }
        self.check_room_of_numbers(changes.len())?;
        let edges = CameraEdges::new(&tracer);
        let draw = |place: &SamplePlace| {
            let edge = tracer.camera_edge(&eval, place.pixel, &place.stream)?;
            Ok(edge.map(|edge| edge.map_flow(|flow| flow.tangent[0])))
        };
        let task = Task {
            kernels: &FORWARD,
            changes: &changes,
            crossed: crossed.as_ref(),
            edges: has_edges.then_some((&edges, &draw)),
            most,
        };
        let averages = self.average::<6>(task, &options.sampling(), watch)?;
        Ok(GradientImage {
            value: averages.estimate(scene, 0),
            gradient: averages.estimate(scene, 3),
            chosen: Some(settled(options, &Wanted::by(tangent))),
            statistics: averages.statistics,
        })
    }

    /// What changes, as `changes.slang` reads it, but for edges: where the motion of the triangles is and
    /// whether boundaries move, the texels of each texture, the camera, and that motion.
    fn changes(&self, eval: &Forward, tangent: &Tangent) -> Vec<u32> {
        let origin = Viewpoint::towards_surfaces(Vec3::zero(), Vec3::zero(), 0);
        let boundaries_move = !eval.is_still(&origin);
        let mut words = vec![NONE; TEXTURE_CHANGES + self.textures.len()];
        words[BOUNDARIES_MOVE] = boundaries_move.into();
        words[WALKS] = 0;
        for (number, shown) in self.textures.iter().enumerate() {
            if let Some(change) = &tangent.textures[shown.numbers.0 as usize] {
                words[TEXTURE_CHANGES + number] = words.len() as u32;
                words.extend(change.iter().map(|x| float(shown.scale * x)));
            }
        }
        let accel = self.prepared.accel();
        let sensor = accel.scene.sensor.moving_state(&tangent.sensor);
        words[CAMERA_CHANGE_AT] = words.len() as u32;
        words.extend(camera_changes(accel, &sensor, &self.frame));
        if Wanted::by(tangent).moves() {
            words[MOTION_AT] = words.len() as u32;
            words.extend(self.motion_records(eval));
        }
        words
    }
}
