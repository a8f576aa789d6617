//! A number for every number of a scene: how fast it changes ([`Tangent`]), or what a loss
//! gains by its change ([`Gradient`]).

use std::array;
use std::marker::PhantomData;
use std::sync::Arc;

use capwalk_math::{Affine, Dual, Rgb, Vec3};
use serde::Serialize;

use crate::emitter::Emitter;
use crate::ids::{ShapeId, TextureId};
use crate::scene::Scene;
use crate::sensor::{Optic, Sensor, SensorState};
use crate::shape::{ShadingNormals, vertex_normals};
use crate::texture::texel;

/// A vector with the form of a scene's numbers: those of shapes, textures, lights and the
/// sensor.
/// `K` tells velocities from derivatives, so that none is taken for the other.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SceneVector<K> {
    /// One per shape; `None` is zero.
    pub shapes: Vec<Option<ShapeVectors>>,
    /// One per texture, in the form of its data; `None` is zero.
    pub textures: Vec<Option<Vec<f64>>>,
    /// One per emitter: how lights without extent move. The others have none of their own.
    pub emitters: Vec<EmitterVectors>,
    /// The sensor.
    pub sensor: SensorVectors,
    kind: PhantomData<K>,
}

/// A direction in parameter space: how fast every number of a scene changes for a unit
/// change of the parameter.
pub type Tangent = SceneVector<Velocities>;

/// The derivative of a loss with respect to every number of a scene, per unit of that
/// number. Its [product](Gradient::dot) with a [`Tangent`] is the derivative along it.
pub type Gradient = SceneVector<Derivatives>;

/// What a [`Tangent`] is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Velocities {}

/// What a [`Gradient`] is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Derivatives {}

/// Vectors of a shape.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShapeVectors {
    /// One per vertex, world units (or per world unit).
    pub vertices: Vec<Vec3>,
    /// One per vertex, orthogonal to its normal, for shapes with normals given with the
    /// mesh. Computed normals follow the vertices, see [`Scene::normal_velocities`].
    pub normals: Option<Vec<Vec3>>,
}

/// Vectors of an emitter without extent; zero by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct EmitterVectors {
    /// The part of its position, world units (or per world unit).
    pub translation: Vec3,
    /// The part of its rotation about its position, radians (or per radian), in world axes.
    pub rotation: Vec3,
}

impl EmitterVectors {
    fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Self {
            translation: self.translation.map(&f),
            rotation: self.rotation.map(&f),
        }
    }
}

/// Vectors of the sensor; zero by default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct SensorVectors {
    /// The part of its origin, world units (or per world unit).
    pub translation: Vec3,
    /// The part of its rotation about its origin, radians (or per radian), in world axes.
    pub rotation: Vec3,
    /// The part of the images of the camera's axes, the columns of `world_from_camera`, besides the
    /// rotation.
    pub axes: [Vec3; 3],
    /// The part of its other numbers, by [`Optic`].
    pub optics: Vec3,
}

impl SensorVectors {
    fn vectors(&self) -> [Vec3; 6] {
        let [a, b, c] = self.axes;
        [self.translation, self.rotation, a, b, c, self.optics]
    }

    fn from_vectors([translation, rotation, a, b, c, optics]: [Vec3; 6]) -> Self {
        Self {
            translation,
            rotation,
            axes: [a, b, c],
            optics,
        }
    }

    /// Changes one of the other numbers, too.
    pub fn add_optic(&mut self, optic: Optic, velocity: f64) {
        let mut optics = self.optics.to_array();
        optics[optic as usize] += velocity;
        self.optics = optics.into();
    }

    /// True if rays start elsewhere or turn: not if they only reach other
    /// places of the film, as with another field of view.
    pub fn moves_rays(&self) -> bool {
        let [pose @ .., optics] = self.vectors();
        pose.iter().any(|&v| v != Vec3::zero()) || optics[Optic::ApertureRadius as usize] != 0.0
    }
}

impl<K> SceneVector<K> {
    /// A vector of its parts, one per shape, one per texture and one per emitter.
    pub fn new(
        shapes: Vec<Option<ShapeVectors>>,
        textures: Vec<Option<Vec<f64>>>,
        emitters: Vec<EmitterVectors>,
        sensor: SensorVectors,
    ) -> Self {
        Self {
            shapes,
            textures,
            emitters,
            sensor,
            kind: PhantomData,
        }
    }

    /// All numbers are zero.
    pub fn zero(scene: &Scene) -> Self {
        Self {
            shapes: vec![None; scene.shapes.len()],
            textures: vec![None; scene.textures.len()],
            emitters: vec![EmitterVectors::default(); scene.emitters.len()],
            sensor: SensorVectors::default(),
            kind: PhantomData,
        }
    }

    /// Adds another one.
    pub fn add(&mut self, other: &Self) {
        self.add_scaled(other, 1.0);
    }

    /// Adds `factor` times another one.
    pub fn add_scaled(&mut self, other: &Self, factor: f64) {
        for (own, others) in self.shapes.iter_mut().zip(&other.shapes) {
            if let Some(others) = others {
                let own = own.get_or_insert_with(|| ShapeVectors {
                    vertices: vec![Vec3::zero(); others.vertices.len()],
                    normals: None,
                });
                own.add_scaled(others, factor);
            }
        }
        for (own, others) in self.textures.iter_mut().zip(&other.textures) {
            if let Some(others) = others {
                let own = own.get_or_insert_with(|| vec![0.0; others.len()]);
                let pairs = own.iter_mut().zip(others);
                pairs.for_each(|(own, &other)| *own += other * factor);
            }
        }
        for (own, others) in self.emitters.iter_mut().zip(&other.emitters) {
            own.translation += others.translation * factor;
            own.rotation += others.rotation * factor;
        }
        let (own, others) = (self.sensor.vectors(), other.sensor.vectors());
        let sum = array::from_fn(|i| own[i] + others[i] * factor);
        self.sensor = SensorVectors::from_vectors(sum);
    }

    /// The vector with every number replaced by a function of it, which must keep zero.
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        let map = |v: &[Vec3]| v.iter().map(|v| v.map(&f)).collect::<Vec<_>>();
        let shape = |shape: &ShapeVectors| ShapeVectors {
            vertices: map(&shape.vertices),
            normals: shape.normals.as_ref().map(|normals| map(normals)),
        };
        let texture = |data: &Vec<f64>| data.iter().map(|&x| f(x)).collect();
        Self {
            shapes: self.shapes.iter().map(|s| s.as_ref().map(shape)).collect(),
            textures: self
                .textures
                .iter()
                .map(|t| t.as_ref().map(texture))
                .collect(),
            emitters: self.emitters.iter().map(|e| e.map(&f)).collect(),
            sensor: SensorVectors::from_vectors(self.sensor.vectors().map(|v| v.map(&f))),
            kind: PhantomData,
        }
    }

    /// All numbers that are not zero for the lack of them.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let shapes = self.shapes.iter().flatten().flat_map(|shape| {
            let normals = shape.normals.iter().flatten();
            shape.vertices.iter().chain(normals).copied()
        });
        let emitters = self.emitters.iter();
        let emitters = emitters.flat_map(|light| [light.translation, light.rotation]);
        let vectors = shapes.chain(emitters).chain(self.sensor.vectors());
        let textures = self.textures.iter().flatten().flatten().copied();
        vectors.flat_map(|v| v.to_array()).chain(textures)
    }

    /// `factor` times the vector.
    pub fn scaled(&self, factor: f64) -> Self {
        self.map(|x| x * factor)
    }
}

impl Tangent {
    /// Change of a texel of a texture.
    #[inline]
    pub fn texel(&self, scene: &Scene, id: TextureId, index: usize) -> Rgb {
        match &self.textures[id.0 as usize] {
            Some(velocities) => texel(velocities, scene.texture(id).channels, index),
            None => Rgb::zero(),
        }
    }

    /// Adds velocities of a shape's vertices and normals.
    pub fn add_to_shape(&mut self, id: ShapeId, velocities: ShapeVectors) {
        match &mut self.shapes[id.0 as usize] {
            Some(own) => own.add_scaled(&velocities, 1.0),
            rest => *rest = Some(velocities),
        }
    }
}

impl Gradient {
    /// The derivative along a tangent: the sum of the products of corresponding numbers.
    pub fn dot(&self, other: &Tangent) -> f64 {
        let dot = |a: &[Vec3], b: &[Vec3]| a.iter().zip(b).map(|(a, &b)| a.dot(b)).sum::<f64>();
        let shapes = self.shapes.iter().zip(&other.shapes);
        let of_shapes: f64 = shapes
            .filter_map(|(a, b)| {
                let (a, b) = (a.as_ref()?, b.as_ref()?);
                let normals = a.normals.as_ref().zip(b.normals.as_ref());
                let of_normals = normals.map_or(0.0, |(a, b)| dot(a, b));
                Some(dot(&a.vertices, &b.vertices) + of_normals)
            })
            .sum();
        let textures = self.textures.iter().zip(&other.textures);
        let of_textures: f64 = textures
            .filter_map(|(a, b)| Some((a.as_ref()?, b.as_ref()?)))
            .flat_map(|(a, b)| a.iter().zip(b).map(|(a, b)| a * b))
            .sum();
        let emitters = self.emitters.iter().zip(&other.emitters);
        let of_emitters: f64 = emitters
            .map(|(a, b)| a.translation.dot(b.translation) + a.rotation.dot(b.rotation))
            .sum();
        of_shapes + of_textures + of_emitters + dot(&self.sensor.vectors(), &other.sensor.vectors())
    }
}

impl ShapeVectors {
    /// Adds `factor` times another one.
    pub fn add_scaled(&mut self, other: &Self, factor: f64) {
        let add = |own: &mut [Vec3], others: &[Vec3]| {
            let pairs = own.iter_mut().zip(others);
            pairs.for_each(|(own, &other)| *own += other * factor);
        };
        add(&mut self.vertices, &other.vertices);
        if let Some(others) = &other.normals {
            let own = (self.normals).get_or_insert_with(|| vec![Vec3::zero(); others.len()]);
            add(own, others);
        }
    }
}

impl Sensor {
    /// Its numbers with their velocities.
    pub fn moving_state(&self, tangent: &SensorVectors) -> SensorState<Dual<1>> {
        let SensorState {
            axes,
            origin,
            optics,
        } = self.state();
        let turning = |i: usize| tangent.rotation.cross(axes[i]) + tangent.axes[i];
        SensorState {
            axes: [0, 1, 2].map(|i| axes[i].with_tangent(turning(i))),
            origin: origin.with_tangent(tangent.translation),
            optics: optics.with_tangent(tangent.optics),
        }
    }

    /// Moves on along a motion for `step`, turning rigidly where it turns.
    fn move_along(&mut self, tangent: &SensorVectors, step: f64) {
        let camera = &mut self.world_from_camera;
        let origin = camera.translation + tangent.translation * step;
        let rate = tangent.rotation.length();
        if rate > 0.0 {
            *camera = Affine::rotate(tangent.rotation, rate * step) * *camera;
        }
        for (i, row) in camera.rows.iter_mut().enumerate() {
            *row += Vec3::from(tangent.axes.map(|axis| axis[i])) * step;
        }
        camera.translation = origin;
        for optic in Optic::ALL {
            if let Some(number) = self.model.optic_mut(optic) {
                *number += tangent.optics[optic as usize] * step;
            }
        }
    }
}

impl Emitter {
    /// Moves on along a motion for `step`, turning rigidly; emitters with an extent stay.
    fn move_along(&mut self, tangent: &EmitterVectors, step: f64) {
        let turn = || match tangent.rotation.length() {
            0.0 => Affine::IDENTITY,
            rate => Affine::rotate(tangent.rotation, rate * step),
        };
        match self {
            Self::Area { .. } | Self::Constant { .. } | Self::EnvironmentMap { .. } => {}
            Self::Point { position, .. } => *position += tangent.translation * step,
            Self::Spot {
                world_from_emitter, ..
            }
            | Self::Projector {
                world_from_emitter, ..
            } => {
                let origin = world_from_emitter.translation + tangent.translation * step;
                *world_from_emitter = turn() * *world_from_emitter;
                world_from_emitter.translation = origin;
            }
            Self::Directional { direction, .. } => {
                *direction = turn().vector(*direction).normalized();
            }
        }
    }
}

impl Scene {
    /// The scene after the motion has gone on for `step`: vertices, normals
    /// and numbers along straight lines, the sensor turning rigidly. Its
    /// derivative at `step = 0` is the motion; differences of it are what
    /// derivatives are checked against. Shapes and textures that stay are shared with
    /// this scene.
    pub fn moved(&self, tangent: &Tangent, step: f64) -> Scene {
        let mut scene = self.clone();
        let along = |values: &mut [Vec3], velocities: &[Vec3]| {
            values
                .iter_mut()
                .zip(velocities)
                .for_each(|(p, &v)| *p += v * step);
        };
        for (shape, tangent) in scene.shapes.iter_mut().zip(&tangent.shapes) {
            let Some(tangent) = tangent else { continue };
            let shape = Arc::make_mut(shape);
            along(&mut shape.mesh.positions, &tangent.vertices);
            match (&mut shape.normals, &tangent.normals) {
                (ShadingNormals::Given(normals), Some(velocities)) => {
                    along(normals, velocities);
                    normals.iter_mut().for_each(|n| *n = n.normalized());
                }
                (ShadingNormals::Computed(normals), _) => {
                    *normals = vertex_normals(&shape.mesh.positions, &shape.mesh.faces);
                }
                (ShadingNormals::Face | ShadingNormals::Given(_), _) => {}
            }
        }
        for (texture, velocities) in scene.textures.iter_mut().zip(&tangent.textures) {
            let Some(velocities) = velocities else {
                continue;
            };
            let numbers = Arc::make_mut(texture).data.iter_mut().zip(velocities);
            numbers.for_each(|(x, &v)| *x += v * step);
        }
        for (emitter, tangent) in scene.emitters.iter_mut().zip(&tangent.emitters) {
            emitter.move_along(tangent, step);
        }
        scene.sensor.move_along(&tangent.sensor, step);
        scene
    }

    /// Velocities of the [anchors](Emitter::anchors) of all emitters, one after the other.
    pub fn anchor_velocities(&self, tangent: &Tangent) -> Vec<Vec3> {
        let emitters = self.emitters.iter().zip(&tangent.emitters);
        let of_each = emitters.flat_map(|(emitter, moving)| {
            let turning = move |v: Vec3| moving.rotation.cross(v);
            let anchors = emitter.anchors().into_iter().enumerate();
            anchors.map(move |(i, anchor)| match emitter.anchor_is_point(i) {
                true => moving.translation,
                false => turning(anchor),
            })
        });
        of_each.collect()
    }

    /// The transpose of [`Scene::anchor_velocities`]: what covectors on all anchors mean for
    /// the emitters.
    pub fn pull_anchors(&self, covectors: &[Vec3]) -> Vec<EmitterVectors> {
        let mut covectors = covectors.iter();
        let of_emitter = |emitter: &Emitter| {
            let mut sum = EmitterVectors::default();
            for (i, anchor) in emitter.anchors().into_iter().enumerate() {
                let covector = *covectors.next().expect("one for each anchor");
                match emitter.anchor_is_point(i) {
                    true => sum.translation += covector,
                    false => sum.rotation += anchor.cross(covector),
                }
            }
            sum
        };
        self.emitters.iter().map(of_emitter).collect()
    }

    /// Velocities of a shape's unit shading normals, one per vertex; `None` if
    /// its triangles are flat or it does not move.
    pub fn normal_velocities(&self, tangent: &Tangent, shape: usize) -> Option<Vec<Vec3>> {
        let velocities = tangent.shapes[shape].as_ref()?;
        let shape = &self.shapes[shape];
        match &shape.normals {
            ShadingNormals::Face => None,
            ShadingNormals::Given(normals) => Some(match &velocities.normals {
                Some(turning) => turning.clone(),
                None => vec![Vec3::zero(); normals.len()],
            }),
            ShadingNormals::Computed(_) => {
                let positions = shape.mesh.positions.iter();
                let moving: Vec<_> = positions
                    .zip(&velocities.vertices)
                    .map(|(p, &v)| p.with_tangent(v))
                    .collect();
                let normals = vertex_normals(&moving, &shape.mesh.faces);
                Some(normals.into_iter().map(|n| n.tangent(0)).collect())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::builtin;
    use crate::params;

    /// A scene that moves copies what moves, and shares everything else.
    #[test]
    fn what_stays_is_shared() {
        let scene = builtin::scene("leaf").expect("built in");
        let expression = "leaf.translate.x + lamp.emitter.radiance.value";
        let tangent = params::Registry::new(&scene)
            .tangent(&scene, expression)
            .expect("parameters");
        let moved = scene.moved(&tangent, 0.5);
        for (i, shape) in scene.shapes.iter().enumerate() {
            assert_eq!(Arc::ptr_eq(shape, &moved.shapes[i]), shape.id != "leaf");
        }
        for (i, texture) in scene.textures.iter().enumerate() {
            let stays = texture.id != "lamp.emitter.radiance";
            assert_eq!(Arc::ptr_eq(texture, &moved.textures[i]), stays);
        }
    }
}
