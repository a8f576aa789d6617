//! Sampling of directions towards emitters, and of points on them.

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;
use capwalk_scene::emitter::EnvironmentTable;
use capwalk_scene::{Emitter, Scene};

/// How directions towards an emitter are sampled.
#[derive(Clone, Debug)]
pub enum EmitterSampler {
    /// By points on an emitter.
    Area(TriangleSampler),
    /// By the cosine at the surface, or uniformly: light from everywhere.
    Constant,
    /// By the brightness of an environment map, unless it is black.
    Environment(Option<EnvironmentTable>),
    /// Not at all: there is only one.
    Delta,
}

impl EmitterSampler {
    /// The sampler of a scene's emitter.
    pub fn new(scene: &Scene, emitter: &Emitter) -> Self {
        match emitter {
            Emitter::Area { shape, .. } => {
                Self::Area(TriangleSampler::new(&scene.shape(*shape).mesh))
            }
            Emitter::Constant { .. } => Self::Constant,
            Emitter::EnvironmentMap { map, data, .. } => {
                Self::Environment(EnvironmentTable::new(map, scene.texture(*data)))
            }
            Emitter::Point { .. } | Emitter::Spot { .. } | Emitter::Directional { .. } => {
                Self::Delta
            }
        }
    }
}

/// An emitter's triangles, sampled by area. Indices are the shape's own.
#[derive(Clone, Debug)]
pub struct TriangleSampler {
    triangles: Vec<[Vec3; 3]>,
    /// Area of each triangle and all before it.
    cumulative: Vec<f64>,
}

/// A point sampled on an emitter.
#[derive(Clone, Copy, Debug)]
pub struct TrianglePoint {
    /// World-space position.
    pub position: Vec3,
    /// Unit normal of the emitting side.
    pub normal: Vec3,
    /// The triangle.
    pub face: u32,
    /// Weights of its second and third corner.
    pub barycentric: [f64; 2],
}

impl TriangleSampler {
    /// A sampler of all triangles of a mesh.
    pub fn new(mesh: &Mesh) -> Self {
        let mut area = 0.0;
        let cumulative = (0..mesh.faces.len())
            .map(|face| {
                area += 0.5 * mesh.face_cross(face).length();
                area
            })
            .collect();
        let triangles = (0..mesh.faces.len())
            .map(|face| mesh.corners(face))
            .collect();
        Self {
            triangles,
            cumulative,
        }
    }

    /// Total area.
    pub fn area(&self) -> f64 {
        *self.cumulative.last().expect("a checked mesh has faces")
    }

    /// A uniform point, with density `1 / area`.
    pub fn sample(&self, u: [f64; 2]) -> TrianglePoint {
        let target = u[0] * self.area();
        let i = self.cumulative.partition_point(|&c| c <= target);
        let i = i.min(self.triangles.len() - 1);
        let before = if i == 0 { 0.0 } else { self.cumulative[i - 1] };
        // The random number, rescaled within the triangle, is uniform again.
        let share = self.cumulative[i] - before;
        let u0 = ((target - before) / share).clamp(0.0, 1.0);
        let [a, b, c] = self.triangles[i];
        // Square root folds the square onto the triangle uniformly.
        let root = u0.sqrt();
        let (wb, wc) = (root * (1.0 - u[1]), root * u[1]);
        TrianglePoint {
            position: a + (b - a) * wb + (c - a) * wc,
            normal: (b - a).cross(c - a).normalized(),
            face: i as u32,
            barycentric: [wb, wc],
        }
    }

    /// Density per solid angle of [`TriangleSampler::sample`], for a direction from a
    /// point at `distance` that sees the emitter at the cosine `cos_l`.
    #[inline]
    pub fn solid_angle_pdf(&self, distance: f64, cos_l: f64) -> f64 {
        distance * distance / (cos_l.abs() * self.area())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Moments of a uniform distribution over two triangles of unequal size.
    #[test]
    fn points_are_uniform() {
        let mesh = Mesh {
            positions: vec![
                Vec3::new(0.0, 0.0, 0.0),
                Vec3::new(3.0, 0.0, 0.0),
                Vec3::new(0.0, 1.0, 0.0),
                Vec3::new(-1.0, 0.0, 0.0),
            ],
            faces: vec![[0, 1, 2], [0, 2, 3]],
        };
        let triangles = TriangleSampler::new(&mesh);
        assert!((triangles.area() - 2.0).abs() < 1e-15);
        let (mut mean, n) = (Vec3::zero(), 400);
        for i in 0..n {
            for k in 0..n {
                let u = [(i as f64 + 0.5) / n as f64, (k as f64 + 0.5) / n as f64];
                let point = triangles.sample(u);
                assert!(point.normal.z > 0.999);
                mean += point.position / f64::from(n * n);
            }
        }
        let expected = (Vec3::new(1.0, 1.0 / 3.0, 0.0) * 1.5
            + Vec3::new(-1.0 / 3.0, 1.0 / 3.0, 0.0) * 0.5)
            / 2.0;
        assert!((mean - expected).length() < 1e-3);
    }
}
