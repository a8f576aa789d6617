//! Bad shapes, materials, emitters and mesh files.

use crate::common::*;

#[test]
fn unknown_shape_plugin() {
    check(
        &scene(r#"<shape type="torus"/>"#),
        &[
            "scene.xml:5:16: unknown shape plugin \"torus\"",
            "  known shape plugins: obj, ply, serialized, gltf, rectangle, cube, disk, cylinder, \
             sphere, bsplinecurve, linearcurve, shapegroup, instance",
        ],
    );
}

#[test]
fn mistyped_shape_plugin() {
    check(
        &scene(r#"<shape type="spere"/>"#),
        &[
            "scene.xml:5:16: unknown shape plugin \"spere\"",
            "  known shape plugins: obj, ply, serialized, gltf, rectangle, cube, disk, cylinder, \
             sphere, bsplinecurve, linearcurve, shapegroup, instance",
            "  did you mean \"sphere\"?",
        ],
    );
}

#[test]
fn refused_shape() {
    check(
        &scene(r#"<shape type="sdfgrid"/>"#),
        &[
            "scene.xml:5:16: the shape \"sdfgrid\" is not supported",
            "  surfaces are triangles; extract a mesh where the distances are 0 (marching cubes), \
             save it as .ply, and write <shape type=\"ply\">",
        ],
    );
}

#[test]
fn unknown_bsdf_plugin() {
    check(
        &scene(r#"<bsdf type="roughconductr" id="m"/>"#),
        &[
            "scene.xml:5:15: unknown bsdf plugin \"roughconductr\"",
            "  known bsdf plugins: diffuse, conductor, roughconductor, dielectric, roughdielectric, \
             thindielectric, plastic, roughplastic, pplastic, principled, principledthin, null, \
             difftrans, polarizer, circular, retarder, twosided, mask, blendbsdf, normalmap, bumpmap",
            "  did you mean \"roughconductor\"?",
        ],
    );
}

#[test]
fn unknown_emitter_plugin() {
    check(
        &scene(r#"<emitter type="sunsky"/>"#),
        &[
            "scene.xml:5:18: the emitter \"sunsky\" is not supported",
            "  bake it into an image with Mitsuba and show that by an <emitter type=\"envmap\">; \
             docs/scene-files.md has the lines of Python, under \"Skies\"",
        ],
    );
    check(
        &scene(r#"<emitter type="laser"/>"#),
        &[
            "scene.xml:5:18: unknown emitter plugin \"laser\"",
            "  known emitter plugins: area, constant, envmap, point, spot, projector, directional",
        ],
    );
}

#[test]
fn unknown_property() {
    check(
        &scene(r#"<shape type="sphere"><float name="raduis" value="1"/></shape>"#),
        &[
            "scene.xml:5:37: unknown property \"raduis\" of the shape \"sphere\"",
            "  its properties are center, flip_normals, radius, silhouette_sampling_weight, to_world",
            "  did you mean \"radius\"?",
        ],
    );
}

#[test]
fn camel_case_property() {
    check(
        &scene(r#"<shape type="sphere"><transform name="toWorld"/></shape>"#),
        &[
            "scene.xml:5:41: unknown property \"toWorld\" of the shape \"sphere\"",
            "  Mitsuba 2 and 3 write names in small letters with underscores",
            "  did you mean \"to_world\"?",
        ],
    );
}

#[test]
fn reflectance_above_one() {
    check(
        &scene(
            r#"<bsdf type="diffuse" id="m"><rgb name="reflectance" value="0.1 0.2 1.5"/></bsdf>"#,
        ),
        &[
            "scene.xml:5:62: \"reflectance\" is (0.1, 0.2, 1.5)",
            "  expected numbers from 0 to 1: a surface cannot reflect more than it receives",
        ],
    );
}

#[test]
fn negative_radiance() {
    check(
        &format!(
            "{HEAD}{}",
            r#"<integrator type="path"/><sensor type="perspective"/>
<emitter type="constant"><float name="radiance" value="-1"/></emitter></scene>"#
        ),
        &[
            "scene.xml:3:56: \"radiance\" is (-1, -1, -1)",
            "  expected numbers of at least 0",
        ],
    );
}

#[test]
fn flattening_transform() {
    check(
        &scene(
            r#"<shape type="cube"><transform name="to_world"><scale y="0"/></transform></shape>"#,
        ),
        &[
            "scene.xml:5:22: \"to_world\" cannot be inverted",
            "  scale by finite numbers other than 0",
        ],
    );
}

#[test]
fn transform_out_of_reach() {
    check(
        &scene(
            r#"<shape type="cube"><transform name="to_world"><scale y="1e31"/></transform></shape>"#,
        ),
        &[
            "scene.xml:5:22: \"to_world\" leads out of reach",
            "  scale and translate by numbers up to 1e30",
        ],
    );
}

#[test]
fn ellipsoid() {
    check(
        &scene(
            r#"<shape type="sphere"><transform name="to_world"><scale y="2"/></transform></shape>"#,
        ),
        &[
            "scene.xml:5:24: \"to_world\" scales the axes of a sphere differently",
            "  expected a uniform scale (Mitsuba ignores that of y and z); an ellipsoid can be given as a mesh",
        ],
    );
}

#[test]
fn sphere_of_radius_zero() {
    check(
        &scene(r#"<shape type="sphere"><float name="radius" value="0"/></shape>"#),
        &[
            "scene.xml:5:52: \"radius\" is 0",
            "  expected a number other than 0",
        ],
    );
}

#[test]
fn two_materials() {
    check(
        &scene(r#"<shape type="cube"><bsdf type="diffuse"/><bsdf type="diffuse"/></shape>"#),
        &[
            "scene.xml:5:44: the shape \"cube\" has more than one bsdf",
            "  keep one of them",
        ],
    );
}

#[test]
fn object_in_wrong_place() {
    check(
        &scene(r#"<shape type="cube"><film type="hdrfilm"/></shape>"#),
        &[
            "scene.xml:5:22: the shape \"cube\" cannot have a film",
            "  expected <emitter>, <bsdf>",
        ],
    );
}

#[test]
fn twosided_without_material() {
    check(
        &scene(r#"<bsdf type="twosided" id="m"/>"#),
        &[
            "scene.xml:5:3: the bsdf \"twosided\" has no material",
            "  put a one-sided material into it, such as <bsdf type=\"diffuse\"/>",
        ],
    );
}

#[test]
fn twosided_in_twosided() {
    check(
        &scene(
            r#"<bsdf type="twosided" id="m"><bsdf type="twosided"><bsdf type="diffuse"/></bsdf></bsdf>"#,
        ),
        &[
            "scene.xml:5:32: a twosided material stands inside a twosided material",
            "  put one-sided materials into it, such as <bsdf type=\"diffuse\"/>",
        ],
    );
}

#[test]
fn area_emitter_outside() {
    check(
        &scene(r#"<emitter type="area"/>"#),
        &[
            "scene.xml:5:3: an area emitter stands outside of any shape",
            "  move it into the <shape> that emits",
        ],
    );
}

#[test]
fn constant_emitter_inside() {
    check(
        &scene(r#"<shape type="cube"><emitter type="constant"/></shape>"#),
        &[
            "scene.xml:5:22: a constant emitter stands inside a shape",
            "  move it into <scene>, or write <emitter type=\"area\">",
        ],
    );
}

#[test]
fn two_environments() {
    check(
        &scene(r#"<emitter type="constant" id="b"/>"#),
        &[
            "scene.xml:5:3: there is more than one emitter around the scene (constant, envmap); keep one",
        ],
    );
}

#[test]
fn area_emitter_with_transform() {
    check(
        &scene(
            r#"<shape type="cube"><emitter type="area"><transform name="to_world"/></emitter></shape>"#,
        ),
        &[
            "scene.xml:5:43: an area emitter has no \"to_world\"",
            "  it stands where its shape stands; move the shape",
        ],
    );
}

#[test]
fn shared_area_emitter() {
    check(
        &scene(
            r#"<emitter type="area" id="l"/><shape type="cube"><ref id="l"/></shape><shape type="disk"><ref id="l"/></shape>"#,
        ),
        &[
            "scene.xml:5:100: this emitter belongs to another shape already",
            "  give each shape an emitter of its own",
        ],
    );
}

#[test]
fn shape_by_reference() {
    check(
        &scene(r#"<shape type="cube" id="c"/><ref id="c"/>"#),
        &[
            "scene.xml:5:39: a shape is referred to",
            "  each shape stands in the scene once; copy it, or show a shapegroup by instances",
        ],
    );
}

#[test]
fn missing_mesh_file() {
    check(
        &scene(r#"<shape type="obj"><string name="filename" value="bunny.obj"/></shape>"#),
        &[
            "scene.xml:5:52: there is no file \"FOLDER/bunny.obj\" or \"bunny.obj\"",
            "  give the file relative to the scene file",
        ],
    );
}

#[test]
fn no_mesh_file() {
    check(
        &scene(r#"<shape type="ply"/>"#),
        &[
            "scene.xml:5:3: the shape \"ply\" names no file",
            "  add <string name=\"filename\" value=\"mesh.ply\"/>",
        ],
    );
}

#[test]
fn mesh_of_wrong_ending() {
    check(
        &scene(r#"<shape type="obj"><string name="filename" value="bunny.ply"/></shape>"#),
        &[
            "scene.xml:5:52: the shape \"obj\" cannot read \"bunny.ply\"",
            "  write <shape type=\"ply\">",
        ],
    );
}

#[test]
fn mesh_of_foreign_ending() {
    check(
        &scene(r#"<shape type="obj"><string name="filename" value="bunny.stl"/></shape>"#),
        &[
            "scene.xml:5:52: the shape \"obj\" cannot read \"bunny.stl\"",
            "  convert the mesh to .ply or .obj",
        ],
    );
}

#[test]
fn shape_called_sensor() {
    check(
        &scene(r#"<shape type="cube" id="sensor"/>"#),
        &[
            "scene.xml:5:3: the id \"sensor\" is the sensor's",
            "  parameters are called by it; give the shape another id",
        ],
    );
}
