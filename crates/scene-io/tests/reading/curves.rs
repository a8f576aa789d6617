//! Curves, cylinders, groups and instances.

use capwalk_math::{Affine, Vec3};
use capwalk_scene::{ShadingNormals, Shape};

use crate::common::*;

fn curves(plugin: &str, file: &str, more: &str) -> String {
    scene(&format!(
        "<shape type=\"{plugin}\"><string name=\"filename\" value=\"{file}\"/>{more}</shape>"
    ))
}

/// Control points move, and radii stay, as in Mitsuba.
#[test]
fn curves_are_tubes_where_their_transform_puts_them() {
    let stretch = "<transform name=\"to_world\"><scale value=\"2\"/></transform>";
    let scene = load(&curves("linearcurve", "curves.txt", stretch));
    let shape = &scene.shapes[0];
    assert_eq!(shape.id, "curves");
    assert_eq!(shape.world_from_object, Affine::scale(Vec3::splat(2.0)));
    let (low, high) = shape.mesh.bounds();
    // The joints' spheres reach beyond the control points; polygons are 1 % off.
    assert!(
        (low - Vec3::new(-0.2, -0.2, -0.2)).length() < 5e-3,
        "{low:?}"
    );
    assert!(
        (high - Vec3::new(2.2, 4.1, 2.1)).length() < 5e-3,
        "{high:?}"
    );
    assert_eq!(
        shape.uvs.as_ref().map(Vec::len),
        Some(shape.mesh.faces.len())
    );
    assert!(matches!(shape.normals, ShadingNormals::Given(_)));
}

#[test]
fn bad_curves() {
    for (plugin, file, lines) in [
        (
            "bsplinecurve",
            "curves.txt",
            [
                "line 2: the curve that ends here has 2 control points",
                "  expected 4 or more; empty lines stand between curves only",
            ],
        ),
        (
            "linearcurve",
            "short_line.txt",
            [
                "line 2: \"1 0 0\" is no control point",
                "  expected four numbers: x, y, z, radius",
            ],
        ),
        (
            "linearcurve",
            "negative_radius.txt",
            [
                "line 2: the radius is -1",
                "  expected a number from 0 to 1e30",
            ],
        ),
    ] {
        let place = 42 + plugin.len();
        check(
            &curves(plugin, file, ""),
            &[
                &format!("scene.xml:5:{}: \"FOLDER/{file}\", {}", place + 7, lines[0]),
                lines[1],
            ],
        );
    }
    check(
        &curves("linearcurve", "same_place.txt", ""),
        &[
            "scene.xml:5:60: curve 0 of \"FOLDER/same_place.txt\" has no direction at its control \
             point 0, both counted from 0",
            "  expected control points at different places",
        ],
    );
    check(
        &curves(
            "linearcurve",
            "curves.txt",
            "<boolean name=\"flip_normals\" value=\"true\"/>",
        ),
        &[
            "scene.xml:5:88: unknown property \"flip_normals\" of the shape \"linearcurve\"",
            "  its properties are filename, silhouette_sampling_weight, to_world",
        ],
    );
}

/// What the unit cylinder becomes: its axis, its radius, and the side of its front.
#[test]
fn cylinders_lie_between_their_points() {
    let text = "<shape type=\"cylinder\"><point name=\"p0\" x=\"1\" y=\"0\" z=\"0\"/>\
                <point name=\"p1\" x=\"1\" y=\"3\" z=\"0\"/><float name=\"radius\" value=\"0.5\"/>\
                <boolean name=\"flip_normals\" value=\"true\"/></shape>";
    let scene = load(&scene(text));
    let shape = &scene.shapes[0];
    let (low, high) = shape.mesh.bounds();
    assert!((low - Vec3::new(0.5, 0.0, -0.5)).length() < 1e-3, "{low:?}");
    assert!(
        (high - Vec3::new(1.5, 3.0, 0.5)).length() < 1e-3,
        "{high:?}"
    );
    let end = shape.world_from_object.point(Vec3::new(0.0, 0.0, 1.0));
    assert!((end - Vec3::new(1.0, 3.0, 0.0)).length() < 1e-12);
    let inward = Vec3::new(1.0, 1.5, 0.0) - shape.mesh.corners(0)[0];
    assert!(shape.mesh.face_cross(0).dot(inward) > 0.0);
}

#[test]
fn cylinders_without_extent() {
    check(
        &scene(r#"<shape type="cylinder"><point name="p1" x="0" y="0" z="0"/></shape>"#),
        &[
            "scene.xml:5:26: the cylinder ends where it begins",
            "  expected two different points, \"p0\" and \"p1\"",
        ],
    );
    check(
        &scene(r#"<shape type="cylinder"><float name="radius" value="0"/></shape>"#),
        &[
            "scene.xml:5:54: \"radius\" is 0",
            "  expected a number other than 0",
        ],
    );
}

const GROUP: &str = "<shape type=\"shapegroup\" id=\"g\"><shape type=\"cube\" id=\"box\"/>\
                     <shape type=\"sphere\"/></shape>";

/// Each instance has a copy of each shape under its own transform, with one material; the
/// front stays where it was under a mirror.
#[test]
fn instances_are_copies() {
    let scene = load(&scene(&format!(
        "{GROUP}<shape type=\"instance\" id=\"a\"><ref id=\"g\"/></shape>\
         <shape type=\"instance\"><ref id=\"g\"/><transform name=\"to_world\">\
         <scale x=\"-2\" y=\"1\" z=\"1\"/><translate x=\"5\"/></transform></shape>"
    )));
    let ids: Vec<&str> = scene.shapes.iter().map(|s| &*s.id).collect();
    assert_eq!(
        ids,
        ["a.box", "a.sphere", "instance.box", "instance.sphere"]
    );
    assert_eq!(scene.shapes[0].bsdf, scene.shapes[2].bsdf);
    let [cube, mirrored] = [&scene.shapes[0], &scene.shapes[2]];
    let (low, high) = mirrored.mesh.bounds();
    assert_eq!(
        (low, high),
        (Vec3::new(3.0, -1.0, -1.0), Vec3::new(7.0, 1.0, 1.0))
    );
    for shape in [cube, mirrored] {
        let centre = shape.centre();
        for face in 0..shape.mesh.faces.len() {
            let outward = shape.mesh.corners(face)[0] - centre;
            assert!(shape.mesh.face_cross(face).dot(outward) > 0.0);
        }
    }
    for shape in [&scene.shapes[1], &scene.shapes[3]] {
        let normals = shape.normals.per_vertex().expect("a sphere is smooth");
        for (face, corners) in shape.mesh.faces.iter().enumerate().step_by(101) {
            let n = shape.mesh.face_cross(face).normalized();
            assert!(corners.iter().all(|&i| n.dot(normals[i as usize]) > 0.98));
            assert!(n.dot(shape.mesh.corners(face)[0] - shape.centre()) > 0.0);
        }
    }
    // Its coordinates move with its matrix.
    let corner = mirrored.world_from_object.point(Vec3::splat(-1.0));
    assert_eq!(corner, mirrored.mesh.positions[0]);
}

/// The only shape of a group is called by its instance: `tree.translate.x` moves it.
#[test]
fn instances_of_one_shape_have_its_name() {
    let scene = load(&scene(
        "<shape type=\"instance\" id=\"tree\"><ref id=\"g\"/></shape>\
         <shape type=\"shapegroup\" id=\"g\"><shape type=\"cube\"/></shape>",
    ));
    let ids: Vec<&str> = scene.shapes.iter().map(|s| &*s.id).collect();
    assert_eq!(ids, ["tree"]);
}

#[test]
fn bad_instances() {
    check(
        &scene("<shape type=\"instance\"/>"),
        &[
            "scene.xml:5:3: the shape \"instance\" shows no group",
            "  add <ref id=\"...\"/> with the id of a <shape type=\"shapegroup\">",
        ],
    );
    check(
        &scene("<shape type=\"instance\"><shape type=\"cube\"/></shape>"),
        &[
            "scene.xml:5:26: the shape \"instance\" shows a shape that is not a group",
            "  expected a <shape type=\"shapegroup\"> around the shape",
        ],
    );
    check(
        &scene(
            "<shape type=\"shapegroup\"><shape type=\"cube\"><emitter type=\"area\"/></shape></shape>",
        ),
        &[
            "scene.xml:5:47: the shape \"cube\" cannot have an emitter",
            "  shapes of groups emit no light, as in Mitsuba; put it outside of the group",
        ],
    );
    check(
        &scene(
            "<shape type=\"shapegroup\"><shape type=\"instance\"><shape type=\"shapegroup\"/></shape></shape>",
        ),
        &[
            "scene.xml:5:28: the shape \"instance\" stands in a group",
            "  expected shapes; groups stand in the scene, side by side",
        ],
    );
    let sphere = "<shape type=\"shapegroup\" id=\"g\"><shape type=\"sphere\"/></shape>";
    let many = "<shape type=\"instance\"><ref id=\"g\"/></shape>".repeat(278);
    let message = message(&scene(&format!("{sphere}\n{many}")), &[]);
    assert!(
        message.contains(
            "scene.xml:6:12189: with this instance, all instances have 16819000 triangles"
        ),
        "{message}"
    );
}

#[test]
fn groups_without_instances_warn() {
    let text = scene(GROUP);
    let loaded = capwalk_scene_io::load_scene_str(&text, &folder(), "scene.xml", &[]);
    let loaded = loaded.expect("a scene");
    assert!(loaded.scene.shapes.is_empty());
    let warnings: Vec<String> = loaded.warnings.iter().map(|w| w.to_string()).collect();
    let warned = warnings
        .iter()
        .any(|w| w.contains("no instance shows this group"));
    assert!(warned, "{warnings:?}");
}

/// As in Mitsuba, computed normals are those of the group and go through the map; a map that
/// keeps angles gives the same as computing them behind it.
#[test]
fn computed_normals_of_instances() {
    let normals = |map: &str| {
        let scene = load(&scene(&format!(
            "<shape type=\"shapegroup\" id=\"g\"><shape type=\"obj\"><string name=\"filename\" \
             value=\"roof.obj\"/></shape></shape><shape type=\"instance\"><ref id=\"g\"/>\
             <transform name=\"to_world\">{map}</transform></shape>"
        )));
        (*scene.shapes[0]).clone()
    };
    let group = normals("");
    let flat = normals("<scale x=\"2\" y=\"0.5\" z=\"3\"/>");
    let mirrored = normals("<scale x=\"2\" y=\"-0.5\" z=\"3\"/>");
    let turned = normals("<scale value=\"2\"/><rotate y=\"1\" angle=\"90\"/>");
    assert!(matches!(group.normals, ShadingNormals::Computed(_)));
    assert!(matches!(turned.normals, ShadingNormals::Computed(_)));
    let of = |shape: &Shape| shape.normals.per_vertex().expect("smooth").to_vec();
    let near = |a: Vec3, b: Vec3| assert!((a - b).length() < 1e-12, "{a:?} {b:?}");
    for (i, n) in of(&group).into_iter().enumerate() {
        assert!(n.x != 0.0 || n.z != 0.0 || i > 3, "{n:?}");
        near(
            of(&flat)[i],
            Vec3::new(n.x / 2.0, n.y * 2.0, n.z / 3.0).normalized(),
        );
        near(
            of(&mirrored)[i],
            Vec3::new(n.x / 2.0, n.y * -2.0, n.z / 3.0).normalized(),
        );
        near(of(&turned)[i], Vec3::new(n.z, n.y, -n.x));
    }
    for shape in [&flat, &mirrored, &turned] {
        for (face, corners) in shape.mesh.faces.iter().enumerate() {
            let front = shape.mesh.face_cross(face);
            assert!(
                corners
                    .iter()
                    .all(|&i| front.dot(of(shape)[i as usize]) > 0.0)
            );
        }
    }
}

/// An instance of nothing is nothing, and says so.
#[test]
fn instances_of_empty_groups_warn() {
    let text =
        "<shape type=\"shapegroup\" id=\"g\"/><shape type=\"instance\"><ref id=\"g\"/></shape>";
    let (scene, warnings) = load_with_warnings(&scene(text));
    assert!(scene.shapes.is_empty());
    let expected =
        "scene.xml:5:49: the group of this instance has no shapes: it is not in the image";
    assert!(warnings.iter().any(|w| w == expected), "{warnings:?}");
}
