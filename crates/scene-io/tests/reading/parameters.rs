//! `<default>`, `$name`, definitions from outside, `<include>`, `<path>`, `<alias>`.

use capwalk_math::Rgb;
use capwalk_scene::Bsdf;
use capwalk_scene::lobe::{Diffuse, Lobe};
use capwalk_scene_io::LoadError;
use capwalk_scene_io::mesh::{MeshFileError, MeshPlace};

use crate::common::*;

fn radius_scene(before: &str, value: &str) -> String {
    scene(&format!(
        "{before}<shape type=\"sphere\"><float name=\"radius\" value=\"{value}\"/></shape>"
    ))
}

/// Radius of the sphere in the scene.
fn radius(text: &str, defines: &[(&str, &str)]) -> f64 {
    let scene = try_load(text, defines).unwrap_or_else(|error| panic!("{error}"));
    scene.shapes[0].mesh.positions[0].length()
}

#[test]
fn definitions_win_over_defaults() {
    let text = radius_scene("<default name=\"r\" value=\"2\"/>", "$r");
    assert!((radius(&text, &[]) - 2.0).abs() < 1e-12);
    assert!((radius(&text, &[("r", "3")]) - 3.0).abs() < 1e-12);
}

/// As in Mitsuba: the longest name that fits, and text around it.
#[test]
fn the_longest_name_is_taken() {
    let both = "<default name=\"r\" value=\"2\"/><default name=\"rad\" value=\"3\"/>";
    assert!((radius(&radius_scene(both, "$rad"), &[]) - 3.0).abs() < 1e-12);
    assert!((radius(&radius_scene(both, "$r.5"), &[]) - 2.5).abs() < 1e-12);
    assert!((radius(&radius_scene(both, "0$r"), &[]) - 2.0).abs() < 1e-12);
    // A default may use an earlier one.
    let chain = "<default name=\"a\" value=\"4\"/><default name=\"b\" value=\"$a\"/>";
    assert!((radius(&radius_scene(chain, "$b"), &[]) - 4.0).abs() < 1e-12);
}

#[test]
fn escaped_dollar_is_a_dollar() {
    let text = scene("<shape type=\"cube\" id=\"a\\$b\"/>");
    assert_eq!(load(&text).shapes[0].id, "a$b");
}

#[test]
fn unused_definition() {
    let text = radius_scene("<default name=\"radius\" value=\"2\"/>", "$radius");
    assert_eq!(
        message(&text, &[("raduis", "3")]),
        "scene.xml: nothing in the scene uses $raduis, which is defined as \"3\"\n  \
         the file's parameters are radius\n  did you mean \"radius\"?"
    );
    assert_eq!(
        message(&scene(""), &[("spp", "3")]),
        "scene.xml: nothing in the scene uses $spp, which is defined as \"3\"\n  \
         the file has no parameters"
    );
}

#[test]
fn contradictory_and_nameless_definitions() {
    assert_eq!(
        message(&scene(""), &[("a", "1"), ("a", "2")]),
        "scene.xml: the parameter a is defined twice, as \"1\" and as \"2\"\n  define it once"
    );
    assert_eq!(
        message(&scene(""), &[("", "1")]),
        "scene.xml: \"\", defined as \"1\", cannot be the name of a parameter\n  \
         expected letters, digits and underscores"
    );
}

#[test]
fn includes_bring_objects_and_use_parameters() {
    let text = scene(
        "<default name=\"red\" value=\"0.25\"/><include filename=\"materials.xml\"/>\
         <include filename=\"one_material.xml\"/>\
         <shape type=\"cube\"><ref id=\"red\"/></shape>",
    );
    let scene = load(&text);
    let Bsdf::Plain(Lobe::Diffuse(Diffuse { reflectance })) =
        scene.material(scene.shapes[0].bsdf).bsdf
    else {
        panic!("diffuse");
    };
    let reflectance = scene.texture(reflectance).texel(0);
    assert_eq!(reflectance, Rgb::new(0.25, 0.0, 0.0));
    assert_eq!(scene.materials[1].id, "grey");
}

#[test]
fn errors_in_included_files_name_both_places() {
    check(
        &scene("<include filename=\"bad_material.xml\"/>"),
        &[
            "FOLDER/bad_material.xml:3:16: unknown property \"reflektance\" of the bsdf \"diffuse\"",
            "  its properties are reflectance",
            "  did you mean \"reflectance\"?",
            "  included at scene.xml:5:22",
        ],
    );
}

#[test]
fn files_that_include_themselves() {
    check(
        &scene("<include filename=\"loop.xml\"/>"),
        &[
            "FOLDER/loop.xml:2:22: \"FOLDER/loop.xml\" includes itself",
            "  remove this <include>",
            "  included at scene.xml:5:22",
        ],
    );
}

/// What stands in an included file is looked for beside it, and then beside the files that
/// include it, as in Mitsuba: `<path>` and `<include>` alike.
#[test]
fn included_files_look_beside_those_that_include_them() {
    let scene = load(&scene("<include filename=\"include/nested.xml\"/>"));
    assert_eq!(scene.shapes[0].id, "square");
    assert_eq!(scene.material(scene.shapes[0].bsdf).id, "grey");
}

#[test]
fn paths_are_searched_for_files() {
    let folder = folder();
    let parent = folder.parent().expect("tests/data has a parent");
    let text = scene(
        "<path value=\"data\"/><shape type=\"obj\">\
         <string name=\"filename\" value=\"square.obj\"/></shape>",
    );
    let scene = capwalk_scene_io::load_scene_str(&text, parent, "scene.xml", &[]);
    assert_eq!(scene.expect("a scene").scene.shapes[0].mesh.faces.len(), 2);
}

#[test]
fn aliases_are_second_names() {
    let text = scene(
        "<bsdf type=\"diffuse\" id=\"a\"/><alias id=\"a\" as=\"b\"/>\
         <shape type=\"cube\"><ref id=\"b\"/></shape>",
    );
    let scene = load(&text);
    assert_eq!(scene.material(scene.shapes[0].bsdf).id, "a");
    check(
        &crate::common::scene("<alias id=\"a\" as=\"b\"/>"),
        &[
            "scene.xml:5:14: there is no object with the id \"a\"",
            "  give the id=\"...\" of an object in this file or an included one",
        ],
    );
}

/// Files from some editors begin with a byte order mark and end lines with
/// carriage returns.
#[test]
fn byte_order_marks_and_carriage_returns() {
    let text = format!(
        "\u{feff}{}",
        scene("<shape type=\"spere\"/>").replace('\n', "\r\n")
    );
    let error = try_load(&text, &[]).expect_err("a bad scene");
    let position = error.position().expect("a place");
    assert_eq!((position.line, position.column), (5, 16));
    assert_eq!(&text[position.span.clone()], "spere");
}

#[test]
fn missing_scene_file() {
    let error = capwalk_scene_io::load_scene("no/such.xml".as_ref(), &[]).expect_err("no file");
    assert!(error.position().is_none());
    let message = error.to_string();
    assert!(
        message.starts_with("no/such.xml: cannot read \"no/such.xml\": "),
        "{message}"
    );
}

/// The parts of an error, for front ends that draw their own.
#[test]
fn errors_have_parts() {
    let text = scene("<shape type=\"spere\"/>");
    let error = try_load(&text, &[]).expect_err("a bad scene");
    assert_eq!((error.line(), error.column()), (Some(5), Some(16)));
    let position = error.position().expect("a place");
    assert_eq!(&text[position.span.clone()], "spere");
    assert_eq!(error.file(), None);
    let LoadError::Unknown(diagnostic) = &error else {
        panic!("{error:?}");
    };
    assert_eq!(diagnostic.location.name, "scene.xml");
    assert_eq!(diagnostic.near, ["sphere"]);
    assert_eq!(diagnostic.message, "unknown shape plugin \"spere\"");
    assert!(diagnostic.help.is_some() && diagnostic.notes.is_empty());
}

/// Callers can tell mistakes apart.
#[test]
fn errors_have_kinds() {
    let error = |object: &str| try_load(&scene(object), &[]).expect_err("a bad scene");
    let shape = |file: &str| {
        let filename = format!("<string name=\"filename\" value=\"{file}\"/>");
        error(&format!("<shape type=\"obj\">{filename}</shape>"))
    };
    assert!(matches!(error("<shape"), LoadError::Syntax(_)));
    assert!(matches!(
        error("<shape type=\"obj\"/>"),
        LoadError::Missing(_)
    ));
    assert!(matches!(shape("$file.obj"), LoadError::Definition(_)));
    assert!(matches!(shape("gone.obj"), LoadError::Unreadable(_)));
    let mesh = shape("nan.obj");
    let LoadError::Mesh { error: inner, .. } = &mesh else {
        panic!("{mesh:?}");
    };
    assert_eq!(mesh.line(), Some(5));
    assert!(matches!(inner, MeshFileError::Invalid(fault) if fault.place == MeshPlace::Line(2)));
    let unknown = error("<shape type=\"cube\"><rgb name=\"a\" value=\"1\"/></shape>");
    assert!(matches!(unknown, LoadError::Unknown(_)));
    let twice = error("<emitter type=\"constant\"/>");
    assert!(matches!(twice, LoadError::Scene { .. }), "{twice:?}");
    let missing = capwalk_scene_io::load_scene("no/such.xml".as_ref(), &[]).expect_err("no file");
    assert!(matches!(missing, LoadError::Unreadable(_)));
    assert_eq!(missing.file(), Some("no/such.xml".as_ref()));
    assert_eq!(missing.line(), None);
}
