//! Cones on the device against brute force.

use std::f64::consts::PI;

use capwalk_geometry::edge::{Edge, ON_PLANE, Sides, closest_direction};
use capwalk_geometry::{
    ConeQuery, EdgeSelection, HalfSpace, Mesh, SilhouettePoint, SilhouetteTree, oracle, topology,
};
use capwalk_gpu::{DeviceSilhouetteTree, Gpu, Precision, SINGLE_ERROR};
use capwalk_math::Vec3;

use super::adapter;
use super::meshes::{self, Placed, Random};

/// Cones per mesh.
const CONES: usize = 300;

/// Error of angles by divisions and roots that are off by some ulp, radians.
const DOUBLE_ERROR: f64 = 1e-14;

pub fn cones(placed: &Placed, random: &mut Random, count: usize) -> Vec<ConeQuery> {
    let mut cones = Vec::new();
    while cones.len() < count {
        let apex = placed.spot(random);
        let axis = match random.below(3) {
            0 => random.direction(),
            _ => (placed.spot(random) - apex).normalized(),
        };
        if !axis.is_finite() {
            continue;
        }
        let max_angle = match random.below(8) {
            0..3 => PI,
            3..5 => 0.5 * random.number(),
            5 => 3.2 * random.number(),
            6 => 10_f64.powf(-3.0 - 5.0 * random.number()),
            _ => [0.0, -1.0, f64::NAN, f64::INFINITY][random.below(4)],
        };
        let is_cut = random.below(5) == 0;
        let plane = HalfSpace {
            point: placed.spot(random),
            normal: random.point() * 3.0,
        };
        cones.push(ConeQuery {
            apex,
            axis,
            max_angle,
            edges: match random.below(4) {
                0 => EdgeSelection::All,
                _ => EdgeSelection::Silhouettes,
            },
            groups: [u8::MAX, 1, 6][random.below(3)],
            in_front_of: is_cut.then_some(plane),
        });
    }
    cones
}

/// The edges of a mesh, in several groups.
pub fn edges_of(mesh: &Mesh) -> Vec<Edge> {
    let mut edges = topology::edges(mesh);
    for (i, edge) in edges.iter_mut().enumerate() {
        edge.groups = [1, 2, 4, u8::MAX][i % 4];
    }
    edges
}

/// What brute force knows of an edge seen from a cone's apex, within an error.
struct Seen {
    /// The angle of its closest point.
    angle: f64,
    /// By how much that can be off.
    error: f64,
    /// It is a boundary for certain, or it may be one.
    is_certain: bool,
    is_possible: bool,
}

/// By how much everything may be off, distances in the world.
#[derive(Clone, Copy)]
struct Errors {
    /// Positions.
    position: f64,
    /// Heights of the apex over the plane of a face, where it counts as in the plane.
    plane: f64,
}

fn seen(mesh: &Mesh, edge: &Edge, query: &ConeQuery, errors: Errors) -> Option<Seen> {
    let error = errors.position;
    let ends = edge.vertices.map(|i| mesh.positions[i as usize]);
    let [a, b] = ends.map(|p| p - query.apex);
    let Some(closest) = closest_direction(a, b, query.axis) else {
        // It passes through the apex; in single precision perhaps beside it, then anywhere.
        return (error > 0.0).then_some(Seen {
            angle: 0.0,
            error: PI,
            is_certain: false,
            is_possible: true,
        });
    };
    let along = b - a;
    let t = (-a.dot(along) / along.length_squared()).clamp(0.0, 1.0);
    let nearest = (a + along * t).length();
    let heights =
        |plane: &HalfSpace| ends.map(|p| (p - plane.point).dot(plane.normal.normalized()));
    let in_front = |at_least: f64| {
        query
            .in_front_of
            .is_none_or(|plane| heights(&plane).into_iter().any(|height| height >= at_least))
    };
    // Far enough from the planes of both faces to be sure which side is seen?
    let is_clear = match edge.sides {
        Sides::Open => true,
        Sides::Between { faces, .. } => faces.iter().all(|&face| {
            let normal = mesh.face_cross(face as usize).normalized();
            [a, b]
                .into_iter()
                .all(|end| normal.dot(end).abs() > errors.plane)
        }),
    };
    let counts = query.edges == EdgeSelection::All || edge.is_silhouette(mesh, query.apex);
    let in_groups = edge.groups & query.groups != 0;
    Some(Seen {
        angle: closest.angle,
        error: DOUBLE_ERROR + if error < nearest { error / nearest } else { PI },
        is_certain: in_groups && counts && in_front(error),
        is_possible: in_groups && (counts || !is_clear) && in_front(-error),
    })
}

fn errors_of(gpu: &Gpu, tree: &SilhouetteTree, query: &ConeQuery) -> Errors {
    let frame = tree.buffers().frame;
    match gpu.precision() {
        Precision::Double if adapter::is_exact(gpu) => Errors {
            position: 0.0,
            plane: 0.0,
        },
        // Fused products move what is tested by some ulp.
        Precision::Double => {
            let sum = |p: Vec3| p.x.abs() + p.y.abs() + p.z.abs();
            let reach = sum(query.apex) + frame.reach;
            Errors {
                position: 8.0 * f64::EPSILON * reach,
                plane: 2.0 * ON_PLANE * reach,
            }
        }
        Precision::Single => {
            let sum = |p: Vec3| p.x.abs() + p.y.abs() + p.z.abs();
            let apex = frame.local_from_world(query.apex);
            let position = SINGLE_ERROR * (sum(apex) + 3.0) * frame.scale;
            Errors {
                position,
                plane: position + ON_PLANE * (sum(query.apex) + frame.reach),
            }
        }
    }
}

/// The answer is a boundary's closest point, and no boundary is nearer.
fn check_closest(
    mesh: &Mesh,
    edges: &[Edge],
    query: &ConeQuery,
    errors: Errors,
    found: Option<SilhouettePoint>,
) -> Result<(), String> {
    let angle = found.map_or(query.max_angle, |point| point.angle);
    if let Some(point) = found {
        let edge = seen(mesh, &edges[point.edge as usize], query, errors)
            .ok_or("an edge through the apex")?;
        if !edge.is_possible {
            return Err(format!("edge {} does not count", point.edge));
        }
        if (edge.angle - angle).abs() > edge.error || angle >= query.max_angle {
            return Err(format!(
                "its angle is {}, not {angle}, allowed {:e}",
                edge.angle, edge.error
            ));
        }
        let size = (point.direction.length() - 1.0).abs();
        if size > 1e-12 || !(0.0..=1.0).contains(&point.t) {
            return Err(format!("{point:?}"));
        }
    }
    for (i, edge) in edges.iter().enumerate() {
        let Some(edge) = seen(mesh, edge, query, errors) else {
            continue;
        };
        if edge.is_certain && edge.angle + edge.error < angle {
            return Err(format!(
                "edge {i} is nearer: {} by {:e}",
                edge.angle,
                angle - edge.angle
            ));
        }
    }
    Ok(())
}

/// All boundaries in the cone but those at its very rim.
fn check_gathered(
    mesh: &Mesh,
    edges: &[Edge],
    query: &ConeQuery,
    errors: Errors,
    found: &[u32],
) -> Result<(), String> {
    let mut is_found = vec![false; edges.len()];
    for &edge in found {
        if std::mem::replace(&mut is_found[edge as usize], true) {
            return Err(format!("edge {edge} twice"));
        }
    }
    for (i, edge) in edges.iter().enumerate() {
        let edge = seen(mesh, edge, query, errors);
        let (may, must) = edge.map_or((false, false), |edge| {
            let may = edge.is_possible && edge.angle - edge.error < query.max_angle;
            let must = edge.is_certain && edge.angle + edge.error < query.max_angle;
            (may, must)
        });
        if is_found[i] && !may || !is_found[i] && must {
            return Err(format!(
                "edge {i}: found {}, may {may}, must {must}",
                is_found[i]
            ));
        }
    }
    Ok(())
}

/// Compares the answers with brute force, and returns how many silhouettes are found, and how
/// many of them are those of brute force to the last bit. `tree` is what the device's should be.
pub fn check(
    gpu: &Gpu,
    placed: &Placed,
    edges: &[Edge],
    tree: &SilhouetteTree,
    device: &DeviceSilhouetteTree,
    cones: &[ConeQuery],
) -> [usize; 2] {
    let points = device.closest(cones).expect("answers");
    assert_eq!(
        device.closest(cones).expect("answers"),
        points,
        "a second time"
    );
    let gathered = device.gather(cones, 16).expect("answers");
    assert_eq!(
        device.gather(cones, 16).expect("answers"),
        gathered,
        "a second time"
    );
    let (mesh, name) = (&placed.mesh, &placed.name);
    let (mut found, mut same) = (0, 0);
    let mut larger = 0;
    for (i, query) in cones.iter().enumerate() {
        let errors = errors_of(gpu, tree, query);
        let right = check_closest(mesh, edges, query, errors, points[i]);
        let expected = oracle::closest_silhouette(mesh, edges, query);
        assert!(
            right.is_ok(),
            "{name}: {right:?}: {:?}, expected {expected:?} of {query:?}",
            points[i]
        );
        found += usize::from(points[i].is_some());
        same += usize::from(points[i].is_some() && points[i] == expected);
        let right = check_gathered(mesh, edges, query, errors, gathered.of(i));
        assert!(right.is_ok(), "{name}: {right:?} of {query:?}");
        larger += usize::from(gathered.of(i).len() > 16);
    }
    assert_eq!(gathered.overflowed(), larger, "{name}");
    [found, same]
}

/// The closest silhouettes and all in a cone, wherever meshes are and however large; also
/// after vertices moved.
#[test]
fn cones_find_what_brute_force_finds() {
    adapter::each(|gpu| {
        let mut random = Random(11);
        let mut counts = [0; 2];
        let mut asked = 0;
        for mut placed in meshes::all() {
            let edges = edges_of(&placed.mesh);
            let mut tree = SilhouetteTree::build(&placed.mesh, &edges);
            let mut device = DeviceSilhouetteTree::new(gpu, &tree).expect("enough memory");
            let some = cones(&placed, &mut random, CONES);
            let first = check(gpu, &placed, &edges, &tree, &device, &some);
            for p in &mut placed.mesh.positions {
                *p += random.point() * (0.05 * placed.size);
            }
            tree.refit(&placed.mesh);
            let some = cones(&placed, &mut random, CONES / 4);
            device.refit(&placed.mesh).expect("enough memory");
            let second = check(gpu, &placed, &edges, &tree, &device, &some);
            counts = [0, 1].map(|i| counts[i] + first[i] + second[i]);
            asked += CONES + CONES / 4;
        }
        let [found, same] = counts;
        assert!(
            found > asked / 3,
            "{found} silhouettes of {asked} cones prove little"
        );
        if gpu.precision() == Precision::Double && adapter::is_exact(gpu) {
            assert!(
                same * 1000 > found * 995,
                "only {same} of {found} to the last bit"
            );
        }
    });
}

/// From so far away that squares and cubes of distances leave single precision.
#[test]
fn far_apexes() {
    adapter::each(|gpu| {
        let mut random = Random(13);
        let placed = meshes::all().swap_remove(0);
        let edges = edges_of(&placed.mesh);
        let tree = SilhouetteTree::build(&placed.mesh, &edges);
        let centre = placed.spot(&mut random);
        let mut far = Vec::new();
        for exponent in [6, 10, 12, 13, 14, 16, 18, 19, 20, 25, 30] {
            for side in 0..6 {
                let towards = random.direction();
                let apex = centre - towards * (placed.size * 10_f64.powi(exponent));
                // At the mesh, across, away, and in between.
                let across = towards.cross(random.direction()).normalized();
                let axis = match side {
                    0 => towards,
                    1 => across,
                    2 => -towards,
                    3 => (towards + across * 0.5).normalized(),
                    4 => (across - towards * 0.5).normalized(),
                    _ => (towards + across * 1e-3).normalized(),
                };
                far.push(ConeQuery {
                    apex,
                    axis,
                    max_angle: [PI, 2.5, 0.5][side % 3],
                    edges: EdgeSelection::Silhouettes,
                    groups: u8::MAX,
                    in_front_of: None,
                });
            }
        }
        let device = DeviceSilhouetteTree::new(gpu, &tree).expect("enough memory");
        let [found, _] = check(gpu, &placed, &edges, &tree, &device, &far);
        assert!(found > far.len() / 2, "{found} of {} cones", far.len());
    });
}

/// Any number of cones, and any capacity: what does not fit is found in a second pass.
#[test]
fn batches_of_any_size() {
    adapter::each(|gpu| {
        let mut random = Random(12);
        let placed = meshes::all().swap_remove(0);
        let edges = edges_of(&placed.mesh);
        let tree = SilhouetteTree::build(&placed.mesh, &edges);
        let device = DeviceSilhouetteTree::new(gpu, &tree).expect("enough memory");
        let many = cones(&placed, &mut random, 9_000);
        let whole = device.closest(&many).expect("answers");
        for count in [0, 1, 63, 64, 65, 1000] {
            assert_eq!(
                device.closest(&many[..count]).expect("answers"),
                whole[..count],
                "{count}"
            );
        }
        let some = &many[..1000];
        let whole = device.gather(some, usize::MAX).expect("answers");
        assert_eq!(whole.overflowed(), 0);
        for capacity in [0, 1, 7, 100] {
            let cut = device.gather(some, capacity).expect("answers");
            let larger = (0..some.len())
                .filter(|&i| whole.of(i).len() > capacity)
                .count();
            assert_eq!(cut.overflowed(), larger);
            assert!(
                (0..some.len()).all(|i| cut.of(i) == whole.of(i)),
                "capacity {capacity}"
            );
        }
        assert_eq!(device.gather(&[], 5).expect("answers").overflowed(), 0);
    });
}

/// A tree without edges answers nothing.
#[test]
fn empty_tree() {
    adapter::each(|gpu| {
        let tree = SilhouetteTree::build(&Mesh::default(), &[]);
        let device = DeviceSilhouetteTree::new(gpu, &tree).expect("enough memory");
        let query = ConeQuery {
            apex: Vec3::zero(),
            axis: Vec3::new(0.0, 0.0, 1.0),
            max_angle: PI,
            edges: EdgeSelection::All,
            groups: u8::MAX,
            in_front_of: None,
        };
        assert_eq!(device.closest(&[query; 3]).expect("answers"), vec![None; 3]);
        assert_eq!(
            device.gather(&[query; 3], 4).expect("answers").of(2),
            [0_u32; 0]
        );
    });
}
