//! Where the integrand jumps, and how fast these curves move (METHOD 1 to 3).

use std::cell::Cell;

use capwalk_geometry::{Edge, EdgeSelection, Sides, SilhouettePoint, SilhouetteTree, topology};
use capwalk_math::Vec3;
use capwalk_scene::{Emitter, Shape};
use capwalk_walk::{Sphere, WalkSettings, sample_field, sample_value};

use crate::accel::Accel;
use crate::sampler::Stream;
use crate::world::{D, InMotion};

use super::crossing::crossings;

/// Edges that are boundaries for segments that start at the camera.
pub const CAMERA: u8 = 1;
/// Edges that are boundaries for segments from a surface towards light: all
/// but those of lamps with few edges, whose flux is taken back explicitly.
pub const LIGHT: u8 = 2;

/// Lamps with at most this many edges have their flux sampled explicitly
/// (METHOD 3); the edges of others join the boundaries.
const FEW_EDGES: usize = 64;

/// Unit normals that differ by less than this are the same: rounding to single
/// precision moves them by about 1e-7.
const SAME_NORMAL: f64 = 1e-6;

/// The edges of a scene that can be boundaries, and how they move.
pub struct Boundaries {
    edges: Vec<Edge>,
    tree: SilhouetteTree,
    /// Positions of the joined mesh's vertices, then of the ends of crossings.
    pub positions: Vec<Vec3>,
    /// Their velocities.
    pub velocities: Vec<Vec3>,
    /// True if any of them is not zero.
    pub any_moves: bool,
    /// End points (vertices of the joined mesh) of the edges of lamps with few
    /// edges, and the total length up to and including each.
    pub lamp_edges: Vec<([u32; 2], f64)>,
}

impl Boundaries {
    /// The boundaries of a scene. Edges are welded within each shape: shapes
    /// may move against each other.
    pub fn new(accel: &Accel, world: &InMotion) -> Self {
        let scene = accel.scene;
        let mut edges = Vec::new();
        let mut lamp_edges = Vec::new();
        let mut length = 0.0;
        let mut first_face = 0;
        for (shape, &first_vertex) in scene.shapes.iter().zip(&accel.first_vertex) {
            let mut own = topology::edges_with(&shape.mesh, |faces| shades_apart(shape, faces));
            let is_lamp = shape.emitter.is_some_and(|id| {
                matches!(scene.emitter(id), Emitter::Area { .. }) && own.len() <= FEW_EDGES
            });
            for edge in &mut own {
                shift(edge, first_vertex, first_face);
                edge.groups = if is_lamp { CAMERA } else { CAMERA | LIGHT };
                if shape.emitter.is_some()
                    && matches!(edge.sides, Sides::Between { flipped: true, .. })
                {
                    // Light ends where a lamp turns its back, folded or not.
                    edge.sides = Sides::Open;
                }
                if is_lamp {
                    let [a, b] = edge.vertices.map(|i| accel.mesh.positions[i as usize]);
                    length += (b - a).length();
                    lamp_edges.push((edge.vertices, length));
                }
            }
            edges.append(&mut own);
            first_face += shape.mesh.faces.len() as u32;
        }
        let mut velocities = world.vertices.clone();
        let mut mesh = accel.mesh.clone();
        for crossing in crossings(accel, &velocities) {
            let first = mesh.positions.len() as u32;
            mesh.positions.extend(crossing.ends);
            velocities.extend(crossing.velocities);
            edges.push(Edge {
                vertices: [first, first + 1],
                sides: Sides::Open,
                // A lamp that something cuts through ends there.
                groups: if crossing.emits {
                    CAMERA | LIGHT
                } else {
                    CAMERA
                },
            });
        }
        Self {
            tree: SilhouetteTree::build(&mesh, &edges),
            edges,
            positions: mesh.positions,
            any_moves: velocities.iter().any(|&v| v != Vec3::zero()),
            velocities,
            lamp_edges,
        }
    }
}

/// True if two neighbouring faces have different shading normals at an end of
/// their common edge.
fn shades_apart(shape: &Shape, faces: [u32; 2]) -> bool {
    let Some(normals) = shape.normals.per_vertex() else {
        return false;
    };
    let [first, second] = faces.map(|face| shape.mesh.faces[face as usize]);
    let position = |i: u32| shape.mesh.positions[i as usize];
    first.iter().any(|&i| {
        let twins = second.iter().filter(|&&k| position(k) == position(i));
        twins
            .map(|&k| (normals[i as usize] - normals[k as usize]).length())
            .any(|difference| difference > SAME_NORMAL)
    })
}

/// Makes an edge of a shape one of the joined mesh.
fn shift(edge: &mut Edge, first_vertex: u32, first_face: u32) {
    edge.vertices = edge.vertices.map(|i| i + first_vertex);
    if let Sides::Between { faces, .. } = &mut edge.sides {
        *faces = faces.map(|i| i + first_face);
    }
}

/// A point that looks at the boundaries around it, and how it moves.
#[derive(Clone, Copy)]
pub struct Eye {
    /// The shading point or the camera, with its velocity.
    pub position: Vec3<D>,
    /// Unit normal of the face it lies on, if it lies on one.
    pub face_normal: Option<Vec3>,
    /// Which edges count.
    pub selection: EdgeSelection,
    /// The group of edges that counts.
    pub group: u8,
    /// If the eye is the camera, only what it can see of them counts. If the
    /// closest point of an edge is hidden, what hides it has an outline between
    /// that point and the rest of the edge: leaving out the edge leaves out no
    /// visible point that would be the closest.
    pub is_camera: bool,
}

/// The velocity field around an eye at one direction.
#[derive(Clone, Copy, Debug)]
pub struct FieldAt {
    /// Angular velocity of the direction, tangent to it.
    pub velocity: Vec3,
    /// Its divergence on the sphere.
    pub divergence: f64,
}

/// The sink of the walk in forward mode: it sums up the velocities.
pub struct Field<'a> {
    /// What hides them.
    pub accel: &'a Accel<'a>,
    /// The edges.
    pub boundaries: Boundaries,
    /// Edges whose ends lie this close (world units) to the plane of the face
    /// that the eye is on lie in its horizon.
    pub horizon_distance: f64,
}

impl Field<'_> {
    /// True if no boundary moves relative to the eye.
    fn at_rest(&self, eye: &Eye) -> bool {
        !self.boundaries.any_moves && eye.position.tangent(0) == Vec3::zero()
    }

    fn sphere(&self, eye: &Eye) -> Sphere<'_, impl Fn(&SilhouettePoint) -> bool> {
        let is_camera = eye.is_camera;
        Sphere {
            tree: &self.boundaries.tree,
            eye: eye.position.value(),
            edges: eye.selection,
            groups: eye.group,
            in_front_of: None,
            counts: move |site: &SilhouettePoint| {
                !is_camera || self.accel.camera_sees(site.direction, site.distance)
            },
            queries: Cell::new(0),
        }
    }

    /// A sample of the field and its divergence in the direction `q`.
    pub fn sample(&self, eye: &Eye, q: Vec3, walk: &WalkSettings, random: Numbers) -> FieldAt {
        if self.at_rest(eye) {
            return FieldAt {
                velocity: Vec3::zero(),
                divergence: 0.0,
            };
        }
        let sphere = self.sphere(eye);
        let sample = sample_field(&sphere, q, walk, |i| random.number(i));
        random
            .draw
            .queries
            .set(random.draw.queries.get() + sphere.queries.get());
        let (mean, divergence) = sample.evaluate(|site| self.site_velocity(eye, site));
        FieldAt {
            velocity: mean.reject_from(q),
            divergence,
        }
    }

    /// A sample of the field alone.
    pub fn sample_value(&self, eye: &Eye, q: Vec3, walk: &WalkSettings, random: Numbers) -> Vec3 {
        if self.at_rest(eye) {
            return Vec3::zero();
        }
        let sphere = self.sphere(eye);
        let site = sample_value(&sphere, q, walk, |i| random.number(i));
        random
            .draw
            .queries
            .set(random.draw.queries.get() + sphere.queries.get());
        match site {
            None => Vec3::zero(),
            Some(site) => self.site_velocity(eye, &site).reject_from(q),
        }
    }

    /// Angular velocity of a boundary point seen from the eye,
    /// `P_x̂ (ẋ - ȯ) / |x - o|`.
    fn site_velocity(&self, eye: &Eye, site: &SilhouettePoint) -> Vec3 {
        let edge = &self.boundaries.edges[site.edge as usize];
        let velocities = &self.boundaries.velocities;
        let [va, vb] = edge.vertices.map(|i| velocities[i as usize]);
        let relative = va + (vb - va) * site.t - eye.position.tangent(0);
        if let Some(normal) = eye.face_normal
            && self.in_horizon(eye, edge, normal)
        {
            // Around the face that the eye slides on, its edges are the
            // horizon. Only the motion across the horizon matters; that along
            // it grows without bound as the eye nears the edge.
            return normal * (normal.dot(relative) / site.distance);
        }
        relative.reject_from(site.direction) / site.distance
    }

    fn in_horizon(&self, eye: &Eye, edge: &Edge, normal: Vec3) -> bool {
        let eye = eye.position.value();
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
    /// Counts closest-silhouette queries.
    pub queries: &'a Cell<u64>,
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
    fn number(&self, i: u32) -> f64 {
        self.draw.stream.number(self.dimension + i)
    }
}
