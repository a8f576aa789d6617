//! The edges of hard shadows: where silhouettes, as a light without extent sees them, end its
//! light on the faces behind (METHOD 7).
//!
//! The light past an edge fills a wedge, and on a flat face the shadow of the edge is a
//! segment: where the face crosses the wedge. So these segments are boundaries like those in
//! which two faces cross, for any viewpoint, and they move like them: their points stay in the
//! plane of the face and in that through the light and the edge.

use std::sync::atomic::{AtomicUsize, Ordering};

use capwalk_geometry::{Apex, Edge, Halt, Sides, Wedge, WedgePoint, is_edge_on};
use capwalk_math::Vec3;
use capwalk_scene::EmitterId;
use rayon::prelude::*;

use crate::accel::Accel;
use crate::crossing::{Crossing, CrossingPlane, crossing_of_planes};

/// The most segments that the shadows of a scene may have: two gigabytes.
pub const MOST_SHADOW_LINES: usize = 4_000_000;

/// Depths that differ by less than this part are the same.
const SAME_DEPTH: f64 = 1e-9;

/// Shorter parts of an edge, as fractions of it, throw no shadow: what rounding leaves
/// between two faces that meet.
const SHORTEST: f64 = 1e-12;

/// A segment of the edge of a hard shadow.
#[derive(Clone, Debug, PartialEq)]
pub struct ShadowLine {
    /// The face that the shadow falls on.
    pub face: u32,
    /// The segment.
    pub line: Crossing,
}

/// The segments of a scene's hard shadows, light by light and edge by edge; `None` if there are
/// more than [`MOST_SHADOW_LINES`]. `edges` are those of the shapes, with vertices of the joined
/// mesh. Some of them if the work is given up.
pub fn shadow_lines(accel: &Accel, edges: &[Edge], halt: &Halt) -> Option<Vec<ShadowLine>> {
    shadow_lines_up_to(accel, edges, MOST_SHADOW_LINES, halt)
}

/// [`shadow_lines`] with another limit. Never more than that many segments are held, whatever the
/// number of threads: each is counted before it is kept.
fn shadow_lines_up_to(
    accel: &Accel,
    edges: &[Edge],
    most: usize,
    halt: &Halt,
) -> Option<Vec<ShadowLine>> {
    let count = AtomicUsize::new(0);
    let mut lines = Vec::new();
    for (i, emitter) in accel.scene.emitters.iter().enumerate() {
        let Some(apex) = emitter.apex() else { continue };
        let light = Light {
            accel,
            apex,
            anchor: accel.anchor(EmitterId(i as u32)),
            count: &count,
            most,
        };
        for edges in edges.chunks(CHUNK) {
            let of_edge = |edge: &Edge| match halt.now() {
                true => Vec::new(),
                false => light.lines(edge),
            };
            let found: Vec<ShadowLine> = edges.par_iter().flat_map_iter(of_edge).collect();
            if light.are_too_many() {
                return None;
            }
            lines.extend(found);
        }
    }
    Some(lines)
}

/// Edges whose segments are put together at once.
const CHUNK: usize = 1 << 12;

/// A light without extent.
struct Light<'a> {
    accel: &'a Accel,
    apex: Apex,
    /// Its number among the points of the boundaries.
    anchor: u32,
    /// Segments that were found, of all lights, and the most that there may be.
    count: &'a AtomicUsize,
    most: usize,
}

/// Where a face crosses the wedge of an edge, along a part of the edge.
#[derive(Clone, Copy)]
struct Section {
    face: u32,
    ends: [WedgePoint; 2],
}

impl Section {
    /// Its depth where light passes the edge at a fraction of it.
    fn depth(&self, along: f64) -> f64 {
        let [a, b] = self.ends;
        a.depth + (b.depth - a.depth) * ((along - a.along) / (b.along - a.along))
    }

    fn range(&self) -> [f64; 2] {
        self.ends.map(|end| end.along)
    }

    /// Its least and its largest depth.
    fn depths(&self) -> [f64; 2] {
        let [a, b] = self.ends.map(|end| end.depth);
        [a.min(b), a.max(b)]
    }

    /// The part of it that is behind the edge.
    fn behind(&self, depth: f64) -> Option<Self> {
        let mut behind = *self;
        let [a, b] = self.ends;
        let t = (depth - a.depth) / (b.depth - a.depth);
        let crossing = WedgePoint {
            along: a.along + (b.along - a.along) * t,
            depth,
        };
        match (a.depth > depth, b.depth > depth) {
            (true, true) => {}
            (true, false) => behind.ends[1] = crossing,
            (false, true) => behind.ends[0] = crossing,
            (false, false) => return None,
        }
        Some(behind)
    }
}

impl Light<'_> {
    /// The shadow of an edge: where the light past it first reaches a face.
    fn lines(&self, edge: &Edge) -> Vec<ShadowLine> {
        let mesh = &self.accel.mesh;
        if self.are_too_many() || !edge.is_silhouette_to(mesh, self.apex) {
            return Vec::new();
        }
        let ends = edge.vertices.map(|i| mesh.positions[i as usize]);
        let Some(wedge) = Wedge::new(self.apex, ends) else {
            return Vec::new();
        };
        let has_edge = |face: u32| {
            let corners = mesh.corners(face as usize);
            ends.iter().all(|end| corners.contains(end))
        };
        // Light passes beside the surface that ends at the edge. If that has faces along the
        // light, others touch the wedge where these end: from the side of the surface they
        // hide nothing.
        let mut wedge = match self.corner_beside(edge, &wedge) {
            Some(corner) => wedge.beside(corner),
            None => wedge,
        };
        let mut found = Vec::new();
        self.accel.across(&wedge, &mut found);
        if edge.sides == Sides::Open && found.iter().any(|&(face, _)| has_edge(face)) {
            wedge = wedge.turned();
            self.accel.across(&wedge, &mut found);
        }
        // The faces of the edge itself cross the wedge in the edge, and faces that the light
        // sees edge-on, in no more than a ray.
        let counts = |face: u32| !has_edge(face) && !is_edge_on(mesh, face, self.apex);
        let found = found.into_iter().filter(|&(face, _)| counts(face));
        let sections = found.map(|(face, ends)| Section { face, ends });
        let sections: Vec<Section> = sections.collect();
        let parts = first_met(&sections, wedge.depth_of_segment());
        let parts = parts.into_iter();
        let lines = parts.filter_map(|part| {
            let line = self.line(edge, &wedge, &part)?;
            let face = part.face;
            Some(ShadowLine { face, line })
        });
        // Whether there are too many does not depend on the order of counting.
        let is_room = |_: &ShadowLine| self.count.fetch_add(1, Ordering::Relaxed) < self.most;
        lines.take_while(is_room).collect()
    }

    fn are_too_many(&self) -> bool {
        self.count.load(Ordering::Relaxed) > self.most
    }

    /// The corner of the two faces at an edge that is farthest from its wedge.
    fn corner_beside(&self, edge: &Edge, wedge: &Wedge) -> Option<Vec3> {
        let Sides::Between { faces, .. } = edge.sides else {
            return None;
        };
        let mesh = &self.accel.mesh;
        let start = mesh.positions[edge.vertices[0] as usize];
        let height = |corner: &Vec3| wedge.normal().dot(*corner - start).abs();
        let corners = faces
            .into_iter()
            .flat_map(|face| mesh.corners(face as usize));
        corners.max_by(|a, b| height(a).total_cmp(&height(b)))
    }

    /// The segment of the shadow on a part of a face; `None` if light passes along the face.
    fn line(&self, edge: &Edge, wedge: &Wedge, part: &Section) -> Option<Crossing> {
        let mesh = &self.accel.mesh;
        let [a, b] = edge.vertices;
        let ends = part.ends.map(|end| wedge.point(end));
        let positions = ends.map(|(_, position)| position);
        let face = CrossingPlane::of_face(mesh, part.face, positions);
        let light = CrossingPlane {
            vertices: [a, b, self.anchor],
            weights: ends.map(|(weights, _)| weights),
            normal: wedge.normal().normalized(),
        };
        crossing_of_planes([face, light], positions, false)
    }
}

/// The parts of sections that light past an edge reaches first; the edge has a depth. Parts
/// that something hides may be left in where hiding and hidden faces cross; they are edges
/// of no shadow, but harm nothing.
fn first_met(sections: &[Section], depth_of_edge: f64) -> Vec<Section> {
    // What is before the edge takes its light.
    let edge = |[from, to]: [f64; 2]| Section {
        face: u32::MAX,
        ends: [from, to].map(|along| WedgePoint {
            along,
            depth: depth_of_edge,
        }),
    };
    let whole = edge([0.0, 1.0]);
    let mut lit = vec![[0.0, 1.0]];
    for section in sections {
        take_hidden(&mut lit, &whole, section);
    }
    let behind: Vec<Section> = sections
        .iter()
        .filter_map(|section| section.behind(depth_of_edge))
        .collect();
    let places = Places::new(&behind);
    let mut met = Vec::new();
    for section in &behind {
        let mut free = lit[within(&lit, section.range())].to_vec();
        let [from, to] = section.range();
        for range in &mut free {
            *range = [range[0].max(from), range[1].min(to)];
        }
        free.retain(is_long);
        places.take_hidden(&mut free, section);
        met.extend(free.into_iter().map(|range| Section {
            face: section.face,
            ends: range.map(|along| WedgePoint {
                along,
                depth: section.depth(along),
            }),
        }));
    }
    met
}

/// Sections by where along the edge they are: in equal parts of it, as many as let a section
/// lie in two of them on average, the nearest to the light first.
struct Places {
    parts: Vec<Vec<Section>>,
}

impl Places {
    fn new(sections: &[Section]) -> Self {
        let length = |section: &Section| section.range()[1] - section.range()[0];
        let total: f64 = sections.iter().map(length).sum();
        let count = sections.len() as f64;
        let mut places = Self {
            parts: vec![Vec::new(); (count / total.max(1.0)).max(1.0) as usize],
        };
        let mut order: Vec<&Section> = sections.iter().collect();
        order.sort_by(|a, b| a.depths()[0].total_cmp(&b.depths()[0]));
        for section in order {
            for part in places.parts_of(section) {
                places.parts[part].push(*section);
            }
        }
        places
    }

    /// The parts of the edge that a section lies in.
    fn parts_of(&self, section: &Section) -> std::ops::RangeInclusive<usize> {
        let part = |along: f64| (along * self.parts.len() as f64) as usize;
        let [from, to] = section
            .range()
            .map(|along| part(along).min(self.parts.len() - 1));
        from..=to
    }

    /// Takes from the free ranges of a section those in which another one is before it.
    fn take_hidden(&self, free: &mut Vec<[f64; 2]>, section: &Section) {
        let [_, farthest] = section.depths();
        for part in self.parts_of(section) {
            let nearer = self.parts[part].iter();
            for other in nearer.take_while(|other| other.depths()[0] < farthest) {
                if free.is_empty() {
                    return;
                }
                take_hidden(free, section, other);
            }
        }
    }
}

/// True if a range of an edge is not just what rounding leaves.
fn is_long([low, high]: &[f64; 2]) -> bool {
    high - low > SHORTEST
}

/// Which of some ranges, in ascending order and apart, lie within another one somewhere.
fn within(ranges: &[[f64; 2]], [from, to]: [f64; 2]) -> std::ops::Range<usize> {
    let first = ranges.partition_point(|&[_, high]| high <= from);
    let end = ranges.partition_point(|&[low, _]| low < to);
    first..end.max(first)
}

/// Takes from the free ranges of a section that in which another one is before it.
fn take_hidden(free: &mut Vec<[f64; 2]>, section: &Section, other: &Section) {
    let ([a, b], [c, d]) = (section.range(), other.range());
    let (from, to) = (a.max(c), b.min(d));
    if to - from <= SHORTEST {
        return;
    }
    let cut = within(free, [from, to]);
    if cut.is_empty() {
        return;
    }
    // How far the other one is before it.
    let before = |along: f64| section.depth(along) - other.depth(along);
    let largest = |along: f64| section.depth(along).abs().max(other.depth(along).abs());
    let same = SAME_DEPTH * largest(from).max(largest(to));
    if before(from) < -same || before(to) < -same || before(0.5 * (from + to)) <= same {
        return;
    }
    // Of the ranges that it cuts there is left what the first begins and the last ends with.
    let left = [[free[cut.start][0], from], [to, free[cut.end - 1][1]]];
    free.splice(cut, left.into_iter().filter(is_long));
}

#[cfg(test)]
mod tests {
    use capwalk_geometry::{Mesh, topology};
    use capwalk_math::Affine;
    use capwalk_scene::params::Registry;
    use capwalk_scene::primitive::{cube, rectangle};
    use capwalk_scene::{Emitter, Scene, ShadingNormals, Shape, Tangent, builtin};

    use super::*;
    use crate::crossing::crossings;

    /// Numbers from 0 to 1 that look random.
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f64 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        }

        fn point(&mut self) -> Vec3 {
            Vec3::from([(); 3].map(|()| 2.0 * self.next() - 1.0))
        }
    }

    /// Loose triangles, some of which cross, and a closed mesh over a floor that bends, in one
    /// of the lights.
    fn scenes() -> Vec<Scene> {
        let mut numbers = Numbers(7);
        let loose = |numbers: &mut Numbers| Mesh {
            positions: (0..24).map(|_| numbers.point()).collect(),
            faces: (0..8).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        };
        let floor = Mesh {
            positions: [
                [-4.0, -4.0, -1.1],
                [4.0, -4.0, -1.3],
                [4.0, 4.0, -0.9],
                [-4.0, 4.0, -1.2],
            ]
            .map(Vec3::from)
            .to_vec(),
            faces: vec![[0, 1, 2], [0, 2, 3]],
        };
        let tip = [0.0, 0.1, 1.2];
        let closed = Mesh {
            positions: [[-0.7, -0.4, 0.3], [0.8, -0.5, 0.2], [0.1, 0.9, 0.4], tip]
                .map(Vec3::from)
                .to_vec(),
            faces: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
        };
        let bulb = |x: f64, y: f64, z: f64| Emitter::Point {
            id: "light".into(),
            position: Vec3::new(x, y, z),
            intensity: capwalk_scene::TextureId(0),
        };
        let sun = Emitter::Directional {
            id: "light".into(),
            direction: Vec3::new(0.3, 0.1, -1.0).normalized(),
            irradiance: capwalk_scene::TextureId(0),
        };
        let lights = [bulb(0.4, 0.3, 3.0), bulb(0.0, 0.05, 0.1), sun];
        let mut scenes = Vec::new();
        for light in &lights {
            let soup = vec![loose(&mut numbers), floor.clone()];
            let solid = vec![closed.clone(), floor.clone()];
            scenes.extend([soup, solid].map(|meshes| scene(meshes, light)));
        }
        scenes
    }

    fn scene(meshes: Vec<Mesh>, light: &Emitter) -> Scene {
        let mut scene = builtin::scene("leaf").expect("built in");
        let bsdf = scene.shapes[0].bsdf;
        let shapes = meshes.into_iter().enumerate().map(|(i, mesh)| {
            Shape::new(format!("shape{i}"), mesh, ShadingNormals::Face, bsdf).into()
        });
        scene.shapes = shapes.collect();
        scene.emitters = vec![light.clone()];
        scene
    }

    /// Turned cubes over a floor in light that passes along some of their faces: along four,
    /// in parallel to their edges, along two, and from a point in the plane of one.
    fn scenes_with_faces_along_the_light() -> Vec<Scene> {
        let mut numbers = Numbers(17);
        let mut scenes = Vec::new();
        for _ in 0..6 {
            let axis = numbers.point().normalized();
            let turn = Affine::rotate(axis, 0.6 * numbers.next());
            let (cube, _) = cube(turn * Affine::scale(Vec3::new(0.5, 0.6, 0.4)));
            let below = Affine::translate(Vec3::new(0.0, 0.0, -1.3));
            let (floor, _) = rectangle(below * Affine::scale(Vec3::splat(5.0)));
            let sun = |direction: Vec3| Emitter::Directional {
                id: "light".into(),
                direction: turn.vector(direction).normalized(),
                irradiance: capwalk_scene::TextureId(0),
            };
            let bulb = Emitter::Point {
                id: "light".into(),
                position: turn.point(Vec3::new(0.5, -0.7, 2.5)),
                intensity: capwalk_scene::TextureId(0),
            };
            let lights = [
                sun(Vec3::new(0.0, 0.0, -1.0)),
                sun(Vec3::new(0.0, 0.4, -1.0)),
                bulb,
            ];
            let meshes = || vec![cube.clone(), floor.clone()];
            scenes.extend(lights.iter().map(|light| scene(meshes(), light)));
        }
        scenes
    }

    fn edges_of(accel: &Accel) -> Vec<Edge> {
        let mut edges = Vec::new();
        for (i, shape) in accel.scene.shapes.iter().enumerate() {
            let own = topology::edges_with(&shape.mesh, |_| false);
            edges.extend(own.into_iter().map(|mut edge| {
                crate::boundaries::shift(&mut edge, accel.first_vertex[i], accel.first_face[i]);
                edge
            }));
        }
        edges
    }

    fn lines_of(accel: &Accel) -> Vec<Crossing> {
        let lines = shadow_lines(accel, &edges_of(accel), &Halt::never()).expect("few");
        lines.into_iter().map(|line| line.line).collect()
    }

    fn is_lit(accel: &Accel, point: Vec3) -> bool {
        match accel.scene.emitters[0].apex().expect("no extent") {
            Apex::Point(origin) => accel.visible(point, origin),
            Apex::Direction(direction) => {
                accel.surface_sees(point, -direction.normalized(), f64::INFINITY)
            }
        }
    }

    /// Asserts that along any way over a face light begins and ends only where a line or another
    /// face is: how often it does, and how often ways pass lines.
    fn changes_at_lines(scenes: Vec<Scene>) -> [usize; 2] {
        const STEPS: u32 = 400;
        let mut numbers = Numbers(3);
        let (mut changes, mut passed) = (0, 0);
        for (number, scene) in scenes.into_iter().enumerate() {
            let accel = Accel::new(scene);
            let lines = lines_of(&accel);
            let crossings = crossings(&accel, &Halt::never());
            for face in 0..accel.mesh.faces.len() {
                // Whether a face along the light is lit is a matter of rounding.
                let apex = accel.scene.emitters[0].apex().expect("no extent");
                if is_edge_on(&accel.mesh, face as u32, apex) {
                    continue;
                }
                let [a, b, c] = accel.mesh.corners(face);
                let normal = accel.mesh.face_cross(face).normalized();
                for _ in 0..30 {
                    let mut inside = || {
                        let (u, v) = (numbers.next().sqrt(), numbers.next());
                        a * (1.0 - u) + b * (u * (1.0 - v)) + c * (u * v)
                    };
                    let (from, to) = (inside(), inside());
                    let across = normal.cross(to - from);
                    // Where the way passes a segment on the face, in steps.
                    let passes = |line: &Crossing| {
                        let ends = line.ends.map(|end| end.position);
                        if ends.iter().any(|&p| normal.dot(p - a).abs() > 1e-9) {
                            return None;
                        }
                        let heights = ends.map(|p| across.dot(p - from));
                        let t = heights[0] / (heights[0] - heights[1]);
                        let at = ends[0] + (ends[1] - ends[0]) * t;
                        let way = (to - from).dot(at - from) / (to - from).length_squared();
                        let is_passed = (heights[0] < 0.0) != (heights[1] < 0.0);
                        (is_passed && (0.0..1.0).contains(&way)).then_some(way * f64::from(STEPS))
                    };
                    let at_lines: Vec<f64> = lines.iter().filter_map(passes).collect();
                    let mut places: Vec<f64> = crossings.iter().filter_map(passes).collect();
                    places.extend(&at_lines);
                    let lit: Vec<bool> = (0..=STEPS)
                        .map(|k| from + (to - from) * (f64::from(k) / f64::from(STEPS)))
                        .map(|point| is_lit(&accel, point))
                        .collect();
                    for (k, pair) in lit.windows(2).enumerate() {
                        let step = k as f64 - 1e-3..k as f64 + 1.001;
                        if pair[0] != pair[1] {
                            changes += 1;
                            assert!(
                                places.iter().any(|place| step.contains(place)),
                                "scene {number}, face {face}, from {from:?} to {to:?}, step {k}"
                            );
                        }
                    }
                    passed += at_lines.len();
                }
            }
        }
        [changes, passed]
    }

    /// Along any way over a face, light begins and ends only where a line or another face is;
    /// and nearly all lines are places where it does.
    #[test]
    fn light_ends_where_lines_are() {
        let [changes, passed] = changes_at_lines(scenes());
        assert!(changes > 500, "{changes}");
        // Two lines within a step hide each other; a few others are false.
        assert!(
            changes as f64 > 0.8 * passed as f64,
            "{changes} of {passed}"
        );
    }

    /// So it does where faces lie along the light, although rounding decides what their corners
    /// are to it: of their two silhouettes, one behind the other, at least one has a shadow.
    #[test]
    fn light_ends_where_lines_are_of_faces_along_it() {
        let [changes, _] = changes_at_lines(scenes_with_faces_along_the_light());
        assert!(changes > 150, "{changes}");
    }

    /// One line more than there may be, and there is none; never more than that are held.
    #[test]
    fn too_many_lines_are_none() {
        for scene in scenes() {
            let accel = Accel::new(scene);
            let edges = edges_of(&accel);
            let all = shadow_lines(&accel, &edges, &Halt::never()).expect("few");
            // Inside of a closed mesh a light throws no shadow.
            if all.is_empty() {
                continue;
            }
            let up_to = |most: usize| shadow_lines_up_to(&accel, &edges, most, &Halt::never());
            assert_eq!(up_to(all.len()).as_ref(), Some(&all));
            assert_eq!(up_to(all.len() - 1), None);
            let count = AtomicUsize::new(0);
            let light = Light {
                accel: &accel,
                apex: accel.scene.emitters[0].apex().expect("no extent"),
                anchor: accel.anchor(EmitterId(0)),
                count: &count,
                most: 3,
            };
            let kept: usize = edges.iter().map(|edge| light.lines(edge).len()).sum();
            assert_eq!(kept, all.len().min(3));
        }
    }

    /// [`first_met`] by comparing every section with every other one, one free range at a time.
    fn first_met_of_all_pairs(sections: &[Section], depth_of_edge: f64) -> Vec<Section> {
        let at = |depth: f64, range: [f64; 2]| Section {
            face: u32::MAX,
            ends: range.map(|along| WedgePoint { along, depth }),
        };
        let cut = |free: Vec<[f64; 2]>, section: &Section, other: &Section| {
            let pieces = free.into_iter().flat_map(|range| {
                let mut pieces = vec![range];
                take_hidden(&mut pieces, section, other);
                pieces
            });
            pieces.collect()
        };
        let whole = at(depth_of_edge, [0.0, 1.0]);
        let all = |free, section: &Section, others: &[Section]| {
            let others = others.iter();
            others.fold(free, |free, other| cut(free, section, other))
        };
        let lit: Vec<[f64; 2]> = all(vec![[0.0, 1.0]], &whole, sections);
        let behind = sections.iter().filter_map(|s| s.behind(depth_of_edge));
        let behind: Vec<Section> = behind.collect();
        let mut met = Vec::new();
        for section in &behind {
            let [from, to] = section.range();
            let own = lit.iter().map(|&[low, high]| [low.max(from), high.min(to)]);
            let free = all(own.filter(is_long).collect(), section, &behind);
            met.extend(free.into_iter().map(|range| Section {
                face: section.face,
                ends: range.map(|along| WedgePoint {
                    along,
                    depth: section.depth(along),
                }),
            }));
        }
        met
    }

    /// What is looked at by place and depth is what hides something, to the bit: with short and
    /// long sections, some of the same depth, some that cross, and some before the edge.
    #[test]
    fn hidden_sections_are_those_of_all_pairs() {
        let numbers_of = |section: &Section| {
            let [a, b] = section.ends;
            (
                section.face,
                [a.along, a.depth, b.along, b.depth].map(f64::to_bits),
            )
        };
        let mut numbers = Numbers(11);
        let (mut parts, mut hidden) = (0, 0);
        for trial in 0..300 {
            let length = [0.02, 0.2, 1.5][trial % 3];
            let sections = (0..60).map(|face| {
                let from = numbers.next();
                let long = if numbers.next() < 0.1 { 1.0 } else { length };
                let to = (from + long * numbers.next()).min(1.0);
                let from = if long == 1.0 { 0.1 * from } else { from };
                let depth = (8.0 * numbers.next()).round() + 0.5;
                let slope = if numbers.next() < 0.5 {
                    0.0
                } else {
                    numbers.next()
                };
                Section {
                    face,
                    ends: [(from, depth), (to, depth + slope)]
                        .map(|(along, depth)| WedgePoint { along, depth }),
                }
            });
            let sections: Vec<Section> = sections.collect();
            for depth_of_edge in [0.0, 1.7] {
                let found = first_met(&sections, depth_of_edge);
                let expected = first_met_of_all_pairs(&sections, depth_of_edge);
                let [found, expected] =
                    [found, expected].map(|all| all.iter().map(numbers_of).collect::<Vec<_>>());
                assert_eq!(found, expected, "trial {trial}");
                parts += found.len();
                hidden += (0..60)
                    .filter(|&f| found.iter().all(|part| part.0 != f))
                    .count();
            }
        }
        assert!(parts > 5000 && hidden > 5000, "{parts} {hidden}");
    }

    /// Lines move as those of scenes a little later, with everything in motion.
    #[test]
    fn lines_move_with_faces_edges_and_lights() {
        let step = 1e-6;
        let mut count = 0;
        for scene in scenes() {
            let moves = match scene.emitters[0] {
                Emitter::Directional { .. } => "light.rotate.x - 0.4*light.rotate.y",
                _ => "0.3*light.translate.x - light.translate.y + 0.2*light.translate.z",
            };
            let sum = format!(
                "shape0.translate.x + 0.6*shape0.rotate.y - shape1.translate.z + 0.1*shape1.rotate.x + {moves}"
            );
            let tangent: Tangent = Registry::new(&scene).tangent(&scene, &sum).expect(&sum);
            let accel = Accel::new(scene.clone());
            let mut velocities: Vec<Vec3> = Vec::new();
            for shape in &tangent.shapes {
                velocities.extend(&shape.as_ref().expect("moves").vertices);
            }
            velocities.extend(scene.anchor_velocities(&tangent));
            let later = Accel::new(scene.moved(&tangent, step));
            let (before, after) = (lines_of(&accel), lines_of(&later));
            assert_eq!(before.len(), after.len());
            for (line, moved) in before.iter().zip(&after) {
                let [from, to] = moved.ends.map(|end| end.position);
                let along = to - from;
                if along.length() < 1e-3 {
                    continue;
                }
                count += 1;
                for end in &line.ends {
                    let velocity = end.velocity(&velocities);
                    let expected = end.position + velocity * step;
                    let off = along.cross(expected - from).length() / along.length();
                    // The second order grows where light grazes.
                    let speed = velocity.length().max(1.0);
                    assert!(
                        off < 1e-3 * step * speed * speed,
                        "off by {off} at {velocity:?}"
                    );
                }
            }
        }
        assert!(count > 100, "{count}");
    }
}
