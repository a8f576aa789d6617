//! Lights of `KHR_lights_punctual`. Their candela and lux are taken as they are, as emission is.

use capwalk_math::{Affine, Rgb};
use gltf::khr_lights_punctual::{Kind as LightKind, Light};

use super::gltf_sensor::view;
use super::graph_builder::GraphBuilder;
use crate::mesh::{MeshFileError, shown_name};
use crate::node::{Kind, NodeId, PropertyValue};

impl GraphBuilder<'_> {
    /// A light which stands at a node.
    pub(super) fn light(
        &mut self,
        node: usize,
        light: &Light,
        to_scene: Affine,
    ) -> Result<NodeId, MeshFileError> {
        let (file, line) = (self.file, self.line_of_node(node));
        let name = file.document.as_json().nodes[node].name.as_deref();
        let name = shown_name(name).or(shown_name(light.name()));
        let place = |key: &str| {
            let index = light.index();
            format!("extensions.KHR_lights_punctual.lights[{index}].{key}")
        };
        let colour = file.numbers(&place("color"), [1.0; 3])?;
        let intensity = file.number(&place("intensity"), 1.0)?;
        let intensity = PropertyValue::Rgb(Rgb::from(colour.map(|channel| channel * intensity)));
        let to_world = view(to_scene, node)?;
        if light.range().is_some() {
            self.warn(line, "the light's range has no effect: light does not end");
        }
        let emitter = match light.kind() {
            LightKind::Directional => {
                let emitter = self.add(Kind::Emitter, "directional", name, line);
                self.set(emitter, "irradiance", intensity);
                emitter
            }
            LightKind::Point => {
                let emitter = self.add(Kind::Emitter, "point", name, line);
                self.set(emitter, "intensity", intensity);
                emitter
            }
            LightKind::Spot { .. } => {
                let emitter = self.add(Kind::Emitter, "spot", name, line);
                self.set(emitter, "intensity", intensity);
                let angle = |key: &str, default| {
                    let angle = file.number(&place(&format!("spot.{key}")), default)?;
                    Ok::<_, MeshFileError>(PropertyValue::Float(angle.to_degrees()))
                };
                let outer = angle("outerConeAngle", std::f64::consts::FRAC_PI_4)?;
                self.set(emitter, "cutoff_angle", outer);
                self.set(emitter, "beam_width", angle("innerConeAngle", 0.0)?);
                let message = "between its cones the spot light falls off in proportion to the \
                               angle, as Mitsuba's does; glTF recommends a square of cosines";
                self.warn(line, message);
                emitter
            }
        };
        self.set(emitter, "to_world", PropertyValue::Transform(to_world));
        Ok(emitter)
    }
}
