//! Emitters other than `area`: what they are, and what is wrong with them.

use capwalk_math::{Rgb, Vec3};
use capwalk_scene::params::{self, ParameterKind};
use capwalk_scene::{Emitter, Pattern, Scene};

use crate::common::*;

/// A scene with one emitter, which stands in line 4 from column 3 on.
fn with(emitter: &str) -> String {
    scene("").replace("<emitter type=\"constant\"/>", emitter)
}

fn emitted(scene: &Scene) -> Rgb {
    scene.texture(scene.emitters[0].radiance()).texel(0)
}

/// Directions and what Mitsuba 3.9.1 shows there of the same map.
const MITSUBA: [([f64; 3], [f64; 3]); 3] = [
    ([0.3, 0.2, 0.9], [0.5761851, 0.0146311, 0.6764585]),
    ([-0.5, 0.8, -0.1], [0.7634884, 0.8076165, 0.8973499]),
    ([-1.0, 0.1, 0.01], [0.7639314, 1.2898765, 0.5195876]),
];

#[test]
fn environment_maps() {
    let scene = load(&with(
        "<emitter type=\"envmap\" id=\"sky\"><string name=\"filename\" value=\"sky.exr\"/>\
         <float name=\"scale\" value=\"2\"/><transform name=\"to_world\">\
         <rotate x=\"0.6\" y=\"0.8\" angle=\"70\"/></transform></emitter>",
    ));
    let Emitter::EnvironmentMap {
        map, data, scale, ..
    } = &scene.emitters[0]
    else {
        panic!("an environment map");
    };
    assert_eq!((map.width, map.height), (4, 3));
    assert_eq!(scene.texture(*scale).texel(0).r, 2.0);
    for (direction, expected) in MITSUBA {
        let direction = Vec3::from(direction).normalized();
        let value = map.lookup(direction, |i| scene.texture(*data).texel(i)) * 2.0;
        let error = (value - Rgb::from(expected)).length();
        assert!(error < 1e-5, "{direction:?}: {value:?}");
    }
    for (name, kind) in [
        ("sky.data", ParameterKind::Radiance),
        ("sky.data.b", ParameterKind::Radiance),
        ("sky.scale", ParameterKind::Factor),
    ] {
        let parameters = params::Registry::new(&scene).scalars(&scene);
        let found = parameters.iter().find(|p| p.name == name).expect(name);
        assert_eq!((found.kind, found.moves_discontinuities), (kind, false));
    }
}

#[test]
fn points_and_spots() {
    let scene = load(&with(
        "<emitter type=\"point\"><point name=\"position\" x=\"1\" y=\"2\" z=\"3\"/>\
         <rgb name=\"intensity\" value=\"4, 5, 6\"/></emitter>",
    ));
    assert!(
        matches!(&scene.emitters[0], Emitter::Point { id, position, .. }
        if id == "point" && *position == Vec3::new(1.0, 2.0, 3.0))
    );
    assert_eq!(emitted(&scene), Rgb::new(4.0, 5.0, 6.0));
    params::Registry::new(&scene)
        .tangent(&scene, "point.intensity.value.g")
        .expect("listed");

    let scene = load(&with(
        "<emitter type=\"spot\"><transform name=\"to_world\">\
         <lookat origin=\"1, 2, 3\" target=\"1, 0, 3\" up=\"0, 0, 1\"/></transform></emitter>",
    ));
    let Emitter::Spot {
        world_from_emitter,
        cutoff_angle,
        beam_width,
        ..
    } = &scene.emitters[0]
    else {
        panic!("a spot");
    };
    assert_eq!(world_from_emitter.translation, Vec3::new(1.0, 2.0, 3.0));
    let axis = world_from_emitter.vector(Vec3::new(0.0, 0.0, 1.0));
    assert!((axis - Vec3::new(0.0, -1.0, 0.0)).length() < 1e-15);
    assert_eq!(scene.texture(*cutoff_angle).data, [20.0]);
    assert_eq!(scene.texture(*beam_width).data, [15.0]);
    let widening = params::Registry::new(&scene)
        .tangent(&scene, "spot.cutoff_angle")
        .expect("listed");
    let wide = scene
        .moved(&widening, -5.0)
        .check()
        .expect_err("no range to fall off in");
    assert!(
        wide.to_string().contains("less than the cutoff_angle"),
        "{wide}"
    );
    assert_eq!(
        widening,
        params::Registry::new(&scene)
            .tangent(&scene, "spot.cutoff_angle.value")
            .expect("listed")
    );
}

#[test]
fn parallel_light() {
    for properties in [
        "<vector name=\"direction\" x=\"0\" y=\"-3\" z=\"4\"/>",
        "<transform name=\"to_world\"><lookat origin=\"0, 0, 0\" target=\"0, -3, 4\" \
         up=\"1, 0, 0\"/></transform>",
    ] {
        let text = with(&format!(
            "<emitter type=\"directional\">{properties}</emitter>"
        ));
        let Emitter::Directional { direction, .. } = &load(&text).emitters[0] else {
            panic!("directional");
        };
        assert!((*direction - Vec3::new(0.0, -0.6, 0.8)).length() < 1e-15);
    }
}

/// An image twice as wide as high has twice the field of view in its width.
#[test]
fn projectors() {
    let text = with(
        "<emitter type=\"projector\"><float name=\"fov\" value=\"90\"/>\
         <string name=\"fov_axis\" value=\"y\"/><float name=\"scale\" value=\"3\"/>\
         <texture name=\"irradiance\" type=\"bitmap\">\
         <string name=\"filename\" value=\"sky.exr\"/></texture></emitter>",
    );
    let scene = load(&text);
    let Emitter::Projector {
        half_size: [width, height],
        irradiance,
        scale,
        ..
    } = &scene.emitters[0]
    else {
        panic!("a projector");
    };
    let Pattern::Bitmap(bitmap) = &scene.texture(*irradiance).pattern else {
        panic!("an image");
    };
    assert!((height - 1.0).abs() < 1e-12);
    let aspect = f64::from(bitmap.width) / f64::from(bitmap.height);
    assert!(aspect > 1.0 && (width - aspect).abs() < 1e-12);
    assert_eq!(scene.texture(*scale).data, [3.0]);
    let registry = params::Registry::new(&scene);
    for name in ["projector.scale", "projector.irradiance.data"] {
        registry.tangent(&scene, name).expect("listed");
    }
    let refused = registry.tangent(&scene, "projector.to_world");
    let refused = refused.expect_err("no parameter").to_string();
    assert!(refused.contains("where a projector stands"), "{refused}");
}

#[test]
fn wrong_projectors() {
    check(
        &with("<emitter type=\"projector\"><float name=\"fov\" value=\"180\"/></emitter>"),
        &[
            "scene.xml:4:54: \"fov\" is 180",
            "  expected an angle between 0 and 180 degrees",
        ],
    );
    check(
        &with(
            "<emitter type=\"projector\"><texture name=\"irradiance\" type=\"mesh_attribute\">\
             <string name=\"name\" value=\"vertex_color\"/></texture></emitter>",
        ),
        &[
            "scene.xml:4:29: projector.irradiance is \"projector.irradiance\", which covers surfaces \
             only; expected a colour, a bitmap or a checkerboard",
        ],
    );
    check(
        &with(
            "<emitter type=\"projector\"><transform name=\"to_world\"><scale value=\"2\"/>\
             </transform></emitter>",
        ),
        &[
            "scene.xml:4:29: the \"to_world\" of the emitter \"projector\" scales, shears or mirrors",
            "  expected a rotation and a translation",
        ],
    );
}

#[test]
fn wrong_properties() {
    check(
        &with("<emitter type=\"point\"><float name=\"intensty\" value=\"1\"/></emitter>"),
        &[
            "scene.xml:4:38: unknown property \"intensty\" of the emitter \"point\"",
            "  its properties are intensity, position, sampling_weight, to_world",
            "  did you mean \"intensity\"?",
        ],
    );
    check(
        &with("<emitter type=\"spot\"><float name=\"beam_width\" value=\"30\"/></emitter>"),
        &[
            "scene.xml:4:56: \"beam_width\" is 30 and \"cutoff_angle\" is 20",
            "  expected degrees, 0 <= beam_width < cutoff_angle <= 180",
        ],
    );
    check(
        &with("<emitter type=\"spot\"><rgb name=\"texture\" value=\"0.5\"/></emitter>"),
        &[
            "scene.xml:4:51: the \"texture\" of a spot light is the same everywhere",
            "  expected a bitmap or a checkerboard; a colour is its \"intensity\"",
        ],
    );
    check(
        &with(
            "<emitter type=\"spot\"><float name=\"cutoff_angle\" value=\"90\"/>\
             <texture type=\"checkerboard\" name=\"texture\"/></emitter>",
        ),
        &[
            "scene.xml:4:58: spot.cutoff_angle.value is (90, 90, 90); expected less than 90 degrees, \
             because the light throws an image",
        ],
    );
    check(
        &with("<emitter type=\"directional\"><vector name=\"direction\" value=\"0\"/></emitter>"),
        &[
            "scene.xml:4:63: the light has no direction",
            "  expected a vector that is not zero: where the light goes",
        ],
    );
    check(
        &with("<emitter type=\"envmap\"/>"),
        &[
            "scene.xml:4:3: the emitter \"envmap\" names no file",
            "  add <string name=\"filename\" value=\"sky.exr\"/>",
        ],
    );
    check(
        &with(
            "<emitter type=\"envmap\"><transform name=\"to_world\"><scale value=\"2\"/>\
             </transform><string name=\"filename\" value=\"sky.exr\"/></emitter>",
        ),
        &[
            "scene.xml:4:26: the \"to_world\" of the emitter \"envmap\" scales, shears or mirrors",
            "  expected a rotation and a translation",
        ],
    );
    check(
        &with(
            "<emitter type=\"constant\"/><emitter type=\"envmap\"><string name=\"filename\" value=\"sky.exr\"/></emitter>",
        ),
        &[
            "scene.xml:4:29: there is more than one emitter around the scene (constant, envmap); \
             keep one",
        ],
    );
    check(
        &with(
            "<emitter type=\"point\"><texture name=\"intensity\" type=\"checkerboard\"/></emitter>",
        ),
        &[
            "scene.xml:4:25: the intensity of the emitter \"point\" is a texture",
            "  give one colour; an image of all directions is <emitter type=\"envmap\">",
        ],
    );
    check(
        &scene("<shape type=\"cube\"><emitter type=\"point\"/></shape>"),
        &[
            "scene.xml:5:22: a point emitter stands inside a shape",
            "  move it into <scene>, or write <emitter type=\"area\">",
        ],
    );
}
