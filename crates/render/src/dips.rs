//! Where rays dip below the faces of smooth mirrors and glass (METHOD 6). They are reflected and refracted about
//! interpolated normals, so near grazing angles they can leave on the wrong side of the face that they meet: light ends
//! there along curves inside faces, and along edges between them that are discontinuities nowhere else.

use capwalk_boundary::may_be_specular;
use capwalk_geometry::topology;
use capwalk_math::{Real, Vec3};
use capwalk_scene::{Scene, Shape, SurfacePoint};

/// A shape is coarse, and its dips count, if the median of the sines of its vertices is at least this. On finer meshes
/// what they move is small, and the noise of telling it is large.
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
            sines: scene
                .shapes
                .iter()
                .map(|shape| sines(scene, shape))
                .collect(),
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
fn sines(scene: &Scene, shape: &Shape) -> Vec<f64> {
    let normals = shape.normals.per_vertex();
    let Some(normals) = normals.filter(|_| may_be_specular(scene, shape.bsdf)) else {
        return Vec::new();
    };
    // Vertices at one place count as one: the sine must be continuous wherever normals are.
    let mesh = &shape.mesh;
    let places = topology::weld(&mesh.positions);
    let mut largest = vec![0.0; mesh.positions.len()];
    for (face, corners) in mesh.faces.iter().enumerate() {
        let corner_normals = corners.map(|i| normals[i as usize].normalized());
        let [a, b, c] = corner_normals;
        let normal = mesh.face_cross(face).normalized();
        let outside = normal * (a + b + c).dot(normal).signum();
        let sine = |turned: Vec3| match turned.dot(outside) > 0.0 {
            true => turned.cross(outside).length().min(1.0),
            false => 1.0,
        };
        // No ray meets a face without area.
        if normal.is_finite() {
            let most = corner_normals.map(sine).into_iter().fold(0.0, f64::max);
            for &i in corners {
                let known = &mut largest[places[i as usize] as usize];
                *known = most.max(*known);
            }
        }
    }
    let sines: Vec<f64> = places.iter().map(|&i| largest[i as usize]).collect();
    let mut sorted = sines.clone();
    let middle = sorted.len() / 2;
    let is_coarse =
        middle < sorted.len() && *sorted.select_nth_unstable_by(middle, f64::total_cmp).1 >= COARSE;
    if is_coarse { sines } else { Vec::new() }
}
