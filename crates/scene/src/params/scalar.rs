//! Descriptions of scalar parameters.

use super::optic::{optic_text, optic_value};
use super::parameter::{Parameter, ParameterKind};
use super::target::{AXES, Target};
use crate::ids::{EmitterId, ShapeId};
use crate::scene::Scene;

/// What a user reads about the scalar that is called `name`. `users` says of each
/// texture where it is.
pub(super) fn describe(
    scene: &Scene,
    target: Target,
    users: &[String],
    name: String,
    alias_of: Option<String>,
) -> Parameter {
    use ParameterKind::*;
    let shape = |id: ShapeId| &scene.shape(id).id;
    let light = |id: EmitterId| scene.emitter(id).name(scene);
    let moves_discontinuities = match target {
        Target::Texels(_, _, quantity, _) => quantity.moves_edges(),
        Target::Translate(..)
        | Target::Rotate(..)
        | Target::Scale(_)
        | Target::TranslateLight(..)
        | Target::RotateLight(..)
        | Target::TranslateSensor(_)
        | Target::RotateSensor(_)
        | Target::SensorOptic(_) => true,
    };
    let (kind, value, unit, description) = match target {
        Target::Translate(id, axis) => {
            let what = format!("moves {} along world {}", shape(id), AXES[axis]);
            (Translation, vec![0.0], "world units", what)
        }
        Target::Rotate(id, axis) => {
            let what = format!("turns {} about its centre, world {}", shape(id), AXES[axis]);
            (Rotation, vec![0.0], "radians", what)
        }
        Target::Scale(id) => {
            let what = format!("scales {} about its centre", shape(id));
            (Scale, vec![1.0], "times its size", what)
        }
        Target::Texels(id, part, quantity, channel) => {
            let texture = scene.texture(id);
            let which = match part.count {
                1 => String::new(),
                n => format!(", all {n} texels together"),
            };
            let what = format!("{} of {}{which}", quantity.name(), users[id.0 as usize]);
            let what = channel.of(&what, texture.channels);
            let values = match part.count {
                1 => {
                    let first = part.first * texture.channels;
                    channel.values(&texture.data[first..first + texture.channels])
                }
                _ => Vec::new(),
            };
            (quantity.into(), values, quantity.unit(), what)
        }
        Target::TranslateLight(id, axis) => {
            let what = format!("moves {} along world {}", light(id), AXES[axis]);
            (LightTranslation, vec![0.0], "world units", what)
        }
        Target::RotateLight(id, axis) => {
            let what = format!("turns {}, world {}", light(id), AXES[axis]);
            (LightRotation, vec![0.0], "radians", what)
        }
        Target::TranslateSensor(axis) => {
            let what = format!("moves the sensor along world {}", AXES[axis]);
            (SensorTranslation, vec![0.0], "world units", what)
        }
        Target::RotateSensor(axis) => {
            let what = format!("turns the sensor about its origin, world {}", AXES[axis]);
            (SensorRotation, vec![0.0], "radians", what)
        }
        Target::SensorOptic(optic) => {
            let (kind, unit, what) = optic_text(optic);
            (kind, vec![optic_value(scene, optic)], unit, what.to_owned())
        }
    };
    Parameter {
        name,
        kind,
        value,
        unit,
        moves_discontinuities,
        description,
        alias_of,
    }
}
