//! Viewpoints, the centres of velocity fields, and which edges are boundaries around them.

use capwalk_geometry::EdgeSelection;
use capwalk_math::{Real, Vec3};
use capwalk_scene::sensor::view::View;

/// The group of edges that bound all incident light.
pub const SEEN: u8 = 1;
/// The group of edges that bound emitted light alone: all but those of area emitters with
/// few edges, which have a term of their own (METHOD 3).
pub const EMITTED: u8 = 2;

/// The group of those edges of [`SEEN`] that bound all light also where both of their faces are seen.
pub const CREASED: u8 = 4;
/// The group of those between faces of smooth meshes, whose normals are interpolated. Where both faces are seen,
/// they bound only what is scattered there: the small shadow of a face on its neighbours' shading ends at them.
pub const SMOOTH: u8 = 8;
/// The group of those between faces of smooth meshes that scatter nothing, such as mirrors and glass.
pub const ROUND: u8 = 16;

/// The centre of a velocity field: the camera or a shading point.
#[derive(Clone, Copy, Debug)]
pub struct Viewpoint<R> {
    /// World space.
    pub position: Vec3<R>,
    /// The axes of a camera with parallel rays, around which directions are those of
    /// image space ([`View`]).
    pub axes: Option<[Vec3<R>; 3]>,
    /// Unit normal of the face it lies on, if it lies on one.
    pub face_normal: Option<Vec3>,
    /// Which edges count.
    pub selection: EdgeSelection,
    /// The group of edges that counts.
    pub group: u8,
    /// True if hidden edges count.
    pub visibility: Visibility,
    /// Most flat specular events behind which edges count.
    pub events: u32,
}

/// Which boundary points count.
///
/// The closest point of an edge decides for the whole edge. If that point is hidden, its
/// occluder has a silhouette between it and the visible rest of the edge, and that
/// silhouette is closer: no visible closest point is lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Visibility {
    /// All of them: also unbiased, and sufficient where nothing is hidden.
    All,
    /// Those visible from a point on a surface.
    Surface,
    /// Those visible from the camera, between its clip planes.
    Camera,
}

impl<R: Real> Viewpoint<R> {
    /// The camera. Edges count behind at most `events` flat specular events.
    pub fn camera(view: &View<R>, events: u32) -> Self {
        Self {
            position: view.origin,
            axes: view.is_parallel().then(|| view.axes()),
            face_normal: None,
            // Shading is discontinuous at every crease, also where both faces are visible.
            selection: EdgeSelection::All,
            group: SEEN,
            visibility: Visibility::Camera,
            events,
        }
    }

    /// A shading point, for directions towards emitters.
    pub fn towards_emitters(position: Vec3<R>, face_normal: Vec3) -> Self {
        Self {
            position,
            axes: None,
            face_normal: Some(face_normal),
            selection: EdgeSelection::Silhouettes,
            group: EMITTED,
            // Around a direction that reaches an emitter nothing closest is hidden: an
            // occluder of an edge would have a silhouette closer than the edge.
            visibility: Visibility::All,
            events: 0,
        }
    }

    /// A shading point, for directions towards other surfaces. Edges count behind at most
    /// `events` flat specular events.
    pub fn towards_surfaces(position: Vec3<R>, face_normal: Vec3, events: u32) -> Self {
        Self {
            position,
            axes: None,
            face_normal: Some(face_normal),
            selection: EdgeSelection::All,
            group: SEEN,
            visibility: Visibility::Surface,
            events,
        }
    }

    /// The viewpoint without derivatives.
    pub fn value(&self) -> Viewpoint<f64> {
        Viewpoint {
            position: self.position.value(),
            axes: self.axes.map(|axes| axes.map(Vec3::value)),
            face_normal: self.face_normal,
            selection: self.selection,
            group: self.group,
            visibility: self.visibility,
            events: self.events,
        }
    }

    /// True if it certainly does not move.
    pub fn is_constant(&self) -> bool {
        let vectors = self.vectors();
        vectors.iter().all(|vector| vector.is_constant())
    }

    /// The vectors on which the position of what is fixed to the viewpoint depends, with the
    /// coefficients of [`BoundarySample::shares`](crate::BoundarySample::shares).
    pub fn vectors(&self) -> [Vec3<R>; 4] {
        let [a, b, c] = self.axes.unwrap_or([Vec3::zero(); 3]);
        [self.position, a, b, c]
    }
}
