//! The scene as independent variables on a tape, for reverse mode.

use std::cell::RefCell;

use capwalk_boundary::{Accel, Field, Motion, Numbers, Viewpoint, Warp};
use capwalk_math::tape::Adjoints;
use capwalk_math::{Real, Rgb, Tape, Var, Vec3};
use capwalk_render::{SceneEval, Warped, vertex_normal};
use capwalk_scene::sensor::SensorState;
use capwalk_scene::sensor::view::View;
use capwalk_scene::{Scene, TextureId};
use capwalk_walk::WalkSettings;

use crate::adjoint::{Target, Wanted};

/// A scene whose numbers are recorded on a tape, for one sample.
pub struct Reverse<'a, 't> {
    accel: &'a Accel,
    field: Field<'a>,
    wanted: &'a Wanted,
    /// Which points of the boundaries depend on what is wanted.
    points: &'a [bool],
    tape: &'t Tape,
    marks: RefCell<Vec<Mark<'t>>>,
}

/// Numbers on the tape that come from outside of it.
struct Mark<'t> {
    /// The first of them.
    place: usize,
    origin: Origin<'t>,
}

/// Where they come from.
enum Origin<'t> {
    /// The scene: three numbers.
    Scene(Target),
    /// A warped direction: three numbers, and its Jacobian behind them if that was asked
    /// for.
    Warp(Box<WarpedFrom<'t>>),
}

/// How a direction moves with what is around a viewpoint.
struct WarpedFrom<'t> {
    q: Vec3,
    viewpoint: Viewpoint<Var<'t>>,
    warp: Warp,
    has_jacobian: bool,
}

/// Room for the marks of most samples.
const MARKS: usize = 64;

impl<'a, 't> Reverse<'a, 't> {
    /// A recording on an empty tape.
    pub fn new(field: Field<'a>, wanted: &'a Wanted, points: &'a [bool], tape: &'t Tape) -> Self {
        debug_assert!(tape.is_empty());
        Self {
            accel: field.accel,
            field,
            wanted,
            points,
            tape,
            marks: RefCell::new(Vec::with_capacity(MARKS)),
        }
    }

    fn variables(&self, wanted: bool, value: Vec3, origin: Origin<'t>) -> Vec3<Var<'t>> {
        if !wanted {
            return Vec3::constant(value);
        }
        let place = self.tape.len();
        self.marks.borrow_mut().push(Mark { place, origin });
        self.tape.variables(value)
    }

    /// A direction that a warp moves, and its Jacobian if it `has_jacobian`, else 1. What nothing
    /// wanted changes is constant.
    fn warped(
        &self,
        viewpoint: &Viewpoint<Var<'t>>,
        q: Vec3,
        warp: Warp,
        has_jacobian: bool,
    ) -> (Vec3<Var<'t>>, Var<'t>) {
        let viewpoint_moves = !viewpoint.vectors().iter().all(|v| v.is_constant());
        let point = |i: u32| self.points[i as usize];
        let depends = warp.depends(&self.field, point, viewpoint_moves);
        let (still, one) = (Vec3::constant(q), Var::constant(1.0));
        let is_recorded = depends.direction || (has_jacobian && depends.divergence);
        if !is_recorded {
            return (still, one);
        }
        let from = WarpedFrom {
            q,
            viewpoint: *viewpoint,
            warp,
            has_jacobian,
        };
        let recorded = self.variables(true, q, Origin::Warp(Box::new(from)));
        let jacobian = match has_jacobian {
            true => self.tape.variable(1.0),
            false => one,
        };
        let direction = match depends.direction {
            true => recorded,
            false => still,
        };
        (direction, jacobian)
    }

    /// Appends the covectors on the scene's numbers that follow from the
    /// adjoints of results: the tape backwards, and at each mark out of it.
    /// `adjoints` is memory.
    pub fn pull_back(
        self,
        results: &[(Rgb<Var<'t>>, Rgb)],
        adjoints: &mut Adjoints,
        covectors: &mut Vec<(Target, Vec3)>,
    ) {
        adjoints.reset(self.tape);
        for &(result, adjoint) in results {
            adjoints.add_colour(result, adjoint);
        }
        let mut end = self.tape.len();
        for mark in self.marks.into_inner().into_iter().rev() {
            // What was recorded behind the mark passes its adjoints on to the mark.
            self.tape.sweep(adjoints, mark.place..end);
            end = mark.place;
            let [x, y, z] = [0, 1, 2].map(|i| adjoints.at(mark.place + i));
            let covector = Vec3::new(x, y, z);
            match mark.origin {
                Origin::Scene(target) => covectors.push((target, covector)),
                Origin::Warp(from) => {
                    // The transposed warp leads to the scene, and to the viewpoint, which
                    // was recorded before.
                    let WarpedFrom {
                        q,
                        viewpoint,
                        warp,
                        has_jacobian,
                    } = *from;
                    let divergence = match has_jacobian {
                        true => adjoints.at(mark.place + 3),
                        false => 0.0,
                    };
                    let vectors = viewpoint.vectors();
                    warp.pull(
                        &self.field,
                        covector.reject_from(q),
                        divergence,
                        |i, covector| covectors.push((Target::Point(i), covector)),
                        |i, covector| adjoints.add_vector(vectors[i], covector),
                    );
                }
            }
        }
    }
}

impl<'t> SceneEval<Var<'t>> for Reverse<'_, 't> {
    const MOVES: bool = true;
    #[inline]
    fn vertex(&self, index: u32) -> Vec3<Var<'t>> {
        let wanted = self.wanted.vertices(self.accel, index);
        let value = self.accel.mesh.positions[index as usize];
        self.variables(wanted, value, Origin::Scene(Target::Point(index)))
    }
    #[inline]
    fn normal(&self, shape: usize, vertex: u32) -> Vec3<Var<'t>> {
        let wanted = self.wanted.normals_of(&self.accel.scene, shape);
        let value = vertex_normal(&self.accel.scene, shape, vertex);
        self.variables(wanted, value, Origin::Scene(Target::Normal(shape, vertex)))
    }
    #[inline]
    fn scene(&self) -> &Scene {
        &self.accel.scene
    }
    #[inline]
    fn texel(&self, id: TextureId, index: usize) -> Rgb<Var<'t>> {
        let value = self.accel.scene.texture(id).texel(index);
        let wanted = self.is_asked_for(id);
        let value = Vec3::from(value.to_array());
        let texel = self.variables(wanted, value, Origin::Scene(Target::Texel(id, index)));
        Rgb::from(texel.to_array())
    }
    #[inline]
    fn is_asked_for(&self, id: TextureId) -> bool {
        self.wanted.textures[id.0 as usize]
    }
    #[inline]
    fn view(&self, lens: Option<[f64; 2]>) -> View<Var<'t>> {
        let scene = &self.accel.scene;
        let SensorState {
            axes,
            origin,
            optics,
        } = scene.sensor.state();
        let wanted = self.wanted;
        let variables =
            |wanted, value, target| self.variables(wanted, value, Origin::Scene(target));
        let turns = wanted.sensor_axes;
        let optic = |value: Var<'t>, wanted| match wanted {
            true => value,
            false => Var::constant(value.value()),
        };
        let moving = variables(wanted.aperture || wanted.film, optics, Target::SensorOptics);
        let state = SensorState {
            axes: [0, 1, 2].map(|i| variables(turns, axes[i], Target::SensorAxis(i))),
            origin: variables(wanted.sensor_origin, origin, Target::SensorOrigin),
            optics: Vec3::new(
                optic(moving.x, wanted.film),
                optic(moving.y, wanted.aperture),
                optic(moving.z, wanted.film),
            ),
        };
        View::new(&scene.sensor, &scene.film, &state, lens.unwrap_or_default())
    }
    #[inline]
    fn boundary_point(&self, index: u32) -> Vec3<Var<'t>> {
        let value = self.field.boundaries.position(index);
        let wanted = self.points[index as usize];
        self.variables(wanted, value, Origin::Scene(Target::Point(index)))
    }
    #[inline]
    fn speed(&self, ends: [u32; 2], _: f64, _: Vec3, _: Vec3) -> f64 {
        likely_speed(self.points, ends)
    }
    #[inline]
    fn motion_of_point(&self, index: u32) -> Motion {
        likely_motion(self.points[index as usize])
    }
    #[inline]
    fn motion_of(&self, vector: Vec3<Var<'t>>) -> Motion {
        likely_motion_of_viewpoint(!vector.is_constant())
    }
    #[inline]
    fn is_still(&self, viewpoint: &Viewpoint<Var<'t>>) -> bool {
        // Behind glass, viewpoints move also with its refractive index.
        !self.wanted.geometry() && viewpoint.vectors().iter().all(|v| v.is_constant())
    }
    #[inline]
    fn moves(&self) -> bool {
        self.wanted.geometry()
    }
    #[inline]
    fn is_stationary(&self) -> bool {
        !self.wanted.geometry() && !self.wanted.film
    }
    fn warp(
        &self,
        viewpoint: &Viewpoint<Var<'t>>,
        q: Vec3,
        walk: &WalkSettings,
        numbers: Numbers,
    ) -> Warped<Var<'t>> {
        if self.is_still(viewpoint) {
            return Warped::still(q);
        }
        self.moved(viewpoint, q, self.field.warp(viewpoint, q, walk, numbers))
    }
    fn moved(&self, viewpoint: &Viewpoint<Var<'t>>, q: Vec3, warp: Warp) -> Warped<Var<'t>> {
        let near_boundary = !warp.is_zero();
        let (direction, jacobian) = self.warped(viewpoint, q, warp, true);
        Warped {
            direction,
            jacobian,
            near_boundary,
        }
    }
    fn warp_value(
        &self,
        viewpoint: &Viewpoint<Var<'t>>,
        q: Vec3,
        walk: &WalkSettings,
        numbers: Numbers,
    ) -> Vec3<Var<'t>> {
        if self.is_still(viewpoint) {
            return Vec3::constant(q);
        }
        let warp = self.field.warp_value(viewpoint, q, walk, numbers);
        self.warped(viewpoint, q, warp, false).0
    }
}

/// What [`likely_speed`] takes for an edge before which only the viewpoint can move.
const STILL_EDGE: f64 = 0.1;

/// What sampling takes for the speed of an edge where no velocity is known, relative to
/// others: 1 if the edge, whose ends are points of the boundaries, may move, and less if
/// only the viewpoint can.
pub fn likely_speed(may_move: &[bool], ends: [u32; 2]) -> f64 {
    match ends.iter().any(|&i| may_move[i as usize]) {
        true => 1.0,
        false => STILL_EDGE,
    }
}

/// What sampling takes for the motion of a point of the boundaries where no velocity is known.
pub fn likely_motion(may_move: bool) -> Motion {
    Motion::guessed(if may_move { 1.0 } else { 0.0 })
}

/// What sampling takes for the motion of a viewpoint where no velocity is known.
pub fn likely_motion_of_viewpoint(may_move: bool) -> Motion {
    // Never certainly still: a velocity can vanish of what depends on something that moves, and
    // forward mode, sampling alike, would then take it for what does not.
    match may_move {
        true => Motion::guessed(STILL_EDGE),
        false => Motion::LEAST,
    }
}
