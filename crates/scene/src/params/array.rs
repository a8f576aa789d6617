//! Arrays: numbers of the scene that may each change by itself, such as the
//! vertices of a mesh. Reverse mode gives the gradient of a loss with respect to all of
//! them; an optimiser reads and writes them.

use std::borrow::Cow;
use std::ops::Range;

use capwalk_geometry::topology::weld;
use capwalk_math::{Affine, Vec3};

use super::error::ParameterError;
use super::matrix;
use super::optic::{optic_scale, optic_value};
use super::parameter::ParameterKind;
use super::velocity::vertex_tangent;
use crate::ids::{EmitterId, ShapeId, TextureId};
use crate::scene::Scene;
use crate::scene_vector::{Gradient, ShapeVectors, Tangent};
use crate::sensor::Optic;
use crate::shape::{ShadingNormals, vertex_normals};
use crate::texture::NamedTexels;

/// An array of numbers of the scene, each of which may change by itself.
#[derive(Clone, Debug, PartialEq)]
pub struct ArrayParameter {
    /// What it is called.
    pub name: String,
    /// What sort of numbers are in it.
    pub kind: ParameterKind,
    /// Its dimensions; numbers are in row-major order.
    pub shape: Vec<usize>,
    /// Unit of its numbers.
    pub unit: &'static str,
    /// True if edges move, seen from somewhere: the derivative then has a
    /// boundary part.
    pub moves_discontinuities: bool,
    /// What is in it, in a few words.
    pub description: String,
    /// The name under which the same array is listed first, if this is only
    /// another name for it.
    pub alias_of: Option<String>,
    pub(super) place: Place,
}

/// Where its numbers are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    Positions(ShapeId),
    Normals(ShapeId),
    Texels(TextureId, NamedTexels),
    ShapeToWorld(ShapeId),
    ShapeTranslation(ShapeId),
    LightTranslation(EmitterId),
    LightPosition(EmitterId),
    LightRotation(EmitterId),
    SensorTranslation,
    SensorRotation,
    SensorToWorld,
    SensorOptic(Optic),
}

/// The shape of an array as NumPy writes it: `(162, 3)`, `(3,)`.
pub fn shape_text(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        _ => {
            let sides: Vec<String> = shape.iter().map(ToString::to_string).collect();
            format!("({})", sides.join(", "))
        }
    }
}

impl ArrayParameter {
    /// How many numbers it has.
    pub fn count(&self) -> usize {
        self.shape.iter().product()
    }

    /// Its shape, see [`shape_text`].
    pub fn shape_text(&self) -> String {
        shape_text(&self.shape)
    }

    /// Its numbers. Translations and rotations are zero: they are changes of where things are.
    pub fn get(&self, scene: &Scene) -> Vec<f64> {
        match self.place {
            Place::Positions(id) => flat(&scene.shape(id).mesh.positions),
            Place::Normals(id) => flat(scene.shape(id).normals.per_vertex().unwrap_or_default()),
            Place::Texels(id, part) => scene.texture(id).data[numbers_of(scene, id, part)].to_vec(),
            Place::ShapeToWorld(id) => matrix::numbers(&scene.shape(id).world_from_object),
            Place::ShapeTranslation(_)
            | Place::LightTranslation(_)
            | Place::LightRotation(_)
            | Place::SensorTranslation
            | Place::SensorRotation => vec![0.0; 3],
            Place::LightPosition(id) => scene.emitter(id).anchors()[0].to_array().to_vec(),
            Place::SensorToWorld => matrix::numbers(&scene.sensor.world_from_camera),
            Place::SensorOptic(optic) => vec![optic_value(scene, optic)],
        }
    }

    /// Replaces its numbers. Computed normals follow the positions, given ones
    /// are made unit; shapes, the sensor and lights move from where they are, and turn by a
    /// vector along the axis with the angle as its length. A matrix takes the shape with
    /// it, and a translation takes the matrix with it.
    ///
    /// Refuses another count, numbers that are not finite, normals without
    /// direction, matrices that cannot be inverted or whose last row is not `0 0 0
    /// 1`, and positions that part vertices which lie at the same place,
    /// and leaves the scene as it was then. Ask [`Scene::check`] whether what
    /// came out can be rendered.
    pub fn set(&self, scene: &mut Scene, numbers: &[f64]) -> Result<(), ParameterError> {
        self.check(scene, numbers)?;
        match self.place {
            Place::Positions(id) => {
                let (shape, positions) = (scene.shape(id), vectors(numbers));
                refuse_tears(&shape.id, &shape.mesh.positions, &positions)?;
                let shape = scene.shape_mut(id);
                shape.mesh.positions = positions;
                if let ShadingNormals::Computed(normals) = &mut shape.normals {
                    *normals = vertex_normals(&shape.mesh.positions, &shape.mesh.faces);
                }
            }
            Place::Normals(id) => {
                let normals = vectors(numbers).into_iter().map(Vec3::normalized).collect();
                scene.shape_mut(id).normals = ShadingNormals::Given(normals);
            }
            Place::Texels(id, part) => {
                let range = numbers_of(scene, id, part);
                scene.texture_mut(id).data[range].copy_from_slice(numbers);
            }
            Place::ShapeToWorld(id) => {
                matrix::place(scene.shape_mut(id), matrix::affine(numbers));
            }
            Place::ShapeTranslation(id) => {
                *scene = scene.moved(&self.tangent(scene, numbers), 1.0);
                let place = &mut scene.shape_mut(id).world_from_object;
                *place = Affine::translate(vectors(numbers)[0]) * *place;
            }
            Place::LightPosition(id) => {
                let offset = vectors(numbers)[0] - scene.emitter(id).anchors()[0];
                *scene = scene.moved(&self.tangent(scene, &offset.to_array()), 1.0);
            }
            Place::LightTranslation(_)
            | Place::LightRotation(_)
            | Place::SensorTranslation
            | Place::SensorRotation => {
                *scene = scene.moved(&self.tangent(scene, numbers), 1.0);
            }
            Place::SensorToWorld => scene.sensor.world_from_camera = matrix::affine(numbers),
            Place::SensorOptic(optic) => {
                if let Some(number) = scene.sensor.model.optic_mut(optic) {
                    *number = numbers[0] * optic_scale(optic);
                }
            }
        }
        Ok(())
    }

    /// As many numbers as the array has, all of them finite.
    fn check_finite(&self, numbers: &[f64]) -> Result<(), ParameterError> {
        if numbers.len() != self.count() {
            return Err(ParameterError::ArrayLength {
                name: self.name.clone(),
                shape: self.shape_text(),
                numbers: self.count(),
                given: numbers.len(),
            });
        }
        match numbers.iter().position(|x| !x.is_finite()) {
            Some(index) => Err(self.bad(numbers, index, "finite numbers")),
            None => Ok(()),
        }
    }

    fn bad(&self, numbers: &[f64], index: usize, expected: &'static str) -> ParameterError {
        ParameterError::BadNumber {
            name: self.name.clone(),
            index,
            value: numbers[index],
            expected,
        }
    }

    fn check(&self, scene: &Scene, numbers: &[f64]) -> Result<(), ParameterError> {
        self.check_finite(numbers)?;
        let bad = |index: usize, expected| self.bad(numbers, index, expected);
        if let Place::Normals(_) = self.place {
            let zero = vectors(numbers).iter().position(|n| n.length() == 0.0);
            if let Some(vertex) = zero {
                return Err(bad(3 * vertex, "normals that are longer than 0"));
            }
        }
        let old = match self.place {
            Place::ShapeToWorld(id) => &scene.shape(id).world_from_object,
            Place::SensorToWorld => &scene.sensor.world_from_camera,
            _ => return Ok(()),
        };
        match matrix::refusal(numbers, old) {
            None => Ok(()),
            Some((index, expected)) => Err(bad(index, expected)),
        }
    }

    /// The motion in which its numbers change at these velocities. Normals turn and
    /// stay unit; the last row of a matrix stays as it is.
    ///
    /// # Panics
    /// If there are not as many.
    pub fn tangent(&self, scene: &Scene, velocities: &[f64]) -> Tangent {
        assert_eq!(velocities.len(), self.count(), "{}", self.name);
        let mut tangent = Tangent::zero(scene);
        match self.place {
            Place::Positions(id) => {
                tangent.shapes[id.0 as usize] = Some(ShapeVectors {
                    vertices: vectors(velocities),
                    normals: None,
                });
            }
            Place::Normals(id) => {
                let normals = scene.shape(id).normals.per_vertex().unwrap_or_default();
                let turning = normals.iter().zip(vectors(velocities));
                tangent.shapes[id.0 as usize] = Some(ShapeVectors {
                    vertices: vec![Vec3::zero(); self.shape[0]],
                    normals: Some(turning.map(|(&n, v)| v.reject_from(n)).collect()),
                });
            }
            Place::Texels(id, part) => {
                let mut data = vec![0.0; scene.texture(id).data.len()];
                data[numbers_of(scene, id, part)].copy_from_slice(velocities);
                tangent.textures[id.0 as usize] = Some(data);
            }
            Place::ShapeToWorld(id) => {
                let of_shape = matrix::shape_vectors(scene.shape(id), velocities);
                tangent.shapes[id.0 as usize] = Some(of_shape);
            }
            Place::ShapeTranslation(id) => {
                let vertices = vec![vectors(velocities)[0]; scene.shape(id).mesh.positions.len()];
                tangent.shapes[id.0 as usize] = Some(ShapeVectors {
                    vertices,
                    normals: None,
                });
            }
            Place::LightTranslation(id) | Place::LightPosition(id) => {
                tangent.emitters[id.0 as usize].translation = vectors(velocities)[0];
            }
            Place::LightRotation(id) => {
                tangent.emitters[id.0 as usize].rotation = vectors(velocities)[0];
            }
            Place::SensorTranslation => tangent.sensor.translation = vectors(velocities)[0],
            Place::SensorRotation => tangent.sensor.rotation = vectors(velocities)[0],
            Place::SensorToWorld => tangent.sensor = matrix::sensor_vectors(velocities),
            Place::SensorOptic(optic) => {
                tangent
                    .sensor
                    .add_optic(optic, velocities[0] * optic_scale(optic));
            }
        }
        tangent
    }

    /// [`ArrayParameter::tangent`] of velocities that somebody gives: refuses another count,
    /// numbers that are not finite, and those that part vertices at the same place.
    pub fn given_tangent(
        &self,
        scene: &Scene,
        velocities: &[f64],
    ) -> Result<Tangent, ParameterError> {
        self.check_finite(velocities)?;
        match self.place {
            Place::Positions(id) => vertex_tangent(scene, &scene.shape(id).id, vectors(velocities)),
            _ => Ok(self.tangent(scene, velocities)),
        }
    }

    /// What a gradient says about its numbers: the derivative with respect to each, so that a step along it is one that
    /// [`ArrayParameter::set`] takes. Vertices at the same place share the sum
    /// of their derivatives evenly, because they must stay together, and
    /// derivatives with respect to normals are orthogonal to them, because their length does
    /// not count. Linear in the gradient; zero if it was not asked for this.
    pub fn gradient(&self, scene: &Scene, gradient: &Gradient) -> Vec<f64> {
        self.pull_back(scene)(gradient).into_owned()
    }

    /// [`ArrayParameter::gradient`] of any gradient. What depends on the scene alone is found out
    /// once, and numbers that a gradient has in this form are not copied.
    pub fn pull_back<'s>(
        &'s self,
        scene: &'s Scene,
    ) -> impl for<'g> Fn(&'g Gradient) -> Cow<'g, [f64]> + 's {
        let welded = match self.place {
            Place::Positions(id) => weld(&scene.shape(id).mesh.positions),
            _ => Vec::new(),
        };
        move |gradient| {
            if let Place::Texels(id, part) = self.place
                && let Some(data) = &gradient.textures[id.0 as usize]
            {
                return data[numbers_of(scene, id, part)].into();
            }
            self.pulled(scene, &welded, gradient).into()
        }
    }

    /// [`ArrayParameter::gradient`] of what is not borrowed from it. `welded` has for each of a
    /// shape's positions the first vertex there.
    fn pulled(&self, scene: &Scene, welded: &[u32], gradient: &Gradient) -> Vec<f64> {
        match self.place {
            Place::Positions(id) => {
                let of_shape = gradient.shapes[id.0 as usize].as_ref();
                of_shape.map(|shape| flat(&shared(welded, &shape.vertices)))
            }
            Place::Normals(id) => {
                let of_shape = gradient.shapes[id.0 as usize].as_ref();
                let covectors = of_shape.and_then(|shape| shape.normals.as_ref());
                covectors
                    .zip(scene.shape(id).normals.per_vertex())
                    .map(|(covectors, normals)| {
                        let pairs = covectors.iter().zip(normals);
                        let tangent = pairs.map(|(covector, &n)| covector.reject_from(n));
                        flat(&tangent.collect::<Vec<_>>())
                    })
            }
            // It was not asked for.
            Place::Texels(..) => None,
            Place::ShapeToWorld(id) => {
                let of_shape = gradient.shapes[id.0 as usize].as_ref();
                of_shape.map(|covectors| matrix::shape_gradient(scene.shape(id), covectors))
            }
            Place::ShapeTranslation(id) => {
                let of_shape = gradient.shapes[id.0 as usize].as_ref();
                let total = |vectors: &[Vec3]| vectors.iter().fold(Vec3::zero(), |sum, &v| sum + v);
                of_shape.map(|shape| flat(&[total(&shape.vertices)]))
            }
            Place::LightTranslation(id) | Place::LightPosition(id) => {
                Some(flat(&[gradient.emitters[id.0 as usize].translation]))
            }
            Place::LightRotation(id) => Some(flat(&[gradient.emitters[id.0 as usize].rotation])),
            Place::SensorTranslation => Some(flat(&[gradient.sensor.translation])),
            Place::SensorRotation => Some(flat(&[gradient.sensor.rotation])),
            Place::SensorToWorld => Some(matrix::sensor_gradient(&gradient.sensor)),
            Place::SensorOptic(optic) => Some(vec![
                gradient.sensor.optics[optic as usize] * optic_scale(optic),
            ]),
        }
        .unwrap_or_else(|| vec![0.0; self.count()])
    }
}

/// Where the numbers of a part of a texture are in its data.
fn numbers_of(scene: &Scene, id: TextureId, part: NamedTexels) -> Range<usize> {
    let channels = scene.texture(id).channels;
    part.first * channels..(part.first + part.count) * channels
}

/// The mean of the covectors on each group of vertices at the same place, for
/// every vertex of the group. `first` is the first vertex of each one's group.
fn shared(first: &[u32], covectors: &[Vec3]) -> Vec<Vec3> {
    let mut sums = vec![Vec3::zero(); first.len()];
    let mut counts = vec![0.0; first.len()];
    for (&first, &covector) in first.iter().zip(covectors) {
        sums[first as usize] += covector;
        counts[first as usize] += 1.0;
    }
    let mean = |&first: &u32| sums[first as usize] / counts[first as usize];
    first.iter().map(mean).collect()
}

/// An error if vertices at the same place would part.
fn refuse_tears(shape: &str, old: &[Vec3], new: &[Vec3]) -> Result<(), ParameterError> {
    for (vertex, &first) in weld(old).iter().enumerate() {
        let first = first as usize;
        if new[first] != new[vertex] {
            return Err(ParameterError::Parted {
                shape: shape.into(),
                vertices: [first, vertex],
                positions: [new[first], new[vertex]],
            });
        }
    }
    Ok(())
}

fn flat(vectors: &[Vec3]) -> Vec<f64> {
    vectors.iter().flat_map(|v| v.to_array()).collect()
}

fn vectors(numbers: &[f64]) -> Vec<Vec3> {
    let rows = numbers.chunks_exact(3);
    rows.map(|row| Vec3::new(row[0], row[1], row[2])).collect()
}

#[cfg(test)]
mod tests;
