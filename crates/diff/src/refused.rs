//! What a scene refuses as a whole.

use capwalk_boundary::refuse::{is_specular_somewhere, refuse_cut_normals, refuse_motion};
use capwalk_boundary::{Method, Refusal};
use capwalk_render::PreparedScene;
use capwalk_scene::Scene;

use crate::options::GradientOptions;

/// True if a derivative is refused where silhouettes move that are seen by specular events and
/// not covered.
pub(crate) fn refuses_uncovered(scene: &Scene, options: &GradientOptions) -> bool {
    !options.allow_missing.specular
        && options.method.traits().is_unbiased
        && is_specular_somewhere(scene)
}

/// The reason why derivatives with respect to whatever moves edges are refused for a
/// scene, if they are.
pub fn refusal(prepared: &PreparedScene) -> Option<Refusal> {
    refuse_cut_normals(prepared.scene(), true, |_| false)
        .and_then(|()| refuse_motion(prepared.accel(), &Method::default()))
        .err()
}
