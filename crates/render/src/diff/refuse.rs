//! What cannot be differentiated rightly, said before or while it is tried.

use capwalk_scene::{Emitter, Scene, SensorModel, TextureId};
use capwalk_walk::WalkSettings;

use crate::accel::Accel;
use crate::estimate::Statistics;
use crate::material::{looks_turned, may_be_specular, tangents_of_face, textures_of};
use crate::options::{GradientOptions, Method, Refusal};

use super::boundary::Field;
use super::clip::refuse_clipped;
use super::explicit::MOST_EDGES;
use super::texture_line::{self, MOST_LINES};
use super::unfold::MAX_EVENTS;

/// A refusal if there are lights without extent: the edges of their shadows lie on
/// surfaces, not among directions (METHOD 7).
fn refuse_hard_shadows(scene: &Scene) -> Result<(), Refusal> {
    let is_delta = |emitter: &&Emitter| {
        matches!(
            emitter,
            Emitter::Point { .. } | Emitter::Spot { .. } | Emitter::Directional { .. }
        )
    };
    match scene.emitters.iter().find(is_delta) {
        None => Ok(()),
        Some(emitter) => Err(Refusal {
            reason: format!(
                "the emitter \"{}\" ({}) has no extent, and the motion of the hard edges of its \
                 shadows is not available. Use a small area lamp instead, or finite differences",
                emitter.name(scene),
                emitter.plugin()
            ),
        }),
    }
}

/// A refusal if the camera's rays are parallel and the method has a field around
/// points only.
fn refuse_parallel_rays(scene: &Scene, method: &Method) -> Result<(), Refusal> {
    let walks = matches!(method, Method::Walk | Method::Edges);
    match scene.sensor.model {
        SensorModel::Orthographic if !walks => Err(Refusal {
            reason: format!(
                "the method `{}` has no field for the parallel rays of an orthographic sensor. Use \
                 the default method, or a perspective sensor far away with a small fov",
                method.name()
            ),
        }),
        _ => Ok(()),
    }
}

/// A refusal if a texture jumps inside faces and the method misses its motion against
/// the rays, or if it does so along too many lines (METHOD 7).
fn refuse_jumping_textures(accel: &Accel, method: &Method) -> Result<(), Refusal> {
    let knows_lines = matches!(method, Method::Walk | Method::Edges);
    for shape in &accel.scene.shapes {
        let textures = textures_of(accel.scene, shape);
        let Some(texture) = textures.iter().find(|texture| texture_line::jumps(texture)) else {
            continue;
        };
        let count = texture_line::count(accel, shape);
        if knows_lines && count <= MOST_LINES {
            continue;
        }
        let why = match knows_lines {
            true => format!("along {count:.0} lines; expected at most {MOST_LINES:.0}"),
            false => format!(
                "and the method `{}` misses the motion of these jumps",
                method.name()
            ),
        };
        return Err(Refusal {
            reason: format!(
                "the texture \"{}\" on the shape \"{}\" jumps from texel to texel, {why}. Use the \
                 filter `bilinear`, {}or finite differences",
                texture.id,
                shape.id,
                if knows_lines {
                    ""
                } else {
                    "the default method, "
                },
            ),
        });
    }
    Ok(())
}

/// A refusal if a smooth surface looks different when it is turned, and nothing says
/// how it is turned: the frame that is then made up jumps.
pub(super) fn refuse_turned_without_uvs(scene: &Scene) -> Result<(), Refusal> {
    for shape in &scene.shapes {
        let Some(normals) = shape.normals.per_vertex() else {
            continue;
        };
        let has_map = scene.map_in(shape.bsdf).is_some();
        if !has_map && !looks_turned(scene, shape.bsdf) {
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
        let has = match shape.uvs {
            None => "no texture coordinates".into(),
            Some(_) => format!("texture coordinates without extent in face {face} (from 0)"),
        };
        return Err(Refusal {
            reason: format!(
                "the material of the shape \"{}\" {}, and its mesh has {has} to say in which \
                 directions; these jump somewhere on smooth surfaces. Add texture coordinates to \
                 the mesh that span every face",
                shape.id,
                if has_map {
                    "has a map of normals"
                } else {
                    "is anisotropic"
                },
            ),
        });
    }
    Ok(())
}

/// A refusal if a map of normals cuts light off along curves inside faces, and
/// these move: with the geometry, or with the numbers of the map.
pub(super) fn refuse_cut_normals(
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
            return Err(Refusal {
                reason: format!(
                    "without `{flag}` the {} \"{}\" cuts light off along curves inside faces, \
                     and their motion is not available. Set it to true, or use finite differences",
                    material.bsdf.plugin(),
                    material.id
                ),
            });
        }
    }
    Ok(())
}

/// True if some shape has a material that can be perfectly specular.
pub(super) fn is_specular_somewhere(scene: &Scene) -> bool {
    let mut shapes = scene.shapes.iter();
    shapes.any(|shape| may_be_specular(scene, shape.bsdf))
}

/// A refusal if something moved in a curved mirror or behind refracting glass, and
/// the method promises the truth.
pub(super) fn refuse_uncovered(
    scene: &Scene,
    statistics: &Statistics,
    method: &Method,
) -> Result<(), Refusal> {
    if statistics.uncovered == 0 || !method.is_unbiased() {
        return Ok(());
    }
    let share = statistics.uncovered as f64 / statistics.samples as f64;
    if matches!(method, Method::TriangleWalk | Method::ExplicitWalk) {
        return Err(Refusal {
            reason: format!(
                "things move that are seen in mirrors or through what lets light pass (about {:.2} \
                 specular events in 100 samples), and the motion of their outlines there is not \
                 available with fields on triangles. Use `domain` sphere, the default, which has it \
                 for flat mirrors and panes",
                100.0 * share
            ),
        });
    }
    let (sees, covered) = match scene.sensor.model {
        SensorModel::Orthographic => (
            "in mirrors by an orthographic sensor",
            "before a perspective sensor in flat mirrors",
        ),
        SensorModel::Perspective { .. } | SensorModel::ThinLens { .. } => {
            ("in curved mirrors", "in flat mirrors")
        }
    };
    Err(Refusal {
        reason: format!(
            "things move that are seen {sees}, through refracting glass, or after more than \
             {MAX_EVENTS} reflections (about {:.2} specular events in 100 samples), and the motion \
             of their outlines there is not available. It is {covered} (without vertex normals) and \
             through panes (`thindielectric`), and so are shadows seen in mirrors at rest. Use one \
             of these, a rough material (alpha of 0.01 or more), or finite differences",
            100.0 * share
        ),
    })
}

/// The reason why derivatives by whatever moves edges are refused for the scene,
/// if they are.
pub fn refusal(scene: &Scene) -> Option<Refusal> {
    let found = refuse_cut_normals(scene, true, |_| false);
    found
        .and_then(|()| refuse_motion(&Accel::new(scene), &Method::default()))
        .err()
}

/// A refusal if the scene has what cannot be differentiated by what moves edges.
pub(super) fn refuse_motion(accel: &Accel, method: &Method) -> Result<(), Refusal> {
    refuse_parallel_rays(accel.scene, method)?;
    refuse_hard_shadows(accel.scene)?;
    refuse_jumping_textures(accel, method)?;
    refuse_turned_without_uvs(accel.scene)?;
    refuse_clipped(accel)
}

/// A refusal if a method would look at too many edges.
pub(super) fn refuse_many_edges(field: &Field) -> Result<(), Refusal> {
    let count = field.boundaries.edges().len();
    if field.method != Method::ExplicitWalk || count <= MOST_EDGES {
        return Ok(());
    }
    Err(Refusal {
        reason: format!(
            "the scene has {count} edges, and walks among explicit boundaries look at all of them \
             for every direction; expected at most {MOST_EDGES}. Use `domain` triangle, which asks \
             a tree for the closest ones, or sphere"
        ),
    })
}

/// A refusal if the settings of a method do not give a field.
pub(super) fn refuse_settings(options: &GradientOptions) -> Result<(), Refusal> {
    match &options.method {
        Method::Walk | Method::Edges | Method::TriangleWalk | Method::ExplicitWalk => {
            refuse_walk(&options.walk)
        }
        Method::Was(was) | Method::PsdrWas(was)
            if was.rays == 0 || !(was.kappa > 0.0 && was.kappa.is_finite()) =>
        {
            Err(Refusal {
                reason: format!(
                    "warped-area sampling with {} auxiliary rays of concentration {}; expected \
                     at least one ray and a finite concentration above 0",
                    was.rays, was.kappa
                ),
            })
        }
        Method::Was(_) | Method::PsdrWas(_) => Ok(()),
    }
}

/// A refusal if a walk does not give a continuous field.
pub(super) fn refuse_walk(walk: &WalkSettings) -> Result<(), Refusal> {
    if walk.steps == 0 {
        return Err(Refusal {
            reason: "a walk of 0 steps gives a field that is not continuous, and a wrong \
                     derivative; use at least 1 step"
                .into(),
        });
    }
    if !(walk.max_radius > 0.0 && walk.max_radius <= std::f64::consts::PI) {
        return Err(Refusal {
            reason: format!(
                "the largest angle of a walk is {}; expected radians above 0 and at most π",
                walk.max_radius
            ),
        });
    }
    Ok(())
}
