//! A scene prepared for queries: one mesh, its ray tree, its emitters.

use std::sync::{Arc, OnceLock};

use capwalk_geometry::{
    BUNDLE, HalfSpace, Halt, Halted, Hit, Mesh, Ray, RayTree, Shadow, Wedge, WedgePoint,
};
use capwalk_math::Vec3;
use capwalk_scene::lobe::Event;
use capwalk_scene::resolve::Resolver;
use capwalk_scene::sensor::view::{View, ViewRay};
use capwalk_scene::{DeltaLight, EmitterId, Scene, ShapeId};

use crate::flush_emitter::FlushEmitters;
use crate::material::{FlatEvents, flat_events, needs_place, needs_tangent};
use crate::mirror_planes::MirrorPlanes;

/// All shapes of a scene in one mesh, with the tree for its rays. Vertex and
/// face indices of a shape follow those of the shapes before it.
#[derive(Clone, Debug)]
pub struct Accel {
    /// The scene.
    pub scene: Arc<Scene>,
    /// All triangles.
    pub mesh: Mesh,
    /// The shape of each face.
    pub shape_of_face: Vec<ShapeId>,
    /// First vertex of each shape.
    pub first_vertex: Vec<u32>,
    /// First face of each shape.
    pub first_face: Vec<u32>,
    /// What places the emitters without extent, emitter by emitter: points of the boundaries
    /// behind the vertices of the joined mesh.
    pub anchors: Vec<Vec3>,
    /// First anchor of each emitter.
    first_anchor: Vec<u32>,
    /// For each shape, true if its material depends on its rotation about the normal.
    pub needs_tangent: Vec<bool>,
    /// What the camera sees from the middle of its lens.
    pub view: View<f64>,
    /// For each shape, true if its shading depends on where on a face it is hit.
    pub needs_place: Vec<bool>,
    /// What materials need besides their textures.
    pub resolver: Resolver,
    /// What specular events at each shape keep images in shape.
    flat_events: Vec<FlatEvents>,
    has_flat_events: bool,
    /// The planes of flat mirrors; found when they are first asked for.
    mirror_planes: OnceLock<Option<MirrorPlanes>>,
    rays: RayTree,
    /// Emitters in the planes of other surfaces.
    flush: Option<FlushEmitters>,
    /// Distances below this (world units) around a ray's origin belong to the
    /// surface it starts on.
    self_distance: f64,
}

/// Fraction by which a shadow ray stops short of the point it is sent to.
pub(crate) const SHORT_OF_TARGET: f64 = 1e-9;

/// A refitted tree whose surface-area cost is this many times that of when it was built
/// is built anew: rays take about 2.7 times as long there.
pub(crate) const WORN_OUT: f64 = 2.0;

/// What became of a scene's joined mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshChange {
    /// All vertices are where they were.
    None,
    /// Vertices moved; faces are the same.
    Moved,
    /// Everything may be different.
    Rebuilt,
}

impl Accel {
    /// Builds the tree of a checked scene.
    pub fn new(scene: impl Into<Arc<Scene>>) -> Self {
        Self::try_new(scene.into(), &Halt::never()).expect("nobody gives it up")
    }

    /// [`Self::new`], unless the work is given up.
    pub fn try_new(scene: Arc<Scene>, halt: &Halt) -> Result<Self, Halted> {
        let joined = Joined::new(&scene);
        let rays = RayTree::try_build(&joined.mesh, halt)?;
        let resolver = Resolver::new(&scene);
        Ok(Self::assemble(scene, joined, rays, resolver))
    }

    /// Goes over to another checked scene: refits the tree if its faces are the same.
    pub fn update(&mut self, scene: Arc<Scene>) -> MeshChange {
        let pairs = scene.shapes.iter().zip(&self.scene.shapes);
        let is_same = scene.shapes.len() == self.scene.shapes.len()
            && pairs.into_iter().all(|(new, old)| Arc::ptr_eq(new, old));
        let joined = match is_same {
            true => self.take_joined(),
            false => Joined::new(&scene),
        };
        let mut rays = std::mem::replace(&mut self.rays, RayTree::build(&Mesh::default()));
        let same_faces = || {
            joined.mesh.faces == self.mesh.faces
                && joined.shape_of_face == self.shape_of_face
                && joined.first_vertex == self.first_vertex
        };
        let change = if is_same {
            MeshChange::None
        } else if !same_faces() {
            MeshChange::Rebuilt
        } else if joined.mesh.positions == self.mesh.positions {
            MeshChange::None
        } else {
            rays.refit(&joined.mesh);
            MeshChange::Moved
        };
        if change == MeshChange::Rebuilt || rays.degradation() > WORN_OUT {
            rays = RayTree::build(&joined.mesh);
        }
        let mut resolver = std::mem::take(&mut self.resolver);
        resolver.update(&scene);
        *self = Self::assemble(scene, joined, rays, resolver);
        change
    }

    /// The joined mesh, taken away.
    fn take_joined(&mut self) -> Joined {
        Joined {
            mesh: std::mem::take(&mut self.mesh),
            shape_of_face: std::mem::take(&mut self.shape_of_face),
            first_vertex: std::mem::take(&mut self.first_vertex),
            first_face: std::mem::take(&mut self.first_face),
        }
    }

    fn assemble(scene: Arc<Scene>, joined: Joined, rays: RayTree, resolver: Resolver) -> Self {
        let Joined {
            mesh,
            shape_of_face,
            first_vertex,
            first_face,
        } = joined;
        let shapes = || scene.shapes.iter();
        let (mut anchors, mut first_anchor) = (Vec::new(), Vec::new());
        for emitter in &scene.emitters {
            first_anchor.push(anchors.len() as u32);
            anchors.extend(emitter.anchors());
        }
        let flat_events: Vec<_> = shapes().map(|shape| flat_events(&scene, shape)).collect();
        let flush = FlushEmitters::new(&scene, &mesh, &shape_of_face, &first_face);
        Self {
            shape_of_face,
            first_vertex,
            first_face,
            anchors,
            first_anchor,
            needs_tangent: shapes().map(|s| needs_tangent(&scene, s.bsdf)).collect(),
            view: scene.sensor.view(&scene.film),
            needs_place: shapes().map(|s| needs_place(&scene, s)).collect(),
            resolver,
            has_flat_events: flat_events.iter().any(|events| !events.is_empty()),
            flat_events,
            mirror_planes: OnceLock::new(),
            flush,
            rays,
            mesh,
            self_distance: scene.nearest_hit(),
            scene,
        }
    }

    /// The tree for rays.
    pub fn rays(&self) -> &RayTree {
        &self.rays
    }

    /// True if some emitter lies in the plane of another surface: rays that meet both meet the
    /// emitter.
    pub fn has_flush_emitters(&self) -> bool {
        self.flush.is_some()
    }

    /// Points this close (world units) to a plane lie in it, as far as ray hits
    /// are precise. Rays from surfaces do not meet what is nearer.
    pub fn horizon_distance(&self) -> f64 {
        self.self_distance
    }

    /// The first surface seen from a point on another one.
    #[inline]
    pub fn first_hit(&self, origin: Vec3, direction: Vec3) -> Option<Hit> {
        self.first_hit_within(&self.surface_ray(origin, direction))
    }

    /// A ray from a point on a surface.
    #[inline]
    pub fn surface_ray(&self, origin: Vec3, direction: Vec3) -> Ray {
        Ray {
            t_min: self.self_distance,
            ..Ray::new(origin, direction)
        }
    }

    /// Where faces cross a wedge of light, in ascending order.
    pub fn across(&self, wedge: &Wedge, found: &mut Vec<(u32, [WedgePoint; 2])>) {
        self.rays.across(&self.mesh, wedge, found);
    }

    /// The first surface along a ray with bounds of its own; of surfaces in one plane, an
    /// emitter that shows its front.
    #[inline]
    pub fn first_hit_within(&self, ray: &Ray) -> Option<Hit> {
        let hit = self.rays.first_hit(ray)?;
        let emitter = self.flush.as_ref().and_then(|flush| {
            let is_emitter = self.scene.shape(self.shape_of(&hit)).emitter.is_some();
            (!is_emitter).then(|| flush.in_front(ray, &hit)).flatten()
        });
        Some(emitter.unwrap_or(hit))
    }

    /// True if nothing lies between two points on surfaces.
    #[inline]
    pub fn visible(&self, from: Vec3, to: Vec3) -> bool {
        let offset = to - from;
        let distance = offset.length();
        self.surface_sees(from, offset / distance, distance)
    }

    /// True if nothing lies between a point on a surface and the point at a
    /// distance along a unit direction.
    #[inline]
    pub fn surface_sees(&self, from: Vec3, direction: Vec3, distance: f64) -> bool {
        self.is_free(self.surface_ray(from, direction), distance)
    }

    /// True if nothing lies on a ray before the point at a distance.
    #[inline]
    pub(crate) fn is_free(&self, ray: Ray, distance: f64) -> bool {
        let t_max = distance * (1.0 - SHORT_OF_TARGET);
        !self.rays.occluded(&Ray { t_max, ..ray })
    }

    /// What the face hides that is first seen from a point on a surface in a direction: the part of it in front of
    /// the plane through the point with this unit normal, and not in that plane. There, no ray from the point is free.
    pub(crate) fn shadow_before(
        &self,
        from: Vec3,
        direction: Vec3,
        normal: Vec3,
    ) -> Option<Shadow> {
        let hit = self.rays.first_hit(&self.surface_ray(from, direction))?;
        let corners = self.mesh.corners(hit.face as usize);
        let shadow = Shadow::of_face(from, corners, self.self_distance)?;
        Some(shadow.in_front_of(HalfSpace {
            point: from + normal * (2.0 * self.self_distance),
            normal,
        }))
    }

    /// The distances between which something is in the way of each ray of a bundle from points on
    /// surfaces to points at these distances, as [`Self::surface_sees`] has them.
    pub fn ranges_to_targets(&self, distances: &[f64; BUNDLE]) -> [[f64; BUNDLE]; 2] {
        let ends = distances.map(|distance| distance * (1.0 - SHORT_OF_TARGET));
        [[self.self_distance; BUNDLE], ends]
    }

    /// The camera's ray from a point of its lens in a unit direction, between its
    /// clip planes.
    pub fn camera_ray(&self, viewpoint: Vec3, direction: Vec3) -> Ray {
        bounded_ray(&self.view.from(viewpoint).ray(direction))
    }

    /// What the camera can see, up to rounding: what is behind its near plane. `None` if its
    /// rays are parallel.
    pub fn behind_near_plane(&self) -> Option<HalfSpace> {
        (!self.view.is_parallel()).then(|| {
            let [point, normal] = self.view.near_plane();
            // Moved towards the camera by more than rounding.
            let point = point + (self.view.origin - point) * SHORT_OF_TARGET;
            HalfSpace { point, normal }
        })
    }

    /// True if the camera sees the point at a distance along its ray from a point
    /// of its lens: between its clip planes, nothing is before it.
    pub fn camera_sees(&self, viewpoint: Vec3, direction: Vec3, distance: f64) -> bool {
        let ray = self.camera_ray(viewpoint, direction);
        ray.t_min < distance
            && distance < ray.t_max
            && !self.rays.occluded(&Ray {
                t_max: distance * (1.0 - SHORT_OF_TARGET),
                ..ray
            })
    }

    /// True if there are flat mirrors or panes.
    #[inline]
    pub fn has_flat_events(&self) -> bool {
        self.has_flat_events
    }

    /// What specular events at a hit keep images in shape.
    #[inline]
    pub fn flat_events(&self, hit: &Hit) -> FlatEvents {
        self.flat_events[self.shape_of(hit).0 as usize]
    }

    /// True if a shape has perfectly specular reflections that keep images in shape.
    pub fn is_flat_mirror(&self, shape: ShapeId) -> bool {
        self.flat_events[shape.0 as usize].contains(Event::Reflect)
    }

    /// The planes of all flat mirrors; `None` if there are too many to make images by each.
    pub fn mirror_planes(&self) -> Option<&MirrorPlanes> {
        let find = || {
            let events = |face: u32| self.flat_events[self.shape_of_face[face as usize].0 as usize];
            let reflects = |face: u32| events(face).contains(Event::Reflect);
            MirrorPlanes::new(&self.mesh, reflects)
        };
        self.mirror_planes.get_or_init(find).as_ref()
    }

    /// The shape that a vertex of the joined mesh belongs to.
    #[inline]
    pub fn shape_of_vertex(&self, vertex: u32) -> ShapeId {
        ShapeId(self.first_vertex.partition_point(|&first| first <= vertex) as u32 - 1)
    }

    /// The shape that was hit.
    #[inline]
    pub fn shape_of(&self, hit: &Hit) -> ShapeId {
        self.shape_of_face[hit.face as usize]
    }

    /// The number among the points of the boundaries of the first anchor of an emitter.
    #[inline]
    pub fn anchor(&self, emitter: EmitterId) -> u32 {
        self.mesh.positions.len() as u32 + self.first_anchor[emitter.0 as usize]
    }

    /// How a point receives an emitter without extent, see [`capwalk_scene::Emitter::delta_light`].
    pub fn delta_light(&self, id: EmitterId, point: Vec3) -> Option<DeltaLight<f64>> {
        let first = self.first_anchor[id.0 as usize] as usize;
        let anchor = |i: usize| self.anchors[first + i];
        let number = |id| self.scene.texture(id).data[0];
        self.scene.emitter(id).delta_light(point, anchor, number)
    }

    /// The face of the joined mesh that is the given one of an emitter.
    #[inline]
    pub fn emitter_face(&self, emitter: EmitterId, face: u32) -> u32 {
        let shape = self.scene.emitter(emitter).shape();
        let shape = shape.expect("only emitters on shapes have faces");
        self.first_face[shape.0 as usize] + face
    }

    /// What emits at a hit towards a viewer that looks along `direction`: only
    /// the front does.
    #[inline]
    pub fn emitter_at(&self, hit: &Hit, direction: Vec3) -> Option<EmitterId> {
        let emitter = self.scene.shape(self.shape_of(hit)).emitter?;
        let front = self.mesh.face_cross(hit.face as usize).dot(direction) < 0.0;
        front.then_some(emitter)
    }
}

/// A camera's ray between its clip planes.
pub fn bounded_ray(ray: &ViewRay<f64>) -> Ray {
    let [t_min, t_max] = ray.range;
    Ray {
        origin: ray.origin,
        direction: ray.direction,
        t_min,
        t_max,
    }
}

/// All shapes of a scene in one mesh.
struct Joined {
    mesh: Mesh,
    shape_of_face: Vec<ShapeId>,
    first_vertex: Vec<u32>,
    first_face: Vec<u32>,
}

impl Joined {
    fn new(scene: &Scene) -> Self {
        let mut joined = Self {
            mesh: Mesh::default(),
            shape_of_face: Vec::new(),
            first_vertex: Vec::new(),
            first_face: Vec::new(),
        };
        for (i, shape) in scene.shapes.iter().enumerate() {
            let mesh = &mut joined.mesh;
            joined.first_vertex.push(mesh.positions.len() as u32);
            joined.first_face.push(mesh.faces.len() as u32);
            mesh.append(&shape.mesh);
            joined
                .shape_of_face
                .resize(mesh.faces.len(), ShapeId(i as u32));
        }
        joined
    }
}
