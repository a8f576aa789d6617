//! From a parameter to the velocities it means.

use capwalk_geometry::topology::weld;
use capwalk_math::Vec3;

use super::error::ParameterError;
use super::near::near;
use super::optic::optic_scale;
use super::target::Target;
use crate::ids::ShapeId;
use crate::scene::Scene;
use crate::scene_vector::{ShapeVectors, Tangent};
use crate::shape::ShadingNormals;

/// Adds `factor` times a parameter's velocities to a motion.
pub(super) fn accumulate(scene: &Scene, target: Target, factor: f64, tangent: &mut Tangent) {
    let axis = |axis: usize| Vec3::from([0, 1, 2].map(|i| if i == axis { factor } else { 0.0 }));
    match target {
        Target::Translate(id, along) => add_rigid(scene, id, axis(along), Vec3::zero(), tangent),
        Target::Rotate(id, about) => add_rigid(scene, id, Vec3::zero(), axis(about), tangent),
        Target::Scale(id) => {
            let shape = scene.shape(id);
            let centre = shape.centre();
            let positions = shape.mesh.positions.iter();
            let vertices = positions.map(|&p| (p - centre) * factor).collect();
            // A uniform scale turns no normal.
            let normals = None;
            tangent.add_to_shape(id, ShapeVectors { vertices, normals });
        }
        Target::Texels(id, part, _, channel) => {
            let texture = scene.texture(id);
            let (numbers, channels) = (texture.data.len(), texture.channels);
            let velocities = &mut tangent.textures[id.0 as usize];
            let velocities = velocities.get_or_insert_with(|| vec![0.0; numbers]);
            for texel in part.first..part.first + part.count {
                for i in (0..channels).filter(|&i| channel.contains(i)) {
                    velocities[texel * channels + i] += factor;
                }
            }
        }
        Target::TranslateLight(id, along) => {
            tangent.emitters[id.0 as usize].translation += axis(along);
        }
        Target::RotateLight(id, about) => {
            tangent.emitters[id.0 as usize].rotation += axis(about);
        }
        Target::TranslateSensor(along) => tangent.sensor.translation += axis(along),
        Target::RotateSensor(about) => tangent.sensor.rotation += axis(about),
        Target::SensorOptic(optic) => tangent.sensor.add_optic(optic, factor * optic_scale(optic)),
    }
}

/// Adds a rigid motion of a shape: `translation + rotation × (p - centre)`.
fn add_rigid(scene: &Scene, id: ShapeId, translation: Vec3, rotation: Vec3, tangent: &mut Tangent) {
    let shape = scene.shape(id);
    let centre = shape.centre();
    let positions = shape.mesh.positions.iter();
    let vertices = positions
        .map(|&p| translation + rotation.cross(p - centre))
        .collect();
    let normals = match &shape.normals {
        ShadingNormals::Given(normals) if rotation != Vec3::zero() => {
            Some(normals.iter().map(|&n| rotation.cross(n)).collect())
        }
        // A translation turns no normal, and computed ones follow by themselves.
        ShadingNormals::Given(_) | ShadingNormals::Face | ShadingNormals::Computed(_) => None,
    };
    tangent.add_to_shape(id, ShapeVectors { vertices, normals });
}

/// The motion of a single shape whose vertices each have a velocity, world
/// units. Normals given with the mesh stay, computed ones follow.
///
/// There must be one finite velocity per vertex, and the same one for vertices
/// at the same position (seams of normals or texture coordinates).
pub fn vertex_tangent(
    scene: &Scene,
    shape: &str,
    velocities: Vec<Vec3>,
) -> Result<Tangent, ParameterError> {
    let Some(index) = scene.shapes.iter().position(|s| s.id == shape) else {
        return Err(ParameterError::UnknownShape {
            shape: shape.into(),
            near: near(shape, scene.shapes.iter().map(|s| s.id.as_str())),
        });
    };
    let positions = &scene.shapes[index].mesh.positions;
    if velocities.len() != positions.len() {
        return Err(ParameterError::VertexCount {
            shape: shape.into(),
            vertices: positions.len(),
            velocities: velocities.len(),
        });
    }
    if let Some(vertex) = velocities.iter().position(|v| !v.is_finite()) {
        return Err(ParameterError::BadVelocity {
            shape: shape.into(),
            vertex,
            velocity: velocities[vertex],
        });
    }
    for (vertex, &first) in weld(positions).iter().enumerate() {
        let first = first as usize;
        if velocities[first] != velocities[vertex] {
            return Err(ParameterError::Torn {
                shape: shape.into(),
                vertices: [first, vertex],
                velocities: [velocities[first], velocities[vertex]],
            });
        }
    }
    let mut tangent = Tangent::zero(scene);
    tangent.shapes[index] = Some(ShapeVectors {
        vertices: velocities,
        normals: None,
    });
    Ok(tangent)
}
