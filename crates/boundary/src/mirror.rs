//! Flat mirrors: images of points and directions in faces that may move, and the
//! velocities of these images (METHOD 6).

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;

/// The most specular events between a viewpoint and an edge.
pub const MAX_EVENTS: u32 = 6;

/// The plane of a face, which may move, as a mirror.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mirror {
    corners: [Vec3; 3],
    /// Unit vector.
    pub(crate) normal: Vec3,
}

impl Mirror {
    pub(crate) fn new(mesh: &Mesh, face: u32) -> Self {
        Self {
            corners: mesh.corners(face as usize),
            normal: mesh.face_cross(face as usize).normalized(),
        }
    }

    /// The distance of a point from the plane, along the normal.
    pub(crate) fn height(&self, point: Vec3) -> f64 {
        self.normal.dot(point - self.corners[0])
    }

    /// The image of a point.
    pub(crate) fn point(&self, point: Vec3) -> Vec3 {
        point - self.normal * (2.0 * self.height(point))
    }

    /// The image of a direction.
    pub(crate) fn direction(&self, direction: Vec3) -> Vec3 {
        direction - self.normal * (2.0 * self.normal.dot(direction))
    }

    /// How the image of a point moves when the corners move by one along the
    /// normal. With `d` the point's height, `y` its foot and `h` the plane's
    /// motion along its normal `n`, linear between the corners, the image moves
    /// by `2 h(y) n + 2 d ∇h`: the normal turns by `-∇h`.
    fn derivatives(&self, point: Vec3) -> [Vec3; 3] {
        let [a, b, c] = self.corners;
        let (edge1, edge2) = (b - a, c - a);
        let cross = edge1.cross(edge2);
        let scale = 1.0 / cross.length_squared();
        // Gradients of the barycentric weights.
        let (gradient_b, gradient_c) = (edge2.cross(cross) * scale, cross.cross(edge1) * scale);
        let gradients = [-gradient_b - gradient_c, gradient_b, gradient_c];
        let offset = point - a;
        let (weight_b, weight_c) = (gradient_b.dot(offset), gradient_c.dot(offset));
        let weights = [1.0 - weight_b - weight_c, weight_b, weight_c];
        let height = self.height(point);
        [0, 1, 2].map(|i| self.normal * (2.0 * weights[i]) + gradients[i] * (2.0 * height))
    }
}

/// The mirrors in which a point is seen, the one nearest to the viewpoint first.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mirrors {
    faces: [u32; MAX_EVENTS as usize],
    count: u8,
}

impl Mirrors {
    /// Faces of the joined mesh.
    pub fn faces(&self) -> &[u32] {
        &self.faces[..usize::from(self.count)]
    }

    /// True if it is seen without any.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    pub(crate) fn push(&mut self, face: u32) {
        self.faces[usize::from(self.count)] = face;
        self.count += 1;
    }

    /// The velocity of the image of a point, for velocities of the mirrors' corners.
    pub fn velocity(
        &self,
        mesh: &Mesh,
        mut point: Vec3,
        mut velocity: Vec3,
        corner: impl Fn(u32) -> Vec3,
    ) -> Vec3 {
        for &face in self.faces().iter().rev() {
            let mirror = Mirror::new(mesh, face);
            velocity = mirror.direction(velocity);
            for (derivative, i) in mirror
                .derivatives(point)
                .into_iter()
                .zip(mesh.faces[face as usize])
            {
                velocity += derivative * mirror.normal.dot(corner(i));
            }
            point = mirror.point(point);
        }
        velocity
    }

    /// The covector on the velocity of a point for one on that of its image;
    /// those on the velocities of the mirrors' corners go to `corner`.
    pub fn pull(
        &self,
        mesh: &Mesh,
        mut point: Vec3,
        mut covector: Vec3,
        mut corner: impl FnMut(u32, Vec3),
    ) -> Vec3 {
        let mut points = [Vec3::zero(); MAX_EVENTS as usize];
        for (i, &face) in self.faces().iter().enumerate().rev() {
            points[i] = point;
            point = Mirror::new(mesh, face).point(point);
        }
        for (&face, point) in self.faces().iter().zip(points) {
            let mirror = Mirror::new(mesh, face);
            for (derivative, i) in mirror
                .derivatives(point)
                .into_iter()
                .zip(mesh.faces[face as usize])
            {
                corner(i, mirror.normal * derivative.dot(covector));
            }
            covector = mirror.direction(covector);
        }
        covector
    }
}
