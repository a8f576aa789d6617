//! Textures: what they are, what meshes give them, and what is wrong with them.

use capwalk_scene::lobe::{Diffuse, Lobe};
use capwalk_scene::texture::{Bitmap, TexelFilter, Wrap};
use capwalk_scene::{Bsdf, Pattern, Scene, Texture, params};

use crate::common::*;

fn textured(texture: &str) -> String {
    scene(&format!(
        "<shape type=\"cube\" id=\"box\"><bsdf type=\"diffuse\">{texture}</bsdf></shape>"
    ))
}

fn bitmap(properties: &str) -> String {
    format!(
        "<texture name=\"reflectance\" type=\"bitmap\"><string name=\"filename\" \
         value=\"texels.png\"/>{properties}</texture>"
    )
}

/// The reflectance of the first shape.
fn reflectance(scene: &Scene) -> &Texture {
    match scene.material(scene.shapes[0].bsdf).bsdf {
        Bsdf::Plain(Lobe::Diffuse(Diffuse { reflectance })) => scene.texture(reflectance),
        ref other => panic!("{other:?}"),
    }
}

/// Values of Mitsuba 3.9.1 for the same file at (0.3, 0.45) and (1.3, -0.2).
#[test]
fn bitmaps_are_looked_up_as_in_mitsuba() {
    let transform = "<transform name=\"to_uv\"><scale x=\"2\" y=\"3\"/><rotate z=\"1\" \
                     angle=\"30\"/><translate x=\"0.25\" y=\"0.1\"/></transform>";
    let nearest = "<string name=\"wrap_mode\" value=\"clamp\"/><string name=\"filter_type\" \
                   value=\"nearest\"/>";
    for (properties, expected) in [
        (
            "",
            [
                [0.22702, 0.206624, 0.114213],
                [0.299782, 0.161427, 0.666118],
            ],
        ),
        (
            "<boolean name=\"raw\" value=\"true\"/>",
            [
                [0.47451, 0.355569, 0.365412],
                [0.473804, 0.326628, 0.793412],
            ],
        ),
        (
            "<string name=\"wrap_mode\" value=\"mirror\"/>",
            [
                [0.22702, 0.206624, 0.114213],
                [0.415167, 0.239289, 0.297909],
            ],
        ),
        (
            nearest,
            [
                [0.171441, 0.015996, 0.132868],
                [0.002125, 0.527115, 0.250158],
            ],
        ),
        (
            transform,
            [
                [0.248395, 0.521464, 0.210608],
                [0.427095, 0.263176, 0.616493],
            ],
        ),
    ] {
        let scene = load(&textured(&bitmap(properties)));
        let texture = reflectance(&scene);
        for (uv, expected) in [[0.3, 0.45], [1.3, -0.2]].into_iter().zip(expected) {
            let value = texture.lookup(uv, |i| texture.texel(i)).to_array();
            let errors = [0, 1, 2].map(|i| f64::abs(value[i] - expected[i]));
            let error = errors.into_iter().fold(0.0, f64::max);
            assert!(error < 3e-6, "{properties} {uv:?}: {value:?}");
        }
    }
}

#[test]
fn bitmaps_have_their_form_and_names() {
    let properties = "<string name=\"filter_type\" value=\"nearest\"/>\
                      <string name=\"wrap_mode\" value=\"clamp\"/>";
    let scene = load(&textured(&bitmap(properties)));
    let texture = reflectance(&scene);
    assert_eq!(texture.id, "box.bsdf.reflectance");
    assert_eq!((texture.channels, texture.data.len()), (3, 36));
    let Pattern::Bitmap(Bitmap {
        width,
        height,
        filter,
        wrap,
        ..
    }) = &texture.pattern
    else {
        panic!("a bitmap");
    };
    assert_eq!((*width, *height), (4, 3));
    assert_eq!((*filter, *wrap), (TexelFilter::Nearest, Wrap::Clamp));
    let tangent = params::Registry::new(&scene)
        .tangent(&scene, "box.bsdf.reflectance.data.g")
        .expect("listed");
    let velocities = tangent.textures.iter().flatten().next().expect("moves");
    let expected: Vec<f64> = [0.0, 1.0, 0.0].repeat(12);
    assert_eq!(*velocities, expected);
}

/// A texture at the top is one, whoever refers to it.
#[test]
fn references_share_one_texture() {
    let scene = load(&scene(&format!(
        "{}<bsdf type=\"diffuse\" id=\"a\"><ref name=\"reflectance\" id=\"wood\"/></bsdf>\
         <bsdf type=\"diffuse\" id=\"b\"><ref name=\"reflectance\" id=\"wood\"/></bsdf>",
        bitmap("").replace("name=\"reflectance\"", "id=\"wood\"")
    )));
    let ids: Vec<&str> = scene.textures.iter().map(|t| t.id.as_str()).collect();
    assert_eq!(ids, ["wood", "environment.radiance"]);
    for name in ["wood.data", "a.reflectance.data.r", "b.reflectance.data"] {
        params::Registry::new(&scene)
            .tangent(&scene, name)
            .unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn checkerboards_have_two_colours() {
    let board = "<texture name=\"reflectance\" type=\"checkerboard\">\
                 <rgb name=\"color1\" value=\"0.1, 0.2, 0.3\"/></texture>";
    let scene = load(&textured(board));
    let texture = reflectance(&scene);
    assert_eq!(texture.data, [0.4, 0.4, 0.4, 0.1, 0.2, 0.3]);
    let second = params::Registry::new(&scene)
        .tangent(&scene, "box.bsdf.reflectance.color1.value.b")
        .expect("listed");
    let velocities = second.textures.iter().flatten().next().expect("moves");
    assert_eq!(*velocities, [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    check(
        &textured(&board.replace("value=\"0.1", "value=\"-0.1")),
        &[
            "scene.xml:5:126: \"color1\" is (-0.1, 0.2, 0.3)",
            "  expected numbers of at least 0",
        ],
    );
}

#[test]
fn meshes_bring_attributes() {
    let scene = load(&scene(
        "<shape type=\"ply\" id=\"sheet\"><string name=\"filename\" value=\"attributes.ply\"/>\
         <bsdf type=\"diffuse\"><texture name=\"reflectance\" type=\"mesh_attribute\">\
         <string name=\"name\" value=\"vertex_color\"/><float name=\"scale\" value=\"0.5\"/>\
         </texture></bsdf></shape>",
    ));
    let shape = &scene.shapes[0];
    let names: Vec<&str> = shape.attributes.iter().map(|a| a.name.as_str()).collect();
    assert_eq!(names, ["vertex_color", "vertex_heat", "face_tint_color"]);
    let data = |name: &str| {
        let texture = scene.texture(shape.attribute(name).expect(name));
        assert_eq!(texture.id, format!("sheet.{name}"));
        &texture.data[..]
    };
    assert_eq!(data("vertex_heat"), [7.0, 8.0, 9.0, 10.0]);
    assert_eq!(data("vertex_color")[..6], [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
    // The first face is a polygon of two triangles.
    let tints = [0.25, 0.5, 0.75, 0.25, 0.5, 0.75, 1.0, 0.5, 0.0];
    assert_eq!(data("face_tint_color"), tints);
    let uvs = shape.uvs.as_ref().expect("s and t");
    assert_eq!(uvs[1], [[0.0, 0.0], [1.0, 0.75], [0.0, 1.0]]);
    params::Registry::new(&scene)
        .tangent(&scene, "sheet.vertex_color.r + sheet.vertex_heat")
        .expect("listed");
}

/// In OBJ files v points up, rows of bitmaps go down.
#[test]
fn texture_coordinates_of_obj_files_are_flipped() {
    let load_with = |properties: &str| {
        let scene = load(&scene(&format!(
            "<shape type=\"obj\"><string name=\"filename\" value=\"textured.obj\"/>\
             {properties}</shape>"
        )));
        scene.shapes[0].uvs.clone().expect("vt")
    };
    assert_eq!(load_with(""), [[[0.0, 1.0], [1.0, 0.75], [1.0, 0.0]]]);
    let plain = load_with("<boolean name=\"flip_tex_coords\" value=\"false\"/>");
    assert_eq!(plain, [[[0.0, 0.0], [1.0, 0.25], [1.0, 1.0]]]);
    // Turning a surface over takes its coordinates along.
    let flipped = load_with("<boolean name=\"flip_normals\" value=\"true\"/>");
    assert_eq!(flipped, [[[0.0, 1.0], [1.0, 0.0], [1.0, 0.75]]]);
}

fn on_mesh(file: &str, texture: &str) -> String {
    let plugin = &file[file.len() - 3..];
    scene(&format!(
        "<shape type=\"{plugin}\" id=\"m\"><string name=\"filename\" value=\"{file}\"/>\
         <bsdf type=\"diffuse\">{texture}</bsdf></shape>"
    ))
}

#[test]
fn meshes_without_texture_coordinates() {
    for file in ["square.obj", "half_textured.obj"] {
        check(
            &on_mesh(file, &bitmap("")),
            &[
                "scene.xml:5:59: the texture \"m.bsdf.reflectance\" needs texture coordinates, \
               but the mesh of \"m\" has none; add them to all corners of the mesh, or give one \
               colour",
            ],
        );
    }
}

#[test]
fn meshes_without_the_attribute() {
    let attribute = |name: &str| {
        format!(
            "<texture name=\"reflectance\" type=\"mesh_attribute\"><string name=\"name\" \
             value=\"{name}\"/></texture>"
        )
    };
    check(
        &on_mesh("attributes.ply", &attribute("vertex_colour")),
        &[
            "scene.xml:5:59: the texture \"m.bsdf.reflectance\" asks for \"vertex_colour\", but \
           the mesh of \"m\" has only vertex_color, vertex_heat, face_tint_color",
        ],
    );
    check(
        &on_mesh("square.obj", &attribute("face_heat")),
        &[
            "scene.xml:5:59: the texture \"m.bsdf.reflectance\" asks for \"face_heat\", but the \
             mesh of \"m\" has no attributes",
        ],
    );
    check(
        &on_mesh("attributes.ply", &attribute("colour")),
        &[
            "scene.xml:5:174: \"colour\" is not the name of an attribute",
            "  expected <string name=\"name\" value=\"vertex_color\"/>, or another name that \
             begins with vertex_ or face_",
        ],
    );
}

#[test]
fn bad_bitmaps() {
    check(
        &textured(&bitmap("").replace("texels.png", "square.obj")),
        &[
            "scene.xml:5:125: cannot read \"FOLDER/square.obj\": expected a file that ends in \
             png, jpg, jpeg, bmp, tga, hdr, exr",
            "  give an image file that ends in png, jpg, jpeg, bmp, tga, hdr, exr",
        ],
    );
    check(
        &textured("<texture name=\"reflectance\" type=\"bitmap\"/>"),
        &[
            "scene.xml:5:52: the texture \"bitmap\" names no file",
            "  add <string name=\"filename\" value=\"texture.png\"/>",
        ],
    );
    check(
        &textured(&bitmap("<string name=\"wrap_mode\" value=\"repaet\"/>")),
        &[
            "scene.xml:5:170: \"wrap_mode\" is \"repaet\"",
            "  expected repeat, mirror, clamp",
            "  did you mean \"repeat\"?",
        ],
    );
    check(
        &textured(&bitmap("<float name=\"gamma\" value=\"2.2\"/>")),
        &[
            "scene.xml:5:151: \"gamma\" is not supported",
            "  write raw = true for texels as they are (gamma 1), and raw = false for sRGB (-1); \
             convert images with other curves",
        ],
    );
    check(
        &textured("<texture name=\"reflectance\" type=\"bitmpa\"/>"),
        &[
            "scene.xml:5:86: unknown texture plugin \"bitmpa\"",
            "  known texture plugins: bitmap, checkerboard, mesh_attribute, gltf_texture, blackbody, d65, irregular, rawconstant, regular, srgb, uniform",
            "  did you mean \"bitmap\"?",
        ],
    );
}

#[test]
fn constant_emitters_have_one_colour() {
    let text = scene("").replace(
        "<emitter type=\"constant\"/>",
        &format!(
            "<emitter type=\"constant\">{}</emitter>",
            bitmap("").replace("reflectance", "radiance")
        ),
    );
    check(
        &text,
        &[
            "scene.xml:4:28: the radiance of the emitter \"constant\" is a texture",
            "  give one colour; an image of all directions is <emitter type=\"envmap\">",
        ],
    );
}
