//! The triangle that a direction meets, in motion: fields on it (METHOD 1,
//! `domain = triangle`), and what they do to the direction.
//!
//! The paper's fields live on the surface that is seen, and their vectors are
//! velocities of the hit point `p` *relative to its material*, in the triangle's
//! plane (Eqs. 4 and 5). With the material's velocity `ṁ(p)`, linear between the
//! corners, the hit point moves with `ṁ + v`, and the direction from the viewpoint to it
//! with `u = P_q w / r`, where `w = ṁ + v - ȯ`. An area of the triangle is seen
//! under the solid angle `|n·q| / r²`, so that along the motion the solid angle
//! grows by
//!
//! ```text
//! div u = ∇·v + (area's growth) + (ṅ·(p - o) + n·w) / (n·(p - o)) - 3 q·w / r
//! ```
//!
//! All of this is linear in the velocities of the triangle's corners, of the
//! boundary points that `v` is made of, and of the viewpoint: a [`Flow`].

use capwalk_boundary::{Accel, Flow, FlowSource, Viewpoint, Visibility};
use capwalk_geometry::{HalfSpace, Hit, Mesh};
use capwalk_math::{Frame, Vec3};

/// Silhouettes lie before a triangle's plane if they are not farther behind than
/// this fraction of the triangle's distance: where surfaces pass through it they
/// lie in it.
pub const IN_PLANE: f64 = 1e-6;

/// A triangle and the direction that meets it from a viewpoint.
pub struct Receiver {
    /// The viewpoint.
    pub viewpoint: Vec3,
    /// Unit direction from there.
    pub direction: Vec3,
    /// Distance of the hit point.
    pub distance: f64,
    /// Corners.
    pub corners: [Vec3; 3],
    /// The face.
    pub face: u32,
    vertices: [u32; 3],
    /// Normal, twice as long as the triangle is large.
    cross: Vec3,
}

/// A velocity in the plane of a receiver: what a unit velocity of each source
/// along each axis adds to it.
pub type PlaneVelocity = Vec<(FlowSource, [Vec3; 3])>;

impl Receiver {
    /// The triangle that a direction meets.
    pub fn met(accel: &Accel, viewpoint: &Viewpoint<f64>, q: Vec3) -> Option<Self> {
        let position = viewpoint.position;
        let ray = match viewpoint.visibility {
            Visibility::Camera => accel.camera_ray(position, q),
            Visibility::Surface | Visibility::All => accel.surface_ray(position, q),
        };
        let hit = accel.first_hit_within(&ray)?;
        Some(Self::new(&accel.mesh, &hit, position, q))
    }

    /// What a ray from the viewpoint hits.
    pub fn new(mesh: &Mesh, hit: &Hit, viewpoint: Vec3, direction: Vec3) -> Self {
        Self {
            viewpoint,
            direction,
            distance: hit.t,
            corners: mesh.corners(hit.face as usize),
            face: hit.face,
            vertices: mesh.faces[hit.face as usize],
            cross: mesh.face_cross(hit.face as usize),
        }
    }

    /// The hit point.
    pub fn point(&self) -> Vec3 {
        self.viewpoint + self.direction * self.distance
    }

    /// The unit normal.
    pub fn normal(&self) -> Vec3 {
        self.cross.normalized()
    }

    /// The corners as seen from the viewpoint.
    pub fn offsets(&self) -> [Vec3; 3] {
        self.corners.map(|corner| corner - self.viewpoint)
    }

    /// The triangle's plane, its front towards the viewpoint, moved back by a distance:
    /// what lies behind hides nothing of the triangle (Section 6.1).
    pub fn plane(&self, back: f64) -> HalfSpace {
        let towards = -self.cross.dot(self.direction).signum();
        let normal = self.cross.normalized() * towards;
        HalfSpace {
            point: self.corners[0] - normal * back,
            normal,
        }
    }

    /// Distance from the viewpoint to the plane along a direction.
    pub fn distance_along(&self, direction: Vec3) -> f64 {
        self.cross.dot(self.corners[0] - self.viewpoint) / self.cross.dot(direction)
    }

    /// Weights of the corners at a point of the plane, by areas.
    pub fn weights(&self, point: Vec3) -> [f64; 3] {
        let [a, b, c] = self.corners;
        let scale = 1.0 / self.cross.length_squared();
        let area = |a: Vec3, b: Vec3| (a - point).cross(b - point).dot(self.cross) * scale;
        [area(b, c), area(c, a), area(a, b)]
    }

    /// A velocity's part in the plane, what is missing taken along a direction.
    fn in_plane(&self, velocity: Vec3, along: Vec3) -> Vec3 {
        velocity - along * (self.cross.dot(velocity) / self.cross.dot(along))
    }

    /// The velocity `v^∂`, relative to the material, of the projection of a boundary
    /// point through the viewpoint on the triangle's plane, Eqs. (6) and (28): of the point at
    /// `t` between two others, which turns with a velocity relative to the viewpoint as
    /// `angular` says. `seen` is its unit direction.
    pub fn boundary(
        &self,
        [a, b]: [u32; 2],
        t: f64,
        angular: impl Fn(Vec3) -> Vec3,
        seen: Vec3,
    ) -> PlaneVelocity {
        self.projected(&[(a, 1.0 - t), (b, t)], angular, seen)
    }

    /// The same of any point seen in a direction: a sum of others with weights, and
    /// the map from its velocity relative to the viewpoint to that of its direction.
    pub fn projected(
        &self,
        parts: &[(u32, f64)],
        angular: impl Fn(Vec3) -> Vec3,
        seen: Vec3,
    ) -> PlaneVelocity {
        let r = self.distance_along(seen);
        // The direction turns with the point, the ray is cut by the plane, and the
        // material under it moves on.
        let turned = |velocity: Vec3| self.in_plane(angular(velocity) * r, seen);
        let plane = |velocity: Vec3| self.in_plane(velocity, seen);
        let mut terms = vec![(FlowSource::Viewpoint, columns(|v| plane(v) - turned(v)))];
        for &(point, weight) in parts {
            terms.push((FlowSource::Point(point), columns(|v| turned(v) * weight)));
        }
        let weights = self.weights(self.viewpoint + seen * r);
        for (i, weight) in self.vertices.into_iter().zip(weights) {
            terms.push((FlowSource::Point(i), columns(|v| plane(v) * -weight)));
        }
        terms
    }

    /// A tangent of the triangle as a tangent of the sphere of directions, `Project`
    /// of Algorithm 7, Eq. (37).
    fn project(&self, d: Vec3) -> Vec3 {
        (d / self.distance).reject_from(self.direction)
    }

    /// The covector on a velocity in `∇·v = Σ_{d ∈ {s,t}} d·∂_d̂ u` (Algorithm 7,
    /// Eq. 38), for the gradient of its weight on the sphere of directions.
    pub fn divergence(&self, gradient: Vec3) -> Vec3 {
        let Frame { s, t, .. } = Frame::from_normal(self.cross.normalized());
        [s, t].into_iter().fold(Vec3::zero(), |sum, d| {
            sum + d * gradient.dot(self.project(d))
        })
    }

    /// How the direction moves with the material alone.
    pub fn material(&self) -> Flow {
        let mut flow = Flow::default();
        let w = self.divergence_covector();
        let offset = self.direction * self.distance;
        let weights = self.weights(self.viewpoint + offset);
        let scale = 1.0 / self.cross.dot(offset);
        for (i, weight) in weights.into_iter().enumerate() {
            let opposite = self.corners[(i + 1) % 3] - self.corners[(i + 2) % 3];
            // The area's growth and the turning of the normal, together.
            let tilt = opposite.cross(offset) * scale;
            flow.add(
                FlowSource::Point(self.vertices[i]),
                columns(|v| v * (weight / self.distance)),
                w * weight + tilt,
            );
        }
        flow.add(FlowSource::Viewpoint, columns(|v| -v / self.distance), -w);
        flow
    }

    /// Adds to a flow a velocity relative to the material that has a weight in the
    /// field, and a covector on it in the field's divergence `∇·v`.
    pub fn add(&self, flow: &mut Flow, velocity: &PlaneVelocity, weight: f64, divergence: Vec3) {
        let covector = divergence + self.divergence_covector() * weight;
        for &(source, velocity) in velocity {
            flow.add(
                source,
                velocity.map(|v| v * (weight / self.distance)),
                velocity.map(|v| v.dot(covector)).into(),
            );
        }
    }

    /// The covector on `w`, the hit point's velocity relative to the viewpoint, in the
    /// divergence of the direction's field.
    fn divergence_covector(&self) -> Vec3 {
        let r = self.distance;
        self.cross / (self.cross.dot(self.direction) * r) - self.direction * (3.0 / r)
    }
}

/// A linear map by its columns.
fn columns(map: impl Fn(Vec3) -> Vec3) -> [Vec3; 3] {
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| map(axis.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn v(x: f64, y: f64, z: f64) -> Vec3 {
        Vec3::new(x, y, z)
    }

    struct Example {
        mesh: Mesh,
        velocities: [Vec3; 3],
        viewpoint: Vec3,
        viewpoint_velocity: Vec3,
    }

    impl Example {
        fn new() -> Self {
            Self {
                mesh: Mesh {
                    positions: vec![v(-1.0, -0.8, 2.0), v(1.2, -0.7, 2.6), v(0.1, 1.3, 1.7)],
                    faces: vec![[0, 1, 2]],
                },
                velocities: [v(0.3, -0.2, 0.5), v(-0.4, 0.1, 0.7), v(0.2, 0.6, -0.9)],
                viewpoint: v(0.1, 0.05, -0.3),
                viewpoint_velocity: v(-0.3, 0.2, 0.4),
            }
        }

        fn receiver(&self, q: Vec3) -> Receiver {
            let [a, b, c] = self.mesh.corners(0);
            let cross = (b - a).cross(c - a);
            let hit = Hit {
                face: 0,
                t: cross.dot(a - self.viewpoint) / cross.dot(q),
                barycentric: [0.0; 2],
            };
            Receiver::new(&self.mesh, &hit, self.viewpoint, q)
        }

        fn evaluate(&self, flow: &Flow) -> (Vec3, f64) {
            flow.evaluate(|source| match source {
                FlowSource::Point(i) => self.velocities[i as usize],
                FlowSource::Viewpoint => self.viewpoint_velocity,
            })
        }
    }

    const DIRECTIONS: [Vec3; 3] = [
        Vec3::new(0.1, 0.0, 1.0),
        Vec3::new(-0.2, -0.15, 1.0),
        Vec3::new(0.25, 0.1, 1.0),
    ];

    /// What a flow calls the divergence is that of the field of directions, with
    /// only material moving and with a field on the triangle besides.
    #[test]
    fn divergence_is_that_of_the_directions() {
        let example = Example::new();
        // An affine field on the plane: v(p) = Π (k + l (m·p)), as a map from the
        // second corner's velocity, which only serves as a vector here.
        let m = v(0.7, -0.4, 0.2);
        for (q, with_field) in DIRECTIONS.iter().flat_map(|&q| [(q, false), (q, true)]) {
            let q = q.normalized();
            let flow = |q: Vec3| {
                let receiver = example.receiver(q);
                let mut flow = receiver.material();
                if with_field {
                    let normal = receiver.cross.normalized();
                    let point = receiver.viewpoint + q * receiver.distance;
                    let velocity = columns(|x| x.reject_from(normal));
                    receiver.add(
                        &mut flow,
                        &vec![(FlowSource::Point(1), velocity)],
                        m.dot(point),
                        m.reject_from(normal),
                    );
                }
                flow
            };
            let field = |q: Vec3| example.evaluate(&flow(q)).0.reject_from(q);
            let h = 1e-5;
            let frame = Frame::from_normal(q);
            let numeric: f64 = [frame.s, frame.t]
                .into_iter()
                .map(|e| {
                    let at = |h: f64| field((q + e * h).normalized());
                    (at(h) - at(-h)).dot(e) / (2.0 * h)
                })
                .sum();
            let (_, divergence) = example.evaluate(&flow(q));
            let error = (divergence - numeric).abs();
            assert!(error < 1e-7, "{q:?}: {divergence} against {numeric}");
            assert!(numeric.abs() > 1e-3, "nothing to compare");
        }
    }

    /// The material's flow is where a point of the moving triangle is seen from the
    /// moving viewpoint.
    #[test]
    fn material_is_seen_where_it_moves() {
        let example = Example::new();
        for q in DIRECTIONS {
            let q = q.normalized();
            let receiver = example.receiver(q);
            let weights = receiver.weights(receiver.viewpoint + q * receiver.distance);
            let seen = |h: f64| {
                let corner = |i: usize| receiver.corners[i] + example.velocities[i] * h;
                let viewpoint = receiver.viewpoint + example.viewpoint_velocity * h;
                let at = |i: usize| (corner(i) - viewpoint) * weights[i];
                (at(0) + at(1) + at(2)).normalized()
            };
            let h = 1e-5;
            let numeric = (seen(h) - seen(-h)) / (2.0 * h);
            let flow = example.evaluate(&receiver.material()).0.reject_from(q);
            assert!((flow - numeric).length() < 1e-8, "{flow:?} {numeric:?}");
        }
    }

    /// The projection of a moving point on the moving plane, in coordinates of the
    /// moving triangle: its barycentric weights' velocities times the corners.
    #[test]
    fn shadows_move_relative_to_the_material() {
        let mut example = Example::new();
        let ends = [v(-0.1, 0.1, 0.8), v(0.2, 0.3, 1.1)];
        let end_velocities = [v(0.5, -0.3, 0.4), v(-0.2, 0.8, 0.1)];
        example.mesh.positions.extend(ends);
        let t = 0.3;
        let point = ends[0] + (ends[1] - ends[0]) * t;
        let velocity = end_velocities[0] + (end_velocities[1] - end_velocities[0]) * t;
        let offset = point - example.viewpoint;
        let seen = offset.normalized();
        let receiver = example.receiver(seen);
        let angular = |v: Vec3| v.reject_from(seen) / offset.length();
        let found = receiver.boundary([3, 4], t, angular, seen);
        let found = found.iter().fold(Vec3::zero(), |sum, (source, [x, y, z])| {
            let v = match *source {
                FlowSource::Point(i) if i >= 3 => end_velocities[i as usize - 3],
                FlowSource::Point(i) => example.velocities[i as usize],
                FlowSource::Viewpoint => example.viewpoint_velocity,
            };
            sum + *x * v.x + *y * v.y + *z * v.z
        });
        let weights = |h: f64| {
            let mut moved = Example::new();
            for i in 0..3 {
                moved.mesh.positions[i] += example.velocities[i] * h;
            }
            moved.viewpoint += example.viewpoint_velocity * h;
            let seen = (point + velocity * h - moved.viewpoint).normalized();
            let receiver = moved.receiver(seen);
            receiver.weights(receiver.viewpoint + seen * receiver.distance)
        };
        let h = 1e-5;
        let (ahead, behind) = (weights(h), weights(-h));
        let expected = (0..3).fold(Vec3::zero(), |sum, i| {
            sum + receiver.corners[i] * ((ahead[i] - behind[i]) / (2.0 * h))
        });
        assert!((found - expected).length() < 1e-8, "{found:?} {expected:?}");
        assert!(expected.length() > 0.1, "nothing to compare");
    }
}
