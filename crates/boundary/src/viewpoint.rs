//! Points that look at the boundaries around them: which edges count there.

use capwalk_geometry::EdgeSelection;
use capwalk_math::{Real, Vec3};
use capwalk_scene::sensor::view::View;

/// Edges that are boundaries for all light that is seen.
pub const SEEN: u8 = 1;
/// Edges that are boundaries for emitted light alone: all but those of area emitters
/// with few edges, whose term is added explicitly.
pub const EMITTED: u8 = 2;

/// A point that looks at the boundaries around it.
#[derive(Clone, Copy, Debug)]
pub struct Viewpoint<R> {
    /// The shading point or the camera.
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
    /// Whether hidden edges count.
    pub visibility: Visibility,
    /// Most flat specular events behind which edges count.
    pub events: u32,
}

/// Which boundary points count. If the closest point of an edge is hidden, what
/// hides it has a silhouette between that point and the rest of the edge: leaving
/// out the edge leaves out no visible point that would be the closest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Visibility {
    /// All of them: right, too, and enough where nothing is hidden.
    All,
    /// Those that a point on a surface sees.
    Surface,
    /// Those that the camera sees, between its clip planes.
    Camera,
}

impl<R: Real> Viewpoint<R> {
    /// The camera, whose paths can take so many specular events.
    pub fn camera(view: &View<R>, events: u32) -> Self {
        Self {
            position: view.origin,
            axes: view.is_parallel().then(|| view.axes()),
            face_normal: None,
            // Shading jumps at every crease, seen from either side.
            selection: EdgeSelection::All,
            group: SEEN,
            visibility: Visibility::Camera,
            events,
        }
    }

    /// A surface point that looks for emitted light.
    pub fn towards_emitters(position: Vec3<R>, face_normal: Vec3) -> Self {
        Self {
            position,
            axes: None,
            face_normal: Some(face_normal),
            selection: EdgeSelection::Silhouettes,
            group: EMITTED,
            // Around a direction that reaches light nothing is hidden: what
            // hides an edge would have a silhouette nearer than the edge.
            visibility: Visibility::All,
            events: 0,
        }
    }

    /// A surface point that looks at other surfaces, along paths that can take so
    /// many specular events.
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

    /// The vectors that move what is fixed to the viewpoint, by [`BoundarySample::shares`](crate::BoundarySample::shares).
    pub fn vectors(&self) -> [Vec3<R>; 4] {
        let [a, b, c] = self.axes.unwrap_or([Vec3::zero(); 3]);
        [self.position, a, b, c]
    }
}
