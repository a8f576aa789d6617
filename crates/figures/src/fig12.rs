//! Figure 12: the shape of an occluder from its shadow.

use std::f64::consts::TAU;

use capwalk_geometry::Mesh;
use capwalk_inverse::adam::Adam;
use capwalk_inverse::guard::Guards;
use capwalk_inverse::loss::{Distance, Loss};
use capwalk_inverse::run::Limits;
use capwalk_inverse::schedule::{Decay, Schedule};
use capwalk_inverse::variable::select::Wish;
use capwalk_inverse::variable::vertices::{Directions, Selection};
use capwalk_inverse::variable::{Variables, variable};
use capwalk_inverse::{Problem, State, Stop, View};
use capwalk_math::{Moments, Vec3};
use capwalk_render::{Method, WalkSettings, WasSettings, render};
use capwalk_scene::{Film, Filter, Image, Scene, ShadingNormals, builtin};
use capwalk_scene_io::image::Style;

use crate::claim::{self, Claim, Measured, digits};
use crate::figure::{Curve, Figure, Plot, Row, Shown, Table};
use crate::settings::{Failure, Settings, complete};

/// Vertices of the rim; each has two unknowns.
const RIM: usize = 25;
/// Radius of the disk, and how far the flower's outline is from it.
const RADIUS: f64 = 0.45;
const PETALS: f64 = 0.13;

/// The outline at a vertex: a disk, or a flower with five petals.
fn radius(vertex: usize, flower: bool) -> f64 {
    let angle = TAU * vertex as f64 / RIM as f64;
    match flower {
        true => RADIUS + PETALS * (5.0 * angle).cos(),
        false => RADIUS,
    }
}

/// The scene `leaf` with a fan of triangles in the leaf's place, level above the
/// floor.
fn scene(flower: bool, size: [u32; 2]) -> Result<Scene, Failure> {
    let missing = || Failure::Unusable("the built-in scene leaf has no leaf".into());
    let mut scene = builtin::scene("leaf").ok_or_else(missing)?;
    let leaf = scene.shapes.iter_mut().find(|shape| shape.id == "leaf");
    let centre = Vec3::new(0.02, 1.6, 0.03);
    let rim = (0..RIM).map(|i| {
        let (sin, cos) = (TAU * (i as f64 + 0.2) / RIM as f64).sin_cos();
        centre + Vec3::new(cos, 0.0, sin) * radius(i, flower)
    });
    let last = RIM as u32;
    let shape = leaf.ok_or_else(missing)?;
    shape.mesh = Mesh {
        positions: rim.chain([centre]).collect(),
        faces: (0..last).map(|i| [last, (i + 1) % last, i]).collect(),
    };
    shape.normals = ShadingNormals::Face;
    scene.film = Film::new(size[0], size[1], Filter::Box);
    Ok(scene)
}

/// One way to find the shape.
struct Search {
    name: &'static str,
    /// Loss with its error, iteration by iteration.
    losses: Vec<Measured>,
    /// The last picture.
    picture: Image,
    /// Mean distance of the rim's vertices from the flower's, over that of the
    /// disk's.
    distance: f64,
}

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    let quality = settings.quality;
    let size = quality.choose([16, 12], [48, 36], [128, 96]);
    let iterations = quality.choose(2, 80, 300);
    let spp = quality.choose(4, 24, 64);
    let target_spp = quality.choose(16, 2048, 8192);
    let options = settings.options(target_spp, 50);
    let watch = (settings.stages)("target");
    let target = render(&scene(true, size)?, &options, &*watch);
    complete(&target.statistics)?;
    let disk = render(&scene(false, size)?, &options, &*watch);
    complete(&disk.statistics)?;

    let searches = [
        search(
            "ours",
            Method::Walk,
            &target.value.mean,
            iterations,
            spp,
            settings,
        )?,
        search(
            "WAS",
            Method::Was(WasSettings::default()),
            &target.value.mean,
            iterations,
            spp,
            settings,
        )?,
    ];
    let photo = |title: &str, image: &Image| Shown {
        title: title.into(),
        image: image.clone(),
        style: Style::Photographic { exposure: 0.0 },
    };
    let curves = searches.iter().map(|search| Curve {
        name: search.name.into(),
        points: search
            .losses
            .iter()
            .enumerate()
            // A loss without the noise of its picture may be below zero.
            .filter(|(_, loss)| loss.value > 0.0)
            .map(|(i, loss)| [i as f64 + 1.0, loss.value, loss.error])
            .collect(),
    });
    let rows = vec![
        Row::Pictures(vec![
            photo("(a) target", &target.value.mean),
            photo("(b) start", &disk.value.mean),
            photo("(c) found by ours", &searches[0].picture),
            photo("(c) found by WAS", &searches[1].picture),
        ]),
        Row::Plots(vec![Plot {
            title: "(d) loss".into(),
            axes: [
                "iteration".into(),
                "mean squared difference of a pyramid".into(),
            ],
            logarithmic: true,
            curves: curves.collect(),
        }]),
    ];
    let ends: Vec<Measured> = searches.iter().map(Search::end).collect();
    let lines = searches.iter().zip(&ends).map(|(search, end)| {
        vec![
            search.name.into(),
            digits(search.losses[0].value),
            end.to_string(),
            format!("{:.1} %", 100.0 * search.distance),
        ]
    });
    let table = Table {
        title: "Where the searches end".into(),
        columns: vec![
            "method",
            "first loss",
            "loss of the last iterations",
            "distance of the rim, of the disk's",
        ],
        rows: lines.collect(),
    };
    let distance = Measured {
        value: searches[0].distance,
        error: 0.0,
    };
    let claims = vec![
        Claim {
            statement: "Figure 12: starting from a disk, ours converges to the flower".into(),
            paper: "by eye".into(),
            ours: format!(
                "the rim ends at {:.1} % of the disk's distance (converged: below 20 %)",
                100.0 * distance.value
            ),
            verdict: claim::below(
                distance,
                Measured {
                    value: 0.2,
                    error: 0.0,
                },
            ),
        },
        Claim {
            statement: "Figure 12: WAS does not converge to the optimum; its loss ends above ours"
                .into(),
            paper: "by eye".into(),
            ours: format!("{} against {}", ends[0], ends[1]),
            verdict: claim::below(ends[0], ends[1]),
        },
    ];
    Ok(Figure {
        caption: format!(
            "The rim of a disk with {RIM} vertices, {} unknowns, looked for by {iterations} steps of \
             Adam from the picture of its shadow, {} × {} pixels, {spp} samples each for picture and \
             gradient. Losses are mean squared differences, averaged over three sizes of the pictures, without what the picture's noise adds.",
            2 * RIM,
            size[0],
            size[1]
        ),
        rows,
        tables: vec![table],
        claims,
        ..Figure::default()
    })
}

fn search(
    name: &'static str,
    method: Method,
    target: &Image,
    iterations: u32,
    spp: u32,
    settings: &Settings,
) -> Result<Search, Failure> {
    let size = [target.width as u32, target.height as u32];
    let start = scene(false, size)?;
    let wish = Wish {
        name: "leaf.positions".into(),
        vertices: Some(Selection::Border),
        directions: Some(Directions::Plane([
            Vec3::new(1.0, 0.0, 0.0),
            Vec3::new(0.0, 0.0, 1.0),
        ])),
        uniform: true,
        ..Wish::default()
    };
    let unusable = |error: String| Failure::Unusable(format!("figure 12: {error}"));
    let variable = variable(&start, &wish).map_err(|error| unusable(error.to_string()))?;
    let variables =
        Variables::new(&start, vec![variable]).map_err(|error| unusable(error.to_string()))?;
    let problem = Problem {
        scene: start,
        variables,
        views: vec![View {
            sensor: None,
            target: target.clone(),
            mask: None,
            weight: 1.0,
        }],
        loss: Loss {
            distance: Distance::L2,
            levels: 3,
        },
        adam: Adam::default(),
        lr: 0.02,
        schedule: Schedule {
            warmup: 0,
            decay: Decay::Cosine { end: 0.1 },
        },
        // A baseline that tears the shape is to be seen, not stopped.
        guards: Guards {
            inversion: false,
            self_intersection: false,
        },
        limits: Limits {
            iterations,
            ..Limits::default()
        },
        seed: settings.seed,
        spp,
        spp_grad: spp,
        method,
        walk: WalkSettings::default(),
        threads: settings.threads,
    };
    let mut state = State::new(&problem);
    let mut losses = Vec::new();
    loop {
        let watch = (settings.stages)(name);
        let iteration = problem
            .iterate(&state, &*watch)
            .map_err(|stop| match stop {
                Stop::Interrupted => Failure::Stopped,
                Stop::Refused(refusal) => Failure::Refused(refusal),
                other => unusable(other.to_string()),
            })?;
        losses.push(Measured {
            value: iteration.row.loss,
            error: iteration.row.loss_error,
        });
        match iteration.next {
            Ok(next) => state = next,
            Err(Stop::Done) => {
                let found = problem.scene(&state).map_err(|e| unusable(e.to_string()))?;
                let picture = iteration.pictures.into_iter().next();
                return Ok(Search {
                    name,
                    losses,
                    picture: picture.expect("there is one view"),
                    distance: distance(&found, size)?,
                });
            }
            Err(stop) => return Err(unusable(stop.to_string())),
        }
    }
}

impl Search {
    /// The mean loss of the last tenth of the iterations.
    fn end(&self) -> Measured {
        let last = (self.losses.len() / 10).max(2);
        let mut moments = Moments::default();
        for loss in &self.losses[self.losses.len() - last..] {
            moments.add(loss.value);
        }
        moments.into()
    }
}

/// How far the rim is from the flower's, vertex by vertex, over the same for the
/// disk.
fn distance(found: &Scene, size: [u32; 2]) -> Result<f64, Failure> {
    let rim = |scene: &Scene| -> Vec<Vec3> {
        let leaf = scene.shapes.iter().find(|shape| shape.id == "leaf");
        leaf.map_or(Vec::new(), |leaf| leaf.mesh.positions[..RIM].to_vec())
    };
    let flower = rim(&scene(true, size)?);
    let mean = |of: &[Vec3]| {
        let pairs = of.iter().zip(&flower);
        pairs.map(|(a, b)| (*a - *b).length()).sum::<f64>()
    };
    Ok(mean(&rim(found)) / mean(&rim(&scene(false, size)?)))
}
