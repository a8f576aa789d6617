//! Methods by name: what they refuse, and what they say of themselves.

use capwalk_scene_io::{arrays, image};

use crate::{Capwalk, assert_has};

const LEAF: &str = "leaf -p leaf.translate.x --size 12x9 --spp 4";

#[test]
fn options_of_other_methods_are_errors() {
    let capwalk = Capwalk::new("method_options");
    let refused = |arguments: &str, words: &[&str]| {
        assert_has(&capwalk.error(&format!("{arguments} {LEAF}")), words);
    };
    refused(
        "gradient --method fd --walk-steps 2",
        &["--walk-steps", "the method is fd", "--method walk"],
    );
    refused("gradient --step 0.1", &["--step", "--method fd"]);
    refused("check --method fd", &["nothing to check", "compare"]);
    let backward = "backward --adjoint none.exr --method fd leaf";
    assert_has(
        &capwalk.error(backward),
        &[
            "with respect to one parameter",
            "gradient --method fd -p NAME",
        ],
    );
}

/// What a gradient of the leaf by a method says, and the method and the step that its
/// file names.
fn gradient_by(capwalk: &Capwalk, method: &str) -> (String, Option<String>, Option<String>) {
    let finished = capwalk.run(&format!("gradient {LEAF} {method} -o out.exr"));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    let image = image::read(&capwalk.path("out.exr")).expect("it was written");
    let notes = image.metadata.into_iter();
    let of = |key: &str| {
        let mut notes = notes.clone().filter(|(name, _)| name == key);
        notes.next().map(|(_, value)| value)
    };
    (finished.stderr, of("method"), of("step"))
}

/// Files name the method; baselines are called what they are, once.
#[test]
fn methods_say_what_they_are() {
    let capwalk = Capwalk::new("method_names");
    let run = |method: &str| gradient_by(&capwalk, method);
    let (stderr, method, step) = run("");
    assert!(!stderr.contains("baseline"), "{stderr}");
    assert_eq!((method.as_deref(), step), (Some("edges"), None));
    // With so few samples nothing is tried.
    let (stderr, ..) = run("-v");
    assert_has(&stderr, &["method: edges (camera, emitters)"]);
    assert!(!stderr.contains("tried"), "{stderr}");
    let finished = capwalk.run("gradient leaf -p leaf.translate.x --size 12x9 --spp 200 -v");
    let lines = ["tried edges (camera, emitters)", "method: edges"];
    assert_has(&finished.stderr, &lines);
    let (stderr, method, step) = run("--method fd --step 0.125");
    assert_has(&stderr, &["fd is a baseline"]);
    assert_eq!(method.as_deref(), Some("fd"));
    assert_eq!(step.as_deref(), Some("0.125"));
}

/// Discontinuous textures are no refusal, and `info` says what they are made of.
#[test]
fn discontinuous_textures() {
    let capwalk = Capwalk::new("discontinuous");
    let scene = r#"<scene version="3.0.0"><integrator type="direct"/><sensor type="perspective"/>
<emitter type="constant"/><shape type="cube" id="box"><bsdf type="diffuse">
<texture name="reflectance" type="checkerboard"/></bsdf></shape></scene>"#;
    capwalk.write("board.xml", scene);
    let gradient = "gradient board.xml -p box.scale --size 8x8 --spp 1";
    assert_eq!(capwalk.run(gradient).status, 0);
    let info = capwalk.run("info board.xml").stdout;
    let colours = ["checkerboard of (0.4", "box.bsdf.reflectance.color1.value"];
    assert_has(&info, &colours);
    assert!(!info.contains("refused"), "{info}");
}

/// Wherever standard errors are stated that do not bound errors.
#[test]
fn infinite_variance_is_said() {
    let capwalk = Capwalk::new("method_literal");
    let options = "--size 12x9 --spp 4";
    let gradient = format!("gradient leaf -p leaf.translate.x {options} -o gradient.npz");
    let commands = [
        gradient.clone(),
        format!("{gradient} --method edges"),
        format!("check leaf -p leaf.translate.x {options} -o check.npz"),
        format!("backward leaf -p leaf.positions {options} --adjoint gradient.npz -o backward.npz"),
    ];
    for command in commands {
        for (walk, expected) in [
            ("", 0),
            ("--estimator literal", 1),
            ("--estimator literal --antithetic", 0),
        ] {
            let stderr = capwalk.run(&format!("{command} {walk}")).stderr;
            let found = stderr.matches("infinite variance").count();
            assert_eq!(found, expected, "{command} {walk}: {stderr}");
        }
    }
}

/// `edges` is no baseline, and not `walk` by another name; files and JSON name it.
#[test]
fn every_command_takes_edges() {
    let capwalk = Capwalk::new("method_edges");
    let named = |metadata: &[(String, String)]| {
        let mut methods = metadata.iter().filter(|(key, _)| key == "method");
        let name = methods.next().map(|(_, name)| name.clone());
        assert!(methods.next().is_none(), "named twice");
        name
    };
    let options = "--size 12x9 --spp 4 --json";
    let commands = [
        format!("gradient leaf -p leaf.translate.x {options} -o gradient.npz"),
        format!("check leaf -p leaf.translate.x {options} -o check.npz"),
        format!("backward leaf -p leaf.positions {options} --adjoint gradient.npz -o backward.npz"),
    ];
    for command in commands {
        let run = |method: &str| {
            let finished = capwalk.run(&format!("{command} {method}"));
            // So few samples cannot tell.
            let expected = if command.starts_with("check") { 2 } else { 0 };
            assert_eq!(finished.status, expected, "{}", finished.stderr);
            assert!(!finished.stderr.contains("baseline"), "{}", finished.stderr);
            let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
            let file = capwalk.path(json["files"][0].as_str().expect("a file"));
            let (metadata, numbers) = if command.starts_with("backward") {
                let arrays = arrays::read(&file).expect("readable");
                let positions = arrays.get("leaf.positions").expect("there");
                (arrays.metadata.clone(), positions.numbers.clone())
            } else {
                let image = image::read(&file).expect("readable");
                let gradient = image.layer("gradient").expect("a layer");
                let numbers = gradient.pixels.iter().flat_map(|pixel| pixel.to_array());
                (image.metadata.clone(), numbers.collect())
            };
            (
                json["method"].as_str().map(str::to_owned),
                named(&metadata),
                numbers,
            )
        };
        let (json, file, by_edges) = run("--method edges --walk-steps 2");
        assert_eq!(
            (json.as_deref(), file.as_deref()),
            (Some("edges"), Some("edges"))
        );
        let (json, file, by_walk) = run("--walk-steps 1");
        assert_eq!(
            (json.as_deref(), file.as_deref()),
            (Some("walk"), Some("walk"))
        );
        assert_ne!(by_edges, by_walk, "{command}");
        let refused = capwalk.error(&format!("{command} --method auto --walk-steps 2"));
        assert_has(
            &refused,
            &["--walk-steps", "the method is auto", "--method walk"],
        );
    }
}
