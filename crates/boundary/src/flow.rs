//! How a sampled direction moves with the scene, as any linear map from velocities: what a
//! [`CustomField`](crate::CustomField) comes down to.

use capwalk_math::Vec3;

/// What a direction moves with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlowSource {
    /// A point of the boundaries: a vertex of the joined mesh, or an end of a
    /// crossing.
    Point(u32),
    /// The point that the direction starts from.
    Viewpoint,
}

/// The share of one source.
#[derive(Clone, Copy, Debug)]
struct Term {
    source: FlowSource,
    /// Columns of the symmetric or general map from the source's velocity to
    /// that of the direction: what a unit velocity along each axis gives.
    columns: [Vec3; 3],
    /// The covector on the source's velocity in the divergence.
    divergence: Vec3,
}

/// The velocity of a unit direction, radians, and the divergence of the field that gives it, linear
/// in the velocities of a few points. By default there are none, and the direction does not move.
/// Applied to velocities it serves forward derivatives, transposed reverse ones (METHOD 5).
#[derive(Clone, Debug, Default)]
pub struct Flow {
    terms: Vec<Term>,
}

impl Flow {
    /// Adds the share of a source: what unit velocities along the axes do to the
    /// direction, and the covector on its velocity in the divergence.
    pub fn add(&mut self, source: FlowSource, columns: [Vec3; 3], divergence: Vec3) {
        self.terms.push(Term {
            source,
            columns,
            divergence,
        });
    }

    /// What the direction moves with.
    pub fn sources(&self) -> impl Iterator<Item = FlowSource> {
        self.terms.iter().map(|term| term.source)
    }

    /// The direction's velocity (not yet projected on its tangent space) and the
    /// divergence, for the given velocities.
    pub fn evaluate(&self, velocity: impl Fn(FlowSource) -> Vec3) -> (Vec3, f64) {
        let start = (Vec3::zero(), 0.0);
        self.terms.iter().fold(start, |(u, divergence), term| {
            let v = velocity(term.source);
            let [x, y, z] = term.columns;
            (
                u + x * v.x + y * v.y + z * v.z,
                divergence + term.divergence.dot(v),
            )
        })
    }

    /// The transposed map: from the adjoints of the direction (tangent to it) and
    /// of the divergence to covectors on the sources' velocities.
    pub fn pull(&self, direction: Vec3, divergence: f64, mut sink: impl FnMut(FlowSource, Vec3)) {
        for term in &self.terms {
            let [x, y, z] = term.columns.map(|column| column.dot(direction));
            sink(
                term.source,
                Vec3::new(x, y, z) + term.divergence * divergence,
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pulling_is_the_transpose_of_evaluating() {
        let mut flow = Flow::default();
        let v = |i: u32| Vec3::new((1.0 + f64::from(i)).sin(), 0.3 * f64::from(i), -0.7);
        flow.add(FlowSource::Point(3), [v(1), v(2), v(3)], v(4));
        flow.add(FlowSource::Viewpoint, [v(5), v(6), v(7)], v(8));
        let velocity = |source| match source {
            FlowSource::Point(i) => v(i),
            FlowSource::Viewpoint => v(20),
        };
        let (u, divergence) = flow.evaluate(velocity);
        let (on_u, on_divergence) = (v(9), 1.7);
        let forward = u.dot(on_u) + divergence * on_divergence;
        let mut reverse = 0.0;
        flow.pull(on_u, on_divergence, |source, covector| {
            reverse += covector.dot(velocity(source));
        });
        assert!((forward - reverse).abs() < 1e-14, "{forward} {reverse}");
    }
}
