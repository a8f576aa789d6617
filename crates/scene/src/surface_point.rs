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

impl SurfacePoint<f64> {
    /// The point as one that does not move.
    pub fn constant<R: Real>(&self) -> SurfacePoint<R> {
        SurfacePoint {
            shape: self.shape,
            face: self.face,
            barycentric: self.barycentric.map(R::constant),
            uv: self.uv.map(R::constant),
        }
    }
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

    /// The texels of which the value of a texture at a point is a weighted sum, by the texture that
    /// has them, with their weights: what [`Scene::lookup`] adds up.
    pub fn texel_weights(
        &self,
        id: TextureId,
        at: &SurfacePoint<f64>,
        mut found: impl FnMut(TextureId, usize, f64),
    ) {
        // An attribute is looked up by its name.
        let (id, scale) = match &self.texture(id).pattern {
            Pattern::MeshAttribute { scale, .. } => {
                (self.numbers_of(id, self.shape(at.shape)), *scale)
            }
            _ => (id, 1.0),
        };
        let texture = self.texture(id);
        match &texture.pattern {
            Pattern::PerVertex => {
                let corners = self.shape(at.shape).mesh.faces[at.face];
                for (vertex, weight) in corners.into_iter().zip(at.barycentric) {
                    found(id, vertex as usize, weight * scale);
                }
            }
            Pattern::PerFace => found(id, at.face, scale),
            Pattern::Bitmap(bitmap) => bitmap
                .weights(at.uv)
                .into_iter()
                .filter(|(_, weight)| *weight != 0.0)
                .for_each(|(index, weight)| found(id, index, weight)),
            Pattern::Constant
            | Pattern::Checkerboard { .. }
            | Pattern::MeshAttribute { .. }
            | Pattern::Environment => {
                // One of them.
                texture.lookup(at.uv, |index| {
                    found(id, index, 1.0);
                    Rgb::<f64>::zero()
                });
            }
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
