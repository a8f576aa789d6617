use capwalk_geometry::edge::closest_direction;
use capwalk_geometry::{Edge, Mesh};
use capwalk_math::{Affine, Frame};
use capwalk_scene::lobe::{Conductor, Event};
use capwalk_scene::primitive::{cube, icosphere, rectangle};
use capwalk_scene::{Film, Scene, SensorModel, ShadingNormals, Shape, Texture, builtin};
use capwalk_walk::Domain;

use super::*;
use crate::accel::Accel;
use crate::boundaries::Boundaries;
use crate::method::Method;
use crate::reach::MovingBoundaries;
use crate::warp::Warp;

/// The ball and its emitter, flat-shaded, over a floor that is a mirror.
fn mirrored() -> Scene {
    let mut scene = builtin::scene("ball").expect("built in");
    let mut number = |id: &str, x: f64| scene.add_texture(Texture::number(id, x));
    let metal = Conductor {
        eta: number("eta", 0.0),
        k: number("k", 1.0),
        specular_reflectance: number("tint", 1.0),
    };
    let floor = scene.shapes[0].bsdf;
    scene.materials[floor.0 as usize].bsdf = metal.into();
    for shape in scene.shapes_mut() {
        shape.normals = ShadingNormals::Face;
        shape.uvs = None;
    }
    scene
}

/// The same world without the mirror, and behind it what it shows.
fn doubled() -> Scene {
    let mut scene = mirrored();
    let viewpoint = scene.sensor.origin();
    let floor = &mut scene.shape_mut(capwalk_scene::ShapeId(0)).mesh;
    // Out of sight, above the viewpoint.
    let away = |p: &Vec3| *p * 1e-3 + viewpoint * 50.0;
    floor.positions = floor.positions.iter().map(away).collect();
    for shape in scene.shapes_mut().skip(1) {
        let mut image = shape.mesh.clone();
        image.positions.iter_mut().for_each(|p| p.y = -p.y);
        shape.mesh.append(&image);
    }
    scene
}

/// Images are what one would see if the mirror were a window: the same closest
/// points, found without any mirror.
#[test]
fn images_are_seen_through_windows() {
    let scenes = [mirrored(), doubled()];
    assert_eq!(scenes[0].shapes[0].id, "floor");
    let [with, without] = [Accel::new(scenes[0].clone()), Accel::new(scenes[1].clone())];
    let boundaries = [&with, &without].map(Boundaries::new);
    let fields = [
        Field::new(&with, &boundaries[0], Method::Walk),
        Field::new(&without, &boundaries[1], Method::Walk),
    ];
    let viewpoint: Viewpoint<f64> = Viewpoint::camera(&with.view, 1);
    let [mirror, window] = fields.each_ref().map(|field| sphere(field, &viewpoint));
    let view = scenes[0].sensor.view(&scenes[0].film);
    let [width, height] = scenes[0].film.size.map(f64::from);
    let mut images = 0;
    for i in 0..4000 {
        // A lattice that fills the film evenly.
        let at = [0.754_877_666, 0.569_840_291].map(|a| (f64::from(i) * a).fract());
        let q = view.direction([width * at[0], height * at[1]]);
        let [seen, expected] = [mirror.closest(q, 0.1), window.closest(q, 0.1)];
        let distances = [&seen, &expected].map(|it| it.map_or(0.1, |it| it.distance));
        assert!(
            (distances[0] - distances[1]).abs() < 1e-9,
            "{q:?}: {distances:?}"
        );
        let Some((seen, expected)) = seen.zip(expected) else {
            continue;
        };
        assert!((seen.point - expected.point).length() < 1e-7, "{q:?}");
        images += usize::from(!seen.site.is_direct);
    }
    assert!(images > 100, "{images} images");
}

/// Where walks are said to reach nothing that moves, they find nothing that does: neither the ball, nor images of
/// it in one mirror or two in turn, nor images in a mirror that moves itself. In most of the other places some do.
#[test]
fn walks_out_of_reach_find_nothing_that_moves() {
    let mut scene = mirrored();
    let metal = scene.shapes[0].bsdf;
    let turned = Affine::rotate(Vec3::new(0.0, 1.0, 0.0), 0.3);
    let (wall, normals) = rectangle(Affine::translate(Vec3::new(0.0, 1.0, -2.0)) * turned);
    scene.add_shape(Shape::new("wall", wall, normals, metal));
    let accel = Accel::new(scene.clone());
    let boundaries = Boundaries::new(&accel);
    let field = Field::new(&accel, &boundaries, Method::Walk);
    let number = |i: u32, k: u32| (f64::from(i) * f64::from(2 * k + 3).sqrt() * 0.618_034).fract();
    for (moving, least) in [("ball", [2500, 500, 80]), ("wall", [700, 300, 150])] {
        let moves = |i: u32| {
            let is_vertex = (i as usize) < accel.mesh.positions.len();
            is_vertex && scene.shapes[accel.shape_of_vertex(i).0 as usize].id == moving
        };
        let edges = boundaries.subset(|edge| boundaries.edge(edge).vertices.into_iter().any(moves));
        let reach = MovingBoundaries {
            edges: &edges,
            mirrors: moving == "wall",
        };
        // How often nothing is reached, something that moves is found, and is seen in a mirror.
        let mut counts = [0; 3];
        for i in 0..4000 {
            let place = |k| 3.0 * number(i, k) - 1.5;
            let position = Vec3::new(place(1), 0.5 * place(2) + 0.9, place(3));
            let q = Vec3::new(place(4), place(5), place(6)).normalized();
            let events = i % 4;
            let up = Vec3::new(0.0, 1.0, 0.0);
            let viewpoint: Viewpoint<f64> = Viewpoint::towards_surfaces(position, up, events);
            let settings = WalkSettings {
                steps: 1 + i / 4 % 2,
                max_radius: 0.12,
                ..WalkSettings::default()
            };
            let sphere = sphere(&field, &viewpoint);
            let sample = sample_field(&sphere, q, &settings, |k| number(i, 7 + k));
            let sample = sample.map(|seen| field.boundary_sample(&viewpoint, seen));
            let in_mirrors = sample.terms().any(|term| !term.site.mirrors.is_empty());
            let depends = Warp::Boundary(sample)
                .depends(&field, moves, false)
                .divergence;
            let reaches = field.reaches(&viewpoint, q, &settings, reach);
            assert!(reaches || !depends, "{moving}, {i}");
            counts[0] += u32::from(!reaches);
            counts[1] += u32::from(depends);
            counts[2] += u32::from(depends && in_mirrors);
        }
        let is_enough = counts
            .iter()
            .zip(&least)
            .all(|(count, least)| count >= least);
        assert!(is_enough, "{moving}: {counts:?}");
    }
}

/// The built-in ball under parallel rays, on a film of so many units' half width.
fn flattened(half_width: f64) -> Scene {
    let mut scene = builtin::scene("ball").expect("built in");
    scene.sensor.model = SensorModel::Orthographic;
    let scale = Affine::scale(Vec3::new(half_width, half_width, 1.0));
    scene.sensor.world_from_camera = scene.sensor.world_from_camera * scale;
    scene
}

/// Film points at fractions of the film that fill a square in its middle evenly.
fn lattice(film: &Film, part: f64) -> impl Iterator<Item = [f64; 2]> {
    let [width, height] = film.size.map(f64::from);
    (0..2000).map(move |i| {
        let at = [0.754_877_666, 0.569_840_291].map(|a| (f64::from(i) * a).fract() - 0.5);
        [width * (0.5 + part * at[0]), height * (0.5 + part * at[1])]
    })
}

/// All edges, one after the other: those whose closest point is the first that its
/// ray meets between the clip planes.
#[test]
fn the_closest_edge_in_the_image() {
    let mut scene = flattened(1.0);
    scene.sensor.near_clip = 2.5;
    let accel = Accel::new(scene.clone());
    let boundaries = Boundaries::new(&accel);
    let field = Field::new(&accel, &boundaries, Method::Walk);
    let (view, edges) = (&accel.view, field.boundaries.edges());
    let viewpoint: Viewpoint<f64> = Viewpoint::camera(view, 0);
    let sphere = sphere(&field, &viewpoint);
    let limit = 0.05;
    let mut found = 0;
    for at in lattice(&scene.film, 1.0).take(300) {
        let q = view.direction(at);
        let in_image = |edge: &Edge| {
            let ends = edge.vertices.map(|i| field.boundaries.point([i; 2], 0.0));
            let [a, b] = ends.map(|p| view.towards(p));
            let closest = closest_direction(a, b, q).filter(|it| it.angle < limit)?;
            let place = view.place(ends[0] + (ends[1] - ends[0]) * closest.t);
            let ray = accel.camera_ray(view.origin, closest.direction);
            let first = accel.first_hit_within(&ray).map_or(ray.t_max, |hit| hit.t);
            let is_seen = place.z > ray.t_min && place.z < first + 1e-7;
            is_seen.then_some(closest.angle)
        };
        let expected = edges.iter().filter_map(in_image).reduce(f64::min);
        let nearest = sphere.closest(q, limit);
        let angle = nearest.as_ref().map(|nearest| nearest.distance);
        assert_eq!(angle.is_some(), expected.is_some(), "{at:?}");
        if let Some((angle, expected)) = angle.zip(expected) {
            assert!((angle - expected).abs() < 1e-12, "{at:?}");
            found += 1;
        }
    }
    assert!(found > 50, "{found} edges");
}

/// Looks from points on a ball with waves of this height, and from each in low directions all
/// around.
fn low_directions(waves: f64, mut ask: impl FnMut(&Field, &Viewpoint<f64>, Vec3)) {
    let mut scene = builtin::scene("ball").expect("built in");
    let shape = scene.shapes_mut().find(|shape| shape.id == "ball");
    let shape = shape.expect("it is there");
    (shape.normals, shape.uvs) = (ShadingNormals::Face, None);
    shape.mesh = icosphere(24);
    for p in &mut shape.mesh.positions {
        let wave = (7.0 * p.x).sin() * (6.0 * p.y).cos() * (5.0 * p.z).sin();
        *p = *p * (0.45 * (1.0 + waves * wave)) + Vec3::new(0.0, 0.7, 0.0);
    }
    let accel = Accel::new(scene.clone());
    let boundaries = Boundaries::new(&accel);
    let field = Field::new(&accel, &boundaries, Method::Walk);
    let mut points = 0;
    for at in lattice(&scene.film, 1.0).take(1000) {
        let ray = accel.camera_ray(accel.view.origin, accel.view.direction(at));
        let Some(hit) = accel.first_hit_within(&ray) else {
            continue;
        };
        if accel.scene.shape(accel.shape_of(&hit)).id != "ball" {
            continue;
        }
        let normal = accel.mesh.face_cross(hit.face as usize).normalized();
        let viewpoint = Viewpoint::towards_surfaces(ray.at(hit.t), normal, 0);
        let Frame { s, t, .. } = Frame::from_normal(normal);
        for i in 0..8 {
            let (sin, cos) = (0.3 + f64::from(i)).sin_cos();
            let height = normal * (0.01 * f64::from(i + 1));
            ask(
                &field,
                &viewpoint,
                (s * sin + t * cos + height).normalized(),
            );
        }
        points += 1;
    }
    assert!(points > 50, "{points}");
}

/// A search that knows what faces hide finds what one that asks for every edge does: from both sides of all surfaces of
/// a room in which a ball lies, a cube stands on the floor and a plate cuts it, in all directions. It asks for two thirds
/// at most.
#[test]
fn what_is_in_shadows_is_not_seen() {
    let mut scene = builtin::scene("box-room").expect("built in");
    let bsdf = scene.shapes[0].bsdf;
    let put = |place| Affine::translate(place) * Affine::scale(Vec3::splat(0.25));
    for (name, mesh, place) in [
        ("lying", icosphere(16), Vec3::new(0.5, 0.25, 0.5)),
        (
            "standing",
            cube(Affine::IDENTITY).0,
            Vec3::new(-0.6, 0.25, 0.5),
        ),
        (
            "cutting",
            rectangle(Affine::scale(Vec3::splat(2.0))).0,
            Vec3::new(-0.3, 0.1, 0.8),
        ),
    ] {
        let positions = mesh.positions.iter().map(|&p| put(place).point(p));
        let mesh = Mesh {
            positions: positions.collect(),
            ..mesh
        };
        scene.add_shape(Shape::new(name, mesh, ShadingNormals::Face, bsdf));
    }
    let accel = Accel::new(scene);
    let boundaries = Boundaries::new(&accel);
    let field = Field::new(&accel, &boundaries, Method::Walk);
    let number = |i: usize, k: u32| (i as f64 * f64::from(2 * k + 3).sqrt() * 0.618_034).fract();
    let asked = [Cell::new(0), Cell::new(0)];
    let (mut found, mut low, mut level) = (0, 0, 0);
    for i in 0..4000 {
        // From all surfaces; and from before the plate, at the height of the cube's upper edges behind it.
        let is_level = i % 4 == 0;
        let face = (number(i, 0) * accel.mesh.faces.len() as f64) as usize;
        let face = if i % 2 == 0 { face } else { i / 2 % 60 };
        let [a, b, c] = accel.mesh.corners(face);
        let weight = number(i, 1);
        let (position, normal) = match is_level {
            true => (Vec3::new(weight - 1.1, 0.5, 0.95), Vec3::new(0.0, 1.0, 0.0)),
            false => (
                a + (b - a) * (weight * number(i, 2)) + (c - a) * (1.0 - weight),
                accel.mesh.face_cross(face).normalized(),
            ),
        };
        let side = if i % 3 == 0 { -1.0 } else { 1.0 };
        let normal = normal * side;
        let viewpoint = Viewpoint::towards_surfaces(position, normal, 0);
        let leaving = Leaving::after(Event::Reflect, face as u32, normal);
        let axis = Vec3::new(number(i, 3), number(i, 4), number(i, 5)) - Vec3::splat(0.5);
        let axis = match is_level {
            true => Vec3::new(-0.6, 0.5, 0.5) + axis * 0.2 - position,
            false => axis,
        };
        let from = SeenFrom {
            field: &field,
            viewpoint: &viewpoint,
            apex: position,
        };
        let behind = SeenBehind {
            field: &field,
            viewpoint: &viewpoint,
            leaving: &leaving,
        };
        let query = ConeQuery {
            apex: position,
            axis: axis.normalized(),
            max_angle: 2.0,
            edges: EdgeSelection::All,
            groups: u8::MAX,
            in_front_of: None,
        };
        for sight in [&from as &dyn Sight, &behind] {
            let count = |asked: &Cell<u32>| asked.set(asked.get() + 1);
            let every = |point: &SilhouettePoint| {
                count(&asked[0]);
                sight.sees(point)
            };
            let counted = Counted {
                sight,
                asked: &asked[1],
            };
            let tree = boundaries.tree();
            let expected = tree.closest_where(&query, &every);
            assert_eq!(tree.closest_where(&query, &counted), expected, "{i}");
            found += usize::from(expected.is_some());
            low += usize::from(expected.is_some_and(|it| it.direction.dot(normal) < 0.0));
            let is_seen = expected.is_some_and(|it| field.horizon(&viewpoint, &it).is_some());
            level += usize::from(is_level && is_seen);
        }
    }
    let asked = asked.map(Cell::into_inner);
    assert!(
        found > 3000 && low > 500 && level > 500 && 3 * asked[1] < 2 * asked[0],
        "{found}, {low}, {level}, {asked:?}"
    );
}

/// Counts what is asked for.
struct Counted<'a> {
    sight: &'a dyn Sight,
    asked: &'a Cell<u32>,
}

impl Sight for Counted<'_> {
    fn sees(&self, point: &SilhouettePoint) -> bool {
        self.asked.set(self.asked.get() + 1);
        self.sight.sees(point)
    }

    fn shadow(&self, point: &SilhouettePoint) -> Option<Shadow> {
        self.sight.shadow(point)
    }
}

/// The edges of a point's own face are its horizon, all around it: no direction above it is farther
/// from a boundary. On a fine mesh the neighbours' edges below, seen through the inside of the
/// shape, would be the closest otherwise, and turn fast.
#[test]
fn nothing_hides_the_horizon() {
    low_directions(0.0, |field, viewpoint, q| {
        let normal = viewpoint.face_normal.expect("on a face");
        let nearest = sphere(field, viewpoint).closest(q, 3.0);
        let distance = nearest.expect("the horizon at least").distance;
        assert!(distance < normal.dot(q).asin() + 1e-9, "{distance}, {q:?}");
    });
}

/// Close to the horizon all motion across an edge counts, and less of that along it, down to none:
/// in hollows, where neighbours of a face rise above its horizon.
#[test]
fn motion_along_low_edges_is_damped() {
    let mut low = 0;
    low_directions(0.12, |field, viewpoint, q| {
        let normal = viewpoint.face_normal.expect("on a face");
        let found = sphere(field, viewpoint).closest(q, 3.0);
        let seen = found.expect("the horizon at least").site;
        let sample = field.boundary_sample(viewpoint, &seen);
        if sample.is_horizon {
            return;
        }
        let x = seen.point.direction;
        let [a, b] = sample.points.map(|i| field.boundaries.position(i));
        let along = (b - a).reject_from(x).normalized();
        let across = x.cross(along);
        let velocity = Vec3::new(0.4, -0.7, 0.2) / seen.point.distance;
        let moved = sample.angular(velocity * seen.point.distance);
        let height = (normal.dot(x).abs() / Field::LOW).min(1.0);
        let size = 1e-9 * velocity.length();
        assert!(moved.dot(x).abs() < size);
        assert!((moved.dot(across) - velocity.dot(across)).abs() < size);
        assert!((moved.dot(along) - height * velocity.dot(along)).abs() < size);
        low += usize::from(height < 0.3);
    });
    assert!(low > 50, "{low}");
}
