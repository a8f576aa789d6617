//! What a step must not do to a mesh: turn a face over, or push the surface
//! through itself. Derivatives of such meshes are right, but an optimisation seldom
//! comes back from there.

pub mod cross;

use std::fmt;

use capwalk_geometry::Mesh;
use capwalk_scene::Scene;

/// What to look for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Guards {
    /// Faces that turn over.
    pub inversion: bool,
    /// Surfaces that cross themselves.
    pub self_intersection: bool,
}

impl Default for Guards {
    fn default() -> Self {
        Self {
            inversion: true,
            self_intersection: true,
        }
    }
}

/// What is wrong with a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Violation {
    /// The shape.
    pub shape: String,
    /// What happened there.
    pub kind: ViolationKind,
}

/// What can be wrong with a mesh, by faces counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ViolationKind {
    /// A face turned by a right angle or more in one step, or lost its area.
    Inverted {
        /// Which.
        face: usize,
        /// How many did.
        count: usize,
    },
    /// Two faces cross.
    Crossing {
        /// Which.
        faces: [usize; 2],
    },
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { shape, kind } = self;
        match kind {
            ViolationKind::Inverted { face, count: 1 } => {
                write!(f, "face {face} of \"{shape}\" turned over")
            }
            ViolationKind::Inverted { face, count } => {
                write!(
                    f,
                    "face {face} of \"{shape}\" turned over, as did {} more",
                    count - 1
                )
            }
            ViolationKind::Crossing { faces: [a, b] } => {
                write!(f, "faces {a} and {b} of \"{shape}\" cross each other")
            }
        }
    }
}

impl Guards {
    /// What the step from one scene to the next did wrong, in these shapes.
    pub fn step(&self, before: &Scene, after: &Scene, shapes: &[usize]) -> Option<Violation> {
        shapes.iter().find_map(|&i| {
            let (old, new) = (&before.shapes[i].mesh, &after.shapes[i].mesh);
            let turned = self.inversion.then(|| inverted(old, new)).flatten();
            self.violation(after, i, turned.or_else(|| self.crossing(new)))
        })
    }

    /// What is wrong with a scene before the first step, in these shapes.
    pub fn start(&self, scene: &Scene, shapes: &[usize]) -> Option<Violation> {
        let crossing = |i: usize| self.crossing(&scene.shapes[i].mesh);
        let mut found = shapes.iter();
        found.find_map(|&i| self.violation(scene, i, crossing(i)))
    }

    fn crossing(&self, mesh: &Mesh) -> Option<ViolationKind> {
        let looked_for = self.self_intersection;
        let found = looked_for.then(|| cross::first_crossing(mesh)).flatten();
        found.map(|faces| ViolationKind::Crossing { faces })
    }

    fn violation(&self, scene: &Scene, i: usize, kind: Option<ViolationKind>) -> Option<Violation> {
        kind.map(|kind| Violation {
            shape: scene.shapes[i].id.clone(),
            kind,
        })
    }
}

/// The first face that turned by a right angle or more between two meshes with the
/// same faces, or lost its area, and how many there are. Faces without area before
/// do not count.
fn inverted(old: &Mesh, new: &Mesh) -> Option<ViolationKind> {
    let turned = |&face: &usize| {
        let before = old.face_cross(face);
        before.length() > 0.0 && before.dot(new.face_cross(face)) <= 0.0
    };
    let mut faces = (0..new.faces.len()).filter(turned);
    let face = faces.next()?;
    let count = 1 + faces.count();
    Some(ViolationKind::Inverted { face, count })
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_math::Vec3;

    /// A fan of faces around the origin, in a plane.
    fn fan() -> Mesh {
        let rim = (0..6).map(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 6.0).sin_cos();
            Vec3::new(cos, 0.0, -sin)
        });
        Mesh {
            positions: std::iter::once(Vec3::zero()).chain(rim).collect(),
            faces: (0..6).map(|i| [0, 1 + i, 1 + (i + 1) % 6]).collect(),
        }
    }

    /// A vertex of the rim that passes its neighbour turns a face over, one that
    /// moves along its ray beyond the middle turns two.
    #[test]
    fn passing_neighbours_turn_faces() {
        let old = fan();
        let moved = |vertex: usize, to: Vec3| {
            let mut new = old.clone();
            new.positions[vertex] = to;
            inverted(&old, &new)
        };
        assert_eq!(moved(1, old.positions[1] * 3.0), None);
        assert_eq!(moved(1, old.positions[1] * 0.01), None);
        let past = Vec3::new(0.4, 0.0, -0.9);
        let one = ViolationKind::Inverted { face: 0, count: 1 };
        assert_eq!(moved(1, past), Some(one));
        let both = ViolationKind::Inverted { face: 0, count: 2 };
        assert_eq!(moved(1, old.positions[1] * -0.1), Some(both));
        let flat = ViolationKind::Inverted { face: 0, count: 2 };
        assert_eq!(moved(1, Vec3::zero()), Some(flat));
    }

    #[test]
    fn violations_name_shape_and_face() {
        let violation = |kind| Violation {
            shape: "leaf".into(),
            kind,
        };
        let one = violation(ViolationKind::Inverted { face: 3, count: 1 });
        assert_eq!(one.to_string(), "face 3 of \"leaf\" turned over");
        let more = violation(ViolationKind::Inverted { face: 3, count: 5 });
        assert_eq!(
            more.to_string(),
            "face 3 of \"leaf\" turned over, as did 4 more"
        );
        let crossing = violation(ViolationKind::Crossing { faces: [2, 9] });
        assert_eq!(
            crossing.to_string(),
            "faces 2 and 9 of \"leaf\" cross each other"
        );
    }
}
