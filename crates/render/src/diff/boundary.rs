//! Where the integrand jumps: the boundaries around a point, and how the field
//! that they prescribe depends on their motion (METHOD 1 to 3).
//!
//! Nothing here knows velocities. A sample of the field is a few boundary
//! points ([`Sites`]), and each of them maps the velocities of two vertices and
//! of the eye to an angular velocity, a linear map that serves forward and,
//! transposed, reverse derivatives (METHOD 5).

use std::cell::Cell;

use capwalk_geometry::{
    Edge, EdgeSelection, Mesh, Sides, SilhouettePoint, SilhouetteTree, topology,
};
use capwalk_math::{Real, Vec3};
use capwalk_scene::Emitter;
use capwalk_walk::{FieldSample, Sphere, WalkSettings, sample_field, sample_value};

use crate::accel::Accel;
use crate::options::Method;
use crate::sampler::Stream;

use super::crossing::{Crossing, crossings};
pub use super::eye::{Eye, Visibility};
use super::flow::Flow;
use super::lamp_edge::{LampEdge, lamp_edges};
use super::look::Look;
use super::parallel::picture_tree;
use super::texture_line::texture_lines;
use super::unfold::{Mirrors, Seen, Unfolded};
use super::was;
use super::window::Lamp;

/// Edges that are boundaries for all light that is seen.
pub const SEEN: u8 = 1;
/// Edges that are boundaries for emitted light alone: all but those of lamps
/// with few edges, whose flux is taken back explicitly.
pub const EMITTED: u8 = 2;

/// Lamps with at most this many edges have their flux sampled explicitly
/// (METHOD 3); the edges of others join the boundaries.
const FEW_EDGES: usize = 64;

/// The edges of a scene that can be boundaries.
pub struct Boundaries {
    pub(super) edges: Vec<Edge>,
    /// How much light may jump at each edge that is no silhouette.
    contrasts: Vec<f32>,
    pub(super) tree: SilhouetteTree,
    /// The same edges in picture space, if the sensor's rays are parallel: seen from
    /// its origin they lie in the directions of the sensor's view.
    picture: Option<SilhouetteTree>,
    /// Positions of the joined mesh's vertices, then of the ends of crossings.
    positions: Vec<Vec3>,
    /// The curves where faces cross and textures jump, in the order of their ends'
    /// positions.
    pub crossings: Vec<Crossing>,
    /// The edges of lamps with few edges.
    pub lamp_edges: Vec<LampEdge>,
}

impl Boundaries {
    /// The boundaries of a scene. Edges are welded within each shape: shapes
    /// may move against each other.
    pub fn new(accel: &Accel) -> Self {
        let scene = accel.scene;
        let (mut edges, mut contrasts) = (Vec::new(), Vec::new());
        let mut ends_on_lamps = Vec::new();
        let mut first_face = 0;
        for (shape, &first_vertex) in scene.shapes.iter().zip(&accel.first_vertex) {
            let look = Look::new(scene, shape);
            let mut own = topology::edges_with(&shape.mesh, |faces| look.differs(faces));
            let is_lamp = shape.emitter.is_some_and(|id| {
                matches!(scene.emitter(id), Emitter::Area { .. }) && own.len() <= FEW_EDGES
            });
            contrasts.extend(own.iter().map(|edge| match edge.sides {
                Sides::Open => 1.0,
                Sides::Between { faces, flipped } => look.contrast(faces, flipped) as f32,
            }));
            for edge in &mut own {
                shift(edge, first_vertex, first_face);
                edge.groups = if is_lamp { SEEN } else { SEEN | EMITTED };
                if let (Some(_), Sides::Between { faces, flipped }) = (shape.emitter, edge.sides) {
                    // Light ends where a lamp turns its back, folded or not, and
                    // jumps with its texture.
                    let local = faces.map(|face| face - first_face);
                    if flipped || look.textures_differ(local) {
                        edge.sides = Sides::Open;
                    }
                }
                if is_lamp {
                    ends_on_lamps.push(edge.vertices);
                }
            }
            edges.append(&mut own);
            first_face += shape.mesh.faces.len() as u32;
        }
        let mut mesh = accel.mesh.clone();
        let mut crossings = crossings(accel);
        crossings.extend(texture_lines(accel));
        for crossing in &crossings {
            let first = mesh.positions.len() as u32;
            mesh.positions.extend(crossing.ends.map(|end| end.position));
            edges.push(Edge {
                vertices: [first, first + 1],
                sides: Sides::Open,
                // A lamp that something cuts through ends there.
                groups: if crossing.emits { SEEN | EMITTED } else { SEEN },
            });
            contrasts.push(1.0);
        }
        Self {
            tree: SilhouetteTree::build(&mesh, &edges),
            picture: picture_tree(&accel.view, &mesh, &edges),
            edges,
            contrasts,
            positions: mesh.positions,
            crossings,
            lamp_edges: lamp_edges(&ends_on_lamps, &accel.mesh.positions),
        }
    }

    /// The edges.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Positions of the joined mesh's vertices, then of the ends of crossings.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// How many points the boundaries are made of: the vertices of the joined
    /// mesh, then the ends of crossings.
    pub fn point_count(&self) -> usize {
        self.positions.len()
    }

    /// An edge, by its number.
    pub fn edge(&self, edge: u32) -> &Edge {
        &self.edges[edge as usize]
    }

    /// How much light may jump at an edge, from above 0 to 1: 1 where it is a
    /// silhouette, seen from the eye, or where its faces look different.
    pub fn contrast(&self, edge: u32, mesh: &Mesh, eye: Vec3) -> f64 {
        match self.edge(edge).is_silhouette(mesh, eye) {
            true => 1.0,
            false => f64::from(self.contrasts[edge as usize]),
        }
    }

    /// Where the ends of an edge are.
    pub fn ends(&self, edge: u32) -> [Vec3; 2] {
        let vertices = self.edge(edge).vertices;
        vertices.map(|i| self.position(i))
    }

    /// Where a point of the boundaries is.
    pub fn position(&self, point: u32) -> Vec3 {
        self.positions[point as usize]
    }

    /// The edges in a tree.
    pub fn tree(&self) -> &SilhouetteTree {
        &self.tree
    }

    /// Where a point of an edge is.
    pub(super) fn point(&self, vertices: [u32; 2], t: f64) -> Vec3 {
        let [a, b] = vertices.map(|i| self.positions[i as usize]);
        a + (b - a) * t
    }
}

/// Makes an edge of a shape one of the joined mesh.
fn shift(edge: &mut Edge, first_vertex: u32, first_face: u32) {
    edge.vertices = edge.vertices.map(|i| i + first_vertex);
    if let Sides::Between { faces, .. } = &mut edge.sides {
        *faces = faces.map(|i| i + first_face);
    }
}

/// The fields around all points of a scene at rest.
pub struct Field<'a> {
    /// The scene.
    pub accel: &'a Accel<'a>,
    /// The edges.
    pub boundaries: Boundaries,
    /// What the fields are made by.
    pub method: Method,
    /// The lamps before which edges are gathered, if that is the method.
    pub lamps: Vec<Lamp>,
    /// Edges whose ends lie this close (world units) to the plane of the face
    /// that the eye is on lie in its horizon.
    horizon_distance: f64,
}

/// A boundary point seen from an eye.
#[derive(Clone, Copy, Debug)]
pub struct Site {
    /// Two points of the boundaries ([`Boundaries::point_count`]), and the
    /// place between them.
    pub points: [u32; 2],
    /// Position between them: 0 at the first, 1 at the second.
    pub t: f64,
    /// Velocities along this unit vector are kept if `is_horizon`, else
    /// rejected.
    pub(super) direction: Vec3,
    pub(super) is_horizon: bool,
    pub(super) distance: f64,
    /// Where it is in camera space, if the eye's rays are parallel.
    pub(super) place: Option<Vec3>,
    /// The mirrors in which the eye sees the point.
    pub mirrors: Mirrors,
}

impl Site {
    /// How much each of [`Eye::vectors`] moves what is fixed to the eye here.
    pub fn shares(&self) -> [f64; 4] {
        let Vec3 { x, y, z } = self.place.unwrap_or(Vec3::zero());
        [1.0, x, y, z]
    }

    /// `P_x̂ v / |x - o|` of a velocity relative to the eye, in the space of its
    /// directions. A symmetric map: its own transpose.
    #[inline]
    pub fn angular(&self, relative: Vec3) -> Vec3 {
        let along = self.direction * self.direction.dot(relative);
        let kept = if self.is_horizon {
            along
        } else {
            relative - along
        };
        kept / self.distance
    }
}

/// An unbiased sample of a field and its divergence in one direction, for any
/// velocities of the boundary points.
pub type Sites = FieldSample<Site, Vec3>;

impl<'a> Field<'a> {
    /// The fields of a scene.
    pub fn new(accel: &'a Accel<'a>, method: Method) -> Self {
        Self {
            accel,
            method,
            lamps: match method {
                Method::Edges => Lamp::all(accel.scene),
                _ => Vec::new(),
            },
            boundaries: Boundaries::new(accel),
            horizon_distance: accel.horizon_distance(),
        }
    }

    /// The directions around an eye, bounded by edges and their images.
    pub(super) fn sphere<'e, R: Real>(
        &'e self,
        eye: &'e Eye<R>,
    ) -> Unfolded<'e, R, impl Fn(&SilhouettePoint) -> bool> {
        let position = eye.position.value();
        let (tree, apex) = match eye.axes {
            None => (&self.boundaries.tree, position),
            Some(_) => {
                let tree = self.boundaries.picture.as_ref();
                (tree.expect("the sensor's rays are parallel"), Vec3::zero())
            }
        };
        let is_camera = eye.visibility == Visibility::Camera;
        let is_seen = move |site: &SilhouettePoint| {
            let (_, distance) = self.located(eye, apex, site);
            match is_camera {
                true => self.accel.camera_sees(position, site.direction, distance),
                false => self.accel.surface_sees(position, site.direction, distance),
            }
        };
        let (edges, groups) = match self.method {
            // Beside triangles, in directions that meet nothing.
            Method::TriangleWalk | Method::ExplicitWalk => (EdgeSelection::Silhouettes, SEEN),
            _ => (eye.selection, eye.group),
        };
        Unfolded {
            direct: Sphere {
                tree,
                eye: apex,
                edges,
                groups,
                in_front_of: None,
                counts: (eye.visibility != Visibility::All).then_some(is_seen),
                queries: Cell::new(0),
            },
            field: self,
            eye,
        }
    }

    /// A sample of the field and its divergence in the direction `q`.
    pub fn sample<R: Real>(
        &self,
        eye: &Eye<R>,
        q: Vec3,
        walk: &WalkSettings,
        random: Numbers,
    ) -> Sites {
        let sphere = self.sphere(eye);
        let sample = sample_field(&sphere, q, walk, |i| random.number(i));
        random.draw.count_queries(sphere.direct.queries.get());
        sample.map(|site| self.site(eye, site))
    }

    /// A sample of the field and its divergence in the direction `q`, as a map from
    /// velocities; `None` if the method's fields are [`Sites`] there.
    pub fn flow<R: Real>(
        &self,
        eye: &Eye<R>,
        q: Vec3,
        walk: &WalkSettings,
        random: Numbers,
    ) -> Option<Flow> {
        match &self.method {
            Method::Walk | Method::Edges => None,
            Method::TriangleWalk => self.triangle_flow(eye, q, walk, random),
            Method::ExplicitWalk => self.explicit_flow(eye, q, walk, random),
            Method::Was(settings) => {
                Some(was::flow(self.accel, eye, q, settings, &random.branch()))
            }
            Method::PsdrWas(settings) => {
                Some(self.psdr_was_flow(eye, q, settings, &random.branch()))
            }
        }
    }

    /// True if there is a [`Field::flow`].
    pub fn has_flow(&self) -> bool {
        !matches!(self.method, Method::Walk | Method::Edges)
    }

    /// A sample of the field alone; `None` for velocity zero.
    pub fn sample_value<R: Real>(
        &self,
        eye: &Eye<R>,
        q: Vec3,
        walk: &WalkSettings,
        random: Numbers,
    ) -> Option<Site> {
        let sphere = self.sphere(eye);
        let site = sample_value(&sphere, q, walk, |i| random.number(i));
        random.draw.count_queries(sphere.direct.queries.get());
        Some(self.site(eye, &site?))
    }

    pub(super) fn site<R: Real>(&self, eye: &Eye<R>, seen: &Seen) -> Site {
        let found = &seen.point;
        let edge = &self.boundaries.edges[found.edge as usize];
        // Around the face that the eye slides on, its edges are the horizon.
        // Only the motion across the horizon matters; that along it grows
        // without bound as the eye nears the edge.
        let horizon = eye
            .face_normal
            .filter(|normal| {
                let height = normal.dot(found.direction) * found.distance;
                seen.is_direct && height.abs() <= self.horizon_distance
            })
            .filter(|&normal| self.in_horizon(eye.position.value(), edge, normal));
        Site {
            points: edge.vertices,
            t: found.t,
            direction: horizon.unwrap_or(found.direction),
            is_horizon: horizon.is_some(),
            distance: found.distance,
            place: eye.axes.map(|_| {
                let point = self.boundaries.point(edge.vertices, found.t);
                self.accel.view.place(point)
            }),
            mirrors: seen.mirrors,
        }
    }

    /// Where a boundary point is.
    pub fn position(&self, site: &Site) -> Vec3 {
        self.boundaries.point(site.points, site.t)
    }

    fn in_horizon(&self, eye: Vec3, edge: &Edge, normal: Vec3) -> bool {
        edge.vertices.iter().all(|&i| {
            let offset = self.boundaries.positions[i as usize] - eye;
            offset.dot(normal).abs() <= self.horizon_distance
        })
    }
}

/// One sample: its random numbers, and what it cost.
#[derive(Clone, Copy)]
pub struct Draw<'a> {
    /// The numbers.
    pub stream: &'a Stream,
    /// What it costs, and what it could not do.
    pub counts: &'a Counts,
}

/// Counts of one sample.
#[derive(Debug, Default)]
pub struct Counts {
    /// Closest-silhouette queries.
    pub queries: Cell<u64>,
    /// Specular events behind which outlines can move: these bound no field.
    pub uncovered: Cell<u64>,
}

impl Draw<'_> {
    /// Counts queries for silhouettes.
    pub fn count_queries(&self, count: u64) {
        self.counts.queries.set(self.counts.queries.get() + count);
    }
}

/// The random numbers of one walk.
#[derive(Clone, Copy)]
pub struct Numbers<'a> {
    /// Of this sample.
    pub draw: Draw<'a>,
    /// The first of the walk's dimensions.
    pub dimension: u32,
}

impl Numbers<'_> {
    /// Any number of them, for what does not walk.
    fn branch(&self) -> Stream {
        self.draw.stream.branch(self.dimension)
    }

    pub(super) fn number(&self, i: u32) -> f64 {
        self.draw.stream.number(self.dimension + i)
    }
}
