//! Triangles with what goes around with them.

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Vec3};
use capwalk_scene::primitive::FaceUvs;
use capwalk_scene::{ShadingNormals, Shape};

use crate::mesh::direction;

/// A mesh with what goes around with its faces.
pub(super) struct Surface {
    pub mesh: Mesh,
    pub normals: ShadingNormals,
    pub uvs: Option<FaceUvs>,
}

impl Surface {
    pub fn new((mesh, normals): (Mesh, ShadingNormals), uvs: FaceUvs) -> Self {
        Self {
            mesh,
            normals,
            uvs: Some(uvs),
        }
    }

    /// Makes the back of a surface its front.
    pub fn flip(&mut self) {
        for face in &mut self.mesh.faces {
            face.swap(1, 2);
        }
        for corners in self.uvs.iter_mut().flatten() {
            corners.swap(1, 2);
        }
        match &mut self.normals {
            ShadingNormals::Face => {}
            ShadingNormals::Given(normals) | ShadingNormals::Computed(normals) => {
                for normal in normals {
                    *normal = -*normal;
                }
            }
        }
    }
}

/// Winds each face so that its normal is on the side of its vertices' normals.
pub(super) fn agree(mesh: &mut Mesh, uvs: &mut Option<FaceUvs>, normals: &[Vec3]) {
    for face in 0..mesh.faces.len() {
        let [a, b, c] = mesh.faces[face].map(|i| normals[i as usize]);
        if mesh.face_cross(face).dot(a + b + c) < 0.0 {
            mesh.faces[face].swap(1, 2);
            if let Some(uvs) = uvs {
                uvs[face].swap(1, 2);
            }
        }
    }
}

/// True for maps that change no angle between directions, up to the rounding of digits in files.
fn keeps_angles(map: &Affine) -> bool {
    let size = map.determinant().abs().cbrt();
    let unscaled = Affine::scale(Vec3::splat(1.0 / size)) * *map;
    unscaled.is_rigid(1e-5)
}

/// A copy of a shape under a map, with another name. Its front stays on the side that it
/// was on, also where the map mirrors.
pub(super) fn copy(shape: &Shape, id: String, map: Affine) -> Shape {
    let mut surface = Surface {
        mesh: shape.mesh.clone(),
        normals: ShadingNormals::Face,
        uvs: shape.uvs.clone(),
    };
    for position in &mut surface.mesh.positions {
        *position = map.point(*position);
    }
    if map.determinant() < 0.0 {
        surface.flip();
    }
    surface.normals = match &shape.normals {
        ShadingNormals::Face => ShadingNormals::Face,
        ShadingNormals::Computed(_) if keeps_angles(&map) => {
            ShadingNormals::computed(&surface.mesh)
        }
        // In Mitsuba normals are computed in the group.
        ShadingNormals::Given(normals) | ShadingNormals::Computed(normals) => {
            let normals = normals.iter().map(|&n| direction(map.normal(n)));
            ShadingNormals::Given(normals.collect())
        }
    };
    Shape {
        id,
        mesh: surface.mesh,
        world_from_object: map * shape.world_from_object,
        normals: surface.normals,
        bsdf: shape.bsdf,
        emitter: shape.emitter,
        uvs: surface.uvs,
        attributes: shape.attributes.clone(),
    }
}
