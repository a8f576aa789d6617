//! One variable: numbers that are looked for together.

use std::ops::Range;

use capwalk_scene::params::ArrayParameter;
use capwalk_scene::{Scene, Tangent};

use super::pose::{PoseComponent, PoseLimit};
use super::reparameterization::Reparameterization;
use super::vertices::Vertices;

/// Numbers that are looked for together.
#[derive(Clone, Debug)]
pub struct Variable {
    /// What the user called it.
    pub name: String,
    /// Its values before the first step.
    pub initial: Vec<f64>,
    /// What is between unknowns and values.
    pub reparameterization: Reparameterization,
    /// Its own learning rate, if it has one.
    pub lr: Option<f64>,
    /// True if all its unknowns take steps by the same rate.
    pub uniform: bool,
    pub(crate) map: Map,
}

/// What values do to a scene.
#[derive(Clone, Debug)]
pub(crate) enum Map {
    /// They are the numbers of an array.
    Array(ArrayParameter),
    /// The first is how far everything has gone along a motion in straight
    /// lines, from where it was when the value was `from`.
    Line { tangent: Box<Tangent>, from: f64 },
    /// Displacements of vertices.
    Vertices(Vertices),
    /// Numbers of the place of a shape.
    Pose {
        shape: usize,
        parts: Vec<PoseComponent>,
    },
    /// Numbers of the vector about which the sensor turns, from this axis on.
    Turn { axes: Range<usize> },
}

impl Map {
    /// The first of the values that makes no scene, and which limit it is beyond.
    pub fn refused(&self, values: &[f64]) -> Option<(f64, PoseLimit)> {
        let refused = |parts: &[PoseComponent]| {
            let mut pairs = parts.iter().zip(values);
            pairs.find_map(|(part, &value)| Some((value, part.exceeded(value)?)))
        };
        match self {
            Self::Pose { parts, .. } => refused(parts),
            Self::Turn { axes } => {
                let parts: Vec<_> = axes.clone().map(PoseComponent::Rotate).collect();
                refused(&parts)
            }
            Self::Array(_) | Self::Line { .. } | Self::Vertices(_) => None,
        }
    }
}

/// A turn of the sensor about a vector, of which some numbers are given.
pub(crate) fn turn(base: &Scene, axes: &Range<usize>, numbers: &[f64]) -> Tangent {
    let mut vector = [0.0; 3];
    vector[axes.clone()].copy_from_slice(numbers);
    let mut tangent = Tangent::zero(base);
    tangent.sensor.rotation = vector.into();
    tangent
}
