//! All variables of a problem: the way from unknowns into the scene, and the transposed
//! way for gradients.

use std::sync::Arc;

use std::collections::BTreeMap;
use std::ops::Range;

use capwalk_diff::Wanted;
use capwalk_math::Vec3;
use capwalk_scene::{Gradient, Scene, SensorVectors, ShapeId, Tangent};

use super::error::{ApplyError, VariableError};
use super::kind::{Map, Variable, turn};
use super::overlap;
use super::pose::{Pose, left_jacobian};

/// All variables of a problem. Their unknowns stand one variable after the other.
#[derive(Clone, Debug)]
pub struct Variables {
    variables: Vec<Variable>,
    /// Where the unknowns of each are.
    ranges: Vec<Range<usize>>,
}

impl Variables {
    /// Several variables. An error names two that change the same numbers of the
    /// scene and cannot be added up.
    pub fn new(scene: &Scene, variables: Vec<Variable>) -> Result<Self, VariableError> {
        overlap::refuse(scene, &variables)?;
        let mut ranges = Vec::new();
        let mut end = 0;
        for variable in &variables {
            ranges.push(end..end + variable.initial.len());
            end += variable.initial.len();
        }
        Ok(Self { variables, ranges })
    }

    /// Each variable with the place of its unknowns.
    pub fn iter(&self) -> impl Iterator<Item = (&Variable, Range<usize>)> {
        self.variables.iter().zip(self.ranges.iter().cloned())
    }

    /// How many unknowns there are.
    pub fn count(&self) -> usize {
        self.ranges.last().map_or(0, |range| range.end)
    }

    /// The unknowns before the first step.
    pub fn initial(&self) -> Vec<f64> {
        let variables = self.variables.iter();
        variables
            .flat_map(|variable| variable.reparameterization.unknowns(&variable.initial))
            .collect()
    }

    /// The values of these unknowns.
    pub fn values(&self, unknowns: &[f64]) -> Vec<f64> {
        self.iter()
            .flat_map(|(variable, range)| variable.reparameterization.values(&unknowns[range]))
            .collect()
    }

    /// Puts every unknown back between its bounds.
    pub fn clamp(&self, unknowns: &mut [f64]) {
        for (variable, range) in self.iter() {
            variable.reparameterization.clamp(&mut unknowns[range]);
        }
    }

    /// The scene with these values: `base` is the scene that the variables were
    /// made for. An error says why it cannot be rendered.
    pub fn apply(&self, base: &Scene, values: &[f64]) -> Result<Scene, ApplyError> {
        let mut line = Tangent::zero(base);
        for (variable, range) in self.iter() {
            if let Some((value, limit)) = variable.map.refused(&values[range.clone()]) {
                let name = variable.name.clone();
                return Err(ApplyError::Pose { name, value, limit });
            }
            match &variable.map {
                Map::Line { tangent, from } => {
                    line.add_scaled(tangent, values[range.start] - from);
                }
                Map::Vertices(vertices) => line.add(&vertices.push(base, &values[range])),
                Map::Turn { axes } => line.add(&turn(base, axes, &values[range])),
                Map::Pose { .. } | Map::Array(_) => {}
            }
        }
        let mut scene = base.moved(&line, 1.0);
        for (shape, pose) in self.poses(values) {
            pose.apply(&base.shapes[shape], Arc::make_mut(&mut scene.shapes[shape]));
        }
        for (variable, range) in self.iter() {
            if let Map::Array(array) = &variable.map {
                array
                    .set(&mut scene, &values[range])
                    .map_err(ApplyError::Array)?;
            }
        }
        scene.check().map_err(ApplyError::Scene)?;
        Ok(scene)
    }

    /// How the scene moves when the values change at these velocities. `scene` is
    /// what [`Variables::apply`] made of `base` and the values.
    pub fn push(&self, base: &Scene, scene: &Scene, values: &[f64], velocities: &[f64]) -> Tangent {
        let mut tangent = Tangent::zero(scene);
        for (variable, range) in self.iter() {
            let velocities = &velocities[range.clone()];
            match &variable.map {
                Map::Array(array) => tangent.add(&array.tangent(scene, velocities)),
                Map::Line { tangent: line, .. } => tangent.add_scaled(line, velocities[0]),
                Map::Vertices(vertices) => tangent.add(&vertices.push(base, velocities)),
                Map::Pose { shape, parts } => {
                    let pose = self.poses(values)[shape];
                    for (&part, &velocity) in parts.iter().zip(velocities) {
                        let of_shape = pose.push(&base.shapes[*shape], part, velocity);
                        tangent.add_to_shape(ShapeId(*shape as u32), of_shape);
                    }
                }
                Map::Turn { axes } => {
                    let change = turn(base, axes, velocities).sensor.rotation;
                    tangent.sensor.rotation += left_jacobian(self.turned(values), change);
                }
            }
        }
        tangent
    }

    /// The derivative with respect to each value from that with respect to the scene: the
    /// transpose of [`Variables::push`]. Linear in the gradient.
    pub fn pull(
        &self,
        base: &Scene,
        scene: &Scene,
        values: &[f64],
        gradient: &Gradient,
    ) -> Vec<f64> {
        let poses = self.poses(values);
        let of = |variable: &Variable| match &variable.map {
            Map::Array(array) => array.gradient(scene, gradient),
            Map::Line { tangent, .. } => vec![gradient.dot(tangent)],
            Map::Vertices(vertices) => vertices.pull(gradient),
            Map::Pose { shape, parts } => {
                let of_shape = gradient.shapes[*shape].as_ref();
                let pull = |&part| {
                    let pull = |of_shape| poses[shape].pull(&base.shapes[*shape], part, of_shape);
                    of_shape.map_or(0.0, pull)
                };
                parts.iter().map(pull).collect()
            }
            Map::Turn { axes } => {
                // J(r)ᵀ = J(-r).
                let torque = left_jacobian(-self.turned(values), gradient.sensor.rotation);
                torque.to_array()[axes.clone()].to_vec()
            }
        };
        self.variables.iter().flat_map(of).collect()
    }

    /// The derivative with respect to each unknown from that with respect to each value.
    pub fn pull_reparameterization(&self, unknowns: &[f64], by_values: &[f64]) -> Vec<f64> {
        let of = |(variable, range): (&Variable, Range<usize>)| {
            let unknowns = &unknowns[range.clone()];
            variable
                .reparameterization
                .pull(unknowns, &by_values[range])
        };
        self.iter().flat_map(of).collect()
    }

    /// Which gradients of the scene are needed.
    pub fn wanted(&self, base: &Scene) -> Wanted {
        let mut wanted = Wanted::by(&Tangent::zero(base));
        for variable in 0..self.variables.len() {
            wanted.add(&self.wanted_by(base, variable));
        }
        wanted
    }

    /// Which are needed for one variable alone.
    pub fn wanted_by(&self, base: &Scene, variable: usize) -> Wanted {
        Wanted::by(&overlap::support(base, &self.variables[variable]))
    }

    /// Shapes whose vertices move, other than together with all others.
    pub fn deformed(&self, base: &Scene) -> Vec<usize> {
        let deforms = |variable: &&Variable| match &variable.map {
            Map::Vertices(_) | Map::Line { .. } => true,
            Map::Array(_) | Map::Pose { .. } | Map::Turn { .. } => false,
        };
        let mut found = Vec::new();
        for variable in self.variables.iter().filter(deforms) {
            let support = overlap::support(base, variable);
            let moves = |i: &usize| support.shapes[*i].is_some();
            found.extend((0..base.shapes.len()).filter(moves));
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// True if something moves the sensor.
    pub fn moves_sensor(&self, base: &Scene) -> bool {
        let mut supports = self.variables.iter().map(|v| overlap::support(base, v));
        supports.any(|support| support.sensor != SensorVectors::default())
    }

    /// What the variable is in the scene, for files: the array itself, all
    /// vertices of a shape, or the number.
    pub fn result(&self, variable: usize, scene: &Scene, values: &[f64]) -> Outcome {
        let numbers = values[self.ranges[variable].clone()].to_vec();
        let variable = &self.variables[variable];
        let (shape, numbers) = match &variable.map {
            Map::Array(array) => (array.shape.clone(), numbers),
            Map::Vertices(vertices) => {
                let positions = &scene.shapes[vertices.shape].mesh.positions;
                let rows = positions.iter().flat_map(|p| p.to_array());
                (vec![positions.len(), 3], rows.collect())
            }
            Map::Turn { .. } | Map::Pose { .. } if numbers.len() > 1 => {
                (vec![numbers.len()], numbers)
            }
            Map::Line { .. } | Map::Pose { .. } | Map::Turn { .. } => (Vec::new(), numbers),
        };
        Outcome {
            name: variable.name.clone(),
            shape,
            numbers,
        }
    }

    /// Where each shape is that has a pose among its variables.
    fn poses(&self, values: &[f64]) -> BTreeMap<usize, Pose> {
        let mut poses = BTreeMap::new();
        for (variable, range) in self.iter() {
            if let Map::Pose { shape, parts } = &variable.map {
                let pose: &mut Pose = poses.entry(*shape).or_default();
                for (&part, &value) in parts.iter().zip(&values[range]) {
                    pose.set(part, value);
                }
            }
        }
        poses
    }

    /// The vector about which the sensor has turned.
    fn turned(&self, values: &[f64]) -> Vec3 {
        let mut turned = [0.0; 3];
        for (variable, range) in self.iter() {
            if let Map::Turn { axes } = &variable.map {
                turned[axes.clone()].copy_from_slice(&values[range]);
            }
        }
        turned.into()
    }
}

/// The numbers of a variable in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// What the user called it.
    pub name: String,
    /// Dimensions; none for a single number.
    pub shape: Vec<usize>,
    /// Row by row.
    pub numbers: Vec<f64>,
}
