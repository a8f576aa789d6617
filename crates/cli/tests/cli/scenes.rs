use crate::{Capwalk, assert_has};

#[test]
fn scenes_are_listed() {
    let capwalk = Capwalk::new("scenes_list");
    let text = capwalk.run("scenes").stdout;
    assert_has(
        &text,
        &[
            "leaf",
            "ball",
            "box-room",
            "lattice-shadow",
            "ball.translate.x",
        ],
    );
    let json = capwalk.json("scenes --json leaf");
    assert_eq!(json["scenes"].as_array().map(Vec::len), Some(1));
    assert_has(&capwalk.error("scenes loaf"), &["loaf", "leaf"]);
}

/// A scene comes back from its files as it was. The field of view passes
/// through degrees, so images are equal up to rounding.
#[test]
fn exported_scenes_load_again() {
    let capwalk = Capwalk::new("scenes_export");
    capwalk.json("scenes --export out --json leaf ball");
    for scene in ["leaf", "ball"] {
        let options = "--size 16x12 --spp 4 -o";
        for (source, file) in [(scene.to_owned(), "a"), (format!("out/{scene}.xml"), "b")] {
            let finished = capwalk.run(&format!("render {source} {options} {file}.npz"));
            assert_eq!(finished.status, 0, "{}", finished.stderr);
        }
        let finished = capwalk.run("compare b.npz a.npz --json");
        let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
        let difference = json["relative_l1"].as_f64().expect("a number");
        assert!(difference < 1e-5, "{scene}: {difference}");
    }
}

/// Scenes whose derivatives are refused say so before anybody waits for them.
#[test]
fn info_says_what_is_refused() {
    let capwalk = Capwalk::new("info_refused");
    capwalk.run("scenes --export . leaf");
    let xml = String::from_utf8(capwalk.bytes("leaf.xml")).expect("text");
    let (before, after) = xml
        .split_once("name=\"near_clip\" value=\"")
        .expect("near_clip");
    let (_, after) = after.split_once('"').expect("a quote");
    // Halfway between the camera and the floor that it sees.
    capwalk.write(
        "leaf.xml",
        &format!("{before}name=\"near_clip\" value=\"4.5\"{after}"),
    );
    let json = capwalk.json("info leaf.xml --json");
    assert_eq!(json["parameters"][0]["differentiable"], false);
    let finished = capwalk.run("info leaf.xml --all");
    assert_has(&finished.stdout, &["are refused", "near_clip"]);
    // It is read before the long tables.
    let place = |text: &str| finished.stdout.find(text).expect(text);
    assert!(place("are refused") < place("leaf.translate.x"));
    assert_has(&finished.stdout, &[" 1 emitter\n"]);
    assert_eq!(
        capwalk.json("info leaf --json")["refused"],
        serde_json::Value::Null
    );
}
