//! Scenes made by code, to try things on without any file.
//!
//! In all of them y is up, the floor is `y = 0`, and the emitter is a square that
//! faces down. Nothing lines up exactly with pixels, axes or the emitter.

mod ball;
mod box_room;
mod lattice;
mod lattice_shadow;
mod leaf;
mod stage;
mod voronoi;

use crate::scene::Scene;

/// The description of a built-in scene before it is made.
#[derive(Clone, Copy, Debug)]
pub struct Builtin {
    /// Its name.
    pub name: &'static str,
    /// What it shows, in one line.
    pub description: &'static str,
    /// The parameter it was made for.
    pub default_parameter: &'static str,
    make: fn() -> Scene,
}

/// All built-in scenes, the simplest first.
pub const ALL: [Builtin; 4] = [
    Builtin {
        name: "leaf",
        description: "the shadow of one triangle on a floor; the triangle is out of sight",
        default_parameter: "leaf.translate.x",
        make: leaf::scene,
    },
    Builtin {
        name: "ball",
        description: "a sphere above a floor, and its shadow; both are seen",
        default_parameter: "ball.translate.x",
        make: ball::scene,
    },
    Builtin {
        name: "box-room",
        description: "a box in a room under an emitter (after figure 9 of the paper)",
        default_parameter: "box.translate.x",
        make: box_room::scene,
    },
    Builtin {
        name: "lattice-shadow",
        description: "the shadow of a closed lattice of thin struts with 72 000 triangles \
                      (after figure 11 of the paper)",
        default_parameter: "lattice.translate.y",
        make: lattice_shadow::scene,
    },
];

/// The names of all built-in scenes.
pub fn names() -> impl Iterator<Item = &'static str> {
    ALL.iter().map(|builtin| builtin.name)
}

/// The built-in scene of this name. It passes [`Scene::check`].
pub fn scene(name: &str) -> Option<Scene> {
    find(name).map(|builtin| (builtin.make)())
}

/// The parameter that a built-in scene was made for.
pub fn default_parameter(name: &str) -> Option<&'static str> {
    find(name).map(|builtin| builtin.default_parameter)
}

/// What a built-in scene shows, in one line.
pub fn description(name: &str) -> Option<&'static str> {
    find(name).map(|builtin| builtin.description)
}

fn find(name: &str) -> Option<&'static Builtin> {
    ALL.iter().find(|builtin| builtin.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params;
    use capwalk_geometry::oracle::first_hit;
    use capwalk_geometry::{Hit, Ray};
    use capwalk_math::Vec3;

    #[test]
    fn every_scene_can_be_rendered_and_differentiated() {
        for name in names() {
            let scene = scene(name).expect("it is listed");
            scene.check().expect(name);
            let parameter = default_parameter(name).expect("it is listed");
            let tangent = params::Registry::new(&scene)
                .tangent(&scene, parameter)
                .expect(parameter);
            assert!(tangent.shapes.iter().any(Option::is_some), "{name}");
            assert!(description(name).is_some_and(|text| text.len() < 100));
            assert_eq!(
                super::scene(name),
                Some(scene),
                "{name} must be the same each time"
            );
        }
        assert!(scene("teapot").is_none() && default_parameter("teapot").is_none());
    }

    /// What each camera sees in a grid of directions that reaches the corners
    /// of the film.
    #[test]
    fn cameras_see_what_they_should() {
        for (name, must, may) in [
            ("leaf", &["floor"][..], &[][..]),
            ("ball", &["floor", "ball"], &[]),
            (
                "box-room",
                &["floor", "box", "back", "left", "right"],
                &["ceiling", "lamp"],
            ),
            ("lattice-shadow", &["floor"], &[]),
        ] {
            let scene = scene(name).expect("it is listed");
            let mut seen = std::collections::BTreeSet::new();
            for i in 0..=12 {
                for j in 0..=9 {
                    let [w, h] = scene.film.size.map(f64::from);
                    let point = [w * f64::from(i) / 12.0, h * f64::from(j) / 9.0];
                    let view = scene.sensor.view(&scene.film);
                    let ray = Ray::new(view.origin, view.direction(point));
                    seen.insert(first_shape(&scene, &ray).expect("no hole in the background"));
                }
            }
            for id in must {
                assert!(seen.contains(id), "{name} must see {id}");
            }
            for id in seen {
                assert!(must.contains(&id) || may.contains(&id), "{name} sees {id}");
            }
        }
    }

    fn first_shape<'a>(scene: &'a Scene, ray: &Ray) -> Option<&'a str> {
        let hits = scene.shapes.iter().filter_map(|shape| {
            let hit: Hit = first_hit(&shape.mesh, ray)?;
            Some((hit.t, shape.id.as_str()))
        });
        hits.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, id)| id)
    }

    /// The emitter is above everything, faces down, and the floor faces up.
    #[test]
    fn emitters_face_down_and_floors_up() {
        for name in names() {
            let scene = scene(name).expect("it is listed");
            let normal = |id: &str| {
                let shape = scene.shapes.iter().find(|s| s.id == id).expect(id);
                assert_eq!(shape.mesh.faces.len(), 2);
                shape.mesh.face_cross(0).normalized()
            };
            assert!((normal("lamp") - Vec3::new(0.0, -1.0, 0.0)).length() < 1e-12);
            assert!((normal("floor") - Vec3::new(0.0, 1.0, 0.0)).length() < 1e-12);
        }
    }
}
