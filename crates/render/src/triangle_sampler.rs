//! Sampling of directions towards a mesh, nearly in proportion to solid angle: a tree of its
//! triangles is descended by how large its parts are seen, and a triangle is sampled
//! uniformly by solid angle. The time grows with the logarithm of the triangles. What is a
//! rectangle is sampled as one.

use std::ops::Range;

use capwalk_geometry::Mesh;
use capwalk_math::{Vec3, spherical_triangle};

use crate::rectangle_sampler::RectangleSampler;

/// Triangles in a leaf: among so few, all solid angles are computed.
const LEAF: usize = 4;

/// Triangles seen under less than this, in steradians, are sampled by area: all points of
/// them are seen nearly alike, and the triangle on the sphere loses digits.
const SMALL: f64 = 1e-6;

/// A mesh, sampled as it is seen. Indices are the mesh's own.
#[derive(Clone, Debug)]
pub struct TriangleSampler {
    corners: Vec<[Vec3; 3]>,
    /// The triangles in the order of the tree's leaves.
    order: Vec<u32>,
    /// Where each triangle is in that order.
    rank: Vec<u32>,
    /// The root is the first.
    nodes: Vec<Node>,
    /// All of it, if it is a rectangle.
    rectangle: Option<RectangleSampler>,
}

/// Neighbours in the order of triangles, and bounds of them.
#[derive(Clone, Debug)]
pub struct Node {
    /// Their places in that order.
    pub places: Range<usize>,
    /// The nodes of both halves; none in a leaf.
    pub halves: Option<[usize; 2]>,
    /// A ball around them.
    pub centre: Vec3,
    pub radius: f64,
    /// The sum of their areas, with and without their directions.
    pub vector_area: Vec3,
    pub area: f64,
    /// A cone of all their normals: its axis, and cosine and sine of its angle.
    pub axis: Vec3,
    pub cos_spread: f64,
    pub sin_spread: f64,
}

/// What of a triangle the tree is made by.
#[derive(Clone, Copy)]
struct Triangle {
    face: u32,
    corners: [Vec3; 3],
    /// Three times its centre.
    centre: [f64; 3],
    vector_area: Vec3,
    area: f64,
}

impl Triangle {
    fn new((&corners, face): (&[Vec3; 3], u32)) -> Self {
        let [a, b, c] = corners;
        let vector_area = (b - a).cross(c - a) * 0.5;
        Self {
            face,
            corners,
            centre: (a + b + c).to_array(),
            vector_area,
            area: vector_area.length(),
        }
    }
}

/// A point sampled on a mesh.
#[derive(Clone, Copy, Debug)]
pub struct TrianglePoint {
    /// Unit direction to it.
    pub direction: Vec3,
    /// Distance to it.
    pub distance: f64,
    /// The triangle.
    pub face: u32,
    /// Weights of its second and third corner.
    pub barycentric: [f64; 2],
    /// Density per solid angle of its direction.
    pub pdf: f64,
}

impl TriangleSampler {
    /// A sampler of all triangles of a mesh.
    pub fn new(mesh: &Mesh) -> Self {
        let count = mesh.faces.len();
        let corners: Vec<[Vec3; 3]> = (0..count).map(|face| mesh.corners(face)).collect();
        let triangles = corners.iter().zip(0..);
        let mut triangles: Vec<Triangle> = triangles.map(Triangle::new).collect();
        let mut nodes = Vec::new();
        add_node(&mut triangles, 0..count, &mut nodes);
        let order: Vec<u32> = triangles.iter().map(|triangle| triangle.face).collect();
        let mut rank = vec![0; count];
        for (place, &face) in order.iter().enumerate() {
            rank[face as usize] = place as u32;
        }
        Self {
            corners,
            order,
            rank,
            nodes,
            rectangle: RectangleSampler::new(mesh),
        }
    }

    /// All of it, if it is a rectangle.
    pub fn rectangle(&self) -> Option<&RectangleSampler> {
        self.rectangle.as_ref()
    }

    /// The nodes of its tree; the root is the first.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The triangles in the order of the tree's leaves.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Centre and radius of a ball around the mesh.
    pub fn ball(&self) -> (Vec3, f64) {
        (self.nodes[0].centre, self.nodes[0].radius)
    }

    /// About the solid angle under which the front of the mesh is seen, steradians.
    pub fn solid_angle(&self, viewpoint: Vec3) -> f64 {
        self.root().seen(viewpoint)
    }

    /// All triangles of the mesh.
    pub fn root(&self) -> &Node {
        &self.nodes[0]
    }

    /// A point that is seen from the front, and its density. `None` if there is none where
    /// the random numbers lead. The surface at the viewpoint has the shading normal `n`.
    pub fn sample(&self, [viewpoint, n]: [Vec3; 2], [mut u, v]: [f64; 2]) -> Option<TrianglePoint> {
        if let Some(rectangle) = &self.rectangle {
            let seen = rectangle.seen_from(viewpoint, n)?;
            let point = rectangle.sample(&seen, [u, v]);
            let distance = point.offset.length();
            return Some(TrianglePoint {
                direction: point.offset / distance,
                distance,
                face: point.face,
                barycentric: point.barycentric,
                pdf: rectangle.pdf(&seen, point.offset),
            });
        }
        // Descend by how large the halves are seen, and use the random number again.
        let mut node = &self.nodes[0];
        let mut chosen = 1.0;
        while let Some(halves) = node.halves {
            let shares = self.shares(halves, viewpoint)?;
            // Rounding leads to no half of which nothing is seen.
            let half = usize::from(u >= shares[0] && shares[1] > 0.0);
            u = match half {
                0 => (u / shares[0]).min(1.0),
                _ => (u - shares[0]) / shares[1],
            };
            chosen *= shares[half];
            node = &self.nodes[halves[half]];
        }
        // Choose a triangle of the leaf by its solid angle.
        let solid_angles = self.solid_angles(node, viewpoint);
        let total: f64 = solid_angles.iter().sum();
        let mut rest = u * total;
        let mut found = None;
        for (place, angle) in node.places.clone().zip(solid_angles) {
            if angle > 0.0 {
                found = Some((place, angle, (rest / angle).min(1.0)));
                if rest < angle {
                    break;
                }
                rest -= angle;
            }
        }
        let (place, angle, u) = found?;
        Some(self.point(self.order[place], viewpoint, angle, chosen / total, [u, v]))
    }

    /// A point of a triangle that is seen under `solid_angle` and is chosen with the density
    /// `chosen` times that.
    fn point(
        &self,
        face: u32,
        viewpoint: Vec3,
        solid_angle: f64,
        chosen: f64,
        u: [f64; 2],
    ) -> TrianglePoint {
        let corners = self.corners[face as usize].map(|p| p - viewpoint);
        let [a, b, c] = corners;
        let (ab, ac) = (b - a, c - a);
        let cross = ab.cross(ac);
        if solid_angle < SMALL {
            // The square root folds the square onto the triangle uniformly.
            let root = u[0].sqrt();
            let (wb, wc) = (root * (1.0 - u[1]), root * u[1]);
            let offset = a + ab * wb + ac * wc;
            let distance = offset.length();
            let direction = offset / distance;
            return TrianglePoint {
                direction,
                distance,
                face,
                barycentric: [wb, wc],
                pdf: chosen * density(solid_angle, cross, distance, direction),
            };
        }
        let direction = spherical_triangle::sample(corners, solid_angle, u);
        // Where the direction meets the triangle: inside, up to rounding.
        let t = a.dot(cross) / direction.dot(cross);
        let inside = direction * t - a;
        let squared = cross.length_squared();
        let wb = (inside.cross(ac).dot(cross) / squared).clamp(0.0, 1.0);
        let wc = (ab.cross(inside).dot(cross) / squared).clamp(0.0, 1.0 - wb);
        TrianglePoint {
            direction,
            distance: t,
            face,
            barycentric: [wb, wc],
            pdf: chosen * density(solid_angle, cross, t, direction),
        }
    }

    /// Density per solid angle with which [`TriangleSampler::sample`] draws the direction to a
    /// point of the front of a triangle.
    pub fn pdf(&self, [viewpoint, n]: [Vec3; 2], face: u32, direction: Vec3, distance: f64) -> f64 {
        if let Some(rectangle) = &self.rectangle {
            let seen = rectangle.seen_from(viewpoint, n);
            return seen.map_or(0.0, |seen| rectangle.pdf(&seen, direction * distance));
        }
        let rank = self.rank[face as usize] as usize;
        let mut node = &self.nodes[0];
        let mut chosen = 1.0;
        while let Some(halves) = node.halves {
            let Some(shares) = self.shares(halves, viewpoint) else {
                return 0.0;
            };
            let half = usize::from(rank >= self.nodes[halves[1]].places.start);
            chosen *= shares[half];
            node = &self.nodes[halves[half]];
        }
        let solid_angles = self.solid_angles(node, viewpoint);
        let own = solid_angles[rank - node.places.start];
        // Nothing draws what is seen from behind, or from its plane.
        if own == 0.0 {
            return 0.0;
        }
        let chosen = chosen / solid_angles.iter().sum::<f64>();
        let [a, b, c] = self.corners[face as usize];
        let cross = (b - a).cross(c - a);
        chosen * density(own, cross, distance, direction)
    }

    /// Probabilities of two nodes; `None` if nothing of them can be seen from the front.
    fn shares(&self, halves: [usize; 2], viewpoint: Vec3) -> Option<[f64; 2]> {
        let seen = halves.map(|i| self.nodes[i].seen(viewpoint));
        let sum = seen[0] + seen[1];
        (sum > 0.0).then(|| seen.map(|x| x / sum))
    }

    fn solid_angles(&self, leaf: &Node, viewpoint: Vec3) -> [f64; LEAF] {
        let mut found = [0.0; LEAF];
        for (angle, &face) in found.iter_mut().zip(&self.order[leaf.places.clone()]) {
            let corners = self.corners[face as usize].map(|p| p - viewpoint);
            *angle = spherical_triangle::solid_angle(corners);
        }
        found
    }
}

/// How a triangle's point is sampled, as a density per solid angle times the solid angle
/// under which all of it is seen: 1, but for small triangles, whose points are uniform by
/// area. `cross` is the cross product of two of its sides.
fn density(solid_angle: f64, cross: Vec3, distance: f64, direction: Vec3) -> f64 {
    if solid_angle < SMALL {
        solid_angle * 2.0 * distance * distance / cross.dot(direction).abs()
    } else {
        1.0
    }
}

impl Node {
    /// Bounds of the triangles at these places.
    fn new(triangles: &[Triangle], places: Range<usize>) -> Self {
        let triangles = &triangles[places.clone()];
        let points = || triangles.iter().flat_map(|triangle| triangle.corners);
        let low = points().fold(Vec3::splat(f64::INFINITY), Vec3::min);
        let high = points().fold(Vec3::splat(f64::NEG_INFINITY), Vec3::max);
        let centre = (low + high) * 0.5;
        let squares = points().map(|p| (p - centre).length_squared());
        let radius = squares.fold(0.0, f64::max).sqrt();
        let vectors = triangles.iter().map(|triangle| triangle.vector_area);
        let vector_area = vectors.fold(Vec3::zero(), |sum, v| sum + v);
        let area = triangles.iter().map(|triangle| triangle.area).sum();
        // Any axis will do where directions cancel: the cone is all of them then.
        let axis = Some(vector_area.normalized()).filter(|axis| axis.is_finite());
        let axis = axis.unwrap_or(Vec3::new(0.0, 0.0, 1.0));
        // Triangles without area are never seen.
        let seen = triangles.iter().filter(|triangle| triangle.area > 0.0);
        let cos = seen.map(|triangle| axis.dot(triangle.vector_area) / triangle.area);
        let cos_spread = cos.fold(1.0, f64::min).max(-1.0);
        Self {
            places,
            halves: None,
            centre,
            radius,
            vector_area,
            area,
            axis,
            cos_spread,
            sin_spread: (1.0 - cos_spread * cos_spread).sqrt(),
        }
    }

    /// About the solid angle under which the front of its triangles is seen, steradians; 0 only if
    /// none of it is. Without a branch, for several viewpoints.
    #[inline(always)]
    pub fn seen(&self, viewpoint: Vec3) -> f64 {
        let offset = viewpoint - self.centre;
        let squared = offset.length_squared();
        let distance = squared.sqrt();
        // Bounds of the cosine between the normals and the way to the viewpoint: the cone of
        // normals, and for other points than the centre the ball.
        let cos = (self.axis.dot(offset) / distance).clamp(-1.0, 1.0);
        let sin = (1.0 - cos * cos).sqrt();
        let tilt = self.radius / distance;
        let highest = match cos >= self.cos_spread {
            true => 1.0,
            false => cos * self.cos_spread + sin * self.sin_spread + tilt,
        };
        let lowest = match cos <= -self.cos_spread {
            true => -1.0,
            false => cos * self.cos_spread - sin * self.sin_spread - tilt,
        };
        // From inside of the ball all directions are possible.
        let inside = 0.25 * self.area / (self.radius * self.radius).max(f64::MIN_POSITIVE);
        // All of it is seen from the front: its vector area is what is seen of it.
        let front = (self.vector_area.dot(offset) / distance).max(0.0) / squared;
        // The mean of what is above 0 if cosines are uniform between the bounds.
        let [most, least] = [highest.min(1.0), lowest.max(-1.0)];
        let partly = self.area * most * most / (2.0 * (most - least) * squared);
        let outside = if lowest >= 0.0 { front } else { partly };
        let outside = if highest <= 0.0 { 0.0 } else { outside };
        if distance <= self.radius {
            inside
        } else {
            outside
        }
    }
}

/// Adds the node of these places and all below it, and returns its number. Each node is
/// halved along the longest side of the box around its triangles' centres.
fn add_node(triangles: &mut [Triangle], places: Range<usize>, nodes: &mut Vec<Node>) -> usize {
    let number = nodes.len();
    nodes.push(Node::new(triangles, places.clone()));
    if places.len() > LEAF {
        let own = &mut triangles[places.clone()];
        let extent = |axis: usize| {
            let along = own.iter().map(|triangle| triangle.centre[axis]);
            let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
                (low.min(x), high.max(x))
            });
            high - low
        };
        let extents = [0, 1, 2].map(extent);
        let axis = (0..3).max_by(|&a, &b| extents[a].total_cmp(&extents[b]));
        let axis = axis.expect("three axes");
        let middle = places.len() / 2;
        own.select_nth_unstable_by(middle, |a, b| {
            let along = a.centre[axis].total_cmp(&b.centre[axis]);
            along.then(a.face.cmp(&b.face))
        });
        let middle = places.start + middle;
        let first = add_node(triangles, places.start..middle, nodes);
        let second = add_node(triangles, middle..places.end, nodes);
        nodes[number].halves = Some([first, second]);
    }
    number
}

#[cfg(test)]
mod tests {
    use capwalk_math::{Affine, Moments, sphere};
    use capwalk_scene::primitive::{cube, disk, rectangle, sphere as ball};

    use super::*;

    fn meshes() -> Vec<(&'static str, Mesh)> {
        let place = Affine::translate(Vec3::new(0.3, -0.2, 1.5))
            * Affine::rotate(Vec3::new(1.0, 0.4, -0.2), 2.6)
            * Affine::scale(Vec3::new(0.8, 0.5, 0.7));
        vec![
            ("rectangle", rectangle(place).0),
            ("disk", disk(place).0),
            ("cube", cube(place).0),
            (
                "ball",
                ball(Affine::IDENTITY, Vec3::new(0.3, -0.2, 1.5), 0.6).0,
            ),
        ]
    }

    /// Far, near, within the ball around some of them, nearly in a plane of the cube, and twice as far from
    /// a rectangle as its corners are from its middle.
    const VIEWPOINTS: [[f64; 3]; 7] = [
        [40.0, 10.0, -35.0],
        [0.2, 0.1, 0.2],
        [0.9, -0.3, 0.75],
        [-0.6, 0.4, 1.6],
        [0.5, -0.2, 3.0],
        [1.9, 1.2, 0.6],
        [-1.3, -1.6, 2.4],
    ];

    /// The `i`-th of points that fill the unit square evenly.
    fn numbers(i: i32) -> [f64; 2] {
        [0.754_877_666_246_692_8, 0.569_840_290_998_053_3].map(|k| (f64::from(i) * k).fract())
    }

    /// The integral of directions over a triangle on the sphere (Lambert).
    fn mean_direction(corners: [Vec3; 3]) -> Vec3 {
        let q = corners.map(Vec3::normalized);
        let sides = [(0, 1), (1, 2), (2, 0)].map(|(i, k)| {
            let angle = sphere::angle_between(q[i], q[k]);
            q[k].cross(q[i]).normalized() * (0.5 * angle)
        });
        sides.into_iter().fold(Vec3::zero(), |sum, side| sum + side)
    }

    /// Of surfaces that face away from a mesh, face it, and are tilted, nearly by a right angle the last.
    fn normals(towards: Vec3) -> [Vec3; 4] {
        let [front, across] = [
            towards.normalized(),
            towards.cross(Vec3::new(0.3, 0.9, -0.2)).normalized(),
        ];
        let turned = |angle: f64| front * angle.cos() + across * angle.sin();
        [-front, front, turned(1.2), turned(1.55)]
    }

    /// Over its density, a sample gives the solid angle of all that is seen from the front,
    /// and the integral of directions over it; and the density is what `pdf` says.
    #[test]
    fn samples_have_their_densities() {
        let cases = meshes().into_iter().flat_map(|(name, mesh)| {
            let viewpoints = VIEWPOINTS.map(Vec3::from).into_iter();
            let surfaces = viewpoints.flat_map(move |viewpoint| {
                let all = normals(Vec3::new(0.3, -0.2, 1.5) - viewpoint);
                // Nothing but rectangles depends on them.
                let count = if name == "rectangle" { all.len() } else { 1 };
                all.into_iter().take(count).map(move |n| [viewpoint, n])
            });
            surfaces.map(move |surface| (name, mesh.clone(), surface))
        });
        for (name, mesh, surface) in cases {
            let sampler = TriangleSampler::new(&mesh);
            let [viewpoint, _] = surface;
            let faces = (0..mesh.faces.len()).map(|face| mesh.corners(face));
            let seen = faces.map(|corners| corners.map(|p| p - viewpoint));
            let seen = seen.filter(|c| spherical_triangle::solid_angle(*c) > 0.0);
            let expected = seen.fold((0.0, Vec3::zero()), |(angle, sum), corners| {
                let own = spherical_triangle::solid_angle(corners);
                (angle + own, sum + mean_direction(corners))
            });
            let n = 100_000;
            let (mut angle, mut sum) = (0.0, Vec3::zero());
            for i in 0..n {
                let Some(point) = sampler.sample(surface, numbers(i)) else {
                    continue;
                };
                let distance = point.distance;
                assert!((point.direction.length() - 1.0).abs() < 1e-14);
                let position = viewpoint + point.direction * distance;
                let [a, b, c] = mesh.corners(point.face as usize);
                let [wb, wc] = point.barycentric;
                let mixed = a + (b - a) * wb + (c - a) * wc;
                assert!((mixed - position).length() < 1e-9 * distance, "{name}");
                let pdf = sampler.pdf(surface, point.face, point.direction, distance);
                assert!((pdf / point.pdf - 1.0).abs() < 1e-9, "{name}");
                let weight = 1.0 / (point.pdf * f64::from(n));
                angle += weight;
                sum += point.direction * weight;
            }
            let error = (angle - expected.0).abs() + (sum - expected.1).length();
            assert!(
                error <= 4e-3 * expected.0,
                "{name}, {viewpoint:?}: {error:e}"
            );
        }
    }

    /// What a surface receives from a rectangle differs little from point to point of it: less than where points
    /// are uniform by solid angle, and from behind there is none.
    #[test]
    fn far_rectangles_follow_what_is_received() {
        let (_, mesh) = meshes().swap_remove(0);
        let sampler = TriangleSampler::new(&mesh);
        let middle = Vec3::new(0.3, -0.2, 1.5);
        let away = Vec3::new(1.8, 0.5, -1.5);
        for distance in [2.6, 5.0, 20.0, 3000.0] {
            let viewpoint = middle + away.normalized() * distance;
            let up = Vec3::new(0.0, 0.0, 1.0);
            let seen = sampler.sample([viewpoint, up], [0.3, 0.6]);
            let behind = middle * 2.0 - viewpoint;
            let unseen = sampler.sample([behind, up], [0.3, 0.6]);
            let (viewpoint, seen) = match (seen, unseen) {
                (Some(point), None) => (viewpoint, point),
                (None, Some(point)) => (behind, point),
                _ => panic!("one of both is in front"),
            };
            let turn = |direction: Vec3| direction.cross(seen.direction).length();
            assert!(turn((middle - viewpoint).normalized()) < 0.5);
            let [away, front, tilted, _] = normals(middle - viewpoint);
            for n in [away, front, tilted] {
                let spread = |sample: &dyn Fn([f64; 2]) -> (Vec3, f64)| {
                    let mut received = Moments::default();
                    for i in 0..4000 {
                        let (direction, pdf) = sample(numbers(i));
                        // Where the surface faces away, the solid angle is followed.
                        let cos = if n == away { 1.0 } else { direction.dot(n) };
                        received.add(cos.max(0.0) / pdf);
                    }
                    received.variance().sqrt() / received.mean
                };
                let found = spread(&|u| {
                    let point = sampler.sample([viewpoint, n], u).expect("in front");
                    (point.direction, point.pdf)
                });
                let rectangle = &sampler.rectangle().expect("one").rectangle;
                let (by_angle, _) = rectangle.seen(viewpoint);
                let uniform = spread(&|u| {
                    let offset = rectangle.offset_to(by_angle.sample(u), by_angle.z);
                    (offset.normalized(), 1.0 / by_angle.solid_angle)
                });
                // What is left is of second order.
                let most = (0.3 * uniform).max(1.6 / (distance * distance));
                assert!(found < most, "{distance}, {n:?}: {found} of {uniform}");
            }
        }
    }

    /// From within its plane nothing of a rectangle is seen, and a normal that is not a number does no harm.
    #[test]
    fn far_rectangles_have_limits() {
        let (_, mesh) = meshes().swap_remove(0);
        let sampler = TriangleSampler::new(&mesh);
        let rectangle = &sampler.rectangle().expect("one").rectangle;
        for i in 0..100 {
            let [s, t] = numbers(i).map(|x| 40.0 * x + 3.0);
            let within = rectangle.corner + rectangle.sides[0] * s - rectangle.sides[1] * t;
            let up = rectangle.normal;
            assert!(sampler.sample([within, up], [0.3, 0.6]).is_none());
            let direction = (rectangle.corner - within).normalized();
            assert_eq!(sampler.pdf([within, up], 0, direction, 1.0), 0.0);
            let above = within + up * 2.0;
            let point = sampler.sample([above, Vec3::splat(f64::NAN)], [0.3, 0.6]);
            assert!(point.is_some_and(|point| point.direction.is_finite() && point.pdf > 0.0));
            let nowhere = Vec3::splat(f64::NAN);
            assert!(sampler.sample([nowhere, up], [0.3, 0.6]).is_none());
        }
    }

    /// Of a rectangle, from far away, all directions have nearly the same density, and of others roughly: sampled
    /// by area, a ball has a standard deviation of more than the mean.
    #[test]
    fn densities_are_nearly_uniform() {
        let mut seen = 0;
        for ((name, mesh), bound) in meshes().into_iter().zip([1e-3, 0.3, 0.9, 0.9]) {
            let sampler = TriangleSampler::new(&mesh);
            for viewpoint in VIEWPOINTS[..2].iter().map(|&p| Vec3::from(p)) {
                let away = (viewpoint - Vec3::new(0.3, -0.2, 1.5)).normalized();
                let mut weights = Moments::default();
                for i in 0..4000 {
                    let point = sampler.sample([viewpoint, away], numbers(i));
                    weights.add(point.map_or(0.0, |point| 1.0 / point.pdf));
                }
                // Some are seen from behind.
                if weights.mean == 0.0 {
                    continue;
                }
                seen += 1;
                let spread = weights.variance().sqrt() / weights.mean;
                println!("{name}: {spread}");
                assert!(spread <= bound, "{name}, {viewpoint:?}: {spread}");
            }
        }
        assert!(seen >= 6, "only {seen} of 8 are seen");
    }
}
