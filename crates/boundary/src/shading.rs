//! Shading discontinuities: edges between neighbouring faces, possibly coplanar, whose
//! shading normals, textures or tangents differ.

use capwalk_scene::{Aov, Integrator, Pattern, Scene, Shape, Texture};

use crate::material::{needs_tangent, tangents_of_face, textures_of};

/// Unit normals that differ by less than this are the same: rounding to single
/// precision moves them by about 1e-7.
const SAME_NORMAL: f64 = 1e-6;

/// Tangents that differ by less than this part of their length are the same.
const SAME_TANGENT: f64 = 1e-6;

/// Texture coordinates that differ by less than this are the same.
const SAME_UV: f64 = 1e-6;

/// Contrast of faces with interpolated normals, relative to the angle between them.
const SMOOTH: f64 = 0.1;
/// Smallest contrast.
const LEAST_CONTRAST: f64 = 1e-4;

/// What shading discontinuities of a shape depend on.
pub struct ShadingDiscontinuities<'s> {
    shape: &'s Shape,
    textures: Vec<&'s Texture>,
    /// The image shows the texture coordinates themselves.
    shows_uvs: bool,
    /// The material depends on its rotation about the normal.
    has_tangent: bool,
    /// The image is an AOV.
    is_aov: bool,
}

impl<'s> ShadingDiscontinuities<'s> {
    pub fn new(scene: &'s Scene, shape: &'s Shape) -> Self {
        Self {
            shape,
            textures: textures_of(scene, shape),
            shows_uvs: scene.settings.integrator == Integrator::Aov(Aov::Uv),
            has_tangent: needs_tangent(scene, shape.bsdf),
            is_aov: matches!(scene.settings.integrator, Integrator::Aov(_)),
        }
    }

    /// True if there is a shading discontinuity between two neighbouring faces, even if they
    /// are coplanar.
    pub fn differs(&self, faces: [u32; 2]) -> bool {
        self.normals_differ(faces)
            || self.textures_differ(faces)
            || self.has_tangent && self.tangents_differ(faces)
    }

    /// A guess of how large the discontinuity is between two neighbouring faces that are seen
    /// from the same side, above 0 and at most 1.
    pub fn contrast(&self, faces: [u32; 2], flipped: bool) -> f64 {
        if self.textures_differ(faces) || self.has_tangent && self.tangents_differ(faces) {
            return 1.0;
        }
        let mesh = &self.shape.mesh;
        let [first, second] = faces.map(|face| mesh.face_cross(face as usize).normalized());
        let turn = (first - second * if flipped { -1.0 } else { 1.0 }).length();
        let is_smooth = self.shape.normals.per_vertex().is_some() && !self.normals_differ(faces);
        let guess = match is_smooth && !self.is_aov {
            // With interpolated normals, only the shadow of a face on itself is discontinuous. In proportion to the
            // angle, the many edges of a fine mesh count no more than the few of a coarse one.
            true => SMOOTH * turn,
            // Paths that continue from both sides differ by the angle between the faces, and so
            // does the chance that only one of them hits something small and bright.
            false => turn.sqrt(),
        };
        guess.clamp(LEAST_CONTRAST, 1.0)
    }

    /// True if a texture of the shape can differ between two neighbouring faces
    /// at an end of their common edge.
    pub fn textures_differ(&self, faces: [u32; 2]) -> bool {
        if self.shows_uvs && self.uvs_differ(faces) {
            return true;
        }
        self.textures.iter().any(|texture| match texture.pattern {
            Pattern::PerFace => true,
            Pattern::PerVertex => self
                .common_vertices(faces)
                .any(|[a, b]| texture.texel(a as usize) != texture.texel(b as usize)),
            Pattern::Bitmap(_) | Pattern::Checkerboard { .. } => self.uvs_differ(faces),
            // An attribute stands in the list as what it is.
            Pattern::Constant | Pattern::MeshAttribute { .. } | Pattern::Environment => false,
        })
    }

    /// True if the tangents of two neighbouring faces differ in direction or length.
    fn tangents_differ(&self, faces: [u32; 2]) -> bool {
        let [first, second] = faces.map(|face| {
            let [a, b, c] = self.shape.mesh.corners(face as usize);
            tangents_of_face(self.shape, face as usize, [b - a, c - a])
        });
        match (first, second) {
            (Some(first), Some(second)) => first
                .into_iter()
                .zip(second)
                .any(|(a, b)| (a - b).length() > SAME_TANGENT * a.length()),
            (None, None) => false,
            _ => true,
        }
    }

    /// True if two neighbouring faces have different shading normals at an end of
    /// their common edge.
    fn normals_differ(&self, faces: [u32; 2]) -> bool {
        let Some(normals) = self.shape.normals.per_vertex() else {
            return false;
        };
        self.common_vertices(faces)
            .any(|[a, b]| (normals[a as usize] - normals[b as usize]).length() > SAME_NORMAL)
    }

    /// True if two neighbouring faces have different texture coordinates at an end
    /// of their common edge.
    fn uvs_differ(&self, faces: [u32; 2]) -> bool {
        self.common_corners(faces).any(|[first, second]| {
            let corner = |i: usize| [0, 1, 2].map(|k| if i == k { 1.0_f64 } else { 0.0 });
            let [a, b] = [(faces[0], first), (faces[1], second)]
                .map(|(face, i)| self.shape.uv(face as usize, corner(i)));
            (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) > SAME_UV
        })
    }

    /// The vertices of two faces that are at the same place.
    fn common_vertices(&self, faces: [u32; 2]) -> impl Iterator<Item = [u32; 2]> + use<> {
        let [first, second] = faces.map(|face| self.shape.mesh.faces[face as usize]);
        self.common_corners(faces)
            .map(move |[i, k]| [first[i], second[k]])
    }

    /// The corners of two faces that are at the same place.
    fn common_corners(&self, faces: [u32; 2]) -> impl Iterator<Item = [usize; 2]> + use<> {
        let [first, second] = faces.map(|face| self.shape.mesh.corners(face as usize));
        (0..3)
            .flat_map(|i| (0..3).map(move |k| [i, k]))
            .filter(move |&[i, k]| first[i] == second[k])
    }
}
