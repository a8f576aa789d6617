//! How much of silhouettes is visible from which directions, as far as their own surface
//! decides it: learned by rays (METHOD 8). How often edges are sampled depends on it, and
//! nothing else.

use capwalk_geometry::sampler_buffers::DIRECTIONS;
use capwalk_geometry::{Halt, Ray};
use capwalk_math::{Frame, Vec3, sphere};
use capwalk_scene::ShapeId;

use crate::accel::Accel;
use crate::sampled_edge::SampledEdge;

/// Directions from each edge, in which rays go if something may hide it.
const RAYS: usize = 8;

/// So many edges of a shape, if none of their rays meets it, say that it hides none.
const PROBES: usize = 256;

/// The fraction of the golden ratio: its multiples spread evenly, whatever the order of the edges.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Surfaces within this distance hide an edge, as a fraction of its shape's size; closer
/// viewpoints see it.
const REACH: f64 = 0.25;

/// Share of edges that counts as visible where no ray says so.
const LEAST: f64 = 0.1;

/// So many rays in a direction are few.
const FEW: f64 = 2.0;

/// Distance within which a ray hits the faces of its own edge, as a fraction of coordinates.
const BEYOND_ROUNDING: f64 = 1e-9;

/// Steps of points that are spread evenly in a cube (Roberts 2018): powers of the inverse
/// of the root of x⁴ = x + 1.
const SPREAD: [f64; 3] = [
    0.819_172_513_396_164_4,
    0.671_043_606_703_789_3,
    0.549_700_477_901_970_7,
];

/// From where an edge is visible.
#[derive(Clone, Copy, Debug)]
pub struct EdgeVisibility {
    /// For each ray, the number of its direction, if nothing within reach hides the edge from
    /// there.
    rays: [Option<u8>; RAYS],
    /// How far its own surface can hide it, world units.
    reach: f64,
}

impl EdgeVisibility {
    /// The visibility of all edges of meshes, by their numbers; of some of them if the work is given up.
    pub fn all(edges: &[SampledEdge], accel: &Accel, halt: &Halt) -> Vec<Self> {
        let shape_of = |edge: &SampledEdge| accel.shape_of_vertex(edge.points[0]);
        let of_shapes = edges.chunk_by(|a, b| shape_of(a) == shape_of(b));
        let visibility = of_shapes.flat_map(|edges| {
            let shape = shape_of(&edges[0]);
            let (low, high) = accel.scene.shape(shape).mesh.bounds();
            let reach = REACH * (high - low).length();
            let visibility_of = move |edge: &SampledEdge| match edge.exposure == 1.0 {
                true => Self::of(edge, reach, |ray| hides(shape, ray, accel)),
                // It is seen from nowhere.
                false => Self {
                    rays: [None; RAYS],
                    reach,
                },
            };
            // Of convex shapes, and of others of which some edges say so, nothing is hidden. Of few
            // edges, it takes less to ask each.
            let mut probes = (0..PROBES).map(|i| {
                let place = (i as f64 * GOLDEN).fract() * edges.len() as f64;
                &edges[place as usize]
            });
            let is_hidden_somewhere = edges.len() <= PROBES
                || edges.iter().any(|edge| edge.exposure != 1.0)
                || probes.any(|edge| visibility_of(edge).rays.contains(&None));
            edges.iter().map(move |edge| match is_hidden_somewhere {
                true => visibility_of(edge),
                false => Self::of(edge, reach, |_| false),
            })
        });
        visibility.take_while(|_| !halt.now()).collect()
    }

    /// Looks from points on an edge in directions from which it is a silhouette, all about
    /// equally likely, as far as `reach`, and asks whether something hides it there.
    fn of(edge: &SampledEdge, reach: f64, hides: impl Fn(&Ray) -> bool) -> Self {
        let ([from, to], normals) = (edge.ends, edge.normals());
        let along = to - from;
        let axis = along.normalized();
        let cast = |ray: usize| {
            let index = (edge.edge as usize * RAYS + ray) as f64;
            let [place, height, turn] = SPREAD.map(|step| (index * step).fract());
            // Across the edge, between the planes of its faces, to either side.
            let across = match normals {
                [Some(first), Some(second)] => {
                    let part = (2.0 * turn).fract();
                    let normal = first * (1.0 - part) + second * part;
                    let side = if turn < 0.5 { 1.0 } else { -1.0 };
                    axis.cross(normal).normalized() * side
                }
                _ => sphere::sample_tangent(&Frame::from_normal(axis), turn),
            };
            // On the sphere, heights along an axis are uniform (Archimedes).
            let cos = 2.0 * height - 1.0;
            let direction = axis * cos + across * (1.0 - cos * cos).sqrt();
            let is_hidden = hides(&Ray {
                t_min: BEYOND_ROUNDING * (from.length() + to.length()),
                t_max: reach,
                ..Ray::new(from + along * place, direction)
            });
            (!is_hidden).then(|| number(direction))
        };
        Self {
            rays: std::array::from_fn(cast),
            reach,
        }
    }
}

/// True if a shape itself is what a ray from one of its edges meets. Surfaces of others may be
/// what a viewpoint is on, and hide nothing.
fn hides(shape: ShapeId, ray: &Ray, accel: &Accel) -> bool {
    let hit = accel.first_hit_within(ray);
    hit.is_some_and(|hit| accel.shape_of(&hit) == shape)
}

/// The quarter of a cube's side through which a direction passes: one of [`DIRECTIONS`].
fn number(direction: Vec3) -> u8 {
    let d = direction.to_array();
    let larger = |most: usize, i: usize| if d[i].abs() > d[most].abs() { i } else { most };
    let axis = (1..3).fold(0, larger);
    let sign = |i: usize| u8::from(d[(axis + i) % 3] < 0.0);
    8 * axis as u8 + 4 * sign(0) + 2 * sign(1) + sign(2)
}

/// The silhouettes among some edges that are visible from each direction.
#[derive(Clone, Copy, Debug)]
pub struct LearnedVisibility {
    /// Their lengths, as shares of those of all silhouettes; above 0, and above 1 in
    /// directions from which there are more than elsewhere.
    shares: [f32; DIRECTIONS],
    /// From closer, world units, all of them are.
    reach: f64,
}

/// From where some edges are visible, all together.
#[derive(Clone, Copy, Debug, Default)]
pub struct VisibilitySum {
    /// For each direction, the sum over the rays there that nothing hides of how long silhouettes
    /// their edges are.
    lengths: [f64; DIRECTIONS],
    /// The sum of these lengths over all rays, hidden or not.
    all: f64,
    /// How many rays there are.
    count: usize,
    /// How far their own surfaces can hide edges, world units.
    reach: f64,
}

impl VisibilitySum {
    /// Counts an edge, given how long a silhouette it is, and from where it is visible.
    pub fn add_edge(&mut self, length: f64, visibility: &EdgeVisibility) {
        for &direction in visibility.rays.iter().flatten() {
            self.lengths[usize::from(direction)] += length;
        }
        self.all += length * RAYS as f64;
        self.count += RAYS;
        self.reach = self.reach.max(visibility.reach);
    }

    /// Counts other edges.
    pub fn add(&mut self, other: &Self) {
        let lengths = self.lengths.iter_mut().zip(other.lengths);
        lengths.for_each(|(length, others)| *length += others);
        self.all += other.all;
        self.count += other.count;
        self.reach = self.reach.max(other.reach);
    }
}

impl LearnedVisibility {
    /// Where nothing is known, everything is visible.
    pub const ALL: Self = Self {
        shares: [1.0; DIRECTIONS],
        reach: 0.0,
    };

    /// The visibility of edges, at least one.
    pub fn of(edges: &VisibilitySum) -> Self {
        let all = edges.all.max(f64::MIN_POSITIVE);
        // Where rays are few, what those in all directions say counts as well.
        let mean = edges.lengths.iter().sum::<f64>() / all;
        let few = FEW * all / edges.count as f64;
        let share = |seen: f64| (seen + few * mean) / (all / DIRECTIONS as f64 + few);
        let share = |seen: f64| (LEAST + (1.0 - LEAST) * share(seen)) as f32;
        Self {
            shares: edges.lengths.map(share),
            reach: edges.reach,
        }
    }

    /// The share in each direction.
    pub fn shares(&self) -> [f32; DIRECTIONS] {
        self.shares
    }

    /// From closer than this, world units, everything is visible.
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// The share that is visible from a viewpoint at an offset from the edges.
    pub fn from(&self, offset: Vec3) -> f64 {
        match offset.length() > self.reach {
            true => f64::from(self.shares[usize::from(number(offset))]),
            false => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use capwalk_geometry::effort;
    use capwalk_math::Affine;
    use capwalk_scene::primitive::{cube, icosphere};
    use capwalk_scene::{BsdfId, Scene, ShadingNormals, Shape, builtin};

    use super::*;
    use crate::boundaries::Boundaries;
    use crate::sampled_edge::outward;

    /// The visibility of the edge along z at x = y = 1 of the cube from -1 to 1. `beside`:
    /// with another cube in the same mesh, where x is larger and y smaller.
    fn edge_of_a_cube(beside: bool) -> LearnedVisibility {
        let mut scene: Scene = builtin::scene("leaf").expect("built in");
        scene.shapes.clear();
        scene.emitters.clear();
        let (mut mesh, _) = cube(Affine::IDENTITY);
        if beside {
            let place = Affine::translate(Vec3::new(10.0, -8.0, 0.0));
            mesh.append(&cube(place * Affine::scale(Vec3::splat(8.0))).0);
        }
        scene.add_shape(Shape::new("cube", mesh, ShadingNormals::Face, BsdfId(0)));
        let accel = Accel::new(scene);
        let boundaries = Boundaries::new(&accel);
        let edges = boundaries.edges().iter().zip(0..);
        let mut sampled = edges
            .map(|(edge, i)| SampledEdge::new(i, edge, boundaries.ends(i), &accel.mesh, None, 0.0));
        let is_it = |edge: &SampledEdge| edge.ends.iter().all(|p| p.x == 1.0 && p.y == 1.0);
        let edge = sampled.find(is_it).expect("an edge of the cube");
        let visibility = EdgeVisibility::of(&edge, 10.0, |ray| hides(ShapeId(0), ray, &accel));
        // So many like it that their rays are not few.
        let mut seen = VisibilitySum::default();
        (0..100).for_each(|_| seen.add_edge(edge.weight, &visibility));
        LearnedVisibility::of(&seen)
    }

    /// An edge of a cube is visible from wherever it is a silhouette, and there are no
    /// silhouettes elsewhere. Another cube hides it.
    #[test]
    fn cubes_show_their_edges() {
        let [alone, beside] = [false, true].map(edge_of_a_cube);
        let mean = alone.shares.iter().sum::<f32>() / DIRECTIONS as f32;
        assert!((mean - 1.0).abs() < 1e-6, "{mean}");
        // One in each number of direction, far away, with signs of x and y.
        let far = |x: f64, y: f64| {
            let lengths = [(3.0, 2.0, 1.0), (2.0, 3.0, 1.0), (2.0, 2.0, 3.0)];
            let both = lengths
                .into_iter()
                .flat_map(|(a, b, c)| [(a, b, c), (a, b, -c)]);
            both.map(move |(a, b, c)| Vec3::new(a * x, b * y, c) * 9.0)
        };
        for side in far(1.0, 1.0).chain(far(-1.0, -1.0)) {
            assert!(alone.from(side) < 0.2, "{side:?}");
            assert_eq!(alone.from(side / 60.0), 1.0);
        }
        let sum = |x: f64, y: f64| far(x, y).map(|side| beside.from(side)).sum::<f64>();
        let (hidden, open) = (sum(1.0, -1.0), sum(-1.0, 1.0));
        assert!(hidden < 0.8 * open, "{hidden}, {open}");
    }

    /// Of many small shapes, each edge is asked once: so many rays, and no more.
    #[test]
    fn edges_of_small_shapes_are_asked_once() {
        let mut scene: Scene = builtin::scene("leaf").expect("built in");
        scene.shapes.clear();
        scene.emitters.clear();
        for i in 0..20 {
            let (mesh, _) = cube(Affine::translate(Vec3::new(3.0 * f64::from(i), 0.0, 0.0)));
            let name = format!("{i}");
            scene.add_shape(Shape::new(name, mesh, ShadingNormals::Face, BsdfId(0)));
        }
        let accel = Accel::new(scene);
        let boundaries = Boundaries::new(&accel);
        let edges = boundaries.edges().iter().zip(0..);
        let sampled = edges
            .map(|(edge, i)| SampledEdge::new(i, edge, boundaries.ends(i), &accel.mesh, None, 0.0));
        let sampled: Vec<SampledEdge> = sampled.collect();
        let one = |work: &dyn Fn()| {
            let before = effort();
            work();
            effort() - before
        };
        let ray = one(&|| {
            accel.first_hit(Vec3::zero(), Vec3::new(0.0, 0.0, 1.0));
        });
        let all = one(&|| {
            EdgeVisibility::all(&sampled, &accel, &Halt::never());
        });
        assert_eq!(all, (sampled.len() * RAYS) as u64 * ray);
    }

    /// What is known is the same as if all edges had been asked, of shapes that hide nothing of
    /// themselves and of those that do, with and without concave edges.
    #[test]
    fn a_few_edges_say_that_nothing_is_hidden() {
        let mut scene: Scene = builtin::scene("leaf").expect("built in");
        scene.shapes.clear();
        scene.emitters.clear();
        let mut waves = icosphere(16);
        for p in &mut waves.positions {
            *p = *p * (1.0 + 0.2 * (7.0 * p.x).sin() * (6.0 * p.y).cos() * (5.0 * p.z).sin());
        }
        // These have no concave edges: two cubes side by side, and half of a ball.
        let (mut cubes, _) = cube(Affine::IDENTITY);
        cubes.append(&cube(Affine::translate(Vec3::new(2.2, 0.0, 0.0))).0);
        let mut bowl = icosphere(16);
        let is_low = |face: &[u32; 3]| face.iter().all(|&i| bowl.positions[i as usize].z < 0.3);
        bowl.faces = bowl.faces.iter().copied().filter(is_low).collect();
        let meshes = [icosphere(16), waves, cubes, bowl];
        for (i, mut ball) in meshes.into_iter().enumerate() {
            let away = Vec3::new(0.0, 10.0 * i as f64, 0.0);
            ball.positions.iter_mut().for_each(|p| *p += away);
            let name = format!("{i}");
            scene.add_shape(Shape::new(name, ball, ShadingNormals::Face, BsdfId(0)));
        }
        let accel = Accel::new(scene);
        let boundaries = Boundaries::new(&accel);
        let edges = boundaries.edges();
        let outward = outward(edges, &accel);
        let sampled = edges.iter().zip(0..).map(|(edge, i)| {
            let outward = outward[accel.shape_of_vertex(edge.vertices[0]).0 as usize];
            SampledEdge::new(i, edge, boundaries.ends(i), &accel.mesh, outward, 0.0)
        });
        let sampled: Vec<SampledEdge> = sampled.collect();
        let mut hidden = [0; 4];
        for (edge, found) in
            sampled
                .iter()
                .zip(EdgeVisibility::all(&sampled, &accel, &Halt::never()))
        {
            let shape = accel.shape_of_vertex(edge.points[0]);
            if edge.exposure != 1.0 {
                continue;
            }
            let expected = EdgeVisibility::of(edge, found.reach, |ray| hides(shape, ray, &accel));
            assert_eq!(found.rays, expected.rays);
            let rays = found.rays.iter();
            hidden[shape.0 as usize] += rays.filter(|ray| ray.is_none()).count();
        }
        assert_eq!(hidden[0], 0);
        assert!(
            hidden[1] > 100 && hidden[2] > 4 && hidden[3] > 20,
            "{hidden:?}"
        );
    }
}
