//! What the image changes along.

use std::borrow::Cow;
use std::collections::BTreeMap;

use capwalk::{Direction, Error, Prepared, Scene, Tangent, params};
use numpy::{PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::arrays;

/// An expression, or velocities of arrays by their names.
#[derive(FromPyObject)]
pub enum Along<'py> {
    Expression(String),
    Velocities(BTreeMap<String, PyReadonlyArrayDyn<'py, f64>>),
}

/// A direction without Python objects, for other threads.
pub enum Motion {
    Expression(String),
    Velocities(Vec<Velocities>),
}

pub struct Velocities {
    array: String,
    shape: Vec<usize>,
    numbers: Vec<f64>,
}

/// A motion of a scene, with the expression that it was asked for by.
pub struct Named<'m> {
    tangent: Tangent,
    name: Option<&'m str>,
}

impl Direction for Named<'_> {
    fn tangent(
        &self,
        scene: &Scene,
        registry: &params::Registry,
    ) -> Result<Cow<'_, Tangent>, Error> {
        self.tangent.tangent(scene, registry)
    }

    fn name(&self) -> Option<&str> {
        self.name
    }
}

impl From<Along<'_>> for Motion {
    fn from(along: Along) -> Self {
        let velocities = match along {
            Along::Expression(text) => return Self::Expression(text),
            Along::Velocities(velocities) => velocities.into_iter(),
        };
        let velocities = velocities.map(|(array, velocities)| Velocities {
            array,
            shape: velocities.shape().to_vec(),
            numbers: arrays::to_numbers(&velocities),
        });
        Self::Velocities(velocities.collect())
    }
}

impl Motion {
    /// The names of what moves, or a sum of them.
    pub fn names(&self) -> Vec<&str> {
        match self {
            Self::Expression(text) => vec![text],
            Self::Velocities(velocities) => velocities.iter().map(|v| v.array.as_str()).collect(),
        }
    }

    /// What moves in the scene.
    pub fn direction(&self, prepared: &Prepared) -> Result<Named<'_>, Error> {
        let (scene, registry) = (prepared.scene(), prepared.registry());
        let velocities = match self {
            Self::Expression(text) => {
                return Ok(Named {
                    tangent: text.tangent(scene, registry)?.into_owned(),
                    name: Some(text),
                });
            }
            Self::Velocities(velocities) => velocities,
        };
        let mut sum = Tangent::zero(scene);
        for velocity in velocities {
            let Velocities {
                array,
                shape,
                numbers,
            } = velocity;
            arrays::check_shape(array, &prepared.values(array)?.shape, shape)?;
            sum.add(&prepared.tangent(array, numbers)?);
        }
        Ok(Named {
            tangent: sum,
            name: None,
        })
    }
}
