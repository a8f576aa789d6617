//! `capwalk optimize`: what it finds, what it writes, and what it says of bad jobs.

mod methods;
mod resume;
mod stops;
#[cfg(target_os = "linux")]
mod viewer;

use std::fs;
use std::path::{Path, PathBuf};

use capwalk_scene_io::arrays::{self, Arrays};

use crate::{Capwalk, assert_has};

/// Milliseconds of work per iteration.
const SMALL: &str = r#"
scene = "leaf"
size = [8, 6]
output = "out"
iterations = 40
spp = 4
seed = 5
images = 7

[target]
spp = 64
[target.set]
"leaf.translate.x" = 0.2

[[parameter]]
name = "leaf.translate.x"
bounds = [-1, 1]

[[parameter]]
name = "floor.bsdf.reflectance.value"
reparam = "sigmoid"

[[parameter]]
name = "lamp.emitter.radiance.value.g"
reparam = "log"

[optimizer]
lr = 0.02
"#;

fn arrays_of(path: &Path) -> Arrays {
    arrays::read(path).expect("readable")
}

/// The same bits with any number of threads, and the numbers that were hidden.
#[test]
fn hidden_numbers_are_found() {
    let capwalk = Capwalk::new("optimize_found");
    let job = fs::read_to_string(examples().join("leaf_and_floor.toml")).expect("the example");
    let documented = fs::read_to_string(examples().join("../../docs/optimize.md")).expect("a page");
    let documented = documented.split("```toml\n").nth(1).expect("an example");
    let documented = documented.split("```").next().expect("its end");
    assert!(
        job.ends_with(documented),
        "docs/optimize.md shows another job"
    );
    let job = job.replace("size = [40, 30]", "size = [16, 12]");
    for seed in [3, 4, 5] {
        let job = job.replace("seed = 3", &format!("seed = {seed}"));
        capwalk.write("job.toml", &job);
        let json = capwalk.json(&format!("optimize job.toml -o found{seed} --json"));
        assert_eq!(json["iterations"], 80);
        assert_eq!(json["unknowns"], 4);
        assert_eq!(json["stopped"], "all iterations are done");
        let found = arrays_of(&capwalk.path(&format!("found{seed}/parameters.npz")));
        let numbers = |name: &str| found.get(name).expect(name).numbers.clone();
        let x = numbers("leaf.translate.x")[0];
        assert!((x - 0.2).abs() < 0.02, "{seed}: {x}");
        let floor = numbers("floor.bsdf.reflectance.value");
        for (found, hidden) in floor.iter().zip([0.5, 0.6, 0.3]) {
            assert!((found - hidden).abs() < 0.01, "{seed}: {floor:?}");
        }
    }
    // Another seed, another way.
    let record = |seed: u32| capwalk.bytes(&format!("found{seed}/record.csv"));
    assert_ne!(record(3), record(4));
    // The exported scene has them.
    let info = capwalk.json("info found5/scene.xml --json");
    let listed = info["parameters"].as_array().expect("a list");
    let floor = listed
        .iter()
        .find(|p| p["name"] == "floor.bsdf.reflectance.value");
    let red = floor.expect("there")["value"][0]
        .as_f64()
        .expect("a number");
    assert!((red - 0.5).abs() < 0.01, "{red}");
}

/// The three numbers of a translation are one variable.
#[test]
fn a_translation_is_found_as_a_vector() {
    let capwalk = Capwalk::new("optimize_vector");
    let job = SMALL
        .replace("iterations = 40", "iterations = 60")
        .replace("x\" = 0.2", "x\" = 0.2\n\"leaf.translate.z\" = -0.15")
        .replace("leaf.translate.x\"\nbounds", "leaf.translate\"\nbounds");
    let (all, last) = (job.find("[[parameter]]"), job.find("[optimizer]"));
    let (all, last) = (all.expect("there"), last.expect("there"));
    let one = "[[parameter]]\nname = \"leaf.translate\"\nbounds = [-1, 1]\n\n";
    capwalk.write("job.toml", &[&job[..all], one, &job[last..]].concat());
    let json = capwalk.json("optimize job.toml --json");
    assert_eq!(json["unknowns"], 3);
    let found = arrays_of(&capwalk.path("out/parameters.npz"));
    let found = found.get("leaf.translate").expect("there");
    assert_eq!(found.shape, [3]);
    // How high it is shows in the penumbra alone.
    let hidden = [(0.2, 0.02), (0.0, 0.15), (-0.15, 0.02)];
    for (number, (hidden, error)) in found.numbers.iter().zip(hidden) {
        assert!((number - hidden).abs() < error, "{:?}", found.numbers);
    }
}

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/jobs")
}

/// The example of figure 12 is read, has its fifty unknowns, and gets better.
#[test]
fn the_flower_has_fifty_unknowns() {
    let capwalk = Capwalk::new("optimize_flower");
    for file in ["scene.xml", "disk.obj", "flower.obj"] {
        let bytes = fs::read(examples().join("flower").join(file)).expect("the example");
        fs::write(capwalk.path(file), bytes).expect("writable");
    }
    let job = fs::read_to_string(examples().join("flower/job.toml")).expect("the example");
    let job = job.replace("iterations = 150", "iterations = 12\nsize = [24, 18]");
    capwalk.write("job.toml", &job.replace("spp = 1024", "spp = 64"));
    let json = capwalk.json("optimize job.toml --json");
    assert_eq!(json["unknowns"], 50);
    let record = String::from_utf8(capwalk.bytes("out/record.csv")).expect("text");
    let loss = |row: usize| -> f64 {
        let row = record.lines().nth(1 + row).expect("a row");
        row.split(',')
            .nth(1)
            .expect("a loss")
            .parse()
            .expect("a number")
    };
    assert!(loss(12) < 0.5 * loss(0), "{} {}", loss(0), loss(12));
    let positions = arrays_of(&capwalk.path("out/parameters.npz"));
    let positions = positions.get("sheet.positions").expect("there");
    assert_eq!(positions.shape, [26, 3]);
    assert!(
        positions
            .numbers
            .iter()
            .skip(1)
            .step_by(3)
            .all(|&y| y == 1.5)
    );
    capwalk.bytes("out/images/000000.png");
    capwalk.bytes("out/images/000012.png");
}

/// A view of its own sensor and mask with a target from a file, beside another.
#[test]
fn several_views_with_masks_and_files() {
    let capwalk = Capwalk::new("optimize_views");
    assert_eq!(
        capwalk
            .run("render leaf --size 8x6 --spp 64 -o target.exr")
            .status,
        0
    );
    let mut mask = capwalk_scene::Image::new(8, 6);
    mask.pixels[..24].fill(capwalk_math::Rgb::splat(1.0));
    let mut layered = capwalk_scene_io::image::LayeredImage::default();
    layered.push("value", mask);
    let preview = capwalk_scene_io::image::Preview::default();
    capwalk_scene_io::image::write(&capwalk.path("mask.npz"), &layered, &preview).expect("fine");
    let views = r#"
[[view]]
mask = "mask.npz"
target = { image = "target.exr" }
weight = 2

[[view]]
x_fov = 30
to_world = [[-1, 0, 0, 0.1], [0, 0.8, -0.6, 2], [0, -0.6, -0.8, 2.5], [0, 0, 0, 1]]
"#;
    let job = SMALL.replace("iterations = 40", "iterations = 3") + views;
    capwalk.write("job.toml", &job);
    assert_eq!(capwalk.run("optimize job.toml").status, 0);
    let record = String::from_utf8(capwalk.bytes("out/record.csv")).expect("text");
    let mut lines = record.lines();
    let header = lines.next().expect("a header");
    assert_has(
        header,
        &["loss of view 1,loss of view 2", "leaf.translate.x"],
    );
    let row: Vec<f64> = lines
        .next()
        .expect("a row")
        .split(',')
        .map(|x| x.parse().unwrap_or(f64::NAN))
        .collect();
    assert!(
        (row[1] - (2.0 * row[13] + row[14]) / 3.0).abs() < 1e-12,
        "{row:?}"
    );
    for view in 1..=2 {
        capwalk.bytes(&format!("out/images/000003-view{view}.png"));
    }
    let error = job.replace(
        "\"leaf.translate.x\"\nbounds",
        "\"sensor.translate.x\"\nbounds",
    );
    capwalk.write("bad.toml", &error);
    assert_has(
        &capwalk.error("optimize bad.toml -o bad"),
        &["bad.toml:16:8", "its own"],
    );
}

#[test]
fn bad_jobs_name_the_place() {
    let capwalk = Capwalk::new("optimize_bad");
    let bad = |old: &str, new: &str, parts: &[&str]| {
        assert!(SMALL.contains(old), "{old}");
        capwalk.write("job.toml", &SMALL.replacen(old, new, 1));
        assert_has(&capwalk.error("optimize job.toml"), parts);
    };
    bad(
        "seed = 5",
        "sed = 5",
        &[
            "job.toml:7:1",
            "unknown key `sed`",
            "expected one of",
            "\"seed\"?",
        ],
    );
    bad("seed = 5", "seed = -1", &["job.toml:7:8", "at least 0"]);
    bad("lr = 0.02", "", &["`lr` is missing in [optimizer]"]);
    bad("lr = 0.02", "lr = 0", &["a number above 0"]);
    bad("spp = 4", "spp = 1", &["job.toml:6:7", "from 2 to"]);
    bad(
        "\"sigmoid\"",
        "\"sigmoit\"",
        &["job.toml:21:11", "\"sigmoid\"?", "\"log\""],
    );
    bad(
        "leaf.translate.x\"\nb",
        "leaf.translat.x\"\nb",
        &["job.toml:16:8", "leaf.translate.x"],
    );
    bad(
        "[-1, 1]",
        "[1, -1]",
        &["job.toml:16:8", "the lower one first"],
    );
    bad(
        "[-1, 1]",
        "[1, 2, 3]",
        &["job.toml:17:10", "[lowest, highest]"],
    );
    bad(
        "scene = \"leaf\"",
        "scene = \"leav\"",
        &["job.toml:2:9", "no file", "leaf, "],
    );
    bad(
        "\"leaf.translate.x\" = 0.2",
        "\"leaf.translate.w\" = 0.2",
        &["job.toml:13:1"],
    );
    bad("= 0.2", "= \"far\"", &["job.toml:13:22", "finite numbers"]);
    bad(
        "[target]\nspp = 64\n[target.set]\n\"leaf.translate.x\" = 0.2",
        "",
        &["no target"],
    );
    bad(
        "spp = 64\n[target.set]\n\"leaf.translate.x\" = 0.2",
        "image = \"none.exr\"",
        &["job.toml:11:9", "none.exr"],
    );
    bad(
        "spp = 64\n[target.set]\n\"leaf.translate.x\" = 0.2",
        "imge = \"none.exr\"",
        &[
            "job.toml:11:1",
            "unknown key `imge` in [target]",
            "\"image\"?",
        ],
    );
    bad(
        "lr = 0.02",
        "lr = 0.02\nbetas = [0.9, 1]",
        &["job.toml:29:9", "below 1"],
    );
    bad(
        "[optimizer]",
        "[loss]\ntype = \"l3\"\n[optimizer]",
        &["job.toml:28:8", "\"l2\"", "\"relative\""],
    );
    bad(
        "bounds = [-1, 1]",
        "plane = \"xz\"",
        &["job.toml:16:8", "`<shape>.positions`"],
    );
    bad("iterations = 40", "iterations = ", &["job.toml:5:14"]);
    bad(
        "lr = 0.02",
        "lr = 0.02\neps = 0",
        &["job.toml:29:7", "above 0"],
    );
    // A built-in scene has no `$name`, and one sensor.
    bad(
        "[target]",
        "[defines]\nwidth = 3\n[target]",
        &["job.toml:11:1", "\"leaf\" is built in", "no `$name`"],
    );
    bad(
        "[target.set]",
        "defines = { width = 3 }\n[target.set]",
        &["job.toml:12:13", "no `$name`"],
    );
    bad(
        "[optimizer]",
        "[[view]]\nsensor = 1\n[optimizer]",
        &["job.toml:28:10", "one sensor"],
    );
    let none = SMALL.find("[[parameter]]").expect("there");
    let end = SMALL.find("[optimizer]").expect("there");
    bad(
        &SMALL[none..end],
        "",
        &["`parameter` is missing", "[[parameter]]"],
    );
    let empty = SMALL.replace(&SMALL[none..end], "");
    capwalk.write("empty.toml", &format!("parameter = []\n{empty}"));
    assert_has(
        &capwalk.error("optimize empty.toml"),
        &["empty.toml:1:13", "one or more [[parameter]]"],
    );
    assert_has(
        &capwalk.error("optimize none.toml"),
        &["none.toml", "cannot read"],
    );
}

/// `render` and `optimize` warn once about text in a scene file that has no effect.
#[test]
fn scenes_that_warn_do_so_here_too() {
    let capwalk = Capwalk::new("optimize_warns");
    assert_eq!(capwalk.run("scenes --export scenes leaf").status, 0);
    let scene = String::from_utf8(capwalk.bytes("scenes/leaf.xml")).expect("text");
    let scene = scene.replace("</scene>", "stray text</scene>");
    capwalk.write("scenes/stray.xml", &scene);
    let job = SMALL.replace("iterations = 40", "iterations = 1");
    // The target is of the same file, which is read again.
    let job = job.replace("scene = \"leaf\"", "scene = \"scenes/stray.xml\"");
    let job = job.replace("[target]", "[target]\nscene = \"scenes/stray.xml\"");
    capwalk.write("job.toml", &job);
    let warning = "text outside of attributes has no effect";
    for arguments in [
        "render scenes/stray.xml --size 8x6 --spp 2",
        "optimize job.toml",
    ] {
        let finished = capwalk.run(arguments);
        assert_eq!(finished.status, 0, "{arguments}: {}", finished.stderr);
        let count = finished.stderr.matches(warning).count();
        assert_eq!(count, 1, "{arguments}: {}", finished.stderr);
    }
}

/// What `backward` refuses is refused with the place of the parameter.
#[test]
fn refusals_name_the_parameter() {
    let capwalk = Capwalk::new("optimize_refused");
    let projector = "<emitter type=\"projector\"/>";
    assert_eq!(capwalk.run("scenes --export scenes leaf").status, 0);
    let scene = String::from_utf8(capwalk.bytes("scenes/leaf.xml")).expect("text");
    capwalk.write(
        "scenes/projector.xml",
        &scene.replace("</scene>", &format!("{projector}</scene>")),
    );
    let job = SMALL.replace("scene = \"leaf\"", "scene = \"scenes/projector.xml\"");
    let job = job.replace(
        "name = \"leaf.translate.x\"\nbounds = [-1, 1]\n",
        "name = \"floor.bsdf.reflectance.value.r\"\n",
    );
    let job = job.replace(
        "floor.bsdf.reflectance.value\"\nreparam = \"sigmoid\"",
        "leaf.translate.x\"",
    );
    capwalk.write("job.toml", &job);
    let error = capwalk.error("optimize job.toml");
    assert_has(
        &error,
        &[
            "job.toml:19:8",
            "with respect to \"leaf.translate.x\" is refused",
            "(projector) projects is discontinuous",
        ],
    );
}

/// Weights of views count against each other, however large they are.
#[test]
fn weights_of_views_are_relative() {
    let capwalk = Capwalk::new("optimize_weights");
    let loss = |weight: &str| {
        let view = format!("[[view]]\nweight = {weight}\n");
        let job = SMALL.replace("iterations = 40", "iterations = 1");
        capwalk.write("job.toml", &format!("{job}{view}{view}"));
        capwalk.json(&format!("optimize job.toml -o {weight} --json"))["loss"].clone()
    };
    assert_eq!(loss("1e308"), loss("1.0"));
}

/// What is missing in gradients is said, here for rays inside of a coarse mirror.
#[test]
fn a_run_says_what_gradients_lack() {
    let capwalk = Capwalk::new("optimize_lacks");
    let mirror = examples().join("../../tests/scenes/object_moves_in_a_coarse_mirror/ball.obj");
    let scene = format!(
        r#"<scene version="3.0.0">
            <integrator type="path"><integer name="max_depth" value="3"/></integrator>
            <sensor type="perspective">
                <float name="fov" value="90"/>
                <float name="near_clip" value="0.0001"/>
                <transform name="to_world">
                    <lookat origin="0, -0.1883, 0.6086" target="1, -0.1883, 0.6086" up="0, 0, 1"/>
                </transform>
                <film type="hdrfilm"><rfilter type="box"/></film>
            </sensor>
            <shape type="obj" id="mirror">
                <string name="filename" value="{}"/>
                <boolean name="flip_normals" value="true"/>
                <bsdf type="conductor"/>
            </shape>
            <shape type="cube" id="thing">
                <transform name="to_world"><scale value="0.1"/></transform>
                <emitter type="area"/>
            </shape>
        </scene>"#,
        mirror.display()
    );
    capwalk.write("scene.xml", &scene);
    capwalk.write(
        "job.toml",
        r#"
        scene = "scene.xml"
        size = [8, 6]
        iterations = 1
        spp = 2
        target = { set = { "thing.translate.x" = 0.02 }, spp = 4 }
        parameter = [{ name = "thing.translate.x" }]
        optimizer = { lr = 0.01 }
        "#,
    );
    let json = capwalk.json("optimize job.toml --json");
    let missing = json["missing"].as_str().expect("something is missing");
    assert!(missing.contains("dips below its face"), "{missing}");
}
