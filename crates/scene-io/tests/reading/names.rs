//! Ids of shapes, materials, emitters and the sensor, which name parameters.

use capwalk_scene::{Bsdf, Emitter};
use capwalk_scene_io::load_scene_str;

use crate::common::*;

fn shape_ids(objects: &str) -> Vec<String> {
    let scene = load(&scene(objects));
    scene.shapes.iter().map(|shape| shape.id.clone()).collect()
}

#[test]
fn shapes_without_id_are_called_after_their_plugin_or_file() {
    let ids = shape_ids(
        "<shape type=\"sphere\"/><shape type=\"cube\"/><shape type=\"sphere\"/>\
         <shape type=\"obj\"><string name=\"filename\" value=\"square.obj\"/></shape>\
         <shape type=\"obj\"><string name=\"filename\" value=\"square.obj\"/></shape>\
         <shape type=\"sphere\"/>",
    );
    let expected = [
        "sphere", "cube", "sphere_2", "square", "square_2", "sphere_3",
    ];
    assert_eq!(ids, expected);
}

/// An id of the file never gives way to a made up one, wherever it stands.
#[test]
fn given_ids_are_kept() {
    let ids = shape_ids(
        "<shape type=\"sphere\"/><shape type=\"cube\" id=\"sphere\"/>\
         <shape type=\"sphere\"/><shape type=\"cube\" id=\"sphere_2\"/>",
    );
    assert_eq!(ids, ["sphere_3", "sphere", "sphere_4", "sphere_2"]);
}

/// As the keys of Mitsuba's dictionaries; where an object stands in another, its name says what
/// it is of.
#[test]
fn names_directly_in_the_scene_are_ids() {
    let loaded = load(&scene(
        "<bsdf type=\"diffuse\" name=\"grey\"/>\
         <shape type=\"sphere\" name=\"ball\"><ref id=\"grey\"/></shape>\
         <shape type=\"cube\" name=\"taken\"/><shape type=\"cube\" id=\"taken\"/>\
         <shape type=\"cube\" name=\"box\" id=\"crate\">\
         <bsdf type=\"diffuse\" name=\"skin\"/></shape>",
    ));
    let ids: Vec<&str> = loaded.shapes.iter().map(|shape| &*shape.id).collect();
    assert_eq!(ids, ["ball", "cube", "taken", "crate"]);
    let material_of = |i: usize| &*loaded.material(loaded.shapes[i].bsdf).id;
    assert_eq!((material_of(0), material_of(3)), ("grey", "crate.bsdf"));
}

/// The sensor is called so; a name is nothing that a shape must have.
#[test]
fn the_name_sensor_is_no_id_of_a_shape() {
    let loaded = load(&scene("<shape type=\"cube\" name=\"sensor\"/>"));
    assert_eq!(loaded.shapes[0].id, "cube");
}

/// Sensors and shapes, whose parameters are called alike, never share a name. None of several
/// is called `sensor` unless the file says so: without one of that name it is whichever renders.
#[test]
fn sensors_have_names_of_their_own() {
    let text = scene(
        "<sensor type=\"perspective\" id=\"sensor_2\"/><sensor type=\"perspective\"/>\
         <shape type=\"cube\" id=\"sensor_1\"/><sensor type=\"perspective\"/>",
    );
    let loaded = load_scene_str(&text, &folder(), "scene.xml", &[]).expect("a scene");
    let ids: Vec<&str> = loaded.sensors.iter().map(|v| &*v.sensor.id).collect();
    assert_eq!(ids, ["sensor_0", "sensor_2", "sensor_2_2", "sensor_3"]);

    let named =
        scene("<shape type=\"obj\"><string name=\"filename\" value=\"sensor.obj\"/></shape>");
    let named = named.replace("<sensor ", "<sensor id=\"camera\" ");
    let files = std::env::temp_dir().join(format!("capwalk-names-{}", std::process::id()));
    std::fs::create_dir_all(&files).expect("a folder");
    let square = folder().join("square.obj");
    std::fs::copy(square, files.join("sensor.obj")).expect("a file");
    let loaded = load_scene_str(&named, &files, "scene.xml", &[]).expect("a scene");
    std::fs::remove_dir_all(&files).expect("the folder");
    assert_eq!(loaded.scene.shapes[0].id, "sensor_2");
}

#[test]
fn materials_are_called_after_their_id_or_shape() {
    let scene = load(&scene(
        "<bsdf type=\"diffuse\" id=\"white\"/>\
         <shape type=\"cube\" id=\"a\"><ref id=\"white\"/></shape>\
         <shape type=\"cube\" id=\"b\"><bsdf type=\"diffuse\"/></shape>\
         <shape type=\"cube\" id=\"c\"/>\
         <shape type=\"cube\" id=\"d\"><bsdf type=\"twosided\"><bsdf type=\"diffuse\"/>\
         <ref id=\"white\"/></bsdf></shape>",
    ));
    let material_of = |i: usize| scene.material(scene.shapes[i].bsdf);
    assert_eq!(material_of(0).id, "white");
    assert_eq!(material_of(1).id, "b.bsdf");
    assert_eq!(material_of(2).id, "c.bsdf");
    assert_eq!(material_of(3).id, "d.bsdf");
    let Bsdf::TwoSided { front, back } = material_of(3).bsdf else {
        panic!("two sides");
    };
    assert_eq!(scene.material(front).id, "d.bsdf.brdf_0");
    assert_eq!(scene.material(back).id, "white");
}

/// Shapes that share a material share its parameters.
#[test]
fn references_share_one_material() {
    let scene = load(&scene(
        "<bsdf type=\"diffuse\" id=\"white\"/>\
         <shape type=\"cube\"><ref id=\"white\"/></shape>\
         <shape type=\"disk\"><ref id=\"white\"/></shape>",
    ));
    assert_eq!(scene.shapes[0].bsdf, scene.shapes[1].bsdf);
    assert_eq!(scene.materials.len(), 1);
}

#[test]
fn environment_and_sensor_have_names() {
    let unnamed = load(&scene(""));
    assert_eq!(unnamed.sensor.id, "sensor");
    assert_eq!(
        unnamed.texture(unnamed.emitters[0].radiance()).id,
        "environment.radiance"
    );
    let text = scene("").replace("\"constant\"", "\"constant\" id=\"sky\"");
    let text = text.replace("\"perspective\"", "\"perspective\" id=\"eye\"");
    let named = load(&text);
    assert_eq!(named.sensor.id, "eye");
    assert!(matches!(&named.emitters[0], Emitter::Constant { id, .. } if id == "sky"));
}
