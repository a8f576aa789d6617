//! Which derivatives are refused, decided before they are estimated.

use capwalk_scene::{BsdfId, Emitter, Scene, SensorModel, TextureId};
use capwalk_walk::WalkSettings;

use crate::accel::Accel;
use crate::boundaries::Boundaries;
use crate::clip::refuse_clipped;
use crate::material::{
    blends_images, depends_on_rotation, may_be_specular, tangents_of_face, textures_of,
};
use crate::method::Method;
use crate::refusal::Refusal;
use crate::shadow_line::MOST_SHADOW_LINES;
use crate::texture_line::{self, MOST_LINES};

pub use crate::infinite_derivative::refuse_infinite_derivatives;

/// A refusal if there are emitters without extent and the method does not cover the edges
/// of their shadows, which lie on surfaces (METHOD 7), or those of an image they project.
fn refuse_hard_shadows(scene: &Scene, method: &Method) -> Result<(), Refusal> {
    let has_borders = |emitter: &&Emitter| match emitter {
        Emitter::Projector { .. } => true,
        Emitter::Spot { texture, .. } => {
            texture.is_some_and(|id| texture_line::is_discontinuous(scene.texture(id)))
        }
        _ => false,
    };
    if let Some(emitter) = scene.emitters.iter().find(has_borders) {
        return Err(Refusal::ImageBorders {
            emitter: emitter.name(scene),
            plugin: emitter.plugin(),
        });
    }
    match scene.emitters.iter().find(|emitter| emitter.is_delta()) {
        Some(emitter) if !method.traits().is_spherical => Err(Refusal::HardShadows {
            emitter: emitter.name(scene),
            plugin: emitter.plugin(),
            method: method.name(),
        }),
        _ => Ok(()),
    }
}

/// A refusal if the edges of hard shadows consist of too many segments.
pub fn refuse_many_shadows(boundaries: &Boundaries) -> Result<(), Refusal> {
    match boundaries.has_too_many_shadow_lines {
        true => Err(Refusal::ManyShadowLines {
            most: MOST_SHADOW_LINES,
        }),
        false => Ok(()),
    }
}

/// A refusal if the camera's rays are parallel and the method has no field for them.
fn refuse_parallel_rays(scene: &Scene, method: &Method) -> Result<(), Refusal> {
    match scene.sensor.model {
        SensorModel::Orthographic if !method.traits().is_spherical => Err(Refusal::ParallelRays {
            method: method.name(),
        }),
        SensorModel::Orthographic
        | SensorModel::Perspective { .. }
        | SensorModel::ThinLens { .. } => Ok(()),
    }
}

/// A refusal if a texture is discontinuous inside faces and the method does not cover the
/// motion of these discontinuities, or if there are too many lines of them (METHOD 7).
fn refuse_discontinuous_textures(accel: &Accel, method: &Method) -> Result<(), Refusal> {
    for shape in &accel.scene.shapes {
        let textures = textures_of(&accel.scene, shape);
        let Some(texture) = textures
            .iter()
            .find(|texture| texture_line::is_discontinuous(texture))
        else {
            continue;
        };
        let (texture, shape_name) = (texture.id.clone(), shape.id.clone());
        let count = texture_line::count(accel, shape);
        if !method.traits().is_spherical {
            return Err(Refusal::TextureDiscontinuities {
                texture,
                shape: shape_name,
                method: method.name(),
            });
        }
        if count > MOST_LINES {
            return Err(Refusal::ManyTextureLines {
                texture,
                shape: shape_name,
                count,
                most: MOST_LINES,
            });
        }
    }
    Ok(())
}

/// A refusal if the material of a smooth surface depends on tangents and the mesh has no
/// texture coordinates to define them: tangents made up without them are discontinuous.
pub fn refuse_turned_without_uvs(scene: &Scene) -> Result<(), Refusal> {
    for shape in &scene.shapes {
        let Some(normals) = shape.normals.per_vertex() else {
            continue;
        };
        let has_map = scene.map_in(shape.bsdf).is_some();
        if !has_map && !depends_on_rotation(scene, shape.bsdf) {
            continue;
        }
        let is_made_up = |&face: &usize| {
            let [a, b, c] = shape.mesh.corners(face);
            tangents_of_face(shape, face, [b - a, c - a]).is_none()
        };
        let is_smooth = |&face: &usize| {
            let [a, b, c] = shape.mesh.faces[face].map(|i| normals[i as usize]);
            a != b || b != c
        };
        let mut faces = 0..shape.mesh.faces.len();
        let Some(face) = faces.find(|face| is_smooth(face) && is_made_up(face)) else {
            continue;
        };
        return Err(Refusal::UnknownTangents {
            shape: shape.id.clone(),
            has_map,
            face: shape.uvs.is_some().then_some(face),
        });
    }
    Ok(())
}

/// A refusal if a normal map cuts off light along curves inside faces, and these move with
/// the geometry or with the numbers of the map.
pub fn refuse_cut_normals(
    scene: &Scene,
    moves: bool,
    is_asked_for: impl Fn(TextureId) -> bool,
) -> Result<(), Refusal> {
    for shape in &scene.shapes {
        for id in scene.materials_below(shape.bsdf) {
            let material = scene.material(id);
            let Some(limits) = material.bsdf.normal_limits() else {
                continue;
            };
            let mut slots = material.bsdf.slots().into_iter();
            let turns = slots.any(|slot| is_asked_for(scene.numbers_of(slot.texture, shape)));
            let flag = if !limits.flip_invalid && (moves || turns) {
                "flip_invalid_normals"
            } else if !limits.shadowing && moves {
                "use_shadowing_function"
            } else {
                continue;
            };
            return Err(Refusal::CutNormals {
                material: material.id.clone(),
                plugin: material.bsdf.plugin(),
                flag,
            });
        }
    }
    Ok(())
}

/// A refusal if something can be seen in mirrors or through transparent surfaces, and the method's field has no
/// silhouettes there, or one of these shows it twice by the same events.
pub fn refuse_specular(scene: &Scene, method: &Method) -> Result<(), Refusal> {
    let two = |id: &BsdfId| blends_images(scene, *id);
    let mut blends = scene
        .shapes
        .iter()
        .flat_map(|shape| scene.materials_below(shape.bsdf));
    if let Some(id) = blends.find(two) {
        return Err(Refusal::TwoImages {
            material: scene.material(id).id.clone(),
        });
    }
    let traits = method.traits();
    match traits.is_unbiased && !traits.is_spherical && is_specular_somewhere(scene) {
        true => Err(Refusal::SpecularMotion {
            method: method.name(),
        }),
        false => Ok(()),
    }
}

/// True if some shape has a material that can be perfectly specular.
fn is_specular_somewhere(scene: &Scene) -> bool {
    let mut shapes = scene.shapes.iter();
    shapes.any(|shape| may_be_specular(scene, shape.bsdf))
}

/// A refusal if the scene has discontinuities whose motion no method covers.
pub fn refuse_motion(accel: &Accel, method: &Method) -> Result<(), Refusal> {
    refuse_parallel_rays(&accel.scene, method)?;
    refuse_hard_shadows(&accel.scene, method)?;
    refuse_discontinuous_textures(accel, method)?;
    refuse_turned_without_uvs(&accel.scene)?;
    refuse_clipped(accel)
}

/// A refusal if the method's field cannot be had among these boundaries.
pub fn refuse_boundaries(
    boundaries: &Boundaries,
    method: &Method,
    walk: &WalkSettings,
) -> Result<(), Refusal> {
    match method {
        Method::Custom(field) => field.check(boundaries, walk),
        _ => Ok(()),
    }
}

/// A refusal if the settings of a method give no valid field.
pub fn refuse_settings(method: &Method, walk: &WalkSettings) -> Result<(), Refusal> {
    match method.traits().walks {
        true => refuse_walk(walk),
        false => Ok(()),
    }
}

/// A refusal if the settings of a walk give no continuous field.
pub fn refuse_walk(walk: &WalkSettings) -> Result<(), Refusal> {
    if walk.steps == 0 {
        return Err(Refusal::NoSteps);
    }
    if !(walk.max_radius > 0.0 && walk.max_radius <= std::f64::consts::PI) {
        return Err(Refusal::MaxAngle(walk.max_radius));
    }
    Ok(())
}
