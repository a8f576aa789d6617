//! A scene that stays, read by numbers with derivatives of their own: those of a ray.

use capwalk_boundary::{Accel, Motion, Numbers, Viewpoint, Warp};
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::sensor::SensorState;
use capwalk_scene::sensor::view::View;
use capwalk_scene::{Scene, TextureId};
use capwalk_walk::WalkSettings;

use crate::scene_eval::{SceneEval, Warped, vertex_normal};

/// A scene that stays while rays move through it.
pub struct Still<'a>(pub &'a Accel);

impl<R: Real> SceneEval<R> for Still<'_> {
    const MOVES: bool = true;
    #[inline]
    fn vertex(&self, index: u32) -> Vec3<R> {
        Vec3::constant(self.0.mesh.positions[index as usize])
    }
    #[inline]
    fn normal(&self, shape: usize, vertex: u32) -> Vec3<R> {
        Vec3::constant(vertex_normal(&self.0.scene, shape, vertex))
    }
    #[inline]
    fn scene(&self) -> &Scene {
        &self.0.scene
    }
    #[inline]
    fn texel(&self, id: TextureId, index: usize) -> Rgb<R> {
        Rgb::constant(self.0.scene.texture(id).texel(index))
    }
    #[inline]
    fn is_asked_for(&self, _: TextureId) -> bool {
        false
    }
    fn view(&self, lens: Option<[f64; 2]>) -> View<R> {
        let Scene { sensor, film, .. } = &*self.0.scene;
        let state = sensor.state();
        let state = SensorState {
            axes: state.axes.map(Vec3::constant),
            origin: Vec3::constant(state.origin),
            optics: Vec3::constant(state.optics),
        };
        View::new(sensor, film, &state, lens.unwrap_or_default())
    }
    fn boundary_point(&self, _: u32) -> Vec3<R> {
        unreachable!("nobody asks what stays for its boundaries")
    }
    fn speed(&self, _: [u32; 2], _: f64, _: Vec3, _: Vec3) -> f64 {
        0.0
    }
    fn motion_of_point(&self, _: u32) -> Motion {
        Motion::STILL
    }
    fn motion_of(&self, _: Vec3<R>) -> Motion {
        Motion::STILL
    }
    fn is_still(&self, _: &Viewpoint<R>) -> bool {
        true
    }
    fn moves(&self) -> bool {
        false
    }
    fn is_stationary(&self) -> bool {
        true
    }
    fn warp(&self, _: &Viewpoint<R>, q: Vec3, _: &WalkSettings, _: Numbers) -> Warped<R> {
        Warped::still(q)
    }
    fn moved(&self, _: &Viewpoint<R>, q: Vec3, _: Warp) -> Warped<R> {
        Warped::still(q)
    }
    fn warp_value(&self, _: &Viewpoint<R>, q: Vec3, _: &WalkSettings, _: Numbers) -> Vec3<R> {
        Vec3::constant(q)
    }
}
