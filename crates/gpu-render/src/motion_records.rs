//! How triangles move, as the kernels read it: `layout.rs` says which number is what.

use capwalk_boundary::tangents_of_face;
use capwalk_diff::Forward;
use capwalk_math::Vec3;
use capwalk_render::SceneEval;

use crate::device_scene::DeviceScene;
use crate::layout::motion::MOTION;
use crate::texture_records::float;

impl DeviceScene<'_> {
    /// The motion of the triangles of the tree, in its units of length.
    pub(crate) fn motion_records(&self, eval: &Forward) -> Vec<u32> {
        let accel = self.prepared.accel();
        let mut words = Vec::with_capacity(MOTION * self.faces.len());
        let mut add = |change: Vec3| words.extend(change.to_array().map(float));
        for &face in &self.faces {
            let id = accel.shape_of_face[face as usize];
            let (shape, number) = (accel.scene.shape(id), id.0 as usize);
            let corners = accel.mesh.faces[face as usize].map(|i| (i, eval.vertex(i)));
            for (_, corner) in corners {
                add(corner.tangent(0) * self.frame.inverse_scale);
            }
            let first = accel.first_vertex[number];
            let has_normals = shape.normals.per_vertex().is_some();
            for (i, _) in corners {
                add(match has_normals {
                    true => eval.normal(number, i - first).tangent(0),
                    false => Vec3::zero(),
                });
            }
            let [(_, a), (_, b), (_, c)] = corners;
            let face = (face - accel.first_face[number]) as usize;
            let tangents = tangents_of_face(shape, face, [b - a, c - a]);
            let along = tangents.map(|[along_u, _]| along_u.normalized().tangent(0));
            let along = along.filter(|change| change.is_finite());
            add(along.unwrap_or(Vec3::zero()));
        }
        words
    }
}
