//! Where the parts of a scene stand in the text, for what is found out about the
//! finished scene.

use std::collections::BTreeMap;

use capwalk_math::Vec3;
use capwalk_scene::{Scene, SceneError, SensorModel};

use crate::fields::Context;
use crate::problem::Problem;
use crate::texts::Span;

/// Spans of the parts, in their order in the scene.
#[derive(Default)]
pub(super) struct Places {
    /// The span of each shape.
    pub shapes: Vec<Span>,
    /// The span of each emitter.
    pub emitters: Vec<Span>,
    /// The span of each material.
    pub materials: Vec<Span>,
    /// The spans of numbers, by the names that [`SceneError::BadNumber`] uses.
    pub numbers: BTreeMap<String, Span>,
    pub film: Option<Span>,
}

impl Places {
    /// A warning if all shapes lie before or behind the sensor's clip planes.
    /// Sensors whose rays are parallel may scale depths, and are passed over.
    pub fn warn_of_clipping(&self, context: &Context, scene: &Scene, root: Span) {
        let sensor = &scene.sensor;
        if sensor.model == SensorModel::Orthographic {
            return;
        }
        let [a, b, c] = sensor.world_from_camera.rows;
        let forward = Vec3::new(a.z, b.z, c.z);
        let vertices = scene.shapes.iter().flat_map(|s| &s.mesh.positions);
        let depths = vertices.map(|&p| forward.dot(p - sensor.origin()));
        let (least, most) = depths.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| {
            (low.min(z), high.max(z))
        });
        let (near, far) = (sensor.near_clip, sensor.far_clip);
        let has_shapes = least <= most;
        if !has_shapes || (most > near && least < far) {
            return;
        }
        let number = self.numbers.get(&format!("{}.near_clip", sensor.id));
        let message = format!(
            "no surface is seen: seen from the sensor, all shapes lie at depths from {least:.4} \
             to {most:.4}, outside of near_clip {near} to far_clip {far}; set near_clip and \
             far_clip around them, or turn the sensor towards them (depths below 0 are behind it)"
        );
        context.warn(number.copied().unwrap_or(root), &message);
    }

    /// An error of the finished scene, at the place in the text it comes from.
    pub fn problem(&self, scene: &Scene, root: Span, error: SceneError) -> Problem {
        let shape_span = |id: &str| {
            let index = scene.shapes.iter().position(|s| s.id == id);
            index.map(|i| self.shapes[i])
        };
        let span = match &error {
            SceneError::Mesh { shape, .. }
            | SceneError::TooSmall { shape, .. }
            | SceneError::DuplicateId { id: shape }
            | SceneError::NoTextureCoordinates { shape, .. }
            | SceneError::NoDirections { shape, .. }
            | SceneError::NoAttribute { shape, .. } => shape_span(shape),
            SceneError::ZeroAreaEmitter { shape } => {
                let shape = scene.shapes.iter().find(|s| s.id == *shape);
                let emitter = shape.and_then(|s| s.emitter);
                emitter.map(|e| self.emitters[e.0 as usize])
            }
            SceneError::Material { material, .. } => {
                let index = scene.materials.iter().position(|m| m.id == *material);
                index.map(|i| self.materials[i])
            }
            SceneError::ImageSize { .. } => self.film,
            SceneError::BadNumber { name, .. } => {
                // `wood.data, texel 5` stands where `wood.data` does.
                let number = name.split(", texel ").next().unwrap_or(name);
                self.numbers.get(number).copied()
            }
            SceneError::SeveralEnvironments => {
                let emitters = scene.emitters.iter().zip(&self.emitters);
                let mut environments = emitters.filter(|(e, _)| e.is_environment());
                environments.nth(1).map(|(_, span)| *span)
            }
            // What has no place of its own stands at the root.
            _ => None,
        };
        Problem::scene(span.unwrap_or(root), error)
    }
}
