//! A shape: a mesh in world coordinates and what it is made of.

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Real, Vec3};
use serde::{Deserialize, Serialize};

use crate::ids::{BsdfId, EmitterId, TextureId};

/// A shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// Its name, unique in the scene.
    pub id: String,
    /// Its triangles, in world coordinates.
    pub mesh: Mesh,
    /// Where the coordinates that it was described in lie in the world; can be
    /// inverted. Only a parameter: whatever the shape is moved by, it stays.
    pub world_from_object: Affine,
    /// Its shading normals.
    pub normals: ShadingNormals,
    /// Its material.
    pub bsdf: BsdfId,
    /// What it emits, if anything.
    pub emitter: Option<EmitterId>,
    /// Texture coordinates of the corners of each triangle. Two triangles may
    /// give a vertex that they share different ones.
    pub uvs: Option<Vec<[[f64; 2]; 3]>>,
    /// What the shape says of itself, for textures that ask for it.
    pub attributes: Vec<Attribute>,
}

/// Numbers that come with a mesh.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Attribute {
    /// Its name: `vertex_color`, `face_heat` ...
    pub name: String,
    /// Its numbers, per vertex or per face.
    pub texture: TextureId,
}

/// Where shading normals come from. Unit length, on the side of the face
/// normals, interpolated over the triangle and normalised.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum ShadingNormals {
    /// Each triangle is flat.
    Face,
    /// One per vertex, given with the mesh; they turn with the shape, but do
    /// not change when single vertices move.
    Given(Vec<Vec3>),
    /// One per vertex, from the faces around it ([`vertex_normals`]); they
    /// follow every motion of the vertices.
    Computed(Vec<Vec3>),
}

impl ShadingNormals {
    /// Smooth normals computed from the mesh.
    pub fn computed(mesh: &Mesh) -> Self {
        Self::Computed(vertex_normals(&mesh.positions, &mesh.faces))
    }

    /// One normal per vertex, or `None` for flat triangles.
    pub fn per_vertex(&self) -> Option<&[Vec3]> {
        match self {
            Self::Face => None,
            Self::Given(normals) | Self::Computed(normals) => Some(normals),
        }
    }
}

/// 1 if a normal of a face is on the outside of its shape, else -1: the normals of its corners say which side that is,
/// even against the winding; all three together, so that it is the same all over the face.
#[inline]
pub fn outside(normals: [Vec3; 3], face_normal: Vec3) -> f64 {
    let [a, b, c] = normals;
    (a + b + c).dot(face_normal).signum()
}

impl Shape {
    /// A shape without light, texture coordinates and attributes.
    pub fn new(id: impl Into<String>, mesh: Mesh, normals: ShadingNormals, bsdf: BsdfId) -> Self {
        Self {
            id: id.into(),
            mesh,
            world_from_object: Affine::IDENTITY,
            normals,
            bsdf,
            emitter: None,
            uvs: None,
            attributes: Vec::new(),
        }
    }

    /// Texture coordinates at the point of a face with these weights of its
    /// corners. Without any they are the weights of the second and the third
    /// corner, as in Mitsuba.
    pub fn uv<R: Real>(&self, face: usize, barycentric: [R; 3]) -> [R; 2] {
        let Some(uvs) = &self.uvs else {
            return [barycentric[1], barycentric[2]];
        };
        [0, 1].map(|axis| {
            let [a, b, c] = uvs[face].map(|corner| R::constant(corner[axis]));
            a * barycentric[0] + b * barycentric[1] + c * barycentric[2]
        })
    }

    /// The numbers of an attribute, if the shape has it.
    pub fn attribute(&self, name: &str) -> Option<TextureId> {
        let found = self.attributes.iter().find(|a| a.name == name);
        found.map(|attribute| attribute.texture)
    }

    /// The point that rotation and scaling leave in place: the centre of the
    /// bounding box.
    pub fn centre(&self) -> Vec3 {
        let (low, high) = self.mesh.bounds();
        (low + high) * 0.5
    }
}

/// Unit vertex normals: the face normals around each vertex weighted by the
/// angle of the corner (Max 1999 compares the weights; Mitsuba takes these).
/// `+z` where all faces at a vertex are degenerate or cancel.
pub fn vertex_normals<R: Real>(positions: &[Vec3<R>], faces: &[[u32; 3]]) -> Vec<Vec3<R>> {
    let sums = normal_sums(positions, faces);
    let up = Vec3::constant(Vec3::new(0.0, 0.0, 1.0));
    sums.into_iter()
        .map(|sum| match sum.length_squared().value() {
            0.0 => up,
            _ => sum.normalized(),
        })
        .collect()
}

/// The vertex normals before they are normalised: sums over the faces around each
/// vertex, zero where there are none or they cancel.
pub fn normal_sums<R: Real>(positions: &[Vec3<R>], faces: &[[u32; 3]]) -> Vec<Vec3<R>> {
    let mut sums = vec![Vec3::<R>::zero(); positions.len()];
    for corners in faces {
        if let Some(parts) = corner_normals(corners.map(|i| positions[i as usize])) {
            for (&i, part) in corners.iter().zip(parts) {
                sums[i as usize] += part;
            }
        }
    }
    sums
}

/// What a face adds to the normals at its corners, before they are normalised:
/// its normal times the angle of the corner. `None` if it is degenerate.
pub fn corner_normals<R: Real>(p: [Vec3<R>; 3]) -> Option<[Vec3<R>; 3]> {
    let cross = (p[1] - p[0]).cross(p[2] - p[0]);
    if cross.length_squared().value() == 0.0 {
        return None;
    }
    let normal = cross.normalized();
    Some([0, 1, 2].map(|i| {
        let d1 = (p[(i + 1) % 3] - p[i]).normalized();
        let d2 = (p[(i + 2) % 3] - p[i]).normalized();
        normal * angle(d1, d2)
    }))
}

/// The angle between unit vectors, with its derivative.
fn angle<R: Real>(a: Vec3<R>, b: Vec3<R>) -> R {
    let value = a
        .value()
        .cross(b.value())
        .length()
        .atan2(a.value().dot(b.value()));
    // angle = atan2(sin, cos), d angle = cos d sin - sin d cos. The products
    // with (x - its value) vanish but carry the derivative.
    let (sin, cos) = (a.cross(b).length(), a.dot(b));
    let detached = |x: R| R::constant(x.value());
    R::constant(value) + detached(cos) * (sin - detached(sin))
        - detached(sin) * (cos - detached(cos))
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_math::Dual;

    /// Velocities of computed normals against central differences.
    #[test]
    fn vertex_normals_differentiate() {
        let faces = [[0, 1, 2], [0, 2, 3], [0, 3, 1]];
        let at = |h: f64| {
            vec![
                Vec3::new(0.1 + h, 0.2 - 0.5 * h, 1.0 + 2.0 * h),
                Vec3::new(1.0, 0.0, 0.1),
                Vec3::new(-0.4, 0.9, 0.0),
                Vec3::new(-0.6, -0.8, 0.2),
            ]
        };
        let mut moving: Vec<Vec3<Dual<1>>> = at(0.0).into_iter().map(Vec3::constant).collect();
        moving[0] = at(0.0)[0].with_tangent(Vec3::new(1.0, -0.5, 2.0));
        let h = 1e-6;
        let (above, below) = (
            vertex_normals(&at(h), &faces),
            vertex_normals(&at(-h), &faces),
        );
        for (i, normal) in vertex_normals(&moving, &faces).into_iter().enumerate() {
            let difference = (above[i] - below[i]) / (2.0 * h);
            assert!(
                (normal.tangent(0) - difference).length() < 1e-8,
                "vertex {i}"
            );
            assert!((normal.value().length() - 1.0).abs() < 1e-14);
        }
    }
}
