//! Lines inside faces along which textures are discontinuous: between the squares of a
//! checkerboard, and between texels that are not interpolated.
//!
//! On a face these lines are straight, and they are fixed in its material. So they are
//! boundaries like the segments in which faces cross, though no mesh has an edge there
//! (METHOD 7 leaves them out).

use capwalk_geometry::Halt;
use capwalk_math::Vec3;
use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
use capwalk_scene::{Pattern, Shape, Texture};

use crate::accel::Accel;
use crate::material::textures_of;

use crate::crossing::{Crossing, CrossingEnd, Pull};

/// The most lines along which the textures of a shape may be discontinuous: a gigabyte.
pub const MOST_LINES: f64 = 4e6;

/// Equidistant lines in texture space, in both directions: where each of
/// `to_uv(u, v) · count` is a whole number.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Grid {
    to_uv: UvTransform,
    /// Lines per unit in each direction.
    counts: [u32; 2],
    /// True if there are lines inside the unit square alone.
    is_clamped: bool,
}

/// A piece of a line on a face: the weights of the face's corners at its ends.
type Piece = [[f64; 3]; 2];

impl Grid {
    /// The grid of lines where a texture is discontinuous; `None` if there are none inside
    /// faces.
    fn of(texture: &Texture) -> Option<Self> {
        match &texture.pattern {
            Pattern::Checkerboard { to_uv } => Some(Self {
                to_uv: *to_uv,
                counts: [2; 2],
                is_clamped: false,
            }),
            Pattern::Bitmap(bitmap) if bitmap.filter == TexelFilter::Nearest => {
                let &Bitmap { width, height, .. } = bitmap;
                Some(Self {
                    to_uv: bitmap.to_uv,
                    counts: [width, height],
                    is_clamped: bitmap.wrap == Wrap::Clamp,
                })
            }
            Pattern::Bitmap(_)
            | Pattern::Constant
            | Pattern::MeshAttribute { .. }
            | Pattern::PerVertex
            | Pattern::PerFace
            | Pattern::Environment => None,
        }
    }

    /// The lines of one direction across a face, as whole numbers, and the place of
    /// each corner among them.
    fn across(&self, shape: &Shape, face: usize, axis: usize) -> ([f64; 2], [f64; 3]) {
        let count = f64::from(self.counts[axis]);
        let corner = |i: usize| [0, 1, 2].map(|k| f64::from(u8::from(i == k)));
        let place = |i: usize| self.to_uv.apply(shape.uv(face, corner(i)))[axis] * count;
        let places = [place(0), place(1), place(2)];
        let low = places.into_iter().fold(f64::INFINITY, f64::min).ceil();
        let high = places.into_iter().fold(f64::NEG_INFINITY, f64::max).floor();
        let range = match self.is_clamped {
            true => [low.max(1.0), high.min(count - 1.0)],
            false => [low, high],
        };
        (range, places)
    }

    /// How many lines there are across a face, at most.
    fn count(&self, shape: &Shape, face: usize) -> f64 {
        let along = |axis: usize| {
            let ([low, high], _) = self.across(shape, face, axis);
            (high - low + 1.0).max(0.0)
        };
        along(0) + along(1)
    }

    /// The lines on a face.
    fn pieces(&self, shape: &Shape, face: usize) -> Vec<Piece> {
        let mut pieces = Vec::new();
        for axis in 0..2 {
            let ([low, high], places) = self.across(shape, face, axis);
            let mut line = low;
            while line <= high {
                pieces.extend(piece(places, line));
                line += 1.0;
            }
        }
        pieces
    }
}

/// Where on a face a linear function with these values at the corners has a given value.
/// Along an edge it counts to the face on the side of lower values, so that it is
/// found once.
fn piece(places: [f64; 3], value: f64) -> Option<Piece> {
    let is_below = places.map(|place| place < value);
    let mut ends = (0..3).filter_map(|i| {
        let k = (i + 1) % 3;
        let [from, to] = [places[i], places[k]];
        if is_below[i] == is_below[k] {
            return None;
        }
        let t = (value - from) / (to - from);
        let mut weights = [0.0; 3];
        (weights[i], weights[k]) = (1.0 - t, t);
        Some(weights)
    });
    let piece = [ends.next()?, ends.next()?];
    // A line through a corner alone has no length.
    (piece[0] != piece[1]).then_some(piece)
}

/// The grids of a shape, each once, and whether its emission is discontinuous there.
fn grids(accel: &Accel, shape: &Shape) -> Vec<(Grid, bool)> {
    let scene = &accel.scene;
    let emitted = shape.emitter.map(|id| {
        let numbers = scene.numbers_of(scene.emitter(id).radiance(), shape);
        Grid::of(scene.texture(numbers))
    });
    let emitted = emitted.flatten();
    let mut grids: Vec<(Grid, bool)> = Vec::new();
    for grid in textures_of(scene, shape).into_iter().filter_map(Grid::of) {
        if grids.iter().all(|(known, _)| *known != grid) {
            grids.push((grid, emitted == Some(grid)));
        }
    }
    grids
}

/// True if a texture is discontinuous along lines inside faces.
pub fn is_discontinuous(texture: &Texture) -> bool {
    Grid::of(texture).is_some()
}

/// How many lines the textures of a shape have, at most.
pub fn count(accel: &Accel, shape: &Shape) -> f64 {
    let grids = grids(accel, shape);
    let faces = 0..shape.mesh.faces.len();
    let on_face = |face| {
        grids
            .iter()
            .map(|(grid, _)| grid.count(shape, face))
            .sum::<f64>()
    };
    match grids.is_empty() {
        true => 0.0,
        false => faces.map(on_face).sum(),
    }
}

/// The lines along which textures are discontinuous inside faces, in a fixed order. Shapes
/// with more than [`MOST_LINES`] are left out: no derivative with respect to motion is taken beside them. Some
/// of them if the work is given up.
pub fn texture_lines(accel: &Accel, halt: &Halt) -> Vec<Crossing> {
    let mut lines = Vec::new();
    for (shape, &first_face) in accel.scene.shapes.iter().zip(&accel.first_face) {
        if count(accel, shape) > MOST_LINES {
            continue;
        }
        for (grid, emits) in grids(accel, shape) {
            for face in 0..shape.mesh.faces.len() {
                if halt.now() {
                    return lines;
                }
                let pieces = grid.pieces(shape, face);
                let line = |piece| line(accel, first_face as usize + face, piece, emits);
                lines.extend(pieces.into_iter().filter_map(line));
            }
        }
    }
    lines
}

/// A segment of a line, which moves with the material of the face.
fn line(accel: &Accel, face: usize, piece: Piece, emits: bool) -> Option<Crossing> {
    let corners = accel.mesh.corners(face);
    let position = |weights: [f64; 3]| {
        let weighted = corners.iter().zip(weights).map(|(&p, w)| p * w);
        weighted.fold(Vec3::zero(), |sum, p| sum + p)
    };
    let [a, b] = piece.map(position);
    let normal = accel.mesh.face_cross(face).normalized();
    let across = normal.cross(b - a).normalized();
    let end = |weights, position| CrossingEnd {
        position,
        // Along the line nothing changes.
        pulls: [normal, across].map(|axis| Pull {
            vertices: accel.mesh.faces[face],
            weights,
            normal: axis,
            column: axis,
        }),
    };
    let ends = [end(piece[0], a), end(piece[1], b)];
    // A face without extent has no lines.
    across.is_finite().then_some(Crossing { ends, emits })
}

#[cfg(test)]
mod tests {
    use capwalk_geometry::Mesh;
    use capwalk_math::Rgb;
    use capwalk_scene::{Scene, ShadingNormals, builtin};

    use super::*;

    /// A triangle of skewed texture coordinates, some of them on lines.
    fn triangle_with(pattern: Pattern, texels: usize) -> Scene {
        let mut scene = builtin::scene("leaf").expect("built in");
        let corners = [(-3.0, 0.2, 1.0), (2.0, -2.5, 0.3), (1.5, 3.0, -0.4)];
        let mesh = Mesh {
            positions: corners.map(|(x, y, z)| Vec3::new(x, y, z)).to_vec(),
            faces: vec![[0, 1, 2]],
        };
        let bsdf = scene.shapes[0].bsdf;
        let mut shape = Shape::new("skewed", mesh, ShadingNormals::Face, bsdf);
        shape.uvs = Some(vec![[[-0.5, 0.25], [1.75, 0.5], [0.3, 2.0]]]);
        scene.shapes = vec![shape.into()];
        scene.emitters.clear();
        let slot = scene.slots_below(bsdf)[0].texture;
        *scene.texture_mut(slot) = Texture {
            id: "blocks".into(),
            channels: 1,
            data: (0..texels).map(|i| i as f64).collect(),
            pattern,
        };
        scene
    }

    fn patterns() -> Vec<(Pattern, usize)> {
        let to_uv = UvTransform {
            rows: [[1.5, 0.4, 0.1], [-0.3, 2.0, -0.2]],
        };
        let bitmap = |wrap, to_uv| {
            Pattern::Bitmap(Bitmap {
                width: 4,
                height: 3,
                filter: TexelFilter::Nearest,
                wrap,
                to_uv,
            })
        };
        let checkerboard = |to_uv| (Pattern::Checkerboard { to_uv }, 2);
        let wraps = [Wrap::Repeat, Wrap::Clamp].map(|wrap| (bitmap(wrap, to_uv), 12));
        let mut patterns = vec![checkerboard(to_uv), checkerboard(UvTransform::IDENTITY)];
        patterns.extend(wraps);
        patterns
    }

    /// Along any way over a face, the texture changes as often as lines are crossed.
    #[test]
    fn textures_change_where_lines_are() {
        for (pattern, texels) in patterns() {
            let scene = triangle_with(pattern.clone(), texels);
            let accel = Accel::new(scene.clone());
            let shape = &scene.shapes[0];
            let pieces: Vec<Piece> = grids(&accel, shape)
                .iter()
                .flat_map(|(grid, _)| grid.pieces(shape, 0))
                .collect();
            assert!(pieces.len() as f64 <= count(&accel, shape));
            assert_eq!(texture_lines(&accel, &Halt::never()).len(), pieces.len());
            let texture = textures_of(&scene, shape)[0];
            let value = |[u, v]: [f64; 2]| {
                let uv = shape.uv(0, [1.0 - u - v, u, v]);
                texture.lookup(uv, |i| Rgb::splat(i as f64)).r
            };
            for i in 0..40 {
                // Inside the triangle, in the weights of two corners.
                let angle = 0.37 + 0.71 * f64::from(i);
                let around = |k: f64| {
                    let (sin, cos) = (angle + k).sin_cos();
                    [0.33 + 0.25 * cos, 0.33 + 0.25 * sin * 0.9]
                };
                let (from, to) = (around(0.0), around(2.5));
                let at = |t: f64| [0, 1].map(|k| from[k] + (to[k] - from[k]) * t);
                let steps = 20_000;
                let values = (0..=steps).map(|k| value(at(f64::from(k) / f64::from(steps))));
                let values: Vec<f64> = values.collect();
                let changes = values.windows(2).filter(|pair| pair[0] != pair[1]).count();
                let side = |a: [f64; 2], b: [f64; 2], x: [f64; 2]| {
                    (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]) > 0.0
                };
                let crossed = pieces.iter().filter(|piece| {
                    let [a, b] = piece.map(|[_, u, v]| [u, v]);
                    side(a, b, from) != side(a, b, to) && side(from, to, a) != side(from, to, b)
                });
                assert_eq!(changes, crossed.count(), "{pattern:?}, way {i}");
                assert!(changes > 0 || texels > 2);
            }
        }
    }

    /// A line between two faces belongs to one of them.
    #[test]
    fn lines_along_edges_are_found_once() {
        let places = [
            [0.0, 1.0, 1.0],
            [2.0, 1.0, 1.0],
            [0.0, 1.0, 0.0],
            [1.0, 2.0, 2.0],
        ];
        let found = places.map(|places| piece(places, 1.0).is_some());
        assert_eq!(found, [true, false, false, false]);
    }
}
