//! Which faces of a mesh cross each other.
//!
//! Two faces cross if an edge of one passes through the inside of the other, or if
//! they lie in one plane and overlap. Faces that merely touch, at common vertices
//! and edges above all, do not. Signs of determinants are exact.

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;
use robust::{Coord, Coord3D, orient2d, orient3d};

/// The first two faces that cross, in the order of the first and then the second;
/// `None` if there are none.
pub fn first_crossing(mesh: &Mesh) -> Option<[usize; 2]> {
    let boxes: Vec<_> = (0..mesh.faces.len()).map(|f| bounds(mesh, f)).collect();
    let (low, high) = mesh.bounds();
    let axis = longest_axis(high - low);
    // Sweep and prune (Cohen et al. 1995): along one axis, only faces whose
    // intervals overlap are compared.
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|&a, &b| boxes[a].0[axis].total_cmp(&boxes[b].0[axis]));
    let mut first: Option<[usize; 2]> = None;
    for (place, &a) in order.iter().enumerate() {
        let end = boxes[a].1[axis];
        let overlapping = order[place + 1..].iter();
        for &b in overlapping.take_while(|&&b| boxes[b].0[axis] <= end) {
            let pair = [a.min(b), a.max(b)];
            let is_earlier = first.is_none_or(|first| pair < first);
            if is_earlier && overlap(boxes[a], boxes[b]) && faces_cross(mesh, pair) {
                first = Some(pair);
            }
        }
    }
    first
}

/// Smallest and largest coordinates of a face.
fn bounds(mesh: &Mesh, face: usize) -> (Vec3, Vec3) {
    let [a, b, c] = mesh.corners(face);
    (a.min(b).min(c), a.max(b).max(c))
}

fn overlap((low_a, high_a): (Vec3, Vec3), (low_b, high_b): (Vec3, Vec3)) -> bool {
    (0..3).all(|axis| low_a[axis] <= high_b[axis] && low_b[axis] <= high_a[axis])
}

fn longest_axis(extent: Vec3) -> usize {
    let longest = |a: &usize, b: &usize| extent[*a].total_cmp(&extent[*b]);
    (0..3).max_by(longest).unwrap_or(0)
}

fn faces_cross(mesh: &Mesh, [a, b]: [usize; 2]) -> bool {
    let (a, b) = (mesh.corners(a), mesh.corners(b));
    if b.iter().all(|&p| side(a, p) == 0.0) {
        return overlap_in_plane(a, b);
    }
    let edges = |[p, q, r]: [Vec3; 3]| [[p, q], [q, r], [r, p]];
    edges(a).iter().any(|&edge| passes(edge, b)) || edges(b).iter().any(|&edge| passes(edge, a))
}

/// On which side of the plane of a triangle a point lies; 0 in the plane, and
/// everywhere for triangles without area.
fn side([a, b, c]: [Vec3; 3], p: Vec3) -> f64 {
    let [a, b, c, p] = [a, b, c, p].map(|Vec3 { x, y, z }| Coord3D { x, y, z });
    orient3d(a, b, c, p)
}

/// True if a segment passes through the inside of a triangle.
fn passes([p, q]: [Vec3; 2], triangle: [Vec3; 3]) -> bool {
    let [from, to] = [p, q].map(|end| side(triangle, end));
    // Signs, not their product: it may underflow.
    if from == 0.0 || to == 0.0 || (from > 0.0) == (to > 0.0) {
        return false;
    }
    let [a, b, c] = triangle;
    let turns = [[a, b], [b, c], [c, a]].map(|[s, t]| side([p, q, s], t));
    turns.iter().all(|&turn| turn > 0.0) || turns.iter().all(|&turn| turn < 0.0)
}

/// True if the insides of two triangles in one plane overlap: no line along a side
/// of one has the other one beyond it.
fn overlap_in_plane(a: [Vec3; 3], b: [Vec3; 3]) -> bool {
    let normal = (a[1] - a[0]).cross(a[2] - a[0]).map(f64::abs);
    let away = longest_axis(normal);
    let flat = |p: Vec3| Coord {
        x: p[(away + 1) % 3],
        y: p[(away + 2) % 3],
    };
    let (a, b) = (a.map(flat), b.map(flat));
    let separated = |[p, q, r]: [Coord<f64>; 3], other: [Coord<f64>; 3]| {
        let inside = orient2d(p, q, r).signum();
        let beyond = |s, t| other.iter().all(|&x| orient2d(s, t, x) * inside <= 0.0);
        beyond(p, q) || beyond(q, r) || beyond(r, p)
    };
    let has_area = |[p, q, r]: [Coord<f64>; 3]| orient2d(p, q, r) != 0.0;
    has_area(a) && has_area(b) && !separated(a, b) && !separated(b, a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_diff::{Purpose, Seed};

    fn mesh(positions: &[[f64; 3]], faces: &[[u32; 3]]) -> Mesh {
        Mesh {
            positions: positions.iter().map(|&p| p.into()).collect(),
            faces: faces.to_vec(),
        }
    }

    /// All pairs.
    fn brute_force(mesh: &Mesh) -> Option<[usize; 2]> {
        let count = mesh.faces.len();
        let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| [a, b]));
        let mut pairs = pairs;
        pairs.find(|&pair| faces_cross(mesh, pair))
    }

    /// Two triangles that share one vertex, an edge or nothing.
    #[test]
    fn touching_is_not_crossing() {
        let square = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
        ];
        assert_eq!(
            first_crossing(&mesh(&square, &[[0, 1, 2], [0, 2, 3]])),
            None
        );
        let folded = mesh(&square, &[[0, 1, 2], [0, 1, 3]]);
        assert_eq!(first_crossing(&folded), Some([0, 1]));
        let mut points = square.to_vec();
        points.extend([[0.6, 0.3, -1.0], [0.6, 0.3, 1.0], [3.0, 0.0, 0.0]]);
        let through = mesh(&points, &[[0, 1, 2], [4, 5, 6]]);
        assert_eq!(first_crossing(&through), Some([0, 1]));
        let at_a_corner = mesh(&points, &[[0, 1, 2], [0, 4, 5]]);
        assert_eq!(first_crossing(&at_a_corner), Some([0, 1]), "an edge passes");
        points.push([-0.6, -0.3, 1.0]);
        let beside = mesh(&points, &[[0, 1, 2], [0, 7, 5]]);
        assert_eq!(first_crossing(&beside), None);
        let in_plane = mesh(
            &[
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [0.2, 0.2, 0.0],
                [2.0, 0.2, 0.0],
                [2.0, 2.0, 0.0],
            ],
            &[[0, 1, 2], [3, 4, 5]],
        );
        assert_eq!(first_crossing(&in_plane), Some([0, 1]));
    }

    /// Of random triangles, few and many, and in a plane.
    #[test]
    fn sweeping_is_brute_force() {
        let mut state = 1_u64;
        let mut number = || {
            state = Seed(state).of_iteration(0, 0, Purpose::Image).0;
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let (mut crossing, mut free) = (0, 0);
        for case in 0..400 {
            let (count, size) = (2 + case % 24, 0.05 + 0.5 * number());
            let flat = case % 5 == 0;
            let mut random = Mesh::default();
            for i in 0..count {
                let centre = Vec3::new(number(), number(), number());
                for _ in 0..3 {
                    let offset = Vec3::new(number(), number(), number());
                    let mut p = centre + (offset - Vec3::splat(0.5)) * size;
                    p.z = if flat { 0.25 } else { p.z };
                    random.positions.push(p);
                }
                random.faces.push([3 * i, 3 * i + 1, 3 * i + 2]);
            }
            let expected = brute_force(&random);
            assert_eq!(first_crossing(&random), expected, "{case}");
            match expected {
                Some(_) => crossing += 1,
                None => free += 1,
            }
        }
        assert!(crossing > 50 && free > 50, "{crossing} {free}");
    }

    /// Closed meshes are free of crossings until a vertex is pushed through the
    /// other side.
    #[test]
    fn a_pushed_vertex_comes_out_behind() {
        let scene = crate::variable::tests::ball();
        let ball = scene.shapes.iter().find(|shape| shape.id == "ball");
        let mut mesh = ball.expect("a ball").mesh.clone();
        assert_eq!(first_crossing(&mesh), None);
        let centre = Vec3::new(0.03, 0.66, 0.04);
        let vertex = mesh.positions[0];
        mesh.positions[0] = centre + (centre - vertex) * 0.9;
        assert_eq!(first_crossing(&mesh), None, "not yet through");
        mesh.positions[0] = centre + (centre - vertex) * 1.2;
        let found = first_crossing(&mesh).expect("it is through");
        assert_eq!(Some(found), brute_force(&mesh));
        assert!(found.iter().any(|&face| mesh.faces[face].contains(&0)));
    }
}
