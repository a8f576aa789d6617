//! Queries per second on the adapter that is found, through each interface that reaches it
//! and in both precisions, beside the CPU's own, with how far the answers agree:
//! what the tables of docs/benchmarks.md are made of.
//!
//! `cargo xtask gpu [ADAPTER]`, where part of an adapter's name chooses it. The meshes are
//! bumpy spheres of 100,352 triangles and of 871,200, as many as the Stanford dragon has; the
//! views come from around them, as in the benchmark of `capwalk-geometry`. Times are of the
//! kernels alone, and of whole batches with the preparation and the upload of the queries
//! and the way of the answers back; the CPU's are of one thread.

use std::f64::consts::PI;
use std::fmt::Debug;
use std::ops::ControlFlow;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::{Duration, Instant};

use capwalk_geometry::{
    ConeQuery, EdgeSelection, Hit, Mesh, Ray, RayTree, SilhouettePoint, SilhouetteTree, topology,
};
use capwalk_gpu::{
    DeviceRayTree, DeviceSilhouetteTree, Gpu, GpuError, GpuOptions, Interface, Precision,
};
use capwalk_math::Vec3;

/// Splits of each edge of an octahedron: `8 n²` triangles.
const SPLITS: [u32; 2] = [112, 330];
/// Queries of a batch, on a GPU and in software.
const COUNTS: [usize; 2] = [1 << 20, 1 << 13];
/// Answers that are compared with the CPU's.
const COMPARED: usize = 1 << 16;
/// Half-angle of the limited cones, radians.
const NARROW: f64 = 0.05;
/// Half the width of the image whose points are shaded, at unit distance.
const FIELD: f64 = 0.45;
/// Room for so many edges of each limited cone.
const CAPACITY: usize = 64;
/// Batches; the fastest counts.
const ROUNDS: usize = 5;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), GpuError> {
    let mut options = GpuOptions::default();
    options.adapter = std::env::args().nth(1);
    let mut gpus = Vec::new();
    let mut missing = None;
    for interface in [Interface::Wgpu, Interface::Cuda] {
        for precision in [Precision::Double, Precision::Single] {
            options.interface = Some(interface);
            options.precision = Some(precision);
            match Gpu::new(&options) {
                Ok(gpu) => gpus.push(Arc::new(gpu)),
                Err(error) => {
                    println!("{interface:?}, {precision:?}: left out, {error}");
                    missing = Some(error);
                }
            }
        }
    }
    if let (true, Some(error)) = (gpus.is_empty(), missing) {
        return Err(error);
    }
    let count = COUNTS[usize::from(gpus.iter().all(|gpu| gpu.is_software()))];
    for splits in SPLITS {
        let own = Own::new(bumpy_sphere(splits), count);
        for gpu in &gpus {
            match measure(gpu, &own) {
                // As for the large mesh in software.
                Err(error @ GpuError::TreeTooLarge { .. }) => println!("Left out: {error}"),
                measured => measured?,
            }
        }
    }
    Ok(())
}

/// The trees, the queries, and the CPU's answers to the first of them.
struct Own {
    mesh: Mesh,
    ray_tree: RayTree,
    edge_tree: SilhouetteTree,
    rays: Vec<Ray>,
    all: Vec<ConeQuery>,
    narrow: Vec<ConeQuery>,
    shaded: Vec<ConeQuery>,
    hits: Timed<Option<Hit>>,
    occluded: Timed<bool>,
    closest: [Timed<Option<SilhouettePoint>>; 3],
    gathered: Timed<Vec<u32>>,
}

/// Answers, and the CPU's time for them.
type Timed<T> = (Duration, Vec<T>);

impl Own {
    fn new(mesh: Mesh, count: usize) -> Self {
        let ray_tree = RayTree::build(&mesh);
        let edge_tree = SilhouetteTree::build(&mesh, &topology::edges(&mesh));
        let rays = views(count);
        let cones = |rays: &[Ray], max_angle: f64| -> Vec<ConeQuery> {
            let cone = |ray: &Ray| ConeQuery {
                apex: ray.origin,
                axis: ray.direction,
                max_angle,
                edges: EdgeSelection::Silhouettes,
                groups: u8::MAX,
                in_front_of: None,
            };
            rays.iter().map(cone).collect()
        };
        let (all, narrow) = (cones(&rays, PI), cones(&rays, NARROW));
        let shaded = cones(&towards_light(&ray_tree, count), PI);
        let gather = |cone: &ConeQuery| {
            let mut edges = Vec::new();
            edge_tree.gather(cone, None, |edge, _| {
                edges.push(edge);
                ControlFlow::Continue(())
            });
            edges.sort_unstable();
            edges
        };
        Self {
            hits: timed(&rays, |ray| ray_tree.first_hit(ray)),
            occluded: timed(&rays, |ray| ray_tree.occluded(ray)),
            closest: [&all, &narrow, &shaded]
                .map(|cones| timed(cones, |cone| edge_tree.closest(cone))),
            gathered: timed(&narrow, gather),
            mesh,
            ray_tree,
            edge_tree,
            rays,
            all,
            narrow,
            shaded,
        }
    }
}

/// The CPU's answers to the first queries.
fn timed<Q, A>(queries: &[Q], answer: impl Fn(&Q) -> A) -> Timed<A> {
    let some = &queries[..queries.len().min(COMPARED)];
    let started = Instant::now();
    let answers = some.iter().map(answer).collect();
    (started.elapsed(), answers)
}

fn measure(gpu: &Arc<Gpu>, own: &Own) -> Result<(), GpuError> {
    println!(
        "\n{} ({}) through {:?}, {} triangles, {} queries, {:?} precision{}\n",
        gpu.name(),
        gpu.driver().trim(),
        gpu.interface(),
        own.mesh.faces.len(),
        own.rays.len(),
        gpu.precision(),
        match gpu.is_software() {
            true => ".\nThis adapter is software: no figure is from hardware",
            false => "",
        },
    );
    let device_rays = DeviceRayTree::new(gpu, &own.ray_tree)?;
    let device_edges = DeviceSilhouetteTree::new(gpu, &own.edge_tree)?;
    println!(
        "| query | kernel, million per second | x first hit | whole call | CPU | \
         equal to the bit | off by at most |"
    );
    println!("|---|---|---|---|---|---|---|");
    let mut table = Table {
        count: own.rays.len(),
        first_hit: None,
    };
    let found = fastest(gpu, || device_rays.first_hits(&own.rays))?;
    table.row("first hit", &found, &own.hits, |a, b| {
        Some((a.as_ref()?.t - b.as_ref()?.t).abs())
    });
    let found = fastest(gpu, || device_rays.occluded(&own.rays))?;
    table.row("occluded", &found, &own.occluded, |a, b| {
        (a == b).then_some(0.0)
    });
    let names = [
        "closest silhouette",
        "closest silhouette within 0.05",
        "closest silhouette, from an image's points to a light",
    ];
    for ((name, cones), expected) in names
        .into_iter()
        .zip([&own.all, &own.narrow, &own.shaded])
        .zip(&own.closest)
    {
        let found = fastest(gpu, || device_edges.closest(cones))?;
        table.row(name, &found, expected, |a, b| {
            Some((a.as_ref()?.angle - b.as_ref()?.angle).abs())
        });
    }
    let found = fastest(gpu, || device_edges.gather(&own.narrow, CAPACITY))?;
    let overflowed = found.answers.overflowed();
    let sorted = |i: usize| {
        let mut edges = found.answers.of(i).to_vec();
        edges.sort_unstable();
        edges
    };
    let found = Fastest {
        kernels: found.kernels,
        whole: found.whole,
        answers: (0..own.gathered.1.len()).map(sorted).collect::<Vec<_>>(),
    };
    table.row(
        "all silhouettes within 0.05",
        &found,
        &own.gathered,
        |a, b| (a == b).then_some(0.0),
    );
    println!("\nOf the last, {overflowed} met more than {CAPACITY} edges and were asked twice.");
    refits(gpu, own, device_rays, device_edges)
}

/// How long it takes to follow vertices, and how the queries' times change with bounds from the
/// device.
fn refits(
    gpu: &Gpu,
    own: &Own,
    mut device_rays: DeviceRayTree,
    mut device_edges: DeviceSilhouetteTree,
) -> Result<(), GpuError> {
    let milliseconds = |time: Duration| time.as_secs_f64() * 1e3;
    println!("\n| refit | kernels, ms | whole call, ms | CPU, ms |\n|---|---|---|---|");
    let row = |name: &str, refit: &mut dyn FnMut() -> Result<(), GpuError>, own: Duration| {
        let found = fastest(gpu, refit)?;
        println!(
            "| {name} | {:.2} | {:.2} | {:.2} |",
            milliseconds(found.kernels),
            milliseconds(found.whole),
            milliseconds(own)
        );
        Ok(())
    };
    let (mut ray_tree, mut edge_tree) = (own.ray_tree.clone(), own.edge_tree.clone());
    let started = Instant::now();
    ray_tree.refit(&own.mesh);
    let of_rays = started.elapsed();
    row("triangles", &mut || device_rays.refit(&own.mesh), of_rays)?;
    let started = Instant::now();
    edge_tree.refit(&own.mesh);
    let of_edges = started.elapsed();
    row("edges", &mut || device_edges.refit(&own.mesh), of_edges)?;
    let hits = fastest(gpu, || device_rays.first_hits(&own.rays))?;
    let closest = fastest(gpu, || device_edges.closest(&own.all))?;
    println!(
        "\nAfter that, kernels take {:.2} ms for the first hits and {:.2} ms for the closest silhouettes.",
        milliseconds(hits.kernels),
        milliseconds(closest.kernels)
    );
    Ok(())
}

/// The rows so far.
struct Table {
    count: usize,
    first_hit: Option<Duration>,
}

impl Table {
    /// `difference` is that of two answers; `None` where they are not of one kind.
    fn row<T: PartialEq + Debug>(
        &mut self,
        name: &str,
        found: &Fastest<Vec<T>>,
        (own, expected): &Timed<T>,
        difference: impl Fn(&T, &T) -> Option<f64>,
    ) {
        let first_hit = *self.first_hit.get_or_insert(found.kernels);
        let rate = |count: usize, time: Duration| count as f64 / time.as_secs_f64() * 1e-6;
        let pairs = || found.answers.iter().zip(expected);
        let same = pairs().filter(|(a, b)| a == b).count();
        let different = || pairs().filter(|(a, b)| a != b);
        let unlike = different()
            .filter(|(a, b)| difference(a, b).is_none())
            .count();
        let most = different()
            .filter_map(|(a, b)| difference(a, b))
            .fold(0.0, f64::max);
        let off = match unlike {
            0 => format!("{most:.1e}"),
            _ => format!("{most:.1e}; {unlike} otherwise"),
        };
        println!(
            "| {name} | {:.3} | {:.2} | {:.3} | {:.3} | {:.2} % | {off} |",
            rate(self.count, found.kernels),
            found.kernels.as_secs_f64() / first_hit.as_secs_f64(),
            rate(self.count, found.whole),
            rate(expected.len(), *own),
            100.0 * same as f64 / expected.len() as f64,
        );
    }
}

/// Answers, and the least times of some rounds, of the kernels alone and with all else.
struct Fastest<T> {
    kernels: Duration,
    whole: Duration,
    answers: T,
}

/// After one round that compiles the kernel and finds how many queries a launch should have.
fn fastest<T>(
    gpu: &Gpu,
    mut work: impl FnMut() -> Result<T, GpuError>,
) -> Result<Fastest<T>, GpuError> {
    let mut result = Fastest {
        answers: work()?,
        kernels: Duration::MAX,
        whole: Duration::MAX,
    };
    for _ in 0..ROUNDS {
        let (started, busy) = (Instant::now(), gpu.busy());
        result.answers = work()?;
        result.whole = result.whole.min(started.elapsed());
        result.kernels = result.kernels.min(gpu.busy() - busy);
    }
    Ok(result)
}

/// Incoherent views from around the mesh towards it.
fn views(count: usize) -> Vec<Ray> {
    let mut state = 1_u64;
    let mut number = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / 2.0_f64.powi(53)
    };
    let mut on_sphere = || {
        let height = 2.0 * number() - 1.0;
        let (sin, cos) = (2.0 * PI * number()).sin_cos();
        let radius = (1.0 - height * height).sqrt();
        Vec3::new(radius * cos, radius * sin, height)
    };
    let mut view = || {
        let from = on_sphere() * 2.5;
        let towards = on_sphere() * 0.9;
        Ray::new(from, (towards - from).normalized())
    };
    (0..count).map(|_| view()).collect()
}

/// From what the pixels of an image see of the mesh to a light above, pixel by pixel; where
/// they see nothing, the pixels' own rays.
fn towards_light(tree: &RayTree, count: usize) -> Vec<Ray> {
    let width = (count as f64).sqrt().ceil() as usize;
    let (eye, light) = (Vec3::new(0.0, -2.5, 0.5), Vec3::new(1.0, -1.0, 3.0));
    let pixel = |i: usize| {
        let at = |i: usize| FIELD * (2.0 * (i as f64 + 0.5) / width as f64 - 1.0);
        let (right, up) = (at(i % width), at(i / width));
        let ray = Ray::new(eye, Vec3::new(right, 1.0, up - 0.2).normalized());
        tree.first_hit(&ray).map_or(ray, |hit| {
            let from = ray.at(hit.t - 1e-6);
            Ray::new(from, (light - from).normalized())
        })
    };
    (0..count).map(pixel).collect()
}

/// A smooth closed surface of radius about 1: an octahedron with each face split in
/// `n²`, bulged by low waves. Vertices on the rims of faces are there twice; edges are
/// found on welded positions.
fn bumpy_sphere(n: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for octant in 0..8 {
        let signs = [0, 1, 2].map(|bit| if octant >> bit & 1 == 0 { 1.0 } else { -1.0 });
        let is_mirrored = signs.iter().product::<f64>() < 0.0;
        let first = mesh.positions.len() as u32;
        for i in 0..=n {
            for j in 0..=n - i {
                let corner = [i, j, n - i - j].map(f64::from);
                let p = Vec3::from([0, 1, 2].map(|axis| signs[axis] * corner[axis])).normalized();
                let wave = (7.0 * p.x).sin() * (5.0 * p.y + 1.0).sin() * (6.0 * p.z).cos();
                mesh.positions.push(p * (0.95 + 0.08 * wave));
            }
        }
        // Row `i` has `n + 1 - i` vertices.
        let at = |i: u32, j: u32| first + i * (n + 1) - i * (i.max(1) - 1) / 2 + j;
        let mut push = |[a, b, c]: [u32; 3]| {
            mesh.faces
                .push(if is_mirrored { [a, c, b] } else { [a, b, c] })
        };
        for i in 0..n {
            for j in 0..n - i {
                push([at(i, j), at(i + 1, j), at(i, j + 1)]);
                if j + 1 < n - i {
                    push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
    }
    mesh
}
