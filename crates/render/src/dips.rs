//! Where rays dip below the faces of smooth mirrors and glass (METHOD 6). They are reflected and refracted about
//! interpolated normals, so near grazing angles they can leave on the wrong side of the face that they meet: light ends
//! there along curves inside faces, and along edges between them that are discontinuities nowhere else.

use std::collections::HashMap;

use capwalk_math::{Real, Vec3};
use capwalk_scene::{Scene, Shape, SurfacePoint};

/// The least sine of such an angle, in the whole of a shape, for which its dips count. On finer meshes what they move is
/// small, and the noise of telling it is large.
const COARSE: f64 = 0.15;

/// How much the interpolated normals of shapes turn away from their faces.
#[derive(Clone, Debug, Default)]
pub struct Dips {
    /// For each vertex of a shape, the largest sine of the angle between the normal of a corner and that of its face,
    /// of all faces around; none for shapes that are not coarse.
    sines: Vec<Vec<f64>>,
}

impl Dips {
    /// Those of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self {
            sines: scene.shapes.iter().map(|shape| sines(shape)).collect(),
        }
    }

    /// How far a ray is from where it could dip, which leaves a surface point with this cosine to the shading normal: a
    /// continuous function of the point and the ray. Above 0 it dips neither below the face of the point nor, on an
    /// edge, below the neighbour. `None` where that does not count.
    pub fn margin<R: Real>(&self, scene: &Scene, point: &SurfacePoint<R>, cosine: R) -> Option<R> {
        let sines = &self.sines[point.shape.0 as usize];
        if sines.is_empty() {
            return None;
        }
        let corners = scene.shape(point.shape).mesh.faces[point.face];
        let sines = Vec3::from(corners.map(|i| sines[i as usize]));
        Some(cosine - Vec3::from(point.barycentric).dot(Vec3::constant(sines)))
    }
}

/// Those of the vertices of a shape.
fn sines(shape: &Shape) -> Vec<f64> {
    let Some(normals) = shape.normals.per_vertex() else {
        return Vec::new();
    };
    // Vertices at one place count as one: the sine must be continuous wherever normals are.
    let positions = &shape.mesh.positions;
    let place = |i: u32| positions[i as usize].to_array().map(f64::to_bits);
    let mut largest: HashMap<[u64; 3], f64> = HashMap::new();
    for (face, &corners) in shape.mesh.faces.iter().enumerate() {
        let normal = shape.mesh.face_cross(face).normalized();
        let turned = corners.map(|i| normals[i as usize].normalized().cross(normal).length());
        // A face without area has NaN, which counts for nothing: no ray meets it.
        let most = turned.into_iter().fold(0.0, f64::max).min(1.0);
        for corner in corners {
            let known = largest.entry(place(corner)).or_default();
            *known = most.max(*known);
        }
    }
    if largest.values().all(|&sine| sine < COARSE) {
        return Vec::new();
    }
    let vertices = 0..positions.len() as u32;
    let sine = |i| largest.get(&place(i)).copied().unwrap_or_default();
    vertices.map(sine).collect()
}
