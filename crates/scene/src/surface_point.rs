//! The textures of a scene at a point of a surface.

use capwalk_math::{Real, Rgb};

use crate::ids::{ShapeId, TextureId};
use crate::scene::Scene;
use crate::shape::Shape;
use crate::texture::Pattern;

/// A point of a surface, as textures see it. It may move over the surface.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint<R> {
    /// The shape.
    pub shape: ShapeId,
    /// The triangle, counted in the shape.
    pub face: usize,
    /// Weights of the triangle's corners; they add up to one.
    pub barycentric: [R; 3],
    /// Texture coordinates ([`crate::Shape::uv`]).
    pub uv: [R; 2],
}

impl Scene {
    /// The texture whose numbers another one shows on a shape: itself, or the
    /// shape's attribute that it looks up.
    ///
    /// # Panics
    /// If the shape has no such attribute ([`Scene::check`] finds that).
    #[inline]
    pub fn numbers_of(&self, id: TextureId, shape: &Shape) -> TextureId {
        match &self.texture(id).pattern {
            Pattern::MeshAttribute { name, .. } => {
                let attribute = shape.attribute(name);
                attribute.expect("scenes are checked for attributes")
            }
            Pattern::Constant
            | Pattern::Bitmap(_)
            | Pattern::Checkerboard { .. }
            | Pattern::PerVertex
            | Pattern::PerFace
            | Pattern::Environment => id,
        }
    }

    /// The value of a texture at a point of a surface. `texel` gives texels,
    /// with or without derivatives: of the texture itself, or of the shape's
    /// attribute that it looks up.
    ///
    /// # Panics
    /// If the shape has no such attribute ([`Scene::check`] finds that).
    pub fn lookup<R: Real>(
        &self,
        id: TextureId,
        at: &SurfacePoint<R>,
        mut texel: impl FnMut(TextureId, usize) -> Rgb<R>,
    ) -> Rgb<R> {
        let texture = self.texture(id);
        match &texture.pattern {
            Pattern::MeshAttribute { scale, .. } => {
                let attribute = self.numbers_of(id, self.shape(at.shape));
                self.lookup(attribute, at, texel) * R::constant(*scale)
            }
            Pattern::PerVertex => {
                let corners = self.shape(at.shape).mesh.faces[at.face];
                let [a, b, c] = corners.map(|vertex| texel(id, vertex as usize));
                a * at.barycentric[0] + b * at.barycentric[1] + c * at.barycentric[2]
            }
            Pattern::PerFace => texel(id, at.face),
            Pattern::Constant
            | Pattern::Bitmap(_)
            | Pattern::Checkerboard { .. }
            | Pattern::Environment => texture.lookup(at.uv, |index| texel(id, index)),
        }
    }
}
