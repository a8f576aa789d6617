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

/// Elements with factors, added up. Those of one shape's vertices are so together, however many
/// there are.
#[derive(Default)]
pub(super) struct ElementSum {
    shapes: Vec<MovedVertices>,
}

impl ElementSum {
    /// Adds the motion in which the numbers of an element change by so much per unit, here or to
    /// `others`. Vertices at the same place move with the one that is named.
    pub fn add(&mut self, scene: &Scene, element: Element, factor: f64, others: &mut Tangent) {
        let Element { array, numbers } = element;
        let Place::Positions(id) = array.place else {
            let mut velocities = vec![0.0; array.count()];
            velocities[numbers].fill(1.0);
            others.add_scaled(&array.tangent(scene, &velocities), factor);
            return;
        };
        let known = self
            .shapes
            .iter()
            .position(|moved| moved.array.place == array.place);
        let place = known.unwrap_or_else(|| {
            let welded = weld(&scene.shape(id).mesh.positions);
            self.shapes.push(MovedVertices::new(array, &welded));
            self.shapes.len() - 1
        });
        self.shapes[place].add(numbers, factor);
    }

    /// The motion of all vertices.
    pub fn add_to(&self, scene: &Scene, tangent: &mut Tangent) {
        for MovedVertices {
            array, velocities, ..
        } in &self.shapes
        {
            tangent.add(&array.tangent(scene, velocities));
        }
    }
}

/// Velocities of the vertices of a shape.
struct MovedVertices {
    array: ArrayParameter,
    velocities: Vec<f64>,
    /// The next vertex at the same place, around in a circle.
    next: Vec<usize>,
}

impl MovedVertices {
    /// None moves yet; `welded` has the first vertex at the place of each.
    fn new(array: ArrayParameter, welded: &[u32]) -> Self {
        let mut next: Vec<usize> = (0..welded.len()).collect();
        for (vertex, &first) in welded.iter().enumerate() {
            next.swap(vertex, first as usize);
        }
        Self {
            velocities: vec![0.0; array.count()],
            array,
            next,
        }
    }

    /// Moves a vertex, of which these are numbers, and what is at its place.
    fn add(&mut self, numbers: Range<usize>, factor: f64) {
        let named = numbers.start / 3;
        let axes = numbers.start - 3 * named..numbers.end - 3 * named;
        let mut vertex = named;
        loop {
            let row = &mut self.velocities[3 * vertex..3 * vertex + 3];
            row[axes.clone()].iter_mut().for_each(|x| *x += factor);
            vertex = self.next[vertex];
            if vertex == named {
                break;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::time::{Duration, Instant};

    use super::super::tests::example;
    use super::*;
    use crate::primitive;

    /// Far more than they take, far less than in time proportional to the square of their number.
    const LONGEST: Duration = Duration::from_secs(8);

    /// Sums of thousands of names, and of vertices of a fine mesh, are those of a few.
    #[test]
    fn long_sums_take_little_time() {
        let mut scene = example();
        let ball = Arc::make_mut(&mut scene.shapes[0]);
        ball.mesh = primitive::icosphere(6);
        ball.normals = crate::shape::ShadingNormals::Face;
        let registry = Registry::new(&scene);
        let tangent = |text: &str| {
            let started = Instant::now();
            let tangent = registry.tangent(&scene, text).expect("a sum");
            let taken = started.elapsed();
            assert!(taken < LONGEST, "{} ... takes {taken:?}", &text[..30]);
            tangent
        };
        let times = |term: &str| vec![term; 3000].join("  + ");
        let sum = tangent(&times("ball.translate.x"));
        assert_eq!(sum, tangent("3000*ball.translate.x"));
        let sum = tangent(&times("2*ball.positions[5,1]"));
        assert_eq!(sum, tangent("6000*ball.positions[5,1]"));
    }
}
