//! What lanes look up in a scene: faces, and what their sides scatter.

use capwalk_boundary::{Accel, tangents_of_face};
use capwalk_geometry::simd::{Instructions, prefetch};
use capwalk_geometry::{Hit, MeshSphere};
use capwalk_math::{Frame, Rgb, Vec3};
use capwalk_scene::lobe::{Diffuse, Lobe, LocalBsdf, Side};
use capwalk_scene::resolve::Constants;
use capwalk_scene::{
    Bsdf, BsdfId, EmitterId, Scene, Shape, ShapeId, Slot, SurfacePoint, TextureId, outside,
};

use crate::lanes::lobes::{LaneLobes, Lobes};
use crate::lanes::scattered::{Arriving, AskedNumber, OnTexture, Place, Scatterer, asked_numbers};
use crate::lanes::step::{SetDiffuse, SetFace, Vertices};
use crate::lanes::vectors::{lanes_of, mask_of};
use crate::path_adjoint::PathAdjoint;
use crate::scene_eval::Primal;
use crate::shading::Textures;

/// So many lanes are set at once, fewer one by one.
const MANY: u32 = 8;

/// No face.
pub const NOTHING: u32 = u32::MAX;

/// The shapes of a scene, and what is the same all over each of them.
pub struct LaneScene<'a> {
    accel: &'a Accel,
    primal: Primal<'a>,
    /// Which numbers derivatives are asked for with respect to.
    is_asked_for: &'a (dyn Fn(TextureId) -> bool + Sync),
    shapes: Vec<ShapeOfLanes<'a>>,
    instructions: Instructions,
}

/// What a shape's sides scatter: the one that its normal points to, and the other.
struct ShapeOfLanes<'a> {
    sides: [Scattering; 2],
    /// Those of its vertices.
    normals: Option<&'a [Vec3]>,
    /// The same faces in the ray tree, if that has them as a sphere: what rays have just met there is
    /// still in the CPU's cache.
    sphere: Option<&'a MeshSphere>,
    /// True if its material turns with texture coordinates.
    turns: bool,
    emitter: Option<EmitterId>,
    /// The numbers of its material that are asked for.
    asked: Vec<AskedNumber>,
    first_face: u32,
    first_vertex: u32,
}

/// What a side of a surface does to light.
enum Scattering {
    /// Nothing: it is black.
    Nothing,
    /// It reflects a fraction diffusely.
    Diffuse(Rgb),
    /// The fraction is that of a texture.
    Textured(TextureId),
    /// It has other lobes, the same everywhere.
    Lobes(Box<Lobes>),
    /// Its lobes differ from point to point.
    Differing,
}

impl<'a> LaneScene<'a> {
    /// The shapes of a scene, to be differentiated with respect to some numbers.
    pub fn new(accel: &'a Accel, is_asked_for: &'a (dyn Fn(TextureId) -> bool + Sync)) -> Self {
        let shape = |(i, shape): (usize, &'a std::sync::Arc<Shape>)| {
            let slots = asked_slots(&accel.scene, shape, is_asked_for);
            let asked = asked_numbers(&accel.scene, shape, slots);
            let faces = accel.first_face[i]..accel.first_face[i] + shape.mesh.faces.len() as u32;
            ShapeOfLanes {
                sides: match asked[..] {
                    [] => sides(accel, shape, accel.needs_tangent[i]),
                    _ => textured(&accel.scene, shape.bsdf).unwrap_or_else(differing),
                },
                asked,
                normals: shape.normals.per_vertex(),
                sphere: (accel.rays().sphere_of(faces))
                    .filter(|sphere| sphere.first_vertex() == accel.first_vertex[i]),
                turns: accel.needs_tangent[i],
                emitter: shape.emitter,
                first_face: accel.first_face[i],
                first_vertex: accel.first_vertex[i],
            }
        };
        Self {
            accel,
            primal: Primal(accel),
            is_asked_for,
            shapes: accel.scene.shapes.iter().enumerate().map(shape).collect(),
            instructions: Instructions::detect(),
        }
    }

    #[inline]
    fn shape_of(&self, face: u32) -> (ShapeId, &ShapeOfLanes<'a>) {
        let id = self.accel.shape_of_face[face as usize];
        (id, &self.shapes[id.0 as usize])
    }

    /// The emitter of a face, or what is seen where nothing is met.
    #[inline]
    pub fn emitter_at(&self, face: u32) -> Option<EmitterId> {
        match face {
            NOTHING => self.accel.scene.environment(),
            _ => self.shape_of(face).1.emitter,
        }
    }

    /// True if a ray in a direction meets the front of a face, or nothing.
    #[inline]
    pub fn is_in_front(&self, face: u32, direction: Vec3) -> bool {
        face == NOTHING || self.accel.mesh.face_cross(face as usize).dot(direction) < 0.0
    }

    /// Where a ray meets the plane of the face that it hits.
    pub fn hit(&self, face: u32, origin: Vec3, direction: Vec3) -> Option<Hit> {
        if face == NOTHING {
            return None;
        }
        let [a, b, c] = self.accel.mesh.corners(face as usize);
        let (ab, ac) = (b - a, c - a);
        let cross = ab.cross(ac);
        let t = (a - origin).dot(cross) / direction.dot(cross);
        let offset = origin + direction * t - a;
        let scale = 1.0 / cross.length_squared();
        let barycentric = [offset.cross(ac), ab.cross(offset)].map(|v| v.dot(cross) * scale);
        Some(Hit {
            t,
            face,
            barycentric,
        })
    }

    /// Looks up the face that some paths hit.
    #[inline]
    pub fn set_face(&self, face: u32, lanes: u32, vertices: &mut Vertices) {
        let shape = self.shape_of(face).1;
        let corners = match shape.sphere {
            Some(sphere) => sphere.corners_of(face - shape.first_face),
            None => self.accel.mesh.corners(face as usize),
        };
        if let Some(normals) = shape.normals {
            for i in self.vertices_of(shape, face) {
                prefetch(&normals[i as usize]);
            }
        }
        if lanes.count_ones() >= MANY {
            return self.instructions.run(SetFace {
                corners,
                lanes,
                vertices,
            });
        }
        let [a, b, c] = corners;
        for lane in lanes_of(lanes) {
            vertices.corner.set(lane, a);
            vertices.edges[0].set(lane, b - a);
            vertices.edges[1].set(lane, c - a);
        }
    }

    /// Looks up what the face scatters that some paths hit, where their positions are known; one bit for
    /// each where it scatters something. `front` has one for each that sees the side of its normal. What
    /// is not diffuse goes to `lobes`.
    pub fn look_up<'s>(
        &'s self,
        face: u32,
        lanes: u32,
        front: u32,
        vertices: &mut Vertices,
        lobes: &mut LaneLobes<'s>,
    ) -> u32 {
        let shape = self.shape_of(face).1;
        let mut first = lanes & front;
        if let Some(normals) = shape.normals {
            let normals = self.vertices_of(shape, face).map(|i| normals[i as usize]);
            for lane in lanes_of(lanes) {
                let (outward, out) = interpolated(normals, lane, vertices);
                vertices.outward.set(lane, outward);
                if out < 0.0 {
                    first ^= 1 << lane;
                }
            }
        }
        lobes.clear(lanes);
        let mut found = 0;
        for (place, lanes) in [first, lanes & !first].into_iter().enumerate() {
            if lanes != 0 {
                found |= self.look_up_side((face, shape, place), lanes, vertices, lobes);
            }
        }
        found
    }

    /// What one of the sides of a face scatters.
    fn look_up_side<'s>(
        &'s self,
        (face, shape, place): (u32, &'s ShapeOfLanes<'_>, usize),
        lanes: u32,
        vertices: &mut Vertices,
        lobes: &mut LaneLobes<'s>,
    ) -> u32 {
        // What is diffuse from behind is the front of the back of a two-sided material.
        let side = [1.0, -1.0][place];
        match &shape.sides[place] {
            Scattering::Nothing => return 0,
            Scattering::Diffuse(reflectance) if lanes.count_ones() >= MANY => {
                self.instructions.run(SetDiffuse {
                    reflectance: *reflectance,
                    side,
                    lanes,
                    vertices,
                });
            }
            Scattering::Diffuse(reflectance) => {
                for lane in lanes_of(lanes) {
                    vertices.side[lane] = side;
                    vertices.scattered.set_colour(lane, *reflectance);
                }
            }
            Scattering::Textured(id) => {
                for lane in lanes_of(lanes) {
                    let reflectance = self.texture(*id, face, lane, vertices);
                    vertices.side[lane] = side;
                    vertices.scattered.set_colour(lane, reflectance);
                }
            }
            Scattering::Lobes(found) => {
                for lane in lanes_of(lanes) {
                    lobes.set(lane, found, self.tangent(face, lane, vertices));
                    vertices.side[lane] = found.front;
                    vertices.scattered.set(lane, Vec3::zero());
                }
            }
            Scattering::Differing => {
                let seen = [Side::Front, Side::Back][place];
                return mask_of(lanes, |lane| {
                    let tangent = self.tangent(face, lane, vertices);
                    let find = |bsdf: &mut _| self.resolve(face, lane, vertices, seen, bsdf);
                    let front = lobes.set_own(lane, tangent, find);
                    vertices.side[lane] = front.unwrap_or(1.0);
                    vertices.scattered.set(lane, Vec3::zero());
                    front.is_some()
                });
            }
        }
        lanes
    }

    /// True if numbers of the material of a face are asked for.
    pub fn is_asked_for(&self, face: u32) -> bool {
        !self.shape_of(face).1.asked.is_empty()
    }

    /// From the covectors on what a surface scatters to those on the texels that are asked for.
    pub fn pull(
        &self,
        at: Place<'_>,
        arrives: &[Option<Arriving>; 2],
        depends: &mut impl FnMut(PathAdjoint),
    ) {
        let Place {
            face,
            lane,
            vertices,
        } = at;
        let (outward, place) = self.seen(face, lane, vertices);
        let (id, shape) = self.shape_of(face);
        let point = self.point(face, lane, vertices);
        if let Scattering::Textured(texture) = shape.sides[place] {
            let covectors = arrives.iter().flatten().map(|light| light.covector);
            let sum = covectors.fold(Rgb::zero(), |sum, covector| sum + covector);
            return self.pull_texture(texture, Some(&point), sum, depends);
        }
        let tangents = self.tangents(face, lane, vertices);
        let surface = Scatterer {
            scene: &self.accel.scene,
            resolver: &self.accel.resolver,
            material: self.accel.scene.shape(id).bsdf,
            side: [Side::Front, Side::Back][place],
            frame: frame_of(outward, tangents),
            to_viewer: -vertices.direction.get(lane),
            textures: &mut self.textures(&point, tangents, outward),
        };
        surface.pull(&shape.asked, arrives, |texture, covector| match covector {
            OnTexture::Alike(covector) => {
                self.pull_texture(texture, Some(&point), covector, depends);
            }
            OnTexture::Mixed(covectors) => {
                let scene = &self.accel.scene;
                scene.texel_weights(texture, &point, |texture, index, weight| {
                    let covectors = covectors.map(|covector| covector * weight);
                    depends(PathAdjoint::MixedTexel {
                        texture,
                        index,
                        covectors,
                    });
                });
            }
        });
    }

    /// From the covector on the value of a texture to those on its texels, if they are asked for.
    /// The point is needed unless the texture is the same everywhere.
    pub fn pull_texture(
        &self,
        texture: TextureId,
        at: Option<&SurfacePoint<f64>>,
        covector: Rgb,
        depends: &mut impl FnMut(PathAdjoint),
    ) {
        let scene = &self.accel.scene;
        match at.filter(|_| !scene.texture(texture).is_constant()) {
            None => self.add_texel(texture, 0, covector, depends),
            Some(at) => scene.texel_weights(texture, at, |id, index, weight| {
                self.add_texel(id, index, covector * weight, depends);
            }),
        }
    }

    /// Adds the covector on a texel, if it is asked for.
    #[inline]
    pub fn add_texel(
        &self,
        texture: TextureId,
        index: usize,
        covector: Rgb,
        depends: &mut impl FnMut(PathAdjoint),
    ) {
        if (self.is_asked_for)(texture) {
            depends(PathAdjoint::Texel {
                texture,
                index,
                covector,
            });
        }
    }

    /// A point of an emitter.
    pub fn point_of(&self, hit: &Hit) -> SurfacePoint<f64> {
        let [wb, wc] = hit.barycentric;
        self.point_at(hit.face, [1.0 - wb - wc, wb, wc])
    }

    /// The shading normal on the outside, and which of the shape's sides a path hits.
    #[inline]
    fn seen(&self, face: u32, lane: usize, vertices: &Vertices) -> (Vec3, usize) {
        let shape = self.shape_of(face).1;
        let (outward, out) = match shape.normals {
            None => (vertices.face_normal.get(lane), 1.0),
            Some(normals) => {
                let normals = self.vertices_of(shape, face).map(|i| normals[i as usize]);
                interpolated(normals, lane, vertices)
            }
        };
        (outward, usize::from(vertices.seen[lane] * out <= 0.0))
    }

    /// The vertices of a face, counted from its shape's first.
    #[inline]
    fn vertices_of(&self, shape: &ShapeOfLanes<'_>, face: u32) -> [u32; 3] {
        match shape.sphere {
            Some(sphere) => sphere.vertices_of(face - shape.first_face),
            None => self.accel.mesh.faces[face as usize].map(|i| i - shape.first_vertex),
        }
    }

    /// The point on its shape.
    fn point(&self, face: u32, lane: usize, vertices: &Vertices) -> SurfacePoint<f64> {
        self.point_at(face, vertices.barycentric(lane))
    }

    fn point_at(&self, face: u32, barycentric: [f64; 3]) -> SurfacePoint<f64> {
        let (id, shape) = self.shape_of(face);
        let face = (face - shape.first_face) as usize;
        SurfacePoint {
            shape: id,
            face,
            barycentric,
            uv: self.accel.scene.shape(id).uv(face, barycentric),
        }
    }

    fn texture(&self, id: TextureId, face: u32, lane: usize, vertices: &Vertices) -> Rgb {
        let scene = &self.accel.scene;
        let texture = scene.texture(id);
        if texture.is_constant() {
            return texture.texel(0);
        }
        let texel = |id, index| scene.texture(id).texel(index);
        scene.lookup(id, &self.point(face, lane, vertices), texel)
    }

    /// Derivatives of the position with respect to the texture coordinates, if the material turns
    /// with them.
    fn tangents(&self, face: u32, lane: usize, vertices: &Vertices) -> Option<[Vec3; 2]> {
        let (id, shape) = self.shape_of(face);
        let edges = [0, 1].map(|i| vertices.edges[i].get(lane));
        let face = (face - shape.first_face) as usize;
        shape
            .turns
            .then(|| tangents_of_face(self.accel.scene.shape(id), face, edges))?
    }

    fn tangent(&self, face: u32, lane: usize, vertices: &Vertices) -> Option<Vec3> {
        self.tangents(face, lane, vertices)
            .map(|[along_u, _]| along_u)
    }

    /// The textures at a point.
    fn textures<'p>(
        &'p self,
        point: &'p SurfacePoint<f64>,
        tangents: Option<[Vec3; 2]>,
        outward: Vec3,
    ) -> Textures<'p, f64, Primal<'p>> {
        Textures {
            eval: &self.primal,
            is_asked_for: self.is_asked_for,
            point,
            tangents,
            frame: frame_of(outward, tangents),
        }
    }

    /// Adds the lobes at a point of a shape on which they differ; `None` if there are none, else
    /// whether the normal is to be turned over.
    fn resolve(
        &self,
        face: u32,
        lane: usize,
        vertices: &Vertices,
        seen: Side,
        bsdf: &mut LocalBsdf,
    ) -> Option<bool> {
        let (id, _) = self.shape_of(face);
        let tangents = self.tangents(face, lane, vertices);
        let outward = vertices.outward.get(lane);
        let point = self.point(face, lane, vertices);
        let mut textures = self.textures(&point, tangents, outward);
        let (scene, resolver) = (&self.accel.scene, &self.accel.resolver);
        let material = scene.shape(id).bsdf;
        let flipped = resolver.resolve_into(scene, material, seen, &mut textures, bsdf);
        bsdf.lobes().next()?;
        // What has no weight may have a derivative.
        if self.is_asked_for(face) {
            bsdf.explore();
        }
        Some(flipped)
    }
}

/// The interpolated normal, and 1 or -1 for whether the face's own points out.
#[inline]
fn interpolated(normals: [Vec3; 3], lane: usize, vertices: &Vertices) -> (Vec3, f64) {
    let out = outside(normals, vertices.face_normal.get(lane));
    let [a, b, c] = normals;
    let [wa, wb, wc] = vertices.barycentric(lane);
    ((a * wa + b * wb + c * wc).normalized(), out)
}

/// The places in a shape's material of textures whose numbers are asked for.
pub fn asked_slots(
    scene: &Scene,
    shape: &Shape,
    is_asked_for: &dyn Fn(TextureId) -> bool,
) -> impl Iterator<Item = Slot> {
    let slots = scene.slots_below(shape.bsdf).into_iter();
    slots.filter(|slot| is_asked_for(scene.numbers_of(slot.texture, shape)))
}

/// The shading frame with a normal, which follows the first texture coordinate if it turns with it.
fn frame_of(outward: Vec3, tangents: Option<[Vec3; 2]>) -> Frame<f64> {
    match tangents {
        Some([along_u, _]) => Frame::from_normal_and_tangent(outward, along_u),
        None => Frame::from_normal(outward),
    }
}

fn differing() -> [Scattering; 2] {
    [Scattering::Differing, Scattering::Differing]
}

/// What the sides of a shape do to light. `turns` if the material turns with texture coordinates.
fn sides(accel: &Accel, shape: &Shape, turns: bool) -> [Scattering; 2] {
    let scene: &Scene = &accel.scene;
    let slots = scene.slots_below(shape.bsdf);
    let mut textures = slots.iter().map(|slot| scene.texture(slot.texture));
    if !textures.all(|texture| texture.is_constant()) {
        return textured(scene, shape.bsdf).unwrap_or_else(differing);
    }
    [Side::Front, Side::Back].map(|side| {
        let resolver = &accel.resolver;
        let resolved = resolver.resolve(scene, shape.bsdf, side, &mut Constants(scene));
        let lobes: Vec<_> = resolved.bsdf.lobes().collect();
        match lobes[..] {
            [] => Scattering::Nothing,
            [(1.0, Lobe::Diffuse(lobe))] if !turns => Scattering::Diffuse(lobe.reflectance),
            _ => Scattering::Lobes(Box::new(Lobes::new(resolved))),
        }
    })
}

/// What both sides of a material reflect, if it is diffuse.
fn textured(scene: &Scene, id: BsdfId) -> Option<[Scattering; 2]> {
    let side = |id: BsdfId| match &scene.material(id).bsdf {
        Bsdf::Plain(Lobe::Diffuse(Diffuse { reflectance })) => {
            Some(Scattering::Textured(*reflectance))
        }
        _ => None,
    };
    match &scene.material(id).bsdf {
        Bsdf::TwoSided { front, back } => Some([side(*front)?, side(*back)?]),
        _ => Some([side(id)?, Scattering::Nothing]),
    }
}
