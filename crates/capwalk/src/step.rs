//! By how much a finite difference moves its parameter.

use capwalk_diff::{PreparedScene, Wanted, may_be_specular};
use capwalk_math::{Dual, Vec3};
use capwalk_scene::sensor::view::View;
use capwalk_scene::{Emitter, Film, Filter, Scene, Shape, ShapeVectors, Tangent, TextureId};

/// Part of the size of the fastest shape that it moves by on each side of a
/// finite difference. The bias of the difference grows with its square, the
/// variance with its inverse.
const STEP_FRACTION: f64 = 1.0 / 100.0;

/// Change of a colour, or of a unit normal, on each side of a finite difference.
/// Images are linear in radiance and nearly so in reflectance: the bias stays
/// small.
const COLOUR_STEP: f64 = 0.01;

/// The step of a finite difference along the motion, in units of its
/// parameter: the smallest that any of the things that move asks for.
pub fn difference_step(prepared: &PreparedScene, tangent: &Tangent) -> f64 {
    let scene = &**prepared.scene();
    let mut step = f64::INFINITY;
    // Vertices move by a part of their shape, given normals by as much as colours.
    for (shape, tangent) in scene.shapes.iter().zip(&tangent.shapes) {
        if let Some(tangent) = tangent {
            let (low, high) = shape.mesh.bounds();
            let speeds = tangent.vertices.iter().map(|v| v.length());
            let fastest = speeds.fold(0.0, f64::max);
            step = step.min(STEP_FRACTION * (high - low).length() / fastest);
            let turning = tangent.normals.iter().flatten().map(|v| v.length());
            step = step.min(COLOUR_STEP / turning.fold(0.0, f64::max));
        }
    }
    // The sensor moves by a part of the scene, turned or not.
    let (low, high) = bounds(scene);
    let size = (high - low).length();
    let sensor = &tangent.sensor;
    let turning = sensor
        .axes
        .iter()
        .fold(sensor.rotation.length(), |sum, axis| sum + axis.length());
    let speed = sensor.translation.length() + turning * size;
    step = step.min(STEP_FRACTION * size / speed);
    step = step.min(light_step(scene, tangent, size));
    // Nothing in the image moves by more than a part of a pixel.
    step = step.min(film_step(scene) / film_speed(prepared, tangent));
    // Numbers of materials and emitters change a little.
    let numbers = tangent.textures.iter().flatten().flatten();
    let rate = numbers.map(|v| v.abs()).fold(0.0, f64::max);
    step.min(COLOUR_STEP / rate)
}

/// The step at which lights without extent move by a part of the scene, which has a size,
/// and turn by a small angle.
fn light_step(scene: &Scene, tangent: &Tangent, size: f64) -> f64 {
    let lights = scene.emitters.iter().zip(&tangent.emitters);
    let steps = lights.map(|(emitter, moving)| {
        let angle = match emitter {
            Emitter::Spot {
                cutoff_angle,
                beam_width,
                ..
            } => {
                // Its intensity falls to zero between these.
                let degrees = |id: &TextureId| scene.texture(*id).data[0];
                (degrees(cutoff_angle) - degrees(beam_width)).to_radians()
            }
            _ => 1.0,
        };
        let moved = STEP_FRACTION * size / moving.translation.length();
        moved.min(COLOUR_STEP * angle / moving.rotation.length())
    });
    steps.fold(f64::INFINITY, f64::min)
}

/// How far, in pixels, what is in the image moves on each side of a finite
/// difference. Where a silhouette passes a place at which the filter is discontinuous
/// (box) or has a kink within the step, the difference smears it.
fn film_step(scene: &Scene) -> f64 {
    match scene.film.filter {
        Filter::Box => 0.1,
        Filter::Tent { .. }
        | Filter::Gaussian { .. }
        | Filter::Mitchell { .. }
        | Filter::Lanczos { .. } => 0.2,
    }
}

/// The largest speed on the film, in pixels per unit of the parameter, of a
/// vertex in the image, or an end of a hard shadow's edge, hidden or not; and of what is
/// seen at some places if the sensor moves.
fn film_speed(prepared: &PreparedScene, tangent: &Tangent) -> f64 {
    let scene = &**prepared.scene();
    let (sensor, film) = (&scene.sensor, &scene.film);
    let moving = sensor.moving_state(&tangent.sensor);
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
        let seen_from = |(view, primal): &(View<Dual<1>>, View<f64>)| {
            let [x, y] = view.film(view.towards(position.with_tangent(velocity)));
            let in_image = [x, y].iter().enumerate().all(|(axis, c)| {
                let low = f64::from(film.crop_offset[axis]);
                let high = low + f64::from(film.crop_size[axis]);
                (low - reach..=high + reach).contains(&c.value)
            });
            let depth = primal.depth(position);
            let [near, far] = primal.clip();
            match in_image && depth > 0.0 && depth > near && depth < far {
                true => x.tangent[0].hypot(y.tangent[0]),
                false => 0.0,
            }
        };
        views.iter().map(seen_from).fold(0.0, f64::max)
    };
    let vertices = scene
        .shapes
        .iter()
        .zip(&tangent.shapes)
        .flat_map(|(shape, tangent)| {
            shape
                .mesh
                .positions
                .iter()
                .enumerate()
                .map(move |(i, &position)| {
                    let velocity = tangent
                        .as_ref()
                        .map_or(Vec3::zero(), |tangent| tangent.vertices[i]);
                    (position, velocity)
                })
        });
    let shadows = shadow_ends(prepared, tangent);
    let of_points = vertices.chain(shadows);
    let of_points = of_points.map(|(position, velocity)| speed(position, velocity));
    let view = sensor.view(film);
    let of_places = places(film)
        .filter_map(|place| seen_at(prepared, &view, place))
        .map(|point| speed(point, Vec3::zero()));
    let seen = of_points.chain(of_places).fold(0.0, f64::max);
    seen.max(mirrored_speed(scene, tangent))
}

/// The ends of the edges of hard shadows, and their velocities.
fn shadow_ends(prepared: &PreparedScene, tangent: &Tangent) -> impl Iterator<Item = (Vec3, Vec3)> {
    let scene = &**prepared.scene();
    let has_shadows = scene.emitters.iter().any(Emitter::is_delta);
    // Listing the boundaries takes time, and where nothing moves they rest.
    let lines = (has_shadows && Wanted::by(tangent).geometry()).then(|| {
        let shapes = scene.shapes.iter().zip(&tangent.shapes);
        let mut velocities = Vec::new();
        for (shape, tangent) in shapes {
            match tangent {
                Some(tangent) => velocities.extend(&tangent.vertices),
                None => {
                    velocities.resize(velocities.len() + shape.mesh.positions.len(), Vec3::zero())
                }
            }
        }
        velocities.extend(scene.anchor_velocities(tangent));
        let lines = prepared.boundaries().shadow_lines();
        let ends = lines.iter().flat_map(|line| &line.ends);
        let moving = ends.map(move |end| (end.position, end.velocity(&velocities)));
        moving.collect::<Vec<_>>()
    });
    lines.into_iter().flatten()
}

/// Steps between the places on the film at which its own motion is measured, along each
/// side.
const STEPS_ALONG_FILM: u32 = 4;

/// Places on the film, its corners among them, pixels.
fn places(film: &Film) -> impl Iterator<Item = [f64; 2]> {
    let (offset, size) = (film.crop_offset, film.crop_size);
    let along = move |axis: usize, i: u32| {
        f64::from(offset[axis]) + f64::from(size[axis]) * f64::from(i) / f64::from(STEPS_ALONG_FILM)
    };
    (0..=STEPS_ALONG_FILM)
        .flat_map(move |j| (0..=STEPS_ALONG_FILM).map(move |i| [along(0, i), along(1, j)]))
}

/// A point in world space that stands for what is seen at a place on the film: rays from
/// one point turn by the same angle at every distance, parallel rays move by more the
/// farther away the surface is that they hit.
fn seen_at(prepared: &PreparedScene, view: &View<f64>, place: [f64; 2]) -> Option<Vec3> {
    let accel = prepared.accel();
    let ray = accel.camera_ray(view.origin, view.direction(place));
    let distance = match view.is_parallel() {
        false => 0.5 * (ray.t_min + ray.t_max),
        true => accel.first_hit_within(&ray)?.t,
    };
    Some(ray.origin + ray.direction * distance)
}

/// A bound of the speed on the film, near its middle, of what moves in a mirror or
/// with one: a mirror image is as far from the camera as the path to it is long, and a ray
/// turns by twice as much as the mirror that it meets.
fn mirrored_speed(scene: &Scene, tangent: &Tangent) -> f64 {
    let is_specular = |shape: &Shape| may_be_specular(scene, shape.bsdf);
    if !scene.shapes.iter().any(|shape| is_specular(shape)) {
        return 0.0;
    }
    let view = scene.sensor.view(&scene.film);
    let shapes = scene.shapes.iter().zip(&tangent.shapes);
    let rates = shapes.map(|(shape, tangent)| {
        let Some(ShapeVectors { vertices, .. }) = tangent else {
            return 0.0;
        };
        let positions = &shape.mesh.positions;
        let angular = |(&p, v): (&Vec3, &Vec3)| v.length() / (p - view.origin).length();
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

/// Smallest and largest coordinates of all vertices, world units.
pub fn bounds(scene: &Scene) -> (Vec3, Vec3) {
    let start = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
    let shapes = scene.shapes.iter().map(|shape| shape.mesh.bounds());
    shapes.fold(start, |(low, high), (a, b)| (low.min(a), high.max(b)))
}

#[cfg(test)]
mod tests {
    use capwalk_scene::params::Registry;

    use super::*;
    use capwalk_math::Rgb;
    use capwalk_scene::lobe::Null;
    use capwalk_scene::{Optic, SensorModel, Texture};

    fn difference_step(scene: &Scene, tangent: &Tangent) -> f64 {
        super::difference_step(&PreparedScene::new(scene.clone()), tangent)
    }

    /// What is in the image moves by a fixed part of a pixel.
    #[test]
    fn steps_follow_the_film() {
        let mut scene = capwalk_scene::builtin::scene("ball").unwrap();
        let step = |scene: &Scene, expression: &str| {
            let tangent = Registry::new(scene).tangent(scene, expression).unwrap();
            difference_step(scene, &tangent)
        };
        // The middle of the image turns by this many pixels per radian.
        let fov_x = scene.sensor.model.optic(Optic::FovX).unwrap();
        let focal = 0.5 * f64::from(scene.film.size[0]) / (0.5 * fov_x).tan();
        let turn = step(&scene, "sensor.rotate.y");
        assert!(
            turn < 0.1 / focal * 1.2 && turn > 0.1 / focal * 0.6,
            "{turn}"
        );
        // With another field of view, the corners move farthest.
        let fov = Registry::new(&scene)
            .tangent(&scene, "sensor.x_fov")
            .unwrap();
        let zoomed = scene.moved(&fov, difference_step(&scene, &fov)).sensor;
        let corner = scene.sensor.view(&scene.film).direction([0.0, 0.0]);
        let [x, y] = zoomed.view(&scene.film).film(corner);
        assert!((x.hypot(y) / 0.1 - 1.0).abs() < 0.01, "{x} {y}");
        let coarse = step(&scene, "ball.translate.x");
        scene.film.size = scene.film.size.map(|n| 2 * n);
        scene.film.crop_size = scene.film.size;
        let fine = step(&scene, "ball.translate.x");
        assert!(
            (coarse / fine - 2.0).abs() < 1e-6,
            "{coarse} against {fine}"
        );
    }

    /// Parallel rays that turn move what they hit by its distance, not by that of the clip
    /// planes.
    #[test]
    fn steps_of_parallel_rays_follow_what_is_seen() {
        let mut scene = capwalk_scene::builtin::scene("ball").unwrap();
        scene.sensor.model = SensorModel::Orthographic;
        scene.sensor.far_clip = 1e4;
        let tangent = Registry::new(&scene)
            .tangent(&scene, "sensor.rotate.y")
            .unwrap();
        let step = difference_step(&scene, &tangent);
        let view = scene.sensor.view(&scene.film);
        let prepared = PreparedScene::new(scene.clone());
        let seen = places(&scene.film).filter_map(|place| seen_at(&prepared, &view, place));
        let farthest = seen.map(|point| view.depth(point)).fold(0.0, f64::max);
        assert!(farthest > 1.0 && farthest < 100.0, "{farthest}");
        let one_pixel = 0.1 * view.pixel_size() / farthest;
        assert!(step > 0.2 * one_pixel, "{step} against {one_pixel}");
    }

    /// Normals that turn where nothing moves.
    #[test]
    fn normals_alone() {
        let scene = capwalk_scene::builtin::scene("ball").unwrap();
        let tangent = |text| Registry::new(&scene).tangent(&scene, text).unwrap();
        let turning = tangent("ball.normals[7,2]");
        let step = difference_step(&scene, &turning);
        assert!((COLOUR_STEP..0.2).contains(&step), "{step}");
    }

    /// What a mirror shows turns twice as fast as the mirror.
    #[test]
    fn steps_follow_what_mirrors_show() {
        let mut scene = capwalk_scene::builtin::scene("ball").unwrap();
        let step = |scene: &Scene| {
            let tangent = Registry::new(scene)
                .tangent(scene, "floor.rotate.z")
                .unwrap();
            difference_step(scene, &tangent)
        };
        let dull = step(&scene);
        let floor = scene.shapes.iter().find(|s| s.id == "floor").unwrap();
        scene.materials[floor.bsdf.0 as usize].bsdf = Null::default().into(); // specular, as mirrors are
        let view = scene.sensor.view(&scene.film);
        let turn = 2.0 * 0.1 * view.pixel_size();
        assert!(dull > turn && step(&scene) < 0.5 * turn, "{dull} {turn}");
    }

    /// The fastest vertex moves by a fixed part of the shape, whatever the
    /// parameter's unit.
    #[test]
    fn steps_follow_the_size_of_what_moves() {
        let scene = capwalk_scene::builtin::scene("leaf").unwrap();
        let step = |expression: &str| {
            let tangent = Registry::new(&scene).tangent(&scene, expression).unwrap();
            difference_step(&scene, &tangent)
        };
        let leaf = scene.shapes.iter().find(|s| s.id == "leaf").unwrap();
        let (low, high) = leaf.mesh.bounds();
        let expected = (high - low).length() / 100.0;
        assert!((step("leaf.translate.x") / expected - 1.0).abs() < 1e-12);
        assert!((step("10*leaf.translate.x") / expected - 0.1).abs() < 1e-12);
        let both = step("leaf.translate.x + 100*floor.bsdf.reflectance.value");
        assert!((both / (COLOUR_STEP / 100.0) - 1.0).abs() < 1e-12);
        // The sensor moves by a part of the scene, where pixels do not limit it.
        let mut coarse = scene.clone();
        (coarse.film.size, coarse.film.crop_size) = ([1; 2], [1; 2]);
        *coarse.sensor.model.optic_mut(Optic::FovX).unwrap() = 3.1;
        let tangent = Registry::new(&coarse).tangent(&coarse, "sensor.translate.x");
        let (low, high) = bounds(&coarse);
        let expected = (high - low).length() / 100.0;
        let found = difference_step(&coarse, &tangent.unwrap());
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }

    /// Boundaries are listed for the step of what moves hard shadows, and of nothing else.
    #[test]
    fn the_step_of_a_colour_lists_no_boundaries() {
        let mut scene = capwalk_scene::builtin::scene("leaf").unwrap();
        let intensity = scene.add_texture(Texture::colour("intensity", Rgb::splat(1.0)));
        scene.emitters.push(Emitter::Point {
            id: "bulb".into(),
            position: Vec3::new(0.2, 0.1, 3.0),
            intensity,
        });
        let prepared = PreparedScene::new(scene);
        let has_listed = |parameter: &str| {
            let scene = prepared.scene();
            let tangent = Registry::new(scene).tangent(scene, parameter).unwrap();
            super::difference_step(&prepared, &tangent);
            prepared.has_boundaries()
        };
        assert!(!has_listed("floor.bsdf.reflectance.value"));
        assert!(has_listed("bulb.translate.x"));
    }
}
