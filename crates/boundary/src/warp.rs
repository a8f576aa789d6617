//! How a sampled direction moves with the scene: the one result of all boundary
//! estimators, and the choice among them.

use capwalk_geometry::EdgeSelection;
use capwalk_math::{Real, Vec3};
use capwalk_walk::{FieldSample, WalkSettings};

use crate::boundary_sample::BoundarySample;
use crate::custom_field::CustomField;
use crate::draw::Numbers;
use crate::field::Field;
use crate::flow::{Flow, FlowSource};
use crate::method::Method;
use crate::viewpoint::{SEEN, Viewpoint};
use crate::walk::{walk, walk_value};

/// The velocity of a unit direction and the divergence of the field that gives it, an
/// unbiased sample of both (METHOD 2): a linear map from the velocities of points of the
/// boundaries and of the viewpoint. Applied to velocities it serves forward derivatives,
/// transposed reverse ones (METHOD 5).
#[derive(Clone, Debug)]
#[allow(
    clippy::large_enum_variant,
    reason = "one per query, on the stack; a box would be an allocation per sample"
)]
pub enum Warp {
    /// The weighted velocities of a few boundary points.
    Boundary(FieldSample<BoundarySample, Vec3>),
    /// The angular velocity of one boundary point, without a divergence.
    Value(Option<BoundarySample>),
    /// Any other linear map.
    Flow(Flow),
}

/// Which parts of a [`Warp`] depend on what may move.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dependence {
    /// The velocity of the direction.
    pub direction: bool,
    /// The divergence; [`Warp::Value`] has none.
    pub divergence: bool,
}

impl Field<'_> {
    /// A sample of the velocity of the direction `q` and of the divergence of the field there.
    /// Uses the numbers of `random` from its first dimension on.
    pub fn warp<R: Real>(
        &self,
        viewpoint: &Viewpoint<R>,
        q: Vec3,
        settings: &WalkSettings,
        random: Numbers,
    ) -> Warp {
        match &self.method {
            Method::Auto | Method::Walk | Method::FittedWalk | Method::Edges(_) => {
                Warp::Boundary(walk(self, viewpoint, q, settings, random))
            }
            Method::Custom(field) => {
                self.custom_warp(*field, &viewpoint.value(), q, settings, random)
            }
        }
    }

    /// The warped direction of [`Self::warp`] without the divergence, for the terms of curves that move against the field.
    pub fn warp_value<R: Real>(
        &self,
        viewpoint: &Viewpoint<R>,
        q: Vec3,
        settings: &WalkSettings,
        random: Numbers,
    ) -> Warp {
        match &self.method {
            Method::Auto | Method::Walk | Method::FittedWalk | Method::Edges(_) => {
                Warp::Value(walk_value(self, viewpoint, q, settings, random))
            }
            Method::Custom(field) => {
                self.custom_warp(*field, &viewpoint.value(), q, settings, random)
            }
        }
    }

    /// The field of someone else; where it has no flow, that on the sphere of directions, bounded by
    /// all silhouettes. Out of line, so that the others are as fast as without it.
    #[cold]
    fn custom_warp(
        &self,
        field: &dyn CustomField,
        viewpoint: &Viewpoint<f64>,
        q: Vec3,
        settings: &WalkSettings,
        random: Numbers,
    ) -> Warp {
        let (accel, boundaries) = (self.accel, self.boundaries);
        if let Some(flow) = field.flow(accel, boundaries, viewpoint, q, settings, random) {
            return Warp::Flow(flow);
        }
        let among_all = Viewpoint {
            selection: EdgeSelection::Silhouettes,
            group: SEEN,
            ..*viewpoint
        };
        Warp::Boundary(walk(self, &among_all, q, settings, random))
    }
}

impl Warp {
    /// True if no boundary is near: the direction does not move, whatever else does.
    pub fn is_zero(&self) -> bool {
        match self {
            Self::Boundary(samples) => samples.is_zero(),
            Self::Value(sample) => sample.is_none(),
            Self::Flow(_) => false,
        }
    }

    /// Which parts of it depend on a point of the boundaries for which `point` holds, or on the
    /// viewpoint if that moves.
    pub fn depends(
        &self,
        field: &Field,
        point: impl Fn(u32) -> bool,
        viewpoint_moves: bool,
    ) -> Dependence {
        let moves = |sample: &BoundarySample| {
            let faces = sample.mirrors.faces().iter();
            let mut corners = faces.flat_map(|&face| field.accel.mesh.faces[face as usize]);
            viewpoint_moves || sample.points.iter().any(|&i| point(i)) || corners.any(&point)
        };
        match self {
            Self::Boundary(samples) => {
                // The anchor, and the ends of walks from a rim, have a share of the divergence
                // alone.
                let moving = samples.terms().filter(|term| moves(&term.site));
                moving.fold(Dependence::default(), |found, term| Dependence {
                    direction: found.direction || term.weight != 0.0,
                    divergence: true,
                })
            }
            Self::Value(sample) => Dependence {
                direction: sample.as_ref().is_some_and(moves),
                divergence: false,
            },
            Self::Flow(flow) => {
                let any = flow.sources().any(|source| match source {
                    FlowSource::Point(i) => point(i),
                    FlowSource::Viewpoint => viewpoint_moves,
                });
                Dependence {
                    direction: any,
                    divergence: any,
                }
            }
        }
    }

    /// The velocity of the direction, radians, not yet projected on its tangent space,
    /// and the divergence, for the velocities of points of the boundaries and of the
    /// viewpoint ([`Viewpoint::vectors`]).
    pub fn evaluate(
        &self,
        field: &Field,
        point: impl Fn(u32) -> Vec3,
        viewpoint: &[Vec3; 4],
    ) -> (Vec3, f64) {
        match self {
            Self::Boundary(samples) => {
                samples.evaluate(|sample| field.velocity(sample, &point, viewpoint))
            }
            Self::Value(None) => (Vec3::zero(), 0.0),
            Self::Value(Some(sample)) => (field.velocity(sample, &point, viewpoint), 0.0),
            Self::Flow(flow) => flow.evaluate(|source| match source {
                FlowSource::Point(i) => point(i),
                FlowSource::Viewpoint => viewpoint[0],
            }),
        }
    }

    /// The transposed map: from the adjoints of the direction's velocity (tangent to it)
    /// and of the divergence to covectors on points of the boundaries and on the vectors
    /// of the viewpoint.
    pub fn pull(
        &self,
        field: &Field,
        direction: Vec3,
        divergence: f64,
        mut on_point: impl FnMut(u32, Vec3),
        mut on_viewpoint: impl FnMut(usize, Vec3),
    ) {
        match self {
            Self::Boundary(samples) => {
                for term in samples.terms() {
                    let covector =
                        direction * term.weight + samples.divergence_covector(term) * divergence;
                    field.pull_velocity(&term.site, covector, &mut on_point, &mut on_viewpoint);
                }
            }
            Self::Value(None) => {}
            Self::Value(Some(sample)) => {
                field.pull_velocity(sample, direction, on_point, on_viewpoint);
            }
            Self::Flow(flow) => flow.pull(direction, divergence, |source, covector| match source {
                FlowSource::Point(i) => on_point(i, covector),
                FlowSource::Viewpoint => on_viewpoint(0, covector),
            }),
        }
    }
}
