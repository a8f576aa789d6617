//! A scene that moves: values with one derivative, for forward mode.

use capwalk_boundary::{Accel, Field, Motion, Numbers, Viewpoint, Warp};
use capwalk_math::{Dual, Rgb, Vec3};
use capwalk_render::{SceneEval, Warped, vertex_normal};
use capwalk_scene::sensor::view::View;
use capwalk_scene::{Scene, SensorVectors, Tangent, TextureId};
use capwalk_walk::WalkSettings;

use crate::adjoint::Wanted;
use crate::reverse_eval::{likely_motion, likely_motion_of_viewpoint, likely_speed};

/// How much of the largest speed changes no digit of a derivative that is compared.
const HARDLY: f64 = 1e-12;

/// A number and its derivative with respect to the parameter.
pub type D = Dual<1>;

/// The scene moving along a [`Tangent`].
pub struct Forward<'a> {
    accel: &'a Accel,
    field: Field<'a>,
    tangent: &'a Tangent,
    /// What the sensor sees from the middle of its lens.
    view: View<D>,
    /// Velocity of every point of the boundaries, world units: the vertices of the
    /// joined mesh, then the anchors of lights, then the ends of crossings.
    points: Vec<Vec3>,
    /// Velocities of each shape's shading normals, where it has any.
    normals: Vec<Option<Vec<Vec3>>>,
    boundaries_move: bool,
    /// If sampling is to know no velocity: which points of the boundaries may move.
    blind: Option<Vec<bool>>,
}

impl<'a> Forward<'a> {
    /// The velocities of everything; shapes that do not move get zeros.
    pub fn new(field: Field<'a>, tangent: &'a Tangent) -> Self {
        let accel = field.accel;
        let mut points = vec![Vec3::zero(); accel.mesh.positions.len()];
        for (shape, &first) in tangent.shapes.iter().zip(&accel.first_vertex) {
            if let Some(shape) = shape {
                let first = first as usize;
                points[first..first + shape.vertices.len()].copy_from_slice(&shape.vertices);
            }
        }
        points.extend(accel.scene.anchor_velocities(tangent));
        let crossings = field.boundaries.crossings.iter();
        let ends: Vec<Vec3> = crossings
            .flat_map(|crossing| crossing.ends.map(|end| end.velocity(&points)))
            .collect();
        points.extend(ends);
        let normals = (0..accel.scene.shapes.len())
            .map(|shape| accel.scene.normal_velocities(tangent, shape))
            .collect();
        Self {
            accel,
            field,
            tangent,
            view: view(accel, tangent, [0.0; 2]),
            boundaries_move: points.iter().any(|&v| v != Vec3::zero()),
            points,
            normals,
            blind: None,
        }
    }

    /// Samples like reverse mode, which knows no velocity. To it all of a shape may move that
    /// is moved somewhere, and all that depends on it, also where velocities vanish: a point of a
    /// surface that grows within its plane. So what may move gets velocities besides that are too
    /// small to count, and have no direction in common.
    pub fn blind(self) -> Self {
        let wanted = Wanted::by(self.tangent);
        let may_move = wanted.points(self.accel, self.field.boundaries);
        let speeds = self.points.iter().map(|velocity| velocity.length());
        let hardly = HARDLY * speeds.fold(f64::MIN_POSITIVE / HARDLY, f64::max);
        let besides = |i: usize| {
            let part = |k: f64| (i as f64 + 1.0) * k % 1.0 - 0.5;
            Vec3::new(part(0.754_877), part(0.569_840), part(0.430_160)) * hardly
        };
        let points = self.points.into_iter().enumerate();
        let points = points.map(|(i, velocity)| match may_move[i] {
            true => velocity + besides(i),
            false => velocity,
        });
        let scene = &self.accel.scene;
        let normals = self.normals.into_iter().enumerate();
        let normals = normals.map(
            |(shape, velocities)| match wanted.normals_of(scene, shape) {
                true => velocities.map(|all| {
                    let all = all.into_iter().enumerate();
                    all.map(|(i, velocity)| velocity + besides(i)).collect()
                }),
                false => velocities,
            },
        );
        Self {
            points: points.collect(),
            normals: normals.collect(),
            blind: Some(may_move),
            ..self
        }
    }

    /// The velocity of a direction and the divergence of its field, for this motion.
    fn evaluate(&self, warp: &Warp, viewpoint: &Viewpoint<D>) -> (Vec3, f64) {
        let moving = viewpoint.vectors().map(|vector| vector.tangent(0));
        warp.evaluate(&self.field, |i| self.points[i as usize], &moving)
    }
}

/// What the moving sensor sees from a point of its lens.
fn view(accel: &Accel, tangent: &Tangent, lens: [f64; 2]) -> View<D> {
    let Scene { sensor, film, .. } = &*accel.scene;
    View::new(sensor, film, &sensor.moving_state(&tangent.sensor), lens)
}

impl SceneEval<D> for Forward<'_> {
    const MOVES: bool = true;
    #[inline]
    fn vertex(&self, index: u32) -> Vec3<D> {
        let index = index as usize;
        self.accel.mesh.positions[index].with_tangent(self.points[index])
    }
    #[inline]
    fn normal(&self, shape: usize, vertex: u32) -> Vec3<D> {
        let velocity = match &self.normals[shape] {
            Some(velocities) => velocities[vertex as usize],
            None => Vec3::zero(),
        };
        vertex_normal(&self.accel.scene, shape, vertex).with_tangent(velocity)
    }
    #[inline]
    fn scene(&self) -> &Scene {
        &self.accel.scene
    }
    #[inline]
    fn texel(&self, id: TextureId, index: usize) -> Rgb<D> {
        let scene = &self.accel.scene;
        let velocity = self.tangent.texel(scene, id, index);
        scene.texture(id).texel(index).with_tangent(velocity)
    }
    #[inline]
    fn is_asked_for(&self, id: TextureId) -> bool {
        self.tangent.textures[id.0 as usize].is_some()
    }
    #[inline]
    fn view(&self, lens: Option<[f64; 2]>) -> View<D> {
        lens.map_or(self.view, |lens| view(self.accel, self.tangent, lens))
    }
    #[inline]
    fn boundary_point(&self, index: u32) -> Vec3<D> {
        let position = self.field.boundaries.position(index);
        position.with_tangent(self.points[index as usize])
    }
    #[inline]
    fn speed(&self, [a, b]: [u32; 2], t: f64, against: Vec3, normal: Vec3) -> f64 {
        if let Some(wanted) = &self.blind {
            return likely_speed(wanted, [a, b]);
        }
        let [a, b] = [a, b].map(|i| self.points[i as usize]);
        let velocity = a + (b - a) * t - against;
        velocity.dot(normal).abs()
    }
    #[inline]
    fn motion_of_point(&self, index: u32) -> Motion {
        match &self.blind {
            Some(wanted) => likely_motion(wanted[index as usize]),
            None => Motion::known(self.points[index as usize]),
        }
    }
    #[inline]
    fn motion_of(&self, vector: Vec3<D>) -> Motion {
        let velocity = vector.tangent(0);
        match self.blind {
            Some(_) => likely_motion_of_viewpoint(velocity != Vec3::zero()),
            None => Motion::known(velocity),
        }
    }
    #[inline]
    fn is_still(&self, viewpoint: &Viewpoint<D>) -> bool {
        let moves = |v: &Vec3<D>| v.tangent(0) != Vec3::zero();
        !self.boundaries_move && !viewpoint.vectors().iter().any(moves)
    }
    #[inline]
    fn moves(&self) -> bool {
        self.boundaries_move || self.tangent.sensor.moves_rays()
    }
    #[inline]
    fn is_stationary(&self) -> bool {
        !self.boundaries_move && self.tangent.sensor == SensorVectors::default()
    }
    fn warp(
        &self,
        viewpoint: &Viewpoint<D>,
        q: Vec3,
        walk: &WalkSettings,
        numbers: Numbers,
    ) -> Warped<D> {
        if self.is_still(viewpoint) {
            return Warped::still(q);
        }
        self.moved(viewpoint, q, self.field.warp(viewpoint, q, walk, numbers))
    }
    fn moved(&self, viewpoint: &Viewpoint<D>, q: Vec3, warp: Warp) -> Warped<D> {
        let (velocity, divergence) = self.evaluate(&warp, viewpoint);
        Warped {
            direction: q.with_tangent(velocity.reject_from(q)),
            jacobian: Dual::new(1.0, [divergence]),
            near_boundary: !warp.is_zero(),
        }
    }
    fn warp_value(
        &self,
        viewpoint: &Viewpoint<D>,
        q: Vec3,
        walk: &WalkSettings,
        numbers: Numbers,
    ) -> Vec3<D> {
        if self.is_still(viewpoint) {
            return Vec3::constant(q);
        }
        let warp = self.field.warp_value(viewpoint, q, walk, numbers);
        q.with_tangent(self.evaluate(&warp, viewpoint).0.reject_from(q))
    }
}
