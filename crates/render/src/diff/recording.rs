//! The scene as independent variables on a tape, for reverse mode.

use std::cell::RefCell;

use capwalk_math::tape::Adjoints;
use capwalk_math::{Real, Rgb, Tape, Var, Vec3};
use capwalk_scene::sensor::SensorState;
use capwalk_scene::{Scene, TextureId};
use capwalk_walk::WalkSettings;

use crate::accel::Accel;
use crate::world::{Carried, World, vertex_normal};

use super::adjoint::{Target, Wanted};
use super::boundary::{Eye, Field, Numbers, Site, Sites};
use super::flow::{Flow, Source};

/// A scene whose numbers are recorded on a tape, for one sample.
pub struct Recording<'a, 't> {
    accel: &'a Accel<'a>,
    field: &'a Field<'a>,
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
    /// A carried direction, three numbers, and its stretch.
    Carried(Box<FromBoundary<'t, Sites>>),
    /// The same by a map from velocities.
    Flow(Box<FromBoundary<'t, Flow>>),
    /// A direction that a boundary point carries.
    Value(Box<FromBoundary<'t, Site>>),
}

/// What the boundaries around an eye make of a direction.
struct FromBoundary<'t, T> {
    q: Vec3,
    eye: Eye<Var<'t>>,
    made: T,
}

/// Room for the marks of most samples.
const MARKS: usize = 64;

impl<'a, 't> Recording<'a, 't> {
    /// A recording on an empty tape.
    pub fn new(
        accel: &'a Accel<'a>,
        field: &'a Field<'a>,
        wanted: &'a Wanted,
        points: &'a [bool],
        tape: &'t Tape,
    ) -> Self {
        debug_assert!(tape.is_empty());
        Self {
            accel,
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

    /// A direction that the boundaries around an eye move.
    fn made<T>(
        &self,
        q: Vec3,
        eye: &Eye<Var<'t>>,
        made: T,
        origin: impl FnOnce(Box<FromBoundary<'t, T>>) -> Origin<'t>,
    ) -> Vec3<Var<'t>> {
        let from = Box::new(FromBoundary { q, eye: *eye, made });
        self.variables(true, q, origin(from))
    }

    /// True if the boundary point can move against the eye.
    fn moves(&self, eye: &Eye<Var<'t>>, site: &Site) -> bool {
        let moves = |i: &u32| self.points[*i as usize];
        let faces = site.mirrors.faces().iter();
        !eye.vectors().iter().all(|vector| vector.is_constant())
            || site.points.iter().any(moves)
            || faces
                .flat_map(|&face| &self.accel.mesh.faces[face as usize])
                .any(moves)
    }

    /// Collects the covectors on the scene's numbers that follow from the
    /// adjoint of a result: the tape backwards, and at each mark out of it.
    /// `adjoints` is memory.
    pub fn pull_back(
        self,
        result: Rgb<Var<'t>>,
        adjoint: Rgb,
        adjoints: &mut Adjoints,
        covectors: &mut Vec<(Target, Vec3)>,
    ) {
        covectors.clear();
        adjoints.reset(self.tape);
        adjoints.add_vector(result, adjoint);
        let mut end = self.tape.len();
        for mark in self.marks.into_inner().into_iter().rev() {
            self.tape.sweep(adjoints, mark.place..end);
            end = mark.place;
            let [x, y, z] = [0, 1, 2].map(|i| adjoints.at(mark.place + i));
            let covector = Vec3::new(x, y, z);
            match mark.origin {
                Origin::Scene(target) => covectors.push((target, covector)),
                Origin::Carried(from) => {
                    let FromBoundary {
                        q,
                        eye,
                        made: sites,
                    } = *from;
                    let stretch = adjoints.at(mark.place + 3);
                    let tangent = covector.reject_from(q);
                    for term in sites.terms() {
                        let on_velocity =
                            tangent * term.weight + sites.divergence_covector(term) * stretch;
                        pull_site(
                            self.field,
                            &term.site,
                            on_velocity,
                            &eye,
                            adjoints,
                            covectors,
                        );
                    }
                }
                Origin::Flow(from) => {
                    let stretch = adjoints.at(mark.place + 3);
                    let tangent = covector.reject_from(from.q);
                    from.made
                        .pull(tangent, stretch, |source, covector| match source {
                            Source::Point(i) => covectors.push((Target::Point(i), covector)),
                            Source::Eye => adjoints.add_vector(from.eye.position, covector),
                        });
                }
                Origin::Value(from) => {
                    let FromBoundary { q, eye, made: site } = *from;
                    let covector = covector.reject_from(q);
                    pull_site(self.field, &site, covector, &eye, adjoints, covectors);
                }
            }
        }
    }
}

/// Passes a covector on the angular velocity of a boundary point on to the
/// point's ends, to the mirrors in which it is seen, and to the eye.
fn pull_site(
    field: &Field,
    site: &Site,
    covector: Vec3,
    eye: &Eye<Var>,
    adjoints: &mut Adjoints,
    covectors: &mut Vec<(Target, Vec3)>,
) {
    let mut on_point = field.pull_seen_velocity(site, covector);
    for (vector, share) in eye.vectors().into_iter().zip(site.shares()) {
        adjoints.add_vector(vector, on_point * -share);
    }
    if !site.mirrors.is_empty() {
        let corner = |i, covector| covectors.push((Target::Point(i), covector));
        let (mesh, point) = (&field.accel.mesh, field.position(site));
        on_point = site.mirrors.pull(mesh, point, on_point, corner);
    }
    let [a, b] = site.points.map(Target::Point);
    covectors.push((a, on_point * (1.0 - site.t)));
    covectors.push((b, on_point * site.t));
}

impl<'t> World<Var<'t>> for Recording<'_, 't> {
    const MOVES: bool = true;
    #[inline]
    fn vertex(&self, index: u32) -> Vec3<Var<'t>> {
        let wanted = self.wanted.vertices(self.accel, index);
        let value = self.accel.mesh.positions[index as usize];
        self.variables(wanted, value, Origin::Scene(Target::Point(index)))
    }
    #[inline]
    fn normal(&self, shape: usize, vertex: u32) -> Vec3<Var<'t>> {
        let wanted = self.wanted.normals_of(self.accel.scene, shape);
        let value = vertex_normal(self.accel.scene, shape, vertex);
        self.variables(wanted, value, Origin::Scene(Target::Normal(shape, vertex)))
    }
    #[inline]
    fn scene(&self) -> &Scene {
        self.accel.scene
    }
    #[inline]
    fn texel(&self, id: TextureId, index: usize) -> Rgb<Var<'t>> {
        let value = self.accel.scene.texture(id).texel(index);
        let wanted = self.is_asked_for(id);
        self.variables(wanted, value, Origin::Scene(Target::Texel(id, index)))
    }
    #[inline]
    fn is_asked_for(&self, id: TextureId) -> bool {
        self.wanted.textures[id.0 as usize]
    }
    #[inline]
    fn sensor(&self) -> SensorState<Var<'t>> {
        let SensorState {
            axes,
            origin,
            optics,
        } = self.accel.scene.sensor.state();
        let wanted = self.wanted;
        let variables =
            |wanted, value, target| self.variables(wanted, value, Origin::Scene(target));
        let turns = wanted.sensor_axes;
        let optic = |value: Var<'t>, wanted| match wanted {
            true => value,
            false => Var::constant(value.value()),
        };
        let moving = variables(wanted.aperture || wanted.film, optics, Target::SensorOptics);
        SensorState {
            axes: [0, 1, 2].map(|i| variables(turns, axes[i], Target::SensorAxis(i))),
            origin: variables(wanted.sensor_origin, origin, Target::SensorOrigin),
            optics: Vec3::new(
                optic(moving.x, wanted.film),
                optic(moving.y, wanted.aperture),
                optic(moving.z, wanted.film),
            ),
        }
    }
    #[inline]
    fn boundary_point(&self, index: u32) -> Vec3<Var<'t>> {
        let value = self.field.boundaries.position(index);
        let wanted = self.points[index as usize];
        self.variables(wanted, value, Origin::Scene(Target::Point(index)))
    }
    #[inline]
    fn is_still(&self, _: &Eye<Var<'t>>) -> bool {
        !self.wanted.geometry()
    }
    #[inline]
    fn moves(&self) -> bool {
        self.wanted.geometry()
    }
    fn carry(
        &self,
        eye: &Eye<Var<'t>>,
        q: Vec3,
        walk: &WalkSettings,
        numbers: Numbers,
    ) -> Carried<Var<'t>> {
        if self.is_still(eye) {
            return Carried::at_rest(q);
        }
        if let Some(flow) = self.field.flow(eye, q, walk, numbers) {
            let moves = |source| match source {
                Source::Point(i) => self.points[i as usize],
                Source::Eye => !eye.position.is_constant(),
            };
            if !flow.sources().any(moves) {
                return Carried {
                    near_boundary: true,
                    ..Carried::at_rest(q)
                };
            }
            return Carried {
                direction: self.made(q, eye, flow, Origin::Flow),
                stretch: self.tape.variable(1.0),
                near_boundary: true,
            };
        }
        let sites = self.field.sample(eye, q, walk, numbers);
        if !sites.terms().any(|term| self.moves(eye, &term.site)) {
            return Carried {
                near_boundary: !sites.is_zero(),
                ..Carried::at_rest(q)
            };
        }
        Carried {
            direction: self.made(q, eye, sites, Origin::Carried),
            stretch: self.tape.variable(1.0),
            near_boundary: true,
        }
    }
    fn carry_value(
        &self,
        eye: &Eye<Var<'t>>,
        q: Vec3,
        walk: &WalkSettings,
        numbers: Numbers,
    ) -> Vec3<Var<'t>> {
        if self.is_still(eye) {
            return Vec3::constant(q);
        }
        if self.field.has_flow() {
            return self.carry(eye, q, walk, numbers).direction;
        }
        match self.field.sample_value(eye, q, walk, numbers) {
            Some(site) if self.moves(eye, &site) => self.made(q, eye, site, Origin::Value),
            _ => Vec3::constant(q),
        }
    }
}
