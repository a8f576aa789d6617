//! glTF files as scenes: what they become.

use std::path::{Path, PathBuf};

use capwalk_scene::{Scene, Settings};
use capwalk_scene_io::{LoadError, Loaded, load_scene, load_scene_str};
use serde_json::{Value, json};

use crate::damage::{Original, survive};
use crate::gltf_file::Document;
use crate::gltf_room::room;

pub fn parity() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/parity")
}

/// Writes a file for one test.
pub fn written(name: &str, bytes: &[u8]) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, bytes).expect("a folder for temporary files");
    path
}

/// The room after a change, in a file of this name.
pub fn changed(
    name: &str,
    change: &dyn Fn(&mut Document, &mut Value),
) -> Result<Loaded, LoadError> {
    let (mut document, mut json) = room(&parity());
    change(&mut document, &mut json);
    document.complete(&mut json);
    load_scene(&written(name, &document.binary(&json)), &[])
}

fn changed_scene(name: &str, change: &dyn Fn(&mut Value)) -> Scene {
    let loaded = changed(name, &|_, json| change(json));
    loaded.unwrap_or_else(|error| panic!("{error}")).scene
}

/// The numbers of a text, and the rest of it.
fn numbers(text: &str) -> (String, Vec<f64>) {
    let is_part = |c: char| c.is_ascii_digit() || "+-.e".contains(c);
    let (mut rest, mut numbers) = (String::new(), Vec::new());
    for word in text.split_inclusive(|c: char| !is_part(c)) {
        let number = word.trim_end_matches(|c: char| !is_part(c));
        match number.parse() {
            Ok(x) => {
                numbers.push(x);
                rest += &word[number.len()..];
            }
            Err(_) => rest += word,
        }
    }
    (rest, numbers)
}

/// Scenes are equal, up to the rounding of transforms and angles.
fn assert_equal(a: &Scene, b: &Scene) {
    let [(a, of_a), (b, of_b)] = [a, b].map(|scene| numbers(&format!("{scene:#?}")));
    for (a, b) in a.lines().zip(b.lines()) {
        assert_eq!(a, b);
    }
    assert_eq!((a.len(), of_a.len()), (b.len(), of_b.len()));
    for (a, b) in of_a.into_iter().zip(of_b) {
        assert!((a - b).abs() <= 1e-12 * a.abs().max(1.0), "{a} {b}");
    }
}

/// A texture of the room as XML.
fn texture(slot: &str, index: u32, channel: &str, factor: &str) -> String {
    format!(
        "<texture type=\"gltf_texture\" name=\"{slot}\"><string name=\"filename\" value=\"as_xml.glb\"/>\
         <integer name=\"texture\" value=\"{index}\"/><string name=\"channel\" \
         value=\"{channel}\"/>{factor}</texture>"
    )
}

/// A material of the room as XML.
fn principled(id: &str, base_color: &str, metallic: &str, roughness: &str, eta: &str) -> String {
    let number = |name: &str, value: &str| match value.starts_with('<') {
        true => value.to_owned(),
        false => format!("<float name=\"{name}\" value=\"{value}\"/>"),
    };
    let base_color = match base_color.starts_with('<') {
        true => base_color.to_owned(),
        false => format!("<rgb name=\"base_color\" value=\"{base_color}\"/>"),
    };
    let numbers = [
        ("metallic", metallic),
        ("roughness", roughness),
        ("eta", eta),
    ];
    let numbers = numbers.map(|(name, value)| number(name, value)).concat();
    format!("<bsdf type=\"principled\" id=\"{id}\">{base_color}{numbers}</bsdf>")
}

/// Every part of the room is what a hand would have written for it.
#[test]
fn the_room_is_what_its_xml_says() {
    let glb = changed("as_xml.glb", &|_, _| {}).unwrap_or_else(|error| panic!("{error}"));
    let wrapped = |id: &str, inner: String| {
        format!("<bsdf type=\"twosided\" id=\"{id}.twosided\">{inner}</bsdf>")
    };
    let colours = texture("base_color", 0, "color", "");
    let floor = wrapped("Floor", principled("Floor", &colours, "0", "0.8", "1.5"));
    let [metallic, roughness] = [("metallic", "blue"), ("roughness", "green")]
        .map(|(slot, channel)| texture(slot, 1, channel, ""));
    let panel = principled("Panel", "0.8, 0.7, 0.6", &metallic, &roughness, "1.5");
    let normals = texture("normalmap", 2, "normal", "");
    let panel = wrapped("Panel", panel);
    let panel = format!("<bsdf type=\"normalmap\" id=\"Panel.normalmap\">{normals}{panel}</bsdf>");
    let bowl = principled("Bowl", "0.9, 0.6, 0.2", "0.7", "0.35", "1.45");
    let screen = principled("Screen", "0.2, 0.5, 0.3", "0", "0.5", "1.5");
    let screen = format!(
        "<bsdf type=\"mask\" id=\"Screen.mask\"><float name=\"opacity\" value=\"0.6\"/>{}</bsdf>",
        wrapped("Screen", screen)
    );
    let lamp = principled("Lamp", "0", "0", "1", "1.5");
    let sign = principled("Sign", "0.1", "0", "1", "1.5");
    let emission = |radiance: &str| format!("<emitter type=\"area\">{radiance}</emitter>");
    let surfaces = [
        floor,
        panel,
        wrapped("Bowl", bowl),
        screen,
        lamp + &emission("<rgb name=\"radiance\" value=\"6, 5.4, 4.5\"/>"),
        sign + &emission(&texture("radiance", 0, "color", "")),
    ];
    let shapes = surfaces.iter().enumerate().map(|(i, surface)| {
        format!(
            "<shape type=\"gltf\"><string name=\"filename\" value=\"as_xml.glb\"/><integer \
             name=\"node\" value=\"{}\"/>{surface}</shape>",
            i + 2
        )
    });
    let shapes = shapes.collect::<String>();
    let turned = |angle: i32, translate: &str| {
        format!(
            "<transform name=\"to_world\"><rotate y=\"1\" angle=\"180\"/><rotate x=\"1\" \
             angle=\"{angle}\"/><translate value=\"{translate}\"/></transform>"
        )
    };
    let [camera, spot, sun] = [(-18, "0.2, 2, 4.8"), (-100, "0.5, 3, 1"), (-50, "0")]
        .map(|(angle, translate)| turned(angle, translate));
    let text = format!(
        "<scene version=\"3.0.0\"><integrator type=\"path\"/><sensor type=\"perspective\" \
         id=\"Camera\"><float name=\"fov\" value=\"32\"/><string name=\"fov_axis\" value=\"y\"/>\
         <float name=\"near_clip\" value=\"0.1\"/><float name=\"far_clip\" value=\"100\"/>{camera}\
         <film type=\"hdrfilm\"><integer name=\"width\" value=\"768\"/><integer name=\"height\" \
         value=\"768\"/></film></sensor>{shapes}<emitter type=\"point\" id=\"Bulb\"><rgb \
         name=\"intensity\" value=\"2, 1, 0.5\"/><point name=\"position\" value=\"-1.5, 1.2, \
         0.9\"/></emitter><emitter type=\"spot\" id=\"Spot\"><rgb name=\"intensity\" value=\"12, \
         12, 12\"/><float name=\"cutoff_angle\" value=\"20\"/><float name=\"beam_width\" \
         value=\"8\"/>{spot}</emitter><emitter type=\"directional\" id=\"Sun\"><rgb \
         name=\"irradiance\" value=\"0.2, 0.25, 0.4\"/>{sun}</emitter></scene>"
    );
    let xml = load_scene_str(&text, env!("CARGO_TARGET_TMPDIR").as_ref(), "room.xml", &[]);
    let xml = xml.unwrap_or_else(|error| panic!("{error}"));
    assert_equal(&glb.scene, &xml.scene);
    let warnings = glb.warnings.iter().map(|warning| {
        let text = warning.to_string();
        text[text.find("as_xml.glb").expect("its file")..].to_owned()
    });
    let expected = [
        "as_xml.glb: nodes[9] \"Spot\": between its cones the spot light falls off in proportion to \
         the angle, as Mitsuba's does; glTF recommends a square of cosines",
        "as_xml.glb: materials[4] \"Lamp\": not doubleSided (nor are 1 more): black from behind, \
         where glTF shows what is behind it",
    ];
    assert_eq!(warnings.collect::<Vec<_>>(), expected);
}

/// What other files say of materials, textures, cameras and animations.
#[test]
fn other_scenes() {
    let slot = |scene: &Scene, id: &str| {
        let mut textures = scene.textures.iter();
        let found = textures.find(|texture| texture.id == id);
        found.unwrap_or_else(|| panic!("there is no {id}")).clone()
    };
    // Texels times factors; 0x33 is a fifth.
    let scene = changed_scene("factors.glb", &|json| {
        json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = json!([0.5, 0.25, 1, 1]);
        json["materials"][1]["pbrMetallicRoughness"]["roughnessFactor"] = 0.5.into();
        json["materials"][1]["normalTexture"]["scale"] = 2.into();
    });
    let plain = changed_scene("plain.glb", &|_| {});
    let pairs = |id: &str| {
        let [a, b] = [&plain, &scene].map(|scene| slot(scene, id).data.clone());
        a.into_iter().zip(b).collect::<Vec<_>>()
    };
    let factors = [0.5, 0.25, 1.0];
    let colours = pairs("Floor.base_color");
    assert!((0..60).all(|i| colours[i].1 == factors[i % 3] * colours[i].0));
    assert!(pairs("Panel.roughness").iter().all(|(a, b)| *b == 0.5 * a));
    assert!(pairs("Panel.metallic").iter().all(|(a, b)| a == b));
    let scaled = |i: usize, a: f64| if i % 3 == 2 { a } else { 0.5 + 2.0 * (a - 0.5) };
    let normals = pairs("Panel.normalmap.normalmap").into_iter().enumerate();
    assert!(normals.into_iter().all(|(i, (a, b))| b == scaled(i, a)));

    // Colours are those of sRGB, here as in a bitmap of Mitsuba's.
    let xml = load_scene(&parity().join("gltf_room.xml"), &[]);
    let xml = xml.unwrap_or_else(|error| panic!("{error}")).scene;
    for (id, in_xml) in [
        ("Floor.base_color", "Floor.bsdf.brdf_0.base_color"),
        ("Sign.emitter.radiance", "Sign.emitter.radiance"),
        ("Panel.normalmap.normalmap", "Panel.bsdf.brdf_0.normalmap"),
    ] {
        assert_eq!(slot(&plain, id).data, slot(&xml, in_xml).data, "{id}");
    }

    // Green is roughness, blue is metal, and alpha opacity, all as they are.
    let scene = changed_scene("channels.glb", &|json| {
        json["textures"][1]["source"] = 0.into();
        json["materials"][0]["alphaMode"] = "BLEND".into();
        json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = json!([1, 1, 1, 0.5]);
    });
    let colours = std::fs::read(parity().join("colours.png")).expect("an image");
    let colours = image::load_from_memory(&colours)
        .expect("an image")
        .into_rgb8();
    let channel = |i: usize| colours.pixels().map(move |p| f64::from(p.0[i]) / 255.0);
    assert!(channel(1).eq(slot(&scene, "Panel.roughness").data.iter().copied()));
    assert!(channel(2).eq(slot(&scene, "Panel.metallic").data.iter().copied()));
    assert_eq!(slot(&scene, "Floor.mask.opacity").data, [0.5; 20]);

    // The lower left quarter of the image, as glTF's own example has it.
    let scene = changed_scene("quarter.glb", &|json| {
        json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = json!({
            "KHR_texture_transform": {"offset": [0, 1], "rotation": std::f64::consts::FRAC_PI_2, "scale": [0.5, 0.5]}
        });
        json["samplers"] = json!([{"magFilter": 9728, "wrapS": 33071, "wrapT": 33071}]);
        json["textures"][0]["sampler"] = 0.into();
    });
    let capwalk_scene::Pattern::Bitmap(bitmap) = slot(&scene, "Floor.base_color").pattern.clone()
    else {
        panic!("a bitmap")
    };
    for (uv, expected) in [
        ([0.0, 0.0], [0.0, 1.0]),
        ([1.0, 0.0], [0.0, 0.5]),
        ([0.0, 1.0], [0.5, 1.0]),
    ] {
        let found: [f64; 2] = bitmap.to_uv.apply(uv);
        let near = (0..2).all(|i| (found[i] - expected[i]).abs() < 1e-9);
        assert!(near, "{found:?} {expected:?}");
    }
    assert_eq!(bitmap.wrap, capwalk_scene::texture::Wrap::Clamp);
    assert_eq!(bitmap.filter, capwalk_scene::texture::TexelFilter::Nearest);

    // A solid of glass, grey reflection, none, and what has no effect.
    let scene = changed_scene("glass.glb", &|json| {
        json["materials"][3] = json!({"name": "Glass", "extensions": {
            "KHR_materials_transmission": {"transmissionFactor": 1},
            "KHR_materials_volume": {"thicknessFactor": 0.1}, "KHR_materials_ior": {"ior": 1.33}},
            "pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 1, 1], "metallicFactor": 0}});
        json["materials"][0]["extensions"] = json!({
            "KHR_materials_specular": {"specularColorFactor": [0.5, 0.5, 0.5]},
            "KHR_materials_clearcoat": {"clearcoatRoughnessFactor": 0.3},
            "KHR_materials_sheen": {"sheenColorFactor": [0, 0, 0]}});
        json["materials"][2]["extensions"] =
            json!({"KHR_materials_specular": {"specularFactor": 0}});
        json["materials"][2]["pbrMetallicRoughness"]["metallicFactor"] = 0.into();
    });
    assert_eq!(slot(&scene, "Glass.base_color").data, [0.25, 1.0, 1.0]);
    assert_eq!(slot(&scene, "Glass.spec_trans").data, [1.0]);
    assert_eq!(slot(&scene, "Glass.eta").data, [1.33]);
    let eta = slot(&scene, "Floor.eta").data[0];
    assert!(
        (((eta - 1.0) / (eta + 1.0)).powi(2) - 0.02).abs() < 1e-15,
        "{eta}"
    );
    assert_eq!(slot(&scene, "Bowl.specular").data, [0.0]);
    // Metals reflect whatever that says.
    let scene = changed_scene("metal.glb", &|json| {
        json["materials"][2]["extensions"] = json!({"KHR_materials_ior": {"ior": 1}});
        json["materials"][2]["pbrMetallicRoughness"]["metallicFactor"] = 1.into();
    });
    assert_eq!(slot(&scene, "Bowl.eta").data, [1.5]);

    // Colours of vertices; opacities that are cut; no material.
    let loaded = changed("others.glb", &|document, json| {
        let colours = document.vectors(&[[0.5, 1.0, 1.0]; 4]);
        json["meshes"][1]["primitives"][0]["attributes"]["COLOR_0"] = colours.into();
        json["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"] = json!([0.8, 0.8, 0.8, 1]);
        json["materials"][0]["alphaMode"] = "MASK".into();
        let primitive = json["meshes"][2]["primitives"][0].as_object_mut();
        primitive.expect("an object").remove("material");
        let mirrored = document.vectors(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        json["meshes"][1]["primitives"][0]["attributes"]["TEXCOORD_0"] = mirrored.into();
        json["animations"] = json!([{"channels": [], "samplers": []}]);
        json["cameras"][0] = json!({"type": "orthographic", "orthographic":
            {"xmag": 2, "ymag": 1, "znear": 0, "zfar": 9}});
        json["nodes"][0]["scale"] = json!([3, 3, 3]);
    });
    let loaded = loaded.unwrap_or_else(|error| panic!("{error}"));
    let scene = &loaded.scene;
    let painted = slot(scene, "Panel.base_color").pattern.clone();
    let capwalk_scene::Pattern::MeshAttribute { name, scale } = painted else {
        panic!("an attribute")
    };
    assert_eq!((name.as_str(), scale), ("vertex_color", 0.8));
    assert!(
        slot(scene, "Floor.mask.opacity")
            .data
            .iter()
            .all(|&x| x == 1.0)
    );
    assert_eq!(slot(scene, "Bowl.bsdf.metallic").data, [1.0]);
    assert_eq!(scene.film.size, [768, 384]);
    // The scale of the node has no effect; that of the film is its half width.
    let columns = scene.sensor.world_from_camera.rows;
    let x = columns.map(|row| row.x * row.x).iter().sum::<f64>();
    assert!((x - 4.0).abs() < 1e-12, "{x}");
    let warnings: Vec<String> = loaded.warnings.iter().map(ToString::to_string).collect();
    for expected in [
        "others.glb: the file has animations: nodes stand where they are without",
        "others.glb: texture coordinates of \"Panel\" are mirrored: its map of normals is upside",
        "materials[0] \"Floor\": alphaCutoff is compared with texels, not between them",
    ] {
        assert!(
            warnings.iter().any(|warning| warning.contains(expected)),
            "{warnings:#?}"
        );
    }
    let Settings { integrator, .. } = &scene.settings;
    assert!(
        format!("{integrator:?}").starts_with("Path"),
        "{integrator:?}"
    );
}

/// Buffers and images beside a `.gltf` are files that were read.
#[test]
fn files_beside_a_scene() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("gltf beside");
    std::fs::create_dir_all(&folder).expect("a folder for temporary files");
    let (document, mut json) = room(&parity());
    json["buffers"][0]["uri"] = "room.bin".into();
    json["images"][0] = json!({"uri": "the%20colours.png"});
    let colours = std::fs::read(parity().join("colours.png")).expect("an image");
    let scene = folder.join("room.gltf");
    for (path, bytes) in [
        (folder.join("room.bin"), document.buffer.clone()),
        (folder.join("the colours.png"), colours),
        (scene.clone(), json.to_string().into_bytes()),
    ] {
        std::fs::write(path, bytes).expect("written");
    }
    let split = load_scene(&scene, &[]).unwrap_or_else(|error| panic!("{error}"));
    let whole = changed("whole.glb", &|_, _| {}).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(split.scene, whole.scene);
    for name in ["room.gltf", "room.bin", "the colours.png"] {
        assert!(split.files.refuse(&folder.join(name)).is_err(), "{name}");
    }
    assert_eq!(
        (split.files.paths().count(), whole.files.paths().count()),
        (3, 1)
    );
}

/// A scene in any bytes is read or refused.
fn scene(bytes: &[u8]) -> bool {
    let thread = std::thread::current();
    let name = thread.name().unwrap_or("main").replace(':', "_");
    match load_scene(&written(&format!("{name}.glb"), bytes), &[]) {
        Ok(loaded) => {
            loaded.scene.check().expect("what is read is usable");
            true
        }
        Err(error) => {
            let message = error.to_string();
            assert!(message.contains(".glb: "), "{message}");
            false
        }
    }
}

/// The text with the buffer as it was, and the whole file.
#[test]
fn damaged_gltf_scenes() {
    let (document, json) = room(&parity());
    let originals = vec![
        Original::new(document.binary(&json), scene),
        Original {
            bytes: json.to_string().into_bytes(),
            wrap: |text| room(&parity()).0.binary_with(text),
            read: scene,
        },
    ];
    let share = survive("scene.gltf", originals, 2_000);
    assert!((0.01..0.95).contains(&share), "{share}");
}
