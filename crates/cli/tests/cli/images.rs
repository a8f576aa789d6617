//! What `render` and `gradient` write.

use crate::{Capwalk, assert_has};

const TINY: &str = "--size 12x9 --spp 8";

#[test]
fn render_writes_all_formats() {
    let capwalk = Capwalk::new("render_formats");
    let json = capwalk.json(&format!(
        "render leaf {TINY} --json -o new/folder/a.exr,a.npz -o a.png"
    ));
    assert_eq!(json["statistics"]["complete"], true);
    assert_eq!(json["statistics"]["samples"], 12 * 9 * 8);
    assert_eq!(json["statistics"]["non_finite"], 0);
    assert_eq!(json["files"].as_array().map(Vec::len), Some(3));
    assert!(
        capwalk
            .bytes("new/folder/a.exr")
            .starts_with(&[0x76, 0x2f, 0x31, 0x01])
    );
    assert!(capwalk.bytes("a.npz").starts_with(b"PK"));
    assert!(capwalk.bytes("a.png").starts_with(b"\x89PNG"));
}

/// Colours end where they are asked to, in pictures alone.
#[test]
fn colours_have_a_limit() {
    let capwalk = Capwalk::new("limit");
    for command in ["gradient", "check"] {
        let written = |limit: &str| {
            let outputs = if limit.is_empty() { "a" } else { "b" };
            capwalk.run(&format!(
                "{command} leaf -p leaf.translate.x {TINY} {limit} -o {outputs}.png,{outputs}.npz"
            ));
            ["png", "npz"].map(|ending| capwalk.bytes(&format!("{outputs}.{ending}")))
        };
        let [free, wide] = ["", "--limit 1e3"].map(written);
        assert!(free[0] != wide[0], "{command}");
        assert!(free[1] == wide[1], "{command}");
    }
    let error = capwalk.error("gradient leaf -p leaf.translate.x --limit 0");
    assert_has(&error, &["--limit", "above 0"]);
}

/// Layers and headers of what was written.
#[test]
fn files_say_what_they_are() {
    let capwalk = Capwalk::new("headers");
    capwalk.run(&format!(
        "gradient leaf -p leaf.translate.x {TINY} --seed 5 -o g.npz,g.exr"
    ));
    for file in ["g.npz", "g.exr"] {
        let layered = capwalk_scene_io::image::read(&capwalk.path(file)).expect("readable");
        for layer in ["value", "gradient", "stderr"] {
            let image = layered.layer(layer).expect("a layer");
            assert_eq!((image.width, image.height), (12, 9), "{file}");
        }
        let of = |key: &str| {
            layered
                .metadata
                .iter()
                .find(|(k, _)| k == key)
                .map(|(_, v)| &v[..])
        };
        assert_eq!(of("scene"), Some("leaf"), "{file}");
        assert_eq!(of("parameter"), Some("leaf.translate.x"), "{file}");
        assert_eq!(of("seed"), Some("5"), "{file}");
        assert_eq!(of("spp"), Some("8"), "{file}");
        assert_eq!(of("version"), Some(env!("CARGO_PKG_VERSION")), "{file}");
        assert_eq!(of("complete"), Some("true"), "{file}");
    }
}

#[test]
fn default_outputs_are_named_after_the_scene() {
    let capwalk = Capwalk::new("default_outputs");
    let finished = capwalk.run(&format!("render leaf {TINY}"));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(&finished.stdout, &["wrote leaf.exr, leaf.png"]);
    assert_eq!(
        finished.stderr, "",
        "nothing to say, and no bar without a terminal"
    );
    capwalk.run(&format!("gradient leaf -p leaf.translate.x {TINY}"));
    capwalk.bytes("leaf-gradient.exr");
    capwalk.bytes("leaf-gradient.png");
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let capwalk = Capwalk::new("threads");
    for command in ["render leaf", "gradient ball -p ball.translate.x"] {
        for threads in [1, 2, 3] {
            let finished = capwalk.run(&format!("{command} {TINY} -t {threads} -o {threads}.npz"));
            assert_eq!(finished.status, 0, "{}", finished.stderr);
        }
        let reference = capwalk.bytes("1.npz");
        assert!(reference == capwalk.bytes("2.npz"), "{command}");
        assert!(reference == capwalk.bytes("3.npz"), "{command}");
        capwalk.run(&format!("{command} {TINY} --seed 7 -o seed.npz"));
        assert!(reference != capwalk.bytes("seed.npz"), "{command}");
    }
}

#[test]
fn gradients_of_files_of_velocities() {
    let capwalk = Capwalk::new("motion_file");
    capwalk.write("x.txt", "1 0 0\n1 0 0\n1 0 0\n");
    capwalk.run(&format!(
        "gradient leaf --motion leaf=x.txt {TINY} -o file.npz"
    ));
    capwalk.run(&format!(
        "gradient leaf -p leaf.translate.x {TINY} -o name.npz"
    ));
    let json = capwalk.json("compare file.npz name.npz --json");
    assert_eq!(json["layer"], "gradient");
    assert_eq!(json["largest_difference"], 0.0);
}

/// Radiance beyond single precision is no number that a file can hold: it counts as zero, and
/// the command does not end as if all were well.
#[test]
fn what_files_cannot_hold_is_counted() {
    let capwalk = Capwalk::new("beyond_single");
    let scene = |radiance: &str| {
        format!(
            r#"<scene version="3.0.0"><integrator type="direct"/><sensor type="perspective"/>
<emitter type="constant"><rgb name="radiance" value="{radiance}"/></emitter></scene>"#
        )
    };
    for (radiance, status, count) in [("1e38", 0, 0), ("1e39", 4, 64)] {
        capwalk.write("sky.xml", &scene(radiance));
        let finished = capwalk.run("render sky.xml --size 4x4 --spp 4 --json -o sky.npz");
        assert_eq!(finished.status, status, "{}", finished.stderr);
        let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
        assert_eq!(json["statistics"]["non_finite"], count);
        let image = capwalk_scene_io::image::read(&capwalk.path("sky.npz")).expect("readable");
        let value = image.layer("value").expect("a layer");
        assert!(value.pixels.iter().all(|pixel| pixel.is_finite()));
    }
}
