//! What moves, from parameters and files of velocities, and by how much a
//! finite difference moves it.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use capwalk_diff::may_be_specular;
use capwalk_math::{Dual, Vec3};
use capwalk_scene::sensor::view::View;
use capwalk_scene::{Filter, Motion, Scene, SensorMotion, Shape, ShapeMotion, params};

use crate::args::MotionArgs;

/// The motion that the command line asks for.
pub fn motion(scene: &Scene, args: &MotionArgs) -> Result<Motion> {
    let mut motion = match &args.param {
        Some(expression) => params::Registry::new(scene).motion(scene, expression)?,
        None => Motion::zero(scene),
    };
    for (shape, file) in &args.motion {
        let velocities = read_velocities(file)
            .with_context(|| format!("cannot read the velocities of \"{shape}\""))?;
        let of_shape = params::vertex_motion(scene, shape, velocities)
            .with_context(|| format!("cannot use the velocities in {}", file.display()))?;
        motion.add(&of_shape);
    }
    ensure!(
        !is_zero(&motion),
        "nothing moves: the parameters and velocities add up to zero"
    );
    Ok(motion)
}

/// True if nothing moves or changes.
pub fn is_zero(motion: &Motion) -> bool {
    let mut shapes = motion.shapes.iter().flatten();
    motion.sensor == SensorMotion::default()
        && shapes.all(|shape| {
            let mut velocities = shape.vertices.iter().chain(shape.normals.iter().flatten());
            velocities.all(|&velocity| velocity == Vec3::zero())
        })
        && motion
            .textures
            .iter()
            .flatten()
            .flatten()
            .all(|&v| v == 0.0)
}

/// A name for the motion in file headers and tables.
pub fn describe(args: &MotionArgs) -> String {
    let files = args.motion.iter();
    let files = files.map(|(shape, file)| format!("{shape}={}", file.display()));
    let parameters = args.param.iter().cloned();
    parameters.chain(files).collect::<Vec<_>>().join(" + ")
}

/// Part of the size of the fastest shape that it moves by on each side of a
/// finite difference. The bias of the difference grows with its square, the
/// variance with its inverse.
const STEP_FRACTION: f64 = 1.0 / 500.0;

/// Change of a colour, or of a unit normal, on each side of a finite difference.
/// Pictures are linear in radiance and nearly so in reflectance: the bias stays
/// small.
const COLOUR_STEP: f64 = 0.01;

/// The step of a finite difference along the motion, in units of its
/// parameter: the smallest that any of the things that move asks for.
pub fn default_step(scene: &Scene, motion: &Motion) -> f64 {
    let mut step = f64::INFINITY;
    for (shape, motion) in scene.shapes.iter().zip(&motion.shapes) {
        if let Some(motion) = motion {
            let (low, high) = shape.mesh.bounds();
            let speeds = motion.vertices.iter().map(|v| v.length());
            let fastest = speeds.fold(0.0, f64::max);
            step = step.min(STEP_FRACTION * (high - low).length() / fastest);
            let turning = motion.normals.iter().flatten().map(|v| v.length());
            step = step.min(COLOUR_STEP / turning.fold(0.0, f64::max));
        }
    }
    let (low, high) = bounds(scene);
    let size = (high - low).length();
    let sensor = &motion.sensor;
    let turning = sensor
        .axes
        .iter()
        .fold(sensor.rotation.length(), |sum, axis| sum + axis.length());
    let speed = sensor.translation.length() + turning * size;
    step = step.min(STEP_FRACTION * size / speed);
    step = step.min(film_step(scene) / film_speed(scene, motion));
    let numbers = motion.textures.iter().flatten().flatten();
    let rate = numbers.map(|v| v.abs()).fold(0.0, f64::max);
    step.min(COLOUR_STEP / rate)
}

/// How far, in pixels, what is in the picture moves on each side of a finite
/// difference. Where an outline passes a place at which the filter has a jump
/// (box) or a kink within the step, the difference smears it.
fn film_step(scene: &Scene) -> f64 {
    match scene.film.filter {
        Filter::Box => 0.03,
        Filter::Tent { .. } | Filter::Gaussian { .. } => 0.2,
    }
}

/// The largest speed on the film, in pixels per unit of the parameter, of a
/// vertex in the picture, hidden or not; and of the picture itself if the
/// sensor turns.
fn film_speed(scene: &Scene, motion: &Motion) -> f64 {
    let (sensor, film) = (&scene.sensor, &scene.film);
    let moving = sensor.moving_state(&motion.sensor);
    // The middle of the lens, and places on its rim.
    let lenses: &[[f64; 2]] = match sensor.model.has_lens() {
        true => &[[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]],
        false => &[[0.0, 0.0]],
    };
    let views = lenses
        .iter()
        .map(|&lens| View::new(sensor, film, &moving, lens));
    let views: Vec<_> = views.map(|view| (view, view.value())).collect();
    let reach = film.filter.radius();
    // Speed on the film of a point.
    let speed = |position: Vec3, velocity: Vec3| {
        let seen_from = |(view, at_rest): &(View<Dual<1>>, View<f64>)| {
            let [x, y] = view.film(view.towards(position.with_tangent(velocity)));
            let in_picture = [x, y].iter().enumerate().all(|(axis, c)| {
                let low = f64::from(film.crop_offset[axis]);
                let high = low + f64::from(film.crop_size[axis]);
                (low - reach..=high + reach).contains(&c.value)
            });
            let depth = at_rest.depth(position);
            let [near, far] = at_rest.clip();
            match in_picture && depth > 0.0 && depth > near && depth < far {
                true => x.tangent[0].hypot(y.tangent[0]),
                false => 0.0,
            }
        };
        views.iter().map(seen_from).fold(0.0, f64::max)
    };
    let vertices = scene
        .shapes
        .iter()
        .zip(&motion.shapes)
        .flat_map(|(shape, motion)| {
            shape
                .mesh
                .positions
                .iter()
                .enumerate()
                .map(move |(i, &position)| {
                    let velocity = motion
                        .as_ref()
                        .map_or(Vec3::zero(), |motion| motion.vertices[i]);
                    (position, velocity)
                })
        });
    let of_vertices = vertices.map(|(position, velocity)| speed(position, velocity));
    let [x, y] = film.crop_offset.map(f64::from);
    let [width, height] = film.crop_size.map(f64::from);
    let corners = [
        [x, y],
        [x + width, y],
        [x, y + height],
        [x + width, y + height],
    ];
    let of_corners = corners.map(|corner| {
        let view = sensor.view(film);
        let ray = view.ray(view.direction(corner));
        let [near, far] = ray.range;
        speed(
            ray.origin + ray.direction * (0.5 * (near + far)),
            Vec3::zero(),
        )
    });
    let seen = of_vertices.chain(of_corners).fold(0.0, f64::max);
    seen.max(mirrored_speed(scene, motion))
}

/// A bound of the speed on the film, near its middle, of what moves in a mirror or
/// with one: an image is as far from the eye as the path to it is long, and a ray
/// turns by twice as much as the mirror that it meets.
fn mirrored_speed(scene: &Scene, motion: &Motion) -> f64 {
    let is_specular = |shape: &Shape| may_be_specular(scene, shape.bsdf);
    if !scene.shapes.iter().any(|shape| is_specular(shape)) {
        return 0.0;
    }
    let view = scene.sensor.view(&scene.film);
    let shapes = scene.shapes.iter().zip(&motion.shapes);
    let rates = shapes.map(|(shape, motion)| {
        let Some(ShapeMotion { vertices, .. }) = motion else {
            return 0.0;
        };
        let positions = &shape.mesh.positions;
        let angular = |(&p, v): (&Vec3, &Vec3)| v.length() / (p - view.eye).length();
        let rates = positions.iter().zip(vertices).map(angular);
        let fastest = rates.filter(|rate| rate.is_finite()).fold(0.0, f64::max);
        let turn = |[a, b, c]: &[u32; 3]| {
            let along = |i: &u32, k: &u32| {
                let (i, k) = (*i as usize, *k as usize);
                (vertices[i] - vertices[k]).length() / (positions[i] - positions[k]).length()
            };
            along(a, b).max(along(b, c)).max(along(c, a))
        };
        match is_specular(shape) {
            true => 2.0 * (fastest + shape.mesh.faces.iter().map(turn).fold(0.0, f64::max)),
            false => fastest,
        }
    });
    rates.fold(0.0, f64::max) / view.pixel_size()
}

/// Smallest and largest coordinates of all shapes.
pub fn bounds(scene: &Scene) -> (Vec3, Vec3) {
    let start = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
    let shapes = scene.shapes.iter().map(|shape| shape.mesh.bounds());
    shapes.fold(start, |(low, high), (a, b)| (low.min(a), high.max(b)))
}

/// Velocities from a .npy array of shape (V, 3), or from rows of three numbers.
fn read_velocities(file: &Path) -> Result<Vec<Vec3>> {
    let bytes = fs::read(file).with_context(|| format!("cannot open {}", file.display()))?;
    let numbers = if bytes.starts_with(b"\x93NUMPY") {
        npy_numbers(&bytes)
    } else {
        text_numbers(&bytes)
    };
    let numbers = numbers.with_context(|| format!("{} is not usable", file.display()))?;
    let rows = numbers.chunks_exact(3);
    Ok(rows.map(|row| Vec3::new(row[0], row[1], row[2])).collect())
}

fn npy_numbers(bytes: &[u8]) -> Result<Vec<f64>> {
    let open = || npyz::NpyFile::new(bytes);
    let shape = open()?.shape().to_vec();
    ensure!(
        shape.len() == 2 && shape[1] == 3,
        "the array has the shape {shape:?}; expected (V, 3)"
    );
    ensure!(
        open()?.order() == npyz::Order::C,
        "the array is stored column by column; save numpy.ascontiguousarray(array) instead"
    );
    if let Ok(doubles) = open()?.try_data::<f64>() {
        return Ok(doubles.collect::<Result<_, _>>()?);
    }
    let Ok(floats) = open()?.try_data::<f32>() else {
        bail!("the array holds no floating point numbers; expected float32 or float64");
    };
    Ok(floats.map(|x| x.map(f64::from)).collect::<Result<_, _>>()?)
}

fn text_numbers(bytes: &[u8]) -> Result<Vec<f64>> {
    let text = std::str::from_utf8(bytes).context("it is neither a .npy file nor text")?;
    let mut numbers = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default();
        let words: Vec<&str> = line.split_whitespace().collect();
        if words.is_empty() {
            continue;
        }
        let row: Result<Vec<f64>, _> = words.iter().map(|word| word.parse()).collect();
        match row {
            Ok(row) if row.len() == 3 => numbers.extend(row),
            _ => bail!(
                "line {} is \"{}\"; expected three numbers, \"x y z\"",
                i + 1,
                line.trim()
            ),
        }
    }
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_scene::{Bsdf, Optic};

    #[test]
    fn rows_of_text() {
        let rows = b"# velocities\n1 2 3\n\n 4e-1 -5 6 # last\n";
        assert_eq!(text_numbers(rows).unwrap(), [1.0, 2.0, 3.0, 0.4, -5.0, 6.0]);
        let message = text_numbers(b"1 2 3\n1 2\n").unwrap_err().to_string();
        assert_eq!(
            message,
            "line 2 is \"1 2\"; expected three numbers, \"x y z\""
        );
    }

    /// An array file as numpy writes it.
    fn npy(dtype: &str, shape: &str, data: &[u8]) -> Vec<u8> {
        let header = format!("{{'descr': '{dtype}', 'fortran_order': False, 'shape': {shape}, }}");
        let header = format!("{header:117}\n"); // 128 bytes with what stands before
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend((header.len() as u16).to_le_bytes());
        bytes.extend(header.bytes());
        bytes.extend(data);
        bytes
    }

    #[test]
    fn arrays_of_numpy() {
        let numbers = [1.0, -2.0, 0.5, 4.0, 5.0, 6.0];
        let doubles: Vec<u8> = numbers.iter().flat_map(|x: &f64| x.to_le_bytes()).collect();
        let floats = numbers.iter().map(|&x| x as f32);
        let floats: Vec<u8> = floats.flat_map(f32::to_le_bytes).collect();
        assert_eq!(
            npy_numbers(&npy("<f8", "(2, 3)", &doubles)).unwrap(),
            numbers
        );
        assert_eq!(
            npy_numbers(&npy("<f4", "(2, 3)", &floats)).unwrap(),
            numbers
        );
        let message = |bytes: &[u8]| npy_numbers(bytes).unwrap_err().to_string();
        assert_eq!(
            message(&npy("<f8", "(3, 2)", &doubles)),
            "the array has the shape [3, 2]; expected (V, 3)"
        );
        assert!(message(&npy("<i8", "(2, 3)", &doubles)).contains("float32 or float64"));
        assert!(npy_numbers(&npy("<f8", "(4, 3)", &doubles)).is_err());
    }

    /// What is in the picture moves by a fixed part of a pixel.
    #[test]
    fn steps_follow_the_film() {
        let mut scene = capwalk_scene::builtin::scene("ball").unwrap();
        let step = |scene: &Scene, expression: &str| {
            let motion = params::Registry::new(scene)
                .motion(scene, expression)
                .unwrap();
            default_step(scene, &motion)
        };
        // The middle of the picture turns by this many pixels per radian.
        let fov_x = scene.sensor.model.optic(Optic::FovX).unwrap();
        let focal = 0.5 * f64::from(scene.film.size[0]) / (0.5 * fov_x).tan();
        let turn = step(&scene, "sensor.rotate.y");
        assert!(
            turn < 0.03 / focal * 1.2 && turn > 0.03 / focal * 0.6,
            "{turn}"
        );
        // With another field of view, the corners move farthest.
        let fov = params::Registry::new(&scene)
            .motion(&scene, "sensor.x_fov")
            .unwrap();
        let zoomed = scene.moved(&fov, default_step(&scene, &fov)).sensor;
        let corner = scene.sensor.view(&scene.film).direction([0.0, 0.0]);
        let [x, y] = zoomed.view(&scene.film).film(corner);
        assert!((x.hypot(y) / 0.03 - 1.0).abs() < 0.01, "{x} {y}");
        let coarse = step(&scene, "ball.translate.x");
        scene.film.size = scene.film.size.map(|n| 2 * n);
        scene.film.crop_size = scene.film.size;
        let fine = step(&scene, "ball.translate.x");
        assert!(
            (coarse / fine - 2.0).abs() < 1e-6,
            "{coarse} against {fine}"
        );
    }

    /// Normals that turn where nothing moves.
    #[test]
    fn normals_alone() {
        let scene = capwalk_scene::builtin::scene("ball").unwrap();
        let motion = |text| params::Registry::new(&scene).motion(&scene, text).unwrap();
        let turning = motion("ball.normals[7,2]");
        assert!(!is_zero(&turning));
        let step = default_step(&scene, &turning);
        assert!((COLOUR_STEP..0.2).contains(&step), "{step}");
        assert!(is_zero(&motion("0*ball.normals[7,2]")));
    }

    /// What a mirror shows turns twice as fast as the mirror.
    #[test]
    fn steps_follow_what_mirrors_show() {
        let mut scene = capwalk_scene::builtin::scene("ball").unwrap();
        let step = |scene: &Scene| {
            let motion = params::Registry::new(scene)
                .motion(scene, "floor.rotate.z")
                .unwrap();
            default_step(scene, &motion)
        };
        let dull = step(&scene);
        let floor = scene.shapes.iter().find(|s| s.id == "floor").unwrap();
        scene.materials[floor.bsdf.0 as usize].bsdf = Bsdf::Null; // specular, as mirrors are
        let view = scene.sensor.view(&scene.film);
        let turn = 2.0 * 0.03 * view.pixel_size();
        assert!(dull > turn && step(&scene) < 0.5 * turn, "{dull} {turn}");
    }

    /// The fastest vertex moves by a fixed part of the shape, whatever the
    /// parameter's unit.
    #[test]
    fn steps_follow_the_size_of_what_moves() {
        let scene = capwalk_scene::builtin::scene("leaf").unwrap();
        let step = |expression: &str| {
            let motion = params::Registry::new(&scene)
                .motion(&scene, expression)
                .unwrap();
            default_step(&scene, &motion)
        };
        let leaf = scene.shapes.iter().find(|s| s.id == "leaf").unwrap();
        let (low, high) = leaf.mesh.bounds();
        let expected = (high - low).length() / 500.0;
        assert!((step("leaf.translate.x") / expected - 1.0).abs() < 1e-12);
        assert!((step("10*leaf.translate.x") / expected - 0.1).abs() < 1e-12);
        let both = step("leaf.translate.x + 100*floor.bsdf.reflectance.value");
        assert!((both / (COLOUR_STEP / 100.0) - 1.0).abs() < 1e-12);
        assert!(step("sensor.translate.x") > step("leaf.translate.x"));
    }
}
