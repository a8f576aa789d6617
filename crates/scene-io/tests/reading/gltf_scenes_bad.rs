//! glTF files that cannot be read as scenes, and what is said about them.

use std::path::PathBuf;

use capwalk_scene_io::{LoadOptions, load_scene, load_scene_with};
use serde_json::{Value, json};

use crate::gltf_file::Document;
use crate::gltf_room::room;
use crate::gltf_scenes::{changed, parity, written};

/// The error of a room after a change, from the file's name on.
fn refused(name: &str, change: &dyn Fn(&mut Document, &mut Value)) -> String {
    let name = format!("refused_{name}.glb");
    let Err(error) = changed(&name, change) else {
        panic!("{name} was read")
    };
    let error = error.to_string();
    let own = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(&name);
    error.replace(&own.display().to_string(), "room.glb")
}

/// The error of a room with another value in the place of one, or a new one.
fn at(name: &str, pointer: &str, value: Value) -> String {
    refused(name, &|_, json| {
        let (parent, key) = pointer.rsplit_once('/').expect("a pointer");
        let parent = json.pointer_mut(parent).expect(parent);
        match key.parse::<usize>() {
            Ok(index) => parent[index] = value.clone(),
            Err(_) => parent[key] = value.clone(),
        }
    })
}

#[test]
fn what_has_no_equal_is_named() {
    let by_hand = "\n  show the mesh in a scene of Mitsuba's XML, by <shape type=\"gltf\">, with a \
                   material written there";
    let without_it = "\n  export the file without it, or show its meshes in a scene of Mitsuba's XML, \
                     by <shape type=\"gltf\">";
    let material = |name: &str, extension: Value| at(name, "/materials/0/extensions", extension);
    for (message, expected) in [
        (
            at("camera", "/nodes/1/camera", Value::Null),
            "room.glb: its scene has no camera to render with\n  export it with a camera (Blender: \
             Include, Cameras), or show its meshes in a scene of Mitsuba's XML, by <shape \
             type=\"gltf\">"
                .to_owned(),
        ),
        (
            at("required", "/extensionsRequired", json!(["KHR_lights_punctual", "ABC_fog"])),
            "room.glb: extensionsRequired[1]: the extension \"ABC_fog\" is not read\n  export the \
             file without it"
                .into(),
        ),
        (
            at("copies", "/nodes/2/extensions", json!({"EXT_mesh_gpu_instancing": {}})),
            "room.glb: nodes[2].extensions: the extension \"EXT_mesh_gpu_instancing\" is not read\n  \
             export each copy as a node"
                .into(),
        ),
        (
            at("sky", "/scenes/0/extensions", json!({"EXT_lights_image_based": {"light": 0}})),
            format!(
                "room.glb: scenes[0].extensions: the extension \"EXT_lights_image_based\" is not \
                 read{without_it}"
            ),
        ),
        (
            refused("skin", &|_, json| {
                json["skins"] = json!([{"joints": [0]}]);
                json["nodes"][4]["skin"] = 0.into();
            }),
            "room.glb: nodes[4] \"Bowl\": \"room.glb\", nodes[4].skin: skinned meshes are not \
             read\n  export the mesh as it is to be seen, without a skin"
                .into(),
        ),
        (
            at("morph", "/meshes/2/primitives/0/targets", json!([{"POSITION": 0}])),
            "room.glb: nodes[4] \"Bowl\": \"room.glb\", meshes[2].primitives[0].targets: morph \
             targets are not read\n  export the mesh as it is to be seen, without morph targets"
                .into(),
        ),
        (
            material("unlit", json!({"KHR_materials_unlit": {}})),
            "room.glb: materials[0].extensions.KHR_materials_unlit: an unlit material shows its \
             colour whatever the light is\n  export it with emission, and black, in its place"
                .into(),
        ),
        (
            material("coat", json!({"KHR_materials_clearcoat": {"clearcoatFactor": 0.5}})),
            format!(
                "room.glb: materials[0].extensions.KHR_materials_clearcoat: \"principled\" has \
                 nothing that is the same{by_hand}"
            ),
        ),
        (
            material("vendor", json!({"ABC_moss": {}})),
            format!(
                "room.glb: materials[0].extensions.ABC_moss: the extension \"ABC_moss\" is not \
                 read{without_it}"
            ),
        ),
        (
            material("thin", json!({"KHR_materials_transmission": {"transmissionFactor": 1}})),
            format!(
                "room.glb: materials[0].extensions.KHR_materials_transmission: a surface that \
                 transmits light and is thin has no equal in \"principled\"; a solid has \
                 KHR_materials_volume with a thickness{by_hand}"
            ),
        ),
        (
            material("gloss", json!({"KHR_materials_specular": {"specularFactor": 0.5}})),
            format!(
                "room.glb: materials[0].extensions.KHR_materials_specular: reflection that is \
                 coloured, or weakened by specularFactor, has no equal in \"principled\"{by_hand}"
            ),
        ),
        (
            refused("matt", &|_, json| {
                json["materials"][2]["extensions"] =
                    json!({"KHR_materials_specular": {"specularFactor": 0}});
            }),
            format!(
                "room.glb: materials[2].extensions.KHR_materials_specular: a mixture of a metal and \
                 a surface that reflects nothing has no equal in \"principled\"{by_hand}"
            ),
        ),
        (
            refused("glow", &|_, json| {
                json["materials"][3]["emissiveFactor"] = json!([1, 1, 1]);
            }),
            format!(
                "room.glb: materials[3].alphaMode: what is not opaque and emits light has no equal: \
                 an emitter has no opacity{by_hand}"
            ),
        ),
        (
            at("uv", "/materials/1/normalTexture/texCoord", 1.into()),
            "room.glb: materials[1].normalTexture: it has the texture coordinates TEXCOORD_1\n  \
             export it with those of TEXCOORD_0, the only ones that are read"
                .into(),
        ),
        (
            refused("wrap", &|_, json| {
                json["samplers"] = json!([{"wrapS": 33071}]);
                json["textures"][2]["sampler"] = 0.into();
            }),
            "room.glb: materials[1] \"Panel\": \"room.glb\", textures[2]: it goes on beyond its \
             borders in another way along u than along v\n  give both the same wrapping mode"
                .into(),
        ),
        (
            at("webp", "/textures/1", json!({"extensions": {"EXT_texture_webp": {"source": 1}}})),
            "room.glb: materials[1] \"Panel\": \"room.glb\", textures[1]: it has no image but by \
             an extension, which is not read\n  export images as PNG or JPEG"
                .into(),
        ),
        (
            refused("colours", &|document, json| {
                let colours = document.vectors(&[[0.5, 1.0, 1.0]; 4]);
                json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = colours.into();
            }),
            format!(
                "room.glb: materials[0].pbrMetallicRoughness: the product of colours of vertices \
                 (COLOR_0) and another colour is not read; export one of them{by_hand}"
            ),
        ),
    ] {
        assert_eq!(message, expected);
    }
}

#[test]
fn bad_scenes() {
    let damaged = "\n  expected what glTF 2.0 allows; the file is cut off or damaged";
    for (message, expected) in [
        (
            at("texture", "/materials/1/normalTexture/index", 3.into()),
            format!(
                "room.glb: materials[1].normalTexture.index: it is 3, but there is no such \
                 entry{damaged}"
            ),
        ),
        (
            at("light", "/nodes/8/extensions/KHR_lights_punctual/light", 7.into()),
            format!(
                "room.glb: nodes[8].extensions.KHR_lights_punctual.light: it is 7, but there is no \
                 such entry{damaged}"
            ),
        ),
        (
            at("mode", "/materials/0/alphaMode", "GLASS".into()),
            format!("room.glb: materials[0].alphaMode: it is \"GLASS\"{damaged}"),
        ),
        (
            at("lens", "/cameras/0", json!({"type": "perspective"})),
            format!("room.glb: cameras[0]: a part of it is missing{damaged}"),
        ),
        (
            at("image", "/images/1", json!({"mimeType": "image/png"})),
            "room.glb: materials[1] \"Panel\": \"room.glb\", images[1]: it has neither \"uri\" nor \
             \"bufferView\"\n  the file is cut off or damaged"
                .into(),
        ),
        (
            at("rough", "/materials/0/pbrMetallicRoughness/roughnessFactor", 1.5.into()),
            "room.glb: materials[0] \"Floor\": Floor.roughness.value is (1.5, 1.5, 1.5); expected \
             numbers from 0 to 1"
                .into(),
        ),
        (
            at("fov", "/cameras/0/perspective/yfov", 4.into()),
            "room.glb: nodes[1] \"Camera\": \"fov\" is 229.1831180523293\n  expected an angle \
             between 0 and 180 degrees"
                .into(),
        ),
        (
            at("flat", "/nodes/0/scale", json!([1, 1, 0])),
            "room.glb: nodes[1]: its camera or its light looks nowhere: its transform cannot be \
             inverted\n  scale by finite numbers other than 0"
                .into(),
        ),
    ] {
        assert_eq!(message, expected);
    }
    let text = refused("cut", &|document, json| {
        let view = json["images"][0]["bufferView"].as_u64().expect("an index") as usize;
        let start = json["bufferViews"][view]["byteOffset"]
            .as_u64()
            .expect("a number") as usize;
        document.buffer[start + 40] ^= 0xff;
    });
    let expected = "room.glb: materials[0] \"Floor\": cannot read images[0] of \"room.glb\": ";
    assert!(text.starts_with(expected), "{text}");
    let path = written("cut_off.glb", &room(&parity()).0.binary(&json!({}))[..40]);
    let text = load_scene(&path, &[]).expect_err("cut off").to_string();
    assert!(text.contains("cut_off.glb: byte 8: "), "{text}");
    let options = LoadOptions {
        defines: vec![("spp".into(), "4".into())],
        ..LoadOptions::default()
    };
    let (document, json) = room(&parity());
    let path = written("defined.glb", &document.binary(&json));
    let error = load_scene_with(&path, &options).expect_err("defined");
    let expected = "defined.glb: \"spp\" is defined, but glTF has no parameters\n  leave the \
                    definition out";
    assert!(error.to_string().ends_with(expected), "{error}");
}
