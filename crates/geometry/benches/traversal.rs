//! Rays per second on one thread in an arcade of 250,000 triangles: primary ones in the order of
//! pixels, shadow rays from where they hit to a square light above the court, and diffuse ones
//! from there. Beside them `obvhs`, and Embree 4 if `CAPWALK_EMBREE` names its library, which PyPI's
//! `embreex` contains; that needs a C compiler.
//!
//! All take the same rays, which single precision represents, in turn and in several rounds. A
//! time is the sum over batches of rays of the least in any round.

mod arcade;
mod random;

use std::hint::black_box;
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};

use capwalk_geometry::{Mesh, Ray, RayTree};
use capwalk_math::Vec3;
use obvhs::BvhBuildParams;
use obvhs::bvh2::{Bvh2, builder::build_bvh2_from_tris};
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
use obvhs::ray::{Ray as YardstickRay, RayHit};
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;
use random::Random;

/// Pixels on each side of the image.
const PIXELS: usize = 512;
/// Rays that are timed together.
const BATCH: usize = 8192;
const ROUNDS: usize = 7;
/// From a surface to where rays start that leave it, metres.
const OFFSET: f64 = 1e-3;

fn main() {
    // `cargo test` runs benches once, without measuring.
    let (pixels, rounds) = match std::env::args().any(|argument| argument == "--bench") {
        true => (PIXELS, ROUNDS),
        false => (16, 1),
    };
    let mesh = arcade::arcade();
    let ours = RayTree::build(&mesh);
    let yardsticks = Yardsticks::new(&mesh);
    let kinds = rays(&mesh, &ours, pixels);
    let embree = Embree::new(&mesh, &kinds);
    println!(
        "{} triangles, one thread, million rays a second",
        mesh.faces.len()
    );
    println!(
        "{:<8} {:<14} {:>7} {:>9} {:>6}",
        "rays", "tracer", "found", "a second", "x ours"
    );
    for kind in &kinds {
        let measure = |tracer: &str| match (tracer, kind.is_occlusion) {
            ("ours", false) => kind.measured(|ray| ours.first_hit(ray).is_some()),
            ("ours", true) => kind.measured(|ray| ours.occluded(ray)),
            ("obvhs CwBvh", false) => kind.measured(|ray| yardsticks.cwbvh_hits(ray)),
            ("obvhs CwBvh", true) => kind.measured(|ray| yardsticks.cwbvh_occluded(ray)),
            ("obvhs Bvh2", false) => kind.measured(|ray| yardsticks.bvh2_hits(ray)),
            ("obvhs Bvh2", true) => kind.measured(|ray| yardsticks.bvh2_occluded(ray)),
            _ => embree
                .as_ref()
                .map_or_else(Vec::new, |it| it.measured(kind)),
        };
        let tracers = ["ours", "obvhs CwBvh", "obvhs Bvh2", "Embree"];
        let mut best = tracers.map(&measure);
        for _ in 1..rounds {
            for (tracer, best) in tracers.iter().zip(&mut best) {
                for (best, again) in best.iter_mut().zip(measure(tracer)) {
                    best.0 = best.0.min(again.0);
                }
            }
        }
        let count = kind.rays.len() as f64;
        let speeds = best
            .each_ref()
            .map(|batches| count * 1e-6 / batches.iter().map(|batch| batch.0).sum::<f64>());
        for ((tracer, batches), speed) in tracers.iter().zip(&best).zip(speeds) {
            if !batches.is_empty() {
                let found = batches.iter().map(|batch| batch.1).sum::<usize>() as f64;
                println!(
                    "{:<8} {tracer:<14} {:>6.2}% {speed:>9.2} {:>6.2}",
                    kind.name,
                    100.0 * found / count,
                    speed / speeds[0]
                );
            }
        }
    }
}

/// Rays that are measured together.
struct Kind {
    name: &'static str,
    is_occlusion: bool,
    rays: Vec<Ray>,
}

impl Kind {
    /// The seconds that each batch takes, and how many of its rays find something.
    fn measured(&self, finds: impl Fn(&Ray) -> bool) -> Vec<(f64, usize)> {
        let batch = |rays: &[Ray]| {
            let start = Instant::now();
            let found = rays.iter().filter(|ray| finds(black_box(ray))).count();
            (start.elapsed().as_secs_f64(), black_box(found))
        };
        self.rays.chunks(BATCH).map(batch).collect()
    }
}

/// The rays of an image taken in the arcade.
fn rays(mesh: &Mesh, tree: &RayTree, pixels: usize) -> [Kind; 3] {
    let eye = Vec3::new(-11.0, -4.5, 1.8);
    let forward = Vec3::new(1.0, 0.32, 0.12).normalized();
    let right = forward.cross(Vec3::new(0.0, 0.0, 1.0)).normalized();
    let down = forward.cross(right);
    let side = |i: usize| 0.8 * (2.0 * (i as f64 + 0.5) / pixels as f64 - 1.0);
    let primary = (0..pixels * pixels).map(|i| {
        let across = right * side(i % pixels) + down * side(i / pixels);
        representable(eye, forward + across, f64::INFINITY)
    });
    let primary: Vec<Ray> = primary.collect();
    let mut random = Random::new(3);
    let (mut shadow, mut diffuse) = (Vec::new(), Vec::new());
    for ray in &primary {
        let Some(hit) = tree.first_hit(ray) else {
            continue;
        };
        let [a, b, c] = mesh.corners(hit.face as usize);
        let normal = (b - a).cross(c - a).normalized();
        let normal = normal * -normal.dot(ray.direction).signum();
        let start = ray.at(hit.t) + normal * OFFSET;
        let light = Vec3::new(6.0 * random.unit() - 3.0, 6.0 * random.unit() - 3.0, 16.0);
        shadow.push(representable(start, light - start, 1.0));
        diffuse.push(representable(
            start,
            normal + random.direction(),
            f64::INFINITY,
        ));
    }
    [
        ("primary", false, primary),
        ("shadow", true, shadow),
        ("diffuse", false, diffuse),
    ]
    .map(|(name, is_occlusion, rays)| Kind {
        name,
        is_occlusion,
        rays,
    })
}

/// The ray that single precision makes of this one.
fn representable(origin: Vec3, direction: Vec3, t_max: f64) -> Ray {
    let rounded = |v: Vec3| v.map(|c| f64::from(c as f32));
    Ray {
        t_max,
        ..Ray::new(rounded(origin), rounded(direction))
    }
}

/// The trees of `obvhs`, each with its triangles in the order of its leaves.
struct Yardsticks {
    cwbvh: CwBvh,
    bvh2: Bvh2,
    cwbvh_triangles: Vec<RtTriangle>,
    bvh2_triangles: Vec<RtTriangle>,
}

impl Yardsticks {
    fn new(mesh: &Mesh) -> Self {
        let corner = |p: Vec3| p.to_array().map(|v| v as f32).into();
        let triangle = |face| {
            let [v0, v1, v2] = mesh.corners(face).map(corner);
            Triangle { v0, v1, v2 }
        };
        let triangles: Vec<Triangle> = (0..mesh.faces.len()).map(triangle).collect();
        let (slow, mut time) = (BvhBuildParams::very_slow_build(), Duration::default());
        let cwbvh = build_cwbvh_from_tris(&triangles, slow, &mut time);
        let bvh2 = build_bvh2_from_tris(&triangles, slow, &mut time);
        let ordered = |order: &[u32]| {
            let triangle = |&index: &u32| RtTriangle::from(&triangles[index as usize]);
            order.iter().map(triangle).collect()
        };
        Self {
            cwbvh_triangles: ordered(&cwbvh.primitive_indices),
            bvh2_triangles: ordered(&bvh2.primitive_indices),
            cwbvh,
            bvh2,
        }
    }

    fn ray(ray: &Ray) -> YardstickRay {
        let [origin, direction] =
            [ray.origin, ray.direction].map(|v| v.to_array().map(|c| c as f32).into());
        YardstickRay::new(origin, direction, ray.t_min as f32, ray.t_max as f32)
    }

    fn cwbvh_hits(&self, ray: &Ray) -> bool {
        let test = |ray: &YardstickRay, i: usize| self.cwbvh_triangles[i].intersect(ray);
        self.cwbvh
            .ray_traverse(Self::ray(ray), &mut RayHit::none(), test)
    }

    fn cwbvh_occluded(&self, ray: &Ray) -> bool {
        let test = |ray: &YardstickRay, i: usize| self.cwbvh_triangles[i].intersect(ray);
        !self.cwbvh.ray_traverse_miss(Self::ray(ray), test)
    }

    fn bvh2_hits(&self, ray: &Ray) -> bool {
        let test = |ray: &YardstickRay, i: usize| self.bvh2_triangles[i].intersect(ray);
        self.bvh2
            .ray_traverse(Self::ray(ray), &mut RayHit::none(), test)
    }

    fn bvh2_occluded(&self, ray: &Ray) -> bool {
        let test = |ray: &YardstickRay, i: usize| self.bvh2_triangles[i].intersect(ray);
        !self.bvh2.ray_traverse_miss(Self::ray(ray), test)
    }
}

/// Embree, in a program of its own.
struct Embree {
    folder: PathBuf,
}

impl Embree {
    /// Compiles the program and writes what it reads: corners and rays, in single precision.
    fn new(mesh: &Mesh, kinds: &[Kind]) -> Option<Self> {
        let library = PathBuf::from(std::env::var_os("CAPWALK_EMBREE")?);
        let folder = std::env::temp_dir().join(format!("traversal-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("the temporary folder is writable");
        let beside = library.parent().expect("a library is in a folder");
        let compiled = Command::new("cc")
            .args([
                "-O2",
                concat!(env!("CARGO_MANIFEST_DIR"), "/benches/embree.c"),
            ])
            .arg(&library)
            .arg(format!("-Wl,-rpath,{}", beside.display()))
            .arg("-o")
            .arg(folder.join("program"))
            .status();
        assert!(
            compiled.is_ok_and(|status| status.success()),
            "CAPWALK_EMBREE names no library that `cc` links benches/embree.c with"
        );
        let write = |name: &str, numbers: &mut dyn Iterator<Item = f64>| {
            let bytes: Vec<u8> = numbers.flat_map(|v| (v as f32).to_le_bytes()).collect();
            std::fs::write(folder.join(name), bytes).expect("the temporary folder is writable");
        };
        let corners = (0..mesh.faces.len()).flat_map(|face| mesh.corners(face));
        write("corners", &mut corners.flat_map(|p| p.to_array()));
        for kind in kinds {
            let rays = kind.rays.iter().flat_map(|ray| [ray.origin, ray.direction]);
            write(kind.name, &mut rays.flat_map(|v| v.to_array()));
        }
        Some(Self { folder })
    }

    /// As [`Kind::measured`].
    fn measured(&self, kind: &Kind) -> Vec<(f64, usize)> {
        let output = Command::new(self.folder.join("program"))
            .args(["corners", kind.name].map(|name| self.folder.join(name)))
            .args([u8::from(kind.is_occlusion).to_string(), BATCH.to_string()])
            .output()
            .expect("what was compiled runs");
        let text = String::from_utf8_lossy(&output.stdout);
        let batch = |line: &str| {
            let (seconds, found) = line.split_once(' ')?;
            Some((seconds.parse().ok()?, found.parse().ok()?))
        };
        let batches: Option<Vec<_>> = text.lines().map(batch).collect();
        batches.expect("the program prints two numbers a line")
    }
}

impl Drop for Embree {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}
