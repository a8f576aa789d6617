//! `demo`, small: its table, its JSON, its files, and its time limit.

use capwalk_scene_io::image::LayeredImage;
use serde_json::{Value, json};

use crate::{Capwalk, assert_has};

const SMALL: &str = "demo --size 16x12 --spp 4 --seed 3 -o out";

/// Where the files go, with the layers that each holds.
const FILES: [(&str, &[&str]); 3] = [
    ("out/lattice-shadow.exr", &["value", "stderr"]),
    (
        "out/lattice-shadow-gradient.exr",
        &["value", "value_stderr", "gradient", "stderr"],
    ),
    (
        "out/lattice-shadow-check.exr",
        &["value", "gradient", "stderr", "reference", "z"],
    ),
];

/// Status of a gradient that four samples cannot judge.
const COULD_NOT_TELL: i32 = 2;

fn read(capwalk: &Capwalk, file: &str) -> LayeredImage {
    capwalk_scene_io::image::read(&capwalk.path(file)).expect("readable")
}

fn metadata(layered: &LayeredImage, key: &str) -> String {
    let found = layered.metadata.iter().find(|(k, _)| k == key);
    found.expect(key).1.clone()
}

#[test]
fn the_table_has_every_number() {
    let capwalk = Capwalk::new("demo_text");
    let finished = capwalk.run(SMALL);
    assert_eq!(finished.status, COULD_NOT_TELL, "{}", finished.stderr);
    assert_eq!(finished.stderr, "");
    let first = "lattice-shadow, 16 x 12 pixels, derivative for lattice.translate.y\n";
    assert!(finished.stdout.starts_with(first), "{}", finished.stdout);
    let of = |name: &str| -> f64 {
        let mut lines = finished.stdout.lines();
        let line = lines.find_map(|line| line.strip_prefix(name)).expect(name);
        let number = line.split_whitespace().next().expect("a number");
        number.parse().expect("a number")
    };
    // A lattice that moves up takes its shadow along; whether four samples see
    // it is luck, and not asked.
    for name in [
        "relative L1 ",
        "correlation ",
        "mean z² ",
        "plain mean z² ",
        "edges ",
    ] {
        assert!(of(name).is_finite(), "{name}");
    }
    // Infinite variance against a finite one: thousands of times, in practice.
    assert!(of("walk, literal ") > 10.0 * of("edges "));
    assert_has(&finished.stdout, &["inconclusive: ", "--spp ", "\nwrote "]);
}

#[test]
fn the_files_have_the_right_shape() {
    let capwalk = Capwalk::new("demo_files");
    let finished = capwalk.run(&format!("{SMALL} --json"));
    assert_eq!(finished.status, COULD_NOT_TELL, "{}", finished.stderr);
    let result: Value = serde_json::from_str(&finished.stdout).expect("one JSON object");
    assert_eq!(result["size"], json!([16, 12]));
    assert_eq!(result["spp"], 4);
    assert_eq!(result["seed"], 3);
    let samples = |stage: &str| result[stage]["samples"].as_u64().expect("a count");
    let per_pixel = |key: &str| result[key].as_u64().expect("a count");
    for (stage, spp) in [
        ("render", 4),
        ("gradient", 4),
        ("literal", per_pixel("literal_spp")),
        ("reference", per_pixel("reference_spp")),
    ] {
        assert_eq!(samples(stage), 16 * 12 * spp, "{stage}");
        assert_eq!(result[stage]["complete"], true, "{stage}");
    }

    let mut expected: Vec<String> = Vec::new();
    for (file, layers) in FILES {
        let layered = read(&capwalk, file);
        for layer in layers {
            let image = layered.layer(layer).expect(layer);
            assert_eq!((image.width, image.height), (16, 12), "{file} {layer}");
            let not_zero = image.pixels.iter().any(|p| p.r != 0.0);
            assert!(not_zero, "{file}: {layer} is empty");
        }
        assert_eq!(metadata(&layered, "complete"), "true", "{file}");
        assert_eq!(metadata(&layered, "seed"), "3", "{file}");
        assert_eq!(metadata(&layered, "spp"), "4", "{file}");
        let preview = file.replace(".exr", ".png");
        assert!(capwalk.bytes(&preview).starts_with(b"\x89PNG"));
        expected.extend([file.to_owned(), preview]);
    }
    assert_eq!(result["files"], json!(expected));
    let folder = std::fs::read_dir(capwalk.path("out")).expect("it is there");
    assert_eq!(folder.count(), expected.len(), "files that nobody named");

    // The seed is used.
    let other =
        capwalk.run(&format!("{SMALL} --seed 4 -o other").replacen("--seed 3 -o out", "", 1));
    assert_eq!(other.status, COULD_NOT_TELL, "{}", other.stderr);
    let [a, b] = ["out", "other"].map(|folder| {
        let layered = read(&capwalk, &format!("{folder}/lattice-shadow.exr"));
        layered.layer("value").expect("a layer").clone()
    });
    assert!(a != b);
}

/// Hours of work in five seconds: every stage says that it was cut short, on the
/// standard error, in the JSON, and in its files.
#[test]
fn a_time_limit_makes_everything_partial() {
    let capwalk = Capwalk::new("demo_time_limit");
    let finished = capwalk.run("demo --size 16x12 --spp 10000000 --time-limit 5s --json -o out");
    let partial = ["image", "literal gradient", "gradient", "reference"];
    let partial = partial.map(|what| format!("warning: the {what} is partial: "));
    assert_has(&finished.stderr, &partial.each_ref().map(String::as_str));
    let result: Value = serde_json::from_str(&finished.stdout).expect("one JSON object");
    for stage in ["render", "literal", "gradient", "reference"] {
        assert_eq!(result[stage]["complete"], false, "{stage}");
    }
    for (file, _) in FILES {
        let layered = read(&capwalk, file);
        assert_eq!(metadata(&layered, "complete"), "false", "{file}");
    }
}
