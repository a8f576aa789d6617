//! Bad XML, tags, values, transforms, references, parameters and includes.

use crate::common::*;

#[test]
fn malformed_xml_mismatched_tag() {
    check(
        &format!(
            "{HEAD}{}",
            r#"  <shape type="cube">
</scene>"#
        ),
        &[
            "scene.xml:3:1: malformed XML: expected 'shape' tag, not 'scene'",
            "  correct the XML syntax here",
        ],
    );
}

#[test]
fn malformed_xml_cut_off() {
    check(
        &format!(
            "{HEAD}{}",
            r#"  <shape type="cube"/>
"#
        ),
        &[
            "scene.xml:2:23: malformed XML: the root node was opened but never closed",
            "  the file ends too early; close every element",
        ],
    );
}

#[test]
fn malformed_xml_bad_attribute() {
    check(
        &format!(
            "{HEAD}{}",
            r#"  <shape type=cube/>
</scene>"#
        ),
        &[
            "scene.xml:2:15: malformed XML: expected a quote not 'c'",
            "  correct the XML syntax here",
        ],
    );
}

#[test]
fn malformed_xml_doctype() {
    check(
        r#"<!DOCTYPE scene>
<scene version="3.0.0">
</scene>"#,
        &[
            "scene.xml:1:1: malformed XML: XML with DTD detected",
            "  remove the <!DOCTYPE ...>; scene files need none",
        ],
    );
}

#[test]
fn empty_file() {
    check(
        r#""#,
        &[
            "scene.xml:1:1: malformed XML: the document does not have a root node",
            "  a scene file contains <scene version=\"3.0.0\"> ... </scene>",
        ],
    );
}

#[test]
fn no_version() {
    check(
        r#"<scene>
</scene>"#,
        &[
            "scene.xml:1:1: <scene> has no attribute \"version\"",
            "  write <scene version=\"3.0.0\">, the version of Mitsuba the file is for",
        ],
    );
}

#[test]
fn strange_version() {
    check(
        r#"<scene version="4.0"/>"#,
        &[
            "scene.xml:1:17: \"4.0\" is not a version of Mitsuba that is read",
            "  expected up to 3.x, for example version=\"3.0.0\"",
        ],
    );
}

#[test]
fn root_is_not_a_scene() {
    check(
        r#"<shape version="3.0.0" type="cube"/>"#,
        &[
            "scene.xml:1:1: the file describes a <shape>",
            "  expected <scene version=\"3.0.0\"> around everything",
        ],
    );
}

#[test]
fn unknown_tag() {
    check(
        &scene(r#"<shap type="cube"/>"#),
        &[
            "scene.xml:5:3: unknown tag <shap>",
            "  expected an object such as <shape> or a property such as <float>",
            "  did you mean \"shape\"?",
        ],
    );
}

#[test]
fn unknown_attribute() {
    check(
        &scene(r#"<shape typ="cube"/>"#),
        &[
            "scene.xml:5:10: unknown attribute \"typ\" of <shape>",
            "  its attributes are type, id, name",
            "  did you mean \"type\"?",
        ],
    );
}

#[test]
fn missing_type() {
    check(
        &scene(r#"<shape/>"#),
        &[
            "scene.xml:5:3: <shape> has no attribute \"type\"",
            "  write <shape type=\"...\">",
        ],
    );
}

#[test]
fn property_of_wrong_type() {
    check(
        &scene(r#"<shape type="sphere"><string name="radius" value="1"/></shape>"#),
        &[
            "scene.xml:5:53: \"radius\" is a <string>",
            "  expected <float name=\"radius\" .../>",
        ],
    );
}

#[test]
fn property_given_twice() {
    check(
        &scene(
            r#"<shape type="sphere"><float name="radius" value="1"/><float name="radius" value="2"/></shape>"#,
        ),
        &[
            "scene.xml:5:69: the property \"radius\" is given twice",
            "  keep one of them",
        ],
    );
}

#[test]
fn property_without_name() {
    check(
        &scene(r#"<shape type="sphere"><float value="1"/></shape>"#),
        &[
            "scene.xml:5:24: <float> has no attribute \"name\"",
            "  write <float name=\"...\">",
        ],
    );
}

#[test]
fn not_a_number() {
    check(
        &scene(r#"<shape type="sphere"><float name="radius" value="1,5"/></shape>"#),
        &[
            "scene.xml:5:52: \"1,5\" is not a finite number",
            "  expected a number like 1, 0.25 or 1e-3",
        ],
    );
}

#[test]
fn not_finite() {
    check(
        &scene(r#"<shape type="sphere"><float name="radius" value="nan"/></shape>"#),
        &[
            "scene.xml:5:52: \"nan\" is not a finite number",
            "  expected a number like 1, 0.25 or 1e-3",
        ],
    );
}

#[test]
fn not_a_whole_number() {
    check(
        &scene(r#"<shape type="sphere"><integer name="radius" value="1.5"/></shape>"#),
        &[
            "scene.xml:5:54: \"1.5\" is not a whole number",
            "  expected one like 64",
        ],
    );
}

#[test]
fn not_a_boolean() {
    check(
        &scene(r#"<shape type="cube"><boolean name="flip_normals" value="yes"/></shape>"#),
        &[
            "scene.xml:5:58: \"yes\" is not a boolean",
            "  expected true or false",
        ],
    );
}

#[test]
fn not_a_colour() {
    check(
        &scene(r##"<bsdf type="diffuse" id="m"><rgb name="reflectance" value="#12345"/></bsdf>"##),
        &[
            "scene.xml:5:62: \"#12345\" is not a colour",
            "  expected \"r, g, b\", one number for a grey, or #rrggbb (decoded from sRGB)",
        ],
    );
}

#[test]
fn colour_of_two_numbers() {
    check(
        &scene(r#"<bsdf type="diffuse" id="m"><rgb name="reflectance" value="0.1 0.2"/></bsdf>"#),
        &[
            "scene.xml:5:62: \"0.1 0.2\" has 2 numbers",
            "  expected \"r, g, b\", one number for a grey, or #rrggbb (decoded from sRGB)",
        ],
    );
}

#[test]
fn transform_step_unknown() {
    check(
        &scene(
            r#"<shape type="cube"><transform name="to_world"><rotat x="1"/></transform></shape>"#,
        ),
        &[
            "scene.xml:5:49: <rotat> cannot stand inside <transform>",
            "  a transform is made of translate, rotate, scale, lookat and matrix",
            "  did you mean \"rotate\"?",
        ],
    );
}

#[test]
fn transform_outside() {
    check(
        &scene(r#"<shape type="cube"><rotate x="1" angle="3"/></shape>"#),
        &[
            "scene.xml:5:22: <rotate> stands outside a transform",
            "  write <transform name=\"to_world\"> around it",
        ],
    );
}

#[test]
fn rotation_without_axis() {
    check(
        &scene(
            r#"<shape type="cube"><transform name="to_world"><rotate angle="30"/></transform></shape>"#,
        ),
        &[
            "scene.xml:5:49: the axis of the rotation is zero",
            "  write for example <rotate y=\"1\" angle=\"90\"/>, in degrees",
        ],
    );
}

#[test]
fn lookat_parallel_up() {
    check(
        &scene(
            r#"<shape type="cube"><transform name="to_world"><lookat origin="0 0 0" target="0 1 0" up="0 1 0"/></transform></shape>"#,
        ),
        &[
            "scene.xml:5:49: \"up\" is parallel to the view",
            "  origin and target must differ, and up must not be parallel to the view",
        ],
    );
}

#[test]
fn matrix_of_wrong_size() {
    check(
        &scene(
            r#"<shape type="cube"><transform name="to_world"><matrix value="1 0 0 1"/></transform></shape>"#,
        ),
        &[
            "scene.xml:5:64: the matrix has 4 numbers",
            "  expected 9 or 16, row by row",
        ],
    );
}

#[test]
fn projective_matrix() {
    check(
        &scene(
            r#"<shape type="cube"><transform name="to_world"><matrix value="1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1"/></transform></shape>"#,
        ),
        &[
            "scene.xml:5:64: the last row of the matrix is not 0 0 0 1",
            "  only affine transforms are read; give 16 numbers row by row",
        ],
    );
}

#[test]
fn vector_mixed() {
    check(
        &scene(
            r#"<shape type="cube"><transform name="to_world"><scale value="2" x="1"/></transform></shape>"#,
        ),
        &[
            "scene.xml:5:66: <scale> has both \"value\" and \"x\"",
            "  give either value=\"x, y, z\" or x, y and z",
        ],
    );
}

#[test]
fn reference_to_nothing() {
    check(
        &scene(r#"<bsdf type="diffuse" id="white"/><shape type="cube"><ref id="whit"/></shape>"#),
        &[
            "scene.xml:5:64: there is no object with the id \"whit\"",
            "  give the id=\"...\" of an object in this file or an included one",
            "  did you mean \"white\"?",
        ],
    );
}

#[test]
fn reference_cycle() {
    check(
        &scene(
            r#"<bsdf type="twosided" id="a"><ref id="b"/></bsdf><bsdf type="twosided" id="b"><ref id="a"/></bsdf>"#,
        ),
        &[
            "scene.xml:5:90: this object contains itself",
            "  remove this reference",
        ],
    );
}

#[test]
fn duplicate_id() {
    check(
        &scene(
            r#"<bsdf type="diffuse" id="a"/>
  <shape type="cube" id="a"/>"#,
        ),
        &[
            "scene.xml:6:26: the id \"a\" is taken: an object at scene.xml:5:28 has it",
            "  give each object its own id",
        ],
    );
}

#[test]
fn element_inside_property() {
    check(
        &scene(
            r#"<shape type="sphere"><float name="radius" value="1"><float name="x" value="1"/></float></shape>"#,
        ),
        &[
            "scene.xml:5:55: <float> cannot stand inside <float>",
            "  close the <float/> before it",
        ],
    );
}

#[test]
fn undefined_parameter() {
    check(
        &format!(
            "{HEAD}{}",
            r#"<default name="size" value="1"/><shape type="sphere"><float name="radius" value="$siz"/></shape></scene>"#
        ),
        &[
            "scene.xml:2:82: the parameter $siz is not defined",
            "  define siz, or give it a value before this place with <default name=\"siz\" value=\"...\"/>; a dollar sign itself is written \\$",
            "  did you mean \"size\"?",
        ],
    );
}

#[test]
fn default_without_name() {
    check(
        &format!("{HEAD}{}", r#"<default name="" value="1"/></scene>"#),
        &[
            "scene.xml:2:16: the parameter has no name",
            "  write <default name=\"spp\" value=\"16\"/> and use it as $spp",
        ],
    );
}

#[test]
fn missing_include() {
    check(
        &scene(r#"<include filename="nothing.xml"/>"#),
        &[
            "scene.xml:5:22: there is no file \"FOLDER/nothing.xml\"",
            "  give a scene file to include",
        ],
    );
}

#[test]
fn missing_path() {
    check(
        &scene(r#"<path value="nowhere"/>"#),
        &[
            "scene.xml:5:16: there is no folder \"FOLDER/nowhere\"",
            "  give a folder, relative to this file or one that includes it",
        ],
    );
}

#[test]
fn too_deep() {
    check(
        &format!(
            "{HEAD}{}{}</scene>",
            "<bsdf type=\"twosided\">".repeat(40),
            "</bsdf>".repeat(40)
        ),
        &[
            "scene.xml:2:683: <bsdf> is nested 33 elements deep",
            "  at most 32 are read",
        ],
    );
}
