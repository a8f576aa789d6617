//! Figure 8: directional derivatives of fields against finite differences, in
//! the plane (Eq. 27) and on the sphere (Eq. 34).

use capwalk_diff::{Estimate, check};
use capwalk_geometry::{Mesh, SilhouettePoint, SilhouetteTree, topology};
use capwalk_math::{Moments, Rgb, Vec2, Vec3, sphere};
use capwalk_scene::Image;
use capwalk_scene_io::image::{Scale, Style};
use capwalk_walk::{Domain, Sphere, WalkSettings, sample_field, sample_value};
use rayon::prelude::*;

use crate::claim::{self, Claim};
use crate::figure::{Figure, Row, Shown};
use crate::random::random;
use crate::settings::{Failure, Settings};
use crate::walk::plane::{CurvePoint, Plane};

/// Half the distance of the points of a difference.
const STEP: f64 = 0.004;

/// A boundary value problem, as an image.
trait Problem: Sync {
    type Domain: Domain;
    /// The space and its boundary.
    fn domain(&self) -> Self::Domain;
    /// The boundary's value.
    fn value(site: &<Self::Domain as Domain>::Site) -> f64;
    /// What the pixel at `(x, y)` in `[-1, 1]²` shows: a point, and the
    /// direction of the derivative there. `None` outside.
    fn at(x: f64, y: f64) -> Option<Place<<Self::Domain as Domain>::Vector>>;
    /// The point at a distance along a direction of any length.
    fn moved(
        place: &Place<<Self::Domain as Domain>::Vector>,
        distance: f64,
    ) -> <Self::Domain as Domain>::Vector;
}

struct Place<V> {
    point: V,
    direction: V,
}

/// A polygon with a corner that points inward, in the plane.
struct Flat;

impl Problem for Flat {
    type Domain = Plane;

    fn domain(&self) -> Plane {
        let corners = [
            [-0.9, -0.7],
            [0.85, -0.85],
            [0.95, 0.6],
            [0.1, 0.15],
            [-0.6, 0.9],
        ];
        Plane::polygon(&corners.map(|[x, y]| Vec2::new(x, y)))
    }

    fn value(site: &CurvePoint) -> f64 {
        (3.0 * site.point.x + 1.0).sin() + (4.0 * site.point.y).cos()
    }

    fn at(x: f64, y: f64) -> Option<Place<Vec2>> {
        Some(Place {
            point: Vec2::new(x, y),
            direction: Vec2::new(0.8, 0.6),
        })
    }

    fn moved(place: &Place<Vec2>, distance: f64) -> Vec2 {
        place.point + place.direction * distance
    }
}

/// A triangle seen from the centre of the sphere.
struct Spherical {
    tree: SilhouetteTree,
}

impl Spherical {
    fn new() -> Self {
        let corners = [[-0.75, -0.5, 0.6], [0.8, -0.45, 0.55], [0.05, 0.8, 0.5]];
        let mesh = Mesh {
            positions: corners.map(|[x, y, z]| Vec3::new(x, y, z)).to_vec(),
            faces: vec![[0, 1, 2]],
        };
        Self {
            tree: SilhouetteTree::build(&mesh, &topology::edges(&mesh)),
        }
    }
}

/// A view of a tree that can be copied from thread to thread.
impl<'a> Problem for &'a Spherical {
    type Domain = Sphere<'a>;

    fn domain(&self) -> Sphere<'a> {
        Sphere::of_silhouettes(&self.tree, Vec3::zero())
    }

    fn value(site: &SilhouettePoint) -> f64 {
        let q = site.direction;
        (3.0 * q.x + 1.0).sin() + (4.0 * q.y).cos()
    }

    fn at(x: f64, y: f64) -> Option<Place<Vec3>> {
        let height = 1.0 - x * x - y * y;
        let q = Vec3::new(x, y, height.max(0.0).sqrt());
        (height > 0.0).then(|| Place {
            point: q,
            direction: Vec3::new(0.8, 0.6, 0.0).reject_from(q),
        })
    }

    fn moved(place: &Place<Vec3>, distance: f64) -> Vec3 {
        let length = place.direction.length();
        let e = place.direction * length.recip();
        sphere::walk_along(place.point, e, distance * length)
    }
}

/// Field, derivative, and difference; zero where there is nothing to compare.
struct Images {
    value: Image,
    derivative: Estimate,
    difference: Estimate,
}

fn images<P: Problem>(problem: &P, steps: u32, settings: &Settings) -> Images {
    let size = settings.quality.choose(16, 96, 256);
    let samples = settings.quality.choose(40, 250, 2_000);
    let walk = WalkSettings {
        steps,
        max_radius: 4.0,
        ..WalkSettings::default()
    };
    let rows: Vec<Vec<[Moments; 3]>> = (0..size)
        .into_par_iter()
        .map(|row| {
            let domain = problem.domain();
            let pixel = |column: usize| {
                let [x, y] = [column, row].map(|i| 2.0 * (i as f64 + 0.5) / size as f64 - 1.0);
                let mut sums = [Moments::default(); 3];
                let Some(place) = P::at(x, -y) else {
                    return sums;
                };
                // A difference across the boundary is that of two fields.
                let near = domain.closest(place.point, 3.0 * STEP).is_some();
                let ends = [STEP, -STEP].map(|distance| P::moved(&place, distance));
                for i in 0..samples {
                    let address = |set: u64, d: u32| {
                        let pixel = (row * size + column) as u64;
                        random([settings.seed + (set << 32), pixel, i, u64::from(d)])
                    };
                    let field = sample_field(&domain, place.point, &walk, |d| address(1, d));
                    let (value, gradient) = field.scalar(P::value);
                    sums[0].add(value);
                    if !near {
                        sums[1].add(capwalk_walk::Vector::dot(gradient, place.direction));
                        let [ahead, behind] = ends.map(|x| {
                            let site = sample_value(&domain, x, &walk, |d| address(2, d));
                            site.as_ref().map_or(0.0, P::value)
                        });
                        sums[2].add((ahead - behind) / (2.0 * STEP));
                    }
                }
                sums
            };
            (0..size).map(pixel).collect()
        })
        .collect();
    let estimate = |k: usize| {
        let moments = || rows.iter().flatten().map(|sums| &sums[k]);
        let image = |f: &dyn Fn(&Moments) -> f64| Image {
            width: size,
            height: size,
            pixels: moments().map(|m| Rgb::splat(f(m))).collect(),
        };
        Estimate {
            mean: image(&|m| m.mean),
            standard_error: image(&|m| if m.count < 2 { 0.0 } else { m.standard_error() }),
        }
    };
    Images {
        value: estimate(0).mean,
        derivative: estimate(1),
        difference: estimate(2),
    }
}

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    let mut figure = Figure {
        caption: format!(
            "Above, in the plane around a polygon; below, on the hemisphere around a triangle, \
             projected on a disk. (a) the field of one step from values on the boundary, (b) its \
             derivative along a direction, (c) central differences of the field over ±{STEP} with \
             common random numbers. Both are estimated independently of each other with the same \
             number of samples. Points closer to the boundary than {} are left out.",
            3.0 * STEP
        ),
        ..Figure::default()
    };
    let spherical = Spherical::new();
    for steps in 1..=3 {
        let flat = stage(settings, "plane", || images(&Flat, steps, settings))?;
        let round = stage(settings, "sphere", || images(&&spherical, steps, settings))?;
        for (name, equation, images) in [("plane", "(27)", flat), ("sphere", "(34)", round)] {
            let comparison = check::compare(&images.derivative, &images.difference);
            let verdict = claim::of_check(&comparison);
            let words = claim::in_words(&comparison);
            figure.claims.push(Claim {
                statement: format!(
                    "Derivatives by Eq. {equation} match finite differences ({name}, M = {steps})"
                ),
                paper: match steps {
                    1 => "figure 8, by eye".into(),
                    _ => "not shown".into(),
                },
                ours: words,
                verdict,
            });
            if steps == 1 {
                figure.rows.push(Row::Images(shown(&images)));
            }
        }
    }
    Ok(figure)
}

fn shown(images: &Images) -> Vec<Shown> {
    let shown = |title: &str, image: &Image, limit: f64| Shown {
        title: title.into(),
        image: image.clone(),
        style: Style::Diverging(Scale::even(limit)),
    };
    let derivatives = [&images.derivative.mean, &images.difference.mean];
    let limit = Scale::of(derivatives).limit;
    vec![
        shown(
            "(a) values",
            &images.value,
            Scale::of([&images.value]).limit,
        ),
        shown("(b) derivative", derivatives[0], limit),
        shown("(c) differences", derivatives[1], limit),
    ]
}

/// A stage without images of its own: it can only be stopped at its end.
fn stage<T>(
    settings: &Settings,
    name: &'static str,
    work: impl FnOnce() -> T,
) -> Result<T, Failure> {
    let watch = (settings.stages)(name);
    let result = work();
    match watch.should_stop() {
        true => Err(Failure::Stopped),
        false => Ok(result),
    }
}
