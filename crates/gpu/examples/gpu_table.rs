//! Queries per second on the adapter that is found, in both precisions, beside the
//! processor's own, with how far the answers agree: a table for docs/benchmarks.md.
//!
//! `cargo xtask gpu [ADAPTER]`, where part of an adapter's name chooses it. The mesh is a
//! bumpy sphere of 100,352 triangles, the views come from around it, as in the benchmark of
//! `capwalk-geometry`. Times are of whole batches, with the upload of the queries and the
//! way of the answers back; the processor's are of one thread.

use std::f64::consts::PI;
use std::fmt::Debug;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::{Duration, Instant};

use capwalk_geometry::{
    ConeQuery, EdgeSelection, Mesh, Ray, RayTree, SilhouettePoint, SilhouetteTree, topology,
};
use capwalk_gpu::{DeviceRayTree, DeviceSilhouetteTree, Gpu, GpuError, GpuOptions, Precision};
use capwalk_math::Vec3;

/// Splits of each edge of an octahedron: `8 n²` triangles.
const SPLITS: u32 = 112;
/// Half-angle of the limited cones, radians.
const NARROW: f64 = 0.05;
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
    let mesh = bumpy_sphere(SPLITS);
    let edges = topology::edges(&mesh);
    let trees = (RayTree::build(&mesh), SilhouetteTree::build(&mesh, &edges));
    for precision in [Precision::Double, Precision::Single] {
        options.precision = Some(precision);
        let gpu = match Gpu::new(&options) {
            Ok(gpu) => Arc::new(gpu),
            Err(GpuError::Unusable { adapter, reason }) => {
                println!("{adapter}, {precision:?}: left out, {reason}");
                continue;
            }
            Err(error) => return Err(error),
        };
        measure(&gpu, &mesh, &trees)?;
    }
    Ok(())
}

fn measure(gpu: &Arc<Gpu>, mesh: &Mesh, trees: &(RayTree, SilhouetteTree)) -> Result<(), GpuError> {
    let (ray_tree, silhouette_tree) = trees;
    let count = if gpu.is_software() { 1 << 15 } else { 1 << 20 };
    println!(
        "\n{} ({}), {} triangles, {count} queries, {:?} precision{}\n",
        gpu.name(),
        gpu.driver().trim(),
        mesh.faces.len(),
        gpu.precision(),
        match gpu.is_software() {
            true => ".\nThis adapter is software: no figure is from hardware",
            false => "",
        },
    );
    let rays = views(count);
    let cones = |max_angle: f64| -> Vec<ConeQuery> {
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
    let (all, narrow) = (cones(PI), cones(NARROW));
    let rays_there = DeviceRayTree::new(gpu, ray_tree)?;
    let cones_there = DeviceSilhouetteTree::new(gpu, silhouette_tree)?;

    println!(
        "| query | million per second | x first hit | processor, million per second | equal to the bit | off by at most |"
    );
    println!("|---|---|---|---|---|---|");
    let mut table = Table::new(count);
    let (time, found) = fastest(|| rays_there.first_hits(&rays))?;
    let (own, expected) = once(|| {
        rays.iter()
            .map(|ray| ray_tree.first_hit(ray))
            .collect::<Vec<_>>()
    });
    table.row("first hit", time, own, &found, &expected, |a, b| {
        Some((a.as_ref()?.t - b.as_ref()?.t).abs())
    });
    let (time, found) = fastest(|| rays_there.occluded(&rays))?;
    let (own, expected) = once(|| {
        rays.iter()
            .map(|ray| ray_tree.occluded(ray))
            .collect::<Vec<_>>()
    });
    table.row("occluded", time, own, &found, &expected, |a, b| {
        (a == b).then_some(0.0)
    });
    let angle = |a: &Option<SilhouettePoint>, b: &Option<SilhouettePoint>| {
        Some((a.as_ref()?.angle - b.as_ref()?.angle).abs())
    };
    for (name, cones) in [
        ("closest silhouette", &all),
        ("closest silhouette within 0.05", &narrow),
    ] {
        let (time, found) = fastest(|| cones_there.closest(cones))?;
        let (own, expected) = once(|| {
            cones
                .iter()
                .map(|cone| silhouette_tree.closest(cone))
                .collect::<Vec<_>>()
        });
        table.row(name, time, own, &found, &expected, angle);
    }
    let (time, found) = fastest(|| cones_there.gather(&narrow, CAPACITY))?;
    let (own, expected) = once(|| {
        let gather = |cone: &ConeQuery| {
            let mut edges = Vec::new();
            silhouette_tree.gather(cone, None, |edge, _| edges.push(edge));
            edges
        };
        narrow.iter().map(gather).collect::<Vec<_>>()
    });
    let sorted = |mut edges: Vec<u32>| {
        edges.sort_unstable();
        edges
    };
    let overflowed = found.overflowed();
    let found: Vec<_> = (0..count).map(|i| sorted(found.of(i).to_vec())).collect();
    let expected: Vec<_> = expected.into_iter().map(sorted).collect();
    table.row(
        "all silhouettes within 0.05",
        time,
        own,
        &found,
        &expected,
        |a, b| (a == b).then_some(0.0),
    );
    println!("\nOf the last, {overflowed} met more than {CAPACITY} edges and were asked twice.");
    Ok(())
}

/// The rows so far.
struct Table {
    count: usize,
    first_hit: Option<Duration>,
}

impl Table {
    fn new(count: usize) -> Self {
        Self {
            count,
            first_hit: None,
        }
    }

    /// `difference` is that of two answers; `None` where they are not of one kind.
    fn row<T: PartialEq + Debug>(
        &mut self,
        name: &str,
        time: Duration,
        own: Duration,
        found: &[T],
        expected: &[T],
        difference: impl Fn(&T, &T) -> Option<f64>,
    ) {
        let first_hit = *self.first_hit.get_or_insert(time);
        let rate = |time: Duration| self.count as f64 / time.as_secs_f64() * 1e-6;
        let pairs = || found.iter().zip(expected);
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
            "| {name} | {:.3} | {:.2} | {:.3} | {:.2} % | {off} |",
            rate(time),
            time.as_secs_f64() / first_hit.as_secs_f64(),
            rate(own),
            100.0 * same as f64 / self.count as f64,
        );
    }
}

fn once<T>(work: impl FnOnce() -> T) -> (Duration, T) {
    let started = Instant::now();
    let result = work();
    (started.elapsed(), result)
}

/// The time of the fastest of some rounds, after one that compiles the kernel.
fn fastest<T>(work: impl Fn() -> Result<T, GpuError>) -> Result<(Duration, T), GpuError> {
    let mut result = work()?;
    let mut least = Duration::MAX;
    for _ in 0..ROUNDS {
        let (time, again) = once(&work);
        result = again?;
        least = least.min(time);
    }
    Ok((least, result))
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
