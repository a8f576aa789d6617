//! The numbers of a scene, with or without derivatives. The same code evaluates
//! a path, its forward and its reverse derivative, by asking one [`SceneEval`] or
//! another.

use std::borrow::Cow;

use capwalk_boundary::{Accel, Motion, Numbers, Viewpoint, Warp};
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::sensor::view::View;
use capwalk_scene::{Scene, SurfacePoint, TextureId};
use capwalk_walk::WalkSettings;

use crate::vertex::Vertex;

/// What a path reads from a scene, and how its directions are warped.
pub trait SceneEval<R: Real> {
    /// False if nothing has a derivative: then terms of value zero are not computed.
    const MOVES: bool;
    /// Position of a vertex of the joined mesh.
    fn vertex(&self, index: u32) -> Vec3<R>;
    /// Unit shading normal of a vertex of a shape with vertex normals.
    fn normal(&self, shape: usize, vertex: u32) -> Vec3<R>;
    /// The scene whose numbers they are.
    fn scene(&self) -> &Scene;
    /// A texel of a texture.
    fn texel(&self, id: TextureId, index: usize) -> Rgb<R>;
    /// True if derivatives with respect to the texels of a texture are asked for.
    fn is_asked_for(&self, id: TextureId) -> bool;
    /// What the sensor sees from a point of its lens, given on the unit disk; without, from
    /// its middle.
    fn view(&self, lens: Option<[f64; 2]>) -> View<R>;
    /// A vertex of a path without derivatives.
    fn primal<'v>(&self, vertex: &'v Vertex<R>) -> Cow<'v, Vertex<f64>> {
        Cow::Owned(vertex.value())
    }
    /// A point of the boundaries: the position of a vertex of the joined mesh, an anchor of a
    /// light ([`Accel::anchors`]), or, only if `MOVES`, the end of a crossing.
    fn boundary_point(&self, index: u32) -> Vec3<R>;
    /// How fast a point of an edge moves along `normal` against something else, at least 0,
    /// world units per unit of the parameter: what sampling weights know of the motion. The
    /// point divides the edge between two points of the boundaries at the fraction `t`.
    /// Where no motion is known, as in reverse mode, a guess. Used only if `MOVES`.
    fn speed(&self, ends: [u32; 2], t: f64, against: Vec3, normal: Vec3) -> f64;
    /// The motion of a point of the boundaries as sampling weights use it; used only if
    /// `MOVES`.
    fn motion_of_point(&self, index: u32) -> Motion;
    /// The motion of a shading point, or the change of its normal, as they use it.
    fn motion_of(&self, vector: Vec3<R>) -> Motion;
    /// True if no boundary moves against the viewpoint.
    fn is_still(&self, viewpoint: &Viewpoint<R>) -> bool;
    /// True if curves in the image can move against the rays.
    fn moves(&self) -> bool;
    /// True if neither the camera's rays nor the first surfaces that they hit move: then film points
    /// need not, either.
    fn is_stationary(&self) -> bool;
    /// The unit direction `q` from a point, moving with the velocity field
    /// around the point, an unbiased sample of it and of its divergence.
    fn warp(
        &self,
        viewpoint: &Viewpoint<R>,
        q: Vec3,
        walk: &WalkSettings,
        numbers: Numbers,
    ) -> Warped<R>;
    /// The direction `q`, moved by a linear map that is already known.
    fn moved(&self, viewpoint: &Viewpoint<R>, q: Vec3, warp: Warp) -> Warped<R>;
    /// The warped direction of [`Self::warp`] without the divergence, for flows through curves.
    fn warp_value(
        &self,
        viewpoint: &Viewpoint<R>,
        q: Vec3,
        walk: &WalkSettings,
        numbers: Numbers,
    ) -> Vec3<R>;

    /// The value of a texture at a point of a surface.
    #[inline]
    fn lookup(&self, id: TextureId, at: &SurfacePoint<R>) -> Rgb<R> {
        let scene = self.scene();
        match scene.texture(id).is_constant() {
            true => self.texel(id, 0),
            false => scene.lookup(id, at, |id, index| self.texel(id, index)),
        }
    }
}

/// A sampled direction that moves.
#[derive(Clone, Copy, Debug)]
pub struct Warped<R> {
    /// The direction; its value is the sampled one, of unit length.
    pub direction: Vec3<R>,
    /// One; its derivative is the divergence of the field.
    pub jacobian: R,
    /// True if a boundary is near: derivatives may be noisy there.
    pub near_boundary: bool,
}

impl<R: Real> Warped<R> {
    /// A direction that stays.
    pub fn still(q: Vec3) -> Self {
        Self {
            direction: Vec3::constant(q),
            jacobian: R::constant(1.0),
            near_boundary: false,
        }
    }

    /// A direction that turns with a unit normal, by the smallest rotation; such a field has no
    /// divergence.
    pub fn turning(q: Vec3, normal: Vec3<R>) -> Self {
        let (n, still) = (normal.value(), Vec3::constant(q));
        let turned = normal * R::constant(n.dot(q)) - Vec3::constant(n) * normal.dot(still);
        Self {
            direction: still + turned - Vec3::constant(turned.value()),
            ..Self::still(q)
        }
    }
}

/// The scene as it is.
pub struct Primal<'a>(pub &'a Accel);

impl SceneEval<f64> for Primal<'_> {
    const MOVES: bool = false;
    #[inline]
    fn vertex(&self, index: u32) -> Vec3 {
        self.0.mesh.positions[index as usize]
    }
    #[inline]
    fn normal(&self, shape: usize, vertex: u32) -> Vec3 {
        vertex_normal(&self.0.scene, shape, vertex)
    }
    #[inline]
    fn scene(&self) -> &Scene {
        &self.0.scene
    }
    #[inline]
    fn texel(&self, id: TextureId, index: usize) -> Rgb {
        self.0.scene.texture(id).texel(index)
    }
    #[inline]
    fn is_asked_for(&self, _: TextureId) -> bool {
        false
    }
    #[inline]
    fn view(&self, lens: Option<[f64; 2]>) -> View<f64> {
        let Some(lens) = lens else {
            return self.0.view;
        };
        let scene = &self.0.scene;
        View::new(&scene.sensor, &scene.film, &scene.sensor.state(), lens)
    }
    #[inline]
    fn primal<'v>(&self, vertex: &'v Vertex<f64>) -> Cow<'v, Vertex<f64>> {
        Cow::Borrowed(vertex)
    }
    #[inline]
    fn boundary_point(&self, index: u32) -> Vec3 {
        let vertices = &self.0.mesh.positions;
        let anchors = &self.0.anchors;
        let mut points = vertices.iter().chain(anchors);
        *points
            .nth(index as usize)
            .expect("without derivatives there are no crossings")
    }
    #[inline]
    fn speed(&self, _: [u32; 2], _: f64, _: Vec3, _: Vec3) -> f64 {
        0.0
    }
    #[inline]
    fn motion_of_point(&self, _: u32) -> Motion {
        Motion::STILL
    }
    #[inline]
    fn motion_of(&self, _: Vec3) -> Motion {
        Motion::STILL
    }
    #[inline]
    fn is_still(&self, _: &Viewpoint<f64>) -> bool {
        true
    }
    #[inline]
    fn moves(&self) -> bool {
        false
    }
    #[inline]
    fn is_stationary(&self) -> bool {
        true
    }
    #[inline]
    fn warp(&self, _: &Viewpoint<f64>, q: Vec3, _: &WalkSettings, _: Numbers) -> Warped<f64> {
        Warped::still(q)
    }
    #[inline]
    fn moved(&self, _: &Viewpoint<f64>, q: Vec3, _: Warp) -> Warped<f64> {
        Warped::still(q)
    }
    #[inline]
    fn warp_value(&self, _: &Viewpoint<f64>, q: Vec3, _: &WalkSettings, _: Numbers) -> Vec3 {
        q
    }
}

/// The unit shading normal of a vertex, as it is.
pub fn vertex_normal(scene: &Scene, shape: usize, vertex: u32) -> Vec3 {
    let normals = scene.shapes[shape].normals.per_vertex();
    normals.expect("asked only of shapes with vertex normals")[vertex as usize]
}
