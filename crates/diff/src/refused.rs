//! What a scene refuses as a whole.

use capwalk_boundary::refuse::{refuse_cut_normals, refuse_motion};
use capwalk_boundary::{Method, Refusal};
use capwalk_render::PreparedScene;

/// The reason why derivatives with respect to whatever moves edges are refused for a
/// scene, if they are.
pub fn refusal(prepared: &PreparedScene) -> Option<Refusal> {
    refuse_cut_normals(prepared.scene(), true, |_| false)
        .and_then(|()| refuse_motion(prepared.accel(), &Method::default()))
        .err()
}
