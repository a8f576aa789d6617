//! Queries per second on meshes of about 100,000 triangles, one thread, with
//! `obvhs` as a yardstick; and the time to build both trees.
//!
//! `cargo bench -p capwalk-geometry` runs criterion's measurements and then
//! prints tables of ratios, measured in two ways:
//!
//! - alone: one query for all views, in many rounds, then the next query. This
//!   is what criterion does, and its times are the same. The caches then hold
//!   the one tree of that query.
//! - in turn: the views in small batches, every query on a batch in turn. Before
//!   each, the same query runs on the batch before; still the trees of the other
//!   queries have been through the caches, as when a renderer traces rays and
//!   searches silhouettes by turns. Rays suffer more, so ratios are lower.
//!
//! A time is the sum over the batches of the medians over the rounds, so neither
//! a slow phase of the machine nor being interrupted counts for much. Slow
//! phases do count for one query only where it is measured alone.

mod meshes;
mod random;

use std::hint::black_box;
use std::time::{Duration, Instant};

use capwalk_geometry::{ConeQuery, EdgeSelection, Mesh, Ray, RayTree, SilhouetteTree, topology};
use capwalk_math::Vec3;
use criterion::{BenchmarkId, Criterion, Throughput};
use obvhs::BvhBuildParams;
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
use obvhs::ray::{Ray as YardstickRay, RayHit};
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;
use random::Random;

/// Views per scene.
const VIEWS: usize = 4096;
/// Views per batch: few, so that most batches are not interrupted.
const BATCH: usize = 512;
/// Rounds; odd, so that there is a median.
const ROUNDS: usize = 21;
/// Half-angle of the limited cones, radians.
const NARROW: f64 = 0.05;

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(20)
        .measurement_time(Duration::from_secs(2))
        .warm_up_time(Duration::from_millis(500))
        .configure_from_args();
    let scenes = [
        Scene::new("sphere", &meshes::bumpy_sphere(112)),
        Scene::new("lattice", &meshes::lattice([11, 11, 10])),
    ];
    for scene in &scenes {
        let mut group = criterion.benchmark_group(scene.name);
        group.throughput(Throughput::Elements(VIEWS as u64));
        for (name, query) in QUERIES {
            group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
                bencher.iter(|| query(scene, &scene.views));
            });
        }
        group.finish();
    }
    criterion.final_summary();
    // `cargo test` runs benches once, without measuring.
    if std::env::args().any(|argument| argument == "--bench") {
        scenes.iter().for_each(print_ratios);
        print_build_times();
    }
}

/// A mesh in all trees, and from where to look at it.
struct Scene {
    name: &'static str,
    triangles: usize,
    views: Vec<View>,
    ray_tree: RayTree,
    silhouette_tree: SilhouetteTree,
    yardstick: CwBvh,
    /// In the order of the yardstick's leaves.
    yardstick_triangles: Vec<RtTriangle>,
}

/// A viewpoint and a unit axis. The viewpoints lie around the mesh, evenly between 1.2 and
/// 3 times its radius; each looks at an even point within 1.1 times its radius,
/// so some look past it.
struct View {
    viewpoint: Vec3,
    axis: Vec3,
}

impl Scene {
    fn new(name: &'static str, mesh: &Mesh) -> Self {
        let corner = |p: Vec3| p.to_array().map(|v| v as f32).into();
        let triangles: Vec<Triangle> = (0..mesh.faces.len())
            .map(|face| {
                let [v0, v1, v2] = mesh.corners(face).map(corner);
                Triangle { v0, v1, v2 }
            })
            .collect();
        let mut time = Duration::default();
        let yardstick = build_cwbvh_from_tris(&triangles, BvhBuildParams::slow_build(), &mut time);
        let in_leaf_order = |&index: &u32| RtTriangle::from(&triangles[index as usize]);
        let mut random = Random::new(7);
        let views = (0..VIEWS).map(|_| {
            let viewpoint = random.direction() * (1.2 + 1.8 * random.unit());
            let target = random.direction() * (1.1 * random.unit().cbrt());
            View {
                viewpoint,
                axis: (target - viewpoint).normalized(),
            }
        });
        Self {
            name,
            triangles: mesh.faces.len(),
            views: views.collect(),
            ray_tree: RayTree::build(mesh),
            silhouette_tree: SilhouetteTree::build(mesh, &topology::edges(mesh)),
            yardstick_triangles: yardstick
                .primitive_indices
                .iter()
                .map(in_leaf_order)
                .collect(),
            yardstick,
        }
    }
}

/// A query for every one of the views; how many found something.
type Query = fn(&Scene, &[View]) -> usize;

const QUERIES: [(&str, Query); 5] = [
    ("first hit", first_hit),
    ("first hit, obvhs CwBvh", first_hit_yardstick),
    ("occluded", occluded),
    ("closest silhouette", closest_silhouette),
    ("closest silhouette within 0.05", closest_silhouette_nearby),
];

fn first_hit(scene: &Scene, views: &[View]) -> usize {
    count(views, |view| {
        scene
            .ray_tree
            .first_hit(&Ray::new(view.viewpoint, view.axis))
            .is_some()
    })
}

fn occluded(scene: &Scene, views: &[View]) -> usize {
    count(views, |view| {
        scene
            .ray_tree
            .occluded(&Ray::new(view.viewpoint, view.axis))
    })
}

fn first_hit_yardstick(scene: &Scene, views: &[View]) -> usize {
    count(views, |view| {
        let [viewpoint, axis] =
            [view.viewpoint, view.axis].map(|v| v.to_array().map(|c| c as f32).into());
        let ray = YardstickRay::new_inf(viewpoint, axis);
        let mut hit = RayHit::none();
        scene.yardstick.ray_traverse(ray, &mut hit, |ray, index| {
            scene.yardstick_triangles[index].intersect(ray)
        })
    })
}

fn closest_silhouette(scene: &Scene, views: &[View]) -> usize {
    count(views, |view| {
        closest_within(scene, view, std::f64::consts::PI)
    })
}

fn closest_silhouette_nearby(scene: &Scene, views: &[View]) -> usize {
    count(views, |view| closest_within(scene, view, NARROW))
}

fn closest_within(scene: &Scene, view: &View, max_angle: f64) -> bool {
    let query = ConeQuery {
        apex: view.viewpoint,
        axis: view.axis,
        max_angle,
        edges: EdgeSelection::Silhouettes,
        groups: u8::MAX,
        in_front_of: None,
    };
    scene.silhouette_tree.closest(&query).is_some()
}

fn count(views: &[View], found: impl Fn(&View) -> bool) -> usize {
    views.iter().filter(|view| found(black_box(view))).count()
}

fn print_ratios(scene: &Scene) {
    let found = QUERIES.map(|(_, query)| query(scene, &scene.views)); // also warms up
    let batches: Vec<&[View]> = scene.views.chunks(BATCH).collect();
    let alone = QUERIES.map(|(_, query)| {
        let mut times = vec![Vec::new(); batches.len()];
        for _ in 0..ROUNDS {
            for (batch, times) in batches.iter().zip(&mut times) {
                times.push(seconds(|| query(scene, batch)));
            }
        }
        time_per_view(times)
    });
    // times[query][batch], one for each round
    let mut times = QUERIES.map(|_| vec![Vec::new(); batches.len()]);
    for _ in 0..ROUNDS {
        for b in 0..batches.len() {
            let before = (b + batches.len() - 1) % batches.len();
            for ((_, query), times) in QUERIES.iter().zip(&mut times) {
                black_box(query(scene, batches[before]));
                times[b].push(seconds(|| query(scene, batches[b])));
            }
        }
    }
    let in_turn = times.map(time_per_view);
    println!(
        "\n{}: {} triangles, one thread",
        scene.name, scene.triangles
    );
    println!(
        "{:<30} {:>6} {:>9} {:>11} {:>11} {:>11}",
        "query", "found", "alone ns", "x first hit", "in turn ns", "x first hit"
    );
    for (i, (name, _)) in QUERIES.iter().enumerate() {
        let share = 100.0 * found[i] as f64 / VIEWS as f64;
        let [alone, in_turn] = [alone, in_turn].map(|times| (1e9 * times[i], times[i] / times[0]));
        println!(
            "{name:<30} {share:>5.0}% {:>9.0} {:>11.2} {:>11.0} {:>11.2}",
            alone.0, alone.1, in_turn.0, in_turn.1
        );
    }
}

fn seconds(run: impl FnOnce() -> usize) -> f64 {
    let start = Instant::now();
    black_box(run());
    start.elapsed().as_secs_f64()
}

/// From the times of each batch in all rounds.
fn time_per_view(batches: Vec<Vec<f64>>) -> f64 {
    batches.into_iter().map(median).sum::<f64>() / VIEWS as f64
}

fn print_build_times() {
    let mesh = meshes::bumpy_sphere(145);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(2)
        .build()
        .expect("two threads can be started");
    let mut times = vec![[0.0; 4]; 9];
    for round in &mut times {
        pool.install(|| {
            let start = Instant::now();
            let edges = black_box(topology::edges(&mesh));
            let topology = start.elapsed();
            black_box(RayTree::build(&mesh));
            let ray_tree = start.elapsed();
            let mut tree = black_box(SilhouetteTree::build(&mesh, &edges));
            let silhouette_tree = start.elapsed();
            let refit = Instant::now();
            tree.refit(&mesh);
            *round = [
                topology,
                ray_tree - topology,
                silhouette_tree - ray_tree,
                refit.elapsed(),
            ]
            .map(|time| time.as_secs_f64());
        });
    }
    let names = [
        "topology",
        "ray tree",
        "silhouette tree",
        "silhouette tree, refit",
    ];
    println!("\nbuilding for {} triangles, two threads", mesh.faces.len());
    for (i, name) in names.iter().enumerate() {
        let time = median(times.iter().map(|round| round[i]).collect());
        println!("{name:<34} {:>9.1} ms", 1e3 * time);
    }
    let total = median(times.iter().map(|round| round[..3].iter().sum()).collect());
    println!("{:<34} {:>9.1} ms", "all three", 1e3 * total);
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
