//! Single numbers of arrays: `ball.positions[12,0]`, and `ball.positions[12]`
//! for all numbers of a row together.

use std::ops::Range;

use capwalk_geometry::topology::weld;

use super::array::{ArrayParameter, Place};
use super::error::ParameterError;
use super::registry::Registry;
use crate::scene::Scene;
use crate::scene_vector::Tangent;

/// Numbers of an array that change together.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Element {
    array: ArrayParameter,
    numbers: Range<usize>,
}

/// The element that `text` starts with, if it is an array's name and a bracket,
/// and what stands behind it.
pub(super) fn leading<'a>(
    registry: &Registry,
    text: &'a str,
) -> Result<Option<(Element, &'a str)>, ParameterError> {
    let Some((name, array)) = registry.array_before_bracket(text)? else {
        return Ok(None);
    };
    let inside = &text[name.len() + 1..];
    let bad = |indices: String| ParameterError::BadIndex {
        name: name.into(),
        indices,
        shape: array.shape_text(),
    };
    let (indices, after) = inside
        .split_once(']')
        .ok_or_else(|| bad(format!("[{inside}")))?;
    let after = after.trim_start();
    let ends = after.is_empty() || after.starts_with(['+', '-']);
    let numbers = numbers(&array.shape, indices).filter(|_| ends);
    let numbers = numbers.ok_or_else(|| bad(format!("[{indices}]")))?;
    let array = array.clone();
    Ok(Some((Element { array, numbers }, after)))
}

/// Where the numbers with these first indices are in an array of this shape.
fn numbers(shape: &[usize], indices: &str) -> Option<Range<usize>> {
    let indices: Option<Vec<usize>> = indices
        .split(',')
        .map(|index| index.trim().parse().ok())
        .collect();
    let indices = indices.filter(|indices| indices.len() <= shape.len())?;
    let mut first = 0;
    for (&index, &side) in indices.iter().zip(shape) {
        first = first * side + Some(index).filter(|&index| index < side)?;
    }
    let count: usize = shape[indices.len()..].iter().product();
    Some(first * count..(first + 1) * count)
}

impl Element {
    /// The motion in which its numbers change by one per unit. Vertices at the
    /// same place move with the one that is named.
    pub fn tangent(&self, scene: &Scene) -> Tangent {
        let mut velocities = vec![0.0; self.array.count()];
        velocities[self.numbers.clone()].fill(1.0);
        if let Place::Positions(id) = self.array.place {
            let first = weld(&scene.shape(id).mesh.positions);
            let named = self.numbers.start / 3;
            let row = [0, 1, 2].map(|axis| velocities[3 * named + axis]);
            let same_place = (0..first.len()).filter(|&vertex| first[vertex] == first[named]);
            for vertex in same_place {
                velocities[3 * vertex..3 * vertex + 3].copy_from_slice(&row);
            }
        }
        self.array.tangent(scene, &velocities)
    }
}
