//! Section 7.2: how many cone queries and rays a second, and how long the trees
//! take to build.

use std::time::Instant;

use capwalk_geometry::{ConeQuery, EdgeSelection, Mesh, Ray, RayTree, SilhouetteTree, topology};
use capwalk_math::Vec3;
use capwalk_scene::primitive::icosphere;

use crate::claim::{Claim, Measured, Verdict, digits};
use crate::figure::{Figure, Table};
use crate::lattice;
use crate::random::random;
use crate::settings::{Failure, Settings};

/// Half-angle of the limited cones, radians.
const LIMIT: f64 = 0.2;

/// A mesh in both trees, with the seconds they took.
struct Subject {
    name: String,
    triangles: usize,
    rays: RayTree,
    silhouettes: SilhouetteTree,
    build: f64,
    /// Eyes and unit axes.
    views: Vec<(Vec3, Vec3)>,
}

impl Subject {
    fn new(name: &str, mut mesh: Mesh, settings: &Settings) -> Self {
        // Around the origin, within a radius of 1.
        let (low, high) = mesh.bounds();
        let (centre, scale) = ((low + high) * 0.5, 2.0 / (high - low).length());
        for p in &mut mesh.positions {
            *p = (*p - centre) * scale;
        }
        let started = Instant::now();
        let rays = RayTree::build(&mesh);
        let silhouettes = SilhouetteTree::build(&mesh, &topology::edges(&mesh));
        let build = started.elapsed().as_secs_f64();
        let views = settings.quality.choose(64, 4096, 16_384);
        let view = |i: u64| {
            let number = |d: u64| random([settings.seed, 7, i, d]);
            let direction = |d: u64| {
                let z = 2.0 * number(d) - 1.0;
                let (sin, cos) = (std::f64::consts::TAU * number(d + 1)).sin_cos();
                let r = (1.0 - z * z).sqrt();
                Vec3::new(r * cos, r * sin, z)
            };
            let origin = direction(0) * (1.2 + 1.8 * number(2));
            let target = direction(3) * (0.8 * number(5).cbrt());
            (origin, (target - origin).normalized())
        };
        Self {
            name: name.into(),
            triangles: mesh.faces.len(),
            rays,
            silhouettes,
            build,
            views: (0..views).map(view).collect(),
        }
    }

    /// Seconds for a shadow ray, a cone within [`LIMIT`] and one without limit,
    /// each measured in turn, round by round.
    fn seconds(&self, rounds: u32) -> [Vec<f64>; 3] {
        let shadow = |&(origin, axis): &(Vec3, Vec3)| {
            let ray = Ray {
                t_max: 4.0,
                ..Ray::new(origin, axis)
            };
            self.rays.occluded(&ray)
        };
        let cone = |&(origin, axis): &(Vec3, Vec3), max_angle: f64| {
            let query = ConeQuery {
                apex: origin,
                axis,
                max_angle,
                edges: EdgeSelection::Silhouettes,
                groups: u8::MAX,
                in_front_of: None,
            };
            self.silhouettes.closest(&query).is_some()
        };
        let time = |query: &dyn Fn(&(Vec3, Vec3)) -> bool| {
            let started = Instant::now();
            let found = self.views.iter().filter(|view| query(view)).count();
            std::hint::black_box(found);
            started.elapsed().as_secs_f64() / self.views.len() as f64
        };
        let mut seconds: [Vec<f64>; 3] = Default::default();
        // The first round fills the caches.
        for round in 0..=rounds {
            let times = [
                time(&shadow),
                time(&|view| cone(view, LIMIT)),
                time(&|view| cone(view, 4.0)),
            ];
            for (all, time) in seconds.iter_mut().zip(times) {
                if round > 0 {
                    all.push(time);
                }
            }
        }
        seconds
    }
}

/// The median, and its error from the distance of the quartiles, which for Gaussian
/// times is 1.35 standard deviations: a slow phase of the machine should not count.
fn typical(times: impl IntoIterator<Item = f64>) -> Measured {
    let mut times: Vec<f64> = times.into_iter().collect();
    times.sort_by(f64::total_cmp);
    let at = |share: f64| times[((times.len() - 1) as f64 * share).round() as usize];
    Measured {
        value: at(0.5),
        error: 1.253 * (at(0.75) - at(0.25)) / 1.349 / (times.len() as f64).sqrt(),
    }
}

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    let rounds = settings.quality.choose(3, 15, 41);
    let detail = settings.quality.choose(8, 71, 71);
    let watch = (settings.stages)("queries");
    let smooth = icosphere(detail);
    let lattice = lattice::mesh(settings);
    let subjects = [
        Subject::new("smooth sphere", smooth, settings),
        Subject::new(lattice::name(settings), lattice, settings),
    ];
    let mut table = Table {
        title: "Queries of one thread, and building".into(),
        columns: vec![
            "mesh",
            "triangles",
            "shadow rays, million/s",
            "limited cones, million/s",
            "cones without limit, million/s",
            "cone without limit / shadow ray",
            "building both trees, ms",
        ],
        rows: Vec::new(),
    };
    let mut ratios = Vec::new();
    let mut millions = Vec::new();
    for subject in &subjects {
        let seconds = subject.seconds(rounds);
        if watch.should_stop() {
            return Err(Failure::Stopped);
        }
        let pairs = seconds[2].iter().zip(&seconds[0]);
        let ratio = typical(pairs.map(|(cone, ray)| cone / ray));
        let rates = seconds.map(|times| 1e-6 / typical(times).value);
        table.rows.push(vec![
            subject.name.clone(),
            subject.triangles.to_string(),
            digits(rates[0]),
            digits(rates[1]),
            digits(rates[2]),
            ratio.to_string(),
            digits(1e3 * subject.build),
        ]);
        ratios.push(ratio);
        millions.push(1e3 / rates[2]);
    }
    let claims = vec![
        Claim {
            statement: "Section 7.2: a cone query takes about 10 times as long as a shadow ray \
                        (mesh of 100,000 triangles)"
                .into(),
            paper: "about 10".into(),
            ours: format!(
                "{} ({} triangles, no limit)",
                ratios[0], subjects[0].triangles
            ),
            verdict: about(ratios[0], 10.0),
        },
        Claim {
            statement: "Section 7.2: a million cone queries take about 30 ms (100,000 triangles)"
                .into(),
            paper: "30 ms".into(),
            ours: format!("{} ms", digits(millions[0])),
            verdict: Verdict::NotComparable("a GPU there, one thread of a CPU here".into()),
        },
        Claim {
            statement: "Section 6.1: building takes about 100 ms".into(),
            paper: "100 ms (Voronoi bunny)".into(),
            ours: format!(
                "{} ms for both trees of {} triangles ({})",
                digits(1e3 * subjects[1].build),
                subjects[1].triangles,
                subjects[1].name
            ),
            verdict: Verdict::NotComparable("another CPU".into()),
        },
    ];
    Ok(Figure {
        caption: format!(
            "Eyes around the mesh at 1.2 to 3 times its radius look at points within it, one after \
             the other; medians over {rounds} rounds with their errors. Limited cones reach {LIMIT} rad. The paper's dragon is \
             replaced by a smooth sphere."
        ),
        tables: vec![table],
        claims,
        ..Figure::default()
    })
}

/// That a number is about another: within a factor of two.
fn about(number: Measured, expected: f64) -> Verdict {
    let [low, high] = [-3.0, 3.0].map(|z| number.value + z * number.error);
    if low > 0.5 * expected && high < 2.0 * expected {
        Verdict::Holds
    } else if high < 0.5 * expected {
        Verdict::DoesNotHold(format!("it is less here, {number}"))
    } else if low > 2.0 * expected {
        Verdict::DoesNotHold(format!("it is more here, {number}"))
    } else {
        Verdict::Inconclusive(format!("{number}"))
    }
}
