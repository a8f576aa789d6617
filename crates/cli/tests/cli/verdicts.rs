//! `check`: its three answers, and what it writes.

use crate::{Capwalk, assert_has};

const SIZE: &str = "--size 24x18";

#[test]
fn a_right_gradient_is_right() {
    let capwalk = Capwalk::new("check_right");
    let json = capwalk.json(&format!(
        "check leaf -p leaf.translate.x {SIZE} --spp 1024 --reference-spp 4096 --json -o c.png,c.npz"
    ));
    let comparison = &json["comparison"];
    assert_eq!(comparison["verdict"], "right");
    let factor = comparison["scale_factor"].as_f64().expect("a number");
    assert!((factor - 1.0).abs() < 0.1, "{factor}");
    // The plain mean of z² is that of the image's own z.
    let image = capwalk_scene_io::image::read(&capwalk.path("c.npz")).expect("readable");
    let z = image.layer("z").expect("a layer").pixels.iter();
    let sum: f64 = z.map(|pixel| pixel.r.powi(2)).sum();
    let pixels = comparison["pixels"].as_f64().expect("a count");
    let plain = comparison["mean_z_squared_plain"].as_f64();
    let plain = plain.expect("a number");
    assert!((plain - sum / pixels).abs() < 1e-5 * plain, "{plain}");
    capwalk.bytes("c.png");
    capwalk.bytes("c.npz");
}

#[test]
fn few_samples_cannot_tell() {
    let capwalk = Capwalk::new("check_unsure");
    let few = "--spp 2 --reference-spp 2";
    let finished = capwalk.run(&format!("check leaf -p leaf.translate.x {SIZE} {few}"));
    assert_eq!(finished.status, 2, "{}", finished.stdout);
    assert_has(
        &finished.stdout,
        &[
            "inconclusive",
            "times the samples",
            "--reference-spp",
            "\nmean z²",
            "\nplain mean z²",
        ],
    );
    let one = "--spp 1 --reference-spp 1";
    let finished = capwalk.run(&format!("check leaf -p leaf.translate.x {SIZE} {one}"));
    assert_eq!(finished.status, 2, "{}", finished.stdout);
    assert_has(&finished.stdout, &["at least two samples"]);
}

/// A step so large that the difference is no derivative: the reference is
/// wrong, and the answer says how to find out.
#[test]
fn a_wrong_reference_is_found() {
    let capwalk = Capwalk::new("check_wrong");
    let large = "--spp 64 --reference-spp 64 --step 0.7";
    let finished = capwalk.run(&format!("check leaf -p leaf.translate.x {SIZE} {large}"));
    assert_eq!(finished.status, 1, "{}", finished.stdout);
    assert_has(
        &finished.stdout,
        &["wrong: ", "--step", "one of three references"],
    );
    // A second one with four times the samples has confirmed it, over the step that was asked for,
    // and a third one beside a second gradient.
    let finished = capwalk.run(&format!(
        "check leaf -p leaf.translate.x {SIZE} {large} --json"
    ));
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    assert_eq!(
        (&json["references"], &json["reference_spp"]),
        (&3.into(), &256.into())
    );
    let samples = |value: &serde_json::Value| value.as_f64().expect("a number");
    let of_second = samples(&json["reference"]["samples"]);
    assert!(
        samples(&json["reference_samples"]) > 1.2 * of_second,
        "{json}"
    );
}

/// A far box hides little of the sky from a floor, and moves by little: no sample of the
/// differences changes, while the gradient is precise. That is no evidence against it.
#[test]
fn differences_without_events_cannot_tell() {
    let capwalk = Capwalk::new("check_no_events");
    capwalk.write("far.xml", &card(0.5).replace("x=\"0.1\" z", "x=\"4\" z"));
    let check = "check far.xml -p card.translate.x --spp 100 --reference-spp 50";
    let finished = capwalk.run(check);
    assert_eq!(finished.status, 2, "{}", finished.stdout);
    assert_has(
        &finished.stdout,
        &[
            "inconclusive: the differences saw no event",
            "a larger step",
            "--reference-spp",
        ],
    );
    let finished = capwalk.run(&format!("{check} --json"));
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    assert_eq!(json["comparison"]["verdict"], "inconclusive");
    let reason = json["comparison"]["reason"].as_str().expect("a reason");
    assert!(reason.contains("no event"), "{reason}");
}

/// An emitter's own colour does nothing in direct light: no factor can be seen.
#[test]
fn nothing_changes() {
    let capwalk = Capwalk::new("check_nothing");
    let finished =
        capwalk.run("check leaf -p lamp.bsdf.reflectance.value --size 12x9 --spp 4 -o c.png");
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(
        &finished.stdout,
        &[
            "zero everywhere",
            "nothing in the image changes",
            "\nscale factor    -",
        ],
    );
    assert!(!finished.stdout.contains("NaN"), "{}", finished.stdout);
}

/// A card that slides on a floor, at a height above it.
fn card(height: f64) -> String {
    format!(
        r#"<scene version="3.0.0"><integrator type="direct"/><sensor type="perspective"><float name="fov" value="40"/>
<transform name="to_world"><lookat origin="0.1, -3.4, 1.3" target="0, 0, 0" up="0, 0, 1"/></transform>
<film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="6"/></film></sensor>
<shape type="rectangle" id="floor"/>
<shape type="rectangle" id="card"><transform name="to_world"><scale value="0.3"/><translate x="0.1" z="{height}"/></transform></shape>
<emitter type="constant"/></scene>"#
    )
}

/// A camera in the plane of a face that it moves against sees another side of it on either side of
/// the motion: the image has no derivative there, and a check names the face.
#[test]
fn faces_seen_edge_on_are_named() {
    let capwalk = Capwalk::new("check_edge_on");
    let level = |height: f64| card(height).replace("target=\"0, 0, 0\"", "target=\"0, 0, 1.3\"");
    capwalk.write("on.xml", &level(1.3));
    capwalk.write("above.xml", &level(1.301));
    let check = |scene: &str, parameter: &str| {
        let finished = capwalk.run(&format!("check {scene}.xml -p {parameter} --spp 4 --json"));
        let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
        (finished.stderr, json["edge_on"].clone())
    };
    for parameter in ["card.translate.z", "sensor.translate.z"] {
        let (remarks, faces) = check("on", parameter);
        let note = "the camera sees face 0 of \"card\", face 1 of \"card\" exactly edge-on";
        assert_has(&remarks, &[note, "the image has no derivative"]);
        assert_eq!(faces[1], serde_json::json!({"shape": "card", "face": 1}));
    }
    for (scene, parameter) in [("above", "card.translate.z"), ("on", "card.translate.x")] {
        let (remarks, faces) = check(scene, parameter);
        assert!(!remarks.contains("edge-on"), "{remarks}");
        assert_eq!(faces, serde_json::json!([]));
    }
}

/// Where an edge comes off another shape, or off its border in its plane, an image has no derivative: a
/// check names both. It has one where the edge slides there, or a part of it is above, or the whole a
/// little.
#[test]
fn edges_that_come_off_are_named() {
    let capwalk = Capwalk::new("check_touching");
    let stands = |place: &str| {
        let turned =
            format!(r#"<translate y="1"/><rotate x="1" angle="20"/><scale value="0.3"/>{place}"#);
        card(0.0).replace(r#"<scale value="0.3"/><translate x="0.1" z="0"/>"#, &turned)
    };
    capwalk.write("on.xml", &stands(""));
    capwalk.write("half.xml", &stands(r#"<translate x="-1.1"/>"#));
    capwalk.write("above.xml", &stands(r#"<translate z="0.001"/>"#));
    capwalk.write("inclined.xml", &stands(r#"<rotate y="1" angle="1"/>"#));
    let check = |scene: &str, parameter: &str| {
        let finished = capwalk.run(&format!("check {scene}.xml -p {parameter} --spp 4 --json"));
        let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
        (finished.stderr, json["touching"].clone())
    };
    for scene in ["on", "half"] {
        for parameter in ["card.translate.z", "floor.rotate.y"] {
            let (remarks, pairs) = check(scene, parameter);
            let note = "an edge lies on another shape and moves off it (\"card\" on \"floor\")";
            assert_has(&remarks, &[note, "the image has no derivative"]);
            assert_eq!(pairs, serde_json::json!([["card", "floor"]]));
        }
    }
    // On the border of the floor, and beside it.
    let beside = |x: f64| card(0.0).replace("translate x=\"0.1\"", &format!("translate x=\"{x}\""));
    capwalk.write("border.xml", &beside(1.3));
    capwalk.write("beside.xml", &beside(1.301));
    for parameter in ["card.translate.x", "floor.scale"] {
        let (_, pairs) = check("border", parameter);
        assert_eq!(
            pairs.as_array().map_or(0, Vec::len),
            2,
            "{parameter}: {pairs}"
        );
    }
    for (scene, parameter) in [
        ("on", "card.translate.x"),
        ("border", "card.translate.y"),
        ("beside", "card.translate.x"),
        ("above", "card.translate.z"),
        ("inclined", "card.translate.z"),
    ] {
        let (remarks, pairs) = check(scene, parameter);
        assert!(!remarks.contains("an edge lies"), "{scene}: {remarks}");
        assert_eq!(pairs, serde_json::json!([]), "{scene}");
    }
}

/// Where shapes slide on each other an image has no derivative: a check names them.
#[test]
fn shapes_on_each_other_are_named() {
    let capwalk = Capwalk::new("check_coplanar");
    capwalk.write("on.xml", &card(0.0));
    capwalk.write("above.xml", &card(1e-3));
    let check = |scene: &str| {
        let finished = capwalk.run(&format!(
            "check {scene}.xml -p card.translate.x --spp 4 --json"
        ));
        let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
        (finished.stderr, json["coplanar"].clone())
    };
    let (remarks, pairs) = check("on");
    let note = "\"floor\" and \"card\" have faces in one plane that overlap, and move against";
    assert_has(&remarks, &[note, "the image has no derivative"]);
    assert_eq!(pairs, serde_json::json!([["floor", "card"]]));
    let (remarks, pairs) = check("above");
    assert!(!remarks.contains("one plane"), "{remarks}");
    assert_eq!(pairs, serde_json::json!([]));
}
