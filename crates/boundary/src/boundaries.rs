//! The edges of a scene at which the integrand can be discontinuous (METHOD 1).

use std::ops::ControlFlow;
use std::sync::{Arc, OnceLock};

use capwalk_geometry::{
    ConeQuery, Edge, EdgeSelection, EdgeSubset, Halt, Halted, Mesh, Sides, SilhouetteTree,
    topology, uncounted,
};
use capwalk_math::Vec3;
use capwalk_scene::{Pattern, Scene, Shape, Texture};

use crate::accel::{Accel, MeshChange, WORN_OUT};
use crate::coincident::{self, ALONE};
use crate::crossing::{Crossing, crossings};
use crate::edge_sampler::EdgeSampler;
use crate::emitter_edge::{EmitterEdge, emitter_edges};
use crate::image_space::image_tree;
use crate::material::is_purely_specular;
use crate::shading::ShadingDiscontinuities;
use crate::shadow_line::{ShadowLine, shadow_lines};
use crate::texture_line::texture_lines;
use crate::viewpoint::{CREASED, EMITTED, ROUND, SEEN, SMOOTH};
use crate::window::AreaEmitter;

/// The edges of emitters with at most this many have a term of their own (METHOD 3); those
/// of others are boundaries.
const FEW_EDGES: usize = 64;

/// The edges of a scene that can be boundaries.
#[derive(Debug)]
pub struct Boundaries {
    edges: Vec<Edge>,
    /// A guess of how large the discontinuity is at each edge that is no silhouette.
    contrasts: Vec<f32>,
    /// Which edges may lie on others: the row of each edge, see [`coincident::rows`].
    rows: Vec<u32>,
    tree: SilhouetteTree,
    /// The same edges in image space, if the sensor's rays are parallel: seen from
    /// its origin they lie in the directions of the sensor's view.
    image_tree: Option<SilhouetteTree>,
    /// Samplers of silhouettes, and of all edges; built by the first derivatives that sample them.
    edge_samplers: [OnceLock<EdgeSampler>; 2],
    /// See [`Self::emitting_crossings`]; found by the first who asks.
    emitting_crossings: OnceLock<Option<EdgeSubset>>,
    /// Positions of the joined mesh's vertices, then the anchors of lights, then positions of
    /// the ends of crossings.
    positions: Vec<Vec3>,
    /// The segments where faces cross, where textures are discontinuous and where hard shadows
    /// end, in the order of the positions of their ends.
    pub crossings: Vec<Crossing>,
    /// The faces that the last of them are on, those that are edges of hard shadows.
    pub shadowed_faces: Vec<u32>,
    /// True if there are too many edges of hard shadows, and none of them is listed.
    pub has_too_many_shadow_lines: bool,
    /// The edges of area emitters with few edges.
    pub emitter_edges: Vec<EmitterEdge>,
    /// The area emitters, in front of which edges can be gathered.
    pub area_emitters: Vec<AreaEmitter>,
}

impl Boundaries {
    /// The boundaries of a scene. Edges are welded within each shape: shapes
    /// may move against each other.
    pub fn new(accel: &Accel) -> Self {
        Self::try_new(accel, &Halt::never()).expect("nobody gives it up")
    }

    /// [`Self::new`], unless the work is given up.
    pub fn try_new(accel: &Accel, halt: &Halt) -> Result<Self, Halted> {
        let listed = Listed::new(accel, halt)?;
        let made = Self {
            tree: SilhouetteTree::try_build(&listed.mesh, &listed.edges, halt)?,
            image_tree: image_tree(
                &accel.view,
                &listed.mesh.positions,
                &listed.mesh.faces,
                &listed.edges,
            ),
            area_emitters: AreaEmitter::all(&accel.scene),
            emitter_edges: emitter_edges(&listed.on_emitters, &accel.mesh.positions),
            rows: coincident::rows(&listed.edges, &listed.mesh.positions, halt),
            edges: listed.edges,
            contrasts: listed.contrasts,
            positions: listed.mesh.positions,
            crossings: listed.crossings,
            shadowed_faces: listed.shadowed_faces,
            has_too_many_shadow_lines: listed.has_too_many_shadow_lines,
            edge_samplers: Default::default(),
            emitting_crossings: OnceLock::new(),
        };
        halt.unless_halted(made)
    }

    /// No boundaries, but all of their points that are no ends of crossings: what a derivative
    /// by colours and texels sees, which moves nothing.
    pub fn none(accel: &Accel) -> Self {
        let mut mesh = accel.mesh.clone();
        mesh.positions.extend(&accel.anchors);
        Self {
            tree: SilhouetteTree::build(&mesh, &[]),
            image_tree: image_tree(&accel.view, &mesh.positions, &mesh.faces, &[]),
            area_emitters: Vec::new(),
            emitter_edges: Vec::new(),
            rows: Vec::new(),
            edges: Vec::new(),
            contrasts: Vec::new(),
            positions: mesh.positions,
            crossings: Vec::new(),
            shadowed_faces: Vec::new(),
            has_too_many_shadow_lines: false,
            edge_samplers: Default::default(),
            emitting_crossings: OnceLock::new(),
        }
    }

    /// Follows a scene that changed. Unless `same_edges` says that nothing can have
    /// changed the list of edges, they are listed again, since any motion can bend
    /// coplanar neighbours or make faces cross elsewhere; where the list turns out the
    /// same, its tree is refitted. Answers are those of [`Boundaries::new`], to the bit.
    /// `same_sensor` says that the sensor is where it was. If the work is given up, these are the
    /// boundaries of neither scene.
    pub fn update(
        &mut self,
        accel: &Accel,
        change: MeshChange,
        same_edges: bool,
        same_sensor: bool,
        halt: &Halt,
    ) -> Result<(), Halted> {
        let stays = same_edges && change == MeshChange::None;
        if !stays {
            let listed = Listed::new(accel, halt)?;
            let same_list = change != MeshChange::Rebuilt
                && listed.edges == self.edges
                && listed.mesh.positions.len() == self.positions.len();
            if same_list && listed.mesh.positions != self.positions {
                self.tree.refit(&listed.mesh);
            }
            if !same_list || self.tree.degradation() > WORN_OUT {
                self.tree = SilhouetteTree::try_build(&listed.mesh, &listed.edges, halt)?;
            }
            self.emitter_edges = emitter_edges(&listed.on_emitters, &accel.mesh.positions);
            self.rows = coincident::rows(&listed.edges, &listed.mesh.positions, halt);
            self.edges = listed.edges;
            self.contrasts = listed.contrasts;
            self.positions = listed.mesh.positions;
            self.crossings = listed.crossings;
            self.shadowed_faces = listed.shadowed_faces;
            self.has_too_many_shadow_lines = listed.has_too_many_shadow_lines;
            self.edge_samplers = Default::default();
            self.emitting_crossings = OnceLock::new();
        }
        self.area_emitters = AreaEmitter::all(&accel.scene);
        if !(stays && same_sensor) {
            let faces = &accel.mesh.faces;
            self.image_tree = image_tree(&accel.view, &self.positions, faces, &self.edges);
        }
        halt.unless_halted(())
    }

    /// The segments that are edges of hard shadows.
    pub fn shadow_lines(&self) -> &[Crossing] {
        &self.crossings[self.crossings.len() - self.shadowed_faces.len()..]
    }

    /// The edges.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Positions of the joined mesh's vertices, then the anchors of lights
    /// ([`Accel::anchors`]), then positions of the ends of crossings.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// How many points the boundaries are made of: the vertices of the joined
    /// mesh, then the anchors of lights, then the ends of crossings.
    pub fn point_count(&self) -> usize {
        self.positions.len()
    }

    /// An edge, by its number.
    pub fn edge(&self, edge: u32) -> &Edge {
        &self.edges[edge as usize]
    }

    /// The number of the row that an edge is in with all that may lie on a part of it, or it on a
    /// part of them; `u32::MAX` if there are none.
    pub fn row(&self, edge: u32) -> u32 {
        self.rows[edge as usize]
    }

    /// A guess of how large the discontinuity is at an edge, above 0 and at most 1: it is 1
    /// at silhouettes as seen from the viewpoint and at shading discontinuities.
    pub fn contrast(&self, edge: u32, mesh: &Mesh, viewpoint: Vec3) -> f64 {
        match self.edge(edge).is_silhouette(mesh, viewpoint) {
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

    /// The edges in a cone with their ends, by their numbers: the order must not tell how
    /// the tree came about. Only those in a subset, if one is given. `found` is memory. False, and not
    /// all of them, if there are more than `most`.
    pub fn gather(
        &self,
        query: &ConeQuery,
        among: Option<&EdgeSubset>,
        most: usize,
        found: &mut Vec<(u32, [Vec3; 2])>,
    ) -> bool {
        found.clear();
        let visit = |edge, ends| {
            found.push((edge, ends));
            match found.len() > most {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        };
        self.tree.gather(query, among, visit);
        if found.len() > most {
            return false;
        }
        found.sort_unstable_by_key(|&(edge, _)| edge);
        true
    }

    /// The edges for whose numbers `contains` holds.
    pub fn subset(&self, contains: impl Fn(u32) -> bool) -> EdgeSubset {
        self.tree.subset(contains)
    }

    /// A sampler of the silhouettes of meshes, or of all edges; built by the first call.
    pub fn edge_sampler(&self, accel: &Accel, selection: EdgeSelection) -> &EdgeSampler {
        self.edge_samplers[selection as usize].get_or_init(|| {
            let made = self.make_edge_sampler(accel, selection, &Halt::never());
            made.expect("nobody gives it up")
        })
    }

    /// Builds that sampler before it is asked for, unless the work is given up.
    pub fn build_edge_sampler(
        &self,
        accel: &Accel,
        selection: EdgeSelection,
        halt: &Halt,
    ) -> Result<(), Halted> {
        let sampler = &self.edge_samplers[selection as usize];
        if sampler.get().is_none() {
            let made = self.make_edge_sampler(accel, selection, halt)?;
            sampler.get_or_init(|| made);
        }
        Ok(())
    }

    /// The segments at which emitted light ends where a sampler of silhouettes has no edge: where a
    /// surface passes through an emitter, or its texture is discontinuous. `None` if one of them may lie on an edge
    /// of a mesh, so that one must not be sampled without the other.
    pub fn emitting_crossings(&self) -> Option<&EdgeSubset> {
        let find = || {
            let of_meshes = self.edges.len() - self.crossings.len();
            let emits = |edge: usize| edge >= of_meshes && self.crossings[edge - of_meshes].emits;
            let mut rows: Vec<u32> = (of_meshes..self.edges.len())
                .filter(|&edge| emits(edge) && self.rows[edge] != ALONE)
                .map(|edge| self.rows[edge])
                .collect();
            rows.sort_unstable();
            let is_apart = |row: &u32| rows.binary_search(row).is_err();
            let are_apart = self.rows[..of_meshes].iter().all(is_apart);
            are_apart.then(|| self.subset(|edge| emits(edge as usize)))
        };
        let found = self.emitting_crossings.get_or_init(|| uncounted(find));
        found.as_ref()
    }

    fn make_edge_sampler(
        &self,
        accel: &Accel,
        selection: EdgeSelection,
        halt: &Halt,
    ) -> Result<EdgeSampler, Halted> {
        // Where faces cross, or textures and hard shadows end, surfaces cover both sides:
        // these edges, which come last, are no silhouettes.
        let of_meshes = self.edges.len() - self.crossings.len();
        let creases = match selection {
            EdgeSelection::Silhouettes => None,
            EdgeSelection::All => Some(&self.contrasts[..]),
        };
        let (edges, positions) = (&self.edges, &self.positions);
        uncounted(|| EdgeSampler::try_new(edges, of_meshes, positions, creases, accel, halt))
    }

    /// The edges in a tree.
    pub fn tree(&self) -> &SilhouetteTree {
        &self.tree
    }

    /// The edges in image space; only for sensors whose rays are parallel.
    pub(crate) fn image_tree(&self) -> &SilhouetteTree {
        let tree = self.image_tree.as_ref();
        tree.expect("asked only for sensors whose rays are parallel")
    }

    /// Where a point of an edge is.
    pub fn point(&self, vertices: [u32; 2], t: f64) -> Vec3 {
        let [a, b] = vertices.map(|i| self.positions[i as usize]);
        a + (b - a) * t
    }
}

/// True if two scenes of the same shapes have the same boundaries: what emits, what is
/// shown and where textures are discontinuous is the same. Other numbers in materials and
/// bitmaps make no edge.
pub fn same_edges(a: &Scene, b: &Scene) -> bool {
    let same_texture = |(a, b): (&Arc<Texture>, &Arc<Texture>)| {
        let is_discontinuous_by_its_numbers = matches!(a.pattern, Pattern::PerVertex);
        Arc::ptr_eq(a, b) || a.pattern == b.pattern && !is_discontinuous_by_its_numbers
    };
    // What of a shape decides where shading is discontinuous, beside its vertices.
    let same_shape = |(a, b): (&Arc<Shape>, &Arc<Shape>)| {
        Arc::ptr_eq(a, b)
            || (&a.normals, &a.uvs, &a.attributes, a.bsdf, a.emitter)
                == (&b.normals, &b.uvs, &b.attributes, b.bsdf, b.emitter)
    };
    a.shapes.len() == b.shapes.len()
        && a.shapes.iter().zip(&b.shapes).all(same_shape)
        && a.textures.len() == b.textures.len()
        && a.textures.iter().zip(&b.textures).all(same_texture)
        && a.materials == b.materials
        && a.emitters == b.emitters
        && a.settings.integrator == b.settings.integrator
}

/// The edges of a scene, listed.
struct Listed {
    /// The joined mesh, with the anchors of lights and the ends of crossings behind its
    /// vertices.
    mesh: Mesh,
    edges: Vec<Edge>,
    contrasts: Vec<f32>,
    crossings: Vec<Crossing>,
    shadowed_faces: Vec<u32>,
    has_too_many_shadow_lines: bool,
    /// Ends of the edges whose term is added explicitly.
    on_emitters: Vec<[u32; 2]>,
}

impl Listed {
    fn new(accel: &Accel, halt: &Halt) -> Result<Self, Halted> {
        let scene = &accel.scene;
        let (mut edges, mut contrasts) = (Vec::new(), Vec::new());
        let mut on_emitters = Vec::new();
        let mut first_face = 0;
        for (shape, &first_vertex) in scene.shapes.iter().zip(&accel.first_vertex) {
            if halt.now() {
                return Err(Halted);
            }
            let discontinuities = ShadingDiscontinuities::new(scene, shape);
            let between_like_faces = match shape.normals.per_vertex() {
                Some(_) if is_purely_specular(scene, shape.bsdf) => ROUND,
                Some(_) => SMOOTH,
                None => CREASED,
            };
            let mut own = topology::edges_with(&shape.mesh, |faces| discontinuities.differs(faces));
            let is_explicit = shape
                .emitter
                .is_some_and(|id| scene.emitter(id).shape().is_some() && own.len() <= FEW_EDGES);
            contrasts.extend(own.iter().map(|edge| match edge.sides {
                Sides::Open => 1.0,
                Sides::Between { faces, flipped } => {
                    discontinuities.contrast(faces, flipped) as f32
                }
            }));
            for edge in &mut own {
                let own = match edge.sides {
                    Sides::Between { faces, .. } if !discontinuities.differs(faces) => {
                        between_like_faces
                    }
                    _ => CREASED,
                };
                shift(edge, first_vertex, first_face);
                edge.groups = SEEN | own;
                if !is_explicit {
                    edge.groups |= EMITTED;
                }
                if let (Some(_), Sides::Between { faces, flipped }) = (shape.emitter, edge.sides) {
                    // Emitted light ends where an emitter shows its back, folded or not, and is
                    // discontinuous where its texture is.
                    let local = faces.map(|face| face - first_face);
                    if flipped || discontinuities.textures_differ(local) {
                        edge.sides = Sides::Open;
                    }
                }
                if is_explicit {
                    on_emitters.push(edge.vertices);
                }
            }
            edges.append(&mut own);
            first_face += shape.mesh.faces.len() as u32;
        }
        let mut mesh = accel.mesh.clone();
        mesh.positions.extend(&accel.anchors);
        let mut crossings = crossings(accel, halt);
        crossings.extend(texture_lines(accel, halt));
        let shadow_lines = shadow_lines(accel, &edges, halt);
        let has_too_many_shadow_lines = shadow_lines.is_none();
        let mut shadowed_faces = Vec::new();
        for ShadowLine { face, line } in shadow_lines.into_iter().flatten() {
            shadowed_faces.push(face);
            crossings.push(line);
        }
        for crossing in &crossings {
            let first = mesh.positions.len() as u32;
            mesh.positions.extend(crossing.ends.map(|end| end.position));
            edges.push(Edge {
                vertices: [first, first + 1],
                sides: Sides::Open,
                // An emitter ends where another surface passes through it.
                groups: if crossing.emits { SEEN | EMITTED } else { SEEN } | CREASED,
            });
            contrasts.push(1.0);
        }
        halt.unless_halted(Self {
            mesh,
            edges,
            contrasts,
            crossings,
            shadowed_faces,
            has_too_many_shadow_lines,
            on_emitters,
        })
    }
}

/// Makes an edge of a shape one of the joined mesh.
pub(crate) fn shift(edge: &mut Edge, first_vertex: u32, first_face: u32) {
    edge.vertices = edge.vertices.map(|i| i + first_vertex);
    if let Sides::Between { faces, .. } = &mut edge.sides {
        *faces = faces.map(|i| i + first_face);
    }
}

#[cfg(test)]
mod tests {
    use capwalk_math::{Affine, Rgb};
    use capwalk_scene::primitive::rectangle;
    use capwalk_scene::{BsdfId, Emitter, EmitterId, ShapeId, builtin};

    use super::*;

    /// Where a blade cuts through an emitter, emitted light ends: a crossing of its own, unless another thing has an edge
    /// there.
    #[test]
    fn emitting_crossings_lie_on_no_edge() {
        let blade = Affine::translate(Vec3::new(0.2, 0.0, 0.0))
            * Affine::rotate(Vec3::new(0.0, 1.0, 0.0), std::f64::consts::FRAC_PI_2);
        // One of its sides is on the crossing, or below.
        let hanging = |height: f64| {
            Affine::translate(Vec3::new(0.2, 0.0, height))
                * Affine::rotate(Vec3::new(0.0, 1.0, 0.0), 0.8)
                * Affine::translate(Vec3::new(1.0, 0.0, 0.0))
                * Affine::scale(Vec3::new(1.0, 0.5, 1.0))
        };
        for (height, are_apart) in [(-0.5, true), (0.0, false)] {
            let mut scene: Scene = builtin::scene("leaf").expect("built in");
            scene.shapes.clear();
            scene.emitters.clear();
            for (mesh, normals) in [
                rectangle(Affine::IDENTITY),
                rectangle(blade),
                rectangle(hanging(height)),
            ] {
                scene.add_shape(Shape::new("", mesh, normals, BsdfId(0)));
            }
            let radiance = scene.add_texture(Texture::colour("radiance", Rgb::splat(1.0)));
            let shape = ShapeId(0);
            scene.emitters.push(Emitter::Area { shape, radiance });
            scene.shape_mut(shape).emitter = Some(EmitterId(0));
            let boundaries = Boundaries::new(&Accel::new(scene));
            assert!(boundaries.crossings.iter().any(|crossing| crossing.emits));
            assert_eq!(
                boundaries.emitting_crossings().is_some(),
                are_apart,
                "{height}"
            );
        }
    }
}
