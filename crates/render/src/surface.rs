//! Intersections of rays with surfaces, with the derivatives of both, and what is emitted
//! there.

use capwalk_boundary::{Accel, tangents_of_face};
use capwalk_geometry::Hit;
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::emitter::delta::DeltaLight;
use capwalk_scene::lobe::Side;
use capwalk_scene::{BsdfId, Emitter, EmitterId, SurfacePoint, outside};

use crate::scene_eval::SceneEval;

/// The intersection of a ray and a surface, both possibly moving.
#[derive(Clone, Copy, Debug)]
pub struct Surface<R> {
    /// World-space position.
    pub position: Vec3<R>,
    /// The point on the shape.
    pub point: SurfacePoint<R>,
    /// Normal of the face by its winding; its length is twice the area of the face.
    cross: Vec3<R>,
    /// 1 if that is on the outside, else -1.
    out: f64,
    /// Unit shading normal on the outside.
    pub outward: Vec3<R>,
    /// Derivatives of the position with respect to the texture coordinates, if the material
    /// needs them and the shape has texture coordinates.
    pub tangents: Option<[Vec3<R>; 2]>,
    /// Unit geometric normal on the viewer's side.
    pub face_normal: Vec3,
    /// Which side is seen.
    pub side: Side,
    /// The face, of all in the scene.
    pub face: u32,
    /// The shape's material.
    pub material: BsdfId,
}

impl<R: Real> Surface<R> {
    /// Unit geometric normal on the outside.
    pub fn geometric(&self) -> Vec3<R> {
        self.cross.normalized() * R::constant(self.out)
    }
}

/// The surface at a hit of the ray from `origin` along `direction`. Which
/// side is seen is decided by the face, not by the interpolated normal: the
/// latter would end the material along a curve inside faces, where no edge
/// is.
pub fn surface_at<R: Real, W: SceneEval<R>>(
    eval: &W,
    accel: &Accel,
    hit: &Hit,
    origin: Vec3<R>,
    direction: Vec3<R>,
) -> Surface<R> {
    let scene = &accel.scene;
    let shape_id = accel.shape_of(hit);
    let shape = scene.shape(shape_id);
    let corners = accel.mesh.faces[hit.face as usize];
    let [i, j, k] = corners;
    let (a, b, c) = (eval.vertex(i), eval.vertex(j), eval.vertex(k));
    let (edge1, edge2) = (b - a, c - a);
    let cross = edge1.cross(edge2);

    // Intersect the moving ray with the moving plane of the triangle.
    let t = (a - origin).dot(cross) / direction.dot(cross);
    let position = origin + direction * t;

    let face_normal = cross.value().normalized();
    let seen = if face_normal.dot(direction.value()) > 0.0 {
        -1.0
    } else {
        1.0
    };
    let needs_place = accel.needs_place[shape_id.0 as usize];
    let [wb, wc] = match W::MOVES && needs_place {
        true => {
            // Barycentric weights by the areas opposite to the corners.
            let offset = position - a;
            let scale = R::constant(1.0) / cross.length_squared();
            let twice_area = |a: Vec3<R>, b: Vec3<R>| a.cross(b).dot(cross) * scale;
            [twice_area(offset, edge2), twice_area(edge1, offset)]
        }
        false => hit.barycentric.map(R::constant),
    };
    let barycentric = [R::constant(1.0) - wb - wc, wb, wc];
    let (outward, out) = match shape.normals.per_vertex() {
        None => (cross.normalized(), 1.0),
        Some(_) => {
            let first = accel.first_vertex[shape_id.0 as usize];
            let normal = |i: u32| eval.normal(shape_id.0 as usize, i - first);
            let (na, nb, nc) = (normal(i), normal(j), normal(k));
            let out = outside([na, nb, nc].map(Vec3::value), face_normal);
            let normal = (na + (nb - na) * wb + (nc - na) * wc).normalized();
            (normal, out)
        }
    };
    let face = (hit.face - accel.first_face[shape_id.0 as usize]) as usize;
    Surface {
        position,
        point: SurfacePoint {
            shape: shape_id,
            face,
            barycentric,
            uv: match needs_place {
                true => shape.uv(face, barycentric),
                false => [wb, wc], // not needed
            },
        },
        cross,
        out,
        outward,
        tangents: match accel.needs_tangent[shape_id.0 as usize] {
            true => tangents_of_face(shape, face, [edge1, edge2]),
            false => None,
        },
        face_normal: face_normal * seen,
        side: if seen * out > 0.0 {
            Side::Front
        } else {
            Side::Back
        },
        face: hit.face,
        material: shape.bsdf,
    }
}

/// Radiance that an emitter sends back along a ray that hits it at `hit`, or that misses
/// everything if it is the environment. No ray hits an emitter without extent.
pub fn emitted_at<R: Real, W: SceneEval<R>>(
    eval: &W,
    accel: &Accel,
    emitter: EmitterId,
    hit: Option<&Hit>,
    origin: Vec3<R>,
    direction: Vec3<R>,
) -> Rgb<R> {
    let scene = &accel.scene;
    match (scene.emitter(emitter), hit) {
        (Emitter::Area { radiance, .. }, Some(hit)) if !scene.texture(*radiance).is_constant() => {
            let surface = surface_at(eval, accel, hit, origin, direction);
            eval.lookup(*radiance, &surface.point)
        }
        (Emitter::Area { radiance, .. } | Emitter::Constant { radiance, .. }, _) => {
            eval.texel(*radiance, 0)
        }
        (
            Emitter::EnvironmentMap {
                map, data, scale, ..
            },
            _,
        ) => {
            let texels = map.lookup(direction, |index| eval.texel(*data, index));
            texels * eval.texel(*scale, 0)
        }
        (
            Emitter::Point { .. }
            | Emitter::Spot { .. }
            | Emitter::Projector { .. }
            | Emitter::Directional { .. },
            _,
        ) => unreachable!("no ray hits an emitter without extent"),
    }
}

/// Irradiance across its direction that a point receives from an emitter without extent.
pub fn irradiance_of<R: Real, W: SceneEval<R>>(
    eval: &W,
    emitter: &Emitter,
    light: &DeltaLight<R>,
) -> Rgb<R> {
    // Textures that are not images have the same value everywhere.
    let uv = light.uv.unwrap_or([R::constant(0.0); 2]);
    let number = |id| {
        let texture = eval.scene().texture(id);
        texture.lookup(uv, |index| eval.texel(id, index))
    };
    let intensity = number(emitter.radiance()) * light.factor;
    match emitter.factor() {
        None => intensity,
        Some(factor) => intensity * number(factor),
    }
}
